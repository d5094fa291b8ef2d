"""Matrices of a disc's half section against those of a general finite-element library, and forces of unit loads."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import skfem
from scipy.sparse import bmat, csc_array
from skfem.helpers import dot

from acoustic_fem.membrane.half_section import DiscShape, half_section

SHAPES = {
    "glued": DiscShape(0.3, 0.49, 0.4, 0.25, 0.07, 0.25),
    "clamped": DiscShape(0.3, 0.3, 0.0, 0.0, 0.0, 0.5),
    "boss": DiscShape(0.3, 0.49, 0.4, 0.4, 0.0, 0.25, (0.0, 0.5, 0.2)),
    "clamped boss": DiscShape(0.3, 0.49, 0.0, 0.0, 0.0, 0.25, (0.0, 1.0, 0.2)),
    "rim": DiscShape(0.3, 0.49999, 0.4, 0.4, 0.0, 0.25, (1.0, 1.4, 0.3)),
}


@skfem.BilinearForm
def _elastic(u: Any, v: Any, w: Any) -> Any:
    r, du, dv = w.x[0], u.grad, v.grad
    angle = (du[0, 1] + du[1, 0]) * (dv[0, 1] + dv[1, 0]) / 2
    return 2 * w["shear"] * (du[0, 0] * dv[0, 0] + du[1, 1] * dv[1, 1] + u[0] * v[0] / r**2 + angle) * r


@skfem.BilinearForm
def _stress(u: Any, v: Any, w: Any) -> Any:
    r = w.x[0]
    return (u.grad[0, 0] * v.grad[0, 0] + u.grad[1, 0] * v.grad[1, 0] + u[0] * v[0] / r**2) * r


@skfem.BilinearForm
def _dilation(u: Any, q: Any, w: Any) -> Any:
    return (u.grad[0, 0] + u.grad[1, 1] + u[0] / w.x[0]) * q * w.x[0]


@skfem.BilinearForm
def _volume(p: Any, q: Any, w: Any) -> Any:
    return p * q * w.x[0]


@skfem.BilinearForm
def _inertia(u: Any, v: Any, w: Any) -> Any:
    return dot(u, v) * w.x[0]


def _general(shape: DiscShape) -> tuple[Any, Any, Any]:
    """System, inertia and stress of scikit-fem, its free unknowns in the order of kind, radius and height."""
    section = half_section(shape, 1)
    mesh = skfem.MeshQuad.init_tensor(section.radii, section.heights)
    start, end, _ = shape.raised or (0.0, 0.0, 0.0)
    r, z = mesh.p[:, mesh.t].mean(axis=1)
    mesh = mesh.restrict(np.flatnonzero((z < shape.thickness) | ((r > start) & (r < end))))
    basis = skfem.Basis(mesh, skfem.ElementVector(skfem.ElementQuad2()), intorder=5)
    pressures = basis.with_element(skfem.ElementQuad1())
    ratio = shape.poisson_ratio
    stress = shape.prestress * _stress.assemble(basis)
    stiffness = _elastic.assemble(basis, shear=1 / (2 * (1 + ratio))) + stress
    dilation = _dilation.assemble(basis, pressures)
    volume = (1 + ratio) * (1 - 2 * ratio) / ratio * _volume.assemble(pressures)
    system = csc_array(bmat([[stiffness, -dilation.T], [-dilation, -volume]]))
    below = basis.doflocs[1] < 1e-9
    radius = basis.doflocs[0]
    held = below & (radius > 1 - 1e-9) & (radius < 1 + shape.glue + 1e-9) if shape.rim else radius > 1 - 1e-9
    along_r = np.isin(np.arange(basis.N), basis.get_dofs(elements=np.arange(mesh.nelements)).all("u^1"))
    free = np.flatnonzero(~held & ~(along_r & (radius < 1e-9)))
    free = free[np.lexsort((basis.doflocs[1][free], radius[free].round(9), ~along_r[free]))]
    last = np.lexsort((pressures.doflocs[1], pressures.doflocs[0].round(9)))
    order = np.concatenate([free, basis.N + last])
    none = csc_array((pressures.N, pressures.N))
    inertia, stress = (bmat([[each, None], [None, none]]) for each in (_inertia.assemble(basis), stress))
    system, inertia, stress = (2 * np.pi * csc_array(each)[order][:, order] for each in (system, inertia, stress))
    return system, inertia, stress


@pytest.mark.parametrize("name", SHAPES)
def test_matrices_are_those_of_a_general_library(name: str) -> None:
    found = half_section(SHAPES[name], 1).matrices()
    for one, other in zip(found, _general(SHAPES[name]), strict=True):
        assert one.shape == other.shape
        assert abs(one - other).max() <= 1e-13 * abs(other).max()


@pytest.mark.parametrize(
    ("name", "upper"),
    [
        ("glued", np.pi * 1.4**2),
        ("boss", np.pi * 1.4**2 + 2 * np.pi * 0.5 * 0.2),
        ("rim", np.pi * 1.4**2 - 2 * np.pi * 1.0 * 0.3),
    ],
)
def test_loads_push_on_the_areas_of_their_faces(name: str, upper: float) -> None:
    """The upper face and the upright wall of a raised part are free; the lower face is held at r = 1."""
    section = half_section(SHAPES[name], 1)
    below, patch, above = section.loads().T
    edge = np.diff(section.radii[section.radii < 1 + 1e-9])[-1]
    assert below.sum() == pytest.approx(np.pi - 2 * np.pi * edge / 6, rel=1e-12, abs=0)
    assert patch.sum() == pytest.approx(1.0, rel=1e-12, abs=0)
    assert above.sum() == pytest.approx(upper, rel=1e-12, abs=0)
