"""Words on how to hold an array while it is glued: heights and distances read again from the solids and the table."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

import geometry
from geometry.assembly.model import ArrayModel, array_model
from studies.kit.holding import holding_words, shim_height


@pytest.fixture(scope="module")
def model() -> ArrayModel:
    return array_model("array-2x6")


def test_the_shim_is_the_height_of_the_housings_above_the_shells(model: ArrayModel) -> None:
    # The axis of the chamber is half its height above its floor, that of a port of a shell as high as the design says;
    # both floors are 1 mm thick, so the housings stand higher by the difference.
    design = model.design
    higher = design.resonator.port_axis_height - design.microphone.chamber_height / 2
    assert shim_height(model) == pytest.approx(higher, abs=0.01)
    assert f"{higher:.2f} mm under the housings" in holding_words(model)


def test_the_distance_of_neighbours_is_that_of_the_layout(model: ArrayModel) -> None:
    assert "18.5 mm apart" in holding_words(model)


def test_distances_that_differ_are_told_from_the_shortest_to_the_longest() -> None:
    design = geometry.prototype("glove")
    model = array_model(design)
    places = [point.position for point in model.layout.points]
    apart = [math.dist(one, other) for one, other in pairwise(places[:6])]
    assert max(apart) - min(apart) > 0.1
    assert f"{min(apart):.4g} to {max(apart):.4g} mm apart" in holding_words(model)


def test_a_base_plate_holds_the_array_itself(model: ArrayModel) -> None:
    design = geometry.prototype("array-2x6").with_values({"base.kind": "plate"})
    assert holding_words(array_model(design)) == ""
