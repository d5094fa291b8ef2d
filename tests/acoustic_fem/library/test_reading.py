"""Imports that reading a library takes: its file and its design, no layout and no finite elements."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import acoustic_fem
import geometry
from acoustic_fem.library.exchange import export, load
from geometry.layout.arrangement import lay_out, place_housings
from geometry.layout.overlaps import overlaps
from geometry.layout.placement import point_places


@pytest.mark.parametrize("name", geometry.prototype_names())
def test_points_are_counted_without_a_layout_as_a_layout_counts_them(name: str) -> None:
    design = geometry.prototype(name)
    points = lay_out(design).points
    assert [point.number for point in points] == list(range(1, design.point_count + 1))
    assert tuple((point.line, point.place) for point in points) == point_places(design)


def test_a_library_is_read_without_a_layout_and_solved_with_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    laid_out, measured = [], []
    for module in ("library.network_responses", "library.sofa_file"):
        monkeypatch.setattr(
            f"acoustic_fem.{module}.place_housings",
            lambda design: (laid_out.append(design.name), place_housings(design))[1],
        )
    monkeypatch.setattr("geometry.layout.overlaps.overlaps", lambda *given: (measured.append(1), overlaps(*given))[1])
    library = acoustic_fem.solve(geometry.prototype("line-2"), [1.0, 10.0], "lumped")
    assert len(laid_out) == 1
    for name in ("library.nc", "library.npz"):
        path = tmp_path / name
        export(library, path)
        assert load(path).design == library.design
    assert len(laid_out) == 1
    assert measured == []


@pytest.mark.slow
def test_reading_a_library_loads_neither_finite_elements_nor_torch(tmp_path: Path) -> None:
    path = tmp_path / "library.nc"
    acoustic_fem.save(acoustic_fem.solve(geometry.prototype("array-2x6"), [1.0, 10.0], "lumped"), path)
    program = (
        "import sys, acoustic_fem\n"
        f"library = acoustic_fem.load({str(path)!r})\n"
        "assert library.transfer_function.shape == (12, 2, 2)\n"
        "print(sorted({'skfem', 'torch', 'cadquery', 'gmsh', 'scipy.spatial', 'distributed'} & set(sys.modules)))"
    )
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert ended.stdout.strip() == "[]"
