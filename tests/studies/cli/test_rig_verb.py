"""The verb ``rig``: what it writes is what its call writes, and what it says of it."""

from __future__ import annotations

from pathlib import Path

import pytest
from command import Command
from small_run import small_design

import geometry
import studies


def test_the_verb_writes_what_the_call_writes(
    command: Command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    module = "studies.test_rig.rig_session"
    for name, value in (("SECONDS", 4.0), ("TAKES", 1), ("TAKE_SECONDS", 4.0)):
        monkeypatch.setattr(f"{module}.{name}", value)
    geometry.save_design(small_design(), tmp_path / "row.toml")
    told = command(
        "rig",
        tmp_path / "row.toml",
        "--out",
        tmp_path / "verb",
        "--seed",
        5,
        "--altitude",
        900,
        "--modulus",
        0.9,
        "--fidelity",
        "lumped",
    )
    assert told.code == 0, told.err
    scatter = studies.HiddenScatter(altitude=900.0, modulus=0.9)
    studies.record_rig(small_design(), tmp_path / "call", seed=5, scatter=scatter, fidelity="lumped")
    for name in ("calibration/point-2.wav", "touches/point-02-taps-1.wav", "touches/touches.toml"):
        assert (tmp_path / "verb" / name).read_bytes() == (tmp_path / "call" / name).read_bytes()
    assert [Path(line).name for line in told.out.splitlines()[:4]] == [
        "calibration.toml",
        "touches.toml",
        "truth.json",
        "truth.nc",
    ]
    assert "--full-scale 2 --microphone-output voltage" in " ".join(told.out.split())
    refused = command("rig", tmp_path / "row.toml", "--out", tmp_path / "other", "--altitude", 9000)
    assert refused.code == 1
    assert "altitude = 9000" in refused.err
