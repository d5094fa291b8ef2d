"""How hard a membrane may be pressed: until it saturates, stands on the floor, or tears."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.membrane.large_deflection import Indenter, SoftPatch, design_membrane, press_curve
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range, positive_numbers
from geometry.ground.typed import Array
from geometry.schema.materials import TEAR_LIMITS

SATURATED = 0.1
"""Fraction of the linear law's volume per force below which a further force counts as not felt."""
LINEAR = 0.1
"""Deviation from the linear law, as a fraction of its volume, up to which it is good enough."""
_POINTS = 400


@dataclass(frozen=True)
class PressLimits:
    """Forces on one membrane at which its use ends; infinite where the solution ends before."""

    linear_force: float
    """Force up to which the volume is within a tenth of the linear law, N."""
    saturation_force: float
    """Force above which a further force displaces less than a tenth of what the linear law says, N."""
    force_at_floor: float
    """Force at which the membrane reaches the floor of the cavity, N."""
    tear_force: float
    """Force at which the rubber is stretched to its elongation at break, N; infinite where that is not known."""
    largest_force: float
    """Largest force that the solution covers, N."""
    end: str
    """Why the solution ends there, in words."""
    stretch: float
    """Largest principal stretch at :attr:`usable_force`, a ratio."""
    stress: float
    """Largest principal Cauchy stress at :attr:`usable_force`, Pa."""
    elongation_at_break: float | None
    """Elongation at break of the rubber, a ratio; None where it is not known."""

    @property
    def usable_force(self) -> float:
        """Largest force up to which the membrane neither saturates, nor stands on the floor, nor tears, N."""
        return min(self.saturation_force, self.force_at_floor, self.tear_force, self.largest_force)

    @property
    def elongation(self) -> float | None:
        """Elongation at :attr:`usable_force` by that at break, a ratio; None where that is not known."""
        return None if self.elongation_at_break is None else (self.stretch - 1) / self.elongation_at_break

    def dynamic_range(self, smallest_force: float) -> float:
        """Level of the usable force above the smallest force that is detected, dB.

        Args:
            smallest_force: N.

        Raises:
            Refusal: a force that is not above 0.
        """
        positive_numbers("smallest_force", smallest_force, "N")
        return 20 * math.log10(self.usable_force / smallest_force)


def press_limits(
    design: DesignLike, indenter: Indenter | None = None, *, elongation_at_break: float | None = None
) -> PressLimits:
    """Limits of the presses on a membrane of a design, with the modulus that its material states.

    Args:
        design: the array; its membranes are alike.
        indenter: what presses on the middle; None: a soft patch of a quarter of the opening's radius.
        elongation_at_break: a ratio, above 0 to 20; None: of :data:`geometry.schema.materials.TEAR_LIMITS`, where the
            material is listed.

    Raises:
        Refusal: a membrane that is stretched or not flat, proportions or an elongation out of range.
    """
    design = resolve_design(design)
    known = TEAR_LIMITS.get(design.membrane.material)
    if elongation_at_break is not None:
        check_range("elongation_at_break", elongation_at_break, 0, 20, excluded="low")
    elif known is not None:
        elongation_at_break = known.elongation_at_break
    curve = press_curve(design_membrane(design), indenter or SoftPatch())
    force = np.geomspace(1e-4 * curve.largest_force, curve.largest_force, _POINTS)
    response = curve.response(force)
    small = curve.response(0.0).volume_per_force
    linear = np.abs(curve.volume_fraction(force) - 1) < LINEAR
    felt = response.volume_per_force >= SATURATED * small
    whole = np.ones(_POINTS, bool) if elongation_at_break is None else response.stretch < 1 + elongation_at_break
    limits = PressLimits(
        linear_force=_first(force, ~linear),
        saturation_force=_first(force, ~felt),
        force_at_floor=curve.force_at_floor,
        tear_force=_first(force, ~whole),
        largest_force=curve.largest_force,
        end=curve.end,
        stretch=1.0,
        stress=0.0,
        elongation_at_break=elongation_at_break,
    )
    at_limit = curve.response(limits.usable_force)
    return replace(limits, stretch=float(at_limit.stretch), stress=float(at_limit.stress))


def _first(force: Array, reached: NDArray[np.bool_]) -> float:
    """First force at which something is reached; infinity if it is not."""
    return float(force[reached.argmax()]) if reached.any() else math.inf
