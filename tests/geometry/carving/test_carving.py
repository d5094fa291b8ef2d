"""Bodies with pockets, skins and templates: volumes, ways through them, and parts that clash with no wall."""

import math
from dataclasses import replace
from pathlib import Path

import bodies
import cadquery as cq
import numpy as np
import pytest
from refusals import refused

import geometry
from geometry import Kind
from geometry.assembly.model import array_model
from geometry.body import read_body, samples_of
from geometry.carving import carve, carved_bodies
from geometry.carving.patch import Patch, patch_under
from geometry.carving.pockets import CLEARANCE, pockets, swept
from geometry.formats import export_facets
from geometry.layout import lay_out

EXAMPLES = Path("docs/examples/robot")


@pytest.fixture(scope="module")
def ball(tmp_path_factory):
    """A ball of 20 mm as small facets."""
    path = bodies.written(cq.Workplane().sphere(10), tmp_path_factory.mktemp("ball") / "ball.step")
    return samples_of(read_body(path), 0.6)


def cap(ball, reach, hole=0.0):
    """The part of the ball within reach of its pole."""
    pole = np.array([[0.0, 0.0, 1.0]])
    return patch_under(ball, 10 * pole, pole, np.array([reach]), hole)


def test_a_rod_along_an_arc_has_its_volume():
    angles = np.linspace(0, 1.5, 60)
    course = np.column_stack([5 * np.cos(angles), 5 * np.sin(angles), np.zeros(60)])
    rod = swept(course, 0.5)
    # A facetted circle of 16 corners has less area than a round one.
    area = 8 * 0.5**2 * math.sin(2 * math.pi / 16)
    assert float(rod.volume()) == pytest.approx(area * 7.5, rel=1e-2)
    assert rod.genus() == 0


def test_a_layer_over_a_cap_has_the_volume_of_the_shell_of_a_ball(ball):
    patch = cap(ball, 6.0)
    a, b, c = (patch.places[patch.triangles[:, k]] for k in range(3))
    area = float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)
    layer = patch.layer(0.5, 2.0)
    exact = area / 100 * ((12.0**3) - (10.5**3)) / 3
    assert float(layer.volume()) == pytest.approx(exact, rel=5e-3)
    assert layer.genus() == 0
    assert len(layer.decompose()) == 1


def test_small_holes_of_a_patch_are_filled_and_large_ones_stay(ball):
    angles = np.linspace(0, 2 * math.pi, 24, endpoint=False)
    tilt = math.radians(30)
    ring = np.column_stack(
        [math.sin(tilt) * np.cos(angles), math.sin(tilt) * np.sin(angles), np.full(24, math.cos(tilt))]
    )
    reach = np.full(24, 2.0)
    open_, closed = (patch_under(ball, 10 * ring, ring, reach, hole).layer(0.2, 1.0) for hole in (0.0, 100.0))
    assert (open_.genus(), closed.genus()) == (1, 0)


def test_a_layer_that_folds_in_a_hollow_is_refused():
    x, y = (each.ravel() for each in np.meshgrid(np.linspace(-1, 1, 9), np.linspace(-1, 1, 9)))
    places = np.column_stack([x, y, 3 - np.sqrt(9 - x**2 - y**2)])
    normals = (np.array([0, 0, 3.0]) - places) / 3
    corner = np.arange(72).reshape(8, 9)[:, :8].ravel()
    triangles = np.vstack(
        [np.column_stack([corner, corner + 1, corner + 10]), np.column_stack([corner, corner + 10, corner + 9])]
    )
    hollow = Patch(places, normals, triangles)
    assert float(hollow.layer(0.0, 2.0).volume()) > 0
    with refused(Kind.CONFLICT, "surface.region"):
        hollow.layer(0.0, 4.0)


def test_pockets_hold_their_parts_with_clearance():
    design = geometry.load_design(EXAMPLES / "fingertip.toml")
    layout = lay_out(design)
    ground = samples_of(read_body(EXAMPLES / "fingertip.step"), 1.0)
    own = {pocket.label: pocket for pocket in pockets(design, layout, ground, 2.5)}
    assert len(own) == 24 + 2 + 25
    for tube in layout.tubes[:4]:
        rod = swept(tube.course, tube.tube.outer_diameter / 2 + 0.8 * CLEARANCE)
        assert float((rod - own[tube.label].solid).volume()) < 1e-6
    assert own["tube 2 of line 1"].joins == {"shell 1", "shell 2", "tube 2 of line 1"}
    assert {"tube 1 of line 1", "tube 2 of line 1"} < own["shell 1"].joins


def test_a_facetted_body_is_read_back_from_its_files(tmp_path, ball):
    layer = cap(ball, 5.0).layer(0.1, 1.0)
    mesh = layer.to_mesh64()
    places, corners = np.asarray(mesh.vert_properties)[:, :3], np.asarray(mesh.tri_verts, np.int64)
    facets = geometry.solids.Tessellation(places, corners, np.zeros(len(corners), np.int64), math.nan)
    files = export_facets("skin", facets, 0, tmp_path, ("stl", "step", "3mf"), {"thickness": 0.9})
    assert [path.name for path in files] == ["skin.stl", "skin.3mf"]
    open_ = replace(facets, triangles=corners[1:])
    with refused(Kind.NO_RESULT):
        export_facets("open", open_, 0, tmp_path, ("stl",), {})


# -- whole arrays -----------------------------------------------------------------------------------------
def check(found, model, body, seat):
    """What every carved body must be."""
    first, template = found.bodies
    assert (found.seat, first.name, template.name) == (seat, "host" if seat == "in" else "skin", "drill-template")
    assert all(abs(each.balance) <= 1e-6 for each in found.bodies)
    assert first.openings == 0
    assert template.openings == len(model.layout.points) + len(model.layout.microphones)
    assert found.worst_clash[1] < 1e-3
    labels = {part.label for part in model.placed if part.kind not in ("spring", "sheath")}
    assert set(found.clashes) == labels | {tube.label for tube in model.layout.tubes}
    if seat == "in":
        volume = carved_bodies.solid_of(body.vertices, body.triangles).volume()
        assert first.facets.volume < volume


@pytest.mark.slow
@pytest.mark.parametrize("name", ["fingertip", "handle", "palm"])
def test_skins_of_the_examples_hold_every_part_without_a_clash(name, tmp_path):
    model, body = array_model(geometry.load_design(EXAMPLES / f"{name}.toml")), read_body(EXAMPLES / f"{name}.step")
    found = carve(model, body)
    check(found, model, body, "on")
    for each in found.bodies:
        assert export_facets(each.name, each.facets, each.genus, tmp_path, ("stl", "3mf"), each.facts)


@pytest.mark.slow
def test_pockets_in_a_fingertip_hold_every_part_and_a_moved_one_clashes(tmp_path):
    design = geometry.load_design(EXAMPLES / "fingertip.toml")
    stated = design.surface.model_copy(update={"seat": "in", "pitch": 6.5})
    body = read_body(EXAMPLES / "fingertip.step")
    start = design.model_copy(update={"surface": stated, "lines": (design.lines[0].model_copy(update={"points": 1}),)})
    fitted = geometry.surface.fit_surface(start, body).design
    model = array_model(fitted)
    found = carve(model, body)
    check(found, model, body, "in")
    shell = next(part for part in model.placed if part.label == "shell 3")
    moved = replace(shell, position=tuple(np.array(shell.position) - 0.5 * np.array(shell.axes[2])))
    first = found.bodies[0].facets
    host = carved_bodies.solid_of(first.vertices, first.triangles)
    assert model.facets.in_walls(shell, [host]) < 1e-3
    assert model.facets.in_walls(moved, [host]) > 0.1
