"""The flow along a bore bent to a circle, from its section alone: nothing of the 3-D solver is used.

A flow u(r, z) purely along the azimuth, driven by dp/dphi = -G, obeys mu (laplace u - u / r^2) - j w rho u = -G / r.
Weak form with the weight r: int r grad u . grad v + u v / r + s r u v = G / mu int v, s = j w / nu. The pressure drop
per length of the centre line is G / R. The thermal field, the same at every azimuth, obeys laplace Psi = s (Psi - 1),
s = j w / alpha: int r grad Psi . grad v + s r Psi v = s int r v.
"""

from __future__ import annotations

import numpy as np
import skfem
from skfem.helpers import dot, grad

from acoustic_fem.duct.meshed_section import MeshedSection

_SECTION = MeshedSection.circle(1.0, 10)


@skfem.BilinearForm
def _viscous(u, v, w):
    r = 1 + w.slope * w.x[0]
    return r * dot(grad(u), grad(v)) + w.slope**2 * u * v / r


@skfem.BilinearForm
def _conduction(u, v, w):
    return (1 + w.slope * w.x[0]) * dot(grad(u), grad(v))


@skfem.BilinearForm
def _inertia(u, v, w):
    return (1 + w.slope * w.x[0]) * u * v


@skfem.LinearForm
def _load(v, _):
    return v


def conductance_change(radius, bend_radius, frequency, medium):
    """Relative change of 1/Z' by the bend, against the straight bore on the same mesh; radii in m."""
    rates = 2j * np.pi * np.asarray(frequency) * radius**2 / medium.kinematic_viscosity
    flows = []
    for slope in (radius / bend_radius, 0.0):
        basis, inner, (viscous, inertia) = _system((_viscous, _inertia), slope)
        load = _load.assemble(basis)[inner]
        flows.append(np.array([load @ skfem.solve(viscous + s * inertia, load.astype(complex)) for s in rates]))
    return flows[0] / flows[1] - 1


def compliance_change(radius, bend_radius, frequency, medium):
    """Relative change of Y' by the bend; arguments as above."""
    rates = 2j * np.pi * np.asarray(frequency) * radius**2 / medium.thermal_diffusivity
    storages = []
    for slope in (radius / bend_radius, 0.0):
        basis, inner, (conduction, storage) = _system((_conduction, _inertia), slope)
        whole = _inertia.assemble(basis, slope=slope)
        load = (whole @ np.ones(basis.N))[inner]
        means = [s * load @ skfem.solve(conduction + s * storage, load.astype(complex)) / whole.sum() for s in rates]
        storages.append(medium.gamma - (medium.gamma - 1) * np.array(means))
    return storages[0] / storages[1] - 1


def _system(forms, slope):
    """Basis on the unit disc, its nodes off the wall, and the forms on them."""
    basis = skfem.Basis(skfem.MeshTri2(_SECTION.points.T, _SECTION.triangles.T), skfem.ElementTriP2(), intorder=8)
    inner = np.setdiff1d(np.arange(basis.N), basis.get_dofs().all())
    return basis, inner, [form.assemble(basis, slope=slope)[inner][:, inner].astype(complex) for form in forms]
