"""The membranes of a design: as a mounted disc, as a rubber, and as a bulge under the pressure of enclosed air."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from acoustic_fem.membrane.bulged import BulgeLaw, bulge_law
from acoustic_fem.membrane.disc import DiscOptions, DiscSolution, KnownDiscs, shape_of_disc, solve_disc
from acoustic_fem.membrane.half_section import DiscShape
from acoustic_fem.membrane.rubber import Rubber
from acoustic_fem.quantities.checks import FrequencyLike
from acoustic_fem.quantities.units import metres, pascals
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray


def design_disc(
    design: DesignLike, *, contact_radius: float | None = None, known: KnownDiscs | None = None
) -> DiscSolution:
    """The membrane of a design, mounted, shaped and stretched as it says; its draft is left out.

    A clamped rim does not move, however thick it is. If enclosed air bulges the membrane (``air.overpressure``), the
    modulus is divided by :func:`design_bulge_ratio`.

    Args:
        design: the array.
        contact_radius: of the patch that takes a force, m, as for :class:`DiscOptions`.
        known: discs that need not be solved.

    Raises:
        Refusal: proportions outside what :func:`solve_disc` covers, or as :func:`design_bulge_ratio`.
    """
    design = resolve_design(design)
    density = design.material(design.membrane.material).density
    sizes, options = _membrane_of(design, contact_radius)
    if design.air.overpressure:
        radius, thickness, modulus, *others = sizes
        stiffer = modulus / float(design_bulge_ratio(design, design.air.overpressure))
        return solve_disc(radius, thickness, stiffer, *others, density, options, known)
    return solve_disc(*sizes, density, options, known)


def design_bulge(design: DesignLike) -> BulgeLaw:
    """Law of the membrane of a design under a static pressure, over the floor of its cavity.

    The floor counts as flat: under a dome it is taken where the bowl begins.

    Args:
        design: the array.

    Raises:
        Refusal: a membrane that is stretched or not flat.
    """
    design = resolve_design(design)
    membrane, resonator = design.membrane, design.resonator
    check_range("membrane.stretch", membrane.stretch, 1, 1, why="for large deflections")
    if membrane.shape != "flat":
        raise Refusal(
            kind=Kind.OUT_OF_RANGE,
            field="membrane.shape",
            value=membrane.shape,
            allowed="'flat' for large deflections",
        )
    bowl = (resonator.dome_depth or 0.0) if resonator.shape == "dome" else 0.0
    depth = (resonator.cavity_height - bowl) / (resonator.cavity_diameter / 2)
    return bulge_law(design_shape(design), round(depth, 12))


def design_bulge_ratio(design: DesignLike, overpressure: ArrayLike, stiffness: ArrayLike = 1.0) -> Array:
    """Compliance of the membrane of a design that enclosed air bulges, by that of the flat one.

    Args:
        design: the array; its own overpressure does not count.
        overpressure: static pressure of the enclosed air above that outside, any shape, Pa.
        stiffness: Young's modulus by that of the design, ratios, whose shape is broadcast.

    Returns:
        Float64 of the broadcast shape; below 1 where the membrane is stiffer.

    Raises:
        Refusal: as :func:`design_bulge`, or a pressure beyond the last equilibrium that was found.
    """
    design = resolve_design(design)
    modulus = pascals(design.material(design.membrane.material).youngs_modulus) * np.asarray(stiffness, np.float64)
    return design_bulge(design).compliance_ratio(np.asarray(overpressure, np.float64) / modulus)


def design_shape(design: DesignLike) -> DiscShape:
    """Dimensionless numbers on which the solution of :func:`design_disc` depends.

    Raises:
        Refusal: proportions outside what :func:`solve_disc` covers.
    """
    design = resolve_design(design)
    sizes, options = _membrane_of(design, None)
    return shape_of_disc(*sizes, options)[0]


def _membrane_of(
    design: ArrayDesign, contact_radius: float | None
) -> tuple[tuple[float, float, float, float, float], DiscOptions]:
    """Radius, thickness, modulus, Poisson's ratio and rim of a design's membrane, SI, and its options."""
    membrane = design.membrane
    material, clamped = design.material(membrane.material), membrane.mounting == "clamped"
    options = DiscOptions(
        stretch=membrane.stretch,
        contact_radius=contact_radius,
        rim_height=0.0 if clamped else metres(membrane.rim_height or 0.0),
        boss_radius=metres(membrane.boss_diameter or 0.0) / 2,
        boss_height=metres(membrane.boss_height or 0.0),
    )
    return (
        metres(design.resonator.cavity_diameter) / 2,
        metres(membrane.thickness),
        pascals(material.youngs_modulus),
        material.poisson_ratio,
        0.0 if clamped else metres(membrane.rim_width),
    ), options


def design_rubber(design: DesignLike) -> Rubber:
    """The law of the material of a design's membranes."""
    design = resolve_design(design)
    return Rubber.of(design.material(design.membrane.material))


def design_compliance(design: DesignLike, frequency: FrequencyLike, known: KnownDiscs | None = None) -> ComplexArray:
    """Volume compliance of a design's membrane by the law of its material, m^3/Pa.

    Args:
        design: the array.
        frequency: Hz, any shape.
        known: discs that need not be solved.

    Returns:
        Complex128 of the shape of the frequency.
    """
    design = resolve_design(design)
    disc = design_disc(design, known=known)
    return disc.compliance(frequency, design_rubber(design))
