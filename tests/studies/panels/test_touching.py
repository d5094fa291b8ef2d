"""Touches and recordings of the page are decoded as ``locate`` decodes them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from acoustic_fem.sound.sound_file import write_wav
from geometry import Refusal, prototype
from localize import Decision
from localize.contacts.contact import surface_of
from studies import locate_recording, solve_library
from studies.panels.touching import TOUCHES, replayed, surface, touched

ARRAY = prototype("array-2x6")
FULL_SCALE = 200.0


def test_the_membranes_lie_where_contacts_find_them() -> None:
    import acoustic_fem

    place, radius = surface_of(acoustic_fem.solve(ARRAY, np.linspace(1, 100, 8), fidelity="lumped"))
    found = np.array(surface(ARRAY)["points"])
    np.testing.assert_array_equal(found[:, :2], place)
    np.testing.assert_array_equal(found[:, 2], np.broadcast_to(radius, 12))


@pytest.mark.parametrize(
    ("point", "kind", "message"),
    [(0, "tap", "point = 0 must be between 1 and 12"), (13, "tap", "point = 13"), (1, "hit", "kind = 'hit' must be")],
)
def test_what_cannot_be_touched_is_refused(point: int, kind: str, message: str) -> None:
    with pytest.raises(Refusal, match=message):
        touched(ARRAY, point, kind, 0)


@pytest.mark.slow
def test_a_touch_is_decoded_as_locate_decodes_its_recording(tmp_path: Path) -> None:
    found = touched(ARRAY, 5, TOUCHES[0], 1)
    again = touched(ARRAY, 5, TOUCHES[0], 1)
    other = touched(ARRAY, 5, TOUCHES[0], 2)
    assert found["signals"] == again["signals"] != other["signals"]
    assert [touch[2] for touch in found["touches"]] == [5]

    signals = np.frombuffer(found["signals"], "<f4").reshape(2, found["samples"])
    write_wav(tmp_path / "take.wav", signals / FULL_SCALE, 1000, bits=32)
    content = (tmp_path / "take.wav").read_bytes()
    shown = replayed(ARRAY, content, "take.wav", FULL_SCALE)
    solve_library(ARRAY, tmp_path / "library.nc", fidelity="lumped")
    located = locate_recording(tmp_path / "library.nc", tmp_path / "take.wav", full_scale=FULL_SCALE)
    expected = [[each.start, each.end, each.point, each.probability, each.level] for each in located.touches]
    assert shown["touches"] == expected
    assert [touch[2] for touch in expected] == [5]
    decisions = [event for event in located.events if isinstance(event, Decision)]
    assert shown["decisions"] == [[each.time, each.state, each.point, each.probability] for each in decisions]

    with pytest.raises(Refusal, match=r"^broken\.wav"):
        replayed(ARRAY, b"RIFF" + content[8:60], "../../broken.wav", FULL_SCALE)
    with pytest.raises(Refusal, match=r"^take\.wav.*3"):
        replayed(prototype("glove"), content, "take.wav", FULL_SCALE)
