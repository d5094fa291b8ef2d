"""Signals of a library in time, for forces on its membranes: behind :meth:`acoustic_fem.Library.simulate`."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import scipy.fft
from scipy.optimize import brentq

from acoustic_fem.circuit.state_space import FEWEST_FREQUENCIES, SLOWEST, TOLERANCES, fit_sensor
from acoustic_fem.library.transfer_functions import VARIABLES, Library
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry.ground.caller_warnings import warn_caller
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array

#: Error of the fit to a library that was computed; it is chosen for accuracy, not for a small order.
SIMULATED = 3e-4
#: Peak of the force above the library's last frequency, relative to the largest force, above which a simulation warns.
ABOVE_WARNED = 0.01
#: Probability with which noise of a measured library exceeds the error of the fit to it anywhere, at most.
EXCEEDED = 0.05
#: Samples for each period of the last frequency, at least, with which that part of a force is found.
_BY_PERIOD = 16


def simulate(
    library: Library,
    force: Any,
    rate: float,
    *,
    touch: str = "force",
    output: str = "pressure",
    tolerance: float | None = None,
) -> Array:
    """Signals of the microphones while membranes are pressed.

    The fit begins at 1 mHz. Arguments and errors as in :meth:`acoustic_fem.Library.simulate`.

    Args:
        library: of the sensor.
        force: (n_point, n_sample) real numbers, N or m^3/s.
        rate: samples per second, Hz.
        touch: one of :data:`acoustic_fem.circuit.INPUTS`.
        output: one of :data:`acoustic_fem.circuit.OUTPUTS`.
        tolerance: error of the fit; None: :data:`SIMULATED`, or that of the measurement.

    Returns:
        (n_microphone, n_sample) float64, Pa or V.
    """
    if len(library.frequency) < FEWEST_FREQUENCIES:
        raise Refusal(
            f"has {len(library.frequency)} frequencies; a simulation needs at least {FEWEST_FREQUENCIES}",
            kind=Kind.OUT_OF_RANGE,
            field="library",
        )
    top = float(library.frequency[-1])
    error = default_tolerance(library) if tolerance is None else tolerance
    model = fit_sensor(library, touch=touch, output=output, tolerance=error, band=(SLOWEST, top), passive=False)
    signals = model.simulate(force, rate)
    above = peak_above(np.asarray(force, np.float64), rate, top)
    if above > ABOVE_WARNED:
        warn_caller(
            f"force: its part above {top:g} Hz, the last frequency of the library, peaks at {100 * above:.2g} % of the "
            "largest force, and the signals of that part are wrong; solve the library to a higher frequency, or let "
            "the force rise and fall more slowly",
            ModelLimitWarning,
        )
    return signals


def default_tolerance(library: Library) -> float:
    """Error of the fit that a library deserves, relative to the magnitude of each response.

    Few poles do not follow the noise of a measurement. So for a measured library it is the error that all its values
    keep with a probability of 95 %, if their real and imaginary parts are Gaussian with its standard deviations.

    Args:
        library: of the sensor.
    """
    if library.transfer_function_deviation is None:
        return SIMULATED
    order = VARIABLES["transfer_function"][0]
    deviation = library.transfer_function_deviation.transpose(*order).values
    relative = (deviation / np.abs(library.transfer_function.transpose(*order).values)).ravel()
    relative = relative[relative > 0]
    if not len(relative):
        return SIMULATED
    largest = float(relative.max())

    def excess(error: float) -> float:
        return float(np.exp(-((error / relative) ** 2) / 2).sum()) - EXCEEDED

    kept = brentq(excess, 0.0, largest * math.sqrt(2 * math.log(2 * len(relative) / EXCEEDED)))
    return float(np.clip(kept, SIMULATED, TOLERANCES[1]))


def peak_above(force: Array, rate: float, frequency: float) -> float:
    """Peak of the part of forces above a frequency, relative to the largest force.

    The forces are straight between samples, so they have frequencies above half of the rate too. A force that goes on
    at the end of the record counts as one that does not bend there.

    Args:
        force: (n_point, n_sample) float64, 0 before the first sample.
        rate: samples per second, Hz.
        frequency: Hz.
    """
    largest = float(np.abs(force).max())
    if largest == 0:
        return 0.0
    finer = max(1, math.ceil(_BY_PERIOD * frequency / rate))
    before = np.zeros(math.ceil(rate / frequency) + 1)
    found = 0.0
    for row in force[np.abs(force).max(axis=1) > ABOVE_WARNED / 2 * largest]:
        slope = np.diff(row, prepend=0.0) * rate
        mirrored = np.repeat(np.concatenate([before, slope, slope[::-1], before]), finer)
        length = scipy.fft.next_fast_len(len(mirrored), real=True)
        lines = scipy.fft.rfftfreq(length, 1 / (rate * finer))
        spectrum = scipy.fft.rfft(mirrored, length)
        high = lines > frequency
        spectrum[~high] = 0.0
        # The sum of the steps up to each sample is the force there.
        spectrum[high] /= rate * finer * (1 - np.exp(-2j * np.pi * lines[high] / (rate * finer)))
        found = max(found, float(np.abs(scipy.fft.irfft(spectrum, length)).max()))
    return found / largest
