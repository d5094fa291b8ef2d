"""Models, findings and files that the page hands on are those that Python makes."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
from geometry import Kind, Refusal, load_design, prototype, resolve_design
from geometry.layout.size import array_size
from studies.panels.cad_panel import check_figures, model_of_array, read_upload
from studies.panels.export_files import EXPORTS, make_export
from studies.panels.form import stated_values
from studies.run.check import check_design

ARRAY = prototype("array-2x6")
ROBOT = Path(__file__).parents[3] / "docs" / "examples" / "robot"
SMALL = ARRAY.with_values({"lines": [{"between": ["A", "B"], "points": 2}], "layout.columns": 2})


def test_a_design_that_is_handed_in_is_read_by_the_reader_of_design_files(tmp_path: Path) -> None:
    path = Path(make_export(ARRAY, "design.toml", str(tmp_path), "lumped"))
    assert load_design(path) == ARRAY
    found = read_upload(path.read_text(encoding="utf-8"), "mine.toml")
    assert found == {"stated": stated_values(load_design(path)), "note": ""}
    with pytest.raises(Refusal, match=r"^mine\.toml: "):
        read_upload("name = 3", "mine.toml")


def test_a_design_on_a_body_is_read_with_its_places_or_is_not_fitted_yet() -> None:
    design, text = load_design(ROBOT / "palm.toml"), (ROBOT / "palm.toml").read_text(encoding="utf-8")
    places = (ROBOT / "palm.places.json").read_text(encoding="utf-8")
    assert read_upload(text, "palm.toml", ("palm.places.json", places)) == {"stated": stated_values(design), "note": ""}
    alone = read_upload(text, "palm.toml")
    assert "If you have palm.places.json, open both files together" in alone["note"]
    assert alone["stated"]["layout"]["kind"] == "serpentine"
    assert alone["stated"]["surface"] == stated_values(design)["surface"]
    with refused(Kind.MISMATCH, "places", value="handle.places.json"):
        read_upload(text, "palm.toml", ("handle.places.json", places))
    with pytest.raises(Refusal, match=r"^palm\.places\.json: "):
        read_upload(text, "palm.toml", ("palm.places.json", "{}"))


def test_a_library_is_the_one_that_solve_writes(tmp_path: Path) -> None:
    path = make_export(SMALL, "library.nc", str(tmp_path), "lumped")
    expected = acoustic_fem.solve(SMALL, np.arange(1.0, 501.0), fidelity="lumped")
    assert acoustic_fem.load(path).transfer_function.equals(expected.transfer_function)


def test_another_export_or_fidelity_is_refused(tmp_path: Path) -> None:
    with refused(Kind.OUT_OF_RANGE, "export", value="a.exe"):
        make_export(ARRAY, "a.exe", str(tmp_path), "lumped")
    with refused(Kind.OUT_OF_RANGE, "fidelity", value="best"):
        make_export(ARRAY, "library.nc", str(tmp_path), cast(Any, "best"))
    assert list(EXPORTS) == ["design.toml", "library.nc", "library.sofa", "parts.zip", "report.html"]


@pytest.mark.slow
def test_the_model_is_the_projects_own_gltf_and_the_findings_are_those_of_check() -> None:
    import trimesh

    found = model_of_array(SMALL)
    scene = trimesh.load(io.BytesIO(found["glb"]), file_type="glb")
    labels = {part["label"] for part in found["parts"]}
    assert labels <= set(scene.graph.nodes)
    assert {part["group"] for part in found["parts"]} >= {"point 1", "point 2", "microphone A"}
    assert found["size"] == list(array_size(SMALL))
    # The size leaves out the heads of boards, which may be bent away.
    scene.delete_geometry([part["part"] for part in found["parts"] if part["kind"] == "board"])
    assert max(found["size"]) == pytest.approx(1000 * max(scene.extents), rel=0.02)

    told: list[str] = []
    checked, expected = check_figures(SMALL, told.append), check_design(SMALL, quality=False)
    assert checked == {**expected.to_dict(), "verdict": expected.buildability}
    assert any("Print rules (6 of 6)" in line for line in told)
    assert {finding["part"] for finding in checked["printing"]["findings"]} & {part["part"] for part in found["parts"]}
    assert resolve_design("array-2x6") == ARRAY


@pytest.mark.slow
def test_the_model_of_a_fitted_array_has_the_body_that_lies_beside_the_design(tmp_path: Path) -> None:
    import trimesh

    design = load_design(ROBOT / "fingertip.toml")
    found = model_of_array(design, str(ROBOT / "fingertip.step"))
    assert [part["label"] for part in found["parts"] if part["kind"] == "body"] == ["body"]
    scene = trimesh.load(io.BytesIO(found["glb"]), file_type="glb")
    body = scene.geometry["body"]
    assert np.ptp(body.vertices, axis=0)[:2] == pytest.approx([18, 18], abs=0.1)  # a capsule
    (tmp_path / "fingertip.step").write_bytes((ROBOT / "fingertip.step").read_bytes() + b"\n")
    for folder, words in ((tmp_path, "has changed"), (tmp_path / "empty", "no such file")):
        found = model_of_array(design, str(folder / "fingertip.step"))
        assert words in found["notes"][0]
        assert not [part for part in found["parts"] if part["kind"] == "body"]
