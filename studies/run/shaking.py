"""Effect of motion on a sensor that nobody touches: a waved hand, a knock on the table, and the target's touch."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

import acoustic_fem
from acoustic_fem import Library
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal
from localize.signals.motion import KNOCKED, WAVED
from studies.verdict.tap_levels import covered_forces

SHAKEN_AT = 10.0
"""Frequency at which motion and touches are compared, Hz: hands move below, taps and tables reach above."""
CLEAR = 10 ** (10 / 20)
"""Ratio of the target's touch to the motion from which motion does not matter, 10 dB."""
THINNER = 0.5
"""Thickness of the membrane that is tried as a remedy, by that of the design."""


@dataclass(frozen=True)
class ShakenState:
    """Motion of a sensor, and the touch that is as loud."""

    state: str
    """Name of the motion, in words."""
    acceleration: float
    """Largest acceleration, m/s^2; assumed."""
    pressure: float
    """Pressure at the microphone that motion moves most, in the worst direction, Pa."""
    force: float
    """Force on the membrane of the weakest point whose touch is as loud, N."""
    clear: bool
    """True if the target's touch of that point is louder by 10 dB."""


@dataclass(frozen=True)
class ShakenFindings:
    """Effect of motion on a design."""

    states: tuple[ShakenState, ...]
    """Motions; empty if they are not known."""
    target: float
    """Force of the target's touch on a membrane, N."""
    thinner: float | None = None
    """Factor by which motion looks smaller with membranes of half the thickness; None if no motion hides the target's
    touch, or if they cannot be solved."""
    unknown: str = ""
    """Reason why nothing is known; empty if it is."""

    @property
    def rows(self) -> tuple[tuple[str, str], ...]:
        """Name and value of each motion against the target, and of the remedies."""
        if self.unknown:
            return (("motion", f"is not checked: {self.unknown}"),)
        rows = tuple((f"{each.state}, {each.acceleration:g} m/s2 (assumed)", self.words(each)) for each in self.states)
        if self.thinner is None:
            return rows
        return (
            *rows,
            ("membranes of half the thickness", f"would make it look like {self.thinner:.2g} times that force"),
            ("decoding", "give locate and live --motion with your largest acceleration, m/s2"),
        )

    def words(self, state: ShakenState) -> str:
        """A motion and its verdict, in words."""
        verdict = "ok, your touch is louder by 10 dB" if state.clear else "warn, it hides your touch"
        return f"looks like a touch of {1e3 * state.force:.2g} mN; yours is {1e3 * self.target:.2g} mN: {verdict}"

    def to_dict(self) -> dict[str, Any]:
        """Findings as JSON can hold them."""
        return asdict(self)


def shaken_findings(design: ArrayDesign, library: Library) -> ShakenFindings:
    """Effect of motion on a design at 10 Hz.

    Args:
        design: the array.
        library: computed transfer functions of it, 10 Hz among their frequencies.
    """
    target = float(covered_forces(design).min())
    try:
        force, pressure = _per_acceleration(library)
    except Refusal as problem:
        return ShakenFindings((), target, unknown=str(problem))
    states = tuple(
        ShakenState(name, largest, largest * pressure, largest * force, largest * force * CLEAR <= target)
        for name, largest in (("a waved hand", WAVED), ("a knock on the table", KNOCKED))
    )
    if all(each.clear for each in states):
        return ShakenFindings(states, target)
    return ShakenFindings(states, target, _of_thinner(design, force))


def _of_thinner(design: ArrayDesign, force: float) -> float | None:
    """Force per acceleration with thinner membranes, by that of the design; None if these cannot be solved."""
    try:
        changed = design.with_values({"membrane.thickness": THINNER * design.membrane.thickness})
        return _per_acceleration(acoustic_fem.solve(changed, [SHAKEN_AT], "lumped"))[0] / force
    except Refusal:
        return None


def _per_acceleration(library: Library) -> tuple[float, float]:
    """Touch of the weakest point that is as loud, N per m/s^2, and pressure at the loudest microphone, Pa per m/s^2."""
    shaken = np.abs(library.acceleration_response.sel(frequency=SHAKEN_AT).values)
    pressure = np.linalg.norm(shaken, axis=1)
    touched = np.abs(library.force_response.sel(frequency=SHAKEN_AT).transpose("point", "microphone").values)
    nearest = touched.argmax(axis=1)
    return float((pressure[nearest] / touched.max(axis=1)).max()), float(pressure.max())
