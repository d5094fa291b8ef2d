"""The tolerance-aware decoder in frequency bins: a few thousand frames of a design decided in a fraction of a second.

:class:`localize.TolerantDecoder` decides from the samples of a frame. Here a frame is a vector x_k of the microphones
in each of 25 bins, taken as independent of each other (Whittle's approximation). All else follows the decoder:
hypotheses of each point from drawn sensors, likelihoods of a source of flat spectrum and unknown power, the best
hypotheses fitted with shapes in which the logarithms of their transfer functions deviate, and the same assumed noise,
hum and temperature (:class:`localize.decoders.decoder_options.TolerantOptions`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array, ComplexArray
from localize.decoders.decoder_options import DecoderOptions, TolerantOptions
from localize.signals.frames import FRAME
from studies.metrics.touch_bins import hum_in_bins

UNEXPLAINED = 0.005
"""Fraction of a frame's power that the source need not explain. The decoder has 0.02 and estimates the source a second
time. In bins it is estimated once, and 0.005 comes nearer to that on designs 1000 to 1039 of the benchmark."""
_POWERS = 10 ** (np.arange(-20.0, 201.0, 4.0) / 10)
"""Powers of a touch over the assumed noise that are tried, by a mean over the bins."""
_BLOCK = 4096
"""Number of fits that are solved at once: what the processor keeps near."""
_VALUES = 200_000
"""Number of products of microphones that are weighed at once."""


@dataclass(frozen=True)
class BinnedOptions:
    """Numbers that set how finely the decoder is followed."""

    draws: int = 192
    """Number of sensors that hypotheses are made of; the decoder has 1200."""
    splits: int = 3
    """Number of times that the draws of a point are halved: 8 groups, where the decoder has up to 12."""
    shapes: int = 6
    """Number of shapes in which a hypothesis deviates."""
    candidates: int = 10
    """Number of hypotheses that are fitted to a frame."""


@dataclass(frozen=True, eq=False)
class BinnedHypotheses:
    """Transfer functions that the points of a sensor may have, in bins."""

    response: ComplexArray
    """(n_point, n_hypothesis, n_microphone, n_bin), Pa/Pa."""
    shapes: ComplexArray
    """Deviations of their logarithms by a standard normal amplitude; (n_point, n_hypothesis, n_shape, n_microphone,
    n_bin)."""
    log_prior: Array
    """Logarithm of the prior of each hypothesis of a point; (n_hypothesis,)."""


def binned_hypotheses(
    nominal: ComplexArray, factors: ComplexArray, loudness: Array, to_bins: Array, options: BinnedOptions
) -> BinnedHypotheses:
    """Hypotheses from drawn sensors, the sensor as designed the last one.

    Args:
        nominal: transfer functions of the design, (n_point, n_microphone, n_bin).
        factors: logarithms of the factors of drawn sensors, (n_draw, n_point, n_microphone, n_node), n_draw a multiple
            of 2 ** splits.
        loudness: absolute transfer functions of the design at the nodes, (n_point, n_microphone, n_node).
        to_bins: matrix from nodes to bins, (n_node, n_bin).
        options: how finely.
    """
    tolerant = TolerantOptions().hypotheses
    draws, points = len(factors), len(nominal)
    rows = np.arange(points)
    loudest = loudness.sum(2).argmax(1)
    weight = (1 / np.hypot(1, tolerant.quiet_ratio / loudness)).astype(np.float32)
    factors = factors.swapaxes(0, 1)  # (point, draw, microphone, node)
    ratio = factors - factors[rows, :, loudest][:, :, None]
    weighed = (ratio * weight[:, None]).reshape(points, draws, -1)
    features = np.concatenate([weighed.real, weighed.imag], axis=2)
    groups = _halved(features, options.splits)  # (point, group, draw)
    flat, alike = ratio.reshape(points, draws, -1), factors.reshape(points, draws, -1)
    at = rows[:, None, None], groups
    changes = alike[at].mean(2)
    shapes = _shapes(features[at], flat[at], options.shapes)
    whole = _shapes(features[:, None], flat[:, None], options.shapes)
    size = nominal.shape[1:2] + factors.shape[3:]
    changes = np.concatenate([changes, np.zeros_like(changes[:, :1])], 1).reshape(points, -1, *size)
    shapes = np.concatenate([shapes, whole], 1).reshape(points, changes.shape[1], options.shapes, *size)
    prior = np.full(changes.shape[1], (1 - tolerant.prior_as_designed) / groups.shape[1])
    prior[-1] = tolerant.prior_as_designed
    return BinnedHypotheses(nominal[:, None] * np.exp(changes @ to_bins), shapes @ to_bins, np.log(prior))


def scores(
    frames: ComplexArray, gain: Array, hypotheses: BinnedHypotheses, noise: Array, options: BinnedOptions
) -> Array:
    """Log-likelihoods of the points.

    Args:
        frames: (n, n_microphone, n_bin), Pa.
        gain: expected signal of each over the assumed noise, as :func:`expected_gain` has it; (n, n_bin).
        hypotheses: of the points.
        noise: mean square of the noise in each bin, (n_bin,), Pa^2.
        options: how finely.

    Returns:
        (n, n_point) float64, nats, up to a constant per frame.
    """
    tolerant = TolerantOptions()
    points, each = hypotheses.response.shape[:2]
    assumed = assumed_noise(noise, tolerant)
    white = frames / np.sqrt(assumed)
    believed = _attenuation(white, tolerant)
    white, gain = white * np.sqrt(believed)[:, None, None], gain * believed[:, None]
    response = (hypotheses.response / np.sqrt(assumed)).reshape(-1, *frames.shape[1:])
    temperature = tolerant.temperature * tolerant.relative_temperature
    score = _plain(white, response, gain, temperature)
    order = np.argpartition(-score, min(options.candidates, score.shape[1] - 1), axis=1)[:, : options.candidates]
    shapes = hypotheses.shapes.reshape(len(response), options.shapes, *frames.shape[1:])
    unexplained = 1 + UNEXPLAINED * (white.real**2 + white.imag**2).mean((1, 2))
    raised = _fitted(white, response, shapes, order, gain / (unexplained[:, None] + gain), temperature)
    fitted = np.take_along_axis(score, order, 1) + raised
    # The others can be no better than the worst of these.
    score = np.minimum(score, fitted.min(1, keepdims=True))
    np.put_along_axis(score, order, fitted, axis=1)
    joint = score.reshape(-1, points, each) + hypotheses.log_prior
    top = joint.max(2, keepdims=True)
    return np.asarray(top[..., 0] + np.log(np.exp(joint - top).sum(2)))


def _attenuation(white: ComplexArray, options: TolerantOptions) -> Array:
    """Factors on the power of frames that bring those louder than the decoder believes to that level, (n,)."""
    # A bin is two of the real values of a microphone that the decoder takes the mean of.
    values = white.shape[1] * FRAME / 2
    level = (white.real**2 + white.imag**2).sum((1, 2)) / values / options.temperature
    return np.minimum(1.0, 10 ** (options.believed_level / 10) / np.maximum(level, 1e-30))


def plain_scores(frames: ComplexArray, gain: Array, response: ComplexArray, noise: Array) -> Array:
    """Log-likelihoods of the points of a calibrated sensor, arguments as of :func:`scores`.

    The response is (n_point, n_microphone, n_bin), Pa/Pa.

    Returns:
        (n, n_point) float64, nats.
    """
    options = DecoderOptions()
    root = np.sqrt(assumed_noise(noise, options))
    white, known = frames / root, response / root
    return _plain(white, known, gain, options.temperature)


def expected_gain(frames: ComplexArray, response: ComplexArray, noise: Array) -> Array:
    """Expected signal of frames over the assumed noise, for a source of flat spectrum of the likeliest power.

    The source is at the point that was touched: which frequencies count is the same for all hypotheses, so that points
    are distinguished by ratios of microphones alone and not by the spectrum of the touch.

    Args:
        frames: one of each point, (..., n_point, n_microphone, n_bin), Pa.
        response: transfer functions of the design, (n_point, n_microphone, n_bin).
        noise: mean square of the noise in each bin, (n_bin,), Pa^2.

    Returns:
        (..., n_point, n_bin) float64, ratios of powers.
    """
    assumed = assumed_noise(noise, TolerantOptions())
    energy = (frames.real**2 + frames.imag**2).sum(-2) / assumed
    size = (response.real**2 + response.imag**2).sum(1) / assumed
    shape = size / size.mean(1, keepdims=True)
    gain = shape[..., None] * _POWERS
    likelihood = energy[..., None, :] @ (gain / (1 + gain)) - np.log1p(gain).sum(1)[:, None]
    return np.asarray(_POWERS[likelihood[..., 0, :].argmax(-1)][..., None] * shape)


def assumed_noise(noise: Array, options: DecoderOptions) -> Array:
    """Noise and hum in each bin that a decoder assumes, (n_bin,), Pa^2, from the noise that there is."""
    return np.asarray(noise * options.noise_fraction**2 + hum_in_bins())


def _halved(features: Array, splits: int) -> NDArray[np.int64]:
    """Groups of equally many draws, (n_point, 2 ** splits, n): each is halved along its own largest deviation."""
    points, draws, _ = features.shape
    groups = np.broadcast_to(np.arange(draws), (points, 1, draws))
    rows = np.arange(points)[:, None, None]
    for _ in range(splits):
        own = features[rows, groups]
        own = own - own.mean(2, keepdims=True)
        along = own[..., :1, :] - own[..., -1:, :] + 1e-12
        for _ in range(6):
            along = (own @ along.swapaxes(2, 3)).swapaxes(2, 3) @ own
            along /= np.linalg.norm(along, axis=3, keepdims=True) + 1e-30
        order = np.argsort((own @ along.swapaxes(2, 3))[..., 0], axis=2)
        groups = np.take_along_axis(groups, order, 2).reshape(points, -1, groups.shape[2] // 2)
    return np.asarray(groups)


def _shapes(features: Array, ratio: ComplexArray, count: int) -> ComplexArray:
    """Principal components of how the draws of groups deviate from their mean.

    Args:
        features: weighed, (n_point, n_group, n_draw, n_feature) float32.
        ratio: logarithms of the ratios to the loudest microphone, (n_point, n_group, n_draw, n_value).
        count: how many.

    Returns:
        (n_point, n_group, count, n_value) complex64, those beyond the number of draws zero.
    """
    features = features - features.mean(2, keepdims=True)
    ratio = ratio - ratio.mean(2, keepdims=True)
    draws = features.shape[2]
    is_few = draws < features.shape[3]
    turned = features.swapaxes(2, 3)
    power, vectors = np.linalg.eigh((features @ turned if is_few else turned @ features).astype(np.float64))
    kept = min(count, power.shape[2] - 1)
    power, vectors = power[..., -kept:], vectors[..., -kept:]
    found = power > 1e-9 * power[..., -1:]
    if not is_few:
        vectors = features @ (vectors / np.sqrt(np.where(found, power, 1.0))[..., None, :])
    amplitude = (vectors * found[..., None, :]).swapaxes(2, 3).astype(np.float32)
    shapes = np.zeros((*ratio.shape[:2], count, ratio.shape[3]), np.complex64)
    shapes[:, :, :kept] = amplitude @ ratio / np.sqrt(draws)
    return shapes


def _plain(white: ComplexArray, response: ComplexArray, gain: Array, temperature: float) -> Array:
    """Scores of hypotheses without deviations, (n, n_hypothesis) nats."""
    unit = response / np.linalg.norm(response, axis=1, keepdims=True)
    towards = _weights(unit).reshape(len(unit), -1).T / temperature
    weight = gain / (1 + gain)
    score = np.empty((len(white), len(unit)))
    step = max(1, _VALUES // len(towards))
    for first in range(0, len(white), step):
        own = slice(first, first + step)
        products = _products(white[own]) * weight[own, None]
        np.matmul(products.reshape(len(products), -1), towards, out=score[own])
    return score


def _products(white: ComplexArray) -> Array:
    """Products of the microphones of each bin: squares, then parts of pairs; (n, n_product, n_bin) float64."""
    first, second = np.triu_indices(white.shape[1], 1)
    pairs = white[:, first] * white[:, second].conj()
    return np.concatenate([white.real**2 + white.imag**2, pairs.real, pairs.imag], 1)


def _weights(unit: ComplexArray) -> Array:
    """Weights of these products in the energy along unit vectors, (n_hypothesis, n_product, n_bin) float64."""
    first, second = np.triu_indices(unit.shape[1], 1)
    pairs = 2 * unit[:, first].conj() * unit[:, second]
    return np.concatenate([unit.real**2 + unit.imag**2, pairs.real, -pairs.imag], 1)


def _fitted(
    white: ComplexArray,
    response: ComplexArray,
    shapes: ComplexArray,
    order: NDArray[np.int64],
    weight: Array,
    temperature: float,
) -> Array:
    """Gains of scores by the deviations of hypotheses.

    Args:
        white: frames, (n, n_microphone, n_bin) complex128.
        response: of the hypotheses where noise is white, (n_hypothesis, n_microphone, n_bin).
        shapes: (n_hypothesis, n_shape, n_microphone, n_bin).
        order: numbers of the hypotheses that are fitted to each frame, (n, n_candidate).
        weight: expected signal of each frame over that and all noise, (n, n_bin).
        temperature: divisor of log-likelihoods.

    Returns:
        (n, n_candidate) float64, nats.
    """
    count, (microphones, bins) = shapes.shape[1], white.shape[1:]
    size = (response.real**2 + response.imag**2).sum(1)[:, None]
    unit = response / np.sqrt(size)
    change = response[:, None] * shapes
    change -= unit[:, None] * (unit[:, None].conj() * change).sum(2, keepdims=True)
    # The first place of a pair of shapes is a row of the lower triangle.
    pairs = list(zip(*np.tril_indices(count), strict=True))
    bends = np.stack([(change[:, a].conj() * change[:, b]).real.sum(1) for a, b in pairs], 1)
    slopes = np.ascontiguousarray(change).view(np.float64).reshape(len(unit), count, -1)
    towards = unit.conj() * np.sqrt(2 / (size * temperature))
    slopes *= np.sqrt(2 / temperature)
    flat = order.ravel()
    sorted_pairs = np.argsort(flat, kind="stable")
    numbers, starts = np.unique(flat[sorted_pairs], return_index=True)
    frame_of, ends = sorted_pairs // order.shape[1], [*starts[1:], len(flat)]
    slope, bend = np.empty((count, len(flat))), np.empty((len(pairs), len(flat)))
    # fresh memory would cost more than the sums
    room = np.empty((max(np.subtract(ends, starts)), microphones, bins), complex)
    source_room, part_room = np.empty((2, len(room), bins), complex)
    weight_room = np.empty((len(room), bins))
    for number, start, end in zip(numbers, starts, ends, strict=True):
        own = frame_of[start:end]
        x, source, part, weighed = (each[: len(own)] for each in (room, source_room, part_room, weight_room))
        np.take(white, own, axis=0, out=x, mode="clip")
        np.take(weight, own, axis=0, out=weighed, mode="clip")
        np.multiply(x[:, 0], towards[number, 0], out=source)
        for microphone in range(1, microphones):
            source += np.multiply(x[:, microphone], towards[number, microphone], out=part)
        source *= weighed
        x *= np.conjugate(source, out=part)[:, None]
        np.matmul(slopes[number], x.view(np.float64).reshape(len(own), -1).T, out=slope[:, start:end])
        power = np.multiply(source.real, source.real, out=weighed)
        power += source.imag * source.imag
        np.matmul(bends[number], power.T, out=bend[:, start:end])
    found = np.empty(len(flat))
    found[sorted_pairs] = np.concatenate(
        [_gaussian_gain(slope[:, k : k + _BLOCK], bend[:, k : k + _BLOCK]) for k in range(0, len(flat), _BLOCK)]
    )
    return found.reshape(order.shape)


def _gaussian_gain(slope: Array, bend: Array) -> Array:
    """b^T (1 + F)^-1 b / 2 - log det(1 + F) / 2 of many b and F by elimination, row by row of all at once.

    Args:
        slope: b, (k, n).
        bend: lower triangle of F, (k (k + 1) / 2, n), row after row.

    Returns:
        (n,) float64.
    """
    count = len(slope)
    left, row = slope.copy(), bend.copy()
    place = np.cumsum(np.arange(count))  # of the first value of each row
    gain, determinant = np.zeros(slope.shape[1]), np.ones(slope.shape[1])
    for pivot in range(count):
        held = row[place[pivot] + pivot] + 1
        determinant *= held
        inverse = 1 / held
        gain += left[pivot] ** 2 * inverse
        below = row[place[pivot + 1 :] + pivot]
        factor = below * inverse
        left[pivot + 1 :] -= factor * left[pivot]
        for step, number in enumerate(range(pivot + 1, count)):
            row[place[number] + pivot + 1 : place[number] + number + 1] -= factor[step] * below[: step + 1]
    return 0.5 * (gain - np.log(determinant))
