"""A run of the whole chain: what lies in its folder, the same again when repeated, refusals before any work."""

from __future__ import annotations

import io
import json
import subprocess
import sys
import warnings
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from refusals import refused
from small_run import PLAN, small_design, small_run

import acoustic_fem
import geometry
from acoustic_fem.numerics.disk_cache import CacheWarning
from geometry import Kind
from localize import TrainingPlan, load_localizer
from studies.kit.jobs import BUILD, BUY, CAST, JOBS, PRINT
from studies.metrics.separation import separability
from studies.output.display import Display
from studies.output.folders import MANIFEST, MARK, claim_folder
from studies.run import pipeline as run_module
from studies.run.findings import membrane_compliances
from studies.run.library_files import cell_lines
from studies.run.pipeline import run_design
from studies.run.run_result import RunResult

ROOT = Path(__file__).parents[3]


def results() -> dict:
    return json.loads((small_run().folder / "results.json").read_text(encoding="utf-8"))


def test_the_folder_of_a_run_is_complete() -> None:
    folder = small_run().folder
    names = {path.name for path in folder.iterdir()}
    assert names == {
        MARK, "design.toml", "library.nc", "parts", "localizer", "figures", "results.json", "report.html", MANIFEST
    }  # fmt: skip
    kit = sorted(path.name for path in (folder / "parts").iterdir())  # the kit that the verb parts writes
    assert kit == [*JOBS, "READ-ME-FIRST.txt"]
    assert (folder / "parts" / BUILD / "manual.html").is_file()
    assert (folder / "parts" / BUY / "bill.json").is_file()
    places = (f"{PRINT}/parts", f"{CAST}/reference", f"{BUILD}/reference")
    single = [path for place in places for path in (folder / "parts" / place).iterdir()]
    stems = {path.stem for path in single}
    assert stems == set(small_run().part_counts)
    assert {path.suffix for path in single} == {".stl", ".step", ".3mf"}
    assert not list(folder.rglob(".*.new"))


def test_the_design_file_of_a_run_stands_alone() -> None:
    written = geometry.load_design(small_run().folder / "design.toml")
    assert written == small_design().completed()
    assert set(written.materials) == {"silicone-shore-a-30", "photopolymer-resin"}


def test_the_library_and_the_localizer_of_a_run_are_those_it_judged() -> None:
    result = small_run()
    library = acoustic_fem.load(result.folder / "library.nc")
    assert np.array_equal(library.transfer_function.values, result.library.transfer_function.values)
    assert np.array_equal(library.frequency, np.arange(1.0, 501.0))
    localizer = load_localizer(result.folder / "localizer")
    assert (localizer.design, localizer.point_count) == ("row-3", 3)
    assert localizer.plan["seconds_per_point"] == PLAN.seconds_per_point


def test_the_results_are_those_of_the_library() -> None:
    result, found = small_run(), results()
    distances = separability(result.library.transfer_function)
    assert found["separability"]["combined"] == distances.combined.tolist()
    assert found["separability"]["hardest_pairs"][0] == list(distances.hardest_pairs[0])
    assert np.sum(found["network"]["confusion"]) == found["network"]["touches"] == 3000
    for row, levels in zip(found["points"], np.abs(result.library.transfer_function.values[..., 9]), strict=True):
        assert row["level_10_hz_db"] == pytest.approx(20 * np.log10(levels))
    assert found["network"]["top1"] == pytest.approx(np.trace(found["network"]["confusion"]) / 3000)


def test_multi_sines_and_the_nominal_sensor_stand_beside_the_headline() -> None:
    for each in (results()["network"], results()["bayes"]):
        assert each["signals"] == "taps and presses on 20 as-built sensors"
        assert [(own["group"], own["signals"], own["sensors"]) for own in each["beside"]] == [
            ("as-built sensors", "taps", 20), ("as-built sensors", "presses", 20),
            ("virtual rigs", "taps and presses", 8), ("nominal sensor", "taps and presses", 1),
            ("as-built sensors", "multi-sine touches", 20), ("nominal sensor", "multi-sine touches", 1),
        ]  # fmt: skip
        assert each["worst"] == min(each["sensors"])
        assert each["multi_sines"]["top1"] == each["beside"][-1]["top1"]


def test_three_points_are_told_apart() -> None:
    found = results()
    assert found["bayes"]["multi_sines"]["top1"] > 0.99
    assert found["network"]["top1"] > 0.5  # three short epochs; chance is 0.33


def test_the_results_say_how_they_were_made() -> None:
    found = results()
    assert found["program"] == "acoustic-fem run"
    assert found["provenance"]["fidelity"] == "lumped"
    assert found["provenance"]["library"]["libraries"]["numpy"] == np.__version__
    assert found["provenance"]["localizer"]["seed"] == 0
    assert set(found["seconds"]) == {"Parts", "Cells", "Localizer", "Evaluation", "Figures"}
    assert [cell["method"] for cell in found["cells"]] == ["closed form"] * 2


def test_every_mesh_file_is_within_half_a_percent_of_its_solid() -> None:
    files = results()["files"]
    assert len(files) == 3 * len(small_run().part_counts)
    assert all(abs(file["volume_error"]) < 0.005 for file in files)


def test_the_size_and_the_compliance_are_those_of_the_design() -> None:
    # three points at a pitch of 18.5 mm, tubes of 12.5 mm to the middles of chambers of 1.9 mm; from there half
    # a board of 4.5 mm, its gap and its wall
    length = 2 * 18.5 + 2 * (3 + 12.5) + 1.9 + 4.5 + 2 * (0.1 + 1.0)
    # from the floor of a shell to the top of a microphone, whose chamber of 1.8 mm lies with its middle at 1.25 mm
    height = 1.0 + 1.25 + 0.9 + 0.4 + 0.98
    figures = {figure["name"]: figure["value"] for figure in results()["key_figures"]}
    assert figures["size"] == f"{length:.1f} x 10.0 x {height:.1f} mm"
    ((compliance, ratio),) = membrane_compliances(small_run())
    # a disc of a = 3 mm, h = 0.5 mm glued on a rim of 1.5 mm has 1.64 times the pi a^6 / (192 D) of a thin plate
    rigidity = 1.1424 * 0.5**3 / (12 * (1 - 0.49**2))
    assert compliance == pytest.approx(1.64 * np.pi * 3**6 / (192 * rigidity) * 1e-3, rel=0.005)
    assert ratio == pytest.approx(compliance / (70.686 / 101.325), rel=1e-3)


def test_a_run_trains_by_the_usual_plan_whatever_the_time() -> None:
    assert TrainingPlan().time_limit is None
    assert TrainingPlan().microphone_noise == "design"


@pytest.fixture(scope="module")
def again(tmp_path_factory: pytest.TempPathFactory) -> tuple[RunResult, str]:
    """The small run once more, while a cell in the cache is damaged, and what the console shows."""
    solve = acoustic_fem.solve

    def warned(*arguments: Any, **options: Any) -> acoustic_fem.Library:
        warnings.warn("old.cell is damaged; the cell is solved again", CacheWarning, stacklevel=1)
        return solve(*arguments, **options)

    told = io.StringIO()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(acoustic_fem, "solve", warned)
        folder = tmp_path_factory.mktemp("again")
        result = run_design(small_design(), folder, display=Display(told), fidelity="lumped", plan=PLAN)
    return result, told.getvalue()


@pytest.mark.slow
def test_the_same_run_again_gives_the_same_figures(again: tuple[RunResult, str]) -> None:
    first, second = small_run(), again[0]
    for one, two in ((first.network, second.network), (first.bayes, second.bayes)):
        assert np.array_equal(one.confusion, two.confusion)
    assert first.training["loss"] == second.training["loss"]
    weights = [next((run.folder / "localizer").glob("*.safetensors")).read_bytes() for run in (first, second)]
    assert weights[0] == weights[1]


@pytest.mark.slow
def test_warnings_reach_the_console_and_those_of_the_cache_are_no_limits_of_models(
    again: tuple[RunResult, str],
) -> None:
    result, told = again
    assert "note: old.cell is damaged; the cell is solved again\n" in told
    assert not any("damaged" in line for line in result.warnings)
    assert not any("shear number" in line for line in result.warnings)  # a default leaves no range, at 500 Hz
    assert all(f"note: {line}\n" in told for line in result.warnings)


def test_a_design_of_one_point_is_refused_before_any_work(tmp_path: Path) -> None:
    one = small_design().with_values({"lines.0.points": 1})
    with refused(Kind.UNSUITABLE, "lines.0.points", 1, file="row-3"):
        run_design(one, tmp_path / "out")
    geometry.save_design(one, tmp_path / "one.toml")
    with refused(Kind.UNSUITABLE, "lines.0.points", 1, file=tmp_path / "one.toml"):
        run_design(tmp_path / "one.toml", tmp_path / "out")
    assert not (tmp_path / "out").exists()


# -- folders ------------------------------------------------------------------------------------------------
def test_a_folder_of_somebody_else_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.txt").write_text("all my work")
    with refused(Kind.EXISTS, "out", file=tmp_path):
        run_design(small_design(), tmp_path, fidelity="lumped")
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.txt"]


def names(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


def test_a_run_that_fails_leaves_no_report_and_can_be_repeated(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def killed(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(run_module, "_make_parts", killed)
    with pytest.raises(KeyboardInterrupt):
        run_design(small_design(), tmp_path, fidelity="lumped")
    assert names(tmp_path) == {MARK, "design.toml"}
    assert claim_folder(tmp_path, "one") == tmp_path


@pytest.mark.slow
def test_a_run_from_the_command_line_solves_cells_once_and_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    geometry.save_design(small_design(), tmp_path / "row-3.toml")
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path / "cells"))
    done = subprocess.run(
        [sys.executable, "-m", "studies.cli", "run", str(tmp_path / "row-3.toml"), "--out", str(tmp_path / "out")],
        cwd=ROOT, capture_output=True, encoding="utf-8", check=True,
    )  # fmt: skip
    assert done.stdout.endswith("report.html\n")
    assert done.stderr.count("unknowns solved at") == 2
    assert "from the cache" not in done.stderr
    found = json.loads((tmp_path / "out" / "results.json").read_text(encoding="utf-8"))
    assert not any(cell["cached"] for cell in found["cells"])
    assert found["training"]["plan"] == json.loads(json.dumps(asdict(TrainingPlan())))
    assert not found["training"]["cut_short"]
    assert found["network"]["top1"] > 0.95  # taps and presses on as-built sensors
    assert found["lumped_difference"]["magnitude"] < 0.015
    assert found["lumped_difference"]["phase"] < 1.0
    assert "Lumped is within them" in (tmp_path / "out" / "report.html").read_text(encoding="utf-8")

    # what a second run finds
    first = acoustic_fem.load(tmp_path / "out" / "library.nc")
    again = acoustic_fem.solve(small_design(), first.frequency)
    assert "\n".join(cell_lines(again)).count("from the cache (") == 2
    assert all(cell["cached"] for cell in again.provenance["cells"])
    assert np.array_equal(again.transfer_function, first.transfer_function)
