"""Presses that are not small: the light force that displaces the same volume, so that the linear array can follow it.

Above a light force a membrane displaces less than the linear law says, and it becomes stiffer against the pressure of
its own cavity. With the volume V(F) and the compliance C(F) of :func:`acoustic_fem.membrane.press_curve`, and V' and C'
of the linear law, the array moves as if it were pressed by the force

    F' = (V(F) + (C' - C(F)) p) / V',

where p is the pressure that F' makes in the cavity. It is found by iteration, which converges because the membrane is
only a part of what yields. Other membranes stay linear. The law is static: it has the modulus of the rubber at 1 Hz,
about that of a press of a second, while the linear array keeps the law of its rubber. F is the mean force over 5 ms,
because inertia carries a shorter blow before the membrane has moved far.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import scipy.fft
from scipy.ndimage import uniform_filter1d

import acoustic_fem
from acoustic_fem.numerics.frequency_splines import interpolated
from acoustic_fem.quantities.units import metres, pascals
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import read_completed
from geometry.ground.caller_warnings import warn_caller
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray
from localize.signals.array_response import ArrayResponse
from localize.signals.finger_stimuli import top_faded
from localize.signals.stimulus import LINE_SPACING, SAMPLE_RATE, line_frequencies

if TYPE_CHECKING:
    from acoustic_fem.membrane import PressCurve

LIGHT = 1e-3
"""Force up to which the linear law stands, by modulus times radius squared: 12 mN on the membrane of ``array-2x6``,
where the volume is 3 % off. Up to twice this force the law of large presses comes in gradually."""
RATE = 1.0
"""Frequency at which the modulus of the rubber is taken, Hz."""
BLOW = 5e-3
"""Time over which the force is averaged before the law is applied, s."""
_RING = 1 / LINE_SPACING
_SLOW = 1e-3, 0.2, 48
_CONVERGED = 1e-5
_ITERATIONS = 60


class LargePresses:
    """Law of the presses on the membranes of an array; solved when a press is first not light.

    Args:
        response: the array.
        sample_rate: of the forces, Hz.
    """

    def __init__(self, response: ArrayResponse, sample_rate: float) -> None:
        self._response, self._rate = response, float(sample_rate)
        self._laws: dict[str, _Law] = {}

    @cached_property
    def _design(self) -> ArrayDesign | None:
        text = self._response.provenance.get("design")
        return read_completed(text, "design").completed() if isinstance(text, str) else None

    def _law(self, design: ArrayDesign, point: int) -> _Law:
        kind = design.kinds[design.kind_of_point[point]]
        if kind not in self._laws:
            self._laws[kind] = _Law(design.of_kind(kind))
        return self._laws[kind]

    def light_forces(self, force: Array) -> Array:
        """Forces that displace as much by the linear law as given ones do; light ones are returned as they are.

        An array without a design is taken as linear, since nothing says what its membranes are.

        Args:
            force: on each membrane, at the times of the samples; (n, n_point) float64, N.

        Returns:
            (n, n_point) float64, N.

        Raises:
            Refusal: a force beyond the last state of the membrane that was found.
        """
        found, design = force.copy(), self._design
        if design is None:
            return found
        for point in np.flatnonzero(force.max(axis=0, initial=0.0) > 0):
            law = self._law(design, int(point))
            width = max(1, round(BLOW * self._rate))
            mean = np.maximum(uniform_filter1d(force[:, point], width, mode="nearest"), 0.0)  # it rounds below 0
            if mean.max() > law.light:
                found[:, point] = self._light(force[:, point], mean, int(point), law)
        return found

    def _light(self, force: Array, mean: Array, point: int, law: _Law) -> Array:
        if law.curve is None:
            return force
        largest = law.curve.largest_force
        if mean.max() > largest:
            raise Refusal(
                kind=Kind.OUT_OF_RANGE,
                field="contact.force",
                value=float(mean.max()),
                unit="N",
                allowed=f"at most {largest:.3g} N on the membrane of point {point + 1}, because {law.curve.end}",
            )
        gain, yielding = law.at(mean)
        displaced = force * gain
        if not yielding.any():
            return displaced
        through = self._cavity(point, len(force))
        found = displaced
        for _ in range(_ITERATIONS):
            length = 2 * (len(through) - 1)
            pressure = scipy.fft.irfft(scipy.fft.rfft(found, n=length) * through, n=length)[: len(force)]
            before, found = found, displaced + yielding * pressure
            if np.abs(found - before).max() <= _CONVERGED * displaced.max():
                return found
        raise Refusal(
            f"the pressure in the cavity of point {point + 1} under the press did not converge", kind=Kind.NO_RESULT
        )

    def _cavity(self, point: int, count: int) -> ComplexArray:
        """Pressure in the cavity per force over frequency, (n,) complex128, Pa/N, with room for it to ring."""
        response = self._response
        assert response.cavity_response is not None
        # As long again as the press, so that rubber which still creeps does not act on its beginning.
        length = scipy.fft.next_fast_len(2 * count + round(_RING * self._rate), real=True)
        length += length % 2
        grid = scipy.fft.rfftfreq(length, 1 / self._rate)
        band = (float(response.frequency[0]), min(float(response.frequency[-1]), SAMPLE_RATE / 2))
        fade = np.interp(grid, line_frequencies(), top_faded(band).numpy().astype(np.float64), right=0.0)
        through = np.zeros(len(grid), np.complex128)
        kept = fade > 0
        # A fixed grid, which every press shares: closed forms at each frequency of a long press would fill the memory.
        lines = line_frequencies()[1:]
        shared = np.concatenate([np.geomspace(*_SLOW), lines[lines <= band[1]]])
        _, cavity = response.between(shared)
        assert cavity is not None
        through[kept] = interpolated(cavity[point], shared, grid[kept]) * fade[kept]
        return through


class _Law:
    """Law of the membranes of one kind."""

    def __init__(self, design: ArrayDesign) -> None:
        material = design.material(design.membrane.material)
        stiffer = float(acoustic_fem.membrane.design_rubber(design).ratio(RATE).real)
        modulus = pascals(material.youngs_modulus) * stiffer
        self.light = LIGHT * modulus * (metres(design.resonator.cavity_diameter) / 2) ** 2
        self._design, self._modulus = design, modulus

    @cached_property
    def curve(self) -> PressCurve | None:
        """The membrane under a soft patch; None, with a warning, where it is stretched or shaped."""
        try:
            membrane = acoustic_fem.membrane.design_membrane(self._design)
        except Refusal as refusal:
            warn_caller(f"{refusal}; presses above {self.light * 1e3:.3g} mN are recorded by the linear law")
            return None
        # The face loads finite elements when they are first used.
        patch = acoustic_fem.membrane.SoftPatch()
        return acoustic_fem.membrane.press_curve(replace(membrane, youngs_modulus=self._modulus), patch)

    def at(self, force: Array) -> tuple[Array, Array]:
        """Volume by that of the linear law, and what it yields less to a pressure, N/Pa; (n,) float64 each."""
        assert self.curve is not None
        comes_in = np.clip(force / self.light - 1, 0.0, 1.0)
        response, relaxed = self.curve.response(force), self.curve.response(0.0)
        fraction = self.curve.volume_fraction(force)
        stiffer = 1 - response.compliance / relaxed.compliance
        per_pressure = float(relaxed.compliance / relaxed.volume_per_force)
        return 1 + comes_in * (fraction - 1), comes_in * stiffer * per_pressure
