"""How often points will be taken for each other, predicted from transfer functions, touches and noise: no training.

A localizer decides from a frame of 250 samples. Its input from a frame is taken as a set of filters, each giving one
complex vector x_k with an entry per microphone. Two listeners:

- ``network``: the Morlet wavelets of :mod:`localize.learned.wavelets` at the end of the frame, one standard deviation
  apart in frequency and in time. Above 20 Hz they hear a few periods only, which is where a trained network loses most.
- ``model``: sine windows over the whole frame (Riedel and Sidorenko, IEEE Trans. Signal Process. 43 (1995) 188) at
  0, 4, ..., 104 Hz, for :class:`localize.BayesDecoder`, of which this is the quick form.

If point j is touched, x_k is taken as a zero-mean Gaussian of covariance g C_jk + N_k, all k independent of each other
(Whittle's approximation): C_jk is that of a source of flat spectrum from 1 to 100 Hz seen through the transfer
functions of j and the filter, g the unknown power of the touch, N_k the noise. The point of the largest likelihood,
maximised over g, is named. If signals are far above the noise, this compares ratios of microphones.

The touches are those of :mod:`localize.signals.stimulus`, from fixed seeds and the same for all designs, so that
designs are compared by what differs in them. docs/metrics.md compares predictions with trained localizers.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array, ComplexArray
from localize.signals.noise_model import NoiseSpectrum
from localize.signals.stimulus import BAND
from studies.metrics.batch_responses import shape_error
from studies.metrics.filtered_touches import Listener, TouchFilter, noise_of_filters, standard_noise, touch_filter

POWERS = 10.0 ** np.arange(-4.0, 2.1)
"""Values of g that are tried."""
_MEMORY = 5_000_000
"""Bytes of simulated frames and what they score at once: what the processor keeps near."""


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
    frequency: FrequencyLike,
    microphone_noise: float | NoiseSpectrum | ArrayLike,
    *,
    listener: Listener = "network",
    assumed: ArrayLike | None = None,
    touches: int = 64,
    parts: int = 1,
    seed: int = 0,
) -> PredictedConfusion:
    """Confusion of the points of many designs, each touched in the same ways.

    Args:
        transfer_function: (n_design, n_point, n_microphone, n_freq) complex, Pa/Pa, of the sensors that are touched.
        frequency: (n_freq,) Hz, ascending, over 1 to 100 Hz.
        microphone_noise: of every microphone: Pa rms over 0 to 500 Hz, white; a spectrum from
            :mod:`localize.signals.noise_model`; or mean squares per hertz (n_design, 500), Pa^2.
        listener: "network" or "model".
        assumed: (n, n_point, n_microphone, n_freq) complex, Pa/Pa, that the listener goes by; by default those of each
            sensor itself. Several are a scatter that the listener knows: likelihoods are averaged over them.
        touches: per point.
        parts: number of parts into which the touches are divided. Each design is touched by one part, one after the
            other.
        seed: of touches and noise.

    Raises:
        Refusal: shapes that do not agree, fewer than two points or microphones, a grid that does not cover the
            band, an unknown listener, or noise that is not finite and above zero.
    """
    return predict_confusions(
        transfer_function,
        frequency,
        [microphone_noise],
        listener=listener,
        assumed=assumed,
        touches=touches,
        parts=parts,
        seed=seed,
    )[0]


def predict_confusions(
    transfer_function: ArrayLike,
    frequency: FrequencyLike,
    noises: Sequence[float | NoiseSpectrum | ArrayLike],
    *,
    listener: Listener = "network",
    assumed: ArrayLike | None = None,
    touches: int = 64,
    parts: int = 1,
    seed: int = 0,
) -> tuple[PredictedConfusion, ...]:
    """Confusions under several noises, of the same touches, which are simulated once; arguments and errors as
    :func:`predict_confusion`.
    """
    h, grid = np.asarray(transfer_function, np.complex128), frequencies(frequency)
    _check(h, grid, touches)
    check_range("parts", parts, 1, touches, whole=True)
    designs, points, microphones, _ = h.shape
    powers = [noise_of_filters(noise, designs, listener) for noise in noises]
    touches_filtered = touch_filter(grid.tobytes(), listener, touches, seed)
    standard = standard_noise(points, microphones, listener, touches, seed)
    common = () if assumed is None else tuple(touches_filtered.covariance(_assumed(assumed, h)))
    shape = designs, points, points
    each = touches // parts
    found = [PredictedConfusion(np.zeros(shape), np.zeros(shape), each) for _ in powers]
    for part in range(min(parts, designs)):
        of_part = slice(part * each, (part + 1) * each)
        filters, noise = touches_filtered.of(of_part), np.ascontiguousarray(standard[..., of_part])
        _predict(h, slice(part, None, parts), filters, noise, powers, common, found)
    for result in found:
        result.confusion[:] /= each
        result.pairwise[:] = (result.pairwise + result.pairwise.swapaxes(1, 2)) / (2 * each)
    return tuple(found)


def _predict(
    h: ComplexArray,
    chosen: slice,
    touches: TouchFilter,
    standard: Array,
    powers: Sequence[Array],
    common: tuple[ComplexArray, ...],
    found: Sequence[PredictedConfusion],
) -> None:
    """Count touches of some designs.

    Args:
        h: transfer functions of all designs, (n_design, n_point, n_microphone, n_freq), Pa/Pa.
        chosen: the designs that are touched.
        touches: the touches.
        standard: their noise of variance 1, as :meth:`_Room.noise` takes it.
        powers: noises, (1 or n_design, n_filter) each.
        common: covariances of the hypotheses of all designs; empty if each design is assumed to be itself.
        found: results, written.
    """
    numbers = np.arange(len(h))[chosen]
    points, microphones = h.shape[1:3]
    room = _Room(points, microphones, touches.shape)
    weights: dict[tuple[int, int], list[Array]] = {}
    for first in range(0, len(numbers), room.designs):
        part = numbers[first : first + room.designs]
        own = () if common else touches.covariance(h[part])[:, None]
        if not common or max(map(len, powers)) > 1:
            weights.clear()
        for start in range(0, points, room.points):
            touched = slice(start, start + room.points)
            heard = h[part, touched]
            for place, (number, frames) in enumerate(
                zip(part, touches.frames(heard, room.frames_of(heard)), strict=True)
            ):
                for level, (result, power) in enumerate(zip(found, powers, strict=True)):
                    noise = power[min(number, len(power) - 1)]
                    key = level, number if not common or len(power) > 1 else 0
                    if key not in weights:
                        hypotheses = common or own[place]
                        weights[key] = [_weights(covariance, noise) for covariance in hypotheses]
                    observed = room.products(frames, room.noise(level, start, standard[touched], noise))
                    scores = reduce(np.logaddexp, (room.scores(observed, each) for each in weights[key]))
                    _count(scores, start, result.confusion[number, touched], result.pairwise[number, touched])


def _assumed(assumed: ArrayLike, h: ComplexArray) -> ComplexArray:
    """Transfer functions that the listener goes by, those of each sensor of shape ``h``."""
    known = np.asarray(assumed, np.complex128)
    if known.ndim != 4 or known.shape[1:] != h.shape[1:] or not len(known) or not np.all(np.isfinite(known)):
        raise shape_error("assumed", known, f"(n, {', '.join(map(str, h.shape[1:]))}), all finite")
    return known


class _Room:
    """Arrays that are written over and over, for a few designs at a time, or a few points of a large one.

    Fresh memory would cost more than the sums.
    """

    def __init__(self, points: int, microphones: int, shape: tuple[int, int, int]) -> None:
        _, filters, touches = shape
        of_frame, of_products = 2 * microphones * filters * touches, microphones**2 * filters * touches
        size = 8 * (2 * of_frame + of_products + points * (len(POWERS) + 1) * touches)
        #: how many points at a time, and how many designs
        self.points = -(-points // -(-points * size // _MEMORY))
        self.designs = max(1, _MEMORY // (8 * of_frame * points))
        self._frames = np.empty((self.designs, self.points, microphones, 2, filters, touches))
        self._signal = np.empty_like(self._frames[0])
        # the last row stands for what a likelihood has beside products
        self._products = np.ones((self.points, microphones**2 * filters + 1, touches))
        self._other = np.empty((self.points, filters, touches))
        self._scores = np.empty((self.points, len(POWERS), points, touches))
        self._noise: dict[int, tuple[int, bytes, Array]] = {}

    def frames_of(self, h: ComplexArray) -> Array:
        """Contiguous storage for the frames of transfer functions (n_design, n_point, n_microphone, n_freq)."""
        shape = *h.shape[:2], *self._frames.shape[2:]
        return self._frames.reshape(-1)[: math.prod(shape)].reshape(shape)

    def noise(self, level: int, first: int, standard: Array, power: Array) -> Array:
        """Noise of some points behind the filters; designs with the same microphones share it.

        Args:
            level: number of the noise.
            first: first of the points.
            standard: of variance 1, (n_point, n_microphone, 2, n_filter, n_touch).
            power: mean square behind each filter, (n_filter,).
        """
        known = self._noise.get(level)
        if known is None or known[:2] != (first, power.tobytes()):
            known = self._noise[level] = first, power.tobytes(), standard * np.sqrt(power)[:, None]
        return known[2]

    def products(self, frames: Array, noise: Array) -> Array:
        """Terms that likelihoods are linear in: products of signals, |x_a|^2 and parts of conj(x_a) x_b.

        Args:
            frames: (n_point, n_microphone, 2, n_filter, n_touch) of one design.
            noise: what is added to them, shaped as they are.

        Returns:
            (n_point, n_microphone^2 n_filter + 1, n_touch), in the order of :func:`_pairs`, and 1.
        """
        points, microphones, _, filters, _ = frames.shape
        signal, products, other = (each[:points] for each in (self._signal, self._products, self._other))
        np.add(frames, noise, out=signal)
        real, imaginary = signal[:, :, 0], signal[:, :, 1]
        for number, (a, b) in enumerate(_pairs(microphones)):
            own = products[:, number * filters : (number + 1) * filters]
            if a <= b:
                np.multiply(real[:, a], real[:, b], out=own)
                own += np.multiply(imaginary[:, a], imaginary[:, b], out=other)
            else:  # the imaginary part of the pair b, a
                np.multiply(real[:, b], imaginary[:, a], out=own)
                own -= np.multiply(imaginary[:, b], real[:, a], out=other)
        return products

    def scores(self, observed: Array, weights: Array) -> Array:
        """Log-likelihoods up to a constant per touch, maximised over g.

        Args:
            observed: (n_point, n_microphone^2 n_filter + 1, n_touch), those of :meth:`products`.
            weights: of the hypotheses, as :func:`_weights`.

        Returns:
            (n_point, n_point, n_touch), the first point the touched one, the second the hypothesis.
        """
        # one product per power and point: small ones are faster than their sum
        score = np.matmul(weights, observed[:, None], out=self._scores[: len(observed)])
        return np.asarray(score.max(axis=1))


def _pairs(microphones: int) -> list[tuple[int, int]]:
    """Pairs a, b of microphones: a = b for a power, a < b for a real part, a > b for an imaginary one."""
    return [(a, b) for a in range(microphones) for b in range(microphones)]


def _weights(covariance: ComplexArray, noise: Array) -> Array:
    """Weights of the products in N^-1 - (N + g C)^-1 for all g, and at last -log det (I + g C / N) over the filters.

    Args:
        covariance: C, (n_point, n_microphone, n_microphone, n_filter).
        noise: N, mean square behind each filter, (n_filter,).

    Returns:
        (n_power, n_point, n_microphone^2 n_filter + 1).
    """
    points, microphones, _, filters = covariance.shape
    gain = POWERS[:, None, None]
    # of the Hermitian matrix what is on the diagonal and above; (power, point, filter) each, in real numbers
    real: dict[tuple[int, int], Array] = {}
    imaginary: dict[tuple[int, int], Array] = {}
    for a, b in _pairs(microphones):
        if a <= b:
            real[a, b] = gain * (covariance[:, a, b].real / noise)
        if a < b:
            imaginary[a, b] = gain * (covariance[:, a, b].imag / noise)
        if a == b:
            real[a, a] += 1
    # The sweep operator (Goodnight, The American Statistician 33 (1979) 149) leaves the negative inverse.
    determinant = np.ones(())
    for k in range(microphones):
        determinant, inverse = determinant * real[k, k], 1 / real[k, k]
        column = {a: (real[a, k], imaginary[a, k]) if a < k else (real[k, a], -imaginary[k, a])
                  for a in range(microphones) if a != k}  # fmt: skip
        swept = {a: (one * inverse, other * inverse) for a, (one, other) in column.items()}
        for a, (one, other) in column.items():
            for b, (swept_one, swept_other) in swept.items():
                if a <= b:
                    real[a, b] -= one * swept_one + other * swept_other
                if a < b:
                    imaginary[a, b] -= other * swept_one - one * swept_other
        for a, (swept_one, swept_other) in swept.items():
            real[min(a, k), max(a, k)] = swept_one
            imaginary[min(a, k), max(a, k)] = swept_other if a < k else -swept_other
        real[k, k] = -inverse
    weights = np.empty((len(POWERS), points, microphones**2 * filters + 1))
    once, twice = 1 / noise, 2 / noise
    for number, (a, b) in enumerate(_pairs(microphones)):
        own = weights[:, :, number * filters : (number + 1) * filters]
        if a == b:
            np.multiply(1 + real[a, a], once, out=own)
        else:  # conj(x_a) S_ab x_b and its mirror image: twice the real part
            np.multiply(real[a, b] if a < b else imaginary[b, a], twice if a < b else -twice, out=own)
    np.negative(np.log(determinant).sum(axis=-1), out=weights[:, :, -1])
    return weights


def _count(score: Array, first: int, named: Array, wrong: Array) -> None:
    """Numbers of touches named, and of those for which the wrong one of two is the likelier; a tie counts half.

    Args:
        score: (n, n_point, n_touch) of touches of points ``first`` and on.
        first: the first of them.
        named: (n, n_point), written.
        wrong: (n, n_point), written.
    """
    count = _true(score == score.max(axis=1, keepdims=True))
    if count.sum() != len(score) * score.shape[2]:  # of equal ones the first is named
        count = _true(score.argmax(axis=1)[:, None] == np.arange(score.shape[1])[:, None])
    named[:] = count
    rows = np.arange(len(score))
    own = score[rows, first + rows][:, None]
    np.add(_true(score > own), _true(score >= own), out=wrong)
    wrong *= 0.5
    wrong[rows, first + rows] = 0


def _true(values: NDArray[np.bool_]) -> NDArray[np.int64]:
    """How many of the last axis are true."""
    return np.asarray(np.bitwise_count(np.packbits(values, axis=-1)).sum(axis=-1, dtype=np.int64))


def _check(h: ComplexArray, grid: Array, touches: int) -> None:
    if h.ndim != 4 or h.shape[3] != len(grid) or not len(h):
        raise shape_error("transfer_function", h, f"(n_design, n_point, n_microphone, {len(grid)})")
    for name, count in (("point", h.shape[1]), ("microphone", h.shape[2])):
        if count < 2:
            problem = f"has {counted(count, name)}; at least 2 are needed to predict confusions"
            raise Refusal(problem, kind=Kind.UNSUITABLE, field="transfer_function")
    check_grid(grid)
    if not np.all(np.isfinite(h)):
        raise Refusal(kind=Kind.UNSUITABLE, field="transfer_function", allowed="finite")
    check_range("touches", touches, 1, 100_000, whole=True)


def check_grid(grid: Array) -> None:
    """Refuse frequencies from which no confusion can be predicted.

    Args:
        grid: (n_freq,) float64, Hz.

    Raises:
        Refusal: fewer than 4 ascending values, or less than 1 to 100 Hz.
    """
    if len(grid) < 4 or grid[0] <= 0 or np.any(np.diff(grid) <= 0):
        raise Refusal("must hold at least 4 ascending values above 0 Hz", kind=Kind.UNSUITABLE, field="frequency")
    if grid[0] > BAND[0] + 1e-6 or grid[-1] < BAND[1] - 1e-6:
        raise Refusal(
            f"runs from {grid[0]:g} to {grid[-1]:g} Hz; predicting confusions needs {BAND[0]:g} to {BAND[1]:g} Hz, the "
            "band of the touches",
            kind=Kind.UNSUITABLE,
            field="frequency",
        )
