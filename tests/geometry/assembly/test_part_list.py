"""CAD parts: shapes, fits, names and counts."""

import math
from collections import Counter

import cadquery as cq
import numpy as np
import pytest
from built import built
from refusals import refused
from scipy.integrate import quad

import geometry
from geometry import Kind
from geometry.air.cells import cell_catalogue
from geometry.air.volume import air_solid
from geometry.assembly.model import array_model
from geometry.assembly.part_list import PartSet, build_parts, part_counts, place_parts
from geometry.design.design_file import read_design
from geometry.formats.part_files import tessellate_distinct
from geometry.layout.arrangement import lay_out
from geometry.layout.cutting import cutting_list, spring_length
from geometry.printing.plates import export_plates
from geometry.schema.ports import Port
from geometry.schema.print_processes import PROCESSES, with_rules
from geometry.solids.round_solids import one_solid
from geometry.solids.shell import build_shell


@pytest.fixture(scope="module")
def array():
    """The 2 x 6 array with the numbers that the tests count with."""
    return geometry.prototype("array-2x6").with_values(
        {
            "resonator.cavity_diameter": 6.0,
            "resonator.cavity_height": 2.5,
            "resonator.wall_thickness": 2.0,
            "resonator.floor_thickness": 1.0,
            "membrane.thickness": 0.5,
            "membrane.rim_width": 1.5,
            "microphone.chamber_diameter": 2.2,
            "microphone.chamber_height": 1.8,
            "microphone.wall_thickness": 1.0,
            "microphone.sound_hole_length": 0.3,
            "printing.port_lip": 0.3,
        }
    )


@pytest.fixture(scope="module")
def parts(array):
    return build_parts(array)


def inside(part, *point):
    return part.val().isInside(cq.Vector(*point), 1e-6)


def pierced(radius, near, far):
    """Volume of a round hole across a round wall: over the hole's section, from near(y) to far(y) from the axis."""
    return quad(lambda y: 2 * math.sqrt(radius**2 - y**2) * (far(y) - near(y)), -radius, radius)[0]


def test_the_shell_has_the_volume_of_its_walls_less_its_ports(array, parts):
    # Cavity radius 3, outer 5, height 2.5, floor 1; ledge of 0.25 from 4.55; lip 0.3; bore 0.22, socket 0.5.
    wall = math.pi * (25 * 3.5 - 9 * 2.5 + (25 - 4.55**2) * 0.25)
    bore = pierced(0.22, lambda y: math.sqrt(9 - y**2), lambda y: 3.3)
    socket = pierced(0.5, lambda y: 3.3, lambda y: math.sqrt(25 - y**2))
    assert parts["shell-straight"].val().Volume() == pytest.approx(wall - 2 * (bore + socket), rel=1e-6)


def test_a_port_is_a_bore_through_the_lip_and_a_socket_from_there_out(parts):
    corner, height = parts["shell-corner-90"], 1.25
    for direction in (np.array([1.0, 0.0]), np.array([0.0, 1.0])):
        side = direction[::-1]
        for radius in (2.9, 3.1, 3.29, 3.31, 4.9):
            assert not inside(corner, *(radius * direction), height)
            for offset, material in (
                (0.21, False),
                (0.23, 3 < radius < 3.3),
                (0.49, 3 < radius < 3.3),
                (0.51, radius > 3),
            ):
                # Along z the cavity's wall is straight, so the lip begins at 3 mm for every offset.
                assert inside(corner, *(radius * direction), height + offset) == material
        assert inside(corner, *(3.15 * direction + 0.4 * side), height)
    assert inside(corner, -4, 0, height)
    assert inside(corner, 0, -4, height)


def test_a_shell_with_no_room_for_a_ledge_is_flat_on_top():
    design = geometry.prototype("fingertip-3x4")
    shell = build_shell(design.resonator, design.membrane, design.printing, [Port(0, 0.18, 0.55)])
    assert shell.val().BoundingBox().zmax == pytest.approx(design.resonator.cavity_height, abs=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "shape"),
    [("array-2x6", "cylinder"), ("fingertip-3x4", "cylinder"), ("line-4", "cylinder"), ("fingertip-3x4", "box")],
)
def test_printed_material_and_air_do_not_overlap(name, shape):
    """The air that is computed is the air that the parts leave: same places, same diameters, a box's sides too."""
    design = geometry.prototype(name).with_values({"resonator.shape": shape})
    layout, parts = lay_out(design), built(name) if shape == "cylinder" else build_parts(design)
    catalogue = cell_catalogue(design, layout)
    placed = [p for p in place_parts(design, layout) if p.part.startswith(("shell", "microphone-housing"))]
    places = list(layout.points) + list(layout.microphones)
    done = set()
    for use, part, where in zip(catalogue.points + catalogue.microphones, placed, places, strict=True):
        if (use, part.part) in done:
            continue
        done.add((use, part.part))
        angles = where.port_angles if hasattr(where, "port_angles") else [port.angle for port in where.ports]
        solid = parts[part.part].val().rotate((0, 0, 0), (0, 0, 1), part.rotation)
        # The canonical air cell, turned (and for some mirrored) so that its ports meet the place's tubes.
        cell = [use.cell.ports[k].angle for k in use.order]
        for sense in (1, -1):
            turn = angles[0] - sense * cell[0]
            if all(abs((sense * c + turn - a + 180) % 360 - 180) < 0.2 for c, a in zip(cell, angles, strict=True)):
                break
        else:
            pytest.fail(f"{part.label}: its cell has other port angles")
        air = air_solid(use.cell)
        air = (air if sense == 1 else air.mirror("XZ")).rotate((0, 0, 0), (0, 0, 1), turn)
        # Port angles of parts and cells are rounded to 0.1 degrees: 0.01 mm at most.
        assert solid.intersect(air).Volume() < 2e-3 * air.Volume()
    assert done


@pytest.mark.parametrize("name", geometry.prototype_names())
def test_every_part_of_every_prototype_is_one_valid_solid_and_is_counted(name):
    design = geometry.prototype(name)
    parts, counts = built(name), part_counts(design)
    assert isinstance(parts, PartSet)
    assert parts.counts == counts
    assert list(parts) == list(counts) == list(parts.kinds)
    assert {parts.kinds[name]: parts.origin(name) for name in parts} == {
        "shell": "printed", "membrane": "cast", "housing": "printed", "board": "bought",
        "mold-base": "printed", "mold-lid": "printed", "mold-shim": "printed", "mold-plugs": "printed",
    }  # fmt: skip
    half = parts.only(*list(parts)[::2])
    assert (list(half), list(half.counts), list(half.kinds)) == (list(parts)[::2],) * 3
    for part in parts.values():
        assert len(part.solids().vals()) == 1
        assert part.val().isValid()
    shells = {part: count for part, count in counts.items() if part.startswith("shell")}
    housings = {part: count for part, count in counts.items() if part.startswith("microphone-housing")}
    assert sum(shells.values()) == counts["membrane"] == design.point_count
    assert sum(housings.values()) == counts["microphone-board"] == len(design.microphones)
    assert counts["mold-base"] == counts["mold-lid"] == 1


def test_the_2x6_array_has_two_kinds_of_shell(parts):
    assert parts.counts == {
        "shell-straight": 10,
        "shell-corner-90": 2,
        "membrane": 12,
        "mold-base": 1,
        "mold-lid": 1,
        "mold-shim-1": 3,
        "mold-shim-2": 3,
        "mold-plugs": 1,
        "microphone-housing": 2,
        "microphone-board": 2,
    }
    assert parts.parameters["shell-corner-90"]["cavity_diameter"] == 6.0
    assert parts.parameters["shell-corner-90"]["count"] == 2


def test_mirrored_shells_with_different_tubes_are_different_parts():
    names = [name for name in part_counts(geometry.prototype("fingertip-3x4")) if "0.44" in name]
    angles = [float(name.removeprefix("shell-corner-").split("-")[0]) for name in names]
    assert len(angles) == 2
    assert sum(angles) == pytest.approx(360)


@pytest.mark.parametrize("name", ["array-2x6", "fingertip-4x6", "large-area-64"])
def test_every_tube_leaves_its_shells_through_a_port(name):
    design = geometry.prototype(name)
    layout, parts = lay_out(design), built(name)
    shells = [p for p in place_parts(design, layout) if p.part.startswith("shell")]
    at = {(p.line, p.place): shell for p, shell in zip(layout.points, shells, strict=True)}
    height, checked = design.resonator.port_axis_height, 0
    for tube in layout.tubes:
        for place_, end in ((tube.segment - 1, tube.path[0]), (tube.segment, tube.path[-1])):
            if (tube.line, place_) not in at:
                continue
            shell = at[tube.line, place_]
            turn = math.radians(-shell.rotation)
            x, y = end[:2] - np.array(shell.position[:2])
            angle = math.atan2(y, x) + turn
            bore, outside = tube.tube.inner_diameter / 2, tube.tube.outer_diameter / 2
            lip = design.resonator.cavity_diameter / 2 + design.printing.port_lip
            for radius, clear in ((lip - 0.02, bore), (lip + 0.02, outside)):
                spot = (radius * math.cos(angle), radius * math.sin(angle))
                assert not inside(parts[shell.part], *spot, height + 0.98 * clear)
            assert inside(parts[shell.part], *spot, height + outside + 2 * design.printing.glue_gap)
            checked += 1
    assert checked == 2 * design.point_count


def test_the_cutting_list_takes_off_the_lips(array):
    cuts = cutting_list(array)
    assert [(cut.use, cut.cut_length, cut.count) for cut in cuts] == [("microphone", 11.9, 2), ("segment", 11.9, 11)]
    assert cuts[1].total_length == pytest.approx(130.9)


def test_the_cutting_list_of_the_large_area_adds_up_by_tube_and_names_its_lines():
    design = geometry.prototype("large-area-64")
    cuts = cutting_list(design)
    assert sum(cut.count for cut in cuts) == sum(line.points + 1 for line in design.lines)
    assert len({(cut.use, cut.tube) for cut in cuts}) == len(cuts)
    assert [(cut.use, cut.lines) for cut in cuts] == [
        ("microphone", (1, 2, 3, 4)), ("segment", (1, 2, 3, 4)), ("segment", (1, 2, 3, 4)),
    ]  # fmt: skip
    assert all(cut.spring_length == cut.cut_length for cut in cuts)


@pytest.mark.parametrize("radius", [1.6, 5.0, 40.0])
def test_the_turns_of_a_bent_spring_touch_on_the_inside_of_its_bend(radius):
    tube, bend = geometry.prototype("fingertip-3x4").tube, 1.3
    # Wires of neighbouring turns touch where their middles lie on the inside, half a mean coil diameter off the axis.
    inside = radius - (tube.spring_outer_diameter - tube.wire_diameter) / 2
    turns = bend / (2 * math.asin(tube.wire_diameter / 2 / inside))
    length = spring_length(tube, radius * bend, bend)
    assert length == pytest.approx(turns * tube.wire_diameter, rel=3e-4)
    assert length < radius * bend


def test_springs_wound_around_a_cylinder_are_cut_shorter_than_their_sheaths():
    design = geometry.prototype("array-2x6").with_values(
        {"layout": {"kind": "cylinder", "columns": 6, "diameter": 60.0}}
    )
    lengths = {(cut.use, cut.cut_length, cut.spring_length) for cut in cutting_list(design)}
    # From shell to shell the axis turns by what the shells turn; from row to row it lies straight along the cylinder.
    frames = [lay_out(design).frame(point) for point in lay_out(design).points[:2]]
    turn = math.acos(np.dot(frames[0].axes[2], frames[1].axes[2]))
    wound = round(11.5 - turn * (design.tube.spring_outer_diameter - design.tube.wire_diameter) / 2, 2)
    assert wound < 11.45
    assert {piece for piece in lengths if piece[0] == "segment"} == {("segment", 11.5, wound), ("segment", 11.5, 11.5)}


@pytest.mark.slow
def test_a_carrier_takes_the_place_of_its_shells_on_plates_and_lists(tmp_path):
    values = {"printing.carrier": "sheet", "mold.kind": "open-face", "mold.rows": 1, "mold.columns": 1}
    design = geometry.prototype("array-2x6").with_values(values)
    parts = build_parts(design)
    assert {name: count for name, count in parts.counts.items() if name.startswith(("shell", "carrier"))} == {
        "shell-straight": 0, "shell-corner-90": 0, "carrier": 1,
    }  # fmt: skip
    assert parts.parameters["shell-straight"]["count"] == 0
    shapes = tessellate_distinct(parts)
    laid = export_plates(parts, tmp_path, PROCESSES["sla-resin"], shapes)
    copies = Counter()
    for plate in laid.plates:
        copies.update(plate.copies)
    assert copies == {"carrier": 1, "mold-base": 1, "mold-scraper": 1, "mold-plugs": 1, "microphone-housing": 2}
    # On a machine that is too small for the carrier nothing stands in for it.
    small = with_rules(PROCESSES["sla-resin"], {"build_volume": (50, 45, 50)})
    laid = export_plates(parts, tmp_path, small, shapes)
    assert laid.too_large == ("carrier",)
    assert not [name for plate in laid.plates for name in plate.copies if name.startswith("shell")]


def test_spares_lie_on_the_plates_as_far_as_they_take_no_further_one(parts, tmp_path):
    shapes = tessellate_distinct(parts.only("shell-straight", "shell-corner-90"))
    shells = parts.only("shell-straight", "shell-corner-90")
    wanted = {"shell-straight": 3, "shell-corner-90": 1}
    laid = export_plates(shells, tmp_path, PROCESSES["sla-resin"], shapes, wanted)
    (plate,) = laid.plates
    assert laid.spares == wanted
    assert plate.copies == {name: shells.counts[name] + wanted[name] for name in wanted}
    full = with_rules(PROCESSES["sla-resin"], {"build_volume": (75, 75, 50)})
    most = export_plates(shells, tmp_path, full, shapes, {"shell-straight": 500})
    assert len(most.plates) == len(export_plates(shells, tmp_path, full, shapes).plates)
    assert 0 < most.spares["shell-straight"] < 500
    one_more = {"shell-straight": most.spares["shell-straight"] + 1}
    assert export_plates(shells, tmp_path, full, shapes, one_more).spares == most.spares


@pytest.mark.slow
def test_a_part_is_drawn_again_from_the_design_that_the_parts_hold(array, parts):
    changed = array.with_values({"resonator.shape": "box", "shell.feet": 2, "membrane.rim_width": 1.2, "mold.rows": 2})
    drawn = build_parts(changed)
    for name in ("shell-straight", "mold-base", "mold-shim-2"):
        again = build_parts(read_design(drawn.design_toml))[name]
        assert again.val().Volume() == pytest.approx(drawn[name].val().Volume(), rel=1e-12)
        assert drawn[name].val().Volume() != pytest.approx(parts[name].val().Volume(), rel=1e-3) or "shim" in name
    shims = [parts.parameters[f"mold-shim-{step}"] for step in (1, 2)]
    assert [shim["raises_lid"] for shim in shims] == [0.05, 0.1]
    for step, shim in enumerate(shims, start=1):
        assert shim["height"] == pytest.approx(parts[f"mold-shim-{step}"].val().BoundingBox().zlen)


def test_a_part_that_falls_into_two_is_refused():
    halves = cq.Solid.makeBox(3, 1, 1).cut(cq.Solid.makeBox(1, 1, 1, cq.Vector(1, 0, 0)))
    with refused(Kind.NO_RESULT, "shell"):
        one_solid(halves, "shell")


@pytest.mark.parametrize("view", ["draw_array", "draw_point"])
def test_pictures_show_shells_and_membranes(view, array, parts, tmp_path):
    import pyvista as pv

    from geometry.pictures import views

    path = getattr(views, view)(array_model(array, parts), tmp_path / "view.png", size=(640, 400))
    assert [p.name for p in tmp_path.iterdir()] == ["view.png"]
    pixels = np.asarray(pv.read(path).active_scalars).reshape(-1, 3).astype(int)
    red, green, blue = pixels.T
    assert len(pixels) == 640 * 400
    assert np.mean((blue > red + 10) & (blue > green)) > 0.02, "shells are bluish"
    assert np.mean((red > green + 20) & (green > blue)) > 0.02, "membranes and molds are reddish to yellow"
    assert 0.2 < np.mean(pixels.min(axis=1) > 250) < 0.95
