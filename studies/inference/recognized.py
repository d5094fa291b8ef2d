"""Kinds of touch in a recording of an array's microphones."""

from __future__ import annotations

import json
import os
from dataclasses import asdict, dataclass
from pathlib import Path

import localize
from acoustic_fem.sound.sound_file import check_sound_there
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.whole_files import write_text
from localize.model.decoding import Decoding
from localize.model.opening import ModelSource, files_of, open_library, opened
from localize.recordings.recording import read_recording
from studies.inference.pulse_reading import check_point
from studies.output.folders import check_new_file


@dataclass(frozen=True)
class RecognizedTouch:
    """Touch of a recording, and its kind."""

    start: float
    """Time from which something is heard, s."""
    end: float
    """Time to which something is heard, s."""
    point: int
    """Point that is touched, from 1."""
    kind: str
    """Most probable kind."""
    probability: float
    """Probability of that kind."""


def recognize_recording(
    model: str | os.PathLike[str] | localize.Recognizer,
    library: ModelSource,
    recording: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    point: int | None = None,
    speed: float | None = None,
    full_scale: float | None = None,
    decoding: Decoding | None = None,
) -> tuple[RecognizedTouch, ...]:
    """Touches of a recording with their kinds, in the order of time.

    Args:
        model: a recognizer, or its folder.
        library: library of the array: a path, a library or an open model. If you give no point, its decoder finds it.
        recording: see :func:`localize.read_recording`.
        out: a file for a line of JSON for each touch.
        point: number of the touched point, from 1; by default the point that the decoder finds.
        speed: speed of a sliding contact, mm/s; by default it is estimated from a straight slide over at least three
            points.
        full_scale: pressure at full scale of WAV files, Pa.
        decoding: options for noise, sound and air of the place. By default touches are detected with the noise of the
            training, and points are located with the noise of the design's microphone.

    Raises:
        Refusal: a file that cannot be read or written; a library of another array than the recognizer's; a point that
            the array does not have; a speed for kinds that need none; a point or a level of sound for letters; a point
            without a speed for textures; no speed for a contact that does not slide straight.
    """
    path = None if out is None else Path(out)
    check_new_file(path, ".jsonl", reads=(*files_of(model), *files_of(library), recording))
    check_sound_there(recording)
    from localize.recognition.filter_bank import FilterBank  # torch, which recognizers need
    from localize.recognition.handwriting import WRITTEN

    recognizer = model if isinstance(model, localize.Recognizer) else localize.load_recognizer(model)
    opened_library = opened(library, decoding)
    array, given = opened_library.locator.array, opened_library.decoding
    if array.microphones != recognizer.microphones or array.design != recognizer.design:
        problem = (
            f"is of {recognizer.design} with the microphones {', '.join(recognizer.microphones)}, the library of "
            f"{array.design} with {', '.join(array.microphones)}; they must be of one array"
        )
        raise Refusal(problem, kind=Kind.MISMATCH, field="model")
    if recognizer.subject == WRITTEN:
        for name, value in (("point", point), ("ambient", given.ambient)):
            if value is not None:
                problem = "is of no use: letters are recognized from the path over all points"
                raise Refusal(problem, kind=Kind.CONFLICT, field=name, value=value)
    if recognizer.at_usual_speed and speed is None and point is not None:
        beside = ("must be given where ", Field("point"), " is: else it comes from the points that a slide passes")
        raise Refusal(beside, kind=Kind.MISSING, field="speed")
    if speed is not None and not recognizer.at_usual_speed:
        problem = "is of no use: the recognizer was trained without speeds"
        raise Refusal(problem, kind=Kind.CONFLICT, field="speed", value=speed)
    check_point(point, array.point_count)
    heard = read_recording(Path(recording), recognizer.microphones, full_scale)
    noise = None if given.microphone_noise == "design" else given.microphone_noise
    filters = FilterBank(open_library(opened_library), recognizer, noise)
    found = []
    signals = given.pressures(heard.signals, array)
    for each in filters.touches(signals, point, speed, opened_library.locator):
        best = int(each.probability.argmax())
        kind = recognizer.labels[best]
        found.append(RecognizedTouch(each.start, each.end, each.point, kind, float(each.probability[best])))
    if path is not None:
        write_text(path, "".join(json.dumps(asdict(each)) + "\n" for each in found))
    return tuple(found)
