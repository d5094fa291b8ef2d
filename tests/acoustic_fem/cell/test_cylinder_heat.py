"""The thermal field of a cylinder with bores, from its sections, against closed forms and a mesh of the body."""

import numpy as np
import pytest
import skfem
from reference_data import AIR
from scipy.special import jv

from acoustic_fem.cavity.closed_forms import closed_cylinder_compliance
from acoustic_fem.cell.one_cell import CHECKED_UP_TO, marked_solid
from acoustic_fem.fields.cylinder_heat import CylinderAir, SideBore, cylinder_field
from acoustic_fem.fields.diffusion import diffusion_field, field_coefficients
from acoustic_fem.fields.element_sizes import mesh_sizes
from geometry.air.cells import Cell
from geometry.schema.cavity_shapes import Dome
from geometry.schema.ports import CellPort

BAND = (1.0, 2000.0)
GRID = np.geomspace(*BAND, 12)
HEAT = AIR.thermal_diffusivity


@pytest.mark.physics
@pytest.mark.parametrize(
    ("radius", "height", "highest"), [(3.0, 2.5, 2e3), (1.1, 1.9, 2e3), (10.0, 5.0, 2e3), (3.59, 5.615, 500.0)]
)
def test_the_closed_cylinder_is_that_of_the_series(radius, height, highest):
    """A bore that is next to nothing leaves the closed cylinder; of the last one, places differ in the last bits."""
    field = cylinder_field(CylinderAir(radius, height, (SideBore(1e-3, 1e-3, height / 2),)), HEAT, (1.0, highest))
    grid = np.geomspace(1.0, highest, 12)
    mean = field.mean(grid, HEAT)
    compliance = np.pi * radius**2 * height * 1e-9 * (AIR.gamma - (AIR.gamma - 1) * mean) / (AIR.gamma * AIR.pressure)
    exact = closed_cylinder_compliance(radius * 1e-3, height * 1e-3, grid, AIR)
    np.testing.assert_allclose(compliance, exact, rtol=1e-5)


@pytest.mark.physics
def test_a_bore_is_a_long_one():
    """<Psi> = 1 - 2 J1(k a) / (k a J0(k a)), k^2 = -j w / alpha (Zwikker and Kosten 1949)."""
    bore = 0.5
    field = cylinder_field(CylinderAir(2.0, 1.5, (SideBore(bore, 5e5, 0.75),)), HEAT, BAND)
    k = np.sqrt(-2j * np.pi * GRID / HEAT) * bore * 1e-3
    found = field_coefficients(field.model, GRID, HEAT) @ field.means[1]
    np.testing.assert_allclose(found, 1 - 2 * jv(1, k) / (k * jv(0, k)), atol=2e-5)


@pytest.mark.physics
@pytest.mark.slow
@pytest.mark.parametrize(
    "cell",
    [
        Cell("microphone", 2.185, 1.909, 0.955, (CellPort(0.0, 0.714),), 0.5, 0.3),
        Cell("resonator", 3.0, 2.0, 0.7, (CellPort(0.0, 0.9), CellPort(90.0, 0.5)), 3.0, 0.0),
    ],
    ids=["chamber", "resonator"],
)
def test_openings_add_what_they_add_in_a_mesh_of_the_whole_body(cell):
    """Without them the wide ones would be off by several times the error stated."""
    solid, grid = marked_solid(cell), np.geomspace(1.0, CHECKED_UP_TO, 8)
    mesh = solid.mesh(mesh_sizes(0.5, cell.smallest_extent, AIR, CHECKED_UP_TO)[1], lambda: None)
    exact = diffusion_field(mesh, solid.faces.open, HEAT, (1.0, CHECKED_UP_TO)).mean(grid, HEAT)
    air = solid.cylinder
    assert air.volumes.sum() == pytest.approx(mesh.volume * 2 ** len(solid.faces.planes), rel=1e-4)
    found = cylinder_field(air, HEAT, (1.0, CHECKED_UP_TO)).mean(grid, HEAT)
    unopened = sum(bore.radius**3 for bore in air.bores) / air.volumes.sum()
    assert np.abs(found - exact).max() < air.mean_error < unopened


def test_the_mean_over_a_mesh_of_the_body_is_that_of_the_field():
    """However coarse the mesh, and whatever part of the layer its quadrature points meet."""
    air = CylinderAir(1.0, 1.0, (SideBore(0.2, 0.5, 0.5),))
    field = cylinder_field(air, HEAT, BAND)
    box = skfem.MeshTet2.from_mesh(skfem.MeshTet.init_tensor(*[np.linspace(-0.7, 0.7, 5)] * 2, np.linspace(0, 1, 4)))
    flow = skfem.Basis(box, skfem.ElementTetP1(), intorder=4)
    volume = flow.dx.sum(axis=1)
    mean = field_coefficients(field.model, GRID, HEAT) @ (field.means_over(flow) @ volume / volume.sum())
    np.testing.assert_allclose(mean, field.mean(GRID, HEAT), rtol=1e-10)


def test_only_a_cylinder_is_told_as_one():
    ports = (CellPort(0.0, 0.5), CellPort(180.0, 0.5))
    assert marked_solid(Cell("resonator", 6.0, 2.5, 1.25, ports, 6.0, 0.0)).cylinder is not None
    assert marked_solid(Cell("resonator", 6.0, 2.5, 1.25, ports, 6.0, 0.0, Dome(0.5))).cylinder is None
