"""Microphone signals while a contact moves over an array.

The force on each membrane goes through its impulse response to each microphone, and the pressures of all membranes
add. The array is linear in light forces; a larger one is replaced by the light force that displaces as much
(:mod:`localize.contacts.large_presses`). The impulse responses are those of :mod:`localize.signals.propagation`: the
transfer functions on lines 0.25 Hz apart, times the pressure in the cavity per force, the top of the band faded as for
every touch. Such lines hold responses of two seconds. Slower ones are a sum of exponentials
(:mod:`localize.contacts.relaxation_series`), so that a press can be held, leak away and creep for as long as a take
lasts. Noise and sound outside are those of :class:`localize.TouchGenerator`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import scipy.fft
import torch
from numpy.typing import NDArray

from acoustic_fem import Library
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.typed import Array
from localize.contacts.contact import Contact, covered_force, surface_of
from localize.contacts.large_presses import LargePresses
from localize.contacts.relaxation_series import FITTED_TO, RelaxationSeries
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.disturbances import steady_sound
from localize.signals.finger_stimuli import top_faded
from localize.signals.noise_model import NoiseChoice, check_noise_choice
from localize.signals.random_streams import Purpose
from localize.signals.stimulus import (
    LINE_COUNT,
    LINE_SPACING,
    SAMPLE_LENGTH,
    SAMPLE_RATE,
    Device,
    Stimuli,
    line_frequencies,
)
from localize.signals.touch_generator import TouchGenerator

RATES = (250.0, 1e5)
"""Lowest and highest sample rate, Hz."""
LONGEST = 1000.0
"""Length of the longest take, s."""
_FINEST = 64
_SLOW = 1e-3, 1.0, 48
_AHEAD = 0.25
_BLOCKS = 4096


@dataclass(frozen=True, eq=False)
class Take:
    """Microphone signals of a contact, and the true path and force."""

    signals: Array
    """Pressures at the microphones; (n_microphone, n_sample) float64, Pa."""
    sample_rate: float
    """Sample rate, Hz."""
    time: Array
    """Times of the samples, those of the contact; (n_sample,) float64, s."""
    path: Array
    """Middle of the contact, mm, as :attr:`Contact.path`; (n_sample, 2) float64."""
    force: Array
    """Force of the contact in this recording, its random roughness included; (n_sample,) float64, N."""
    point: NDArray[np.int64]
    """Point whose middle is nearest, from 1; 0 where nothing presses; (n_sample,) int64."""
    label: str
    """Label of the contact."""


class ContactRecorder:
    """Recorder of many contacts on one array; what they share is computed once.

    Args:
        array: a library, or a response with places and forces.
        sample_rate: a multiple of 0.25 Hz, 250 to 100000 Hz.
        microphone_noise: as of :class:`localize.TouchGenerator`.
        ambient: level of the sound outside, dB SPL; None for silence.
        seed: of noise, sound and roughness; any non-negative integer.
        purpose: streams of different purposes never share a number.
        linear: True: membranes are taken as linear at every force.

    Raises:
        Refusal: bare transfer functions, which know neither places nor forces; a rate out of range, or not 1 kHz
            where there is noise or sound; as :class:`localize.TouchGenerator`.
    """

    def __init__(
        self,
        array: Library | ArrayResponse,
        sample_rate: float = SAMPLE_RATE,
        *,
        microphone_noise: NoiseChoice = "design",
        ambient: float | None = None,
        seed: int = 0,
        purpose: Purpose = "evaluation",
        linear: bool = False,
    ) -> None:
        check_range("sample_rate", sample_rate, *RATES, "Hz")
        self._period = round(sample_rate / LINE_SPACING)
        if abs(self._period * LINE_SPACING - sample_rate) > 1e-9:
            raise Refusal(
                kind=Kind.OUT_OF_RANGE,
                field="sample_rate",
                value=sample_rate,
                unit="Hz",
                allowed=f"a multiple of {LINE_SPACING:g} Hz",
            )
        self.response = response_of(array)
        self.sample_rate, self.seed, self.purpose = float(sample_rate), seed, purpose
        self._place, _ = surface_of(self.response)
        self._linear = linear
        self._presses: dict[int, LargePresses] = {}
        self._background: TouchGenerator | None = None
        check_noise_choice(microphone_noise)
        if ambient is not None or microphone_noise != 0.0:
            if sample_rate != SAMPLE_RATE:
                raise Refusal(
                    kind=Kind.CONFLICT,
                    field="sample_rate",
                    value=sample_rate,
                    unit="Hz",
                    allowed=f"{SAMPLE_RATE:g} Hz where there is noise or sound",
                    remedy=(Field("microphone_noise"), " = 0 records without noise"),
                )
            self._background = TouchGenerator(
                self.response,
                seed,
                purpose,
                microphone_noise,
                stimuli=_silence,
                ambient=steady_sound(ambient),
            )
        self._taps, self._slow = self._impulse_responses()
        self._length = 0
        self._on_bins: dict[int, NDArray[np.complex128]] = {}

    def _impulse_responses(self) -> tuple[Array, RelaxationSeries]:
        """(n_point, n_microphone, period) Pa/N per sample, of which what comes before time zero stands at the end; and
        the slow exponentials, which are not in them.
        """
        response = self.response
        if response.cavity_response is None:
            raise Refusal(
                f"{response.name}: bare transfer functions do not give the pressure of a force",
                kind=Kind.MISMATCH,
                remedy="take a library that has a design",
            )
        grid = response.frequency
        band = (float(grid[0]), min(float(grid[-1]), SAMPLE_RATE / 2))
        fade = top_faded(band).numpy().astype(np.float64)
        lines = line_frequencies()[: int(np.flatnonzero(fade)[-1]) + 1]
        relaxing = np.concatenate([np.geomspace(*_SLOW)[:-1], np.arange(_SLOW[1], min(FITTED_TO, band[1]), 0.5)])
        series = RelaxationSeries.of(self._force_response(relaxing), relaxing)
        slow = series.slow()
        bins = self._period // 2 + 1
        through = np.zeros((*response.transfer_function.shape[:2], bins), np.complex128)
        kept = min(len(lines), bins)
        through[..., :kept] = self._force_response(lines[:kept]) * fade[:kept]
        through[..., 0] = series.at(np.zeros(1))[..., 0]
        through -= slow.sampled_at(np.asarray(np.arange(bins) * LINE_SPACING, np.float64), self.sample_rate)
        return np.asarray(scipy.fft.irfft(through, n=self._period)), slow

    def _force_response(self, frequency: Array) -> NDArray[np.complex128]:
        """(n_point, n_microphone, n) Pa/N."""
        touched, in_cavity = self.response.between(frequency)
        assert in_cavity is not None
        return touched * in_cavity[:, None]

    def _bins_of(self, point: int, length: int) -> NDArray[np.complex128]:
        """(n_microphone, length // 2 + 1): the spectrum of a point's impulse response on a longer period."""
        if length != self._length:
            self._length, self._on_bins = length, {}
        if point not in self._on_bins:
            taps, ahead = self._taps[point], self._period // 2
            longer = np.zeros((len(taps), length))
            longer[:, : self._period - ahead] = taps[:, : self._period - ahead]
            longer[:, -ahead:] = taps[:, -ahead:]
            self._on_bins[point] = scipy.fft.rfft(longer)
        return self._on_bins[point]

    def take(self, contact: Contact, sample: int = 0) -> Take:
        """Microphone signals from the first time of a contact to its last.

        Args:
            contact: what presses.
            sample: index of the take: each has noise, sound and roughness of its own, the same whenever it is made.

        Raises:
            Refusal: a contact above 1000 s; a force on a membrane beyond its law of large presses.
        """
        check_range("contact: its length", contact.seconds, 0.0, LONGEST, "s")
        count = math.floor(contact.seconds * self.sample_rate + 1e-6) + 1
        fine = min(max(1, math.ceil(1 / (self.sample_rate * np.diff(contact.time).min()) - 1e-6)), _FINEST)
        steps = contact.time[0] + np.arange(count * fine) / (self.sample_rate * fine)
        heard = contact.at(steps).roughened(self.seed, self.purpose, sample)
        force = covered_force(heard, self.response)
        if not self._linear:
            if fine not in self._presses:
                self._presses[fine] = LargePresses(self.response, self.sample_rate * fine)
            force = self._presses[fine].light_forces(force)
        signals = self._through(force, count, fine)
        if self._background is not None:
            signals += _noise(self._background, sample, count)
        at_samples = heard.force[::fine]
        path = heard.path[::fine]
        nearest = np.linalg.norm(path[:, None] - self._place, axis=-1).argmin(axis=1)
        return Take(
            signals=signals,
            sample_rate=self.sample_rate,
            time=steps[::fine],
            path=path,
            force=at_samples,
            point=np.where(at_samples > 0, nearest + 1, 0),
            label=contact.label,
        )

    def _through(self, force: Array, count: int, fine: int) -> Array:
        """(n_microphone, count) Pa of forces (count * fine, n_point) N."""
        # Whole seconds, so that takes of nearly one length share their spectra.
        rate = math.ceil(self.sample_rate)
        length = scipy.fft.next_fast_len(-(-count // rate) * rate + self._period, real=True)
        bins = length // 2 + 1
        # A force that begins at once rings before its first sample, in the band of the samples.
        ahead = round(_AHEAD * self.sample_rate)
        total = np.zeros((len(self.response.microphones), bins), np.complex128)
        pressed = np.flatnonzero(force.any(axis=0))
        at_samples = np.zeros((len(pressed), count + ahead))
        for number, point in enumerate(pressed):
            spectrum = scipy.fft.rfft(force[:, point], n=length * fine)[:bins] / fine
            total += self._bins_of(int(point), length) * spectrum
            band_limited = scipy.fft.irfft(spectrum, n=length)
            at_samples[number, :ahead], at_samples[number, ahead:] = band_limited[-ahead:], band_limited[:count]
        own = replace(self._slow, weight=self._slow.weight[pressed])
        slow = own.through(at_samples, self.sample_rate)[:, ahead:]
        return np.asarray(scipy.fft.irfft(total, n=length)[:, :count]) + slow


def record(
    contact: Contact,
    array: Library | ArrayResponse,
    sample_rate: float = SAMPLE_RATE,
    *,
    microphone_noise: NoiseChoice = "design",
    ambient: float | None = None,
    seed: int = 0,
    purpose: Purpose = "evaluation",
    sample: int = 0,
    linear: bool = False,
) -> Take:
    """Microphone signals of one contact; for many, :class:`ContactRecorder` is quicker.

    ``sample_rate`` in Hz, ``ambient`` in dB SPL; arguments and errors as for :class:`ContactRecorder` and
    :meth:`ContactRecorder.take`.
    """
    recorder = ContactRecorder(
        array,
        sample_rate,
        microphone_noise=microphone_noise,
        ambient=ambient,
        seed=seed,
        purpose=purpose,
        linear=linear,
    )
    return recorder.take(contact, sample)


def _noise(background: TouchGenerator, sample: int, count: int) -> Array:
    """(n_microphone, count) Pa: seconds of noise and sound, each faded into the next with its power kept."""
    half = SAMPLE_LENGTH // 2
    blocks = -(-count // half) + 1
    made = background.samples(sample * _BLOCKS, blocks).signals.numpy().astype(np.float64)
    fade = np.sin(np.pi * (np.arange(SAMPLE_LENGTH) + 0.5) / SAMPLE_LENGTH)
    noise = np.zeros((made.shape[1], (blocks + 1) * half))
    for number, block in enumerate(made * fade):
        noise[:, number * half : number * half + SAMPLE_LENGTH] += block
    return noise[:, half : half + count]


def _silence(seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device) -> Stimuli:
    """Stimuli of nothing; arguments as :class:`localize.signals.stimulus.StimulusSource`."""
    none = torch.zeros(count, dtype=torch.int64, device=device)
    return Stimuli(
        spectrum=torch.zeros(count, LINE_COUNT, dtype=torch.complex64, device=device),
        interval=none - 1,
        components=none,
    )
