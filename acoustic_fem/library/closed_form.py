"""Responses of an array between and below the frequencies of its library, by the closed forms of its design.

A cubic spline through a library in steps of 1 Hz is 1 % off between them where a long line bends, and it says nothing
below 1 Hz, where presses are held, leaks let go and rubber creeps. The closed forms (fidelity ``lumped``) give any
frequency within milliseconds. Their ratio to the library changes slowly over frequency, so the ratio is interpolated,
and at the frequencies of the library the values are those of the library, whatever its fidelity.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

import acoustic_fem
from acoustic_fem.library.network_responses import array_responses
from acoustic_fem.library.touch_pressure import injected_flow, membranes_in_vacuo
from acoustic_fem.numerics.frequency_splines import interpolated, interpolated_from_zero
from acoustic_fem.quantities.audible import audible_ratio
from acoustic_fem.quantities.medium import Medium
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array, ComplexArray

#: Frequency below which the closed forms are not asked, Hz; what they are there counts down to 0 Hz.
LOWEST = 1e-3
_KEPT = 5


@dataclass(frozen=True, eq=False)
class ClosedForm:
    """Closed forms of a design in a gas, at any frequency; the last few grids are kept."""

    design: ArrayDesign
    """The array."""
    medium: Medium
    """The air."""
    _found: dict[bytes, dict[str, ComplexArray]] = field(default_factory=dict, repr=False)

    @property
    def sealed(self) -> bool:
        """True if no cavity leaks, so that all pressures are equal at 0 Hz."""
        kinds = (self.design.of_kind(kind) for kind in self.design.kinds)
        return all(kind.resonator.leak_diameter == 0 for kind in kinds)

    def at(self, frequency: Array) -> dict[str, ComplexArray]:
        """Responses by closed forms.

        Args:
            frequency: (n,) float64, 0 to 2000 Hz, in any order. Below 1 mHz the values of 1 mHz count, and at 0 Hz
                their real parts.

        Returns:
            Arrays by the names, shapes and units of :data:`acoustic_fem.library.transfer_functions.VARIABLES`, and
            ``cavity_response``, (n_point, n) complex128, Pa/N.
        """
        grid, places = np.unique(np.maximum(frequency, LOWEST), return_inverse=True)
        found = {name: values[..., places] for name, values in self._on(grid).items()}
        still = np.asarray(frequency) == 0
        for values in found.values():
            values[..., still] = values[..., still].real
        return found

    def _on(self, grid: Array) -> dict[str, ComplexArray]:
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
            del values["source_response"]
            self._found[key] = {**values, "cavity_response": cavity}
        return self._found[key]

    def between(
        self, known: Mapping[str, ComplexArray], grid: Array, frequency: Array, microphones: tuple[str, ...]
    ) -> dict[str, ComplexArray]:
        """Responses known on a grid, at other frequencies: closed forms times the interpolated ratio to them.

        Args:
            known: complex128 arrays by the names of :meth:`at`, such as (n_point, n_microphone, n_freq) and (n_point,
                n_freq), at some microphones of the design or all.
            grid: (n_freq,) float64, ascending, above 0 Hz.
            frequency: (n,) float64, 0 Hz to the end of the grid.
            microphones: names of those microphones.

        Returns:
            Arrays of the same names and units, their last axis (n,).
        """
        heard = [self.design.microphones.index(name) for name in microphones]
        there, wanted = self.at(grid), self.at(frequency)
        found = {}
        for name, values in known.items():
            if name == "transfer_function":
                ratio = audible_ratio(values, there[name][:, heard])
                of_zero = interpolated_from_zero(ratio, grid, frequency, self.sealed)
                found[name] = wanted[name][:, heard] * of_zero
            elif name == "microphone_impedance":
                pairs = np.ix_(heard, heard)
                found[name] = wanted[name][pairs] * interpolated(values / there[name][pairs], grid, frequency)
            else:
                found[name] = wanted[name] * interpolated(values / there[name], grid, frequency)
        return found
