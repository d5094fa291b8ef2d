"""The pulse of an artery under a finger: where it is felt, its waveform, the three waves of each beat, the heart rate.

A beat is too slow for a frame of 250 ms to name its point. The decoder of points therefore hears it four times as
fast, in frames of a second, with the spectrum of a pulse for that of a touch. The waveform is the force on the
membrane: the Wiener filter of :mod:`localize.decoders.reconstruct`, with the responses to a force in place of those to
a pressure. Its waves are where it is bent most: minima of the second derivative, as in the acceleration
plethysmogram (Takazawa et al. 1998, Hypertension 32, 365).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import scipy.signal
from numpy.typing import ArrayLike

from acoustic_fem import Library
from geometry.ground.refusal import Refusal
from geometry.ground.typed import Array
from localize.decoders.frame_covariance import INTEGRATION_STEP, SAMPLES, SOURCE_RMS, touch_covariances, whitening
from localize.decoders.level_likelihood import LevelLikelihood
from localize.decoders.library_decoder import PointDecoder
from localize.decoders.options import DecoderOptions
from localize.decoders.reconstruct import Reconstructor
from localize.decoders.surroundings import Surroundings
from localize.recognition.takes import prepared
from localize.signals.array_response import ArrayResponse, interpolated_from_zero, response_of
from localize.signals.frames import checked_signals
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.stimulus import BAND, SAMPLE_RATE

RATES = (40.0, 160.0)
"""Lowest and highest heart rate that is looked for, beats a minute."""
LEAST = 3.0
"""Shortest recording that a pulse is read from, s: two beats at the lowest rate."""
FORCE = 2e-5
"""Force of a pulse that the filter expects, N rms; an array without a design is taken to be touched by :data:`FELT`."""
FELT = 0.05
"""Pressure of a pulse in the cavity that the filter expects, Pa rms."""
WINDOW, LATENCY = 250, 16
"""Window and latency of the filter, samples."""
SLOWER = 4
"""Times that frames of the decoder of pulses are longer than those of touches."""
SOFT, SLOPE = 4.0, 6.0
"""Corner of the spectrum of a pulse, Hz, and the slope of its power above: the wave is round."""
HEARD_NOISE = 2.0
"""Noise that the decoder is told, over that of the microphones: it assumes a quarter of it, for touches are loud, and a
pulse is near the noise."""
SMOOTH = 0.02
"""Standard deviation of the Gaussian in which the second derivative is taken, s."""
AFTER = {"tidal": (0.07, 0.22), "dicrotic": (0.24, 0.44)}
"""Time after the percussion wave in which each other wave is looked for, at 75 beats a minute, s; it goes with the root
of the beat's length."""
END_APART = 0.15
"""Difference of the first or last interval from the median one, a share of it, from which the beat at that end is
none."""
LEAST_BEND = 0.02
"""Bend of a wave, as a share of that of the percussion wave, from which it is there."""


@dataclass(frozen=True, eq=False)
class PulseReading:
    """Pulse that was read from a recording."""

    point: int
    """Point under which it is felt, from 1."""
    probability: float
    """Probability of that point."""
    waveform: Array
    """Force on the membrane, N, or pressure in the cavity, Pa, of an array without a design; NaN at the ends;
    (n_sample,) float64, at 1 kHz."""
    waves: dict[str, Array]
    """Times of the percussion, tidal and dicrotic wave of each beat, NaN where there is none; (n_beat,) float64, s."""
    rate: float
    """Heart rate, beats a minute; NaN where there are no two beats."""
    rate_deviation: float
    """Standard deviation of that mean, from how beats differ, beats a minute; NaN with less than three beats."""


class PulseDecoder:
    """Decoder of the points under which pulses are felt; time runs :data:`SLOWER` times as fast for it.

    Args:
        library: of the array, over 1 to 100 Hz.
        microphone_noise: as of :class:`localize.BayesDecoder`.
    """

    def __init__(self, library: Library | ArrayResponse, microphone_noise: NoiseChoice = "design") -> None:
        response = response_of(library)
        noise = response.noise(microphone_noise)
        own = None
        if isinstance(noise, NoiseSpectrum):
            hertz = np.arange(len(noise.power))
            # It has no noise below 1 Hz, where it would grow without limit.
            power = np.interp(np.maximum(hertz / SLOWER, 1.0), hertz, noise.power) / SLOWER
            own = NoiseSpectrum(power * HEARD_NOISE**2, noise.source)
            microphone_noise = "design"
        else:
            microphone_noise = noise * HEARD_NOISE / math.sqrt(SLOWER)
        faster = _faster(response, own)
        around = Surroundings.of(faster, microphone_noise)
        touched = touch_covariances(faster, np.eye(SAMPLES), _pulse_density)
        self._decoder = PointDecoder(
            faster, around, LevelLikelihood(touched, faster, around, DecoderOptions(), _whitening)
        )

    def named(self, signals: Array) -> Array:
        """Probability of each point, (n_point,) float64.

        Args:
            signals: (n_microphone, n_sample) float64, Pa at 1 kHz, at least a second.
        """
        return self._decoder.locate(scipy.signal.resample_poly(signals, 1, SLOWER, axis=1, padtype="line"))


def _pulse_density(frequency: Array) -> Array:
    """Power density of a pulse to a clock that is slower, Pa^2/Hz."""
    shape = 1 / (1 + (frequency / SLOWER / SOFT) ** SLOPE)
    return np.asarray(SOURCE_RMS**2 * shape / (shape.sum() * INTEGRATION_STEP))


def _whitening(response: ArrayResponse, noise: float | NoiseSpectrum, level: float | None) -> Array:
    """Without hum of mains, which lies above what is left of the signals."""
    return np.asarray(np.kron(np.eye(len(response.microphones)), whitening(noise)))


def _faster(response: ArrayResponse, noise: NoiseSpectrum | None) -> ArrayResponse:
    """What an array is to a clock that is slower."""
    top = min(float(response.frequency[-1]), SAMPLE_RATE / 2 / SLOWER)
    frequency = np.arange(BAND[0] / SLOWER, top + 1e-9, BAND[0] / SLOWER)
    return replace(
        response,
        transfer_function=interpolated_from_zero(
            response.transfer_function, response.frequency, frequency, response.sealed
        ),
        frequency=frequency * SLOWER,
        own_noise=noise,
        ambient_response=None,
        vent_ratio=None,
        cavity_response=None,
        sealed=False,
    )


class PulseReader:
    """Reader of pulses on one array.

    Args:
        library: of the array, over 1 to 100 Hz; steps of 0.25 Hz serve slow hearts.
        microphone_noise: as of :class:`localize.BayesDecoder`.
    """

    def __init__(self, library: Library | ArrayResponse, microphone_noise: NoiseChoice = "design") -> None:
        response = response_of(library)
        self._decoder = PulseDecoder(response, microphone_noise)
        forced = response.force_response
        through = response if forced is None else replace(response, transfer_function=forced, sealed=False)
        rms = FELT if forced is None else FORCE
        self._filters = Reconstructor(through, microphone_noise, WINDOW, LATENCY, rms)
        self.microphones = response.microphones

    def read(self, signals: ArrayLike, point: int | None = None) -> PulseReading:
        """Pulse of a recording.

        Args:
            signals: (n_microphone, n_sample), Pa at 1 kHz, at least 3 s.
            point: under which it is felt, from 1; by default the one that the decoder names over the whole of it.

        Raises:
            Refusal: less than 3 s, no such point, or as :meth:`localize.BayesDecoder.locate`.
        """
        batch, _ = checked_signals(signals, self.microphones)
        given = batch[0]
        if given.shape[1] < LEAST * SAMPLE_RATE:
            raise Refusal(
                f"signals last {given.shape[1] / SAMPLE_RATE:g} s, must last at least {LEAST:g} s for a pulse"
            )
        probability = self._decoder.named(prepared(given))
        felt = int(probability.argmax()) + 1 if point is None else point
        waveform = self._filters.waveform(given, felt).pressure[0]
        waves = waves_of(waveform)
        between = np.diff(waves["percussion"])
        rate = 60 / float(between.mean()) if len(between) else float("nan")
        spread = float(between.std(ddof=1) / np.sqrt(len(between))) if len(between) > 1 else float("nan")
        return PulseReading(felt, float(probability[felt - 1]), waveform, waves, rate, rate**2 / 60 * spread)


def waves_of(waveform: Array) -> dict[str, Array]:
    """Times of the waves of each beat.

    Args:
        waveform: (n_sample,) float64 at 1 kHz, of any unit; NaN where it is not known.

    Returns:
        (n_beat,) float64 each, s, by name; NaN where a wave is not there.
    """
    known = np.flatnonzero(np.isfinite(waveform))
    begin = int(known[0])
    reach = round(4 * SMOOTH * SAMPLE_RATE)
    lag = np.arange(-reach, reach + 1) / SAMPLE_RATE / SMOOTH
    bend = -np.convolve(waveform[known] - waveform[known].mean(), (lag**2 - 1) * np.exp(-0.5 * lag**2), "same")
    bend[:reach], bend[-reach:] = 0.0, 0.0  # the ends are steps
    beat = _beat(bend)
    first, _ = scipy.signal.find_peaks(bend, distance=round(0.6 * beat), height=0.4 * np.quantile(bend, 0.995))
    found = {"percussion": (begin + first) / SAMPLE_RATE}
    lengths = np.append(np.diff(first), beat) if len(first) else np.zeros(0)
    for name, limits in AFTER.items():
        own = []
        for at, length in zip(first, lengths, strict=True):
            stretch = np.sqrt(min(length, 1.5 * beat) / SAMPLE_RATE / 0.8)
            low, high = (at + round(limit * stretch * SAMPLE_RATE) for limit in limits)
            peaks, _ = scipy.signal.find_peaks(bend[low : high + 1], height=LEAST_BEND * bend[at])
            own.append((begin + low + peaks[bend[low + peaks].argmax()]) / SAMPLE_RATE if len(peaks) else np.nan)
        found[name] = np.array(own)
    beats = _between_ends(found["percussion"])
    return {name: own[beats] for name, own in found.items()}


def _between_ends(percussion: Array) -> slice:
    """Beats without the first or the last where that stands apart: a contact that comes or goes bends, too."""
    between = np.diff(percussion)
    if len(between) < 3:
        return slice(None)
    apart = np.abs(between / np.median(between) - 1) > END_APART
    return slice(int(apart[0]), len(percussion) - int(apart[-1]))


def _beat(bend: Array) -> float:
    """Samples from beat to beat: the lag at which the waveform is most like itself."""
    shortest, longest = (round(60 / rate * SAMPLE_RATE) for rate in RATES[::-1])
    longest = min(longest, len(bend) - 1)
    size = 2 * len(bend)
    like = np.fft.irfft(np.abs(np.fft.rfft(bend, size)) ** 2, size)[: longest + 1]
    like /= np.arange(len(bend), len(bend) - longest - 1, -1)  # fewer samples overlap at long lags
    peaks, _ = scipy.signal.find_peaks(like[shortest:])
    if not len(peaks):
        return float(shortest + like[shortest:].argmax())
    strong = peaks[like[shortest + peaks] > 0.8 * like[shortest + peaks].max()]
    return float(shortest + strong[0])  # not two beats at once
