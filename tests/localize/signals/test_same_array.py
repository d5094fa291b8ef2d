"""A library of another array than a localizer's is refused by what differs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import acoustic_fem
import geometry
from localize.signals import check_same_array, check_same_design, design_difference, response_of

DESIGN = geometry.prototype("array-2x6").with_values({"lines.0.points": 4, "layout.columns": 4})


@pytest.fixture(scope="module")
def own():
    return response_of(acoustic_fem.solve(DESIGN, np.linspace(1, 100, 4), fidelity="lumped"))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            {"microphones": ("A", "C")},
            r"other\.nc: is of another array .*: its microphones are A, C, must be A, B",
        ),
        ({"microphones": ("B", "A")}, "its microphones are B, A, must be A, B"),
        (
            {"place": np.array([3, 2, 1, 0])},
            "its points are numbered otherwise: point 1 is place 3 of line 0, must",
        ),
        ({"line": np.array([0, 0, 1, 1])}, "point 3 is place 2 of line 1, must be place 2 of line 0"),
    ],
)
def test_other_microphones_and_points_numbered_otherwise_are_refused(own, change, message):
    with pytest.raises(geometry.Refusal, match=message):
        check_same_array(own, replace(own, **change), "other.nc")


def test_another_number_of_points_is_refused(own):
    fewer = response_of(acoustic_fem.solve(DESIGN.with_values({"lines.0.points": 3}), own.frequency, "lumped"))
    with pytest.raises(geometry.Refusal, match="it has 3 points, must have 4"):
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
    with pytest.raises(geometry.Refusal, match=r"other.nc: is of another design .*: tube.length = 20.0, must be 12\.5"):
        check_same_design(own, of(tube__length=20.0), "other.nc")
    states_no_law = replace(own, provenance={"design": geometry.design.write_design(DESIGN)})
    with pytest.raises(geometry.Refusal, match=r"materials\.silicone-shore-a-30\.law = constant, must be spring-pot"):
        check_same_design(own, states_no_law, "older.nc")
