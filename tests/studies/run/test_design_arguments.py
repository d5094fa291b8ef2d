"""Calls that take a design take the name of a prototype and the path of a file too."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from refusals import refused

import geometry
from acoustic_fem import membrane
from geometry import Kind
from studies.run.quality import design_quality
from studies.scatter.effects import scattered_accuracy

GRID = np.arange(1.0, 101.0, 3.0)
CALLS: dict[str, Callable[[Any], object]] = {
    "lay_out": lambda design: geometry.layout.lay_out(design).microphones,
    "place_housings": lambda design: geometry.layout.place_housings(design).points,
    "point_places": geometry.layout.point_places,
    "cutting_list": geometry.layout.cutting_list,
    "array_size": geometry.layout.array_size,
    "refuse_overlaps": geometry.layout.refuse_overlaps,
    "fix_for": geometry.layout.fix_for,
    "mold_counts": geometry.molds.mold_counts,
    "mold_kinds": geometry.molds.mold_kinds,
    "plan_mold": geometry.molds.plan_mold,
    "design_compliance": lambda design: membrane.design_compliance(design, GRID).tolist(),
    "design_shape": membrane.design_shape,
    "design_rubber": membrane.design_rubber,
    "design_quality": lambda design: str(design_quality(design)),
    "scattered_accuracy": lambda design: scattered_accuracy(design, GRID, sensors=3).tolist(),
}


@pytest.mark.parametrize("name", CALLS)
@pytest.mark.slow
def test_a_design_is_given_by_name_by_path_or_as_itself(name: str, tmp_path: Path) -> None:
    design = geometry.prototype("line-2")
    geometry.save_design(design, tmp_path / "mine.toml")
    expected = CALLS[name](design)
    assert CALLS[name]("line-2") == expected
    assert CALLS[name](tmp_path / "mine.toml") == expected
    with refused(Kind.WRONG_TYPE, "design", 3):
        CALLS[name](3)
