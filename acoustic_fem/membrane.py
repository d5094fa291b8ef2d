"""The silicone disc over a cavity: volume compliance and first resonance by elastic finite elements."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem.axisymmetric_elasticity import ElasticDisc, solve_dimensionless
from acoustic_fem.checks import in_range, positive
from acoustic_fem.units import metres, pascals
from geometry.design import ArrayDesign

_cached_disc = lru_cache(maxsize=256)(solve_dimensionless)


@dataclass(frozen=True, eq=False)
class DiscSolution:
    """Linear elastic behaviour of a disc in vacuo.

    Attributes:
        static_compliance: volume swept by the lower face over the opening per pressure on it, m^3/Pa.
        first_frequency: of the first axisymmetric mode, Hz.
        modal_mass: acoustic mass of that mode, scaled to sweep unit volume, kg/m^4.
        radius: (n,) radii over the opening, m.
        deflection: (n,) static displacement of the lower face per pressure on it, outwards, m/Pa.
    """

    static_compliance: float
    first_frequency: float
    modal_mass: float
    radius: NDArray[np.float64]
    deflection: NDArray[np.float64]

    def compliance(self, frequency: ArrayLike, loss_factor: float = 0.0) -> NDArray[np.complex128]:
        """C(w) = C0 / (1 + j eta - (w / w1)^2), m^3/Pa: the first mode carries the static compliance.

        Valid well below the first resonance, f < f1 / 3; above that it warns. The loss factor is that of
        the modulus, E (1 + j eta).

        Args:
            frequency: Hz, any shape.
            loss_factor: eta, 0 to 1.

        Raises:
            ValueError: a frequency that is not finite and positive, or a loss factor out of range.
        """
        frequency = positive("frequency", frequency, "Hz")
        in_range("loss_factor", loss_factor, 0, 1)
        if frequency.size and frequency.max() > self.first_frequency / 3:
            warnings.warn(
                f"membrane: {frequency.max():.4g} Hz is above a third of its first resonance in vacuo "
                f"({self.first_frequency:.4g} Hz); its compliance is a single mode there",
                stacklevel=2,
            )
        dynamic = 1 + 1j * loss_factor - (frequency / self.first_frequency) ** 2
        return np.asarray(self.static_compliance / dynamic, dtype=np.complex128)


def solve_disc(
    radius: float,
    thickness: float,
    youngs_modulus: float,
    poisson_ratio: float = 0.49,
    rim_width: float = 0.0,
    density: float = 1070.0,
) -> DiscSolution:
    """Axisymmetric mixed elasticity (Q2-Q1) of a disc loaded by pressure on its lower face.

    Small displacements, no pre-stress. Converged to 2e-4 in compliance. A clamped lateral face is stiffer
    than a glued rim: at a = 3 mm, h = 0.5 mm the rim is 36 % softer.

    Args:
        radius: of the opening, m.
        thickness: m, 0.01 to 2 radii.
        youngs_modulus: Pa.
        poisson_ratio: 0.01 to 0.49999.
        rim_width: 0: lateral face clamped; above 0: disc of radius + rim_width, glued on its lower face
            along the rim, other faces free; m, at least 0.05 thicknesses and at most 50 radii.
        density: kg/m^3.

    Raises:
        ValueError: a value that is not finite or out of range.
    """
    for name, value, unit in (
        ("radius", radius, "m"),
        ("youngs_modulus", youngs_modulus, "Pa"),
        ("density", density, "kg/m^3"),
    ):
        positive(name, value, unit)
    # limits stated in millimetres are kept after conversion
    less, more = 1 - 1e-9, 1 + 1e-9
    in_range("thickness", thickness, 0.01 * radius * less, 2 * radius * more, "m")
    in_range("poisson_ratio", poisson_ratio, 0.01, 0.49999)
    if rim_width != 0:
        in_range("rim_width", rim_width, 0.05 * thickness * less, 50 * radius * more, "m")
    # rounding lets equal discs in different units share one solution
    disc: ElasticDisc = _cached_disc(round(thickness / radius, 12), float(poisson_ratio), round(rim_width / radius, 12))
    return DiscSolution(
        static_compliance=disc.compliance * radius**3 / youngs_modulus,
        first_frequency=float(np.sqrt(disc.eigenvalue * youngs_modulus / density)) / (2 * np.pi * radius),
        modal_mass=disc.modal_mass * density / radius,
        radius=disc.radius * radius,
        deflection=disc.deflection * radius / youngs_modulus,
    )


def disc_compliance(
    radius: float, thickness: float, youngs_modulus: float, poisson_ratio: float = 0.49, rim_width: float = 0.0
) -> float:
    """Static volume compliance of a disc, m^3/Pa; arguments and errors as :func:`solve_disc`."""
    return solve_disc(radius, thickness, youngs_modulus, poisson_ratio, rim_width).static_compliance


def design_disc(design: ArrayDesign) -> DiscSolution:
    """The membrane of a design.

    Raises:
        ValueError: proportions outside what :func:`solve_disc` covers.
    """
    material = design.material(design.membrane.material)
    return solve_disc(
        metres(design.resonator.cavity_diameter) / 2,
        metres(design.membrane.thickness),
        pascals(material.youngs_modulus),
        material.poisson_ratio,
        metres(design.membrane.rim_width),
        material.density,
    )


def design_compliance(design: ArrayDesign, frequency: ArrayLike) -> NDArray[np.complex128]:
    """Volume compliance of a design's membrane with the loss factor of its material, m^3/Pa."""
    return design_disc(design).compliance(frequency, design.material(design.membrane.material).loss_factor)
