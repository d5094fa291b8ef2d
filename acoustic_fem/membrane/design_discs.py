"""The membranes of a design: as a mounted disc, as a rubber, and as a bulge under the pressure of enclosed air."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from acoustic_fem.membrane.bulged import BulgeLaw, bulge_law
from acoustic_fem.membrane.disc import DiscOptions, DiscSolution, KnownDiscs, shape_of_disc, solve_disc
from acoustic_fem.membrane.half_section import FITTING, DiscShape, Mounting
from acoustic_fem.membrane.mounting import mounting_ratio
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

    A clamped rim does not move, however thick it is. The modulus is multiplied by :func:`design_stiffening`: of a
    membrane that enclosed air bulges, that is strained, or whose glue is soft.

    Args:
        design: the array.
        contact_radius: of the patch that takes a force, m, as for :class:`DiscOptions`.
        known: discs that need not be solved.

    Raises:
        Refusal: proportions outside what :func:`solve_disc` covers, or as :func:`design_stiffening`.
    """
    design = resolve_design(design)
    density = design.material(design.membrane.material).density
    sizes, options = _membrane_of(design, contact_radius)
    radius, thickness, modulus, ratio, rim = sizes
    return solve_disc(radius, thickness, modulus * design_stiffening(design), ratio, rim, density, options, known)


def design_stiffening(design: DesignLike) -> float:
    """Stiffness of the membrane of a design for small signals, by that of a flat one that fits, on rigid glue.

    It is 1 but for a membrane that enclosed air bulges (``air.overpressure``), that is mounted with strain
    (``membrane.prestrain``, ``membrane.gluing_temperature``), or whose glue is soft (``membrane.glue_thickness``).

    Args:
        design: the array.

    Raises:
        Refusal: as :func:`design_bulge_ratio` and :func:`acoustic_fem.membrane.mounting.mounting_ratio`.
    """
    design = resolve_design(design)
    mounted = 1 / design_mounting_ratio(design)
    if not design.air.overpressure:
        return mounted
    return mounted / float(design_bulge_ratio(design, design.air.overpressure))


def design_mounting(design: DesignLike, prestrain: float = 0.0, glue_thickness: float = 0.0) -> Mounting:
    """Strain and glue with which the membrane of a design is mounted.

    Args:
        design: the array, in the air whose temperature counts.
        prestrain: further strain, a ratio.
        glue_thickness: further thickness of the glue, m.
    """
    design = resolve_design(design)
    membrane = design.membrane
    strain = membrane.prestrain + prestrain
    if membrane.gluing_temperature is not None:
        strain += 1e-6 * membrane.expansion_mismatch * (membrane.gluing_temperature - design.air.temperature)
    thickness = metres(membrane.glue_thickness) + glue_thickness
    if thickness <= 0:
        return Mounting(round(strain, 12))
    glue = design.material(membrane.glue_material or membrane.material)
    unit = pascals(design.material(membrane.material).youngs_modulus) / metres(design.resonator.cavity_diameter / 2)
    shear = pascals(glue.youngs_modulus) / (2 * (1 + glue.poisson_ratio))
    constrained = 2 * shear * (1 - glue.poisson_ratio) / (1 - 2 * glue.poisson_ratio)
    layer = round(shear / thickness / unit, 9), round(constrained / thickness / unit, 9)
    return Mounting(round(strain, 12), layer)


def design_mounting_ratio(design: DesignLike, prestrain: float = 0.0, glue_thickness: float = 0.0) -> float:
    """Compliance of the membrane of a design for small signals by that of one that fits, on rigid glue.

    Args:
        design: the array, in the air whose temperature counts.
        prestrain: further strain, a ratio.
        glue_thickness: further thickness of the glue, m.

    Raises:
        Refusal: a membrane that is pressed together until it all but buckles.
    """
    design = resolve_design(design)
    mounting = design_mounting(design, prestrain, glue_thickness)
    return 1.0 if mounting == FITTING else mounting_ratio(design_shape(design), mounting)


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


def mounted_modulus(design: ArrayDesign) -> float:
    """Young's modulus of a flat membrane that fits and is as stiff as that of the design without bulge, Pa."""
    return pascals(design.material(design.membrane.material).youngs_modulus) / design_mounting_ratio(design)


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
    modulus = mounted_modulus(design) * np.asarray(stiffness, np.float64)
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
