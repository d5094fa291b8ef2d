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

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geometry.refusal import Refusal
from studies.metrics.filtered_touches import BAND, Listener, ear_of, noise_of_filters, standard_noise

if TYPE_CHECKING:
    from localize.signals.noise import NoiseSpectrum

POWERS = 10.0 ** np.arange(-4.0, 2.1)
"""Values of g that are tried."""
_MEMORY = 4_000_000
"""Bytes of simulated frames and what they score at once: what the processor keeps near."""

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
    return predict_confusions(
        transfer_function, frequency, [noise], listener=listener, assumed=assumed, touches=touches, seed=seed
    )[0]


def predict_confusions(
    transfer_function: ArrayLike,
    frequency: ArrayLike,
    noises: Sequence[float | NoiseSpectrum | ArrayLike],
    *,
    listener: Listener = "network",
    assumed: ArrayLike | None = None,
    touches: int = 64,
    seed: int = 0,
) -> tuple[PredictedConfusion, ...]:
    """Confusions under several noises, of the same touches, which are simulated once; arguments and errors as
    :func:`predict_confusion`.
    """
    h, grid = np.asarray(transfer_function, np.complex128), np.asarray(frequency, np.float64)
    _check(h, grid, touches)
    designs, points, microphones, _ = h.shape
    powers = [noise_of_filters(noise, designs, listener) for noise in noises]
    ear = ear_of(grid.tobytes(), listener, touches, seed)
    standard = standard_noise(points, microphones, listener, touches, seed)
    if assumed is None:
        hypotheses = ear.covariance(h)[None]
    else:
        known = np.asarray(assumed, np.complex128)
        if known.ndim != 4 or known.shape[1:] != h.shape[1:] or not len(known) or not np.all(np.isfinite(known)):
            raise Refusal(
                f"assumed has shape {known.shape}; it must be (n, {', '.join(map(str, h.shape[1:]))}), all finite"
            )
        hypotheses = ear.covariance(known)[:, None]
    shape = designs, points, points
    found = [PredictedConfusion(np.zeros(shape), np.zeros(shape), touches) for _ in powers]
    numbers, matrix = ear.factors(h)
    room = _Room(points, microphones, ear.shape, designs)
    for first in range(0, designs, room.step):
        part = slice(first, first + room.step)
        frames = room.frames[: len(numbers[part])]
        rows = frames.reshape(-1, matrix.shape[1])
        np.matmul(numbers[part].reshape(len(rows), -1), matrix, out=rows)
        assumptions = [one[part if len(one) > 1 else slice(None)] for one in hypotheses]
        for result, power in zip(found, powers, strict=True):
            own = power[part if len(power) > 1 else slice(None)]
            observed = room.products(frames, 1 / np.sqrt(own), standard)
            scores = [room.scores(observed, one / own[:, None, None, None]) for one in assumptions]
            result.confusion[part], result.pairwise[part] = _counted(reduce(np.logaddexp, scores))
    return tuple(found)


class _Room:
    """Arrays of a few designs at a time that are written over and over: fresh memory would cost more than the sums."""

    def __init__(self, points: int, microphones: int, shape: Sequence[int], designs: int) -> None:
        _, filters, touches = shape
        size = 8 * points * touches * (microphones * (4 + microphones) * filters + points * len(POWERS))
        #: how many designs at a time
        self.step = min(max(1, _MEMORY // size), designs)
        self.frames = np.empty((self.step, points, microphones, 2, filters, touches))
        self._signal = np.empty_like(self.frames)
        self._products = np.empty((self.step, points, microphones**2, filters, touches))
        self._other = np.empty((self.step, points, filters, touches))
        self._scores = np.empty((self.step, points, len(POWERS), points, touches))

    def products(self, frames: Array, scale: Array, noise: Array) -> Array:
        """What likelihoods are linear in: products of the microphones' signals, |x_a|^2 and parts of conj(x_a) x_b.

        Args:
            frames: (n_design, n_point, n_microphone, 2, n_filter, n_touch).
            scale: of each filter, (n_design, n_filter) or (1, n_filter).
            noise: what is added to scaled frames, shaped as those of one design.

        Returns:
            (n_design, n_point, n_microphone^2 n_filter, n_touch), in the order of :func:`_pairs`.
        """
        count, points, microphones, _, _, touches = frames.shape
        signal, products, other = (each[:count] for each in (self._signal, self._products, self._other))
        np.multiply(frames, scale[:, None, None, None, :, None], out=signal)
        signal += noise
        real, imaginary = signal[:, :, :, 0], signal[:, :, :, 1]
        for number, (a, b) in enumerate(_pairs(microphones)):
            own = products[:, :, number]
            if a <= b:
                np.multiply(real[:, :, a], real[:, :, b], out=own)
                own += np.multiply(imaginary[:, :, a], imaginary[:, :, b], out=other)
            else:  # the imaginary part of the pair b, a
                np.multiply(real[:, :, b], imaginary[:, :, a], out=own)
                own -= np.multiply(imaginary[:, :, b], real[:, :, a], out=other)
        return products.reshape(count, points, -1, touches)

    def scores(self, observed: Array, covariance: Complex) -> Array:
        """Log-likelihoods up to a constant per touch, maximised over g; noise of variance 1.

        Args:
            observed: (n_design, n_point, n_microphone^2 n_filter, n_touch), those of :meth:`products`.
            covariance: (n_design, n_point, n_microphone, n_microphone, n_filter).

        Returns:
            (n_design, n_point, n_point, n_touch), the first point the touched one, the second the hypothesis.
        """
        weights, cost = _weights(covariance)
        # one product per power and point: small ones are faster than their sum
        score = np.matmul(weights[:, None], observed[:, :, None], out=self._scores[: len(observed)])
        score -= cost[:, None, :, :, None]
        return np.asarray(score.max(axis=2))


def _pairs(microphones: int) -> list[tuple[int, int]]:
    """Pairs a, b of microphones: a = b for a power, a < b for a real part, a > b for an imaginary one."""
    return [(a, b) for a in range(microphones) for b in range(microphones)]


def _weights(covariance: Complex) -> tuple[Array, Array]:
    """Weights of the products in I - (I + g C)^-1 for all g, and log det (I + g C) summed over the filters.

    Args:
        covariance: C, (n_design, n_point, n_microphone, n_microphone, n_filter).

    Returns:
        (n_design, n_power, n_point, n_microphone^2 n_filter) and (n_design, n_power, n_point).
    """
    designs, points, microphones, _, filters = covariance.shape
    gain = POWERS[:, None, None]
    # Of the Hermitian matrix what is on the diagonal and above; (design, power, point, filter) each.
    entry: dict[tuple[int, int], Complex | Array] = {}
    for a, b in _pairs(microphones):
        if a == b:
            entry[a, a] = 1 + gain * covariance[:, None, :, a, a].real
        elif a < b:
            entry[a, b] = gain * covariance[:, None, :, a, b]
    # The sweep operator (Goodnight, The American Statistician 33 (1979) 149) leaves the negative inverse.
    determinant: Array = np.ones(())
    for k in range(microphones):
        pivot = entry[k, k].real
        determinant, inverse = np.asarray(determinant * pivot), 1 / pivot
        column = {a: entry[a, k] if a < k else entry[k, a].conj() for a in range(microphones) if a != k}
        for a, own in column.items():
            entry[a, a] = entry[a, a] - (own.real**2 + own.imag**2) * inverse
            for b, other in column.items():
                if a < b:
                    entry[a, b] = entry[a, b] - own * other.conj() * inverse
        for a in column:
            entry[min(a, k), max(a, k)] = entry[min(a, k), max(a, k)] * inverse
        entry[k, k] = -inverse
    weights = np.empty((designs, len(POWERS), points, microphones**2, filters))
    for number, (a, b) in enumerate(_pairs(microphones)):
        if a == b:
            weights[:, :, :, number] = 1 + entry[a, a]
        else:  # conj(x_a) S_ab x_b and its mirror image: twice the real part
            weights[:, :, :, number] = 2 * entry[a, b].real if a < b else -2 * entry[b, a].imag
    return weights.reshape(designs, len(POWERS), points, -1), np.log(determinant).sum(axis=-1)


def _counted(score: Array) -> tuple[Array, Array]:
    """Shares named, and shares where the wrong one of two is the likelier; a tie counts half."""
    _, points, _, touches = score.shape
    named = score.argmax(axis=2)
    confusion = np.count_nonzero(named[:, :, None] == np.arange(points)[:, None], axis=-1) / touches
    own = np.einsum("dppn->dpn", score)[:, :, None]
    wrong = (np.count_nonzero(score > own, axis=-1) + 0.5 * np.count_nonzero(score == own, axis=-1)) / touches
    wrong[:, np.arange(points), np.arange(points)] = 0.0
    return confusion, (wrong + wrong.swapaxes(1, 2)) / 2


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
