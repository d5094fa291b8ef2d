"""Responses of an array between and below the frequencies of its library, by the closed forms of its design.

A cubic spline through a library in steps of 1 Hz is 1 % off between them where a long line bends, and it says nothing
below 1 Hz, where presses are held, leaks let go and rubber creeps. The closed forms (fidelity ``lumped``) give any
frequency within milliseconds. Their ratio to the library changes slowly over frequency, so the ratio is interpolated,
and at the frequencies of the library the values are those of the library, whatever its fidelity.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

import acoustic_fem
from acoustic_fem.library.network_responses import array_responses
from acoustic_fem.library.touch_pressure import injected_flow, membranes_in_vacuo
from acoustic_fem.quantities.medium import Medium
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array, ComplexArray
from localize.signals.frequency_splines import interpolated, interpolated_from_zero

LOWEST = 1e-3
"""Frequency below which the closed forms are not asked, Hz; what they are there counts down to 0 Hz."""
_KEPT = 5


@dataclass(frozen=True, eq=False)
class ClosedForm:
    """Closed forms of a design in a gas, at any frequency; the last few grids are kept."""

    design: ArrayDesign
    """The array."""
    medium: Medium
    """The air."""
    _found: dict[bytes, tuple[ComplexArray, ComplexArray]] = field(default_factory=dict, repr=False)

    @property
    def sealed(self) -> bool:
        """True if no cavity leaks, so that all pressures are equal at 0 Hz."""
        kinds = (self.design.of_kind(kind) for kind in self.design.kinds)
        return all(kind.resonator.leak_diameter == 0 for kind in kinds)

    def at(self, frequency: Array) -> tuple[ComplexArray, ComplexArray]:
        """Transfer functions, and pressures in the touched cavity per force on its membrane.

        Args:
            frequency: (n,) float64, 0 to 2000 Hz, in any order. Below 1 mHz the values of 1 mHz count, and at 0 Hz
                their real parts.

        Returns:
            (n_point, n_microphone, n) complex128, Pa/Pa, and (n_point, n) complex128, Pa/N.
        """
        grid, places = np.unique(np.maximum(frequency, LOWEST), return_inverse=True)
        transfer, cavity = (values[..., places] for values in self._on(grid))
        still = np.asarray(frequency) == 0
        for values in (transfer, cavity):
            values[..., still] = values[..., still].real
        return transfer, cavity

    def _on(self, grid: Array) -> tuple[ComplexArray, ComplexArray]:
        key = grid.tobytes()
        if key not in self._found:
            values, _ = array_responses(self.design, grid, "lumped", self.medium)
            rubber = acoustic_fem.membrane.design_rubber(self.design)
            vacuum = membranes_in_vacuo(
                self.design, lambda alike: acoustic_fem.membrane.design_disc(alike).response(grid, rubber)
            )
            impedance = values["point_impedance"]
            cavity = impedance * injected_flow("force", grid, vacuum, impedance)
            if len(self._found) >= _KEPT:
                self._found.clear()
            self._found[key] = np.asarray(values["transfer_function"]), np.asarray(cavity)
        return self._found[key]


def between(
    closed_form: ClosedForm,
    transfer_function: ComplexArray,
    cavity_response: ComplexArray | None,
    grid: Array,
    frequency: Array,
    microphones: tuple[str, ...],
) -> tuple[ComplexArray, ComplexArray | None]:
    """Responses known on a grid, at other frequencies: those of the closed form times the interpolated ratio to it.

    Args:
        closed_form: of the array.
        transfer_function: (n_point, n_microphone, n_freq) complex128, Pa/Pa.
        cavity_response: (n_point, n_freq) complex128, Pa/N; or None.
        grid: (n_freq,) float64, ascending, above 0 Hz.
        frequency: (n,) float64, 0 Hz to the end of the grid.
        microphones: names of those of the transfer functions.

    Returns:
        (n_point, n_microphone, n) complex128, Pa/Pa, and (n_point, n) complex128, Pa/N, or None.
    """
    heard = [closed_form.design.microphones.index(name) for name in microphones]
    known, known_cavity = closed_form.at(grid)
    wanted, wanted_cavity = closed_form.at(frequency)
    ratio = transfer_function / known[:, heard]
    transfer = wanted[:, heard] * interpolated_from_zero(ratio, grid, frequency, closed_form.sealed)
    if cavity_response is None:
        return transfer, None
    return transfer, wanted_cavity * interpolated(cavity_response / known_cavity, grid, frequency)
