"""Microphones at a side or below, closed rings around a limb, and points wherever they are stated."""

import math
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from refusals import check_messages, refused

import geometry
from geometry import Kind
from geometry.assembly.model import array_model, assembly_of
from geometry.design.design_file import save_design
from geometry.layout import array_size, buildability_notes, cutting_list, lay_out
from geometry.plan.cylinder import wound_length
from geometry.plan.routing import path_length, routed_path, tightest_bend, unit
from geometry.plan.tube_descent import CLEARANCE

#: A pad of 4 x 4 points within 30.1 x 30.1 mm of shells.
PAD = {
    "lines.0.points": 16, "layout.columns": 4, "resonator.cavity_diameter": 5.0, "resonator.wall_thickness": 1.0,
    "membrane.rim_width": 0.9, "tube.length": 2.7, "microphone_tube.length": 15.0,
}  # fmt: skip
OUTWARDS = {"left": (-1, 0), "right": (1, 0), "front": (0, -1), "back": (0, 1)}


def design_of(**values):
    return geometry.prototype("array-2x6").with_values(values)


def places(*points):
    """Changes that put the points of one line at (x, y) or (x, y, angle)."""
    stated = [dict(zip(("x", "y", "angle"), map(float, point), strict=False)) for point in points]
    return {"lines.0.points": len(points), "layout.kind": "places", "layout.places": stated}


@pytest.mark.parametrize("side", OUTWARDS)
def test_both_microphones_lie_at_the_chosen_side_of_a_pad(side):
    design = design_of(**PAD, **{"layout.microphone_side": side})
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    points = np.array([point.position for point in layout.points])
    out = np.array(OUTWARDS[side], float)
    for microphone in layout.microphones:
        assert np.array(microphone.position) @ out > (points @ out).max() + 10
    spread = np.ptp(points, axis=0)
    assert np.allclose(spread, 3 * 7.7)


def test_a_row_has_both_microphones_in_front_of_it():
    design = design_of(**{"lines.0.points": 6, "layout.microphone_side": "front"})
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    assert {point.position[1] for point in layout.points} == {0.0}
    assert all(microphone.position[1] < -10 for microphone in layout.microphones)


def test_microphones_below_a_pad_add_nothing_to_its_outline():
    design = design_of(**PAD, **{"layout.microphone_side": "below"})
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    assert array_size(design)[:2] == pytest.approx((30.1, 30.1))
    lowest = design.resonator.floor_thickness + CLEARANCE
    for tube in (layout.tubes[0], layout.tubes[-1]):
        assert path_length(tube.course) == pytest.approx(tube.tube.length, rel=2e-4)
        assert tightest_bend(tube.course) >= tube.tube.smallest_bend_radius * (1 - 1e-6)
    for microphone in layout.microphones:
        origin = np.array(layout.frame(microphone).origin)
        chamber = design.microphone
        top = chamber.chamber_height / 2 + chamber.sound_hole_length + chamber.package_height
        port = origin[2] + design.resonator.port_axis_height
        assert port + top <= -lowest + 1e-9


@pytest.mark.parametrize("columns", [2, 3, 4, 6, 12])
@pytest.mark.parametrize("cavity", [4.0, 5.0, 7.0])
def test_pads_of_many_shapes_have_room_for_microphones_below(columns, cavity):
    values = {**PAD, "lines.0.points": 12, "layout.columns": columns, "resonator.cavity_diameter": cavity}
    design = design_of(**{**values, "layout.microphone_side": "below", "microphone_tube.length": 14.0})
    assert buildability_notes(design, lay_out(design)) == ()


def test_the_tubes_of_a_pad_with_microphones_below_are_cut_to_their_lengths():
    design = design_of(**PAD, **{"layout.microphone_side": "below"})
    outer, inner = cutting_list(design)
    assert (outer.use, outer.count, inner.count) == ("microphone", 2, 15)
    assert outer.cut_length == pytest.approx(15.0 - 2 * design.printing.port_lip)
    assert outer.spring_length < outer.cut_length  # bent by two quarter circles


def test_parts_and_an_assembly_are_drawn_of_microphones_below():
    values = {**PAD, "lines.0.points": 4, "layout.columns": 2, "layout.microphone_side": "below"}
    design = design_of(**values)
    assert any(name.startswith("shell-corner") for name in geometry.build_parts(design))
    model = array_model(design)
    # The heads of boards are not part of the size.
    housed = replace(model, placed=tuple(part for part in model.placed if part.kind != "board"))
    box = assembly_of(housed).toCompound().BoundingBox()
    assert (box.xlen, box.ylen, box.zlen) == pytest.approx(array_size(design), abs=1e-3)


def test_first_and_last_point_of_a_ring_are_neighbours():
    points, diameter = 10, 160 / math.pi
    base = design_of(**{"layout.kind": "cylinder", "layout.diameter": diameter, "lines.0.points": points})
    resonator = base.resonator
    inner, outer = resonator.cavity_diameter / 2, resonator.outer_diameter / 2
    radius = diameter / 2 + resonator.floor_thickness + resonator.port_axis_height
    length = wound_length(2 * math.pi / points, (inner, inner), (outer, outer), radius)
    design = base.with_values({"layout.columns": points, "tube.length": length, "layout.microphone_side": "front"})
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    origins = np.array([layout.frame(point).origin for point in layout.points])
    apart = np.linalg.norm(origins - np.roll(origins, 1, axis=0), axis=1)
    assert np.allclose(apart, apart[0])
    assert all(microphone.position[1] < -10 for microphone in layout.microphones)


def test_points_lie_where_they_are_stated_and_tubes_keep_their_lengths():
    design = design_of(**places((0, 0), (15, 3), (20, 17)))
    layout = lay_out(design)
    assert [point.position for point in layout.points] == [(0, 0), (15, 3), (20, 17)]
    assert buildability_notes(design, layout) == ()
    for tube in layout.tubes:
        assert path_length(tube.course) == pytest.approx(tube.tube.length, rel=3e-4)


def test_a_line_runs_straight_through_a_point_with_an_angle():
    design = design_of(**places((0, 0, 0), (17, 4, 20), (34, 8, 0)))
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    assert [point.port_angles for point in layout.points] == [(180, 0), (200, 20), (180, 0)]
    for tube in layout.tubes:
        assert path_length(tube.course) == pytest.approx(tube.tube.length, rel=3e-4)
        assert tightest_bend(tube.course) >= tube.tube.smallest_bend_radius


def test_a_routed_tube_has_its_length_and_leaves_both_shells_radially():
    start, end = np.array([0.0, 0.0]), np.array([12.0, 4.0])
    path = routed_path((start, 20.0), (end, 150.0), 2.0, 3.0, 13.0)
    assert path_length(path) == pytest.approx(13.0, abs=1e-9)
    for place, axis, angle in ((path[0], start, 20.0), (path[-1], end, 150.0)):
        assert np.allclose(place, axis + 2.0 * unit(angle))
    with refused(Kind.CONFLICT, "length", 6.0):
        routed_path((start, 20.0), (end, 150.0), 2.0, 3.0, 6.0)


def test_a_file_states_sides_and_places(tmp_path):
    for values in ({**PAD, "layout.microphone_side": "below", "layout.depth": 6.0}, places((0, 0), (15, 3, 45.0))):
        design = design_of(**values)
        save_design(design, tmp_path / "design.toml")
        assert geometry.load_design(tmp_path / "design.toml") == design
        (tmp_path / "design.toml").unlink()


def test_a_microphone_tube_too_short_to_go_below_is_refused():
    design = design_of(**{**PAD, "microphone_tube.length": 5.0, "layout.microphone_side": "below"})
    with refused(Kind.CONFLICT, "microphone_tube.length", 5.0) as found:
        lay_out(design)
    least = float(str(found.value).split("at least ")[1].split(" mm")[0])
    lay_out(design.with_values({"microphone_tube.length": least}))
    with refused(Kind.CONFLICT, "microphone_tube.length"):
        lay_out(design.with_values({"microphone_tube.length": least - 0.2}))


REFUSED = {
    "places of another kind": {"layout.places": [{"x": 0.0, "y": 0.0}]},
    "one place too few": {**places((0, 0), (15, 3)), "lines.0.points": 3},
    "a tube too short": places((0, 0), (25, 0)),
    "a tube too short for its angles": places((0, 0, 0), (14, 10, 0)),
    "shells that touch": places((0, 0), (7, 0)),
    "a pitch of places": {**places((0, 0), (15, 3)), "layout.pitch": 15.0},
    "a depth beside": {"layout.depth": 5.0},
    "a depth without room": {**PAD, "layout.microphone_side": "below", "layout.depth": 3.0},
    "feet on housings": {**PAD, "layout.microphone_side": "below", "shell.feet": 2, "tube.length": 12.0},
    "three rows": {**PAD, "lines.0.points": 12, "layout.microphone_side": "left"},
    "a row and its side": {"lines.0.points": 6, "layout.microphone_side": "left"},
    "a side of a hand": {
        "layout.kind": "hand", "layout.spread": 2.0, "layout.columns": 3, "layout.microphone_side": "left",
    },
    "two rows around": {
        "layout.kind": "cylinder", "layout.diameter": 60.0, "layout.columns": 6, "layout.microphone_side": "front",
    },
    "several lines": {
        "microphones": ["A", "B", "C"], "layout.microphone_side": "left",
        "lines": [{"between": ["A", "B"], "points": 4}, {"between": ["B", "C"], "points": 4}],
    },
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_sides_and_places_that_do_not_go_are_refused(case):
    with refused(Kind.CONFLICT) as found:
        design_of(**REFUSED[case])
    assert found.value.field.split(".")[0] in ("layout", "shell")


def test_messages():
    cases = {case: partial(design_of, **values) for case, values in REFUSED.items()}
    check_messages(Path(__file__).parent / "messages_of_sides.txt", cases)
