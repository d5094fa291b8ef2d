"""Bodies from files: what they are, and one line for each of those that cannot carry an array."""

from functools import partial
from pathlib import Path

import bodies
import cadquery as cq
import numpy as np
import pytest
import trimesh
from refusals import check_messages, refused

from geometry import Kind
from geometry.body import read_body, samples_of

HERE = Path(__file__).parent


def mesh_file(folder, mesh, name="body.stl"):
    path = folder / name
    mesh.export(path)
    return path


def ball(radius=10.0, subdivisions=4):
    return trimesh.creation.icosphere(subdivisions=subdivisions, radius=radius)


@pytest.mark.parametrize("ending", ["stl", "ply", "obj", "3mf"])
def test_a_mesh_is_read_as_it_was_written(tmp_path, ending):
    mesh = ball()
    body = read_body(mesh_file(tmp_path, mesh, f"body.{ending}"))
    assert len(body.triangles) == len(mesh.faces)
    assert len(body.vertices) == len(mesh.vertices)
    assert body.extent == pytest.approx([20, 20, 20], rel=1e-3)


def test_a_step_file_keeps_the_numbers_of_its_faces(tmp_path):
    body = read_body(bodies.written(cq.Workplane().box(10, 20, 30), tmp_path / "box.step"))
    assert sorted(set(body.faces.tolist())) == [1, 2, 3, 4, 5, 6]
    assert body.extent == pytest.approx([10, 20, 30])


def painted(kind):
    """A box of 12 facets as a text, of which the first four are painted otherwise than the others."""
    box = trimesh.creation.box((10, 20, 30))
    corners = [" ".join(map(repr, map(float, place))) for place in box.vertices]
    if kind == "obj":
        rows = [f"usemtl {'pad' if k < 4 else 'rest'}\nf {' '.join(map(str, f + 1))}" for k, f in enumerate(box.faces)]
        return box, "\n".join([*(f"v {corner}" for corner in corners), *rows])
    if kind == "ply":
        head = ["ply", "format ascii 1.0", "element vertex 8", *(f"property float {axis}" for axis in "xyz")]
        head += ["element face 12", "property list uchar int vertex_indices"]
        head += [*(f"property uchar {colour}" for colour in ("red", "green", "blue")), "end_header"]
        rows = [f"3 {' '.join(map(str, f))} {255 if k < 4 else 0} 9 9" for k, f in enumerate(box.faces)]
        return box, "\n".join([*head, *corners, *rows, ""])
    solids = []
    for name, faces in (("pad", box.faces[:4]), ("rest", box.faces[4:])):
        loops = ["outer loop\n" + "\n".join(f"vertex {corners[k]}" for k in f) + "\nendloop" for f in faces]
        solids.append(f"solid {name}\n" + "\n".join(f"facet normal 0 0 0\n{loop}\nendfacet" for loop in loops))
    return box, "\n".join(f"{solid}\nendsolid" for solid in solids)


@pytest.mark.parametrize("kind", ["obj", "ply", "stl"])
def test_painted_groups_of_a_mesh_are_its_faces(tmp_path, kind):
    box, text = painted(kind)
    (tmp_path / f"box.{kind}").write_text(text, encoding="utf-8")
    body = read_body(tmp_path / f"box.{kind}")
    assert np.bincount(body.faces).tolist() == [0, 8, 4]  # the largest first
    own = {tuple(sorted(map(tuple, np.round(box.vertices[f], 6).tolist()))) for f in box.faces[:4]}
    found = body.vertices[body.triangles[body.faces == 2]]
    assert {tuple(sorted(map(tuple, np.round(facet, 6).tolist()))) for facet in found} == own
    assert set(samples_of(body, 2.0).faces.tolist()) == {1, 2}


def test_units_of_a_mesh_are_as_stated(tmp_path):
    path = mesh_file(tmp_path, ball(radius=0.01))
    assert read_body(path, unit="m").extent == pytest.approx([20, 20, 20], rel=1e-3)


def test_one_of_several_skins_is_chosen_by_size(tmp_path):
    two = trimesh.util.concatenate([ball(5.0), ball(10.0).apply_translation([40, 0, 0])])
    path = mesh_file(tmp_path, two)
    assert read_body(path, skin=1).extent == pytest.approx([20, 20, 20], rel=1e-3)
    small = read_body(path, skin=2)
    assert small.extent == pytest.approx([10, 10, 10], rel=1e-3)
    assert small.findings == ("skin 2 of 2 is used",)


def test_facets_of_no_area_are_left_out_and_told(tmp_path):
    mesh = ball()
    sliver = np.array([[mesh.faces[0, 0], mesh.faces[0, 0], mesh.faces[0, 1]]])
    mesh = trimesh.Trimesh(mesh.vertices, np.vstack([mesh.faces, sliver]), process=False)
    assert read_body(mesh_file(tmp_path, mesh)).findings == ("1 facet of no area left out",)


# -- the smooth surface --------------------------------------------------------------------------------
def test_samples_of_a_ball_know_its_radius_and_area(tmp_path):
    samples = samples_of(read_body(mesh_file(tmp_path, ball(10.0, 5))), 0.8)
    assert samples.areas.sum() == pytest.approx(4 * np.pi * 100, rel=2e-3)
    assert np.median(samples.bend(2.0)) == pytest.approx(0.1, rel=0.12)  # the largest of its neighbourhood
    lifted = samples.lifted(2.0)
    assert lifted.areas.sum() == pytest.approx(4 * np.pi * 144, rel=3e-3)
    places, normals = lifted.projected(np.array([[0, 0, 15.0], [9.0, 0, 9.0], [0, -11.0, 0]]))
    assert np.linalg.norm(places, axis=1) == pytest.approx([12, 12, 12], abs=0.05)
    np.testing.assert_allclose(normals, places / np.linalg.norm(places, axis=1, keepdims=True), atol=0.01)


def test_places_are_projected_onto_a_ball(tmp_path):
    samples = samples_of(read_body(mesh_file(tmp_path, ball(10.0, 5))), 0.8)
    places = np.random.default_rng(0).normal(size=(200, 3))
    places *= 10.3 / np.linalg.norm(places, axis=1, keepdims=True)
    assert np.abs(np.linalg.norm(samples.projected(places)[0], axis=1) - 10).max() < 0.05


def test_both_sides_of_a_thin_plate_are_apart(tmp_path):
    samples = samples_of(read_body(bodies.written(cq.Workplane().box(60, 60, 1.0), tmp_path / "plate.step")), 1.5)
    inner = (np.abs(samples.places[:, :2]) < 20).all(axis=1)
    assert samples.bend(3.0)[inner].max() < 1e-3
    places, normals = samples.projected(np.array([[0.0, 0.0, 0.8], [3.0, 2.0, -0.9]]))
    np.testing.assert_allclose(places[:, 2], [0.5, -0.5], atol=1e-6)
    np.testing.assert_allclose(normals[:, 2], [1, -1], atol=1e-6)


# -- bodies that are refused ---------------------------------------------------------------------------
def without_facets(mesh, count):
    return trimesh.Trimesh(mesh.vertices, mesh.faces[count:], process=False)


def forked():
    box = trimesh.creation.box([20, 20, 20])
    fin = np.array([[box.faces[0, 0], box.faces[0, 1], len(box.vertices)]])
    return trimesh.Trimesh(np.vstack([box.vertices, [[0, 0, 40]]]), np.vstack([box.faces, fin]), process=False)


def crossing():
    """A ball whose pole is pushed through the other side."""
    mesh = ball()
    places = mesh.vertices.copy()
    places[int(np.argmax(places[:, 2]))] = [1.3, 0.7, -14.0]
    return trimesh.Trimesh(places, mesh.faces, process=False)


def crossing_everywhere():
    """A ball whose corners are exchanged, so that nearly all facets cross."""
    mesh = ball(subdivisions=5)
    return trimesh.Trimesh(np.random.default_rng(0).permutation(mesh.vertices), mesh.faces, process=False)


def one_facet_turned():
    mesh = ball()
    faces = mesh.faces.copy()
    faces[0] = faces[0][::-1]
    return trimesh.Trimesh(mesh.vertices, faces, process=False)


def turned_inside_out():
    mesh = ball()
    return trimesh.Trimesh(mesh.vertices, mesh.faces[:, ::-1], process=False)


def text_file(name, text):
    def make(folder):
        (folder / name).write_text(text, encoding="utf-8")
        return folder / name

    return make


def of_mesh(make):
    return lambda folder: mesh_file(folder, make())


def surface_only(folder):
    face = cq.Workplane().rect(20, 20).extrude(1).faces(">Z").val()
    return bodies.written(cq.Workplane(obj=face), folder / "body.step")


def two_solids(folder):
    both = cq.Compound.makeCompound([cq.Solid.makeBox(9, 9, 9), cq.Solid.makeBox(9, 9, 9, cq.Vector(20, 0, 0))])
    return bodies.written(cq.Workplane(obj=both), folder / "body.step")


STEP = "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n"
PLY = (
    "ply\nformat ascii 1.0\nelement vertex 1000000000000\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n"
)
REFUSED = {
    "open": of_mesh(lambda: without_facets(ball(), 3)),
    "forked": of_mesh(forked),
    "crossing": of_mesh(crossing),
    "crossing everywhere": of_mesh(crossing_everywhere),
    "a facet that faces the other way": of_mesh(one_facet_turned),
    "inside out": of_mesh(turned_inside_out),
    "two skins": of_mesh(lambda: trimesh.util.concatenate([ball(5.0), ball(5.0).apply_translation([30, 0, 0])])),
    "in metres": of_mesh(lambda: ball(0.01)),
    "in micrometres": of_mesh(lambda: ball(10_000.0)),
    "a text named STL": text_file("body.stl", "this is no mesh"),
    "an empty OBJ": text_file("body.obj", ""),
    "corners that are no numbers": text_file("body.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
    "a text named STEP": text_file("body.step", "this is no body"),
    "a STEP of a surface": surface_only,
    "a STEP of two solids": two_solids,
    "a STEP of a coordinate that is no number": text_file("body.step", f"{STEP}#1 = CARTESIAN_POINT('',(nan,0.,0.));"),
    "a PLY that claims too much": text_file("body.ply", PLY),
    "a drawing": text_file("body.dxf", "0\nEOF\n"),
    "no file": lambda folder: folder / "nothing.stl",
}


def refused_body(make, folder):
    read_body(make(folder), least=3.0)


@pytest.mark.slow  # a process that reads each file
def test_a_body_that_cannot_carry_an_array_ends_in_one_line(tmp_path):
    cases = {name: partial(refused_body, make, tmp_path) for name, make in REFUSED.items()}
    check_messages(HERE / "messages.txt", cases, hidden={f"{tmp_path}/": ""})


@pytest.mark.slow
def test_a_step_file_at_which_the_cad_kernel_may_crash_is_refused(tmp_path):
    """The parentheses overflow its stack, or it gives up before: that depends on what lies on the stack."""
    body = text_file("body.step", f"{STEP}#1 = X({'(' * 10**5}{')' * 10**5});")(tmp_path)
    with refused(Kind.UNREADABLE, file="body.step"):
        read_body(body)
