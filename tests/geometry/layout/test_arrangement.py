"""Positions of parts: lengths of tubes, order of points, overlaps by name."""

import math
import subprocess
import sys
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st
from refusals import check_messages, refused
from rings import rectangle

import geometry
from geometry import Kind
from geometry.air.cells import cell_catalogue
from geometry.layout.arrangement import lay_out, place_housings
from geometry.layout.overlaps import buildability_notes
from geometry.plan.cylinder import wound_length, wound_radius, wound_turn
from geometry.plan.ring import corner_angles, corners
from geometry.plan.routing import bow_angle, bow_radius, bowed_path, path_length, tightest_bend


def design_of(**values):
    """The 2 x 6 array with the numbers that the tests count with, and changes."""
    counted = {"resonator.cavity_diameter": 6.0, "resonator.wall_thickness": 2.0, "tube.length": 12.5}
    return geometry.prototype("array-2x6").with_values({**counted, "microphone_tube.length": 12.5, **values})


@given(cavity=st.floats(0.5, 5), wall=st.floats(0.2, 3), gap=st.floats(0.0, 10), angle=st.floats(1, 120))
def test_a_bowed_tube_has_exactly_its_length_and_leaves_both_shells_radially(cavity, wall, gap, angle):
    outer = cavity + wall
    distance = 2 * outer + gap
    turn = math.radians(angle)
    length = 2 * wall + (distance - 2 * outer * math.cos(turn)) * turn / math.sin(turn)
    found = bow_angle(length, distance, cavity, outer)
    assert found == pytest.approx(angle, abs=1e-6)
    start, end = np.array([1.0, 2.0]), np.array([1.0, 2.0 + distance])
    path = bowed_path(start, end, found, -1, cavity, outer)
    # A polyline of 64 chords falls short of its arc by (2 t)^2 / (24 * 64^2).
    assert path_length(path) == pytest.approx(length, rel=2e-4)
    for centre, first, second in ((start, path[0], path[1]), (end, path[-1], path[-2])):
        assert np.linalg.norm(first - centre) == pytest.approx(cavity)
        assert np.linalg.norm(second - centre) == pytest.approx(outer)
        assert abs(np.linalg.det([first - centre, second - centre])) < 1e-9 * distance**2
    centre_of_arc = path[33] - bow_radius(found, distance, outer) * np.array([1.0, 0.0])
    radii = np.linalg.norm(path[1:-1] - centre_of_arc, axis=1)
    assert np.allclose(radii, bow_radius(found, distance, outer))


def test_a_tube_too_short_for_the_way_is_refused():
    with refused(Kind.CONFLICT, "length", 3.0):
        bow_angle(3.0, 10.0, 3.0, 4.0)


def test_points_run_forth_and_back_at_the_pitch_of_straight_tubes():
    layout = lay_out(design_of())
    assert [p.number for p in layout.points] == list(range(1, 13))
    expected = [(18.5 * k, 0.0) for k in range(6)] + [(18.5 * k, 18.5) for k in range(5, -1, -1)]
    assert [p.position for p in layout.points] == expected
    assert [p.port_angles for p in layout.points][4:8] == [(180.0, 0.0), (180.0, 90.0), (270.0, 180.0), (0.0, 180.0)]


BUILDABLE = [name for name in geometry.prototype_names() if name != "line-4"]


@pytest.mark.parametrize("name", BUILDABLE)
def test_a_prototype_is_built_as_drawn(name):
    design = geometry.prototype(name)
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    assert len(layout.tubes) == design.point_count + len(design.lines)
    for tube in layout.tubes:
        assert not tube.schematic
        assert path_length(tube.path) == pytest.approx(tube.tube.length, rel=2e-4)


@pytest.mark.parametrize("name", ["fingertip-3x4", "fingertip-4x6"])
def test_fingertip_points_are_4_mm_apart(name):
    positions = np.array([p.position for p in lay_out(geometry.prototype(name)).points])
    assert np.allclose(np.linalg.norm(np.diff(positions, axis=0), axis=1), 4.0)


def test_four_fully_connected_microphones_are_said_not_to_be_buildable_as_drawn():
    design = geometry.prototype("line-4")
    first, *others = buildability_notes(design, lay_out(design))
    assert first == "simulated study: not buildable as drawn; 12 microphone tubes are drawn schematically"
    assert len(others) == 4
    for note in others:
        assert note.startswith("microphone ")
        assert "drawn schematically" in note
        assert "is 12 mm, drawn" in note


@pytest.mark.parametrize("name", geometry.prototype_names())
def test_every_tube_starts_and_ends_on_cavity_walls_in_the_direction_of_its_ports(name):
    design = geometry.prototype(name)
    layout = lay_out(design)
    points = {(p.line, p.place): p for p in layout.points}
    microphones = {(port.line, port.end): (m, port) for m in layout.microphones for port in m.ports}
    cavity, chamber = design.resonator.cavity_diameter / 2, design.microphone.chamber_diameter / 2

    def on_wall(centre, angle, radius):
        turn = math.radians(angle)
        return (*np.add(centre, radius * np.array([math.cos(turn), math.sin(turn)])), design.resonator.port_axis_height)

    for tube in layout.tubes:
        last = design.lines[tube.line].points
        if tube.segment == 0:
            microphone, port = microphones[tube.line, 0]
            start = on_wall(microphone.position, port.angle, chamber)
        else:
            point = points[tube.line, tube.segment - 1]
            start = on_wall(point.position, point.port_angles[1], cavity)
        if tube.segment == last:
            microphone, port = microphones[tube.line, 1]
            end = on_wall(microphone.position, port.angle, chamber)
        else:
            point = points[tube.line, tube.segment]
            end = on_wall(point.position, point.port_angles[0], cavity)
        assert np.allclose(tube.path[0], start, atol=1e-5)
        assert np.allclose(tube.path[-1], end, atol=1e-5)


def test_lines_that_meet_enter_a_microphone_at_equal_angles():
    for microphone in lay_out(geometry.prototype("line-4")).microphones:
        angles = sorted(port.angle for port in microphone.ports)
        assert np.diff([*angles, angles[0] + 360]) == pytest.approx([120, 120, 120], abs=1e-5)
        assert [(p.line, p.end) for p in microphone.ports] == sorted((p.line, p.end) for p in microphone.ports)


def test_array_2x6_needs_three_air_cells():
    design = geometry.prototype("array-2x6")
    assert len(cell_catalogue(design, lay_out(design)).distinct) == 3


@pytest.mark.parametrize("name", geometry.prototype_names())
def test_housings_lie_without_the_tubes_as_with_them(name):
    design = geometry.prototype(name)
    housings, layout = place_housings(design), lay_out(design)
    assert (housings.points, housings.microphones) == (layout.points, layout.microphones)
    assert housings.frame(housings.points[-1]) == layout.frame(layout.points[-1])


def ring(points, **values):
    names = ["A", "B", "C"]
    lines = [{"between": [names[k], names[(k + 1) % 3]], "points": count} for k, count in enumerate(points)]
    return design_of(microphones=names, lines=lines, layout={"kind": "ring"}, **values)


def test_a_ring_of_equal_lines_is_built_as_drawn():
    design = ring([5, 5, 5])
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    assert all(path_length(t.path) == pytest.approx(t.tube.length) for t in layout.tubes)
    corners = np.array([m.position for m in layout.microphones])
    assert np.linalg.norm(corners, axis=1) == pytest.approx([np.linalg.norm(corners[0])] * 3)


def sides_of(layout):
    """Distances from each microphone to the next around the ring."""
    corners = np.array([m.position for m in layout.microphones])
    return np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1)


# Between microphones: pitches of 18.5 mm, and at both ends 3 + 12.5 + 1.95 mm.
@pytest.mark.parametrize("points", [(5, 5, 5), (5, 3, 5), (5, 6, 4), (8, 5, 6), (5, 5, 8), (1, 1, 1)])
def test_three_lines_make_the_triangle_of_their_lengths(points):
    design = ring(points, **{"microphone.chamber_diameter": 3.9})
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    assert sides_of(layout) == pytest.approx([18.5 * (count - 1) + 34.9 for count in points], abs=1e-6)
    assert all(path_length(t.path) == pytest.approx(t.tube.length, abs=1e-6) for t in layout.tubes)
    a, b, c = sides_of(layout)
    (port, other) = (p.angle for p in layout.microphones[1].ports)
    cosine = (a**2 + b**2 - c**2) / (2 * a * b)
    assert math.cos(math.radians(other - port)) == pytest.approx(cosine, abs=1e-7)


def test_four_lines_make_a_rectangle_with_square_corners():
    layout = lay_out(rectangle())
    # 15 pitches of 18 or 20 mm, and at both ends 3 + 12 + 0.9 mm
    assert sides_of(layout) == pytest.approx([301.8, 331.8, 301.8, 331.8], abs=1e-6)
    for microphone in layout.microphones:
        first, second = (port.angle for port in microphone.ports)
        assert (first - second) % 180 == pytest.approx(90, abs=1e-6)


def test_equal_lines_make_a_regular_polygon_and_a_line_left_out_leaves_its_side_open():
    names = list("ABCDE")
    lines = [{"between": [names[k], names[(k + 1) % 5]], "points": 3} for k in range(5)]
    for count in (5, 4):
        design = design_of(microphones=names, lines=lines[:count], layout={"kind": "ring"})
        layout = lay_out(design)
        assert buildability_notes(design, layout) == ()
        assert sides_of(layout) == pytest.approx([69.9] * 5, abs=1e-6)
        turned = [(m.ports[0].angle - m.ports[1].angle) % 360 for m in layout.microphones if len(m.ports) == 2]
        assert len(turned) == (5 if count == 5 else 3)
        assert all(min(turn, 360 - turn) == pytest.approx(108, abs=1e-6) for turn in turned)


def test_tubes_of_a_ring_bow_outwards_whichever_way_a_line_runs():
    lines = [{"between": pair, "points": 4} for pair in (["A", "B"], ["A", "C"], ["C", "B"])]
    design = design_of(microphones=["A", "B", "C"], lines=lines, layout={"kind": "ring", "pitch": 15.0})
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    for tube in layout.tubes:
        middle, ends = tube.path[len(tube.path) // 2, :2], tube.path[[0, -1], :2].mean(axis=0)
        if len(tube.path) > 2:
            assert np.linalg.norm(middle) > np.linalg.norm(ends) + 1
        assert path_length(tube.path) == pytest.approx(tube.tube.length, rel=2e-4)


@given(st.lists(st.floats(1, 100), min_size=3, max_size=9))
def test_every_polygon_that_can_close_closes_with_its_corners_on_one_circle(sides):
    longest = max(sides)
    assume(longest < 0.999 * (sum(sides) - longest))
    points = corners(sides)
    assert np.linalg.norm(np.roll(points, -1, axis=0) - points, axis=1) == pytest.approx(sides, rel=1e-9)
    assert np.sum(180 - corner_angles(points)) == pytest.approx(360)  # convex, once around
    # |p - c|^2 is the same for all corners: linear in the centre c
    equations = np.column_stack([2 * points, np.ones(len(points))])
    *centre, _ = np.linalg.lstsq(equations, np.sum(points**2, axis=1), rcond=None)[0]
    radii = np.linalg.norm(points - centre, axis=1)
    assert radii == pytest.approx(radii[0], rel=1e-6)


def test_a_tube_that_cannot_bow_clear_is_noted_by_name():
    # 60 mm of tube between shells that nearly touch: the bows run into the next row.
    design = design_of(**{"layout.pitch": 10.5, "tube.length": 60.0})
    notes = buildability_notes(design, lay_out(design))
    assert any(note.startswith("tube 2 of line 1 passes") and "inside shell" in note for note in notes)
    assert any("tube 2 of line 1 overlaps tube 3 of line 1" in note for note in notes)


def test_a_kinked_tube_is_noted_with_its_radius():
    design = design_of(**{"layout.pitch": 10.05, "tube.length": 4.1, "layout.columns": 12})
    radius = bow_radius(bow_angle(4.1, 10.05, 3.0, 5.0), 10.05, 5.0)
    assert radius < design.tube.outer_diameter
    note = f"tube 2 of line 1 bends to a radius of {radius:.2g} mm, below the 0.9 mm that it may be bent to"
    assert note in buildability_notes(design, lay_out(design))


def test_a_tube_bent_below_what_its_design_allows_is_noted_by_name():
    design = geometry.prototype("fingertip-3x4")
    bends = [tightest_bend(tube.course) for tube in lay_out(design).tubes]
    bow = min(bends)
    assert bow == pytest.approx(1.606, abs=1e-3)
    wide, tight = (design.with_values({"tube.bend_radius": bow + step}) for step in (-1e-3, 1e-3))
    assert buildability_notes(wide, lay_out(wide)) == ()
    notes = buildability_notes(tight, lay_out(tight))
    assert len(notes) == np.sum(np.isfinite(bends)) == 11
    assert notes[0] == "tube 2 of line 1 bends to a radius of 1.6 mm, below the 1.61 mm that it may be bent to"


def test_the_smallest_bend_radius_follows_from_spring_and_sheath():
    tube = geometry.prototype("fingertip-3x4").tube
    assert tube.smallest_bend_radius == tube.outer_diameter  # a thin spring in a thick sheath
    thin = tube.model_copy(update={"inner_diameter": 0.5, "wire_diameter": 0.02})
    assert thin.smallest_bend_radius == pytest.approx(1.5 * 0.54)
    # There the turns gape by one wire on the outside: each turn takes up as much more as the radii are to each other.
    outside, axis = 0.54, thin.smallest_bend_radius
    assert 0.02 * (axis + outside / 2) / (axis - outside / 2) - 0.02 == pytest.approx(0.02)


# -- on a cylinder --------------------------------------------------------------------------------------
@given(
    cavities=st.tuples(st.floats(0.5, 5), st.floats(0.5, 5)),
    walls=st.tuples(st.floats(0.2, 3), st.floats(0.2, 3)),
    radius=st.floats(10, 200),
    part=st.floats(0.01, 0.99),
)
def test_a_wound_tube_has_exactly_its_length(cavities, walls, radius, part):
    outer = tuple(c + w for c, w in zip(cavities, walls, strict=True))
    shortest, longest = 2 * max(outer) - sum(cavities), 2 * max(outer) - sum(cavities) + math.pi * radius
    length = shortest + part * (longest - shortest)
    turn = wound_turn(length, cavities, outer, radius)
    assert wound_length(turn, cavities, outer, radius) == pytest.approx(length)
    assert 0 < wound_radius(turn, outer, radius) < radius


def test_a_serpentine_on_a_cylinder_keeps_every_tube_at_its_length_and_off_the_cylinder():
    design = design_of(layout={"kind": "cylinder", "columns": 6, "diameter": 50.0})
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    axis, ports = -25.0 - 1.0, 25.0 + 1.0 + design.resonator.port_axis_height
    frames = {("point", p.line, p.place): (layout.frame(p), p.port_angles) for p in layout.points}
    bends = set()
    for tube in layout.tubes:
        assert path_length(tube.course) == pytest.approx(tube.tube.length, rel=2e-4)
        from_axis = np.hypot(tube.course[:, 0], tube.course[:, 2] - axis)
        assert from_axis.min() > ports - 1e-9
        bends.add(round(tightest_bend(tube.course), 6))
        if ("point", tube.line, tube.segment - 1) in frames:
            frame, angles = frames["point", tube.line, tube.segment - 1]
            along = frame.seen(tube.course[:2])
            turn = math.radians(angles[1])
            inner, outer = design.resonator.cavity_diameter / 2, design.resonator.outer_diameter / 2
            height = design.resonator.port_axis_height
            assert along[0] == pytest.approx([inner * math.cos(turn), inner * math.sin(turn), height], abs=1e-6)
            assert np.hypot(*along[1, :2]) >= outer - 1e-6
            assert along[1, 2] == pytest.approx(height)
    assert len(bends) == 3  # around to the next point, around to a microphone, straight from row to row
    wide = lay_out(design.with_values({"layout.diameter": 2000.0}))
    flat = lay_out(design_of(layout={"kind": "serpentine", "columns": 6}))
    apart = [np.linalg.norm(np.diff([p.position for p in lay.points], axis=0), axis=1) for lay in (wide, flat)]
    assert apart[0] == pytest.approx(apart[1], rel=1e-4)


def test_a_row_longer_than_its_cylinder_is_round_runs_into_itself_by_name():
    design = design_of(layout={"kind": "cylinder", "columns": 12, "diameter": 50.0})
    layout = lay_out(design)
    assert any(note.startswith("shell 1 overlaps shell 1") for note in buildability_notes(design, layout))


IMPOSSIBLE = [
    ({"kind": "cylinder"}, Kind.MISSING, "layout.diameter"),
    ({"kind": "serpentine", "diameter": 50.0}, Kind.CONFLICT, "layout.diameter"),
    ({"kind": "cylinder", "diameter": 50.0, "pitch": 12.0}, Kind.CONFLICT, "layout.pitch"),
    ({"kind": "cylinder", "diameter": 2.0}, Kind.CONFLICT, "tube.length"),
    ({"kind": "hand", "columns": 2}, Kind.CONFLICT, "layout.columns"),
    ({"kind": "hand", "columns": 3, "spread": 30.0}, Kind.CONFLICT, "layout.spread"),
    ({"kind": "serpentine", "palm": 90.0}, Kind.CONFLICT, "layout.palm"),
]


@pytest.mark.parametrize(("layout", "kind", "field"), IMPOSSIBLE)
def test_layouts_that_cannot_be_are_refused_by_name(layout, kind, field):
    with refused(kind, field, error=geometry.DesignError):
        design_of(**{"layout": layout, "tube.length": 20.0})


def test_messages():
    cases = {str(layout): partial(design_of, **{"layout": layout, "tube.length": 20.0}) for layout, *_ in IMPOSSIBLE}
    cases["a tube too short"] = partial(bow_angle, 3.0, 10.0, 3.0, 4.0)
    check_messages(Path(__file__).with_name("messages.txt"), cases)


# -- on a hand ------------------------------------------------------------------------------------------
def glove(**values):
    lines = [{"between": pair, "points": 6} for pair in (["A", "B"], ["B", "C"])]
    changes = {"microphones": ["A", "B", "C"], "lines": lines, "layout": {"kind": "hand", "columns": 3}}
    return geometry.prototype("glove").with_values({**changes, "microphone.chamber_diameter": 2.9, **values})


def test_points_of_a_hand_lie_along_fingers_that_fan_out_from_the_wrist():
    design = glove()
    layout = lay_out(design)
    assert buildability_notes(design, layout) == ()
    points = np.array([p.position for p in layout.points])
    reach, bearing = np.linalg.norm(points, axis=1), np.degrees(np.arctan2(points[:, 1], points[:, 0]))
    assert reach == pytest.approx([80, 101, 122, 122, 101, 80] * 2)
    assert bearing == pytest.approx(np.repeat([103.5, 94.5, 85.5, 76.5], 3))
    for tube in layout.tubes:
        assert not tube.schematic
        assert path_length(tube.course) == pytest.approx(tube.tube.length, rel=2e-4)
    # The microphone of two lines lies in the palm, as far from both ends as their straight tubes reach.
    middle = layout.microphones[1].position
    for end in (points[5], points[6]):
        assert math.dist(middle, end) == pytest.approx(design.microphone_reach_of(design.lines[0], 0))
    assert np.linalg.norm(middle) < 80
    # Bows over the fingertips lie outside of all points.
    over = next(tube for tube in layout.tubes if tube.label == "tube 4 of line 1")
    assert np.linalg.norm(over.course[len(over.course) // 2, :2]) > 122


def test_tubes_that_meet_in_the_palm_at_too_sharp_an_angle_are_refused():
    with refused(Kind.CONFLICT, "microphone.chamber_diameter", 1.8, error=geometry.DesignError):
        glove(**{"microphone.chamber_diameter": 1.8})


def test_neither_layout_nor_counts_load_the_cad_kernel():
    code = (
        "import sys, geometry, geometry.printing, geometry.formats.part_files\n"
        "from geometry.layout.arrangement import lay_out\nfrom geometry.assembly.part_list import part_counts\n"
        "from geometry.layout.cutting import cutting_list\n"
        "d = geometry.prototype('array-2x6'); lay_out(d); part_counts(d); cutting_list(d)\n"
        "print([m for m in ('cadquery', 'OCP', 'gmsh', 'vtkmodules', 'torch', 'trimesh') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
