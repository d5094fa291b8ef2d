"""The verb calibrate: library and figure of a made sensor, and nothing overwritten."""

from __future__ import annotations

import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from refusals import refused
from typer.testing import CliRunner

import acoustic_fem
import geometry
from acoustic_fem.library.transfer_functions import MEASURED
from geometry import Kind
from geometry.design.design_file import write_design
from studies.cli import calibrations
from studies.cli.app import app
from studies.test_rig.virtual_rig import Recorder, Rig

GRID = np.linspace(1.0, 100.0, 34)


DESIGN = geometry.prototype("array-2x6").with_values({"lines.0.points": 4, "layout.columns": 4})


POINTS = (1, 2, 3, 4)


SHORT = Recorder(seconds=40.0)


def test_the_verb_writes_library_and_figure_and_names_what_it_left_out(tmp_path: Path) -> None:
    Rig(DESIGN, 6, fidelity="lumped").record(tmp_path, [1, 2], SHORT)
    (tmp_path / "point-2.wav").write_bytes((tmp_path / "point-2.wav").read_bytes()[:5000])
    out = tmp_path / "made.nc"
    result = CliRunner().invoke(
        app, ["calibrate", str(tmp_path), "--out", str(out), "--frequencies", "1:100:16", "--fidelity", "lumped"]
    )
    assert result.exit_code == 0, result.output
    assert "left out" in result.output
    assert "cut short" in result.output
    assert "1 of 4 points measured, 3 fitted" in result.output
    told = " ".join(result.output.split())  # whatever the width of the terminal
    assert re.search(r"chi-squared \d+ for \d+ residuals: a sensor within the tolerances fits", told)
    mean, worst = (float(value) for value in re.findall(r"expected accuracy +(\d+\.\d) %", result.output))
    assert 0 < worst <= mean <= 100
    assert (tmp_path / "made.png").stat().st_size > 10_000
    assert acoustic_fem.load(out).fidelity == MEASURED


def test_a_fit_that_is_not_used_is_shown_with_its_figures_and_a_warning(capsys: pytest.CaptureFixture[str]) -> None:
    fit = SimpleNamespace(
        eigenvalues=np.array([2.0, 0.5]), chi_squared=900.0, residuals=768, parameters=(0, 0), objection="it is not",
        worst_point=1, delay=1.0,
    )  # fmt: skip
    manifest = SimpleNamespace(design=SimpleNamespace(point_count=2))
    calibration = SimpleNamespace(missing=(2,), estimates={1: None}, findings=(), manifest=manifest)
    found = SimpleNamespace(fit=fit, calibration=calibration, expected=None, out="made.nc", measure_next=None)
    calibrations._show_calibration(found)
    shown = capsys.readouterr().out
    assert shown.startswith("made.nc: 1 of 2 points measured, 1 of the design\n")
    assert re.search(r"chi-squared +900 +for 768 residuals: no sensor within the tolerances fits", shown)
    assert re.search(r"determined +1 +of 2 combinations", shown)
    assert "delay" not in shown
    assert "it is not" in shown
    assert re.search(r"warning: .*point 2 too, .*point 1\.", shown)


@pytest.mark.parametrize(
    ("earlier", "out", "kind", "file"),
    [
        ("made.nc", "made.nc", Kind.EXISTS, "made.nc"),
        ("made.png", "made.nc", Kind.EXISTS, "made.png"),
        ("other.nc", "made.txt", Kind.OUT_OF_RANGE, "made.txt"),
        ("other.nc", "made.png", Kind.OUT_OF_RANGE, "made.png"),
    ],
)
def test_the_verb_overwrites_nothing_and_says_so_before_any_work(
    tmp_path: Path, earlier: str, out: str, kind: Kind, file: str
) -> None:
    (tmp_path / earlier).write_bytes(b"of an earlier calibration")
    with refused(kind, "out", file=tmp_path / file):
        CliRunner().invoke(
            app, ["calibrate", str(tmp_path / "no-recordings"), "--out", str(tmp_path / out)],
            standalone_mode=False, catch_exceptions=False,
        )  # fmt: skip
    assert [path.name for path in tmp_path.iterdir()] == [earlier]
    assert (tmp_path / earlier).read_bytes() == b"of an earlier calibration"


def test_a_sensor_that_no_fit_takes_is_calibrated_from_recordings_of_all_points(tmp_path: Path) -> None:
    """The batch refuses stretched membranes with loss; measured at every point, nothing has to be computed for it."""
    Rig(DESIGN, 8, fidelity="lumped").record(tmp_path, POINTS, SHORT)
    shaped = DESIGN.with_values({"membrane.stretch": 1.2})
    (tmp_path / "design.toml").write_text(write_design(shaped), encoding="utf-8")
    out = tmp_path / "made.nc"
    result = CliRunner().invoke(
        app, ["calibrate", str(tmp_path), "--out", str(out), "--frequencies", "1:100:8", "--fidelity", "lumped"]
    )
    assert result.exit_code == 0, result.output
    assert "4 of 4 points measured\n" in result.output
    assert acoustic_fem.load(out).design == shaped
