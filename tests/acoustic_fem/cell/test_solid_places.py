"""Bodies of air that lie far from the origin, and tubes that end at a wall."""

import cadquery as cq
import numpy as np
import pytest
import skfem
from reference_data import AIR
from refusals import refused

from acoustic_fem.cell.solid import port_admittance, solve_solid
from acoustic_fem.duct import plane_wave
from acoustic_fem.fields.assembly import surface_basis
from geometry.air.mesh import MeshError
from geometry.ground.refusal import Kind

BODY = cq.Workplane().box(4, 3, 2).union(cq.Workplane("YZ").circle(0.25).extrude(3.2))
PORT = np.array([3.2, 0.0, 0.0])


@pytest.mark.parametrize("place", [(0.0, 0.0, 0.0), (60.0, 0.0, 0.0), (0.0, -100.0, 40.0), (1e3, 2e3, 3e3)], ids=str)
def test_facets_of_small_curved_elements_are_found_wherever_they_lie(place):
    mesh = skfem.MeshTet2.from_mesh(skfem.MeshTet().refined(2).scaled(0.2)).translated(place)
    basis = skfem.Basis(mesh, skfem.ElementTetP2(), intorder=4)
    surface = surface_basis(basis, mesh.boundary_facets())
    assert float(surface.dx.sum()) == pytest.approx(6 * 0.2**2, rel=1e-9)
    middle = np.asarray(surface.global_coordinates()).reshape(3, -1).mean(axis=1)
    assert middle - place == pytest.approx([0.1] * 3, rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("fidelity", ["navier-stokes", "helmholtz"])
def test_a_body_answers_alike_wherever_it_was_drawn(fidelity):
    found = [
        port_admittance(
            BODY.translate(tuple(place)), {"mouth": tuple(PORT + place)}, [1.0, 30.0], AIR, fidelity, accuracy=3e-3
        )
        for place in (np.zeros(3), np.array([60.0, 0, 0]), np.array([0, 100.0, 30.0]), np.array([-1e5, 2e4, 300.0]))
    ]
    for each in found[1:]:
        np.testing.assert_allclose(each, found[0], rtol=1e-3)  # meshes differ by rounding


@pytest.mark.parametrize("port", [(3.2, 0.0, 0.0), (64.0, 0.0, 0.0)], ids=str)
def test_a_port_beside_its_body_is_named_where_the_caller_has_it(port):
    with refused(Kind.UNSUITABLE, "faces.mouth", port, error=MeshError):
        solve_solid(BODY.translate((60, 0, 0)), {"mouth": port}, (1.0, 10.0), AIR)


@pytest.mark.slow
@pytest.mark.parametrize("place", [0.0, 80.0])
@pytest.mark.parametrize("along", ["XY", "YZ", "XZ"])
def test_a_tube_that_ends_at_a_wall_is_the_exact_duct_with_a_rigid_end(along, place):
    tube = cq.Workplane(along).circle(0.5).extrude(20).translate((place, 0, 0))
    frequency = np.array([10.0, 100.0])
    duct = plane_wave.port_admittance(5e-4, 20e-3, frequency, AIR)
    exact = duct[:, 0, 0] - duct[:, 0, 1] * duct[:, 1, 0] / duct[:, 1, 1]
    found = port_admittance(tube, {"mouth": (place, 0, 0)}, frequency, AIR, accuracy=3e-3)
    np.testing.assert_allclose(found[:, 0, 0], exact, rtol=3e-3)
