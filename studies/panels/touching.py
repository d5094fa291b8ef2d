"""Touches on a design: simulated ones or those of a recording, and what the Bayes decoder answers."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import localize
from acoustic_fem.atlas import QuickFidelity, quick_fidelity
from acoustic_fem.sound.sound_file import FORMATS, SCALED
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_choice, check_range
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.text_files import parse_toml
from geometry.ground.whole_files import temporary_folder
from localize import Decision, gesture_of, read_recording, touches_of
from localize.contacts import Contact
from localize.contacts.contact import surface_of
from localize.contacts.finger_gestures import double_tap, press, slide, tap
from localize.live.stream_options import MOVING
from localize.model.opened_model import Model
from localize.model.opening import open_model, opened_as_designed
from localize.recordings.touch_manifest import TouchManifestError
from localize.signals.array_response import response_of
from localize.signals.resampling import check_full_scale
from localize.tracking import tracks_of
from studies.output.frequencies import LIBRARY_FREQUENCIES
from studies.panels.curves import quick_library

if TYPE_CHECKING:
    from localize.contacts import ContactRecorder

#: Kinds of simulated touches.
TOUCHES = ("tap", "double tap", "press")
#: Length of the longest recording that is shown, s.
LONGEST = 120.0
#: Speed of a simulated slide, mm/s, and the longest, mm.
SLIDE_SPEED, LONGEST_SLIDE = 60.0, 600.0


@dataclass(frozen=True, eq=False)
class DesignDecoder:
    """Model and recorder of a design, by its quick library."""

    model: Model
    recorder: ContactRecorder
    fidelity: QuickFidelity
    """Fidelity of the library."""


def simulate_touch(design: ArrayDesign, point: int, kind: str, sample: int) -> dict[str, Any]:
    """One simulated touch by a finger in the middle of a point, and what the decoder of the design makes of it.

    It is recorded through the quick library that decodes it, under the noise of the design's microphones; force, length
    and noise are drawn.

    Args:
        design: the array.
        point: number of the point, from 1.
        kind: of :data:`TOUCHES`.
        sample: number of the touch: each has draws of its own, the same whenever it is made.

    Returns:
        As :func:`decode`.

    Raises:
        Refusal: no such point or kind, or a design that cannot be decoded.
    """
    made: dict[str, Callable[..., Contact]] = dict(zip(TOUCHES, (tap, double_tap, press), strict=True))
    check_choice("kind", kind, TOUCHES)
    check_range("point", point, 1, design.point_count, whole=True)
    decoder = decoder_of(design)
    place, _ = surface_of(decoder.recorder.response)
    x, y = (float(each) for each in place[point - 1])
    take = decoder.recorder.take(made[kind]((x, y), sample=sample), sample)
    return decode(decoder, take.signals)


def simulate_slide(design: ArrayDesign, start: Sequence[float], end: Sequence[float], sample: int) -> dict[str, Any]:
    """One simulated slide of a finger over the array, recorded as by :func:`simulate_touch`, and its path.

    Args:
        design: the array.
        start: x and y in plan where it begins, mm.
        end: where it ends, mm.
        sample: as of :func:`simulate_touch`.

    Returns:
        As :func:`decode`, with ``paths``.

    Raises:
        Refusal: a slide of no length or too long a one, or a design that cannot be decoded.
    """
    length = math.dist(start, end)
    check_range("length of the slide", round(length, 1), 1, LONGEST_SLIDE, "mm")
    decoder = decoder_of(design)
    (x0, y0), (x1, y1) = start, end
    take = decoder.recorder.take(slide((x0, y0), (x1, y1), SLIDE_SPEED, sample=sample), sample)
    return {**decode(decoder, take.signals), "paths": paths_of(decoder, take.signals)}


def paths_of(decoder: DesignDecoder, signals: NDArray[np.float64]) -> list[dict[str, Any]]:
    """Paths of contacts, as ``acoustic-fem track`` finds them.

    Args:
        decoder: that of the design.
        signals: (n_microphone, n_sample) float64, Pa, at 1 kHz.

    Returns:
        Each path has ``places``: time (s), x, y and their standard deviation (mm), and 1 where the contact was
        detected, 0 where its path was only continued, 16 ms apart; ``gesture``: its kind in words; ``length``, mm, 0 of
        a contact that stays.
    """
    model = opened_as_designed(decoder.model)
    found = []
    for each in tracks_of(model.stream(frames=True), model.tracker(MOVING), signals):
        gesture = gesture_of(each)
        found.append(
            {
                "places": np.column_stack([each.time, each.place, each.deviation, each.detected]).round(4).tolist(),
                "gesture": f"{gesture.kind} {gesture.direction}".strip(),
                "length": gesture.length,
            }
        )
    return found


def replay_recording(
    design: ArrayDesign,
    content: bytes,
    name: str,
    full_scale: float,
    notify: Callable[[str], None] = lambda line: None,
) -> dict[str, Any]:
    """A recording as ``acoustic-fem locate`` decodes it with the quick library of a design.

    Args:
        design: the array.
        content: of the file.
        name: of the file, whose suffix states its format.
        full_scale: pressure at full scale, Pa, of files that hold fractions of it.
        notify: called with how far it is.

    Returns:
        As :func:`decode`, with ``paths`` as of :func:`paths_of`, and ``full_scale``, Pa; None if the file itself holds
        pascals.

    Raises:
        Refusal: no recording, or none of the design's microphones, or one longer than :data:`LONGEST`.
    """
    decoder = decoder_of(design)
    suffix = Path(name).suffix.lower()
    suffix = suffix if suffix in FORMATS else ".wav"
    used = full_scale if suffix in SCALED else None
    with temporary_folder() as folder:
        path = folder / f"{re.sub(r'[^A-Za-z0-9._-]', '_', Path(name).stem)[:60] or 'recording'}{suffix}"
        path.write_bytes(content)
        try:
            recording = read_recording(path, decoder.model.locator.microphones, used)
        except Refusal as error:
            raise without_folder(error, str(folder)) from None
    if recording.seconds > LONGEST:
        problem = f"is {recording.seconds:.0f} s long; it must be at most {LONGEST:g} s"
        raise Refusal(problem, file=name, kind=Kind.UNSUITABLE)
    notify(f"{recording.seconds:.0f} s are decoded")
    found = decode(decoder, recording.signals)
    notify(f"{counted(len(found['touches']), 'touch')} found; their paths are followed")
    return {**found, "paths": paths_of(decoder, recording.signals), "full_scale": used}


def manifest_scale(text: str, name: str) -> float:
    """Pressure at full scale that a manifest of recorded touches states, Pa; 1 if it states none.

    Args:
        text: of the manifest, TOML.
        name: of its file, in refusals.

    Raises:
        Refusal: not TOML, or no pressure.
    """
    stated = parse_toml(text, name, TouchManifestError).get("full_scale", 1.0)
    check_full_scale(stated)
    return float(stated)


def without_folder(error: Refusal, folder: str) -> Refusal:
    """A refusal of a file in a temporary folder, with the name that the user knows."""
    file = None if error.file is None else Path(error.file).name
    problem = error.problem.replace(f"{folder}/", "") if isinstance(error.problem, str) else error.problem
    return Refusal.of(error, file=file, problem=problem)


def decode(decoder: DesignDecoder, signals: NDArray[np.float64]) -> dict[str, Any]:
    """Signals, with what the decoder makes of them.

    Args:
        decoder: that of the design.
        signals: (n_microphone, n_sample) float64, Pa, at 1 kHz.

    Returns:
        ``signals`` as float32 bytes, microphone after microphone; ``microphones``, their names; ``samples``, how many;
        ``decisions``: end of the frame (s), state, point and its probability, 16 ms apart; ``touches``: start and end
        (s), point, probability and level (Pa rms); ``fidelity`` of the library, in words.
    """
    array = decoder.model.locator.array
    events = decoder.model.stream().push(signals)
    found = touches_of(events, array)
    return {
        "signals": np.asarray(signals, "<f4").tobytes(),
        "microphones": list(array.microphones),
        "samples": int(signals.shape[1]),
        "decisions": [
            [event.time, event.state, event.point, event.probability] for event in events if isinstance(event, Decision)
        ],
        "touches": [[each.start, each.end, each.point, each.probability, each.level] for each in found],
        "fidelity": decoder.fidelity.words,
    }


def membranes(design: ArrayDesign) -> dict[str, Any]:
    """Positions of the membranes in plan.

    Returns:
        ``points``: x, y and radius of the membrane of each, mm; ``fidelity`` of the library that decodes, in words.
    """
    place, radius = surface_of(response_of(quick_library(design)[0]))
    return {
        "points": np.column_stack([place, np.broadcast_to(radius, len(place))]).tolist(),
        "fidelity": _fidelity(design).words,
    }


def _fidelity(design: ArrayDesign) -> QuickFidelity:
    return quick_fidelity(design, LIBRARY_FREQUENCIES)


def decoder_of(design: ArrayDesign) -> DesignDecoder:
    """Model of a design, by its quick library, with a recorder of simulated contacts."""
    return _decoder_of(design.model_dump_json())


@lru_cache(maxsize=2)
def _decoder_of(design_json: str) -> DesignDecoder:
    """Model of a design, which takes a second to be made."""
    design = ArrayDesign.model_validate_json(design_json, strict=False)
    fidelity = _fidelity(design)
    library = acoustic_fem.solve(design, LIBRARY_FREQUENCIES, fidelity=fidelity.name)
    recorder = localize.contacts.ContactRecorder(library, microphone_noise="design")
    return DesignDecoder(open_model(library), recorder, fidelity)
