"""Simulated takes of kinds of touch: what a sensor hears of them, and the waveforms that are made of that again."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
import scipy.fft
import scipy.interpolate
import torch
from numpy.typing import NDArray
from torch import Tensor

from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.reconstruct import Reconstructor
from localize.live.front_end import HighPass
from localize.recognition.event_kinds import EVENTS, event_pressure
from localize.recognition.power_maps import WINDOW, maps_of
from localize.recognition.recognition_options import TakeOptions
from localize.recognition.textures import PROFILES, SPEED, passing_pressure, texture_pressure
from localize.signals.array_response import ArrayResponse
from localize.signals.disturbances import MAINS
from localize.signals.frames import FRAME
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.random_streams import PURPOSES, Purpose
from localize.signals.stimulus import SAMPLE_RATE
from localize.signals.threads import one_thread

LEAD = FRAME
"""Samples before a window that the filter of the waveform needs."""
SLOWEST, FASTEST = 0.75 * SPEED, 1.7 * SPEED
"""Lowest and highest speed of textures that are trained on, mm/s."""


@dataclass(frozen=True)
class Subject:
    """Kinds of touch of one sort, and how they are made."""

    labels: tuple[str, ...]
    """Names of the kinds."""
    make: Callable[[int, float, np.random.Generator, float], Array]
    """Pressure in the cavity, Pa, of kind k, at a speed in mm/s, with random numbers, by a finger that is so much
    blunter than usual."""
    speeds: tuple[float, float] | None = None
    """Lowest and highest speed that is trained on, mm/s; None for kinds without a speed."""


def _event(kind: int, speed: float, random: np.random.Generator, blunter: float) -> Array:
    made = event_pressure(tuple(EVENTS)[kind], WINDOW + LEAD, random)
    if blunter == 1.0:
        return made
    # A softer, broader contact takes longer to do the same.
    width = max(1, round(8 * (blunter - 1)))
    return np.convolve(np.pad(made, width, mode="edge"), np.hanning(2 * width + 3)[1:-1] / (width + 1), "valid")


def _texture(kind: int, speed: float, random: np.random.Generator, blunter: float) -> Array:
    count = int(np.ceil(WINDOW * SPEED / min(speed, SLOWEST))) + 2 * LEAD  # of one length, but for slower ones
    return texture_pressure(PROFILES[kind], count, speed, random, blunter)


SUBJECTS: Mapping[str, Subject] = {
    "events": Subject(tuple(EVENTS), _event),
    "textures": Subject(tuple(profile.name for profile in PROFILES), _texture, (SLOWEST, FASTEST)),
}
"""Subjects that a recognizer can be trained on without recordings, by name."""


def simulated_signals(
    response: ArrayResponse,
    point: int,
    pressure: Array,
    microphone_noise: NoiseChoice,
    random: np.random.Generator,
    options: TakeOptions = TakeOptions(),
) -> Array:
    """Microphone signals of a pressure in one cavity of a sensor.

    Args:
        response: the sensor; the pressure beyond its frequencies does not reach the microphones.
        point: from 1.
        pressure: (n_sample,) float64, Pa at 1 kHz.
        microphone_noise: of the microphones.
        random: draws the noise.
        options: of the recorder.

    Returns:
        (n_microphone, n_sample) float64, Pa, as :func:`prepared`, hum and drift of a recorder included.
    """
    ease = np.hanning(2 * options.ease)[: options.ease]
    whole = np.concatenate([pressure[0] * ease, pressure, pressure[-1] * ease[::-1]])
    total = scipy.fft.next_fast_len(len(whole), real=True)
    inside, response_inside = _faded_response(response, total, options)
    spectrum = np.zeros((len(response.microphones), total // 2 + 1), np.complex128)
    spectrum[:, inside] = response_inside[point - 1] * scipy.fft.rfft(whole, total)[inside]
    signals = scipy.fft.irfft(spectrum, total)[:, options.ease : options.ease + len(pressure)]
    signals += _noise_of(response, microphone_noise, len(pressure), random) + _of_recorder(
        len(pressure), len(signals), random, options
    )
    return prepared(signals, options)


def prepared(signals: Array, options: TakeOptions = TakeOptions()) -> Array:
    """Signals of which waveforms are made, simulated and recorded alike: without what lies below 1 Hz.

    Args:
        signals: (n_microphone, n_sample) float64, Pa at 1 kHz, at least a frame.
        options: of the takes.

    Returns:
        Same shape, float64, Pa.
    """
    return HighPass(len(signals), options.corner).begin(signals)


def _of_recorder(count: int, channels: int, random: np.random.Generator, options: TakeOptions) -> Array:
    """(n_microphone, count) Pa: mains with their third harmonic, and a slow wander of each channel's zero."""
    time = np.arange(count) / SAMPLE_RATE
    mains = MAINS[int(random.integers(2))] + random.uniform(-0.1, 0.1)
    phase = random.uniform(0, 2 * np.pi, 2)
    hum = np.sin(2 * np.pi * mains * time + phase[0]) + np.sin(6 * np.pi * mains * time + phase[1]) / 3
    wander = np.sin(2 * np.pi * random.uniform(0.05, 0.5, (channels, 1)) * time + random.uniform(0, 6.3, (channels, 1)))
    return np.asarray(_drawn(options.hum, random) * hum + _drawn(options.drift, random) * wander)


def _drawn(of: tuple[float, float], random: np.random.Generator) -> float:
    return float(np.exp(random.uniform(*np.log(of))))


@functools.lru_cache(maxsize=16)
def _faded_response(
    response: ArrayResponse, total: int, options: TakeOptions
) -> tuple[NDArray[np.bool_], NDArray[np.complex128]]:
    """Mask of the lines of a real transform of that length that reach microphones, and the transfer functions there."""
    line = scipy.fft.rfftfreq(total, 1 / SAMPLE_RATE)
    top = min(float(response.frequency[-1]), SAMPLE_RATE / 2)
    inside = (line > options.fade_in[0]) & (line < top)
    grid = line[inside]
    fade = np.clip((grid - options.fade_in[0]) / (options.fade_in[1] - options.fade_in[0]), 0, 1) * np.clip(
        (top - grid) / (top * (1 - options.top_fraction)), 0, 1
    )
    return inside, response.at(grid) * fade


def _noise_of(response: ArrayResponse, noise: NoiseChoice, count: int, random: np.random.Generator) -> Array:
    """(n_microphone, count) Pa."""
    white = random.standard_normal((len(response.microphones), count))
    spectrum = response.noise(noise)
    if not isinstance(spectrum, NoiseSpectrum):
        return spectrum * white
    # White samples of variance one have 2 / SAMPLE_RATE in every hertz.
    frequency = scipy.fft.rfftfreq(count, 1 / SAMPLE_RATE)
    density = np.interp(frequency, np.arange(len(spectrum.power)), spectrum.power) * SAMPLE_RATE / 2
    return np.asarray(scipy.fft.irfft(scipy.fft.rfft(white) * np.sqrt(density), count))


def waveform_windows(reconstructor: Reconstructor, signals: Array, point: int) -> Array:
    """Waveform of a take without the samples at its ends that have no whole window of the filter.

    Args:
        reconstructor: of the library.
        signals: (n_microphone, n_sample) float64, Pa at 1 kHz.
        point: from 1.

    Returns:
        (n,) float64, Pa.
    """
    pressure = reconstructor.waveform(signals, point).pressure[0]
    return pressure[reconstructor.window - 1 - reconstructor.latency : len(pressure) - reconstructor.latency]


def at_usual_speed(waveform: Array, speed: float) -> Array:
    """A waveform as it would be at 12 mm/s.

    Args:
        waveform: (n,) float64 at 1 kHz.
        speed: at which it was made, mm/s.

    Returns:
        (m,) float64 at 1 kHz, m = n speed / 12 mm/s.

    Raises:
        Refusal: a speed that is not between 1 and 100 mm/s.
    """
    check_range("speed", speed, 1.0, 100.0, "mm/s")
    place = np.arange(int(len(waveform) * speed / SPEED)) * (SPEED / speed)
    spline = scipy.interpolate.make_interp_spline(np.arange(len(waveform)), waveform, k=3)
    return np.asarray(spline(np.minimum(place, len(waveform) - 1)))


@dataclass(frozen=True, eq=False)
class TakeMaker:
    """Maker of simulated takes: take i is of kind i modulo the number of kinds, the same whatever was made before."""

    subject: str
    """Name of :data:`SUBJECTS`."""
    reconstructor: Reconstructor
    """Filters of the library that waveforms are made by."""
    sensors: tuple[ArrayResponse, ...]
    """Sensors that are touched, one after the other."""
    seed: int = 0
    """Seed of the takes."""
    microphone_noise: NoiseChoice = "design"
    """Noise of the microphones."""
    speeds: tuple[float, float] | None = None
    """Lowest and highest speed of a texture, mm/s; by default those that are trained on."""
    speed_known: bool = True
    """True if waveforms are brought to the usual speed."""
    speed_error: float = 0.01
    """Standard deviation of the speed that is known, a share of it."""
    blunter: float = 1.0
    """Radius of the finger over the usual one, a ratio."""
    passing: float = 0.0
    """Share of the takes of what slides in which it passes the point, and does not stay on its membrane."""

    options: TakeOptions = TakeOptions()
    """Numbers of the recorder and of the contacts."""

    def __post_init__(self) -> None:
        if self.passing and any(each.membrane_radius is None for each in self.sensors):
            raise Refusal(
                kind=Kind.CONFLICT,
                field="passing",
                value=self.passing,
                allowed="0 for bare transfer functions, which have no membranes",
            )

    def signals(self, purpose: Purpose, number: int) -> tuple[Array, int, int, float]:
        """Signals of one take, (n_microphone, n_sample) Pa; its kind, from 0; point, from 1; and speed, mm/s."""
        subject = SUBJECTS[self.subject]
        key = (PURPOSES.index(purpose), tuple(SUBJECTS).index(self.subject), number)
        random = np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=key))
        kind = number % len(subject.labels)
        sensor = self.sensors[number // len(subject.labels) % len(self.sensors)]
        point = int(random.integers(sensor.point_count))
        speeds = self.speeds or subject.speeds
        speed = SPEED if speeds is None else float(np.exp(random.uniform(*np.log(speeds))))
        # of a stream of its own: takes that stay are the same whatever share of them passes
        chance = random.spawn(1)[0] if self.passing else None
        pressure = subject.make(kind, speed, random, self.blunter)
        if chance is not None and chance.random() < self.passing:
            assert sensor.membrane_radius is not None  # checked when the maker was made
            off = self.options.off_middle
            middle = len(pressure) - WINDOW / 2 * SPEED / speed + chance.uniform(-off, off)
            radius = float(sensor.membrane_radius[point])
            pressure = passing_pressure(PROFILES[kind], len(pressure), speed, chance, radius, middle)
        made = simulated_signals(sensor, point + 1, pressure, self.microphone_noise, random, self.options)
        return made, kind, point + 1, speed

    def waveform(self, purpose: Purpose, number: int) -> tuple[Array, int]:
        """Window by which one take is classified, (1024,) float64 Pa, and its kind, from 0."""
        signals, kind, point, speed = self.signals(purpose, number)
        made = waveform_windows(self.reconstructor, signals, point)
        if SUBJECTS[self.subject].speeds is not None and self.speed_known:
            error = np.random.default_rng((self.seed, number)).standard_normal()
            made = at_usual_speed(made, speed * (1 + self.speed_error * float(error)))
        return made[-WINDOW:], kind

    @one_thread()
    def maps(
        self, purpose: Purpose, count: int, report: Callable[[float], None] | None = None
    ) -> tuple[Tensor, Tensor]:
        """Maps of takes 0 to ``count - 1``, (count, 2, 64, 32) float32, and their kinds, (count,) int64."""
        maps, kinds = [], []
        for first in range(0, count, 64):
            made = [self.waveform(purpose, number) for number in range(first, min(first + 64, count))]
            maps.append(maps_of(np.stack([each for each, _ in made])))
            kinds += [kind for _, kind in made]
            if report:
                report(len(kinds) / count)
        return torch.cat(maps), torch.tensor(kinds)
