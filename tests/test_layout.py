"""Where parts lie: lengths of tubes, order of points, overlaps by name."""

import math
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import geometry
from geometry.cells import cell_catalogue
from geometry.layout import place
from geometry.routing import bow_angle, bow_radius, bowed_path, path_length


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
    with pytest.raises(ValueError, match=r"3 mm does not reach over 4 mm"):
        bow_angle(3.0, 10.0, 3.0, 4.0)


def test_points_run_forth_and_back_at_the_pitch_of_straight_tubes():
    layout = place(design_of())
    assert [p.number for p in layout.points] == list(range(1, 13))
    expected = [(18.5 * k, 0.0) for k in range(6)] + [(18.5 * k, 18.5) for k in range(5, -1, -1)]
    assert [p.position for p in layout.points] == expected
    assert [p.port_angles for p in layout.points][4:8] == [(180.0, 0.0), (180.0, 90.0), (270.0, 180.0), (0.0, 180.0)]


@pytest.mark.parametrize("name", ["array-2x6", "fingertip-3x4", "fingertip-4x6", "line-2"])
def test_arrays_of_one_line_are_built_as_drawn(name):
    design = geometry.prototype(name)
    layout = place(design)
    assert layout.notes == ()
    assert len(layout.tubes) == design.point_count + 1
    for tube in layout.tubes:
        assert not tube.schematic
        assert path_length(tube.path) == pytest.approx(tube.tube.length, rel=2e-4)


@pytest.mark.parametrize("name", ["fingertip-3x4", "fingertip-4x6"])
def test_fingertip_points_are_4_mm_apart(name):
    positions = np.array([p.position for p in place(geometry.prototype(name)).points])
    assert np.allclose(np.linalg.norm(np.diff(positions, axis=0), axis=1), 4.0)


@pytest.mark.parametrize("name", geometry.prototype_names())
def test_the_only_notes_on_prototypes_are_of_microphones_that_join_lines(name):
    design = geometry.prototype(name)
    for note in place(design).notes:
        assert note.startswith("microphone ")
        assert "drawn schematically" in note
        assert f"is {design.microphone_tube_of(design.lines[0]).length:g} mm, drawn" in note


@pytest.mark.parametrize("name", geometry.prototype_names())
def test_every_tube_starts_and_ends_on_cavity_walls_in_the_direction_of_its_ports(name):
    design = geometry.prototype(name)
    layout = place(design)
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
    for microphone in place(geometry.prototype("line-4")).microphones:
        angles = sorted(port.angle for port in microphone.ports)
        assert np.diff([*angles, angles[0] + 360]) == pytest.approx([120, 120, 120], abs=1e-5)
        assert [(p.line, p.end) for p in microphone.ports] == sorted((p.line, p.end) for p in microphone.ports)


def test_array_2x6_needs_three_air_cells():
    design = geometry.prototype("array-2x6")
    assert len(cell_catalogue(design, place(design)).distinct) == 3


def ring(points):
    names = ["A", "B", "C"]
    lines = [{"between": [names[k], names[(k + 1) % 3]], "points": count} for k, count in enumerate(points)]
    return design_of(microphones=names, lines=lines, layout={"kind": "ring"})


def test_a_ring_of_equal_lines_is_built_as_drawn():
    layout = place(ring([5, 5, 5]))
    assert layout.notes == ()
    assert all(path_length(t.path) == pytest.approx(t.tube.length) for t in layout.tubes)
    corners = np.array([m.position for m in layout.microphones])
    assert np.linalg.norm(corners, axis=1) == pytest.approx([np.linalg.norm(corners[0])] * 3)


def test_a_shorter_line_of_a_ring_is_noted_with_its_numbers():
    layout = place(ring([5, 3, 5]))
    # Two points fewer: two pitches of 18.5 mm are shared by the line's two microphone tubes.
    assert len(layout.notes) == 2
    assert "tube 1 of line 2 is 12.5 mm, drawn 31.0 mm" in layout.notes[0]
    assert "tube 4 of line 2 is 12.5 mm, drawn 31.0 mm" in layout.notes[1]


def test_a_tube_that_cannot_bow_clear_is_noted_by_name():
    # 60 mm of tube between shells that nearly touch: the bows run into the next row.
    notes = place(design_of(**{"layout.pitch": 10.5, "tube.length": 60.0})).notes
    assert any(note.startswith("tube 2 of line 1 passes") and "inside shell" in note for note in notes)
    assert any("tube 2 of line 1 overlaps tube 3 of line 1" in note for note in notes)


def test_a_kinked_tube_is_noted_with_its_radius():
    design = design_of(**{"layout.pitch": 10.05, "tube.length": 4.1, "layout.columns": 12})
    radius = bow_radius(bow_angle(4.1, 10.05, 3.0, 5.0), 10.05, 5.0)
    assert radius < design.tube.outer_diameter
    note = f"tube 2 of line 1 bends to a radius of {radius:.2g} mm, below its outside diameter 0.9 mm"
    assert note in place(design).notes


def test_neither_layout_nor_counts_load_the_cad_kernel():
    code = (
        "import sys, geometry, geometry.printing, geometry.part_files\n"
        "from geometry.layout import place\nfrom geometry.assembly import part_counts\n"
        "from geometry.tube import cutting_list\n"
        "d = geometry.prototype('array-2x6'); place(d); part_counts(d); cutting_list(d)\n"
        "print([m for m in ('cadquery', 'OCP', 'gmsh', 'vtkmodules', 'torch', 'trimesh') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"
