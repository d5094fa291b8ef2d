"""Signals of a sensor that is moved, and signals without what its motion adds.

The inertia of the membranes is a pressure on all of them at once
(:func:`acoustic_fem.library.acceleration.acceleration_response`). An accelerometer on the housing tells it.
"""

from __future__ import annotations

import numpy as np
import scipy.fft
from numpy.typing import ArrayLike

from acoustic_fem import Library
from acoustic_fem.numerics.frequency_splines import interpolated_from_zero
from geometry.ground.argument_checks import check_range, real_numbers
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray
from localize.signals.stimulus import SAMPLE_RATE

#: Lowest and highest sample rate, Hz.
RATES = (10.0, 1e5)
#: Silence behind the signals, so that their end does not come back at their beginning, s.
_AFTER = 4.0


def motion_signals(library: Library, acceleration: ArrayLike, sample_rate: float = SAMPLE_RATE) -> Array:
    """Pressures at the microphones while the sensor moves and nothing touches it.

    The responses are taken from 0 Hz to the end of the library; above they are taken to be 0.

    Args:
        library: of the array, with flat membranes.
        acceleration: of the housing along x, y and z of the layout, gravity left out, (3, n_sample), m/s^2.
        sample_rate: Hz.

    Returns:
        (n_microphone, n_sample) float64, Pa.

    Raises:
        Refusal: an acceleration of another shape or that is not finite, a rate out of range, or as of
            :func:`acoustic_fem.library.acceleration.acceleration_response`.
    """
    moved = _checked(acceleration)
    check_range("sample_rate", sample_rate, *RATES, "Hz")
    count = moved.shape[1]
    length = scipy.fft.next_fast_len(count + round(_AFTER * sample_rate), real=True)
    spectrum = scipy.fft.rfft(moved, n=length)
    through = _response(library, np.asarray(scipy.fft.rfftfreq(length, 1 / sample_rate)))
    return np.asarray(scipy.fft.irfft(np.einsum("maf,af->mf", through, spectrum), n=length)[:, :count])


def without_motion(
    library: Library, signals: ArrayLike, acceleration: ArrayLike, sample_rate: float = SAMPLE_RATE
) -> Array:
    """Signals of the microphones less what the motion of the sensor adds to them.

    Args:
        library: of the array; a measured one knows its sensor better.
        signals: (n_microphone, n_sample) Pa.
        acceleration: measured at the same times, (3, n_sample), m/s^2, gravity left out.
        sample_rate: of both, Hz.

    Returns:
        (n_microphone, n_sample) float64, Pa.

    Raises:
        Refusal: signals that do not fit the array or the acceleration; as of :func:`motion_signals`.
    """
    heard, moved = real_numbers("signals", signals), _checked(acceleration)
    expected = (len(library.design.microphones), moved.shape[1])
    if heard.shape != expected:
        raise Refusal(
            f"has shape {heard.shape}, must be (n_microphone, n_sample) = {expected}",
            kind=Kind.MISMATCH,
            field="signals",
        )
    return heard - motion_signals(library, moved, sample_rate)


def _checked(acceleration: ArrayLike) -> Array:
    moved = real_numbers("acceleration", acceleration)
    if moved.ndim != 2 or len(moved) != 3 or moved.shape[1] < 1:
        raise Refusal(
            f"has shape {moved.shape}, must be (3, n_sample), along x, y and z",
            kind=Kind.WRONG_TYPE,
            field="acceleration",
        )
    return moved


def _response(library: Library, frequency: Array) -> ComplexArray:
    """(n_microphone, 3, n) Pa s2/m, 0 above the end of the library."""
    grid = library.frequency
    known = frequency <= grid[-1]
    found = np.zeros((len(library.design.microphones), 3, len(frequency)), np.complex128)
    values = np.asarray(library.acceleration_response.values)
    found[..., known] = interpolated_from_zero(values, grid, frequency[known], False)
    found[..., frequency == 0] = found[..., frequency == 0].real
    return found
