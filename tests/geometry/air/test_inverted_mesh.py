"""Meshes with elements turned inside out are refused wherever they come from."""

import cadquery as cq
import numpy as np
import pytest
from reference_data import AIR
from refusals import refused

from acoustic_fem.cell.condensed import AirModel, BodyFaces, condense
from acoustic_fem.numerics.rational_sweep import passivity_margin
from geometry.air.mesh import InvertedElementsError, MeshSizes, SolidMesh, mesh_solid
from geometry.ground.refusal import Kind


@pytest.fixture(scope="module")
def mesh():
    return mesh_solid(cq.Solid.makeBox(1, 1, 1), {"a": (0.5, 0.5, 0.0)}, (), MeshSizes(1, 1, 0.5, 0.4))


def altered(mesh, nodes=None, tetrahedra=None):
    return SolidMesh(
        mesh.nodes if nodes is None else nodes,
        mesh.tetrahedra if tetrahedra is None else tetrahedra,
        mesh.faces,
        mesh.normals,
        mesh.volume,
        mesh.mesh_volume,
    )


def test_a_tetrahedron_with_two_corners_exchanged_is_refused_with_its_place(mesh):
    flipped = mesh.tetrahedra.copy()
    flipped[3] = flipped[3][[1, 0, 2, 3, 4, 6, 5, 8, 7, 9]]
    with refused(Kind.NO_RESULT, error=InvertedElementsError) as found:
        altered(mesh, tetrahedra=flipped)
    assert "tetrahedron 3 at (" in str(found.value)


def test_a_corner_pushed_through_its_neighbours_is_refused(mesh):
    corner = inner_nodes(mesh, mesh.tetrahedra[:, :4])[0]
    nodes = mesh.nodes.copy()
    nodes[corner] += 2.0
    with refused(Kind.NO_RESULT, error=InvertedElementsError):
        altered(mesh, nodes=nodes)


def inner_nodes(mesh, among):
    """Nodes off the boundary."""
    free = ((mesh.nodes > 0.01) & (mesh.nodes < 0.99)).all(axis=1)
    return np.intersect1d(np.flatnonzero(free), among)


def test_a_curved_edge_is_refused_before_it_costs_accuracy(mesh):
    """Its middle is moved further and further: the corners stay where they were, and so does the volume."""
    middle = inner_nodes(mesh, mesh.tetrahedra[:, 4:])[0]
    refused = []
    for shift in (0.0, 0.01, 0.03, 0.1, 0.3):
        nodes = mesh.nodes.copy()
        nodes[middle] += shift * np.array([0.6, -0.64, 0.48])
        try:
            bent = altered(mesh, nodes=nodes)
        except InvertedElementsError:
            refused.append(shift)
            continue
        body = condense(bent, bent, BodyFaces(["a"]), AirModel(AIR, (0.1, 100.0)))
        admittance = body.nodal_admittance(np.array([0.1, 100.0]))
        assert passivity_margin(admittance).min() > -1e-12
        stored = admittance[0, 0, 0] / (2j * np.pi * 0.1 * 1e-9 / AIR.pressure)
        assert stored.real == pytest.approx(1, rel=1e-4)
        assert -0.01 < stored.imag < 0
    assert 0.3 in refused
    assert 0.01 not in refused
