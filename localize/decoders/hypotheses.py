"""Hypotheses about a sensor that nobody measured: for each point, a few transfer functions that represent the possible
ones.

Sensors are drawn with the tolerances of manufacturing. Some of them also have an air and a slope of the rubber's
modulus of their own, because hypotheses of one air and one rubber explain other ones by wrong points. Points differ in
the ratios between their microphones, so the draws of each point are put into groups by these ratios (k-means). Each
group has one hypothesis, the mean level and phase of its draws, and its fraction of the draws as prior. The sensor as
it was designed is one more hypothesis. A few shapes over frequency (principal components) describe how the draws of a
group differ from their mean, :mod:`localize.decoders.deviations`.

The hypothesis of a group is the mean of its draws, not the mean of their covariances: such a covariance has ratios that
change from one frequency to the next as those of no sensor do, and explains touches of any point.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy.linalg
from numpy.typing import NDArray
from scipy.cluster.vq import kmeans2
from scipy.interpolate import CubicSpline

from acoustic_fem import Library
from acoustic_fem.scatter.as_built_sensors import scatter_factors
from acoustic_fem.scatter.tolerances import ScatteredDesign, Tolerance
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.decoder_options import HypothesisOptions
from localize.decoders.frame_covariance import DEVIATING
from localize.signals.array_response import ArrayResponse
from localize.signals.stimulus import BAND, SAMPLE_RATE

NOTHING = 1e-12
"""Fraction of the power of the first shape below which another is one of rounding."""
_BLOCK = 300


@dataclass(frozen=True, eq=False)
class Hypotheses:
    """Transfer functions that the points of a sensor may have."""

    responses: tuple[ArrayResponse, ...]
    """Arrays that hold hypothesis k of each point; points do not share their hypotheses."""
    deviations: NDArray[np.complex64]
    """Shapes in which the logarithms of these transfer functions deviate, each by a standard normal amplitude;
    (n_hypothesis, n_shape, n_point, n_microphone, n_freq) complex64 at
    :data:`localize.decoders.frame_covariance.DEVIATING`, without those that all microphones share."""
    log_prior: Array
    """Logarithm of the prior of each hypothesis of a point; (n_point, n_hypothesis) float64."""


def as_built_hypotheses(
    library: Library, response: ArrayResponse, tolerances: Sequence[Tolerance], options: HypothesisOptions
) -> Hypotheses:
    """Hypotheses of a library's array, the sensor as it was designed the last one.

    Args:
        library: of a design.
        response: of that library, all of its microphones or some.
        tolerances: of manufacturing.
        options: numbers of the hypotheses.

    Raises:
        Refusal: a design whose scatter is not known.
    """
    top = min(float(response.frequency[-1]), SAMPLE_RATE / 2)
    nodes = np.geomspace(response.frequency[0], top, options.solved_frequencies)
    heard = [library.design.microphones.index(name) for name in response.microphones]
    level, phase = (each[:, :, heard] for each in _drawn(library, nodes, tolerances, options))
    loudness = np.abs(response.at(nodes))
    groups = max(2, min(options.groups, options.most_hypotheses // response.point_count - 1))
    curves = np.zeros((groups, 2, *loudness.shape))
    shapes = np.zeros((groups + 1, options.shapes, *loudness.shape), np.complex64)
    prior = np.zeros((response.point_count, groups + 1))
    prior[:, -1] = options.prior_as_designed
    for point in range(response.point_count):
        features = _ratios(level[:, point], phase[:, point], loudness[point], nodes, options)
        label = _grouped(features, groups, options)
        drawn = level[:, point] + 1j * phase[:, point]
        shapes[-1, :, point] = _shapes(drawn, loudness[point], nodes, options)
        for group in range(groups):
            of_group = label == group
            if of_group.any():
                curves[group, :, point] = level[of_group, point].mean(0), phase[of_group, point].mean(0)
                shapes[group, :, point] = _shapes(drawn[of_group], loudness[point], nodes, options)
            prior[point, group] = (1 - options.prior_as_designed) * of_group.mean()
    change = CubicSpline(np.log(nodes), curves, axis=-1)(np.log(np.minimum(response.frequency, top)))
    factors = np.exp(change[:, 0] + 1j * change[:, 1])
    made = tuple(replace(response, transfer_function=response.transfer_function * factor) for factor in factors)
    # A group without draws is never believed.
    deviations = CubicSpline(np.log(nodes), shapes, axis=-1)(np.log(DEVIATING)).astype(np.complex64)
    return Hypotheses((*made, response), deviations, np.log(np.maximum(prior, 1e-30)))


def bare_library() -> Refusal:
    """Refusal of bare transfer functions where a design is needed."""
    problem = "must have a design, because bare transfer functions do not describe the parts"
    return Refusal(problem, kind=Kind.UNSUITABLE, field="library")


def _drawn(
    library: Library, nodes: Array, tolerances: Sequence[Tolerance], options: HypothesisOptions
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Logarithms of the factors of drawn sensors: nepers and radians, (n_draw, n_point, n_microphone, n_node) each."""
    scattered = ScatteredDesign(library.design, tolerances)
    parts = []
    for first in range(0, options.draws, _BLOCK):
        count = min(_BLOCK, options.draws - first)
        factors = scatter_factors(
            scattered,
            library.medium,
            nodes,
            count,
            options.seed,
            first=first,
            air_and_rubber=options.air_and_rubber,
        )
        parts.append(np.stack([np.log(np.abs(factors)), np.unwrap(np.angle(factors))]).astype(np.float32))
    level, phase = np.concatenate(parts, axis=1)
    return level, phase


def _ratios(
    level: NDArray[np.float32],
    phase: NDArray[np.float32],
    loudness: Array,
    nodes: Array,
    options: HypothesisOptions,
) -> Array:
    """Features by which the draws of a point are grouped: ratios to its loudest microphone, (n_draw, n_feature).

    A microphone counts in proportion to the level of the point above its noise.
    """
    inside = np.flatnonzero((nodes >= BAND[0]) & (nodes <= BAND[1]))
    at = inside[np.linspace(0, len(inside) - 1, options.ratio_frequencies).round().astype(int)]
    loudest = int(loudness[:, at].sum(1).argmax())
    weight = _above_noise(loudness[:, at], options)
    each = (values[..., at] - values[:, loudest, None][..., at] for values in (level, phase))
    return np.concatenate([(weight * ratio).reshape(len(ratio), -1) for ratio in each], axis=1).astype(np.float64)


def _shapes(
    draws: NDArray[np.complex64], loudness: Array, nodes: Array, options: HypothesisOptions
) -> NDArray[np.complex64]:
    """Principal components of how the draws of a group deviate from their mean, by the ratio to the loudest microphone.

    Args:
        draws: logarithms of the factors, (n_draw, n_microphone, n_node).
        loudness: of the microphones, (n_microphone, n_node).
        nodes: Hz.
        options: numbers of the hypotheses.

    Returns:
        (n_shape, n_microphone, n_node), those beyond the number of draws zero.
    """
    ratio = draws - draws[:, [loudness.sum(1).argmax()]]
    ratio = ratio - ratio.mean(0)
    weight = np.where(nodes <= BAND[1], 1.0, options.weight_above_band) * _above_noise(loudness, options)
    weighed = (ratio * weight).reshape(len(ratio), -1)
    amplitude = _leading(np.concatenate([weighed.real, weighed.imag], axis=1), options.shapes) * np.sqrt(len(ratio))
    shapes = np.zeros((options.shapes, *ratio.shape[1:]), np.complex64)
    found = amplitude.T @ ratio.reshape(len(ratio), -1) / len(ratio)
    shapes[: len(found)] = found.reshape(-1, *ratio.shape[1:])
    return shapes


def _above_noise(loudness: Array, options: HypothesisOptions) -> Array:
    """Weight of transfer functions of that size, of the same shape: near 1 above the noise, 0 where nothing arrives."""
    return np.asarray(loudness / np.hypot(loudness, options.quiet_ratio))


def _leading(values: Array, most: int) -> Array:
    """Leading left singular vectors (m, k) of values (m, n), at most so many: those of what is nearly nothing left out.

    By the eigenvectors of the smaller of both products of the values with themselves: of hundreds of singular vectors,
    which a decomposition finds in ten times as long, a few are wanted.
    """
    few = len(values) < values.shape[1]
    product = values @ values.T if few else values.T @ values
    power, turn = scipy.linalg.eigh(product, subset_by_index=(max(0, len(product) - most), len(product) - 1))
    kept = power > NOTHING * power[-1]
    return np.asarray((turn if few else values @ (turn / np.sqrt(np.where(kept, power, 1.0))))[:, kept][:, ::-1])


def _grouped(features: Array, groups: int, options: HypothesisOptions) -> NDArray[np.int64]:
    """Group of each draw, (n_draw,) int64."""
    if np.ptp(features, axis=0).max() < options.least_spread:
        return np.zeros(len(features), np.int64)
    with warnings.catch_warnings():  # empty groups are expected where draws are few or alike; their prior is 0
        warnings.filterwarnings("ignore", "One of the clusters is empty", UserWarning)
        _, label = kmeans2(features, groups, iter=30, minit="++", rng=np.random.default_rng(options.seed))
    return np.asarray(label, np.int64)
