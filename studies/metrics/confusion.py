"""How often points will be taken for each other, predicted from transfer functions, touches and noise: no training.

A localizer decides from a frame of 250 samples. What it makes of a frame is taken as a set of filters, each giving one
complex vector x_k with an entry per microphone. Two listeners:

- ``network``: the Morlet wavelets of :mod:`localize.learned.features` at the end of the frame, one standard deviation
  apart in frequency and in time. Above 20 Hz they hear a few periods only, which is where a trained network loses most.
- ``model``: sine windows over the whole frame (Riedel and Sidorenko, IEEE Trans. Signal Process. 43 (1995) 188) at
  0, 4, ..., 104 Hz, for :class:`localize.BayesDecoder`, of which this is the quick form.

If point j is touched, x_k is taken as a zero-mean Gaussian of covariance g C_jk + N_k, all k independent of each other
(Whittle's approximation): C_jk is that of a source of flat spectrum from 1 to 100 Hz seen through the transfer
functions of j and the filter, g the unknown power of the touch, N_k the noise. The point of the largest likelihood,
maximised over g, is named. Where signals stand far out of the noise, this compares ratios of microphones.

The touches are those of :mod:`localize.signals.stimulus`, from fixed seeds and the same for all designs, so that
designs are compared by what differs in them. docs/metrics.md compares predictions with trained localizers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geometry.refusal import Refusal

if TYPE_CHECKING:
    from localize.signals.noise import NoiseSpectrum

FRAME = 250
"""Length of a frame, samples, as the localizer takes them."""
SAMPLE_RATE = 1000.0
"""Sample rate of the signals, Hz."""
BAND = (1.0, 100.0)
"""Band of the touches and of the source that the decoder assumes, Hz."""
SOURCE_RMS = 0.25
"""Level of the assumed touch at g = 1, Pa rms."""
POWERS = 10.0 ** np.arange(-4.0, 2.1)
"""Values of g that are tried."""
NOISE_LINES = 500
"""Number of values that give a noise: its mean square in the hertz around 0, 1, ..., 499 Hz."""
_MEMORY = 40_000_000
"""Bytes of simulated frames at once."""

#: Who decides: the trained network, or the decoder that needs no training.
Listener = Literal["network", "model"]
Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class PredictedConfusion:
    """Predicted shares of touches, 0 to 1, by simulation."""

    confusion: Array
    """Share of the touches of the row's point that name the column's; (n_design, n_point, n_point) float64."""
    pairwise: Array
    """Share of touches of two points, both touched equally often, for which the wrong one of these two is the likelier;
    (n_design, n_point, n_point) float64, symmetric, zero on the diagonal."""
    touches: int
    """Number of touches simulated per point."""

    @property
    def top1(self) -> Array:
        """Share of touches whose point is named; (n_design,) float64."""
        return np.asarray(np.einsum("dpp->d", self.confusion) / self.confusion.shape[1])


def predict_confusion(
    transfer_function: ArrayLike,
    frequency: ArrayLike,
    noise: float | NoiseSpectrum | ArrayLike,
    *,
    listener: Listener = "network",
    assumed: ArrayLike | None = None,
    touches: int = 64,
    seed: int = 0,
) -> PredictedConfusion:
    """Confusion of the points of many designs, each touched in the same ways.

    Args:
        transfer_function: (n_design, n_point, n_microphone, n_freq) complex, Pa/Pa, of the sensors that are touched.
        frequency: (n_freq,) Hz, ascending, over 1 to 100 Hz.
        noise: of every microphone: Pa rms over 0 to 500 Hz, white; a spectrum from :mod:`localize.signals.noise`; or
            mean squares per hertz (n_design, 500), Pa^2.
        listener: "network" or "model".
        assumed: (n, n_point, n_microphone, n_freq) complex, Pa/Pa, that the listener goes by; by default those of each
            sensor itself. Several are a scatter that the listener knows: likelihoods are averaged over them.
        touches: per point.
        seed: of touches and noise.

    Raises:
        Refusal: shapes that do not agree, fewer than two points or microphones, a grid that does not cover the
            band, an unknown listener, or noise that is not finite and above zero.
    """
    h, grid = np.asarray(transfer_function, np.complex128), np.asarray(frequency, np.float64)
    _check(h, grid, touches)
    designs, points, microphones, _ = h.shape
    of_filters = noise_of_filters(noise, designs, listener)
    ear = _ear(grid.tobytes(), listener, touches, seed)
    standard = _standard_noise(points, microphones, listener, touches, seed)
    hypotheses = None
    if assumed is not None:
        known = np.asarray(assumed, np.complex128)
        if known.ndim != 4 or known.shape[1:] != h.shape[1:] or not len(known) or not np.all(np.isfinite(known)):
            raise Refusal(
                f"assumed has shape {known.shape}; it must be (n, {', '.join(map(str, h.shape[1:]))}), all finite"
            )
        hypotheses = ear.covariance(known)
    confusion, pairwise = np.zeros((2, designs, points, points))
    size = 16 * points * touches * (microphones * of_filters.shape[1] * 2 + points * len(POWERS))
    step = max(1, _MEMORY // size)
    for first in range(0, designs, step):
        part = slice(first, first + step)
        power = of_filters[part if len(of_filters) > 1 else slice(None)]
        signal = ear.frames(h[part]) / np.sqrt(power)[:, None, None, None, :] + standard
        level = power[:, None, :, None, None]
        if hypotheses is None:
            score = _scores(signal, ear.covariance(h[part]) / level)
        else:
            score = _scores(signal, hypotheses[:1] / level)
            for one in hypotheses[1:]:
                score = np.logaddexp(score, _scores(signal, one / level))
        confusion[part], pairwise[part] = _counted(score)
    return PredictedConfusion(confusion, pairwise, touches)


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
        raise Refusal(
            f"noise has shape {power.shape}; it must be one value, ({NOISE_LINES},) or ({designs}, {NOISE_LINES})"
        )
    if not np.all(np.isfinite(power)) or np.any(power < 0) or np.any(power.sum(axis=1) <= 0):
        raise Refusal("noise must be finite and above 0")
    forth, back = _filtered(np.arange(NOISE_LINES, dtype=np.float64), listener)
    return np.asarray(power @ (np.abs(forth) ** 2 + np.abs(back) ** 2) / 2)


class _Ear:
    """What lies between transfer functions on one grid and the filtered frames of the simulated touches; linear."""

    def __init__(self, grid: Array, listener: Listener, touches: int, seed: int) -> None:
        from localize.signals import stimulus
        from localize.signals.array_response import interpolation

        lines = stimulus.lines_within(BAND)
        spectrum = stimulus.multi_sines(seed, "evaluation", 0, touches, BAND).spectrum[:, lines].numpy()
        spectrum = spectrum.astype(np.complex128)
        at = stimulus.line_frequencies()[lines]
        forth, back = _filtered(at, listener)
        real, imaginary = interpolation(grid, at)
        one, other = spectrum[:, :, None] * forth, spectrum.conj()[:, :, None] * back  # (touch, line, filter)
        self._shape = touches, forth.shape[1]
        of_real = np.tensordot(real, one + other, (0, 1)).reshape(len(grid), -1)
        of_imaginary = np.tensordot(imaginary, 1j * (one - other), (0, 1)).reshape(len(grid), -1)
        # real numbers throughout: real and imaginary parts of transfer functions to those of frames
        self._matrix = np.concatenate([of_real, of_imaginary]).view(np.float64)
        source = np.arange(BAND[0], BAND[1] + 1e-9, 1.0)
        self._to_source = interpolation(grid, source)
        forth, back = _filtered(source, listener)
        # mean square of the source per hertz, half of it at the negative frequency
        density = SOURCE_RMS**2 / len(source) / 2
        self._weight = density * np.abs(forth) ** 2, density * np.abs(back) ** 2

    def frames(self, h: Complex) -> Complex:
        """(n_design, n_point, n_microphone, n_touch, n_filter)."""
        parts = np.concatenate([h.real, h.imag], axis=-1).reshape(-1, len(self._matrix))
        return (parts @ self._matrix).view(np.complex128).reshape(*h.shape[:3], *self._shape)

    def covariance(self, h: Complex) -> Complex:
        """C of every point at g = 1: (n_design, n_point, n_filter, n_microphone, n_microphone)."""
        real, imaginary = self._to_source
        at = h.real @ real.T + 1j * (h.imag @ imaginary.T)
        cross = at[:, :, :, None] * at[:, :, None].conj()
        seen = np.asarray(cross @ self._weight[0] + cross.conj() @ self._weight[1], np.complex128)
        return np.moveaxis(seen, -1, 2)


@lru_cache(maxsize=4)
def _ear(grid: bytes, listener: Listener, touches: int, seed: int) -> _Ear:
    return _Ear(np.frombuffer(grid, np.float64), listener, touches, seed)


def _scores(signal: Complex, covariance: Complex) -> Array:
    """Log-likelihoods up to a constant per touch; noise of variance 1.

    Args:
        signal: (n_design, n_point, n_microphone, n_touch, n_filter).
        covariance: (n_design, n_point, n_filter, n_microphone, n_microphone).

    Returns:
        (n_design, n_point, n_touch, n_point), the last over hypotheses.
    """
    designs, points, microphones, touches, _ = signal.shape
    values, vectors = np.linalg.eigh(covariance)
    gain = np.clip(values, 0, None)[..., None] * POWERS  # (design, hypothesis, filter, microphone, power)
    cost = np.log1p(gain).sum(axis=(2, 3))
    share = gain / (1 + gain)
    # x^H (1 - S^-1) x is linear in the products of microphones
    observed, weights = [], []
    for a in range(microphones):
        for b in range(a, microphones):
            factor = vectors[..., a, :] * vectors[..., b, :].conj()
            weight = (factor[..., None, :] @ share)[..., 0, :]  # (design, hypothesis, filter, power)
            if a == b:
                observed.append(signal[:, :, a].real ** 2 + signal[:, :, a].imag ** 2)
                weights.append(weight.real)
            else:
                # conj(x_a) M_ab x_b and its mirror image: twice the real part
                product = signal[:, :, a].conj() * signal[:, :, b]
                observed += [2 * product.real, -2 * product.imag]
                weights += [weight.real, weight.imag]
    left = np.concatenate(observed, axis=-1).reshape(designs, points * touches, -1)
    right = np.moveaxis(np.concatenate(weights, axis=2), 2, 1)  # (design, feature, hypothesis, power)
    score = left @ right.reshape(len(right), right.shape[1], -1)
    score = score.reshape(designs, points * touches, points, len(POWERS)) - cost[:, None]
    return np.asarray(score.max(axis=-1).reshape(designs, points, touches, points))


def _counted(score: Array) -> tuple[Array, Array]:
    """Shares named, and shares where the wrong one of two is the likelier; a tie counts half."""
    points = score.shape[1]
    named = score.argmax(axis=-1)
    confusion = (named[..., None] == np.arange(points)).mean(axis=2)
    own = np.einsum("dpnp->dpn", score)[..., None]
    wrong = ((score > own) + 0.5 * (score == own)).mean(axis=2)
    wrong[:, np.arange(points), np.arange(points)] = 0.0
    return confusion, (wrong + wrong.swapaxes(1, 2)) / 2


@lru_cache(maxsize=4)
def _standard_noise(points: int, microphones: int, listener: Listener, touches: int, seed: int) -> Complex:
    """Filtered white noise of one frame per point and touch, of variance 1 behind each filter.

    (n_point, n_microphone, n_touch, n_filter); filters that overlap share noise, as they do.
    """
    random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(1,)))
    white = random.standard_normal((points, microphones, touches, FRAME))
    return np.asarray(white @ _filters(listener).T / np.linalg.norm(_filters(listener), axis=1))


@lru_cache(maxsize=2)
def _filters(listener: Listener) -> Complex:
    """(n_filter, FRAME) complex128."""
    if listener not in get_args(Listener):
        raise Refusal(f"listener = {listener!r} must be one of: {', '.join(get_args(Listener))}")
    if listener == "model":
        time = np.arange(FRAME)
        taper = math.sqrt(2) * np.sin(np.pi * (time + 0.5) / FRAME)
        bins = np.arange(math.floor(BAND[1] * FRAME / SAMPLE_RATE) + 2)
        return np.asarray(taper * np.exp(-2j * np.pi * bins[:, None] * time / FRAME) / FRAME)
    return _wavelets()


def _wavelets() -> Complex:
    """The wavelets of the features at the end of a frame, continued by its last sample."""
    from localize.learned.features import BANDWIDTH, CONTINUATION, GRID, TAIL

    rows = []
    spread = 1 / (2 * math.pi * BANDWIDTH)  # standard deviation in frequency, per frequency
    count = math.floor(math.log(BAND[1] / BAND[0]) / math.log1p(spread)) + 1
    spectrum_at = np.fft.fftfreq(GRID, 1 / SAMPLE_RATE)
    for centre in BAND[0] * (1 + spread) ** np.arange(count):
        shape = np.exp(-0.5 * ((spectrum_at / centre - 1) / spread) ** 2)
        kernel = np.fft.ifft(np.where(spectrum_at > 0, shape, 0.0))
        times = max(1, round(TAIL / SAMPLE_RATE * centre / BANDWIDTH))
        middle = FRAME - (TAIL + 1) / 2
        moments = [middle] if times == 1 else np.linspace(FRAME - TAIL, FRAME - 1, times)
        for moment in np.round(moments).astype(int):
            row = kernel[(moment - np.arange(FRAME + CONTINUATION)) % GRID]
            row[FRAME - 1] += row[FRAME:].sum()
            rows.append(row[:FRAME] / np.linalg.norm(row[:FRAME]))
    return np.array(rows)


def _filtered(frequency: Array, listener: Listener) -> tuple[Complex, Complex]:
    """What the filters make of exp(j w t) and of its conjugate: (n, n_filter) each."""
    wave = np.exp(2j * np.pi * frequency[:, None] * np.arange(FRAME) / SAMPLE_RATE)
    filters = _filters(listener).T
    return wave @ filters, wave.conj() @ filters


def _check(h: Complex, grid: Array, touches: int) -> None:
    if h.ndim != 4 or h.shape[3] != len(grid) or not len(h):
        raise Refusal(
            f"transfer_function has shape {h.shape}; it must be (n_design, n_point, n_microphone, {len(grid)})"
        )
    for name, count in (("points", h.shape[1]), ("microphones", h.shape[2])):
        if count < 2:
            raise Refusal(f"predicted confusion: {name} = {count} must be at least 2")
    check_grid(grid)
    if not np.all(np.isfinite(h)):
        raise Refusal("transfer_function must be finite")
    if isinstance(touches, bool) or not 1 <= touches <= 100_000:
        raise Refusal(f"touches = {touches} must be a whole number from 1 to 100000")


def check_grid(grid: Array) -> None:
    """Refuse frequencies from which no confusion can be predicted.

    Args:
        grid: (n_freq,) float64, Hz.

    Raises:
        Refusal: fewer than 4 ascending values, or less than 1 to 100 Hz.
    """
    if len(grid) < 4 or grid[0] <= 0 or np.any(np.diff(grid) <= 0):
        raise Refusal("frequency must hold at least 4 ascending values above 0 Hz")
    if grid[0] > BAND[0] + 1e-6 or grid[-1] < BAND[1] - 1e-6:
        raise Refusal(
            f"frequency runs from {grid[0]:g} to {grid[-1]:g} Hz; predicted confusion needs {BAND[0]:g} to "
            f"{BAND[1]:g} Hz, the band of the touches"
        )
