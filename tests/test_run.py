"""A run of the whole chain: what lies in its folder, and what it does with folders that are not its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from small_run import PLAN, small_design, small_run

import acoustic_fem
import geometry
from localize import load_localizer
from studies import run as run_module
from studies.folders import MARK, check_folder, check_new_file, claim_folder, replaced_folder
from studies.metrics import separability
from studies.results import array_size, membrane_compliance
from studies.run import run_design, training_seconds

ROOT = Path(__file__).parents[1]


def results() -> dict:
    return json.loads((small_run().folder / "results.json").read_text(encoding="utf-8"))


def test_the_folder_of_a_run_is_complete() -> None:
    folder = small_run().folder
    names = {path.name for path in folder.iterdir()}
    assert names == {
        MARK, "design.toml", "library.nc", "parts", "localizer", "figures", "results.json", "report.html"
    }  # fmt: skip
    stems = {path.stem for path in (folder / "parts").iterdir()}
    assert stems == set(small_run().part_counts)
    assert {path.suffix for path in (folder / "parts").iterdir()} == {".stl", ".step", ".3mf"}
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


def test_three_points_are_told_apart() -> None:
    found = results()
    assert found["bayes"]["top1"] > 0.99
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
    width, depth, height = array_size(small_design())
    # three points at a pitch of 18.5 mm, microphone tubes of 12.5 mm, housings and chambers beyond
    assert width == pytest.approx(2 * 18.5 + 2 * (3 + 12.5) + 2 * 1.9 + 2 * 1.0)
    assert depth == pytest.approx(10.0)
    assert height == pytest.approx(1.0 + 2.5 + 0.5)
    compliance, ratio = membrane_compliance(small_run())
    # a disc of a = 3 mm, h = 0.5 mm glued on a rim of 1.5 mm has 1.64 times the pi a^6 / (192 D) of a thin plate
    rigidity = 1.1424 * 0.5**3 / (12 * (1 - 0.49**2))
    assert compliance == pytest.approx(1.64 * np.pi * 3**6 / (192 * rigidity) * 1e-3, rel=0.005)
    assert ratio == pytest.approx(compliance / (70.686 / 101.325), rel=1e-3)


def test_larger_arrays_are_trained_longer() -> None:
    assert [training_seconds(points) for points in (3, 12, 64, 216)] == [40.0, 40.0, 192.0, 300.0]


# -- folders ------------------------------------------------------------------------------------------------
def test_a_folder_of_somebody_else_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.txt").write_text("all my work")
    with pytest.raises(ValueError, match=r"holds files that no run of this program made"):
        run_design(small_design(), tmp_path, fidelity="lumped")
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.txt"]


def test_a_new_run_takes_the_old_report_away_first(tmp_path: Path) -> None:
    claim_folder(tmp_path)
    for name in ("report.html", "results.json", "library.nc"):
        (tmp_path / name).write_text("old")
    claim_folder(tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == [MARK, "library.nc"]


def test_a_run_that_fails_leaves_no_report_and_can_be_repeated(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def killed(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(run_module, "_make_parts", killed)
    with pytest.raises(KeyboardInterrupt):
        run_design(small_design(), tmp_path, fidelity="lumped")
    assert sorted(path.name for path in tmp_path.iterdir()) == [MARK, "design.toml"]
    assert claim_folder(tmp_path) == tmp_path


def test_a_folder_is_replaced_only_when_all_went_well(tmp_path: Path) -> None:
    target = tmp_path / "parts"
    target.mkdir()
    (target / "old.stl").write_text("old")

    def fail() -> None:
        with replaced_folder(target) as fresh:
            (fresh / "half.stl").write_text("half")
            raise ValueError("broken")

    with pytest.raises(ValueError, match="broken"):
        fail()
    assert [path.name for path in target.iterdir()] == ["old.stl"]
    with replaced_folder(target) as fresh:
        (fresh / "new.stl").write_text("new")
    assert [path.name for path in target.iterdir()] == ["new.stl"]
    assert [path.name for path in tmp_path.iterdir()] == ["parts"]


def test_places_that_cannot_be_written_are_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(ValueError, match="is a folder; --out must be a file"):
        check_new_file(tmp_path)
    with pytest.raises(ValueError, match="must lie in a folder that exists"):
        check_new_file(tmp_path / "none" / "library.nc")
    for place in (tmp_path / "file", tmp_path / "file" / "deeper"):
        with pytest.raises(ValueError, match=r"must be a folder; .*file is a file"):
            check_folder(place)
    check_folder(tmp_path / "new" / "deeper")


@pytest.mark.slow
def test_a_run_from_the_command_line_solves_cells_once_and_says_so(tmp_path: Path) -> None:
    geometry.save_design(small_design(), tmp_path / "row-3.toml")
    environment = {**os.environ, "ACOUSTIC_FEM_CACHE": str(tmp_path / "cells")}
    told = []
    for _ in range(2):
        done = subprocess.run(
            [sys.executable, "-m", "studies.cli", "run", str(tmp_path / "row-3.toml"), "--out", str(tmp_path / "out")],
            cwd=ROOT, env=environment, capture_output=True, text=True, check=True,
        )  # fmt: skip
        told.append(done.stderr)
        assert done.stdout.endswith("report.html\n")
    assert told[0].count("unknowns solved at") == 2
    assert "from the cache" not in told[0]
    assert told[1].count("from the cache (") == 2
    found = json.loads((tmp_path / "out" / "results.json").read_text(encoding="utf-8"))
    assert all(cell["cached"] for cell in found["cells"])
    assert found["lumped_difference"]["magnitude"] < 0.015
    assert found["lumped_difference"]["phase"] < 1.0
    assert "Lumped is within them" in (tmp_path / "out" / "report.html").read_text(encoding="utf-8")
