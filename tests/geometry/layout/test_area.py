"""Areas: lines that follow each other over a grid, with microphones where their straight tubes meet beside it."""

import math
from itertools import pairwise

import numpy as np
import pytest

import geometry
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import buildability_notes
from geometry.plan.routing import path_length


def area(counts, columns, closed=False, **values):
    names = [f"M{k}" for k in range(len(counts) + (not closed))]
    ends = [*names, names[0]] if closed else names
    lines = [{"between": list(pair), "points": count} for pair, count in zip(pairwise(ends), counts, strict=True)]
    layout = {"kind": "area", "columns": columns}
    return geometry.prototype("array-2x6").with_values(
        {"microphones": names, "lines": lines, "layout": layout, "microphone.chamber_diameter": 2.5, **values}
    )


def places(layout):
    return np.array([point.position for point in layout.points])


def test_the_large_area_is_a_grid_of_eight_by_eight_that_can_be_built():
    design = geometry.prototype("large-area-64")
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    assert {tuple(place) for place in places(layout)} == {(20.0 * x, 18.0 * y) for x in range(8) for y in range(8)}
    for tube in layout.tubes:
        assert not tube.schematic
        assert path_length(tube.path) == pytest.approx(tube.tube.length, abs=1e-6)
    for microphone in layout.microphones:
        assert len(microphone.ports) == 2
        x, y = microphone.position
        assert x < -10 or x > 150 or y < -10 or y > 136


@pytest.mark.parametrize(
    ("counts", "columns", "closed"),
    [((12, 6), 6, False), ((8, 4, 4), 4, False), ((7,), 3, False), ((4, 4, 4), 6, True), ((4, 2, 6), 3, True)],
)
def test_lines_follow_each_other_and_every_microphone_lies_where_its_tubes_reach(counts, columns, closed):
    design = area(counts, columns, closed)
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    assert len({point.position for point in layout.points}) == sum(counts)
    for one, other in pairwise(layout.points):
        assert math.dist(one.position, other.position) == pytest.approx(18.5)
    for microphone in layout.microphones:
        for port in microphone.ports:
            line = design.lines[port.line]
            ends = [point for point in layout.points if point.line == port.line]
            reach = math.dist(microphone.position, ends[-port.end].position)
            assert reach == pytest.approx(design.microphone_reach_of(line), abs=1e-6)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"layout.pitch": 15.0}, "layout.pitch = 15 mm must not be given for layout.kind = 'area'"),
        ({"lines.1.between": ["M0", "M2"]}, "lines must follow each other for layout.kind = 'area'"),
        ({"lines.0.points": 8, "lines.1.points": 10}, "lines.0.points = 8 puts microphone 'M1' between the points"),
        ({"microphone_tube.length": 4.5}, "microphone_tube.length must be larger: the two tubes that microphone 'M1'"),
        (
            {"tube_kinds": {"a": {"length": 9.0, "inner_diameter": 0.44, "outer_diameter": 0.9, "wire_diameter": 0.08}},
             "lines.0.pattern": {"tubes": ["a"] * 11}},
            "layout.kind = 'area' needs tubes of one length along its rows; they have 9, 12.5 mm",
        ),
    ],
)  # fmt: skip
def test_areas_that_cannot_be_are_refused_by_name(values, message):
    with pytest.raises(geometry.DesignError) as refused:
        area((12, 6), 6).with_values(values)
    assert message in str(refused.value)
    assert "\n" not in str(refused.value)


def test_a_circle_needs_an_even_grid_and_ends_at_its_edge():
    with pytest.raises(geometry.DesignError, match=r"layout\.columns = 3 must divide the 9 points"):
        area((3, 3, 3), 3, closed=True)
    with pytest.raises(geometry.DesignError, match=r"layout\.columns = 5 must divide the 12 points"):
        area((4, 4, 4), 5, closed=True)
    with pytest.raises(geometry.DesignError, match="puts microphone 'M1' between the points of an area"):
        area((20, 20, 24), 8, closed=True)
