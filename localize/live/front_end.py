"""Preparation of samples before any decision: a high-pass, removal of mains hum, measurement of the noise.

The array comes to rest only slowly after a touch, and below the lowest frequency of the stimuli no decoder has a model
of the signal: without the high-pass, decoders assign this decay to wrong points for up to a second. The high-pass is
the same for all microphones, so that it leaves their ratios as they were.

Hum and noise are estimated and need not be given. Hum consists of lines at the multiples of 50 and 60 Hz. Their
amplitude, phase and slow change of phase are learned in silence, and are assumed to continue during a touch. Noise is
the density between 200 and 450 Hz, where touches hold next to nothing. The part that the other microphones share is
left out, because sound reaches all of them; the estimate is a low quantile of the last four seconds.
"""

from __future__ import annotations

import math
from collections import deque

import numpy as np
import scipy.signal
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.live.events import HOP
from localize.live.stream_options import StreamOptions
from localize.signals.disturbances import MAINS
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE

ORDER = 2
"""Order of the high-pass, a Butterworth."""
DELAY_AT = 20.0
"""Frequency at which the group delay of the high-pass is stated, Hz: the middle of what touches hold."""
LINES_SHARED = 1.5
"""Number of neighbouring lines of a frame's spectrum that the window makes one."""


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
        options: of the stream.
    """

    def __init__(self, channels: int, options: StreamOptions) -> None:
        self._channels, self._options = channels, options
        self._nominal = np.array([mains for mains in MAINS for _ in range(options.harmonics)])
        self._multiple = np.tile(np.arange(1, options.harmonics + 1), len(MAINS))
        self._family = np.repeat(np.arange(len(MAINS)), options.harmonics)
        time = np.arange(FRAME) / SAMPLE_RATE
        phases = 2 * math.pi * np.unique(self._nominal * self._multiple)[:, None] * time
        basis, _ = np.linalg.qr(np.concatenate([np.cos(phases), np.sin(phases)]).T)
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
        phase = 2 * math.pi * self._frequency[:, None] * np.arange(count + 1) / SAMPLE_RATE + self._phase[:, None]
        self._phase = phase[:, -1] % (2 * math.pi)
        return np.asarray((self._amplitude @ np.exp(1j * phase[:, :-1])).real)

    def learn(self, residual: Array) -> None:
        """Learn from the residual of the hop that has just passed, in which there was no other signal.

        Args:
            residual: (n_microphone, HOP) float64, Pa.
        """
        rate, drift = self._options.hum_rate, self._options.mains_drift
        before = np.exp(1j * (self._phase - 2 * math.pi * self._frequency * HOP / SAMPLE_RATE))
        phasor = np.exp(2j * math.pi * self._frequency[:, None] * np.arange(HOP) / SAMPLE_RATE) * before[:, None]
        change = 2 * rate / HOP * residual @ phasor.conj().T
        power = (np.abs(self._amplitude) ** 2).sum(0)
        # A line that always turns the same way is of another frequency: a loop of second order, critically damped.
        turned = np.imag(self._amplitude.conj() * change).sum(0)
        for family in range(len(MAINS)):
            own = self._family == family
            weight = float((self._multiple[own] ** 2 * power[own]).sum())
            if weight > 0:
                angle = float((self._multiple[own] * turned[own]).sum()) / weight
                off = rate / 4 * angle * SAMPLE_RATE / (2 * math.pi * HOP)
                self._offset[family] = np.clip(self._offset[family] + off, -drift, drift)
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
        options: of the stream.
    """

    def __init__(self, channels: int, options: StreamOptions) -> None:
        spacing, (low, high) = SAMPLE_RATE / FRAME, options.noise_band
        self._options = options
        self._first = round(low / spacing)
        self._lines = round((high - low) / spacing / options.noise_subbands)
        # Of so few lines the others explain some of each microphone's own noise by chance; neighbours share some.
        free = self._lines / LINES_SHARED
        self._chance = free / max(free - channels + 1, 1.0)
        window = np.hanning(FRAME)
        self._window = window / math.sqrt((window**2).mean())
        self._past: deque[Array] = deque(maxlen=round(options.noise_time * SAMPLE_RATE / HOP))
        self._channels = channels
        self.rms = np.zeros(channels)
        """Level of each microphone's noise over 0 to 500 Hz; (n_microphone,) float64, Pa rms."""

    def reset(self) -> None:
        """Forget all."""
        self._past.clear()
        self.rms = np.zeros(self._channels)

    def take(self, frame: Array) -> None:
        """Take the next frame, (n_microphone, FRAME) float64, Pa."""
        subbands = self._options.noise_subbands
        lines = np.fft.rfft(frame * self._window, axis=1)[:, self._first : self._first + subbands * self._lines]
        parts = lines.reshape(len(frame), subbands, self._lines)
        density = np.einsum("mbk,nbk->bmn", parts, parts.conj()) / self._lines
        scale = np.trace(density, axis1=1, axis2=2).real[:, None, None]
        inverse = np.linalg.inv(density + (1e-9 * scale + 1e-300) * np.eye(len(frame)))
        # What is left of a microphone beside all that the others explain; mean square of white noise as dense as it is.
        alone = self._chance / np.diagonal(inverse, axis1=1, axis2=2).real
        self._past.append(alone.mean(0) / FRAME)
        rank = int(self._options.noise_quantile * (len(self._past) - 1))
        self.rms = np.sqrt(np.partition(np.array(self._past), rank, axis=0)[rank])

    def hisses(self, expected: float) -> NDArray[np.bool_]:
        """Microphones whose noise is far above that which is expected, Pa rms, and that of others; (n_microphone,)."""
        if not self._is_known:
            return np.zeros(self._channels, bool)
        return np.asarray(self.rms > self._options.hiss * max(expected, float(self.rms.min())))

    def dead(self, expected: float) -> NDArray[np.bool_]:
        """Microphones whose noise is missing, where Pa rms are expected and others have theirs; (n_microphone,)."""
        if not self._is_known or self._channels < 2:
            return np.zeros(self._channels, bool)
        least, second = np.sort(self.rms)[:2]
        of_others = np.where(self.rms == least, second, least)
        return np.asarray(self.rms < self._options.missing_noise * np.minimum(expected, of_others))

    @property
    def _is_known(self) -> bool:
        return len(self._past) >= self._options.hiss_time * SAMPLE_RATE / HOP
