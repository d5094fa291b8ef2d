"""Microphone signals of touches, made from a library of transfer functions.

The signals are the exact steady state of a periodic stimulus: its spectral lines are multiplied by the transfer
functions, interpolated by a cubic spline of the complex values over frequency, and transformed back over the whole
period. Products of short-window transforms, which alias circularly as soon as the impulse response is longer than
the window, are not used. The stimulus noise is limited to the frequencies that the library covers.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
import torch
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline
from torch import Tensor

from localize import stimulus
from localize.noise import NoiseChoice, NoiseSpectrum, microphone_noise
from localize.stimulus import BAND, Purpose
from localize.threads import one_thread

if TYPE_CHECKING:
    from acoustic_fem import Library

SHARD = 256
"""Samples made at once when streaming: their spectra fit in the processor's cache."""


@dataclass(frozen=True, eq=False)
class ArrayResponse:
    """The transfer functions of one array as plain arrays: what the localizer takes from a library."""

    transfer_function: NDArray[np.complex128]
    """(n_point, n_microphone, n_freq) complex128, pressure at a microphone / pressure in the touched cavity."""
    frequency: NDArray[np.float64]
    """(n_freq,) float64, Hz, increasing, covering 1 to 100 Hz."""
    line: NDArray[np.int64]
    """(n_point,) line of each point."""
    place: NDArray[np.int64]
    """(n_point,) place of each point along its line."""
    microphones: tuple[str, ...]
    name: str = "array"
    """Name of the design."""
    provenance: Mapping[str, Any] = field(default_factory=dict)
    """Design, fidelity, air, frequencies and versions, as JSON can hold them."""
    own_noise: NoiseSpectrum | None = None
    """Noise of the design's microphone; None where there is no design."""

    def __post_init__(self) -> None:
        h, f = self.transfer_function, self.frequency
        if h.ndim != 3 or h.shape[1:] != (len(self.microphones), len(f)):
            raise ValueError(
                f"transfer_function has shape {h.shape}, must be (n_point, n_microphone, n_freq) = "
                f"(n, {len(self.microphones)}, {len(f)})"
            )
        if len(self.line) != len(h) or len(self.place) != len(h):
            raise ValueError(f"line and place must each have one value for each of the {len(h)} points")
        if len(h) < 2 or len(self.microphones) < 2:
            raise ValueError(
                f"{len(h)} points and {len(self.microphones)} microphones: localizing needs at least 2 of each"
            )
        if len(f) < 4 or f[0] <= 0 or np.any(np.diff(f) <= 0):
            raise ValueError("frequency must hold at least 4 increasing values above 0 Hz")
        if f[0] > BAND[0] + 1e-6 or f[-1] < BAND[1] - 1e-6:
            raise ValueError(
                f"frequency runs from {f[0]:g} to {f[-1]:g} Hz; it must cover {BAND[0]:g} to {BAND[1]:g} Hz, "
                "the band of the stimuli"
            )
        bad = np.argwhere(~np.isfinite(h))
        if len(bad):
            point, microphone, k = bad[0]
            raise ValueError(
                f"transfer_function of point {point + 1} at microphone {self.microphones[microphone]} is not finite "
                f"at {f[k]:g} Hz"
            )

    @property
    def point_count(self) -> int:
        """Number of sensing points."""
        return len(self.transfer_function)

    def noise(self, choice: NoiseChoice) -> float | NoiseSpectrum:
        """What is added to every microphone: white noise in Pa rms over 0 to 500 Hz, or that of the design.

        Raises:
            ValueError: "design" where there is none, or a number that is not finite or below zero.
        """
        if choice == "design":
            if self.own_noise is None:
                raise ValueError("microphone_noise = 'design' needs a library with a design; else give Pa rms")
            return self.own_noise
        if not 0 <= choice < np.inf:
            raise ValueError(f"microphone_noise = {choice} must be 'design' or a finite number, zero or above")
        return float(choice)

    def at(self, frequency: NDArray[np.float64]) -> NDArray[np.complex128]:
        """Transfer functions interpolated to frequencies inside the library's range.

        Returns:
            (n_point, n_microphone, n) complex128.
        """
        even, odd = interpolation(self.frequency, frequency)
        return self.transfer_function.real @ even.T + 1j * (self.transfer_function.imag @ odd.T)


class TransferFunctionSource(Protocol):
    """Transfer functions of many sensors of one design, read as they are needed."""

    @property
    def frequency(self) -> NDArray[np.float64]:
        """(n_freq,) float64, Hz."""

    @property
    def sensor_count(self) -> int:
        """Number of sensors."""

    def sensors(self, first: int, count: int) -> NDArray[np.complex128]:
        """(count, n_point, n_microphone, n_freq) complex128 of consecutive sensors."""


def interpolation(
    grid: NDArray[np.float64], frequency: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The splines as matrices (n, n_freq): of real parts, which are even about 0 Hz, and of imaginary ones, odd."""
    # Continued to negative frequencies, where the response of a real system is the conjugate: the spline then
    # needs no end condition near 0 Hz, where the response bends most.
    unit = np.eye(len(grid))
    both = np.concatenate([-grid[::-1], grid])
    even, odd = (CubicSpline(both, np.concatenate([sign * unit[::-1], unit]))(frequency) for sign in (1, -1))
    return even, odd


def response_of(library: Library | ArrayResponse) -> ArrayResponse:
    """The plain arrays of a library.

    Raises:
        ValueError: the library's frequencies do not cover 1 to 100 Hz, or a value is not finite.
    """
    if isinstance(library, ArrayResponse):
        return library
    from geometry.design_file import write_design

    h = library.transfer_function.transpose("point", "microphone", "frequency")
    return ArrayResponse(
        transfer_function=np.asarray(h.values, np.complex128),
        frequency=np.asarray(h.coords["frequency"].values, np.float64),
        line=np.asarray(h.coords["line"].values, np.int64),
        place=np.asarray(h.coords["place"].values, np.int64),
        microphones=tuple(str(name) for name in h.coords["microphone"].values),
        name=library.design.name,
        provenance={
            "design": write_design(library.design),
            "fidelity": library.fidelity,
            "medium": asdict(library.medium),
            "frequency": [float(f) for f in h.coords["frequency"].values],
            "library": dict(library.provenance),
        },
        own_noise=microphone_noise(library.design.microphone, library.medium),
    )


@dataclass(frozen=True)
class TouchSignals:
    """Signals of consecutive samples, one second each at 1 kHz."""

    signals: Tensor
    """(n, n_microphone, SAMPLE_LENGTH) float32, Pa."""
    point: Tensor
    """(n,) int64: index of the touched point, from 0."""
    interval: Tensor
    """(n,) int64: index into ``stimulus.COMPONENT_INTERVALS``."""


class TouchGenerator:
    """Endless stream of touches; sample i touches point i modulo the number of points.

    With a source of many sensors, each sensor in turn is touched at all of its points; only the sensors of the
    samples at hand are read.

    Args:
        response: the array.
        seed: any non-negative integer.
        purpose: streams of different purposes never share a stimulus.
        microphone_noise: added to every microphone, Gaussian: Pa rms over 0 to 500 Hz, white, or "design" for that of
            the design's microphone, see :mod:`localize.noise`.
        source: transfer functions of many sensors in place of those of the array, on frequencies of its own.
        sensors: those of the source that are touched; by default all.

    Raises:
        ValueError: as :meth:`ArrayResponse.noise`; a source that covers less than 1 to 100 Hz, holds other points or
            microphones than the array, or has none of the sensors asked for.
    """

    def __init__(
        self,
        response: ArrayResponse,
        seed: int,
        purpose: Purpose,
        microphone_noise: NoiseChoice = 0.0,
        source: TransferFunctionSource | None = None,
        sensors: range | None = None,
    ) -> None:
        self.response = response
        self.seed = seed
        self.purpose: Purpose = purpose
        self.microphone_noise = response.noise(microphone_noise)
        grid = response.frequency if source is None else source.frequency
        self._noise_band = (float(grid[0]), float(grid[-1]))
        self._lines = stimulus.lines_within(self._noise_band)
        lines = np.clip(stimulus.line_frequencies()[self._lines], *self._noise_band)
        self._splines = interpolation(grid, lines)
        self._source = source
        self._sensors = range(1)
        if source is None:
            self._on_lines = self._on_all_lines(response.transfer_function)
        else:
            self._sensors = range(source.sensor_count) if sensors is None else sensors
            _check_source(source, response, self._sensors)

    def _on_all_lines(self, values: NDArray[np.complex128]) -> Tensor:
        """From the grid to the stimulus's lines, with zeros on those below the ones that the grid covers."""
        even, odd = self._splines
        padded = np.zeros((*values.shape[:-1], self._lines.stop), np.complex64)
        padded[..., self._lines] = values.real @ even.T + 1j * (values.imag @ odd.T)
        return torch.from_numpy(padded)

    def _transfer_function(self, start: int, count: int) -> Tensor:
        """(count, n_microphone, n_line) of consecutive samples."""
        points = self.response.point_count
        if self._source is None:
            return self._on_lines[torch.arange(start, start + count) % points]
        turn = np.arange(start, start + count) // points % len(self._sensors)
        runs = np.split(np.unique(turn), np.flatnonzero(np.diff(np.unique(turn)) > 1) + 1)
        first = self._sensors.start
        read = np.concatenate([self._source.sensors(first + int(run[0]), len(run)) for run in runs])
        place = np.searchsorted(np.unique(turn), turn)
        return self._on_all_lines(read)[place, np.arange(start, start + count) % points]

    @one_thread()
    def samples(self, start: int, count: int) -> TouchSignals:
        """Samples ``start`` to ``start + count - 1``, the same whatever was asked for before."""
        stimuli = stimulus.multi_sines(self.seed, self.purpose, start, count, self._noise_band)
        point = torch.arange(start, start + count) % self.response.point_count
        transfer_function = self._transfer_function(start, count)
        signals = microphone_signals(stimuli.spectrum[:, : self._lines.stop], transfer_function)
        stream = (self.seed, self.purpose, start, count, len(self.response.microphones))
        if isinstance(self.microphone_noise, NoiseSpectrum):
            signals = signals + stimulus.coloured_noise(*stream, self.microphone_noise.power)
        elif self.microphone_noise:
            signals = signals + stimulus.white_noise(*stream, self.microphone_noise)
        return TouchSignals(signals=signals, point=point, interval=stimuli.interval)

    def stream(self, start: int, count: int, shard: int = SHARD) -> Iterator[TouchSignals]:
        """The same samples in shards."""
        for first in range(start, start + count, shard):
            yield self.samples(first, min(shard, start + count - first))


def microphone_signals(
    spectrum: Tensor, transfer_function: Tensor, sample_count: int = stimulus.SAMPLE_LENGTH
) -> Tensor:
    """Exact steady state at the microphones.

    Args:
        spectrum: (n, n_line) complex amplitudes of the cavity pressure on the lowest spectral lines.
        transfer_function: (n, n_microphone, n_line) complex, on the same lines.
        sample_count: at most ``stimulus.PERIOD``.

    Returns:
        (n, n_microphone, sample_count) real.
    """
    return stimulus.time_signal(spectrum[:, None, :] * transfer_function, sample_count)


def _check_source(source: TransferFunctionSource, response: ArrayResponse, sensors: range) -> None:
    grid = source.frequency
    if grid[0] > BAND[0] + 1e-6 or grid[-1] < BAND[1] - 1e-6:
        raise ValueError(
            f"source: frequency runs from {grid[0]:g} to {grid[-1]:g} Hz; it must cover {BAND[0]:g} to {BAND[1]:g} Hz"
        )
    if sensors.step != 1 or not 0 <= sensors.start < sensors.stop <= source.sensor_count:
        raise ValueError(f"sensors = {sensors} must be consecutive ones of the source's {source.sensor_count}")
    shape = source.sensors(sensors.start, 1).shape[1:3]
    expected = (response.point_count, len(response.microphones))
    if shape != expected:
        raise ValueError(
            f"source: its sensors have {shape[0]} points and {shape[1]} microphones; the array has {expected[0]} and "
            f"{expected[1]}"
        )
