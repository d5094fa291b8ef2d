"""Curved meshes of cells: volumes, named faces and the traps of meshing."""

import tempfile

import cadquery as cq
import numpy as np
import pytest
from refusals import refused

from geometry.air.cells import Cell, canonical_ports
from geometry.air.mesh import WALL, MeshError, MeshSizes, mesh_solid
from geometry.air.volume import MIDPLANE, MIRROR, OPENING, air_volume
from geometry.ground.refusal import Kind
from geometry.schema.ports import CellPort

SIZES = MeshSizes(mouth_edge=0.4, tube=0.8, growth=0.7, largest=1.0)
resource = pytest.importorskip("resource")
STRAIGHT = Cell("resonator", 6.0, 2.5, 1.25, (CellPort(0.0, 0.5), CellPort(180.0, 0.5)), 6.0, 0.0)
CHAMBER = Cell("microphone", 2.2, 1.3, 0.65, (CellPort(0.0, 0.44), CellPort(120.0, 0.44)), 0.5, 0.3)


def straight_volume(mesh):
    """Volume of the same elements with straight edges."""
    corners = mesh.nodes[mesh.tetrahedra[:, :4]]
    return np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1])).sum() / 6


@pytest.mark.parametrize("cell", [STRAIGHT, CHAMBER], ids=["resonator", "microphone"])
def test_curved_elements_hold_the_cad_volume_where_straight_ones_lose_it(cell):
    mesh = mesh_of(air_volume(cell))
    assert mesh.mesh_volume == pytest.approx(mesh.volume, rel=2e-4)
    assert straight_volume(mesh) < mesh.volume * 0.995


def test_without_room_for_temporary_files_no_half_of_a_solid_is_meshed(tmp_path, monkeypatch):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    air = air_volume(STRAIGHT)
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, hard))
    try:
        with pytest.raises(OSError, match="set TMPDIR") as caught:
            mesh_of(air)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert caught.value.filename == str(tmp_path)


def mesh_of(air):
    return mesh_solid(air.solid, air.faces, tuple(air.ports), SIZES)


@pytest.mark.parametrize(
    ("height", "second", "parts"), [(None, 180.0, 4), (1.0, 180.0, 2), (None, 90.0, 2), (1.0, 90.0, 1)]
)
def test_air_of_a_symmetric_cell_is_cut_at_each_of_its_mirror_planes(height, second, parts):
    cell = Cell("resonator", 6.0, 2.5, 1.25, tuple(CellPort(a, 0.5, height) for a in (0.0, second)), 6.0, 0.0)
    stubs = 2 * np.pi * 0.25**2 * cell.ports[0].stub_length
    # The stub starts on the curved wall, up to a^2 / (2 R) behind the point where its axis meets it.
    assert parts * air_volume(cell).solid.Volume() == pytest.approx(np.pi * 9 * 2.5 + stubs, rel=2e-4)


def test_ports_membrane_and_mirror_are_named_with_their_area_and_outward_normal():
    mesh = mesh_of(air_volume(STRAIGHT))
    assert set(mesh.faces) == {"port-0", "port-1", OPENING, MIRROR, MIDPLANE, WALL}
    np.testing.assert_allclose(mesh.normals["port-0"], [1, 0, 0], atol=1e-12)
    np.testing.assert_allclose(mesh.normals["port-1"], [-1, 0, 0], atol=1e-12)
    np.testing.assert_allclose(mesh.normals[OPENING], [0, 0, 1], atol=1e-12)
    np.testing.assert_allclose(mesh.normals[MIRROR], [0, -1, 0], atol=1e-12)
    np.testing.assert_allclose(mesh.normals[MIDPLANE], [0, 0, -1], atol=1e-12)
    corners = mesh.nodes[mesh.faces[OPENING]]
    np.testing.assert_allclose(corners[..., 2], 2.5, atol=1e-9)
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
    assert area == pytest.approx(np.pi * 9 / 2, rel=0.02)


def test_mirror_plane_does_not_count_as_a_wall_of_the_tubes():
    """It did once: the whole plane was meshed as finely as a tube."""
    half = mesh_of(air_volume(STRAIGHT))
    turned = Cell("resonator", 6.0, 2.5, 1.25, (CellPort(0.0, 0.5), CellPort(179.5, 0.5)), 6.0, 0.0)
    assert len(half.tetrahedra) < 0.7 * len(mesh_of(air_volume(turned)).tetrahedra)


def test_no_tetrahedron_keeps_three_faces_on_the_wall_of_a_box():
    box = cq.Solid.makeBox(2, 2, 2)
    mesh = mesh_solid(box, {"port": (0.0, 1.0, 1.0)}, (), MeshSizes(1, 1, 0.5, 1.5))
    boundary = {tuple(sorted(t)) for part in mesh.faces.values() for t in part.tolist()}
    on_wall = [
        sum(tuple(sorted(int(c) for c in np.delete(e[:4], k))) in boundary for k in range(4)) for e in mesh.tetrahedra
    ]
    assert max(on_wall) <= 2
    assert mesh.mesh_volume == pytest.approx(8.0, rel=1e-12)


@pytest.mark.parametrize(
    ("solid", "ports", "kind", "field"),
    [
        (cq.Solid.makeBox(1, 1, 1), {"a": (9.0, 0.0, 0.0)}, Kind.UNSUITABLE, "faces.a"),
        (cq.Solid.makeBox(1, 1, 1), {"edge": (0.0, 0.0, 0.5)}, Kind.UNSUITABLE, "faces.edge"),
        (cq.Solid.makeCylinder(1, 1), {"side": (1.0, 0.0, 0.5)}, Kind.UNSUITABLE, "faces.side"),
        (cq.Solid.makeCylinder(1, 1), {"side": (-1.0, 0.0, 0.5)}, Kind.UNSUITABLE, "faces.side"),
        (cq.Solid.makeBox(1, 1, 1), {"a": (0.0, 0.5, 0.5), "b": (0.0, 0.4, 0.5)}, Kind.CONFLICT, "faces"),
        (
            cq.Compound.makeCompound([cq.Solid.makeBox(1, 1, 1), cq.Solid.makeBox(1, 1, 1).moved(x=5)]),
            {"a": (0.0, 0.5, 0.5)},
            Kind.UNSUITABLE,
            "solid",
        ),
    ],
    ids=["off the solid", "on an edge", "on a seam", "curved face", "one face twice", "two solids"],
)
def test_ports_that_name_no_single_flat_face_are_refused(solid, ports, kind, field):
    with refused(kind, field, error=MeshError):
        mesh_solid(solid, ports, (), SIZES)


def test_overlapping_ports_are_refused():
    cell = Cell("resonator", 3.0, 2.0, 1.0, (CellPort(0.0, 0.6), CellPort(5.0, 0.6)), 3.0, 0.0)
    with refused(Kind.CONFLICT):
        air_volume(cell)


def test_rotated_mirrored_and_reordered_ports_are_one_cell():
    first, order = canonical_ports([CellPort(10.0, 0.4), CellPort(100.0, 0.6)])
    for angles, bores in (((200.0, 110.0), (0.4, 0.6)), ((110.0, 200.0), (0.6, 0.4)), ((0.0, 270.0), (0.6, 0.4))):
        ports, other = canonical_ports([CellPort(a, b) for a, b in zip(angles, bores, strict=True)])
        assert ports == first
        assert [ports[k].bore_diameter for k in other] == list(bores)
    assert [first[k].bore_diameter for k in order] == [0.4, 0.6]
