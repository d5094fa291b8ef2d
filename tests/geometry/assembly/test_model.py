"""Whole arrays as solids: tubes fit their ports, nothing is in the way of anything, files hold every part by name."""

import base64
import dataclasses
import math
import re

import cadquery as cq
import numpy as np
import pytest
from built import put_together
from refusals import refused

import geometry
from geometry import Kind
from geometry.assembly.fit import CONTACT_VOLUME, interferences, misfits, port_fits
from geometry.assembly.model import array_model, assembly_of, build_assembly
from geometry.formats.step_assembly import write_step
from geometry.layout.cutting import cutting_list
from geometry.layout.overlaps import buildability_notes
from geometry.pictures.viewer import write_gltf, write_viewer
from geometry.plan.routing import path_length
from geometry.solids.tube import build_tube, piece_of

WOUND = {"layout": {"kind": "cylinder", "columns": 6, "diameter": 60.0}}


def hand():
    lines = [{"between": pair, "points": 6} for pair in (["A", "B"], ["B", "C"])]
    changes = {"layout": {"kind": "hand", "columns": 3}, "lines": lines, "microphone.chamber_diameter": 3.2}
    return geometry.prototype("glove").with_values(changes)


# -- tubes ----------------------------------------------------------------------------------------------
def test_a_straight_tube_is_a_spring_and_a_sheath_of_their_sections_times_the_cut_length():
    design = geometry.prototype("array-2x6")
    tube, lip = design.tube, design.printing.port_lip
    course = np.array([[1.0, 2.0, 3.0], [1.0, 2.0 + tube.length, 3.0]])
    spring, sheath = (part.val() for part in build_tube(piece_of(tube, course, lip)[0]))
    length = tube.length - 2 * lip
    assert length == cutting_list(design)[0].cut_length
    assert spring.Volume() == pytest.approx(math.pi / 4 * (0.6**2 - 0.44**2) * length)
    assert sheath.Volume() == pytest.approx(math.pi / 4 * (0.9**2 - 0.6**2) * length)


def test_a_bent_tube_has_the_volume_of_its_sections_along_its_axis():
    model = put_together("fingertip-3x4")
    tube, lip = model.design.tube, model.design.printing.port_lip
    (bent,) = (name for name in model.shapes if name.startswith("sheath") and "bent" in name)
    # Pappus: the axis runs through the middle of the section.
    exact = math.pi / 4 * (tube.outer_diameter**2 - tube.spring_outer_diameter**2) * (tube.length - 2 * lip)
    assert model.shapes[bent].Volume() == pytest.approx(exact, rel=1e-6)
    assert model.shapes[bent].isValid()


def test_a_piece_lies_where_its_tube_runs():
    design = geometry.prototype("fingertip-3x4")
    for tube in put_together("fingertip-3x4").layout.tubes:
        piece, matrix = piece_of(tube.tube, tube.course, design.printing.port_lip)
        moved = np.array(piece.path) @ matrix[:3, :3].T + matrix[:3, 3]
        assert np.allclose(moved[1:-1], tube.course[1:-1], atol=2e-6)
        assert np.linalg.det(matrix) == pytest.approx(1)
        assert path_length(moved) == pytest.approx(path_length(tube.course) - 2 * design.printing.port_lip, abs=1e-5)


def test_a_tube_that_bends_into_itself_is_refused_by_name():
    tube = geometry.prototype("array-2x6").tube
    turns = np.linspace(0, np.pi / 2, 20)
    arc = 0.4 * np.column_stack([np.sin(turns), 1 - np.cos(turns), 0 * turns])
    course = np.vstack([[-2.0, 0, 0], arc, arc[-1] + [0, 2.0, 0]])
    with refused(Kind.UNSUITABLE):
        build_tube(piece_of(tube, course, 0.3)[0])


# -- fit ------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", geometry.prototype_names())
def test_every_tube_end_fits_its_port_and_its_bore_carries_on_the_spring(name):
    model = put_together(name)
    fits = port_fits(model)
    assert len(fits) == 2 * (len(model.layout.tubes) - len(model.schematic))
    gap = model.design.printing.glue_gap
    for fit in fits:
        assert fit.counterbore == pytest.approx(fit.tube_outside + 2 * gap, abs=1e-9)
        assert fit.glue_gap == pytest.approx(gap, abs=1e-9)
        assert fit.bore == pytest.approx(fit.spring_bore, abs=1e-9)
        # Directions of ports are rounded to 0.1 degrees, so that equal shells are one part.
        assert fit.axis_offset < model.design.resonator.outer_diameter / 2 * math.radians(0.05)
    if name not in ("fingertip-3x4", "fingertip-4x6", "glove", "large-area-64"):  # whose tubes are bowed, or meet askew
        assert max(fit.axis_offset for fit in fits) < 1e-8


def moved(model, label, offset):
    placed = tuple(
        dataclasses.replace(part, position=tuple(np.add(part.position, offset))) if part.label == label else part
        for part in model.placed
    )
    return dataclasses.replace(model, placed=placed)


def test_a_part_in_the_way_is_found_by_name_with_its_volume():
    design = put_together("array-2x6").design
    pressed = moved(put_together("array-2x6"), "membrane 3", (0, 0, -0.1))
    (found,) = interferences(pressed)
    assert (found.first, found.second) == ("shell 3", "membrane 3")
    inner, rim = design.resonator.cavity_diameter / 2, design.membrane.rim_width
    # The membrane's edge has the draft of its mold.
    assert found.volume == pytest.approx(0.1 * math.pi * ((inner + rim) ** 2 - inner**2), rel=2e-3)
    assert found.volume > 1000 * CONTACT_VOLUME


def test_a_tube_beside_its_port_fits_in_none():
    aside = moved(put_together("array-2x6"), "spring of tube 2 of line 1", (0, 0.5, 0))
    aside = moved(aside, "sheath of tube 2 of line 1", (0, 0.5, 0))
    with refused(Kind.UNSUITABLE):
        port_fits(aside)
    assert {found.first for found in interferences(aside)} == {"shell 1", "shell 2"}


def test_what_does_not_go_together_is_said_in_a_line_each():
    model = put_together("array-2x6")
    (line,) = misfits(moved(model, "membrane 3", (0, 0, -0.1)))
    assert re.fullmatch(r"shell 3 and membrane 3 are in each other's way: they share 3\.\d+ mm\^3", line)
    aside = moved(model, "spring of tube 2 of line 1", (0, 0, 0.07))
    aside = moved(aside, "sheath of tube 2 of line 1", (0, 0, 0.07))
    found = [line for line in misfits(aside) if "axis" in line]
    assert [re.sub(r"shell \d", "shell", line) for line in found] == [
        "sheath of tube 2 of line 1 is 0.07 mm beside the axis of its socket in shell, which leaves it 0.05 mm"
    ] * 2


def test_a_sheath_that_is_too_wide_for_its_sockets_is_found():
    model = put_together("array-2x6")
    (name,) = (part.part for part in model.placed if part.label == "sheath of tube 2 of line 1")
    box = model.shapes[name].BoundingBox()
    inner, outer = (
        cq.Solid.makeCylinder(radius, box.xlen, cq.Vector(box.xmin, 0, 0), cq.Vector(1, 0, 0)) for radius in (0.3, 0.55)
    )
    wide = misfits(dataclasses.replace(model, shapes={**model.shapes, name: outer.cut(inner)}))
    assert "sheath of tube 2 of line 1 is 1.1 mm wide, its socket in shell 1 1 mm" in wide
    assert any(line.startswith("shell 1 and sheath of tube 2 of line 1 are in each other's way") for line in wide)


@pytest.mark.slow
def test_a_tube_that_comes_back_below_its_shell_is_measured_where_it_leaves_the_shell():
    below = {"layout.microphone_side": "below", "layout.columns": 4, "microphone_tube.length": 15.0}
    wide = {
        "resonator.cavity_diameter": 8.5,
        "resonator.cavity_height": 3.6,
        "resonator.wall_thickness": 0.8,
        "membrane.rim_width": 0.8,
        "tube.length": 4.12,
    }
    narrow = {"inner_diameter": 0.5, "outer_diameter": 1.011}
    tubes = {f"{tube}.{field}": value for tube in ("tube", "microphone_tube") for field, value in narrow.items()}
    lines = {"lines": [{"between": ["A", "B"], "points": 16}], "microphones": ["A", "B"]}
    model = array_model(geometry.prototype("array-2x6").with_values({**below, **wide, **tubes, **lines}))
    mouth, shell = model.layout.tubes[-1].course[0], model.layout.points[-1].position
    chamber = model.layout.tubes[-1].course[-1]
    assert math.dist(chamber[:2], shell) < math.dist(mouth[:2], shell)  # it ends below the shell that it left
    assert misfits(model) == ()


# -- cylinder and hand ----------------------------------------------------------------------------------
@pytest.mark.slow
@pytest.mark.parametrize("design", [geometry.prototype("array-2x6").with_values(WOUND), hand()], ids=["wound", "hand"])
def test_an_array_that_is_not_flat_or_not_square_fits_together_too(design):
    model = array_model(design)
    assert buildability_notes(model.design, model.layout) == ()
    assert interferences(model) == ()
    fits = port_fits(model)
    assert len(fits) == 2 * len(model.layout.tubes)
    assert max(fit.axis_offset for fit in fits) < 5e-3


@pytest.mark.slow
def test_shells_stand_on_the_cylinder_and_collide_where_it_is_too_narrow():
    design = geometry.prototype("array-2x6").with_values(WOUND)
    model = array_model(design)
    axis = -30.0 - design.resonator.floor_thickness
    for part in model.placed:
        if part.part.startswith("shell"):
            floor = np.array(part.matrix @ [0, 0, -design.resonator.floor_thickness, 1])[:3]
            assert math.hypot(floor[0], floor[2] - axis) == pytest.approx(30.0)
    narrow = array_model(design.with_values({"layout.diameter": 9.0, "lines.0.points": 4}))
    shells = tuple(part for part in narrow.placed if part.kind == "shell")
    solids = {frozenset((f.first, f.second)) for f in interferences(dataclasses.replace(narrow, placed=shells))}
    notes = buildability_notes(narrow.design, narrow.layout)
    overlaps = [re.match(r"(shell \d+) overlaps (shell \d+) by", note) for note in notes]
    assert solids
    assert {frozenset(words.groups()) for words in overlaps if words} == solids


# -- assembly -------------------------------------------------------------------------------------------
def test_the_step_file_names_every_component_and_holds_every_shape_once(tmp_path):
    model = put_together("array-2x6")
    path = write_step(model, tmp_path / "array.step")
    text = path.read_text()
    assert text.count("MANIFOLD_SOLID_BREP(") == len(model.shapes)
    # Products carry the names of the parts, instances those of their places.
    products = re.findall(r"PRODUCT\('([^']*)'", text)
    assert sorted(products) == sorted({*model.shapes, *(part.group for part in model.placed), "array-2x6"})
    instances = re.findall(r"NEXT_ASSEMBLY_USAGE_OCCURRENCE\(\s*'[^']*',\s*'([^']*)'", text)
    assert {"point 7", "shell 7", "membrane 7", "microphone B housing"} <= set(instances)
    assert len(instances) == len(model.placed) + len({part.group for part in model.placed})
    assert not [name for name in instances if name.isdigit()]
    read = cq.Assembly.importStep(str(path))
    assert read.name == "array-2x6"
    groups = {group.name: [part.name for part in group.children] for group in read.children}
    assert set(groups) == {part.group for part in model.placed}
    assert groups["point 7"] == ["shell 7", "membrane 7"]
    assert groups["tube 2 of line 1"] == ["spring of tube 2 of line 1", "sheath of tube 2 of line 1"]
    assert groups["microphone B"] == ["microphone B housing", "board B", "package B"]
    volume = sum(model.shapes[part.part].Volume() for part in model.placed)
    assert read.toCompound().Volume() == pytest.approx(volume, rel=1e-3)


def test_components_lie_where_the_parts_are_placed():
    model = put_together("glove")
    assembly = build_assembly(model.design)
    boxes = {c.name: g.loc * c.loc for g in assembly.children for c in g.children}
    for part in model.placed:
        label = part.label if part.label != part.group else f"{part.label} {part.kind}"
        assert boxes[label].toTuple()[0] == pytest.approx(part.position, abs=1e-9)


def test_a_stretched_membrane_is_shown_as_mounted():
    design = geometry.prototype("array-2x6").with_values({"membrane.stretch": 1.2})
    membrane = array_model(design).shapes["membrane"].BoundingBox()
    across = design.resonator.cavity_diameter + 2 * design.membrane.rim_width
    assert membrane.xlen == pytest.approx(across, abs=1e-6)
    assert membrane.zlen == pytest.approx(design.membrane.thickness / 1.2**2, abs=1e-6)


def test_shells_with_feet_and_grooves_fit_together_and_a_carrier_stands_for_its_shells_on_the_bill():
    design = geometry.prototype("array-2x6").with_values({"shell.groove_width": 0.5, "lines.0.points": 3})
    footed = array_model(design.with_values({"shell.feet": 2}))
    assert footed.shapes["shell-straight"].BoundingBox().ylen > design.resonator.outer_diameter + 2
    assert interferences(footed) == ()
    parts = geometry.build_parts(design.with_values({"printing.carrier": "row"}))
    items = {item.item for item in geometry.bill_of_materials(design, parts).items}
    assert "carrier" in items
    assert "shell-straight" not in items


# -- pictures and models --------------------------------------------------------------------------------
@pytest.mark.parametrize("view", ["top_view", "exploded_view"])
def test_pictures_show_all_kinds_of_parts(view, tmp_path):
    import pyvista as pv

    from geometry.pictures import views

    path = getattr(views, view)(put_together("array-2x6"), tmp_path / "view.png", size=(800, 500))
    red, green, blue = np.asarray(pv.read(path).active_scalars).reshape(-1, 3).astype(int).T
    assert len(red) == 800 * 500
    dark = (red < 90) & (abs(red - green) < 12) & (abs(green - blue) < 12)
    assert np.mean((red > green + 20) & (green > blue)) > 0.005, "membranes"
    assert np.mean(dark) > 0.002, "sheaths"
    if view == "exploded_view":
        assert np.mean((red > blue + 60) & (green > blue + 40)) > 5e-4, "springs"
        assert np.mean((blue > red + 10) & (blue > green)) > 0.01, "shells"
    assert np.mean(np.minimum(np.minimum(red, green), blue) > 250) > 0.4


@pytest.mark.parametrize("name", ["array-2x6", "line-2"])
def test_the_layers_of_an_exploded_view_lie_clear_of_each_other_and_fill_the_picture(name, tmp_path):
    import pyvista as pv

    from geometry.pictures.views import exploded_view

    image = pv.read(exploded_view(put_together(name), tmp_path / "view.png", size=(800, 500)))
    # Rows from the bottom of the picture.
    red, green, blue = np.moveaxis(np.asarray(image.active_scalars).reshape(500, 800, 3).astype(int), -1, 0)
    shells, springs = (blue > red + 10) & (blue > green), (red > blue + 60) & (green > blue + 40)
    rows = np.arange(500)[:, None]
    highest, lowest = np.where(shells, rows, -1).max(axis=0), np.where(springs, rows, 1000).min(axis=0)
    both = (highest >= 0) & (lowest < 1000)
    assert both.sum() > 50
    assert (highest[both] < lowest[both]).all()
    drawn = np.flatnonzero(shells.any(axis=0))
    assert drawn[-1] - drawn[0] > 0.38 * 800


def test_the_gltf_model_is_in_metres_with_a_node_per_part(tmp_path):
    import trimesh

    model = put_together("array-2x6")
    scene = trimesh.load_scene(write_gltf(model, tmp_path / "array.glb"))
    assert set(scene.graph.nodes_geometry) == {part.label.replace(" ", "_") for part in model.placed}
    assert len(scene.geometry) == len(model.shapes)
    compound = assembly_of(model).toCompound().BoundingBox()
    # x, y, z of the array are x, -z, y of glTF.
    low, high = scene.bounds * 1000
    assert (low[0], high[0], low[1], high[1]) == pytest.approx(
        (compound.xmin, compound.xmax, compound.zmin, compound.zmax), abs=0.05
    )
    assert (-high[2], -low[2]) == pytest.approx((compound.ymin, compound.ymax), abs=0.05)


def test_the_page_holds_the_model_and_asks_for_nothing_else(tmp_path):
    import trimesh

    page = write_viewer(put_together("array-2x6"), tmp_path / "array.html").read_text(encoding="utf-8")
    assert not re.search(r"""<(script|link|img|iframe)[^>]+(src|href)="(?!data:)""", page)
    assert "@import" not in page
    # The script fetches the model, which is in the page; the only address in it is the name of XHTML.
    assert set(re.findall(r"""\b(?:https?|wss?)://[^\s"'`]+""", page)) == {"http://www.w3.org/1999/xhtml"}
    content = re.search(r'data:model/gltf-binary;base64,([A-Za-z0-9+/=]+)"', page)
    assert content is not None
    (tmp_path / "model.glb").write_bytes(base64.b64decode(content.group(1)))
    scene = trimesh.load_scene(tmp_path / "model.glb")
    assert len(scene.graph.nodes_geometry) == len(put_together("array-2x6").placed)
    assert "12 points, 2 microphones" in page
    assert "point 7       shell-corner-90     180     90, 0" in page
    assert "<title>array-2x6</title>" in page
