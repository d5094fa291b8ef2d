"""A case whose parts get into each other's way fails by name, the others are computed; of a base that does, none is."""

from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

from geometry.layout.overlaps import OverlapError
from studies.cli.app import app
from studies.study.cases import cases_of
from studies.study.study import read_study
from studies.sweep.block import Job, solve_block
from studies.sweep.run import SweepError, run_sweep
from studies.sweep.survey import surveyed

STUDY = """
base = "array-2x6"
fidelity = "lumped"
frequency = "1:100:4"
metrics = ["distance_smallest"]
[vary]
"microphone_tube.length" = [3.1, 12.5]
"""


def test_a_case_that_cannot_be_built_fails_with_the_reason_and_is_counted_beforehand() -> None:
    study = read_study(STUDY)
    job = Job("lumped", study.frequency, study.metrics)
    result, _ = solve_block(job, cases_of(study), 0, {})
    assert result.reason[0].startswith("array-2x6: cannot be built: shell 1 overlaps microphone A by ")
    assert result.reason[1] == ""
    assert np.isfinite(result.values["distance_smallest"]).tolist() == [False, True]
    assert surveyed(study, every=True).refused == {0: result.reason[0]}


def test_a_base_that_cannot_be_built_is_refused_with_what_mends_it_before_any_work(tmp_path: Path) -> None:
    base = read_study(STUDY).base.with_values({"microphone_tube.length": 3.1})
    study = read_study(STUDY, base=base)
    with pytest.raises(OverlapError, match=r"shell 1 overlaps microphone A by .*; set microphone_tube\.length = "):
        run_sweep(study, tmp_path / "r.zarr", workers=1)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("lengths", "code"), [("3.1, 12.5", 0), ("3.1, 3.2", 1)])
def test_a_sweep_is_a_success_where_a_case_could_be_computed(tmp_path: Path, lengths: str, code: int) -> None:
    (tmp_path / "study.toml").write_text(STUDY.replace("3.1, 12.5", lengths), encoding="utf-8")
    out = tmp_path / "r.zarr"
    told = CliRunner().invoke(app, ["sweep", str(tmp_path / "study.toml"), "--out", str(out), "--workers", "1"])
    assert told.exit_code == code, told.output
    assert f"{1 + code} failed, the first of each kind:" in told.output
    if code:
        assert isinstance(told.exception, SweepError)
        assert str(told.exception).startswith(f"{out}: none of 2 cases could be computed; case 0: array-2x6: cannot be")
