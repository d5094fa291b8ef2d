"""Spectra of strokes: how a finger moves a membrane over time, in closed form.

A stroke rises as sin^2, is held, and falls as sin^2. A Gaussian smooths its edges, so that a stroke without edges of
its own is a Gaussian. Its derivative consists of two half sines, so its spectrum has a closed form:

    S(w) = (E(w rise) exp(-j w t) - E(w fall) exp(-j w (t + rise / 2 + hold + fall / 2))) exp(-(w blur)^2 / 2) / (j w),

in which t is the time of half the rise and E(x) = cos(x / 2) / (1 - (x / pi)^2) the spectrum of a half sine of area
one.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array, ComplexArray

PARAMETERS = ("middle", "rise", "hold", "fall", "blur")
"""Parameters of a stroke in their order: the time of half the rise, s, and the natural logarithms of the times, s, of
the rise, the hold, the fall and the standard deviation of the smoothing."""

_BLOCK = 16
"""Number of frequencies of a block, whose phasors have one factor in common."""
_NEAR = 1e-2
"""Distance y of an edge from its removable singularity below which its series is taken. In single precision, the
quotients lose too many digits below it."""


@dataclass(frozen=True, eq=False)
class StrokeSpectra:
    """Spectra of strokes of height one; made by :func:`stroke_spectra`."""

    spectrum: ComplexArray
    """Spectra, (..., n_freq) complex128 or complex64, s."""
    begin: ComplexArray
    """Phasor of the middle of the rise, smoothed and integrated, (..., n_freq) complex128 or complex64, s."""
    end: ComplexArray
    """Phasor of the middle of the fall, smoothed and integrated, (..., n_freq) complex128 or complex64, s."""
    falling: ComplexArray
    """Part of the fall, which is subtracted, (..., n_freq) complex128 or complex64, s."""
    up_slope: Array
    """Derivative of the edge of the rise by the logarithm of its length, (..., n_freq) float64 or float32."""
    down_slope: Array
    """Derivative of the edge of the fall by the logarithm of its length, (..., n_freq) float64 or float32."""
    times: Array
    """Rise, hold, fall and smoothing of each stroke, (..., 4) float64 or float32, s."""

    def chosen(self, mask: NDArray[np.bool_]) -> StrokeSpectra:
        """Spectra of some strokes, chosen along the first axis."""
        return StrokeSpectra(**{name: values[mask] for name, values in vars(self).items()})

    def derivatives(self, frequency: Array) -> NDArray[np.complex64]:
        """Derivatives by the parameters at the same frequencies (n_freq,) Hz, (..., 5, n_freq) complex64."""
        turn = 2 * np.pi * frequency
        rise, hold, fall, blur = (self.times[..., k, None] for k in range(4))
        later = 1j * turn * self.falling
        found = np.empty((*self.spectrum.shape[:-1], len(PARAMETERS), len(turn)), np.complex64)
        found[..., 0, :] = -1j * turn * self.spectrum
        found[..., 1, :] = self.up_slope * self.begin + later * (rise / 2)
        found[..., 2, :] = later * hold
        found[..., 3, :] = later * (fall / 2) - self.down_slope * self.end
        found[..., 4, :] = -((turn * blur) ** 2) * self.spectrum
        return found


def stroke_spectra(strokes: Array, frequency: Array) -> StrokeSpectra:
    """Spectra of strokes of height one.

    Args:
        strokes: (..., 5), :data:`PARAMETERS` of each.
        frequency: (n_freq,) Hz, above 0, evenly spaced, :data:`_BLOCK` of them at least. Spectra are of double or of
            single precision as both of these are.
    """
    turn, middle = 2 * np.pi * frequency, strokes[..., 0]
    times = np.exp(strokes[..., 1:])
    rise, hold, fall, blur = (times[..., k] for k in range(4))
    smooth = np.exp(-0.5 * (turn * blur[..., None]) ** 2) / (1j * turn)
    up, up_slope = _edge(turn, rise, frequency)
    down, down_slope = _edge(turn, fall, frequency)
    begin = _phasors(middle, frequency) * smooth
    end = _phasors(middle + rise / 2 + hold + fall / 2, frequency) * smooth
    falling = down * end
    return StrokeSpectra(up * begin - falling, begin, end, falling, up_slope, down_slope, times)


def _phasors(time: Array, frequency: Array) -> ComplexArray:
    """Values exp(-2 pi j f t) at evenly spaced frequencies, (...) s -> (..., n_freq) of its precision.

    They are products of the phasors of blocks and of the steps within a block, because exponentials cost more.
    """
    count = len(frequency)
    within = frequency[:_BLOCK] - frequency[0]
    turned = -2j * np.pi * time[..., None]
    found = np.exp(turned * frequency[::_BLOCK])[..., None] * np.exp(turned * within)[..., None, :]
    return np.asarray(found.reshape(*time.shape, -1)[..., :count])


def _edge(turn: Array, length: Array, frequency: Array) -> tuple[Array, Array]:
    """Spectrum of a half sine of area one and of a length, s, and its derivative by the logarithm of the length.

    Both are (..., n_freq), of the precision of the frequency. E(x) is pi / 2 sinc(y) / (2 + 2 y) with
    y = (x / pi - 1) / 2, so that nothing is divided by 0 where x is pi.
    """
    quarter = _phasors(length / 2, frequency)
    angle = turn * length[..., None]
    half = (angle / np.pi - 1) / 2
    near = np.abs(half) < _NEAR
    safe = np.where(near, 1.0, half)
    # sin(pi y) is -cos(x / 2), and cos(pi y) is sin(x / 2).
    square = (np.pi * half) ** 2
    sinc = np.where(near, 1 - square / 6 + square**2 / 120, -quarter.real / (np.pi * safe))
    slope = np.where(near, np.pi**2 * half * (square / 30 - 1 / 3), (-quarter.imag - sinc) / safe)
    below = 2 + 2 * half
    value = np.pi / 2 * sinc / below
    return value, angle / np.pi * (np.pi / 4 * slope - value) / below
