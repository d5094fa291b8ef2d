"""Signals of a sensor that is moved, and signals without what its motion adds.

The inertia of the membranes is a pressure on all of them at once
(:func:`acoustic_fem.library.acceleration.acceleration_response`). An accelerometer on the housing
measures the acceleration.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
import scipy.fft
import scipy.ndimage
import scipy.signal
from numpy.typing import ArrayLike

from acoustic_fem import Library
from acoustic_fem.network.microphone_output import output_response
from acoustic_fem.numerics.frequency_splines import interpolated_from_zero
from acoustic_fem.quantities.microphone_signals import OUTPUTS, Output
from geometry.ground.argument_checks import check_choice, check_range, real_numbers
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray
from localize.signals.stimulus import SAMPLE_RATE

#: Lowest and highest sample rate, Hz.
RATES = (10.0, 1e5)
#: Largest acceleration of a waved hand, m/s^2: what a slow wave of the forearm needs. Assumed.
WAVED = 5.0
#: Largest acceleration of a table under a knock, m/s^2. Assumed.
KNOCKED = 20.0
#: Corners of the low-passes that part a motion, so that a gain and its slope over frequency can be fitted, Hz. Chosen.
CORNERS = (2.0, 6.0, 20.0, 60.0, 150.0)
#: Frequency from which on a motion is fitted, Hz. Chosen.
LOWEST_FITTED = 2.0
#: Length of the windows whose residuals are compared, s. Chosen.
WINDOW = 0.3
#: Number of fits, each in the windows that the fit before it leaves without a touch. Chosen.
ROUNDS = 6
#: Residual of a window, as a multiple of the median in power, up to which it counts as one without a touch. Chosen.
USUAL = 4.0
#: Residual of an as-built sensor beside its motion before the fit, a fraction of the motion in amplitude. Assumed.
UNLIKE = 0.15
#: Standard deviation of the change of a part before the fit, a ratio. Assumed.
PRIOR = 0.3
#: Time within which residuals are correlated and count as one in the fit, s. Assumed.
CORRELATED = 0.1
#: Frequency that stands for 0 Hz in outputs of microphones, Hz.
_LEAST = 1e-3
#: Silence behind the signals, so that their end does not come back at their beginning, s.
_AFTER = 4.0


def motion_signals(
    library: Library, acceleration: ArrayLike, sample_rate: float = SAMPLE_RATE, output: Output = "pressure"
) -> Array:
    """Signals of the microphones while the sensor moves and nothing touches it.

    The responses are taken from 0 Hz to the end of the library; above they are taken to be 0.

    Args:
        library: of the array, with flat membranes.
        acceleration: of the housing along x, y and z of the layout, gravity left out, (3, n_sample), m/s^2.
        sample_rate: Hz.
        output: content of the signals: ``pressure`` in front of the microphones, or ``voltage``, their outputs, with
            the high-pass of their vents.

    Returns:
        (n_microphone, n_sample) float64, Pa.

    Raises:
        Refusal: an acceleration of another shape or that is not finite, a rate out of range, another content, or as of
            :func:`acoustic_fem.library.acceleration.acceleration_response`.
    """
    check_choice("output", output, OUTPUTS)
    response = np.asarray(library.acceleration_response.values)
    heard = partial(output_response, library.design.microphone, air=library.medium) if output == "voltage" else None
    return pressures_of_motion(response, library.frequency, acceleration, sample_rate, heard)


def pressures_of_motion(
    response: ComplexArray,
    frequency: Array,
    acceleration: ArrayLike,
    sample_rate: float = SAMPLE_RATE,
    output: Callable[[Array], ComplexArray] | None = None,
) -> Array:
    """Pressures at the microphones of a moved sensor by its response to accelerations.

    Args:
        response: pressure at a microphone per acceleration along x, y and z, (n_microphone, 3, n_freq) complex128,
            Pa s2/m.
        frequency: its frequencies, (n_freq,) float64, Hz.
        acceleration: as of :func:`motion_signals`, (3, n_sample), m/s^2.
        sample_rate: Hz.
        output: output of a microphone over the pressure in front of it, a ratio, from frequencies in Hz, both of shape
            (n_freq,); by default the signals are pressures.

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
    lines = np.asarray(scipy.fft.rfftfreq(length, 1 / sample_rate))
    through = _at(response, frequency, lines)
    if output is not None:
        through *= output(np.maximum(lines, _LEAST))
    return np.asarray(scipy.fft.irfft(np.einsum("maf,af->mf", through, spectrum), n=length)[:, :count])


def without_motion(
    library: Library,
    signals: ArrayLike,
    acceleration: ArrayLike,
    sample_rate: float = SAMPLE_RATE,
    output: Output = "pressure",
) -> Array:
    """Signals of the microphones less what the motion of the sensor adds to them.

    The motion that the library predicts is fitted to the signals (:func:`fitted_motion`).

    Args:
        library: of the array; a measured one knows its sensor better.
        signals: (n_microphone, n_sample) Pa.
        acceleration: measured at the same times, (3, n_sample), m/s^2, gravity left out.
        sample_rate: of both, Hz.
        output: content of the signals, as of :func:`motion_signals`.

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
    return heard - fitted_motion(heard, motion_signals(library, moved, sample_rate, output), sample_rate)


def fitted_motion(signals: Array, predicted: Array, sample_rate: float = SAMPLE_RATE) -> Array:
    """Motion of a sensor in its signals: what is predicted for its design, brought to the sensor as it is.

    An as-built sensor answers to acceleration with another gain, and another slope of it over frequency, at each
    microphone. The prediction and its parts below :data:`CORNERS` are fitted to the signals, where these hold no touch:
    in the windows whose residual is not above that of most, or small beside the motion. Where there is little motion,
    the prediction stays.

    Args:
        signals: (n_microphone, n_sample) float64, Pa.
        predicted: as of :func:`motion_signals`, (n_microphone, n_sample) float64, Pa.
        sample_rate: Hz.

    Returns:
        (n_microphone, n_sample) float64, Pa.
    """
    slow = scipy.signal.butter(2, LOWEST_FITTED, "highpass", fs=sample_rate, output="sos")
    below = [scipy.signal.butter(1, each, fs=sample_rate, output="sos") for each in CORNERS if each < 0.4 * sample_rate]
    window = max(1, round(WINDOW * sample_rate))
    found = np.empty_like(predicted)
    for k, (heard, motion) in enumerate(zip(signals, predicted, strict=True)):
        parts = np.stack([motion, *(scipy.signal.sosfilt(each, motion) for each in below)])
        basis = scipy.signal.sosfilt(slow, parts, axis=1)
        left = scipy.signal.sosfilt(slow, heard) - basis[0]
        change = np.zeros(len(parts))
        moved = scipy.ndimage.uniform_filter1d(basis[0] ** 2, window)
        for _ in range(ROUNDS):
            size = scipy.ndimage.uniform_filter1d((left - change @ basis) ** 2, window)
            usual = float(np.median(size))
            weight = ((size <= USUAL * usual) | (size <= UNLIKE**2 * moved)).astype(np.float64)
            # the usual residual is the noise of the fit; the floor keeps the system regular if there is none
            prior = np.eye(len(parts)) * max(usual, 1e-30) / PRIOR**2 * (CORRELATED * sample_rate)
            change = np.linalg.solve((basis * weight) @ basis.T + prior, (basis * weight) @ left)
        found[k] = motion + change @ parts
    return found


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
