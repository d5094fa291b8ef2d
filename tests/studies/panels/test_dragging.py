"""Parts that are dragged lie where they were dragged, or as near as the design allows; sizes are as they were typed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from geometry import Refusal, load_design, prototype
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array
from geometry.layout.arrangement import lay_out, place_housings, point_axes
from geometry.layout.size import array_size
from studies.panels.dragged_places import parts_in_space, row_of
from studies.panels.dragging import dragged, resized, size_of

EXAMPLES = Path(__file__).parents[3] / "docs" / "examples"
ARRAY, FINGERTIP, GLOVE = map(prototype, ("array-2x6", "fingertip-4x6", "glove"))
NOWHERE = np.zeros(3)


def by(x: float, y: float, z: float = 0.0) -> Array:
    return np.array([x, y, z])


def with_places(design: ArrayDesign, **values: Any) -> ArrayDesign:
    """The same places, each stated."""
    places = [{"x": float(x), "y": float(y)} for x, y in point_axes(design)]
    return design.with_values({"layout": {"kind": "places", "places": places}, "tube.length": 14.0, **values})


PLACED = with_places(ARRAY)


def microphone(design: ArrayDesign, name: str) -> Array:
    return np.array(next(each.position for each in place_housings(design).microphones if each.name == name))


@pytest.mark.parametrize(
    ("design", "number", "axis", "way", "field"),
    [
        (ARRAY, 6, 0, 5.0, "tube.length"),
        (ARRAY, 7, 1, 3.0, "tube.length"),
        (FINGERTIP, 6, 0, 2.0, "layout.pitch"),
        (prototype("large-area-64"), 3, 1, 3.0, "tube_kinds.up.length"),
        (load_design(EXAMPLES / "wristband-10.toml"), 4, 1, 0.5, "tube.length"),
    ],
)
def test_a_point_of_a_grid_is_at_the_pointer(
    design: ArrayDesign, number: int, axis: int, way: float, field: str
) -> None:
    aim = by(way, 0.2) if axis == 0 else by(0.2, way)
    found = dragged(design, f"point {number}", aim, NOWHERE)
    assert [*found.values] == [field]
    assert found.refused == ""
    moved = point_axes(found.design)[number - 1] - point_axes(design)[number - 1]
    assert moved[axis] == pytest.approx(way, abs=0.5)  # lengths have three digits


def test_the_first_point_is_dragged_from_the_farthest_one() -> None:
    found = dragged(ARRAY, "point 1", by(-5, 0), NOWHERE)
    assert (found.anchor, found.values) == (6, {"tube.length": 13.5})


def test_points_of_a_hand_follow_the_palm_and_the_spread() -> None:
    assert [*dragged(GLOVE, "point 1", by(0, 3), NOWHERE).values] == ["layout.palm"]
    assert [*dragged(GLOVE, "point 9", by(0.5, 0), NOWHERE).values] == ["layout.spread"]


def test_a_ring_grows_with_a_point_that_is_pulled_outwards() -> None:
    ring = prototype("line-3")
    start = point_axes(ring)[17]
    out = start / np.linalg.norm(start)
    found = dragged(ring, "point 18", by(*(5 * out)), NOWHERE)
    moved = point_axes(found.design)[17] - start
    assert float(moved @ out) == pytest.approx(5, rel=0.1)


@pytest.mark.parametrize(
    ("design", "way", "nearest", "reason"),
    [
        (FINGERTIP, 200.0, {"layout.pitch": 5.59}, "is more than its tubes reach"),
        (FINGERTIP, -10.0, {"layout.pitch": 2.41}, "where shells touch"),
        (ARRAY, -500.0, {"tube.length": 4.01}, "the two walls it passes through"),
    ],
)
def test_a_point_that_goes_too_far_stops_at_the_last_place_that_is_allowed(
    design: ArrayDesign, way: float, nearest: dict[str, float], reason: str
) -> None:
    found = dragged(design, "point 6", by(way, 0), NOWHERE)
    assert found.values == nearest
    assert reason in found.refused
    assert found.design == design.with_values(nearest)


def test_a_microphone_takes_its_tube_along_or_changes_its_side() -> None:
    longer = dragged(ARRAY, "microphone A", by(-4, 0), NOWHERE)
    assert longer.values == {"microphone_tube.length": 16.5}
    np.testing.assert_allclose(microphone(longer.design, "A") - microphone(ARRAY, "A"), [-4, 0], atol=0.05)
    for way, side in ((by(30, 0), "below"), (by(30, 60), "back"), (by(200, 0), "right")):
        found = dragged(ARRAY, "microphone A", way, NOWHERE)
        assert found.design.layout.microphone_side == side
        again = dragged(found.design, "microphone A", by(-200, 0), NOWHERE)
        assert again.design.layout.microphone_side == "ends"


def test_a_side_that_a_design_cannot_have_is_refused_with_the_reason() -> None:
    odd = ARRAY.with_values({"lines.0.points": 18})  # three rows
    found = dragged(odd, "microphone A", by(200, 0), NOWHERE)
    assert found.design == odd
    assert "needs an even number of full rows" in found.refused


def test_the_end_of_a_tube_is_pulled_and_the_arc_of_a_bowed_one() -> None:
    (start,) = (tube for tube in lay_out(ARRAY).tubes if (tube.line, tube.segment) == (0, 1))
    found = dragged(ARRAY, "tube 2 of line 1", by(3, 0), start.course[-1])
    assert (found.values, found.anchor) == ({"tube.length": 15.5}, 0)
    backwards = dragged(ARRAY, "tube 2 of line 1", by(-3, 0), start.course[0])
    assert (backwards.values, backwards.anchor) == ({"tube.length": 15.5}, 1)
    assert dragged(ARRAY, "tube 1 of line 1", by(-3, 0), NOWHERE).values == {"microphone_tube.length": 15.5}

    def middle(design: ArrayDesign) -> Array:
        (own,) = (tube for tube in lay_out(design).tubes if (tube.line, tube.segment) == (0, 2))
        return np.asarray(own.course[len(own.course) // 2])

    bowed = dragged(FINGERTIP, "tube 3 of line 1", by(0, 0.5), NOWHERE)
    assert middle(bowed.design)[1] - middle(FINGERTIP)[1] == pytest.approx(0.5, abs=0.02)


def test_places_are_moved_alone_or_as_a_row() -> None:
    alone = dragged(PLACED, "point 3", by(0, 1.04), NOWHERE)
    assert alone.values == {"layout.places.2.x": 37.0, "layout.places.2.y": 1.0}
    row = dragged(PLACED, "point 3", by(0.5, 1), NOWHERE, whole_row=True)
    moved = point_axes(row.design) - point_axes(PLACED)
    np.testing.assert_allclose(moved, [[0.5, 1]] * 6 + [[0, 0]] * 6, atol=1e-9)
    assert [row_of(PLACED, index) for index in (0, 5, 6, 11)] == [range(6), range(6), range(6, 12), range(6, 12)]


@pytest.mark.parametrize(
    ("way", "whole_row", "reason"),
    [
        ((0.0, 30.0), False, "where the tube is straight"),
        ((15.0, 0.0), False, "point 3 would be 3.5 mm from point 4; shells touch at 10 mm"),
        ((0.0, 15.0), True, "shells touch at 10 mm"),
    ],
)
def test_a_place_that_is_not_allowed_is_left_for_the_nearest_that_is(
    way: tuple[float, float], whole_row: bool, reason: str
) -> None:
    found = dragged(PLACED, "point 3", by(*way), NOWHERE, whole_row)
    assert reason in found.refused
    moved = point_axes(found.design)[2] - point_axes(PLACED)[2]
    assert 0 < float(moved @ way) < float(np.dot(way, way))
    apart = np.linalg.norm(point_axes(found.design)[:, None] - point_axes(found.design), axis=2)
    assert apart[~np.eye(12, dtype=bool)].min() >= PLACED.resonator.outer_diameter
    assert parts_in_space(found.design, NOWHERE)["points"][2][:2] == pytest.approx(point_axes(found.design)[2])


@pytest.mark.parametrize(
    ("design", "size", "value"),
    [
        (ARRAY, "x", 150.0),
        (ARRAY, "y", 40.0),
        (ARRAY, "z", 6.0),
        (ARRAY, "pitch", 20.0),
        (FINGERTIP, "x", 45.0),
        (FINGERTIP, "pitch", 4.2),
        (prototype("large-area-64"), "x", 160.0),
    ],
)
def test_a_size_is_as_it_was_typed(design: ArrayDesign, size: str, value: float) -> None:
    found = resized(design, size, value)
    assert (len(found.values), found.refused) == (1, "")
    assert size_of(found.design, size) == pytest.approx(value, abs=1e-4)
    if size != "pitch":
        assert array_size(found.design)["xyz".index(size)] == pytest.approx(value, abs=1e-4)


def test_a_size_that_is_not_allowed_has_the_nearest_one_beside_it() -> None:
    found = resized(ARRAY, "x", 20.0)
    assert "the two walls it passes through" in found.refused
    assert size_of(found.design, "x") == pytest.approx(74.85, abs=0.01)


def test_parts_in_space_are_those_of_the_layout_and_follow_a_shift() -> None:
    shift = by(1, 2, 3)
    found = parts_in_space(ARRAY, shift)
    layout = lay_out(ARRAY)
    np.testing.assert_allclose([each[:2] for each in found["points"]], point_axes(ARRAY) + shift[:2], atol=1e-3)
    assert {tuple(each[3:]) for each in found["points"]} == {(0.0, 0.0, 1.0)}
    assert len(found["tubes"]) == len(layout.tubes)
    np.testing.assert_allclose(found["tubes"][3][-1], layout.tubes[3].course[-1] + shift, atol=1e-3)
    assert found["microphones"]["B"][:2] == pytest.approx(microphone(ARRAY, "B") + shift[:2], abs=1e-3)


def test_an_array_on_a_body_is_not_dragged() -> None:
    body = load_design(EXAMPLES / "robot" / "fingertip.toml")
    with pytest.raises(Refusal, match="stands where it was fitted to the body"):
        dragged(body, "point 3", by(1, 0), NOWHERE)
    with pytest.raises(Refusal, match="follows from the body"):
        resized(body, "x", 30.0)
