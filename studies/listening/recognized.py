"""Kinds of touch in a recording of an array's microphones."""

from __future__ import annotations

import json
import os
from dataclasses import asdict, dataclass
from pathlib import Path

from geometry.ground.refusal import Refusal
from geometry.ground.whole_files import write_text
from studies.listening.opening import Decoding, library_there, open_localizer
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
    model: str | os.PathLike[str],
    library: str | os.PathLike[str],
    recording: str | os.PathLike[str],
    out: str | os.PathLike[str] | None = None,
    *,
    point: int | None = None,
    speed: float | None = None,
    full_scale: float | None = None,
    decoding: Decoding | None = None,
) -> tuple[RecognizedTouch, ...]:
    """Touches of a recording by their kind, in the order of time.

    Args:
        model: the folder of a recognizer.
        library: that of the array; where no point is given, the model-based decoder names it by this.
        recording: see :func:`localize.read_recording`.
        out: a file for a line of JSON for every touch.
        point: that is touched, from 1; by default that which is named.
        speed: of what slides, mm/s; by default that of a straight slide over three points at least, as it is heard.
        full_scale: pressure at full scale of WAV files, Pa.
        decoding: noise, sound and air of the place; by default noise is that of the training where something is heard,
            and that of the design's microphone where points are named.

    Raises:
        Refusal: a file that cannot be read or written; a library of another array than the recognizer's; a point that
            the array does not have; a speed of no use, or of letters a point or a level of sound; a point without a
            speed; no speed, and what is heard is no straight slide.
    """
    path = None if out is None else Path(out)
    check_new_file(path, ".jsonl", reads=(model, library, recording))
    from acoustic_fem.sound.sound_file import check_sound_there
    from localize import load_recognizer, read_recording
    from localize.recognition.filter_bank import Ear
    from localize.recognition.handwriting import WRITTEN

    check_sound_there(recording)
    recognizer = load_recognizer(model)
    given = decoding or Decoding()
    localizer = open_localizer(Path(library), given)
    if localizer.microphones != recognizer.microphones or localizer.design != recognizer.design:
        raise Refusal(
            f"{model}: is of {recognizer.design} with the microphones {', '.join(recognizer.microphones)}, {library} "
            f"of {localizer.design} with {', '.join(localizer.microphones)}; they must be of one array"
        )
    if recognizer.subject == WRITTEN:
        for name, value in (("point", point), ("ambient", given.ambient)):
            if value is not None:
                raise Refusal(f"{name} = {value:g} is of no use: {model} tells letters, of the path over all points")
    if recognizer.at_usual_speed and speed is None and point is not None:
        raise Refusal("`speed` must be given where `point` is: else it is told by the points that a slide passes")
    if speed is not None and not recognizer.at_usual_speed:
        raise Refusal(f"speed = {speed:g} is of no use: {model} was trained without speeds")
    if point is not None and not 1 <= point <= len(localizer.line):
        raise Refusal(f"point = {point} must be from 1 to {len(localizer.line)}, the points of the array")
    heard = read_recording(Path(recording), recognizer.microphones, full_scale)
    ear = Ear(library_there(library, given.air), recognizer, given.noise)
    found = []
    for each in ear.touches(heard.signals, None if point is None else point - 1, speed, localizer):
        best = int(each.probability.argmax())
        kind = recognizer.labels[best]
        found.append(RecognizedTouch(each.start, each.end, each.point + 1, kind, float(each.probability[best])))
    if path is not None:
        write_text(path, "".join(json.dumps(asdict(each)) + "\n" for each in found))
    return tuple(found)
