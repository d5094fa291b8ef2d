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
#: Largest acceleration of a waved hand, m/s^2: what a slow wave of the forearm needs. Assumed.
WAVED = 5.0
#: Largest acceleration of a table under a knock, m/s^2. Assumed.
KNOCKED = 20.0
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
    response = np.asarray(library.acceleration_response.values)
    return pressures_of_motion(response, library.frequency, acceleration, sample_rate)


def pressures_of_motion(
    response: ComplexArray, frequency: Array, acceleration: ArrayLike, sample_rate: float = SAMPLE_RATE
) -> Array:
    """Pressures at the microphones of a moved sensor by its response to accelerations.

    Args:
        response: pressure at a microphone per acceleration along x, y and z, (n_microphone, 3, n_freq) complex128,
            Pa s2/m.
        frequency: its frequencies, (n_freq,) float64, Hz.
        acceleration: as of :func:`motion_signals`, (3, n_sample), m/s^2.
        sample_rate: Hz.

    Returns:
        (n_microphone, n_sample) float64, Pa.

    Raises:
        Refusal: an acceleration of another shape or that is not finite, or a rate out of range.
    """
    moved = _checked(acceleration)
    check_range("sample_rate", sample_rate, *RATES, "Hz")
    count = moved.shape[1]
    length = scipy.fft.next_fast_len(count + round(_AFTER * sample_rate), real=True)
    spectrum = scipy.fft.rfft(moved, n=length)
    through = _at(response, frequency, np.asarray(scipy.fft.rfftfreq(length, 1 / sample_rate)))
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


def _at(response: ComplexArray, grid: Array, frequency: Array) -> ComplexArray:
    """(n_microphone, 3, n) Pa s2/m, 0 above the end of the grid."""
    known = frequency <= grid[-1]
    found = np.zeros((*response.shape[:2], len(frequency)), np.complex128)
    found[..., known] = interpolated_from_zero(response, grid, frequency[known], False)
    found[..., frequency == 0] = found[..., frequency == 0].real
    return found
