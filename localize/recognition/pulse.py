"""The pulse of an artery under a finger: where it is felt, its waveform, the three waves of each beat, the heart rate.

A beat is too slow for a frame of 250 ms to name its point. The decoder of points therefore hears it four times as
fast, in frames of a second, with the spectrum of a pulse for that of a touch. The waveform is the force on the
membrane: the Wiener filter of :mod:`localize.decoders.reconstruct`, with the responses to a force in place of those to
a pressure. Its waves are where it is bent most: minima of the second derivative, as in the acceleration
plethysmogram (Takazawa et al. 1998, Hypertension 32, 365).

Noise has peaks too. They are a pulse only if the waveform around them is alike from beat to beat: each beat is compared
with the mean of the others. This does not need a regular heart.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import partial

import numpy as np
import scipy.signal
from numpy.typing import ArrayLike

from acoustic_fem import Library
from acoustic_fem.numerics.frequency_splines import interpolated_from_zero
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.decoder_options import DecoderOptions
from localize.decoders.frame_covariance import INTEGRATION_STEP, SAMPLES, SOURCE_RMS, touch_covariances, whitening
from localize.decoders.library_decoder import PointDecoder
from localize.decoders.reconstruct import Reconstructor
from localize.decoders.surroundings import Surroundings
from localize.recognition.recognition_options import PulseOptions
from localize.recognition.takes import prepared
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import checked_signals
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.stimulus import BAND, SAMPLE_RATE


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
    missing: str
    """Reason why there is no pulse, in words; empty where there is one."""
    likeness: float
    """Likeness of the beats: correlation of each with the mean of the others, the median over the beats, from -1 to 1;
    NaN with less than two beats."""
    waves: dict[str, Array]
    """Times of the percussion, tidal and dicrotic wave of each beat, NaN for a wave that is not found; (n_beat,)
    float64, s; without a pulse there is no beat."""
    rate: float
    """Heart rate, beats a minute; NaN without a pulse."""
    rate_deviation: float
    """Standard deviation of that mean, from how beats differ, beats a minute; NaN with less than three beats."""
    options: PulseOptions = field(default_factory=PulseOptions)
    """Options of the reading."""

    @property
    def found(self) -> bool:
        """True if there is a pulse: beats that are alike, at a rate of a heart."""
        return not self.missing

    @property
    def rms(self) -> float:
        """Variation of the waveform about its mean, rms, in its unit."""
        return float(np.nanstd(self.waveform))


class PulseDecoder:
    """Decoder of the points under which pulses are felt; time runs ``options.slower`` times as fast for it.

    Args:
        library: of the array, over 1 to 100 Hz.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        options: numbers that tune the reading.
    """

    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = "design",
        options: PulseOptions = PulseOptions(),
    ) -> None:
        self.options = options
        response = response_of(library)
        noise = response.noise(microphone_noise)
        own = None
        if isinstance(noise, NoiseSpectrum):
            hertz = np.arange(len(noise.power))
            # It has no noise below 1 Hz, where it would grow without limit.
            power = np.interp(np.maximum(hertz / options.slower, 1.0), hertz, noise.power) / options.slower
            own = NoiseSpectrum(power * options.noise_ratio**2, noise.source)
            microphone_noise = "design"
        else:
            microphone_noise = noise * options.noise_ratio / math.sqrt(options.slower)
        faster = _faster(response, own, options.slower)
        around = Surroundings.of(faster, microphone_noise)
        touched = touch_covariances(faster, np.eye(SAMPLES), partial(_pulse_density, options=options))
        self._decoder = PointDecoder(faster, around, touched, DecoderOptions(), _whitening)

    def named(self, signals: Array) -> Array:
        """Probability of each point, (n_point,) float64.

        Args:
            signals: (n_microphone, n_sample) float64, Pa at 1 kHz, at least a second.
        """
        return self._decoder.locate(scipy.signal.resample_poly(signals, 1, self.options.slower, axis=1, padtype="line"))


def _pulse_density(frequency: Array, options: PulseOptions) -> Array:
    """Power density of a pulse to a clock that is slower, Pa^2/Hz."""
    shape = 1 / (1 + (frequency / options.slower / options.corner) ** options.slope)
    return np.asarray(SOURCE_RMS**2 * shape / (shape.sum() * INTEGRATION_STEP))


def _whitening(response: ArrayResponse, noise: float | NoiseSpectrum, level: float | None) -> Array:
    """Without hum of mains, which lies above what is left of the signals."""
    return np.asarray(np.kron(np.eye(len(response.microphones)), whitening(noise)))


def _faster(response: ArrayResponse, noise: NoiseSpectrum | None, slower: int) -> ArrayResponse:
    """The array for a clock that is slower."""
    top = min(float(response.frequency[-1]), SAMPLE_RATE / 2 / slower)
    frequency = np.arange(BAND[0] / slower, top + 1e-9, BAND[0] / slower)
    return replace(
        response,
        transfer_function=interpolated_from_zero(
            response.transfer_function, response.frequency, frequency, response.sealed
        ),
        frequency=frequency * slower,
        own_noise=noise,
        ambient_response=None,
        vent_ratio=None,
        cavity_response=None,
        sealed=False,
        closed_form=None,
    )


class PulseReader:
    """Reader of pulses on one array.

    Args:
        library: of the array, over 1 to 100 Hz; steps of 0.25 Hz serve slow hearts.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        options: numbers that tune the reading.
    """

    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = "design",
        options: PulseOptions = PulseOptions(),
    ) -> None:
        self.options = options
        response = response_of(library)
        self._decoder = PulseDecoder(response, microphone_noise, options)
        forced = response.force_response
        through = (
            response if forced is None else replace(response, transfer_function=forced, sealed=False, closed_form=None)
        )
        rms = options.pressure if forced is None else options.force
        self._filters = Reconstructor(through, microphone_noise, options.window, options.latency, rms)
        self.microphones = response.microphones

    def read(self, signals: ArrayLike, point: int | None = None) -> PulseReading:
        """Pulse of a recording.

        Args:
            signals: (n_microphone, n_sample), Pa at 1 kHz, at least 3 s.
            point: number of the point under the finger, from 1; by default the point that the decoder finds from the
                whole recording.

        Raises:
            Refusal: less than 3 s, no such point, or as :meth:`localize.BayesDecoder.locate`.
        """
        batch, _ = checked_signals(signals, self.microphones)
        given = batch[0]
        if given.shape[1] < self.options.shortest * SAMPLE_RATE:
            raise Refusal(
                f"lasts {given.shape[1] / SAMPLE_RATE:g} s, must last at least {self.options.shortest:g} s for a pulse",
                kind=Kind.UNSUITABLE,
                field="signals",
            )
        probability = self._decoder.named(prepared(given))
        felt = int(probability.argmax()) + 1 if point is None else point
        waveform = self._filters.waveform(given, felt).pressure[0]
        waves = waves_of(waveform, self.options)
        likeness, compared = likeness_of(waveform, waves["percussion"], self.options)
        between = np.diff(waves["percussion"])
        rate = 60 / float(between.mean()) if len(between) else float("nan")
        spread = float(between.std(ddof=1) / np.sqrt(len(between))) if len(between) > 1 else float("nan")
        missing = _missing(likeness, compared, between, self.options)
        if missing:
            waves, rate, spread = {name: np.zeros(0) for name in waves}, float("nan"), float("nan")
        return PulseReading(
            felt,
            float(probability[felt - 1]),
            waveform,
            missing,
            likeness,
            waves,
            rate,
            rate**2 / 60 * spread,
            self.options,
        )


def _missing(likeness: float, compared: int, between: Array, options: PulseOptions) -> str:
    """Reason why beats are no pulse; empty if they are one."""
    if compared < 2 or not len(between):
        return "there are no two beats"
    least = options.least_alike if compared > 3 else options.least_alike_of_few
    if likeness < least:
        return f"{compared} peaks are alike to {likeness:.2f}, beats must be to {least:g}"
    slowest, fastest = options.rates
    rate, uneven = 60 / float(between.mean()), float(between.std() / between.mean())
    if not slowest <= rate <= fastest:
        return f"{rate:.1f} peaks a minute are no heart's {slowest:g} to {fastest:g}"
    if uneven > options.most_uneven:
        return (
            f"the time between peaks varies by {100 * uneven:.0f} %, that of a heart by {100 * options.most_uneven:g}"
        )
    return ""


def likeness_of(waveform: Array, percussion: Array, options: PulseOptions = PulseOptions()) -> tuple[float, int]:
    """Likeness of the beats of a waveform.

    Args:
        waveform: (n_sample,) float64 at 1 kHz, of any unit; NaN where it is not known.
        percussion: (n_beat,) float64, times of the percussion waves, s.
        options: numbers that tune the reading.

    Returns:
        Correlation of the second derivative around each percussion wave with the mean of that around the others, the
        median over the beats, NaN with less than two; and the number of beats that lie within the waveform.
    """
    begin, bend = _bend(waveform, options)
    before, after = (round(each * SAMPLE_RATE) for each in options.around)
    at = np.round(percussion * SAMPLE_RATE).astype(int) - begin
    whole = [bend[each - before : each + after + 1] for each in at if before <= each < len(bend) - after]
    if len(whole) < 2:
        return float("nan"), len(whole)
    beats = np.array(whole) - np.mean(whole, axis=1, keepdims=True)
    others = beats.sum(0) - beats
    sizes = np.linalg.norm(beats, axis=1) * np.linalg.norm(others, axis=1)
    return float(np.median((beats * others).sum(1) / np.maximum(sizes, np.finfo(float).tiny))), len(whole)


def waves_of(waveform: Array, options: PulseOptions = PulseOptions()) -> dict[str, Array]:
    """Times of the waves of each beat.

    Args:
        waveform: (n_sample,) float64 at 1 kHz, of any unit; NaN where it is not known.
        options: numbers that tune the reading.

    Returns:
        (n_beat,) float64 each, s, by name; NaN where a wave is not there.
    """
    begin, bend = _bend(waveform, options)
    beat = _beat(bend, options.rates)
    first, _ = scipy.signal.find_peaks(bend, distance=round(0.55 * beat), height=0.4 * _usual_height(bend, beat))
    found = {"percussion": (begin + first) / SAMPLE_RATE}
    lengths = np.append(np.diff(first), beat) if len(first) else np.zeros(0)
    for name, limits in (("tidal", options.tidal), ("dicrotic", options.dicrotic)):
        own = []
        for at, length in zip(first, lengths, strict=True):
            stretch = np.sqrt(min(length, 1.5 * beat) / SAMPLE_RATE / 0.8)
            low, high = (at + round(limit * stretch * SAMPLE_RATE) for limit in limits)
            peaks, _ = scipy.signal.find_peaks(bend[low : high + 1], height=options.least_bend * bend[at])
            own.append((begin + low + peaks[bend[low + peaks].argmax()]) / SAMPLE_RATE if len(peaks) else np.nan)
        found[name] = np.array(own)
    beats = _between_ends(found["percussion"], options.end_apart)
    return {name: own[beats] for name, own in found.items()}


def _bend(waveform: Array, options: PulseOptions) -> tuple[int, Array]:
    """First sample that is known, and the second derivative from there on, its sign changed; 0 at the ends."""
    known = np.flatnonzero(np.isfinite(waveform))
    reach = round(4 * options.smooth * SAMPLE_RATE)
    lag = np.arange(-reach, reach + 1) / SAMPLE_RATE / options.smooth
    bend = -np.convolve(waveform[known] - waveform[known].mean(), (lag**2 - 1) * np.exp(-0.5 * lag**2), "same")
    bend[:reach], bend[-reach:] = 0.0, 0.0  # the ends are steps
    return int(known[0]), bend


def _usual_height(bend: Array, beat: float) -> float:
    """Median of the largest bend within a beat and a half: one knock does not hide all beats."""
    count = max(1, int(len(bend) / (1.5 * beat)))
    return float(np.median([each.max() for each in np.array_split(bend, count)]))


def _between_ends(percussion: Array, apart_from: float) -> slice:
    """Beats without the first or the last where that stands apart: a contact that comes or goes bends, too."""
    between = np.diff(percussion)
    if len(between) < 3:
        return slice(None)
    apart = np.abs(between / np.median(between) - 1) > apart_from
    return slice(int(apart[0]), len(percussion) - int(apart[-1]))


def _beat(bend: Array, rates: tuple[float, float]) -> float:
    """Samples from beat to beat: the lag at which the waveform is most like itself."""
    shortest, longest = (round(60 / rate * SAMPLE_RATE) for rate in rates[::-1])
    longest = min(longest, len(bend) - 1)
    size = 2 * len(bend)
    like = np.fft.irfft(np.abs(np.fft.rfft(bend, size)) ** 2, size)[: longest + 1]
    like /= np.arange(len(bend), len(bend) - longest - 1, -1)  # fewer samples overlap at long lags
    peaks, _ = scipy.signal.find_peaks(like[shortest:])
    if not len(peaks):
        return float(shortest + like[shortest:].argmax())
    strong = peaks[like[shortest + peaks] > 0.65 * like[shortest + peaks].max()]
    return float(shortest + strong[0])  # not two beats at once
