"""How well the points of an array can be told apart, from its transfer functions alone.

A localizer that does not know the touch's own spectrum sees ratios of microphones: for points i and
microphones a, b the ratio r_i(f) = H_ia(f) / H_ib(f). Two points whose ratios agree over the whole band
cannot be told apart, however good the classifier is. Every figure here is a distance of such ratios; it knows
no noise, so that a pair that is far apart may still be lost below the microphone's noise.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array
from localize.signals.stimulus import BAND

if TYPE_CHECKING:
    import xarray as xr

    from acoustic_fem import Library

#: dB per neper.
DECIBEL = 20 / math.log(10)


def microphone_ratios(transfer_function: xr.DataArray) -> NDArray[np.complex128]:
    """Ratios H_ia / H_ib of every pair of microphones a < b.

    Args:
        transfer_function: (n_point, n_microphone, n_freq) complex, Pa/Pa; dimensions point, microphone, frequency (Hz).

    Returns:
        (n_point, n_pair, n_freq) complex128.
    """
    h = _values(transfer_function)
    return np.stack([h[:, a] / h[:, b] for a, b in combinations(range(h.shape[1]), 2)], axis=1)


def check_band(frequency: Array, band: tuple[float, float], metric: str) -> None:
    """Refuse a grid from which no mean over a band can be taken.

    Args:
        frequency: (n_freq,) float64, Hz, ascending.
        band: lowest and highest frequency, Hz.
        metric: name of the metric that needs the mean.

    Raises:
        Refusal: it begins above the band, ends below it, or has a step in it wider than half of it.
    """
    low, high = band
    over = frequency[(frequency > low) & (frequency < high)]
    step = float(np.diff(np.concatenate([[low], over, [high]])).max())
    if frequency[0] > low + 1e-6 or frequency[-1] < high - 1e-6 or step > (high - low) / 2 + 1e-6:
        raise Refusal(
            f"has {counted(len(frequency), 'value')} from {frequency[0]:g} to {frequency[-1]:g} Hz; metric {metric} "
            f"needs {low:g} to {high:g} Hz in steps of at most {(high - low) / 2:g} Hz",
            kind=Kind.UNSUITABLE,
            field="frequency",
        )


def attenuation(transfer_function: xr.DataArray, frequency: float) -> Array:
    """Loss 20 log10 |H| from each cavity to each microphone at one frequency.

    Zero means no loss. Between the frequencies of the grid the complex values are joined by straight
    lines.

    Args:
        transfer_function: (n_point, n_microphone, n_freq) complex, Pa/Pa; dimensions point, microphone, frequency (Hz).
        frequency: Hz.

    Returns:
        (n_point, n_microphone) float64, dB.

    Raises:
        Refusal: a frequency outside the grid.
    """
    return np.asarray(20 * np.log10(np.abs(_at(transfer_function, frequency))), np.float64)


def worst_heard(transfer_function: xr.DataArray, frequency: float) -> tuple[float, int]:
    """Point that is weakest at its second-loudest microphone (a ratio needs two): its level there, dB, and its number.

    Args:
        transfer_function: (n_point, n_microphone, n_freq) complex, Pa/Pa; dimensions point, microphone, frequency (Hz).
        frequency: Hz.

    Raises:
        Refusal: a frequency outside the grid.
    """
    second = np.sort(attenuation(transfer_function, frequency), axis=1)[:, -2]
    worst = int(np.argmin(np.round(second, 2)))  # of mirror images, the first
    return float(second[worst]), int(transfer_function["point"].values[worst])


def sensitivity(library: Library, frequency: float) -> Array:
    """Pressure at the loudest microphone per volume that a touch sweeps.

    A touch that would sweep the volume q of the membrane in vacuo injects j w q; see :class:`acoustic_fem.Library`.

    Args:
        library: of the design.
        frequency: Hz.

    Returns:
        (n_point,) float64, Pa/mm^3.

    Raises:
        Refusal: a frequency outside the grid.
    """
    pressure = np.abs(_at(library.source_response, frequency)).max(axis=1)
    return np.asarray(2 * np.pi * frequency * pressure * 1e-9, np.float64)


@dataclass(frozen=True)
class Disagreement:
    """Largest differences of two sets of transfer functions of one array."""

    magnitude: float
    """Largest deviation in magnitude, | |H| / |H_reference| - 1 |, of one."""
    magnitude_at: tuple[int, str, float]
    """Point, microphone and frequency (Hz) of the largest deviation in magnitude."""
    phase: float
    """Largest deviation in phase, |arg(H / H_reference)|, degrees."""
    phase_at: tuple[int, str, float]
    """Point, microphone and frequency (Hz) of the largest deviation in phase."""


def disagreement(
    transfer_function: xr.DataArray, reference: xr.DataArray, band: tuple[float, float] = BAND
) -> Disagreement:
    """Largest differences of two sets of transfer functions on one grid, within a band.

    Args:
        transfer_function: (n_point, n_microphone, n_freq) complex, Pa/Pa; dimensions point, microphone, frequency (Hz).
        reference: same shape as ``transfer_function``, Pa/Pa.
        band: lowest and highest frequency, Hz.

    Raises:
        Refusal: different points, microphones or frequencies, or no frequency in the band.
    """
    for name in ("point", "microphone", "frequency"):
        if not np.array_equal(transfer_function[name].values, reference[name].values):
            problem = f"has other coordinates {name} than transfer_function"
            raise Refusal(problem, kind=Kind.MISMATCH, field="reference")
    frequency = reference["frequency"].values
    inside = (frequency >= band[0] - 1e-9) & (frequency <= band[1] + 1e-9)
    if not inside.any():
        problem = f"has no frequency between {band[0]:g} and {band[1]:g} Hz"
        raise Refusal(problem, kind=Kind.UNSUITABLE, field="reference")
    ratio = (_values(transfer_function) / _values(reference))[..., inside]

    def largest(values: Array) -> tuple[float, tuple[int, str, float]]:
        i, m, k = np.unravel_index(int(np.argmax(values)), values.shape)
        where = (int(reference["point"].values[i]), str(reference["microphone"].values[m]), frequency[inside][k])
        return float(values[i, m, k]), (where[0], where[1], float(where[2]))

    magnitude, magnitude_at = largest(np.abs(np.abs(ratio) - 1))
    phase, phase_at = largest(np.abs(np.degrees(np.angle(ratio))))
    return Disagreement(magnitude, magnitude_at, phase, phase_at)


def _values(transfer_function: xr.DataArray) -> NDArray[np.complex128]:
    return np.asarray(transfer_function.transpose("point", "microphone", "frequency").values, np.complex128)


def _at(array: xr.DataArray, frequency: float) -> NDArray[np.complex128]:
    grid = np.asarray(array["frequency"].values, np.float64)
    check_range("frequency", frequency, grid[0] - 1e-9, grid[-1] + 1e-9, "Hz")
    values = _values(array)
    upper = min(int(np.searchsorted(grid, frequency)), len(grid) - 1)
    lower = max(upper - 1, 0)
    fraction = 0.0 if upper == lower else (frequency - grid[lower]) / (grid[upper] - grid[lower])
    return np.asarray((1 - fraction) * values[..., lower] + fraction * values[..., upper], np.complex128)


def trapezoidal_weights(frequency: Array) -> Array:
    """Weights of a mean over a linear axis by the trapezoidal rule, summing to 1.

    Args:
        frequency: (n_freq,) float64, Hz, ascending.

    Returns:
        (n_freq,) float64.
    """
    steps = np.diff(frequency)
    weights = np.zeros_like(frequency)
    weights[:-1] += steps / 2
    weights[1:] += steps / 2
    return weights / weights.sum()
