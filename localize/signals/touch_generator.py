"""Microphone signals of touches, made from a library of transfer functions.

A touch is a stimulus (:mod:`localize.signals.stimulus`, :mod:`localize.signals.finger_stimuli`) through the transfer
functions of its point (:mod:`localize.signals`); the sound outside and the microphones' own noise and unlikeness
(:mod:`localize.signals.disturbances`) come on top. Stimuli are limited to the frequencies that the library covers.
"""

from __future__ import annotations

import copy
import hashlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from acoustic_fem.numerics.frequency_splines import from_zero, interpolated, interpolation_from_zero
from geometry.ground.refusal import Kind, Refusal, counted
from localize.signals import disturbances, stimulus
from localize.signals.array_response import (
    ArrayResponse,
    FactorSource,
    TransferFunctionSource,
)
from localize.signals.disturbances import MicrophoneMismatch
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.propagation import microphone_signals, short_window_signals
from localize.signals.random_streams import Purpose
from localize.signals.stimulus import BAND, SCALED_AT, Device, Stimuli, StimulusSource, multi_sines
from localize.signals.threads import one_thread

SHARD = 256
"""Number of samples made at once when streaming: their spectra fit in the processor's cache."""
Method = Literal["exact", "stft"]


@dataclass(frozen=True)
class TouchSignals:
    """Signals of consecutive samples, one second each at 1 kHz."""

    signals: Tensor
    """Pressures at the microphones; (n, n_microphone, SAMPLE_LENGTH) float32, Pa."""
    point: Tensor
    """Touched point of each sample, from 1; (n,) int64."""
    interval: Tensor
    """Index of each sample into ``stimulus.COMPONENT_INTERVALS``, -1 for stimuli that are not multi-sine; (n,)
    int64."""


class TouchGenerator:
    """Endless stream of touches; sample i, from 0, is of point i modulo the number of points, plus 1.

    With a source of many sensors, each sensor in turn is touched at all of its points; only the sensors of the
    samples at hand are read.

    Args:
        response: the array.
        seed: any non-negative integer.
        purpose: streams of different purposes never share a stimulus.
        microphone_noise: added to every microphone, Gaussian: Pa rms over 0 to 500 Hz, white, or "design" for that of
            the design's microphone, see :mod:`localize.signals.noise_model`.
        source: transfer functions of many sensors in place of those of the array, on frequencies of its own.
        sensors: those of the source that are touched; by default all.
        stimuli: kind of the touches; by default the paper's multi-sine stimuli.
        ambient: lowest and highest level of the sound outside, dB SPL; each sample has its own, evenly spread between
            them. With a source, sound reaches the microphones as in the nominal array.
        mismatch: how unlike the microphones are; each sample is recorded by others.
        method: "exact", or "stft" for the paper's short-window products, see
            :func:`localize.signals.propagation.short_window_signals`.
        device: where the signals are made, such as "cuda"; random numbers are drawn on the processor and are the same
            everywhere.

    Raises:
        Refusal: as :meth:`ArrayResponse.noise`; a source that covers less than 1 to 100 Hz, holds other points or
            microphones than the array, or lacks the sensors asked for; ambient sound or a scatter of vents without a
            design, from which their effect follows; levels out of range; an unknown method.
    """

    def __init__(
        self,
        response: ArrayResponse,
        seed: int,
        purpose: Purpose,
        microphone_noise: NoiseChoice = "design",
        source: TransferFunctionSource | None = None,
        sensors: range | None = None,
        *,
        stimuli: StimulusSource = multi_sines,
        ambient: tuple[float, float] | None = None,
        mismatch: MicrophoneMismatch | None = None,
        method: Method = "exact",
        device: Device = "cpu",
    ) -> None:
        if method not in ("exact", "stft"):
            raise Refusal(kind=Kind.OUT_OF_RANGE, field="method", value=method, allowed=("exact", "stft"))
        self.response = response
        self.seed = seed
        self.purpose: Purpose = purpose
        self.microphone_noise = response.noise(microphone_noise)
        self.stimuli = stimuli
        self.ambient = ambient
        self.mismatch = mismatch
        self.method: Method = method
        self.device = device
        grid = response.frequency if source is None else source.frequency
        self._band = (float(grid[0]), min(float(grid[-1]), stimulus.SAMPLE_RATE / 2))
        self._stop = stimulus.lines_within(self._band).stop
        lines = np.minimum(stimulus.line_frequencies()[: self._stop], self._band[1])
        self._source = source
        self._sensors = range(1)
        self._factor_lines = lines
        self._factors = source.factors if isinstance(source, FactorSource) else None
        if source is None or self._factors is not None:
            self._on_lines = self._on_lines_of(response.between(lines)[0])
        if source is not None:
            self._sensors = range(source.sensor_count) if sensors is None else sensors
            _check_source(source, response, self._sensors)
            if self._factors is None:
                self._splines = interpolation_from_zero(grid, lines, response.sealed)
        self._membrane_on_lines = self._strokes_on_lines()
        if ambient is not None:
            disturbances.check_ambient(ambient)
            self._ambient_on_lines = self._nominal("ambient", response.ambient_response)
        if mismatch is not None:
            vent = self._nominal("mismatch.vent", response.vent_ratio) if mismatch.vent else torch.zeros(self._stop)
            self._vent_on_lines = vent.to(device)

    def _on_lines_of(self, values: NDArray[np.complex128]) -> Tensor:
        return torch.from_numpy(values.astype(np.complex64)).to(self.device)

    def _touched(self, values: NDArray[np.complex128]) -> Tensor:
        """Transfer functions of the source on the stimulus's lines from 0 Hz on, complex64."""
        even, odd = self._splines
        known = from_zero(values, self.response.sealed)
        return self._on_lines_of(known.real @ even.T + 1j * (known.imag @ odd.T))

    def _nominal(self, name: str, values: NDArray[np.complex128] | None) -> Tensor:
        """A response of the nominal array on the lines."""
        if values is None:
            raise Refusal(
                "needs a library with a design: bare transfer functions do not tell its effect",
                kind=Kind.MISMATCH,
                field=name,
            )
        grid = self.response.frequency
        lines = np.clip(stimulus.line_frequencies()[: self._stop], None, grid[-1])
        return self._on_lines_of(interpolated(values, grid, lines))

    def _strokes_on_lines(self) -> Tensor | None:
        """Pressure in each cavity by a stroke of its membrane, one at SCALED_AT; (n_point, n_line) complex64."""
        if self.response.cavity_response is None:
            return None
        grid = self.response.frequency
        lines = np.clip(stimulus.line_frequencies()[: self._stop], None, grid[-1])
        _, on_lines = self.response.between(lines)
        _, scaled_at = self.response.between(np.array([SCALED_AT]))
        assert on_lines is not None
        assert scaled_at is not None
        scale = np.abs(scaled_at)
        return self._on_lines_of(on_lines / scale)

    def _in_cavity(self, stimuli: Stimuli, start: int) -> Tensor:
        """Pressures in the cavities by stimuli, (n, n_line) complex64, Pa."""
        spectrum = stimuli.spectrum[:, : self._stop]
        if stimuli.is_stroke is None or self._membrane_on_lines is None:
            return spectrum
        through = self._membrane_on_lines[self._points(start, len(spectrum))] * spectrum
        return torch.where(stimuli.is_stroke[:, None], through, spectrum)

    def _transfer_function(self, start: int, count: int) -> Tensor:
        """(count, n_microphone, n_line) of consecutive samples."""
        points = self.response.point_count
        if self._source is None:
            return self._on_lines[self._points(start, count)]
        turn = np.arange(start, start + count) // points % len(self._sensors)
        runs = np.split(np.unique(turn), np.flatnonzero(np.diff(np.unique(turn)) > 1) + 1)
        first = self._sensors.start
        place, point = np.searchsorted(np.unique(turn), turn), np.arange(start, start + count) % points
        if self._factors is not None:
            drawn = [self._factors(first + int(run[0]), len(run), self._factor_lines) for run in runs]
            factors = np.concatenate(drawn)[place, point]
            return self._on_lines[point] * torch.from_numpy(factors).to(self.device)
        read = np.concatenate([self._source.sensors(first + int(run[0]), len(run)) for run in runs])
        return self._touched(read)[place, point]

    def _points(self, start: int, count: int) -> Tensor:
        """Indices of the points that consecutive samples touch, (count,) int64."""
        return torch.arange(start, start + count, device=self.device) % self.response.point_count

    @one_thread()
    def samples(self, start: int, count: int) -> TouchSignals:
        """Signals of samples ``start`` to ``start + count - 1``, the same whatever was asked for before."""
        sample = (self.seed, self.purpose, start, count)
        stimuli = self.stimuli(*sample, self._band, self.device)
        channels = len(self.response.microphones)
        spectrum = self._in_cavity(stimuli, start)
        recorded = None
        if self._source is None and self.mismatch is None and self.method == "exact":
            signals = microphone_signals(spectrum, self._on_lines, start=start)
        else:
            transfer_function = self._transfer_function(start, count)
            if self.mismatch is not None:
                recorded = self.mismatch.factors(*sample, channels, self._vent_on_lines)
                transfer_function = transfer_function * recorded
            through = microphone_signals if self.method == "exact" else short_window_signals
            signals = through(spectrum, transfer_function)
        if self.ambient is not None:
            signals = signals + self._sound(sample, self.ambient, recorded)
        if isinstance(self.microphone_noise, NoiseSpectrum):
            signals = signals + stimulus.coloured_noise(*sample, channels, self.microphone_noise.power, self.device)
        elif self.microphone_noise:
            signals = signals + stimulus.white_noise(*sample, channels, self.microphone_noise, self.device)
        return TouchSignals(signals=signals, point=self._points(start, count) + 1, interval=stimuli.interval)

    def _sound(
        self, sample: tuple[int, Purpose, int, int], levels: tuple[float, float], recorded: Tensor | None
    ) -> Tensor:
        """(count, n_microphone, SAMPLE_LENGTH): the sound outside, as the microphones record it."""
        every = stimulus.PERIOD // stimulus.SAMPLE_LENGTH
        response = self._ambient_on_lines[..., ::every]
        if recorded is not None:
            response = response * recorded[..., ::every]
        sound = disturbances.ambient_sound(*sample, levels, self._band[1], self.device)
        spectrum = sound[:, None, : response.shape[-1]] * response
        return torch.fft.irfft(spectrum, n=stimulus.SAMPLE_LENGTH, norm="forward")

    def with_stimuli(self, stimuli: StimulusSource) -> TouchGenerator:
        """Generator of other kinds of touches of the same sensors, without solving these on the lines again."""
        other = copy.copy(self)
        other.stimuli = stimuli
        return other

    def transfer_function_sha256(self) -> str:
        """Checksum of the transfer functions; of a source, of its first sensor and their number."""
        digest = hashlib.sha256(self.response.transfer_function.tobytes() + self.response.frequency.tobytes())
        if self._source is not None:
            digest.update(self._source.sensors(self._sensors.start, 1).tobytes())
            digest.update(repr((self._source.sensor_count, self._sensors)).encode())
        return digest.hexdigest()

    def stream(self, start: int, count: int, shard: int = SHARD) -> Iterator[TouchSignals]:
        """Signals of samples ``start`` to ``start + count - 1`` in shards, the same as of :meth:`samples`."""
        for first in range(start, start + count, shard):
            yield self.samples(first, min(shard, start + count - first))


def _check_source(source: TransferFunctionSource, response: ArrayResponse, sensors: range) -> None:
    grid = source.frequency
    if grid[0] > BAND[0] + 1e-6 or grid[-1] < BAND[1] - 1e-6:
        raise Refusal(
            f"runs from {grid[0]:g} to {grid[-1]:g} Hz; it must cover {BAND[0]:g} to {BAND[1]:g} Hz",
            kind=Kind.OUT_OF_RANGE,
            field="source.frequency",
        )
    if sensors.step != 1 or not 0 <= sensors.start < sensors.stop <= source.sensor_count:
        raise Refusal(
            kind=Kind.OUT_OF_RANGE,
            field="sensors",
            value=sensors,
            allowed=f"consecutive ones of the source's {source.sensor_count}",
        )
    shape = source.sensors(sensors.start, 1).shape[1:3]
    expected = (response.point_count, len(response.microphones))
    if shape != expected:
        raise Refusal(
            f"its sensors have {counted(shape[0], 'point')} and {counted(shape[1], 'microphone')}; the array has "
            f"{expected[0]} and {expected[1]}",
            kind=Kind.MISMATCH,
            field="source",
        )
