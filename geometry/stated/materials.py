"""Materials by name: membrane silicones and printing resins, each value with its source."""

from __future__ import annotations

from pydantic import Field

from geometry.refusal import Refusal
from geometry.stated.fields import Number, Section


class Material(Section):
    """An isotropic material as a design file states it."""

    youngs_modulus: Number = Field(
        ge=1e-3, le=1e5, description="static Young's modulus", json_schema_extra={"unit": "MPa"}
    )
    poisson_ratio: Number = Field(gt=0, lt=0.5, description="Poisson's ratio")
    density: Number = Field(ge=500, le=5000, description="density", json_schema_extra={"unit": "kg/m^3"})
    loss_factor: Number = Field(
        ge=0, le=1, description="structural loss factor eta: the dynamic modulus is E (1 + j eta)"
    )
    source: str = Field(description="where the values come from")


def youngs_modulus_from_shore_a(shore_a: float) -> float:
    """Young's modulus of an elastomer from its Shore A hardness.

    E = 0.0981 (56 + 7.62336 S) / (0.137505 (254 - 2.54 S)) in MPa (A. N. Gent, "On the relation
    between indentation hardness and Young's modulus", Rubber Chem. Technol. 31 (1958) 896).
    Trustworthy to about 30 %; below Shore A 10 hardness hardly measures stiffness and a modulus
    measured on the cured silicone should be given instead.

    Args:
        shore_a: hardness, 0 to 90.

    Returns:
        Young's modulus in MPa.

    Raises:
        Refusal: hardness outside 0 to 90.
    """
    if not 0 <= shore_a <= 90:
        raise Refusal(f"shore_a = {shore_a:g} must be between 0 and 90")
    return 0.0981 * (56 + 7.62336 * shore_a) / (0.137505 * (254 - 2.54 * shore_a))


def blend_modulus(first: float, second: float, fraction_of_first: float) -> float:
    """Modulus of a blend of two silicones: geometric mean weighted by volume (Lichtenecker's rule).

    Args:
        first: modulus of the first part, MPa.
        second: modulus of the second part, MPa.
        fraction_of_first: volume fraction of the first part, 0 to 1.
    """
    if not 0 <= fraction_of_first <= 1:
        raise Refusal(f"fraction_of_first = {fraction_of_first:g} must be between 0 and 1")
    return first**fraction_of_first * second ** (1 - fraction_of_first)


def _silicone(youngs_modulus: float, source: str) -> Material:
    return Material(
        youngs_modulus=round(youngs_modulus, 4),
        poisson_ratio=0.49,
        density=1070.0,
        loss_factor=0.1,
        source=source,
    )


_GENT = "modulus by Gent (1958) from Shore A, +-30 %; Poisson ratio, density, loss factor assumed"

MATERIALS: dict[str, Material] = {
    "silicone-shore-a-0": _silicone(youngs_modulus_from_shore_a(0), _GENT),
    "silicone-shore-a-5": _silicone(youngs_modulus_from_shore_a(5), _GENT),
    "silicone-shore-a-10": _silicone(youngs_modulus_from_shore_a(10), _GENT),
    "silicone-shore-a-20": _silicone(youngs_modulus_from_shore_a(20), _GENT),
    "silicone-shore-a-30": _silicone(youngs_modulus_from_shore_a(30), _GENT),
    "silicone-shore-a-50": _silicone(youngs_modulus_from_shore_a(50), _GENT),
    "silicone-blend-5-1-shore-a-0-5": _silicone(
        blend_modulus(youngs_modulus_from_shore_a(0), youngs_modulus_from_shore_a(5), 5 / 6),
        "5:1 blend of Shore A 0 and 5, geometric mean of " + _GENT,
    ),
    "photopolymer-resin": Material(
        youngs_modulus=2500.0,
        poisson_ratio=0.38,
        density=1180.0,
        loss_factor=0.03,
        source="typical rigid photopolymer, assumed; used for the mass of shells only",
    ),
}
