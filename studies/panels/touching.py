"""Touches on a design: simulated ones or those of a recording, and what the model-based decoder answers."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal
from localize.contacts.contact import MOVING
from studies.listening.opening import Decoding, open_localizer, open_stream, open_tracker
from studies.output.frequencies import LIBRARY_FREQUENCIES, stated_frequencies
from studies.run.library_files import solve_library

if TYPE_CHECKING:
    from acoustic_fem.atlas import QuickFidelity
    from localize import BayesDecoder, Localizer, OnnxLocalizer
    from localize.contacts import Contact, ContactRecorder

#: Kinds of simulated touches.
TOUCHES = ("tap", "double tap", "press")
#: Length of the longest recording that is shown, s.
LONGEST = 120.0
#: Speed of a simulated slide, mm/s, and the longest, mm.
SLIDE_SPEED, LONGEST_SLIDE = 60.0, 600.0


@dataclass(frozen=True, eq=False)
class Ears:
    """What listens to a design, with the folder of its library."""

    folder: TemporaryDirectory[str]
    library: Path
    localizer: Localizer | BayesDecoder | OnnxLocalizer
    recorder: ContactRecorder
    fidelity: QuickFidelity
    """Fidelity of the library."""


def touched(design: ArrayDesign, point: int, kind: str, sample: int) -> dict[str, Any]:
    """One simulated touch by a finger in the middle of a point, and what the decoder of the design makes of it.

    It is heard through the quick library that decodes it, under the noise of the design's microphones; force, length
    and noise are drawn.

    Args:
        design: the array.
        point: number of the point, from 1.
        kind: of :data:`TOUCHES`.
        sample: number of the touch: each has draws of its own, the same whenever it is made.

    Returns:
        As :func:`decoded`.

    Raises:
        Refusal: no such point or kind, or a design that cannot be decoded.
    """
    from localize.contacts.contact import surface_of
    from localize.contacts.finger_gestures import double_tap, press, tap

    made: dict[str, Callable[..., Contact]] = dict(zip(TOUCHES, (tap, double_tap, press), strict=True))
    if kind not in made:
        raise Refusal(f"kind = {kind!r} must be one of: {', '.join(TOUCHES)}")
    if not 1 <= point <= design.point_count:
        raise Refusal(f"point = {point} must be between 1 and {design.point_count}")
    ears = listening_to(design)
    place, _ = surface_of(ears.recorder.response)
    x, y = (float(each) for each in place[point - 1])
    take = ears.recorder.take(made[kind]((x, y), sample=sample), sample)
    return decoded(ears, take.signals)


def slid(design: ArrayDesign, start: Sequence[float], end: Sequence[float], sample: int) -> dict[str, Any]:
    """One simulated slide of a finger over the array, heard as :func:`touched`, and the path that is found of it.

    Args:
        design: the array.
        start: x and y in plan where it begins, mm.
        end: where it ends, mm.
        sample: as of :func:`touched`.

    Returns:
        As :func:`decoded`, with ``paths``.

    Raises:
        Refusal: a slide of no length or too long a one, or a design that cannot be decoded.
    """
    from localize.contacts.finger_gestures import slide

    length = math.dist(start, end)
    if not 1 <= length <= LONGEST_SLIDE:
        raise Refusal(f"the slide is {length:.3g} mm long; it must be between 1 and {LONGEST_SLIDE:g} mm")
    ears = listening_to(design)
    (x0, y0), (x1, y1) = start, end
    take = ears.recorder.take(slide((x0, y0), (x1, y1), SLIDE_SPEED, sample=sample), sample)
    return {**decoded(ears, take.signals), "paths": paths_of(ears, take.signals)}


def paths_of(ears: Ears, signals: NDArray[np.float64]) -> list[dict[str, Any]]:
    """Paths of contacts, as ``acoustic-fem track`` finds them.

    Args:
        ears: what listens.
        signals: (n_microphone, n_sample) float64, Pa, at 1 kHz.

    Returns:
        Of each path ``places``: time (s), x, y and their standard deviation (mm), 16 ms apart; ``gesture``: its kind
        in words; ``length``, mm.
    """
    from localize import gesture_of
    from localize.tracking import tracks_of

    decoder, tracker = open_tracker(ears.library, Decoding(), MOVING)
    found = []
    for each in tracks_of(open_stream(ears.library, decoder, Decoding(), frames=True), tracker, signals):
        gesture = gesture_of(each)
        found.append(
            {
                "places": np.column_stack([each.time, each.place, each.deviation]).round(4).tolist(),
                "gesture": f"{gesture.kind} {gesture.direction}".strip(),
                "length": gesture.length,
            }
        )
    return found


def replayed(design: ArrayDesign, content: bytes, name: str, full_scale: float) -> dict[str, Any]:
    """A recording in WAV format as ``acoustic-fem locate`` decodes it with the quick library of a design.

    Args:
        design: the array.
        content: of the file.
        name: of the file, for messages.
        full_scale: pressure at full scale, Pa.

    Returns:
        As :func:`decoded`, with ``paths`` as of :func:`paths_of`.

    Raises:
        Refusal: no WAV file, or none of the design's microphones, or one longer than :data:`LONGEST`.
    """
    from localize import read_recording

    ears = listening_to(design)
    with TemporaryDirectory() as folder:
        path = Path(folder) / f"{re.sub(r'[^A-Za-z0-9._-]', '_', Path(name).stem)[:60] or 'recording'}.wav"
        path.write_bytes(content)
        try:
            heard = read_recording(path, ears.localizer.microphones, full_scale)
        except Refusal as error:
            raise Refusal(str(error).replace(f"{folder}/", "")) from None
    if heard.seconds > LONGEST:
        raise Refusal(f"{name}: {heard.seconds:.0f} s long; it must be at most {LONGEST:g} s")
    return {**decoded(ears, heard.signals), "paths": paths_of(ears, heard.signals)}


def decoded(ears: Ears, signals: NDArray[np.float64]) -> dict[str, Any]:
    """Signals with what the decoder says of them.

    Args:
        ears: what listens.
        signals: (n_microphone, n_sample) float64, Pa, at 1 kHz.

    Returns:
        ``signals`` as float32 bytes, microphone after microphone; ``microphones``, their names; ``samples``, how many;
        ``decisions``: end of the frame (s), state, point and its probability, 16 ms apart; ``touches``: start and end
        (s), point, probability and level (Pa rms); ``fidelity`` of the library, in words.
    """
    from localize import Decision, touches_of

    stream = open_stream(ears.library, ears.localizer, Decoding())
    events = stream.push(signals)
    found = touches_of(events, ears.localizer)
    return {
        "signals": np.asarray(signals, "<f4").tobytes(),
        "microphones": list(ears.localizer.microphones),
        "samples": int(signals.shape[1]),
        "decisions": [
            [event.time, event.state, event.point, event.probability] for event in events if isinstance(event, Decision)
        ],
        "touches": [[each.start, each.end, each.point, each.probability, each.level] for each in found],
        "fidelity": ears.fidelity.words,
    }


def surface(design: ArrayDesign) -> dict[str, Any]:
    """Where the membranes lie in plan.

    Returns:
        ``points``: x, y and radius of the membrane of each, mm; ``fidelity`` of the library that decodes, in words.
    """
    from localize.contacts.contact import surface_of
    from localize.signals.array_response import response_of
    from studies.panels.curves import quick_library

    place, radius = surface_of(response_of(quick_library(design)[0]))
    return {
        "points": np.column_stack([place, np.broadcast_to(radius, len(place))]).tolist(),
        "fidelity": _fidelity(design).words,
    }


def _fidelity(design: ArrayDesign) -> QuickFidelity:
    from acoustic_fem.atlas import quick_fidelity

    return quick_fidelity(design, stated_frequencies(LIBRARY_FREQUENCIES))


def listening_to(design: ArrayDesign) -> Ears:
    """What listens to a design, by its quick library."""
    return _ears(design.model_dump_json())


@lru_cache(maxsize=2)
def _ears(design_json: str) -> Ears:
    """What listens to a design: its decoder takes a second to be made."""
    from localize.contacts import ContactRecorder

    design = ArrayDesign.model_validate_json(design_json, strict=False)
    folder = TemporaryDirectory(prefix="acoustic-fem-studio-")
    path = Path(folder.name) / "library.nc"
    fidelity = _fidelity(design)
    library = solve_library(design, path, fidelity=fidelity.name, frequency=LIBRARY_FREQUENCIES)
    recorder = ContactRecorder(library, microphone_noise="design")
    return Ears(folder, path, open_localizer(path, Decoding()), recorder, fidelity)
