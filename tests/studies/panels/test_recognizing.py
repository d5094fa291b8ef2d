"""Letters and kinds of the page are told as ``recognize`` tells them."""

from __future__ import annotations

import base64
import json
from pathlib import Path

import numpy as np
import pytest
from refusals import refused

import localize
from acoustic_fem.sound.sound_file import write_wav
from geometry import Kind, prototype
from localize.recognition import LETTERS
from studies import recognize_recording, solve_library
from studies.panels.curves import quick_library
from studies.panels.recognizing import store_recognizer, with_kinds, write_letter
from studies.panels.touching import simulate_touch

ARRAY = prototype("fingertip-3x4")


def test_what_cannot_be_written_is_refused() -> None:
    with refused(Kind.OUT_OF_RANGE, "letter", value="l"):
        write_letter(ARRAY, "l", 0)


@pytest.mark.slow
def test_kinds_are_those_of_recognize_and_a_letter_leaves_a_line(tmp_path: Path) -> None:
    library, _ = quick_library(ARRAY, np.arange(1.0, 501.0, 4.0))
    plan = localize.RecognitionPlan(takes=5, epochs=1, batch=16, seed=1)
    localize.train_recognizer(library, "letters", plan).save(tmp_path / "made")
    files = {path.name: base64.b64encode(path.read_bytes()).decode() for path in (tmp_path / "made").iterdir()}
    (tmp_path / "kept").mkdir()
    said = store_recognizer(json.dumps(files).encode(), str(tmp_path / "kept"))
    assert (said["subject"], said["labels"], said["design"]) == ("letters", list(LETTERS), ARRAY.name)

    found = with_kinds(write_letter, ARRAY, ("L", 1), said["folder"])
    line = np.array(found["line"])
    assert line[:, 0].min() >= 0
    assert line[:, 0].max() <= found["samples"] / 1000
    assert np.all((line[:, 3] > 0) & (line[:, 3] <= 1))
    signals = np.frombuffer(found["signals"], "<f4").reshape(len(found["microphones"]), -1)
    full_scale = 1.1 * float(np.abs(signals).max())
    write_wav(tmp_path / "letter.wav", signals / full_scale, 1000, bits=32)
    solve_library(ARRAY, tmp_path / "library.nc", fidelity="lumped")
    told = recognize_recording(
        tmp_path / "made", tmp_path / "library.nc", tmp_path / "letter.wav", full_scale=full_scale
    )
    assert [each[:4] for each in found["kinds"]] == [[each.start, each.end, each.point, each.kind] for each in told]
    assert len(told) == 1

    with refused(Kind.MISMATCH):
        with_kinds(simulate_touch, prototype("array-2x6"), (1, "tap", 0), said["folder"])
