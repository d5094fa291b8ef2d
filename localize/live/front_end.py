"""What is done with samples before anything is decided: a high-pass, the mains' hum removed, the noise measured.

A touch leaves the array at rest only slowly, and below the lowest frequency of the stimuli no decoder knows what to
expect: what is left of it named wrong points for up to a second. The high-pass is the same for all microphones, so that
what they hear of each other stays as it was.

Hum and noise are followed and need not be told. Hum: lines at the multiples of 50 and 60 Hz, whose amplitude, phase and
slow change of phase are learned while nothing else is heard, and are taken to go on while something is. Noise: the
density between 200 and 450 Hz, where touches hold next to nothing, of what the other microphones do not hear as well,
as sound they do; a low quantile of the last four seconds.
"""

from __future__ import annotations

import math
from collections import deque
from dataclasses import dataclass

import numpy as np
import scipy.signal
from numpy.typing import NDArray

from geometry.ground.refusal import Refusal
from geometry.ground.typed import Array
from localize.live.events import HOP
from localize.signals.disturbances import MAINS
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE

HIGH_PASS = 3.0
"""Corner of the high-pass, Hz: the lowest at which what is left of a touch soon is below its noise."""
ORDER = 2
"""Order of the high-pass, a Butterworth."""
DELAY_AT = 20.0
"""Frequency at which the group delay of the high-pass is stated, Hz: the middle of what touches hold."""
HARMONICS = 5
"""Number of multiples of either that are looked for."""
HUM_RATE = 0.04
"""Share of what a hop shows of a line that is learned: a time constant of 0.4 s."""
DRIFT = 0.3
"""Largest distance of a mains frequency from what it should be, Hz."""
WEAK = 20.0
"""Multiple of the threshold of silence up to which what lies on the lines of mains alone is hum, not a touch."""
NOISE_BAND = (200.0, 450.0)
"""Band in which noise is measured, Hz."""
SUBBANDS = 3
"""Number of parts of that band, within each of which the way from one microphone to another is taken as constant."""
NOISE_TIME = 4.0
"""Length of the past over which noise is measured, s."""
LINES_SHARED = 1.5
"""Number of neighbouring lines of a frame's spectrum that the window makes one."""
NOISE_QUANTILE = 0.3
"""Quantile of the densities of that time that is the noise."""
HISS = 5.0
"""Multiple of the noise that is expected, and of that of the quietest microphone, from which on one hisses."""
HISS_TIME = 0.5
"""Time over which noise must have been measured before a microphone is said to hiss, or to be dead, s."""
QUIET = 0.2
"""Multiple of the noise that is expected, and of that of the quietest other microphone, below which one is dead: what
its converter toggles by."""


@dataclass(frozen=True)
class Listening:
    """Choice of what is done with samples before anything is decided, and with what is left of a touch."""

    high_pass: float | None = HIGH_PASS
    """Corner of the high-pass of all microphones, 0.5 to 20 Hz; None for none."""
    follow: bool = True
    """Whether the noise of each microphone and the hum of mains are measured; if not, noise is what the locator was
    made for."""
    fade: bool = True
    """Whether frames that hold only what is left of a touch are told from it."""
    frames: bool = False
    """Whether decisions carry the samples that were judged."""

    def __post_init__(self) -> None:
        if self.high_pass is not None and not 0.5 <= self.high_pass <= 20.0:
            raise Refusal(f"high_pass = {self.high_pass} Hz must be between 0.5 and 20 Hz, or None for none")


AS_IT_COMES = Listening(None, False, False)
"""Nothing is done: every frame is judged as it is."""


def high_pass_sections(corner: float) -> Array:
    """Sections of second order of the high-pass of a corner in Hz, (n, 6) float64."""
    return np.asarray(scipy.signal.butter(ORDER, corner, "highpass", fs=SAMPLE_RATE, output="sos"))


class HighPass:
    """High-pass that starts as if time had run backwards before the first frame.

    Args:
        channels: number of microphones.
        corner: Hz; None lets everything pass.
    """

    def __init__(self, channels: int, corner: float | None) -> None:
        self._sections = None
        self.delay = 0.0
        """Group delay at :data:`DELAY_AT`, s."""
        if corner is not None:
            self._sections = high_pass_sections(corner)
            step = 0.01
            _, near = scipy.signal.sosfreqz(self._sections, [DELAY_AT - step, DELAY_AT + step], fs=SAMPLE_RATE)
            self.delay = float(np.angle(near[0] / near[1]) / (2 * math.pi * 2 * step))
        self._state = np.zeros((1, channels, 2))

    def begin(self, samples: Array) -> Array:
        """First samples, (n_microphone, n) float64, Pa, filtered."""
        if self._sections is None:
            return samples
        self._state = scipy.signal.sosfilt_zi(self._sections)[:, None, :] * samples[None, :, -1:]
        self(samples[:, ::-1])
        return self(samples)

    def __call__(self, samples: Array) -> Array:
        """Samples that follow those before, (n_microphone, n) float64, Pa, filtered."""
        if self._sections is None:
            return samples
        filtered, self._state = scipy.signal.sosfilt(self._sections, samples, axis=1, zi=self._state)
        return np.asarray(filtered)


class Hum:
    """Hum of mains in each microphone, learned hop by hop.

    Args:
        channels: number of microphones.
    """

    def __init__(self, channels: int) -> None:
        self._channels = channels
        self._nominal = np.array([mains for mains in MAINS for _ in range(HARMONICS)])
        self._multiple = np.tile(np.arange(1, HARMONICS + 1), len(MAINS))
        self._family = np.repeat(np.arange(len(MAINS)), HARMONICS)
        time = np.arange(FRAME) / SAMPLE_RATE
        turns = 2 * math.pi * np.unique(self._nominal * self._multiple)[:, None] * time
        basis, _ = np.linalg.qr(np.concatenate([np.cos(turns), np.sin(turns)]).T)
        self._basis = np.ascontiguousarray(basis)
        self.reset()

    def reset(self) -> None:
        """Forget all, at the next sample."""
        self._amplitude = np.zeros((self._channels, len(self._nominal)), np.complex128)
        self._offset = np.zeros(len(MAINS))  # of each mains frequency, Hz
        self._phase = np.zeros(len(self._nominal))

    @property
    def rms(self) -> Array:
        """Level of the hum in each microphone; (n_microphone,) float64, Pa rms."""
        return np.asarray(np.sqrt((np.abs(self._amplitude) ** 2).sum(1) / 2))

    def coming(self, count: int) -> Array:
        """Hum in the next samples; (n_microphone, count) float64, Pa."""
        turn = 2 * math.pi * self._frequency[:, None] * np.arange(count + 1) / SAMPLE_RATE + self._phase[:, None]
        self._phase = turn[:, -1] % (2 * math.pi)
        return np.asarray((self._amplitude @ np.exp(1j * turn[:, :-1])).real)

    def learn(self, rest: Array) -> None:
        """Learn from what is left of the hop that has just passed, in which nothing else was heard.

        Args:
            rest: (n_microphone, HOP) float64, Pa.
        """
        before = np.exp(1j * (self._phase - 2 * math.pi * self._frequency * HOP / SAMPLE_RATE))
        turn = np.exp(2j * math.pi * self._frequency[:, None] * np.arange(HOP) / SAMPLE_RATE) * before[:, None]
        change = 2 * HUM_RATE / HOP * rest @ turn.conj().T
        power = (np.abs(self._amplitude) ** 2).sum(0)
        # A line that always turns the same way is of another frequency: a loop of second order, critically damped.
        turned = np.imag(self._amplitude.conj() * change).sum(0)
        for family in range(len(MAINS)):
            own = self._family == family
            weight = float((self._multiple[own] ** 2 * power[own]).sum())
            if weight > 0:
                angle = float((self._multiple[own] * turned[own]).sum()) / weight
                rate = HUM_RATE / 4 * angle * SAMPLE_RATE / (2 * math.pi * HOP)
                self._offset[family] = np.clip(self._offset[family] + rate, -DRIFT, DRIFT)
        self._amplitude += change

    def beside(self, frame: Array) -> Array:
        """A frame without all that lies on the lines of mains; (n_microphone, FRAME) float64, Pa."""
        return frame - (frame @ self._basis) @ self._basis.T

    @property
    def _frequency(self) -> Array:
        return (self._nominal + self._offset[self._family]) * self._multiple


class NoiseFloor:
    """Noise of each microphone, white as far as it is known, from what touches leave free.

    Args:
        channels: number of microphones.
    """

    def __init__(self, channels: int) -> None:
        spacing = SAMPLE_RATE / FRAME
        self._first = round(NOISE_BAND[0] / spacing)
        self._lines = round((NOISE_BAND[1] - NOISE_BAND[0]) / spacing / SUBBANDS)
        # Of so few lines the others explain some of each microphone's own noise by chance; neighbours share some.
        free = self._lines / LINES_SHARED
        self._chance = free / max(free - channels + 1, 1.0)
        window = np.hanning(FRAME)
        self._window = window / math.sqrt((window**2).mean())
        self._past: deque[Array] = deque(maxlen=round(NOISE_TIME * SAMPLE_RATE / HOP))
        self._channels = channels
        self.rms = np.zeros(channels)
        """Level of each microphone's noise over 0 to 500 Hz; (n_microphone,) float64, Pa rms."""

    def reset(self) -> None:
        """Forget all."""
        self._past.clear()
        self.rms = np.zeros(self._channels)

    def take(self, frame: Array) -> None:
        """Take the next frame, (n_microphone, FRAME) float64, Pa."""
        lines = np.fft.rfft(frame * self._window, axis=1)[:, self._first : self._first + SUBBANDS * self._lines]
        parts = lines.reshape(len(frame), SUBBANDS, self._lines)
        density = np.einsum("mbk,nbk->bmn", parts, parts.conj()) / self._lines
        scale = np.trace(density, axis1=1, axis2=2).real[:, None, None]
        inverse = np.linalg.inv(density + (1e-9 * scale + 1e-300) * np.eye(len(frame)))
        # What is left of a microphone beside all that the others explain; mean square of white noise as dense as it is.
        alone = self._chance / np.diagonal(inverse, axis1=1, axis2=2).real
        self._past.append(alone.mean(0) / FRAME)
        rank = int(NOISE_QUANTILE * (len(self._past) - 1))
        self.rms = np.sqrt(np.partition(np.array(self._past), rank, axis=0)[rank])

    def hisses(self, expected: float) -> NDArray[np.bool_]:
        """Microphones whose noise is far above that which is expected, Pa rms, and that of others; (n_microphone,)."""
        if not self._is_known:
            return np.zeros(self._channels, bool)
        return np.asarray(self.rms > HISS * max(expected, float(self.rms.min())))

    def dead(self, expected: float) -> NDArray[np.bool_]:
        """Microphones whose noise is missing, where Pa rms are expected and others have theirs; (n_microphone,)."""
        if not self._is_known or self._channels < 2:
            return np.zeros(self._channels, bool)
        least, second = np.sort(self.rms)[:2]
        of_others = np.where(self.rms == least, second, least)
        return np.asarray(self.rms < QUIET * np.minimum(expected, of_others))

    @property
    def _is_known(self) -> bool:
        return len(self._past) >= HISS_TIME * SAMPLE_RATE / HOP
