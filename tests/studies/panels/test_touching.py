"""Touches and recordings of the page are decoded as ``locate`` decodes them."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from fake_audio import FakeAudio
from refusals import refused

from acoustic_fem.sound.sound_file import write_wav
from geometry import Kind, Refusal, prototype
from localize import Decision
from localize.contacts.contact import surface_of
from localize.live import sound_device
from studies import locate_recording, solve_library
from studies.inference.tracked import track_recording
from studies.panels.live_panel import listen_live, sound_cards
from studies.panels.touching import (
    TOUCHES,
    manifest_scale,
    membranes,
    replay_recording,
    simulate_slide,
    simulate_touch,
)

ARRAY = prototype("array-2x6")
FULL_SCALE = 200.0


def test_the_membranes_lie_where_contacts_find_them() -> None:
    import acoustic_fem

    place, radius = surface_of(acoustic_fem.solve(ARRAY, np.linspace(1, 100, 8), fidelity="lumped"))
    found = np.array(membranes(ARRAY)["points"])
    np.testing.assert_array_equal(found[:, :2], place)
    np.testing.assert_array_equal(found[:, 2], np.broadcast_to(radius, 12))


@pytest.mark.parametrize(
    ("point", "kind", "field"),
    [
        (0, "tap", "point"),
        (13, "tap", "point"),
        (1, "hit", "kind"),
    ],
)
def test_what_cannot_be_touched_is_refused(point: int, kind: str, field: str) -> None:
    with refused(Kind.OUT_OF_RANGE, field, value={"point": point, "kind": kind}[field]):
        simulate_touch(ARRAY, point, kind, 0)


@pytest.mark.slow
def test_a_touch_is_decoded_as_locate_decodes_its_recording(tmp_path: Path) -> None:
    found = simulate_touch(ARRAY, 5, TOUCHES[0], 1)
    again = simulate_touch(ARRAY, 5, TOUCHES[0], 1)
    other = simulate_touch(ARRAY, 5, TOUCHES[0], 2)
    assert found["signals"] == again["signals"] != other["signals"]
    assert [touch[2] for touch in found["touches"]] == [5]

    signals = np.frombuffer(found["signals"], "<f4").reshape(2, found["samples"])
    write_wav(tmp_path / "take.wav", signals / FULL_SCALE, 1000, bits=32)
    content = (tmp_path / "take.wav").read_bytes()
    shown = replay_recording(ARRAY, content, "take.wav", FULL_SCALE)
    solve_library(ARRAY, tmp_path / "library.nc", fidelity="atlas")
    located = locate_recording(tmp_path / "library.nc", tmp_path / "take.wav", full_scale=FULL_SCALE)
    expected = [[each.start, each.end, each.point, each.probability, each.level] for each in located.touches]
    assert shown["touches"] == expected
    assert [touch[2] for touch in expected] == [5]
    assert shown["full_scale"] == FULL_SCALE
    text = "\n".join(",".join(f"{value:.9g}" for value in row) for row in signals.T)
    (tmp_path / "take.csv").write_text("A,B\n" + text + "\n")
    told: list[str] = []
    pascals = replay_recording(ARRAY, (tmp_path / "take.csv").read_bytes(), "take.csv", 1e-6, told.append)
    assert pascals["full_scale"] is None  # the file holds pascals, whatever full scale is set
    assert pascals["touches"] == pytest.approx(np.array(expected), rel=1e-4)
    assert told[-1].startswith("1 touch found")
    decisions = [event for event in located.events if isinstance(event, Decision)]
    assert shown["decisions"] == [[each.time, each.state, each.point, each.probability] for each in decisions]

    with pytest.raises(Refusal, match=r"^broken\.wav"):
        replay_recording(ARRAY, b"RIFF" + content[8:60], "../../broken.wav", FULL_SCALE)
    with pytest.raises(Refusal, match=r"^take\.wav.*3"):
        replay_recording(prototype("glove"), content, "take.wav", FULL_SCALE)


@pytest.mark.slow
def test_the_path_of_a_slide_is_that_of_track_and_live_hears_what_was_recorded(tmp_path: Path) -> None:
    design = prototype("fingertip-3x4")
    points = membranes(design)["points"]
    start, end = points[0][:2], points[3][:2]
    found = simulate_slide(design, start, end, 1)
    signals = np.frombuffer(found["signals"], "<f4").reshape(-1, found["samples"])
    write_wav(tmp_path / "slide.wav", signals / FULL_SCALE, 1000, bits=32)
    solve_library(design, tmp_path / "library.nc", fidelity="lumped")
    tracked = track_recording(tmp_path / "library.nc", tmp_path / "slide.wav", full_scale=FULL_SCALE)
    assert len(found["paths"]) == len(tracked.tracks) > 0
    for shown, track in zip(found["paths"], tracked.tracks, strict=True):
        expected = np.column_stack([track.time, track.place, track.deviation, track.detected])
        np.testing.assert_allclose(np.array(shown["places"])[1:-1], expected[1:-1], rtol=0.05, atol=0.05)
    replay = replay_recording(design, (tmp_path / "slide.wav").read_bytes(), "slide.wav", FULL_SCALE)
    gestures = [f"{each.kind} {each.direction}".strip() for each in tracked.gestures]
    assert [each["gesture"] for each in replay["paths"]] == gestures == ["swipe right"]

    lines: list[str] = []
    told = listen_live(design, None, FULL_SCALE, tmp_path / "slide.wav", lines.append)
    events = [json.loads(line) for line in lines]
    samples = np.concatenate([event["samples"] for event in events if "samples" in event], axis=1)
    assert told["samples_lost"] == 0
    assert samples.shape[1] >= signals.shape[1] - 32
    named = {event["point"] for event in events if event.get("state") == "touch"}
    assert named <= {1, 2, 3, 4}
    assert named


def test_the_full_scale_of_recorded_touches_is_that_of_their_manifest() -> None:
    assert manifest_scale("full_scale = 20.0\n[[recordings]]\nfile = 'a.wav'\n", "touches.toml") == 20.0
    assert manifest_scale("output = 'pressure'\n", "touches.toml") == 1.0
    with pytest.raises(Refusal, match=r"^touches\.toml"):
        manifest_scale("full_scale = ", "touches.toml")
    with refused(Kind.OUT_OF_RANGE, "full_scale", value=0):
        manifest_scale("full_scale = 0", "touches.toml")


@pytest.mark.parametrize(("end", "length"), [([0.0, 0.0], 0.0), ([5000.0, 0.0], 5000.0)])
def test_a_slide_has_a_length(end: list[float], length: float) -> None:
    with refused(Kind.OUT_OF_RANGE, "length of the slide", value=length):
        simulate_slide(ARRAY, [0.0, 0.0], end, 1)


def test_sound_cards_are_those_that_can_record(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sound_device, "load_sounddevice", lambda: FakeAudio([]))
    assert sound_cards() == [{"number": 1, "name": "USB array, ALSA", "channels": 4, "default": True}]
