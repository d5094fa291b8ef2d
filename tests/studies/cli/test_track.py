"""The verb track."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from command import Command

import acoustic_fem
import geometry
import studies
from acoustic_fem.sound import write_wav
from geometry.layout import frozen_values, lay_out
from localize.contacts import Contact, record
from localize.signals import response_of


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A library of two rows of three points, and a recording of a finger that goes along the first."""
    made = tmp_path_factory.mktemp("track")
    design = geometry.prototype("array-2x6").with_values(
        {"lines.0.points": 6, "layout.kind": "serpentine", "layout.columns": 3, "layout.pitch": 18.0}
    )
    library = acoustic_fem.solve(design, np.arange(1.0, 501.0, 1.0), "lumped")
    acoustic_fem.save(library, made / "library.nc")
    array = response_of(library)
    assert array.position is not None
    time = np.arange(2500) / 1e3
    share = np.clip((time - 0.5) / 0.6, 0, 1)[:, None]
    path = array.position[0] + share * (array.position[2] - array.position[0])
    pressed = (time > 0.5) & (time < 1.1)
    signals = record(Contact(time, path, 5e-3 * pressed, 5.0, 0.2), array, microphone_noise=1e-3).signals
    write_wav(made / "slide.wav", signals / 100, 1000)
    return made


def test_track_writes_a_table_and_a_picture_and_names_the_gesture(command: Command, folder: Path) -> None:
    words = ("--full-scale", 100, "--noise", 1e-3)
    out, picture = folder / "path.csv", folder / "path.png"
    told = command("track", folder / "library.nc", folder / "slide.wav", "--out", out, "--picture", picture, *words)
    assert told.code == 0, told.err
    assert "swipe" in told.out
    assert "1 path in 2.5 s" in told.out
    assert "the decoder assumes that the sensor is exactly as it was designed" in told.out
    assert picture.read_bytes().startswith(b"\x89PNG")
    with out.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert list(rows[0]) == list(studies.inference.tracked.COLUMNS)
    assert {row["path"] for row in rows} == {"1"}
    assert all(bool(row["force_N"]) == (row["detected"] == "1") for row in rows)
    called = studies.track_recording(
        folder / "library.nc", folder / "slide.wav", full_scale=100.0, decoding=studies.Decoding(microphone_noise=1e-3)
    )
    assert called.force_is_known
    place = np.array([[float(row["x_mm"]), float(row["y_mm"])] for row in rows])
    assert np.abs(place - called.tracks[0].place).max() < 1e-3


@pytest.mark.slow
def test_live_tells_places_beside_points(command: Command, folder: Path) -> None:
    words = ("--full-scale", 100, "--noise", 1e-3, "--radius", 5)
    told = command("live", folder / "library.nc", "--replay", folder / "slide.wav", *words)
    assert told.code == 0, told.err
    places = [each for each in map(json.loads, told.out.splitlines()) if "x" in each]
    assert len(places) > 10
    assert all(each["latency"] > 0.1 and each["deviation"] > 0 for each in places)
    assert command("live", folder, "--replay", folder / "slide.wav", "--radius", 5).code == 1


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("library.nc", "slide.wav", "--out", "library.nc"), "library.nc"),
        (
            ("library.nc", "slide.wav", "--out", "x.csv", "--radius", 999),
            "--radius = 999 mm must be between 0.05 and 100",
        ),
        (("localizer", "slide.wav", "--out", "x.csv"), "localizer: is a folder without localizer.json"),
        (("library.nc", "short.wav", "--out", "x.csv"), "short.wav: has 100 samples"),
        (("library.nc", "slide.wav", "--out", "x.csv", "--picture", "slide.wav"), "slide.wav"),
    ],
)
def test_what_cannot_be_tracked_is_told_in_one_line(
    command: Command, folder: Path, monkeypatch: pytest.MonkeyPatch, words: tuple[object, ...], message: str
) -> None:
    monkeypatch.chdir(folder)
    Path("localizer").mkdir(exist_ok=True)
    write_wav("short.wav", np.random.default_rng(0).uniform(-1, 1, (2, 100)), 1000)
    told = command("track", *words)
    assert told.code == 1
    line = [each for each in told.err.splitlines() if each.startswith("acoustic-fem: ")]
    assert len(line) == 1
    assert message in line[0]
    assert not Path("x.csv").exists()


@pytest.mark.slow
def test_track_names_a_wrong_connection_and_says_nothing_of_a_right_one(folder: Path, tmp_path: Path) -> None:
    library = acoustic_fem.load(folder / "library.nc")
    array = response_of(library)
    assert array.position is not None
    time = np.arange(8000) / 1e3
    place = array.position[2] + 0.5 * (1 - np.cos(2 * np.pi * time / 8))[:, None] * (
        array.position[0] - array.position[2]
    )
    signals = record(Contact(time, place, np.full(8000, 5e-3), 5.0, 0.2), array, microphone_noise=1e-3).signals
    a, b = signals / 100
    late = np.concatenate([np.zeros(30), b[:-30]])
    given = {"full_scale": 100.0, "decoding": studies.Decoding(microphone_noise=1e-3)}
    for name, (one, other) in {"right": (a, b), "reversed": (a, -b), "late": (a, late)}.items():
        write_wav(tmp_path / f"{name}.wav", np.stack([one, other]), 1000)
        found = studies.track_recording(library, tmp_path / f"{name}.wav", **given)
        if name == "right":
            assert (found.fault, found.warning) == (None, None)
            continue
        assert found.fault is not None
        assert found.fault.kind == name
        assert found.warning is not None
        assert found.fault.described(array.microphones) in found.warning
        assert name == "reversed" or found.fault.amount == pytest.approx(-0.03, abs=1e-3)


def test_a_path_on_a_body_has_its_places_in_space(command: Command, folder: Path, tmp_path: Path) -> None:
    """A flat array that is frozen is a body whose places in space are those of its plan."""
    flat = acoustic_fem.load(folder / "library.nc").design
    frozen = flat.with_values(frozen_values(flat, lay_out(flat)))
    acoustic_fem.save(acoustic_fem.solve(frozen, np.arange(1.0, 501.0, 1.0), "lumped"), tmp_path / "library.nc")
    out = tmp_path / "path.csv"
    words = (folder / "slide.wav", "--out", out, "--full-scale", 100, "--noise", 1e-3)
    told = command("track", tmp_path / "library.nc", *words)
    assert told.code == 0, told.err
    assert "whose distances are off by 0.0 % (rms); the table also has the places on the body" in " ".join(
        told.out.split()
    )
    with out.open(newline="") as file:
        rows = list(csv.DictReader(file))
    tracked = studies.inference.tracked
    assert list(rows[0]) == [*tracked.COLUMNS, *tracked.BODY_COLUMNS]
    place, space, normal = (
        np.array([[float(row[name]) for name in names] for row in rows])
        for names in (("x_mm", "y_mm"), tracked.BODY_COLUMNS[:3], tracked.BODY_COLUMNS[3:])
    )
    assert np.abs(space[:, :2] - place).max() < 2e-3
    assert np.ptp(space[:, 2]) < 1e-3
    assert np.abs(normal - (0, 0, 1)).max() < 1e-3
    # An earlier table of either kind is replaced.
    assert command("track", folder / "library.nc", *words).code == 0
