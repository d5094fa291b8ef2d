"""Files of one array are equal byte for byte, however often and after whatever else they are written."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import cadquery as cq
import numpy as np
import pytest

import geometry
from geometry.assembly.model import ArrayModel, array_model
from geometry.formats.part_files import export
from geometry.formats.step_assembly import write_step
from geometry.formats.three_mf import Body, write_3mf
from geometry.ground.stated_times import VARIABLE
from geometry.pictures.viewer import write_gltf, write_viewer
from geometry.solids.measure import tessellate

SMALL = geometry.prototype("array-2x6").with_values({"lines.0.points": 3, "layout.columns": 3})
WRITERS = (write_step, write_gltf, write_viewer)


@pytest.mark.parametrize("write", WRITERS, ids=lambda write: write.__name__)
def test_an_array_is_written_alike(
    write: Callable[[ArrayModel, Path], Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(VARIABLE, "1700000000")
    first, second = (write(array_model(SMALL), tmp_path / name).read_bytes() for name in ("first", "second"))
    assert first == second


@pytest.mark.parametrize("format_", ["stl", "step", "3mf"])
def test_a_part_is_written_alike(format_: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, "1700000000")
    for name in ("first", "second"):
        export({"block": cq.Workplane().box(1, 2, 3)}, tmp_path / name, [format_])
    first, second = ((tmp_path / name / f"block.{format_}").read_bytes() for name in ("first", "second"))
    assert first == second


def test_a_step_file_states_the_stopped_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, "1700000000")
    export({"block": cq.Workplane().box(1, 2, 3)}, tmp_path, ["step"])
    assert "'2023-11-14T22:13:20+00:00'" in (tmp_path / "block.step").read_text(encoding="utf-8")


def test_the_colours_of_an_assembly_survive_their_new_order(tmp_path: Path) -> None:
    model = array_model(SMALL)
    read = cq.Assembly.importStep(str(write_step(model, tmp_path / "array.step")))
    colours = {each.color.toTuple()[:3] for each in read.objects.values() if each.color is not None}
    drawn = {geometry.assembly.LOOKS[part.kind][0] for part in model.placed}
    expected = {tuple(int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5)) for colour in drawn}
    assert len(colours) == len(expected)
    for colour in expected:
        assert min(np.abs(np.subtract(colour, found)).max() for found in colours) < 0.01


def test_other_bodies_have_other_identifiers(tmp_path: Path) -> None:
    written = set()
    for name, size in (("a", 1.0), ("b", 1.0), ("a", 2.0)):
        facets = tessellate(cq.Workplane().box(size, 1, 1).val(), 0.1)
        write_3mf([Body(name, facets)], "title", tmp_path / "body.3mf")
        written.add((tmp_path / "body.3mf").read_bytes())
    assert len(written) == 3
