"""Soft parts of an array beside its air and its membranes: leaks, soft floors of cavities, soft sheaths of tubes.

Floors and sheaths yield by the law of their material and without inertia: a floor of 1 mm of 1 MPa across 6 mm
resonates near 1.8 kHz, which is 0.3 % of its compliance at 100 Hz.
"""

from __future__ import annotations

import numpy as np

from acoustic_fem.duct.leak import leak_conductance
from acoustic_fem.duct.plane_wave import tube_compliance
from acoustic_fem.membrane.disc import disc_compliance
from acoustic_fem.membrane.rubber import ELASTIC, Rubber
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.units import metres, pascals
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array, ComplexArray
from geometry.schema.part_fields import Tube


def design_leak(design: ArrayDesign, medium: Medium) -> float:
    """Conductance of the leak of each cavity of a design, m^3/(Pa s); 0 where it is tight."""
    resonator = design.resonator
    return leak_conductance(metres(resonator.leak_diameter) / 2, metres(resonator.leak_length), medium)


def soft_rubber(design: ArrayDesign, material: str | None) -> Rubber:
    """The law of a soft part's material; an elastic one for None, a rigid part."""
    return ELASTIC if material is None else Rubber.of(design.material(material))


def floor_compliance(design: ArrayDesign) -> float:
    """Static volume compliance of the floor of a cavity, a disc clamped at its wall, m^3/Pa; 0 where it is rigid."""
    resonator = design.resonator
    if resonator.floor_material is None:
        return 0.0
    material = design.material(resonator.floor_material)
    return disc_compliance(
        metres(resonator.cavity_diameter) / 2,
        metres(resonator.floor_thickness),
        pascals(material.youngs_modulus),
        material.poisson_ratio,
    )


def sheath_compliance(design: ArrayDesign, tube: Tube) -> float:
    """Static change of a tube's section per pressure, m^2/Pa; 0 where it is rigid.

    Between the turns of the spring the air presses on the sheath, which lies on the spring and yields outwards.
    """
    if tube.sheath_material is None:
        return 0.0
    material = design.material(tube.sheath_material)
    modulus = pascals(material.youngs_modulus)
    inner, outer = metres(tube.spring_outer_diameter) / 2, metres(tube.outer_diameter) / 2
    return tube_compliance(inner, outer, modulus, material.poisson_ratio).real


def beside_air(design: ArrayDesign, membrane: ComplexArray, frequency: Array, medium: Medium) -> ComplexArray:
    """Admittance of all that yields around the air of a cavity: membrane, floor and leak.

    Args:
        design: the array.
        membrane: compliance of its membrane, (n_freq,) complex128, m^3/Pa.
        frequency: (n_freq,) float64, Hz.
        medium: the air.

    Returns:
        (n_freq,) complex128, m^3/(Pa s).
    """
    floor = floor_compliance(design) / soft_rubber(design, design.resonator.floor_material).ratio(frequency)
    return np.asarray(2j * np.pi * frequency * (membrane + floor) + design_leak(design, medium))
