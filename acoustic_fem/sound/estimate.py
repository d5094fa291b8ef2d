"""Transfer functions of recorded signals: H1, H2 and Hv with coherence and standard deviation.

Records are cut into Hann segments that overlap by three quarters (Welch 1967), each with its straight line removed.
At every frequency a segment gives one complex amplitude X of the reference and Y of each output. H1 = Sxy / Sxx is the
least squares solution of Y = H X, H2 = Syy / Syx, and Hv their geometric mean (Rocklin, Crowley and Vold 1985): H1 is
free of bias where the noise is in the outputs, H2 where it is in the reference.

The standard deviation is that of a regression with the reference as it was: the residuals Y - H X of all segments
give the power of the noise, which the power of the reference divides. Unlike the formula in the coherence (Bendat and
Piersol 2010, eq. 9.52), which follows from it for random signals, it holds for a swept sine too, which excites each
frequency in a few segments only.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
import scipy.signal

from geometry.ground.argument_checks import check_choice, mismatch, out_of_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

#: Estimator of a transfer function: noise in the output, in the input, or in both.
Estimator = Literal["H1", "H2", "Hv"]

#: Seconds of a segment: half the main lobe of its window is 0.5 Hz, so that drift does not reach 1 Hz.
SEGMENT = 4.0
#: Segments begin this many times in the length of one. The squares of Hann windows then add up to a constant, so
#: that the first-order effect of the sensor's memory cancels over a sweep; with two it does not.
_PER_SEGMENT = 4
#: Correlation of white noise in two Hann windows one, two and three quarters of their length apart.
_SHARED = tuple(
    (1 - r) * (2 + math.cos(2 * math.pi * r)) / 3 + math.sin(2 * math.pi * r) / (2 * math.pi) for r in (0.25, 0.5, 0.75)
)
#: Segments without which a standard deviation means little.
LEAST_SEGMENTS = 16
#: Sample rate over the highest frequency, to which records are thinned out.
_OVERSAMPLING = 5.0
#: Radius of the disc that holds a circular normal number with a probability of 95 %, in standard deviations.
RADIUS_95 = math.sqrt(-2 * math.log(0.05))


@dataclass(frozen=True, eq=False)
class TransferEstimate:
    """Transfer functions from one reference to several outputs."""

    transfer_function: ComplexArray
    """Output per reference, (n_output, n_freq) complex128, in the unit of the outputs per that of the reference."""
    deviation: Array
    """One standard deviation of the real part, and of the imaginary part, (n_output, n_freq) float64, in its unit;
    circular.
    """
    coherence: Array
    """Coherence |Sxy|^2 / (Sxx Syy), (n_output, n_freq) float64, 0 to 1."""
    segments: int
    """Number of segments that were averaged."""

    @property
    def radius_95(self) -> Array:
        """Radius of the disc around the estimate that holds the true value with a probability of 95 %.

        (n_output, n_freq) float64, in the unit of the transfer function.
        """
        return RADIUS_95 * self.deviation


def shortest_record() -> float:
    """Shortest duration of a record, s."""
    return SEGMENT * (1 + (LEAST_SEGMENTS - 1) / _PER_SEGMENT)


def transfer_estimate(
    reference: Array, outputs: Array, rate: float, frequency: Array, estimator: Estimator = "H1"
) -> TransferEstimate:
    """Estimate transfer functions from a record.

    Args:
        reference: (n_sample,) float64, the signal that drives.
        outputs: (n_output, n_sample) float64, the signals that follow, sampled together with it.
        rate: samples per second, above 2.5 times the highest frequency.
        frequency: (n_freq,) float64, Hz, from 1 Hz on.
        estimator: ``H1``, ``H2`` or ``Hv``.

    Raises:
        Refusal: an unknown estimator, records of different lengths or too short, or a frequency out of range.
    """
    check_choice("estimator", estimator, get_args(Estimator))
    if outputs.ndim != 2 or outputs.shape[1:] != reference.shape:
        raise mismatch("outputs", f"has shape {outputs.shape}; it must be (n_output, {len(reference)})")
    if not (frequency.min() >= 1.0 and 2.5 * frequency.max() <= rate):
        allowed = f"between 1 and {rate / 2.5:g} Hz, the sample rate over 2.5"
        raise out_of_range("frequency", (float(frequency.min()), float(frequency.max())), allowed)
    amplitude = amplitudes(np.concatenate([reference[None], outputs]), rate, frequency)
    count = amplitude.shape[1]
    if count < LEAST_SEGMENTS:
        raise Refusal(
            f"of {len(reference) / rate:.3g} s has {count} segments of {SEGMENT:g} s; it must have at least "
            f"{LEAST_SEGMENTS} ({shortest_record():g} s)",
            kind=Kind.UNSUITABLE,
            field="reference",
        )
    x, y = amplitude[0], amplitude[1:]  # (segment, frequency), (output, segment, frequency)
    power = (np.abs(x) ** 2).sum(0)
    of_output = (np.abs(y) ** 2).sum(1)
    cross = (x.conj() * y).sum(1)
    with np.errstate(divide="ignore", invalid="ignore"):
        first = cross / power
        coherence = np.abs(cross) ** 2 / (power * of_output)
        # noise of neighbouring segments is correlated by what their windows share
        shared = 1 + sum(
            2 * rho * (x[:-lag].conj() * x[lag:]).real.sum(0) / power for lag, rho in enumerate(_SHARED, start=1)
        )
        residual = np.abs(y - first[:, None] * x) ** 2
        even = residual.sum(1) / (count - shared) / power
        # of each segment apart (White 1980; MacKinnon and White 1985, HC2): errors that grow with the signal
        weight = np.abs(x) ** 2 / power
        uneven = (weight * residual / (1 - weight)).sum(1) / power
        deviation = np.sqrt(np.maximum(even, uneven) * shared / 2)
        factor = {"H1": 0.0, "H2": 1.0, "Hv": 0.5}[estimator]
        scale = coherence**-factor
    return TransferEstimate(first * scale, deviation * scale, coherence, count)


def amplitudes(signals: Array, rate: float, frequency: Array, segment: float = SEGMENT) -> ComplexArray:
    """ComplexArray amplitudes of signals in segments, their phases counted from the beginning of the record.

    Args:
        signals: (n_signal, n_sample) float64.
        rate: samples per second.
        frequency: (n_freq,) float64, Hz.
        segment: duration, s; neighbours overlap by three quarters.

    Returns:
        (n_signal, n_segment, n_freq) complex128, in the unit of the signals.
    """
    step = max(1, math.floor(rate / (_OVERSAMPLING * frequency.max())))
    if step > 1:
        # the same filter for all channels leaves their ratios alone
        signals, rate = scipy.signal.resample_poly(signals, 1, step, axis=1, padtype="line"), rate / step
    size = round(segment * rate / _PER_SEGMENT) * _PER_SEGMENT
    pieces = np.lib.stride_tricks.sliding_window_view(signals, size, axis=1)[:, :: size // _PER_SEGMENT]
    pieces = scipy.signal.detrend(pieces, axis=2, type="linear")
    time = np.arange(size) / rate
    kernel = np.exp(-2j * np.pi * time[:, None] * frequency) * scipy.signal.get_window("hann", size)[:, None]
    start = np.arange(pieces.shape[1]) * (size // _PER_SEGMENT) / rate
    return np.asarray((pieces @ kernel) * np.exp(-2j * np.pi * start[:, None] * frequency))
