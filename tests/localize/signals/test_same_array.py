"""A library of another array than a localizer's is refused by what differs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
from geometry import Kind
from localize.signals import check_same_array, check_same_design, design_difference, response_of

DESIGN = geometry.prototype("array-2x6").with_values({"lines.0.points": 4, "layout.columns": 4})


@pytest.fixture(scope="module")
def own():
    response = response_of(acoustic_fem.solve(DESIGN, np.linspace(1, 100, 4), fidelity="lumped"))
    return replace(response, closed_form=None)  # that of the design has its microphones


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"microphones": ("A", "C")}, "A, C, must be A, B"),
        ({"microphones": ("B", "A")}, "B, A, must be A, B"),
        ({"place": np.array([3, 2, 1, 0])}, "point 1 is place 3 of line 0"),
        ({"line": np.array([0, 0, 1, 1])}, "point 3 is place 2 of line 1, must be place 2 of line 0"),
    ],
)
def test_other_microphones_and_points_numbered_otherwise_are_refused(own, change, words):
    with refused(Kind.MISMATCH, file="other.nc") as found:
        check_same_array(own, replace(own, **change), "other.nc")
    assert words in str(found.value)


def test_another_number_of_points_is_refused(own):
    fewer = response_of(acoustic_fem.solve(DESIGN.with_values({"lines.0.points": 3}), own.frequency, "lumped"))
    with refused(Kind.MISMATCH, file="other.nc"):
        check_same_array(own, fewer, "other.nc")


def test_another_design_is_refused_by_its_field_and_another_air_is_not(own):
    def of(**values):
        changed = {name.replace("__", "."): value for name, value in values.items()}
        return replace(
            own, provenance={"design": geometry.design.write_design(DESIGN.with_values(changed).completed())}
        )

    check_same_design(own, of(name="another", air__temperature=30.0, description="of another day"), "other.nc")
    check_same_design(own, replace(own, provenance={}), "other.nc")
    assert design_difference(own, own) is None
    with refused(Kind.MISMATCH, file="other.nc") as found:
        check_same_design(own, of(tube__length=20.0), "other.nc")
    assert "tube.length = 20.0, must be 12.5" in str(found.value)
    text = geometry.design.write_design(DESIGN.completed())
    older = "".join(line for line in text.splitlines(keepends=True) if not line.startswith("bore ="))
    assert older != text
    with refused(Kind.MISMATCH, "tube.bore"):  # an earlier version wrote it: nobody can say whether the two are one
        check_same_design(own, replace(own, provenance={"design": older}), "older.nc")
