"""Kinds of points and tubes, and the patterns in which lines have them."""

from functools import partial
from pathlib import Path

import numpy as np
import pytest
from refusals import check_messages, refused

import geometry
from geometry import Kind
from geometry.design.design_file import prototype_names, read_design, write_design
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import overlaps
from geometry.layout.size import array_size
from geometry.layout.straight_rows import is_wide_apart

STOCK = Path(__file__).parents[3] / "docs" / "examples" / "graded-line-36.toml"
TUBE = {"length": 14.0, "inner_diameter": 0.44, "wire_diameter": 0.08, "outer_diameter": 0.9}
KINDS = {
    "point_kinds": {"plain": {}, "deep": {"cavity_height": 4.0, "membrane_thickness": 0.8}},
    "tube_kinds": {"short": {**TUBE, "length": 8.0}, "long": TUBE},
}


def graded(count=4, mirrored=True, kind="serpentine", **pattern):
    """A line with cavities of two heights; the pattern is that of four points, mirrored, where none is given."""
    base = geometry.prototype("array-2x6")
    pattern = pattern or {"points": ["plain", "deep"], "tubes": ["long", "short"]}
    line = {"between": ["A", "B"], "points": count, "pattern": {**pattern, "mirrored": mirrored}}
    return base.with_values({**KINDS, "lines": [line], "layout": {"kind": kind}})


@pytest.mark.parametrize("name", sorted({*prototype_names()} - {"large-area-64"}))
def test_a_file_without_kinds_states_none_when_it_is_written(name):
    design = geometry.prototype(name)
    text = write_design(design)
    assert "kinds" not in text
    assert "pattern" not in text
    assert (design.kinds, design.of_kind(""), set(design.kind_of_point)) == (("",), design, {0})


def test_a_design_with_kinds_is_the_same_after_it_is_written_and_read():
    design = graded()
    assert read_design(write_design(design)) == design


@pytest.mark.parametrize(
    ("points", "pattern", "heights", "lengths"),
    [
        (4, {"points": ["plain", "deep"], "tubes": ["long", "short"]}, [2.5, 4, 4, 2.5], [14, 8, 14]),
        (5, {"points": ["plain", "plain", "deep"], "tubes": ["long", "short"]},
         [2.5, 2.5, 4, 2.5, 2.5], [14, 8, 8, 14]),
        (2, {"points": ["deep"], "tubes": ["short"]}, [4, 4], [8]),
        (1, {"points": ["deep"]}, [4], []),
    ],
)  # fmt: skip
def test_a_mirrored_pattern_ends_in_the_middle_of_the_line(points, pattern, heights, lengths):
    design = graded(points, True, **pattern)
    line = design.lines[0]
    assert [design.resonator_at(line, place).cavity_height for place in range(points)] == heights
    assert [tube.length for tube in design.segments_of(line)] == lengths
    assert [tube.length for tube in design.tubes_of(line)] == [12.5, *lengths, 12.5]
    whole = graded(
        points,
        False,
        points=[design.kind_at(line, place) for place in range(points)],
        tubes=[design.tube_kind_at(line, segment) for segment in range(1, points)],
    ) if lengths else None  # fmt: skip
    assert whole is None or whole.tubes_of(whole.lines[0]) == design.tubes_of(line)


def test_a_kind_keeps_what_it_does_not_state_and_its_ports_lie_as_high_as_those_of_all():
    design = graded()
    plain, deep = (design.of_kind(kind) for kind in design.kinds)
    assert plain.resonator == design.resonator
    assert plain.membrane == design.membrane
    assert (deep.resonator.cavity_height, deep.membrane.thickness) == (4.0, 0.8)
    assert deep.resonator.port_axis_height == design.resonator.port_axis_height == 1.25
    assert deep.membrane.rim_width == design.membrane.rim_width
    changed = design.with_values({"membrane.rim_width": 1.2, "point_kinds.deep.cavity_height": 3.5})
    assert changed.of_kind("deep").membrane.rim_width == 1.2
    assert changed.of_kind("deep").resonator.cavity_height == 3.5
    thinner = design.with_values({"tube_kinds.short.spring_outer_diameter": 0.5})
    assert thinner.tube_kinds["short"].inner_diameter == pytest.approx(0.34)


NOT_FITTING = [
    ({"lines.0.pattern.points": ["plain"]}, Kind.CONFLICT, "lines.0.pattern.points"),
    ({"lines.0.pattern.tubes": ["long"] * 3}, Kind.CONFLICT, "lines.0.pattern.tubes"),
    ({"lines.0.pattern.mirrored": False}, Kind.CONFLICT, "lines.0.pattern.points"),
    ({"lines.0.pattern.points": ["plain", "dep"]}, Kind.UNKNOWN, "lines.0.pattern.points.1"),
    ({"lines.0.pattern.tubes": ["deep", "long"]}, Kind.UNKNOWN, "lines.0.pattern.tubes.0"),
    ({"lines.0.pattern.mirrored": 1}, Kind.WRONG_TYPE, "lines.0.pattern.mirrored"),
    ({"tube_kinds": {}}, Kind.UNKNOWN, "lines.0.pattern.tubes.0"),
    ({"lines.0.pattern": {}}, Kind.MISSING, "lines.0.pattern"),
    ({"lines.0.tube": TUBE}, Kind.CONFLICT, "lines.0.tube"),
    ({"point_kinds.a-b": {}}, Kind.OUT_OF_RANGE, "point_kinds"),
    ({"layout.kind": "hand"}, Kind.CONFLICT, "lines.0.pattern.tubes"),
    ({"layout.kind": "cylinder", "layout.diameter": 90.0}, Kind.CONFLICT, "lines.0.pattern.tubes"),
    ({"layout.pitch": 16.0}, Kind.CONFLICT, "layout.pitch"),
    ({"point_kinds.deep.membrane_thickness": 9.0}, Kind.CONFLICT, "point_kinds.deep.membrane_thickness"),
    ({"point_kinds.deep.cavity_height": 1.3}, Kind.CONFLICT, "resonator.port_height"),
    ({"tube_kinds.short.inner_diameter": 0.95}, Kind.CONFLICT, "tube_kinds.short.inner_diameter"),
    ({"point_kinds.deep.rim_width": 1.0}, Kind.UNKNOWN, "point_kinds.deep.rim_width"),
]


@pytest.mark.parametrize(("values", "kind", "field"), NOT_FITTING)
def test_what_does_not_fit_is_refused_by_name(values, kind, field):
    with refused(kind, field, file="array-2x6", error=geometry.DesignError):
        graded().with_values(values)


def test_messages():
    snapshot = Path(__file__).with_name("messages_of_kinds.txt")
    check_messages(snapshot, {str(values): partial(graded().with_values, values) for values, *_ in NOT_FITTING})


@pytest.mark.parametrize("layout", ["hand", "cylinder"])
def test_kinds_of_points_alone_suit_every_layout(layout):
    name = {"hand": "glove", "cylinder": "array-2x6"}[layout]
    base = geometry.prototype(name)
    points = base.lines[0].points
    own = {"layout": {"kind": "cylinder", "diameter": 90.0, "columns": 6}} if layout == "cylinder" else {}
    design = base.with_values({
        **own,
        "point_kinds": {"low": {}, "high": {"cavity_height": base.resonator.cavity_height + 1}},
        "lines.0.pattern": {"points": ["high", *["low"] * (points - 1)]},
    })  # fmt: skip
    plain = base.with_values(own)
    assert [p.position for p in lay_out(design).points] == [p.position for p in lay_out(plain).points]


def test_tubes_of_different_lengths_lie_straight_one_after_the_other():
    layout = lay_out(graded())
    assert [point.position for point in layout.points] == [(0, 0), (20, 0), (34, 0), (54, 0)]
    assert all(tube.path[:, 2] == pytest.approx(1.25) for tube in layout.tubes)
    for tube in layout.tubes:
        assert np.linalg.norm(tube.path[-1] - tube.path[0]) == pytest.approx(tube.tube.length)


def test_each_row_of_a_graded_line_begins_above_the_end_of_the_one_before():
    design = graded(5, False, tubes=["short", "long", "long", "short"]).with_values({"layout.columns": 2})
    assert [p.position for p in lay_out(design).points] == [(0, 0), (14, 0), (14, 20), (-6, 20), (-6, 34)]
    assert not is_wide_apart(design)
    assert overlaps(design, lay_out(design)) == ()


def test_tubes_of_different_lengths_bow_to_one_pitch():
    layout = lay_out(graded().with_values({"layout.pitch": 13.5}))
    assert [point.position for point in layout.points] == [(0, 0), (13.5, 0), (27, 0), (40.5, 0)]
    lengths = [np.linalg.norm(np.diff(tube.path, axis=0), axis=1).sum() for tube in layout.tubes]
    assert lengths == pytest.approx([tube.tube.length for tube in layout.tubes], rel=1e-3)


def test_the_sides_of_a_ring_are_as_long_as_their_graded_lines():
    base = geometry.prototype("line-3")
    lines = [{**line.model_dump(), "points": 4} for line in base.lines]
    lines[0]["pattern"] = {"tubes": ["long", "short"], "mirrored": True}
    kinds = {"long": {**base.tube.model_dump(), "length": 14.0}, "short": {**base.tube.model_dump(), "length": 9.0}}
    design = base.with_values({"lines": lines, "tube_kinds": kinds, "layout": {"kind": "ring"}})
    layout = lay_out(design)
    places = np.array([point.position for point in layout.points if point.line == 0])
    diameter = design.resonator.cavity_diameter
    assert np.linalg.norm(np.diff(places, axis=0), axis=1) == pytest.approx(
        [diameter + length for length in (14, 9, 14)]
    )
    for tube in layout.tubes:
        if tube.line == 0 and 0 < tube.segment < 4:
            assert np.linalg.norm(tube.path[-1] - tube.path[0]) == pytest.approx(tube.tube.length)


def test_an_array_is_as_high_as_its_highest_kind():
    design = graded()
    higher = design.with_values({"point_kinds.deep.cavity_height": 5.0, "point_kinds.deep.membrane_thickness": 1.0})
    assert array_size(higher)[2] - array_size(design)[2] == pytest.approx(1.2)
    assert array_size(higher)[:2] == array_size(design)[:2]


def test_the_example_is_the_graded_line_of_stock_parts():
    design = geometry.load_design(STOCK)
    line = design.lines[0]
    tubes = design.tubes_of(line)[:19]
    heights = [design.resonator_at(line, place).cavity_height for place in range(18)]
    thicknesses = [design.membrane_at(line, place).thickness for place in range(18)]
    assert [tube.inner_diameter for tube in tubes] == [0.5, 0.85, *[1.0] * 14, *[0.85] * 3]
    assert [tube.length for tube in tubes] == [7, 22, 22, 12, 12, *[7] * 6, 12, 12, 22, *[29] * 5]
    assert heights == [1.6] * 3 + [5.9] * 8 + [1.6] * 7
    assert thicknesses == [2.0] * 4 + [0.65] * 7 + [2.0] * 7
    assert design.tubes_of(line)[::-1] == design.tubes_of(line)
    assert overlaps(design, lay_out(design)) == ()
