"""Lossy compliance of cavities that are no cylinder: the mean thermal field of a quarter of them by finite elements.

A box under a round collar and a bowl under a cylinder have no closed form of the field of
:mod:`acoustic_fem.cavity`. It is solved once per shape and air over a band, and kept on disk like the cells of a
design, so that later frequencies cost microseconds.
"""

from __future__ import annotations

from dataclasses import asdict
from functools import lru_cache

import numpy as np

from acoustic_fem.fields.diffusion import DiffusionField, diffusion_field
from acoustic_fem.fields.element_sizes import mesh_sizes
from acoustic_fem.numerics import disk_cache
from acoustic_fem.numerics.refinement import HEAT_ORDER, refined
from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.units import metres
from geometry.air.mesh import mesh_solid
from geometry.ground.argument_checks import positive_numbers
from geometry.ground.extras import installed_version
from geometry.ground.typed import Array, ComplexArray
from geometry.schema.cavity_shapes import Box, Dome, draw_cavity

#: Relative error of the compliance that the mesh is refined to, and the scale of the first one that may do.
ACCURACY = 1e-3
_SCALE = 0.9
#: The field is solved over at least this band, Hz, so that another grid finds it in the cache.
_BAND = (1.0, 500.0)
#: Part of the cache key: raise it when the mesh or the field changes.
_VERSION = 2


def shaped_cavity_compliance(
    shape: Box | Dome, radius: float, height: float, frequency: FrequencyLike, air: AirLike
) -> ComplexArray:
    """Compliance of a closed cavity of uniform pressure with isothermal walls, m^3/Pa.

    Args:
        shape: lengths in mm.
        radius: of the circle under the membrane, m.
        height: from the lowest place of the floor to the membrane, m.
        frequency: Hz, any shape.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        Shape of frequency, complex128; estimated relative error below 1e-3.

    Raises:
        Refusal: a radius, height or frequency that is not finite and positive.
        MeshError, ConvergenceError: the cavity cannot be meshed, or the meshes do not reach the accuracy.
    """
    medium = medium_of(air)
    positive_numbers("radius", radius, "m")
    positive_numbers("height", height, "m")
    grid = frequencies(frequency)
    band = (min(_BAND[0], float(grid.min())), max(_BAND[1], float(grid.max())))
    size = (radius / metres(1.0), height / metres(1.0))
    matrices, excitations, weights = _thermal_model(shape, *size, medium, band)
    rate = 2j * np.pi * grid.ravel() * metres(1.0) ** 2 / medium.thermal_diffusivity
    system = matrices[0] + rate[:, None, None] * matrices[1]
    mean = np.linalg.solve(system, rate[:, None, None] * excitations)[:, :, 0] @ weights
    volume = shape.volume(*size) * metres(1.0) ** 3
    compliance = volume * (medium.gamma - (medium.gamma - 1) * mean) / (medium.gamma * medium.pressure)
    return np.asarray(compliance, dtype=np.complex128).reshape(grid.shape)


@lru_cache(maxsize=64)
def _thermal_model(
    shape: Box | Dome, radius: float, height: float, medium: Medium, band: tuple[float, float]
) -> tuple[Array, Array, Array]:
    """Projected stiffness and mass, load, and the mean of each function: lengths in mm."""
    sizes = {"kind": type(shape).__name__, **asdict(shape), "radius": radius, "height": height}
    about = {"shaped cavity": _VERSION, "accuracy": ACCURACY, "gmsh": installed_version("gmsh")}
    key = disk_cache.key_of({**sizes, **about, "diffusivity": medium.thermal_diffusivity, "band": list(band)})
    record = disk_cache.fetch(key)
    if record is None:
        record = _solve(shape, radius, height, medium, band), {}
        disk_cache.store(key, *record)
    arrays, _ = record
    return arrays["matrices"], arrays["excitation"], arrays["weights"]


def _solve(
    shape: Box | Dome, radius: float, height: float, medium: Medium, band: tuple[float, float]
) -> dict[str, Array]:
    import cadquery as cq

    diffusivity = medium.thermal_diffusivity
    far = 2 * (radius + height)
    quarter = draw_cavity(shape, radius, height).intersect(cq.Solid.makeBox(far, far, far))
    inside, middle = 0.1 * min(radius, height), 0.5 * height
    mirrors = {"x": (0.0, inside, middle), "y": (inside, 0.0, middle)}
    width = min(height, *(shape.length, shape.width)) if isinstance(shape, Box) else height
    checked = np.geomspace(*band, 7)

    def solved_on(scale: float, advance: object) -> tuple[DiffusionField, int]:
        del advance
        mesh = mesh_solid(quarter, mirrors, (), mesh_sizes(scale, width, medium, band[1])[1])
        return diffusion_field(mesh, tuple(mirrors), diffusivity, band), len(mesh.tetrahedra)

    def change(fine: DiffusionField, coarse: DiffusionField) -> float:
        # gamma - (gamma - 1) <Psi> is at least 1 and gamma at most 5/3.
        return float(np.max(np.abs(fine.mean(checked, diffusivity) - coarse.mean(checked, diffusivity)))) * 2 / 3

    field, _, _ = refined("heat", solved_on, change, _SCALE, ACCURACY, HEAT_ORDER, lambda done: None)
    return {
        "matrices": field.model.matrices,
        "excitation": field.model.excitations[0],
        "weights": field.integrals.sum(axis=1) / field.basis.dx.sum(),
    }
