"""Areas: lines that follow each other over a grid, with microphones where their straight tubes meet beside it."""

import math
from functools import partial
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from refusals import check_messages, refused

import geometry
from geometry import Kind
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
            assert reach == pytest.approx(design.microphone_reach_of(line, 0), abs=1e-6)


SHORT = {"length": 9.0, "inner_diameter": 0.44, "outer_diameter": 0.9, "wire_diameter": 0.08}
IMPOSSIBLE = [
    ({"layout.pitch": 15.0}, "layout.pitch"),
    ({"lines.1.between": ["M0", "M2"]}, "lines"),
    ({"lines.0.points": 8, "lines.1.points": 10}, "lines.0.points"),
    ({"microphone_tube.length": 4.5}, "microphone_tube.length"),
    ({"tube_kinds": {"a": SHORT}, "lines.0.pattern": {"tubes": ["a"] * 11}}, "layout.kind"),
]
CIRCLES = [((3, 3, 3), 3, "layout.columns"), ((4, 4, 4), 5, "layout.columns"), ((20, 20, 24), 8, "lines.0.points")]


@pytest.mark.parametrize(("values", "field"), IMPOSSIBLE)
def test_areas_that_cannot_be_are_refused_by_name(values, field):
    with refused(Kind.CONFLICT, field, error=geometry.DesignError):
        area((12, 6), 6).with_values(values)


@pytest.mark.parametrize(("points", "columns", "field"), CIRCLES)
def test_a_circle_needs_an_even_grid_and_ends_at_its_edge(points, columns, field):
    with refused(Kind.CONFLICT, field, error=geometry.DesignError):
        area(points, columns, closed=True)


def test_messages():
    made = {str(values): partial(area((12, 6), 6).with_values, values) for values, _ in IMPOSSIBLE}
    closed = {str(points): partial(area, points, columns, closed=True) for points, columns, _ in CIRCLES}
    check_messages(Path(__file__).with_name("messages_of_areas.txt"), {**made, **closed})
