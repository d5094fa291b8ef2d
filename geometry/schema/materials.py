"""Materials by name: membrane silicones and printing resins, each value with its source."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.schema.field_errors import Hertz, Number, Section

#: Frequency of a modulus that comes from a hardness or from another static test, Hz. A rubber's hardness is read one
#: to three seconds after it is loaded (ASTM D2240, ISO 48-4), and a spring-pot has relaxed after t seconds to its
#: storage modulus at about 0.09 / t Hz: from t^-alpha / Gamma(1 - alpha) = w^alpha cos(pi alpha / 2), alpha small.
STATIC_FREQUENCY = 0.1


RelaxationTime = Annotated[Number, Field(ge=1e-6, le=1e6)]
RelaxationModulus = Annotated[Number, Field(gt=0, le=1e5)]


class Material(Section):
    """An isotropic material as a design file states it."""

    youngs_modulus: Number = Field(
        ge=1e-3,
        le=1e5,
        description="Young's modulus: its real part at modulus_frequency; for law = 'prony' the modulus after long "
        "relaxation",
        json_schema_extra={"unit": "MPa"},
    )
    poisson_ratio: Number = Field(gt=0, lt=0.5, description="Poisson's ratio")
    density: Number = Field(ge=500, le=5000, description="density", json_schema_extra={"unit": "kg/m^3"})
    loss_factor: Number | None = Field(
        default=None, ge=0, le=1, description="loss factor eta at all frequencies; not for law = 'prony'"
    )
    law: Literal["spring-pot", "constant", "prony"] = Field(
        default="spring-pot",
        description="modulus over frequency: spring-pot: E (1 + j eta) (f / modulus_frequency)^(2/pi atan eta); "
        "constant: E (1 + j eta), not causal; prony: a table of relaxations",
    )
    modulus_frequency: Hertz = Field(
        default=STATIC_FREQUENCY,
        ge=1e-6,
        le=1e6,
        description="frequency at which youngs_modulus holds; about 0.1 for Shore hardness and static tests",
    )
    relaxation_times: tuple[RelaxationTime, ...] | None = Field(
        default=None, min_length=1, max_length=40, description="relaxation times in s, for law = 'prony' only"
    )
    relaxation_moduli: tuple[RelaxationModulus, ...] | None = Field(
        default=None, min_length=1, max_length=40, description="relaxing moduli in MPa, one for each of those times"
    )
    source: str = Field(description="source of these values")

    @property
    def law_in_words(self) -> str:
        """Its modulus over frequency, for people."""
        if self.law == "prony":
            relaxations = counted(len(self.relaxation_times or ()), "relaxation")
            return f"E = {self.youngs_modulus:g} MPa after long rest, {relaxations}"
        if self.law == "constant" and self.loss_factor:
            return (
                f"E = {self.youngs_modulus:g} MPa and loss factor {self.loss_factor:g} at all frequencies, "
                "which is not causal: no material has both"
            )
        if not self.loss_factor:
            return f"E = {self.youngs_modulus:g} MPa without loss"
        slope = 2 / math.pi * math.atan(self.loss_factor)
        return (
            f"E = {self.youngs_modulus:g} MPa at {self.modulus_frequency:g} Hz, loss factor {self.loss_factor:g}, "
            f"so that E rises as f^{slope:.3f}"
        )

    @model_validator(mode="after")
    def _law_is_complete(self) -> Self:
        times, moduli = self.relaxation_times, self.relaxation_moduli
        if self.law != "prony":
            for name in ("relaxation_times", "relaxation_moduli"):
                if getattr(self, name) is not None:
                    problem = f"needs law = 'prony', not {self.law!r}"
                    raise Refusal(problem, kind=Kind.CONFLICT, field=name)
            if self.loss_factor is None:
                raise Refusal(kind=Kind.MISSING, field="loss_factor", allowed=f"given for law = {self.law!r}")
            return self
        if times is None or moduli is None:
            name = "relaxation_times" if times is None else "relaxation_moduli"
            raise Refusal(kind=Kind.MISSING, field=name, allowed="given for law = 'prony'")
        if len(times) != len(moduli):
            problem = f"has {counted(len(moduli), 'value')} for {counted(len(times), 'relaxation time')}"
            raise Refusal(problem, kind=Kind.MISMATCH, field="relaxation_moduli", remedy="give as many of each")
        if self.loss_factor is not None:
            problem = "is not allowed for law = 'prony', whose table has the losses"
            raise Refusal(problem, kind=Kind.CONFLICT, field="loss_factor", value=self.loss_factor)
        return self


def youngs_modulus_from_shore_a(shore_a: float) -> float:
    """Static Young's modulus of an elastomer from its Shore A hardness, about that at 0.1 Hz.

    E = 0.0981 (56 + 7.62336 S) / (0.137505 (254 - 2.54 S)) in MPa (A. N. Gent, "On the relation
    between indentation hardness and Young's modulus", Rubber Chem. Technol. 31 (1958) 896).
    Trustworthy to about 30 %; below Shore A 10 hardness hardly measures stiffness and a modulus
    measured on the cured silicone should be given instead. At 10 Hz a rubber of loss factor 0.05, 0.1 or
    0.2 is 1.16, 1.34 or 1.78 times as stiff as at 0.1 Hz (:data:`STATIC_FREQUENCY`): the scatter of the
    loss factor adds to that of the hardness.

    Args:
        shore_a: hardness, 0 to 90.

    Returns:
        Young's modulus in MPa.

    Raises:
        Refusal: hardness outside 0 to 90.
    """
    check_range("shore_a", shore_a, 0, 90)
    return 0.0981 * (56 + 7.62336 * shore_a) / (0.137505 * (254 - 2.54 * shore_a))


def blend_modulus(first: float, second: float, fraction_of_first: float) -> float:
    """Modulus of a blend of two silicones: geometric mean weighted by volume (Lichtenecker's rule).

    Args:
        first: modulus of the first part, MPa.
        second: modulus of the second part, MPa.
        fraction_of_first: volume fraction of the first part, 0 to 1.
    """
    check_range("fraction_of_first", fraction_of_first, 0, 1)
    return first**fraction_of_first * second ** (1 - fraction_of_first)


def _silicone(youngs_modulus: float, source: str) -> Material:
    return Material(
        youngs_modulus=round(youngs_modulus, 4),
        poisson_ratio=0.49,
        density=1070.0,
        loss_factor=0.1,
        modulus_frequency=STATIC_FREQUENCY,
        source=source,
    )


_GENT = "static modulus by Gent (1958) from Shore A, +-30 %; Poisson ratio, density, loss factor assumed"

#: Materials that a design may name without stating them, each value with its source.
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


@dataclass(frozen=True)
class TearLimit:
    """Strength of a rubber in a tensile test."""

    elongation_at_break: float
    """Elongation at break, a ratio: 3 is torn at four times its length."""
    tensile_strength: float
    """Force at break per relaxed section, MPa."""
    source: str
    """Source of these values."""


_TENSILE = "typical of data sheets of platinum-cured casting silicones of this hardness, assumed"

#: Strengths of the silicones of :data:`MATERIALS`. A film that has bubbles, cuts or a sharp rim tears earlier.
TEAR_LIMITS: dict[str, TearLimit] = {
    "silicone-shore-a-0": TearLimit(9.0, 1.4, _TENSILE),
    "silicone-blend-5-1-shore-a-0-5": TearLimit(9.0, 1.4, _TENSILE),
    "silicone-shore-a-5": TearLimit(9.0, 2.4, _TENSILE),
    "silicone-shore-a-10": TearLimit(9.0, 3.2, _TENSILE),
    "silicone-shore-a-20": TearLimit(6.0, 3.8, _TENSILE),
    "silicone-shore-a-30": TearLimit(3.6, 3.4, _TENSILE),
    "silicone-shore-a-50": TearLimit(3.2, 5.0, _TENSILE),
}
