"""A cell that is halved at the plane of its tubes, below a membrane, against the same elements on both sides of it."""

from dataclasses import replace

import numpy as np
import pytest
from reference_data import AIR

from acoustic_fem.cell.condensed import AirModel, condense
from acoustic_fem.cell.one_cell import marked_solid
from acoustic_fem.fields.cylinder_heat import cylinder_field
from acoustic_fem.fields.element_sizes import mesh_sizes
from geometry.air.cells import Cell
from geometry.air.mesh import WALL, SolidMesh
from geometry.air.volume import MIDPLANE, OPENING
from geometry.schema.ports import CellPort

BAND = (1.0, 500.0)
FREQUENCY = np.geomspace(*BAND, 7)


def both_sides(half, height):
    """The mesh and its mirror image at half the height, of which no wall moves."""
    on_plane = np.abs(half.nodes[:, 2] - height / 2) < 1e-9
    image = np.where(on_plane, np.arange(len(half.nodes)), len(half.nodes) + np.cumsum(~on_plane) - 1)
    reflected = half.nodes[~on_plane] * [1, 1, -1] + [0, 0, height]
    # Two corners change places, so that no element is turned inside out; their edges do with them.
    turned = image[half.tetrahedra][:, [1, 0, 2, 3, 4, 6, 5, 8, 7, 9]]
    faces = {
        name: np.concatenate([tri, image[tri]])
        for name, tri in half.faces.items()
        if name not in (OPENING, WALL, MIDPLANE)
    }
    faces[OPENING] = half.faces[OPENING]
    faces[WALL] = np.concatenate([half.faces[WALL], image[half.faces[WALL]], image[half.faces[OPENING]]])
    nodes, tetrahedra = np.concatenate([half.nodes, reflected]), np.concatenate([half.tetrahedra, turned])
    normals = {name: normal for name, normal in half.normals.items() if name in faces}
    return SolidMesh(nodes, tetrahedra, faces, normals, 2 * half.volume, 2 * half.mesh_volume)


@pytest.mark.parametrize(("second", "copies"), [(90.0, 2), (180.0, 4)], ids=["right angle", "in line"])
@pytest.mark.slow
def test_half_a_cell_and_what_its_membrane_pumps_through_the_midplane_are_the_whole_cell(second, copies):
    """But that in half of it the pressure is zero at the midplane by its weak form alone."""
    cell = Cell("resonator", 3.0, 3.5, 1.75, (CellPort(0.0, 0.9), CellPort(second, 0.6)), 3.0, 0.0)
    solid = marked_solid(cell).shortened()
    half = solid.mesh(mesh_sizes(2.0, cell.smallest_extent, AIR, BAND[1])[0], lambda: None)
    heat = cylinder_field(solid.cylinder, AIR.thermal_diffusivity, BAND)
    air = AirModel(AIR, BAND)
    body = condense(half, heat, solid.faces, air, tolerance=1e-7)
    whole = condense(both_sides(half, cell.height), heat, replace(solid.faces, midplane=None), air, tolerance=1e-7)
    assert MIDPLANE in half.faces
    assert body.copies == copies
    answers = [each.nodal_admittance(FREQUENCY) for each in (body, whole, replace(body, pumped=None))]
    scale = np.sqrt(np.abs(np.einsum("fii->fi", answers[1])))
    found, without = (
        np.abs(each - answers[1]) / (scale[:, :, None] * scale[:, None, :]) for each in (answers[0], answers[2])
    )
    assert found.max() < 2e-5
    assert without.max() > 1e-2
