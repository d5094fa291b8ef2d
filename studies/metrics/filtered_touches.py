"""Touches as a localizer hears them: simulated, seen through transfer functions and behind the filters of a listener.

The touches are those of :mod:`localize.signals.stimulus`, from fixed seeds and the same for all designs, so that
designs are compared by what differs in them. Frames of 250 samples go through filters, each giving one complex number
per microphone (:mod:`studies.metrics.confusion`).
"""

from __future__ import annotations

import math
from copy import copy
from functools import lru_cache
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

import acoustic_fem
import localize
from geometry.ground.argument_checks import check_choice
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray
from localize.signals import stimulus
from localize.signals.noise_model import NoiseSpectrum
from localize.signals.stimulus import BAND

FRAME = 250
"""Length of a frame, samples, as the localizer takes them."""
SAMPLE_RATE = 1000.0
"""Sample rate of the signals, Hz."""
SOURCE_RMS = 0.25
"""Level of the assumed touch at g = 1, Pa rms."""
NOISE_LINES = 500
"""Number of values that give a noise: its mean square in the hertz around 0, 1, ..., 499 Hz."""
_ROUNDING = 1e-13
"""Part of a transfer function below which its polynomials of high degree are rounding errors."""

#: Who decides: the trained network, or the decoder that needs no training.
Listener = Literal["network", "model"]


def noise_of_filters(noise: float | NoiseSpectrum | ArrayLike, designs: int, listener: Listener) -> Array:
    """Mean square of the noise behind each filter of a listener.

    Args:
        noise: of every microphone, as for :func:`predict_confusion`: a number, a spectrum, or (n_design, 500), Pa^2.
        designs: how many.
        listener: "network" or "model".

    Returns:
        (1, n_filter) or (n_design, n_filter) float64, Pa^2.

    Raises:
        Refusal: a wrong shape, a value that is not finite and above zero, or an unknown listener.
    """
    power = np.asarray(getattr(noise, "power", noise), np.float64)
    if power.ndim == 0:
        power = np.full(NOISE_LINES, power * abs(float(power)) / NOISE_LINES)
    power = np.atleast_2d(power)
    if power.shape[1] != NOISE_LINES or len(power) not in (1, designs):
        problem = f"has shape {power.shape}; it must be one value, ({NOISE_LINES},) or ({designs}, {NOISE_LINES})"
        raise Refusal(problem, kind=Kind.WRONG_TYPE, field="microphone_noise")
    if not np.all(np.isfinite(power)) or np.any(power < 0) or np.any(power.sum(axis=1) <= 0):
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="microphone_noise", allowed="finite and above 0")
    return np.asarray(power @ _passed_noise(listener))


@lru_cache(maxsize=2)
def _passed_noise(listener: Listener) -> Array:
    """Noise that the filters pass at each of its lines, (NOISE_LINES, n_filter)."""
    forth, back = filtered(np.arange(NOISE_LINES, dtype=np.float64), listener)
    return np.asarray((np.abs(forth) ** 2 + np.abs(back) ** 2) / 2)


class TouchFilter:
    """Linear map from transfer functions on one grid to the filtered frames of the simulated touches."""

    def __init__(self, grid: Array, listener: Listener, touches: int, seed: int) -> None:
        lines = stimulus.lines_within(BAND)
        spectrum = stimulus.multi_sines(seed, "evaluation", 0, touches, BAND).spectrum[:, lines].numpy()
        spectrum = spectrum.astype(np.complex128).T
        at = stimulus.line_frequencies()[lines]
        forth, back = filtered(at, listener)
        one, other = forth[:, :, None] * spectrum[:, None], back[:, :, None] * spectrum.conj()[:, None]
        #: 2, n_filter, n_touch
        self.shape = 2, *one.shape[1:]
        # Transfer functions are smooth over log f: their first polynomials, orthonormal on the grid, hold all digits.
        place = np.log(grid / grid[0]) / np.log(grid[-1] / grid[0])
        self._polynomials, _ = np.linalg.qr(np.polynomial.chebyshev.chebvander(2 * place - 1, len(grid) - 1))
        # Real numbers throughout: real and imaginary parts of transfer functions to those of frames. A matrix for each
        # part and filter, in which those of a polynomial follow each other: small products need no copy.
        seen = [
            np.tensordot(matrix @ self._polynomials, sources, (0, 0))
            for matrix, sources in zip(
                acoustic_fem.numerics.interpolation(grid, at), (one + other, 1j * (one - other)), strict=True
            )
        ]
        parts = np.stack([[each.real, each.imag] for each in seen])  # (2, 2, n_number, n_filter, n_touch)
        self._matrix = np.ascontiguousarray(parts.transpose(1, 3, 2, 0, 4)).reshape(-1, 2 * len(grid), touches)
        source = np.arange(BAND[0], BAND[1] + 1e-9, 1.0)
        self._to_source = acoustic_fem.numerics.interpolation(grid, source)
        forth, back = filtered(source, listener)
        # mean square of the source per hertz, half of it at the negative frequency
        density = SOURCE_RMS**2 / len(source) / 2
        at_once, mirrored = density * np.abs(forth) ** 2, density * np.abs(back) ** 2
        self._weight = at_once + mirrored, at_once - mirrored

    def of(self, touches: slice) -> TouchFilter:
        """The filter of some of the touches."""
        matrix = self._matrix[..., touches]
        if matrix.shape == self._matrix.shape:
            return self
        few = copy(self)
        few._matrix, few.shape = np.ascontiguousarray(matrix), (*self.shape[:2], matrix.shape[-1])
        return few

    def frames(self, h: ComplexArray, out: Array | None = None) -> Array:
        """Frames of the touches behind the filters, real and imaginary parts.

        (n_design, n_point, n_microphone, 2, n_filter, n_touch); written to the contiguous ``out`` where it is given.
        """
        parts = np.stack([h.real, h.imag], axis=-2) @ self._polynomials
        size = np.abs(parts).max(axis=-2)
        counts = (size > _ROUNDING * size.max(axis=-1, keepdims=True)).any(axis=(0, 1, 2))
        kept = 1 + int(np.flatnonzero(counts).max(initial=0))
        numbers = parts[..., :kept].swapaxes(-1, -2).reshape(-1, 2 * kept)
        out = np.empty((*h.shape[:3], *self.shape)) if out is None else out
        rows = out.reshape(len(numbers), -1, self.shape[-1]).swapaxes(0, 1)
        np.matmul(numbers, self._matrix[:, : 2 * kept], out=rows)
        return out

    def covariance(self, h: ComplexArray) -> ComplexArray:
        """C of every point at g = 1: (n_design, n_point, n_microphone, n_microphone, n_filter)."""
        real, imaginary = self._to_source
        at_real, at_imaginary = h.real @ real.T, h.imag @ imaginary.T
        microphones = h.shape[2]
        seen = np.zeros((*h.shape[:2], microphones, microphones, self.shape[1]), np.complex128)
        for a in range(microphones):
            for b in range(a, microphones):
                one, other = (each[:, :, a] for each in (at_real, at_imaginary))
                alike = one * at_real[:, :, b] + other * at_imaginary[:, :, b]
                seen[:, :, a, b].real = alike @ self._weight[0]
                if a < b:
                    seen[:, :, a, b].imag = (other * at_real[:, :, b] - one * at_imaginary[:, :, b]) @ self._weight[1]
                    seen[:, :, b, a] = seen[:, :, a, b].conj()
        return seen


@lru_cache(maxsize=4)
def touch_filter(grid: bytes, listener: Listener, touches: int, seed: int) -> TouchFilter:
    """The filter of a listener for a grid of frequencies, the bytes of (n_freq,) float64, Hz, made once."""
    return TouchFilter(np.frombuffer(grid, np.float64), listener, touches, seed)


@lru_cache(maxsize=4)
def standard_noise(points: int, microphones: int, listener: Listener, touches: int, seed: int) -> Array:
    """Filtered white noise of one frame per point and touch, of variance 1 behind each filter.

    (n_point, n_microphone, 2, n_filter, n_touch), real and imaginary parts; filters that overlap share noise, as they
    do.
    """
    random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(1,)))
    white = random.standard_normal((points, microphones, touches, FRAME))
    seen = (white @ filters_of(listener).T / np.linalg.norm(filters_of(listener), axis=1)).swapaxes(-1, -2)
    return np.ascontiguousarray(np.stack([seen.real, seen.imag], axis=2))


@lru_cache(maxsize=2)
def filters_of(listener: Listener) -> ComplexArray:
    """(n_filter, FRAME) complex128."""
    check_choice("listener", listener, get_args(Listener))
    if listener == "model":
        time = np.arange(FRAME)
        taper = math.sqrt(2) * np.sin(np.pi * (time + 0.5) / FRAME)
        bins = np.arange(math.floor(BAND[1] * FRAME / SAMPLE_RATE) + 2)
        return np.asarray(taper * np.exp(-2j * np.pi * bins[:, None] * time / FRAME) / FRAME)
    return _wavelets()


def _wavelets() -> ComplexArray:
    """The wavelets of the features at the end of a frame, continued by its last sample."""
    rows = []
    spread = 1 / (2 * math.pi * localize.learned.BANDWIDTH)  # standard deviation in frequency, per frequency
    count = math.floor(math.log(BAND[1] / BAND[0]) / math.log1p(spread)) + 1
    spectrum_at = np.fft.fftfreq(localize.learned.GRID, 1 / SAMPLE_RATE)
    for centre in BAND[0] * (1 + spread) ** np.arange(count):
        shape = np.exp(-0.5 * ((spectrum_at / centre - 1) / spread) ** 2)
        kernel = np.fft.ifft(np.where(spectrum_at > 0, shape, 0.0))
        times = max(1, round(localize.learned.TAIL / SAMPLE_RATE * centre / localize.learned.BANDWIDTH))
        middle = FRAME - (localize.learned.TAIL + 1) / 2
        moments = [middle] if times == 1 else np.linspace(FRAME - localize.learned.TAIL, FRAME - 1, times)
        for moment in np.round(moments).astype(int):
            row = kernel[(moment - np.arange(FRAME + localize.learned.CONTINUATION)) % localize.learned.GRID]
            row[FRAME - 1] += row[FRAME:].sum()
            rows.append(row[:FRAME] / np.linalg.norm(row[:FRAME]))
    return np.array(rows)


def filtered(frequency: Array, listener: Listener) -> tuple[ComplexArray, ComplexArray]:
    """Outputs of the filters for exp(j w t) and its conjugate: (n, n_filter) each."""
    wave = np.exp(2j * np.pi * frequency[:, None] * np.arange(FRAME) / SAMPLE_RATE)
    filters = filters_of(listener).T
    return wave @ filters, wave.conj() @ filters
