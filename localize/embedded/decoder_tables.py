"""Numbers that a decoder on a chip has of its array: those of its tables.

The likelihood is that of :mod:`localize.decoders.bayes`. With q_k the eigenvectors of the covariance of a point where
the noise is white, l_k their eigenvalues, and x the frame, it is, up to what all points share,

    -(sum_k (q_k^T x)^2 / (1 + g l_k) + sum_k log(1 + g l_k)) / 2 T,

a sum of what the point misses of the frame, of which all terms have one sign: single precision suffices, and the
directions that a point leaves empty, l_k = 0, tell most points apart before anything else is computed.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
import scipy.signal
from numpy.typing import NDArray

from acoustic_fem import Library
from geometry.ground.argument_checks import check_choice
from geometry.ground.typed import Array
from localize.decoders.decoder_options import DecoderOptions
from localize.decoders.frame_covariance import (
    CUTOFF,
    SAMPLES,
    TAPS,
    check_noise,
    joint_whitening,
    touch_covariances,
    whitening,
)
from localize.decoders.likelihood import assumed_noise
from localize.decoders.sound_test import SoundTest
from localize.embedded.reflections import BLOCK, reflections
from localize.live.stream_options import HIGH_PASS, StreamOptions
from localize.signals.array_response import ArrayResponse, response_of, warn_of_uncovered
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.stimulus import SAMPLE_RATE

Single = NDArray[np.float32]
#: Precision of the tables of a decoder in C.
Precision = Literal["float32", "int16"]
PRECISIONS: tuple[Precision, ...] = ("float32", "int16")
"""Precisions of the reflections."""


@dataclass(frozen=True, eq=False)
class EmbeddedTables:
    """Tables of one array."""

    name: str
    """Name of the design."""
    microphones: tuple[str, ...]
    """Names of the microphones, in the order of the samples."""
    precision: Precision
    """Precision of the reflections; everything else is held in single precision."""
    noise_rms: float
    """Noise of a microphone that the decoder expects, Pa rms."""
    silence: float
    """Level up to which a frame counts as silent, without a touch, Pa rms."""
    whitening: Single
    """Lower triangular matrix that makes the noise of a microphone white, as the decoder expects it, row by row;
    (n_number,) float32, 1/Pa."""
    eigenvalues: Single
    """Eigenvalues of each point, those that count; (n_point, rank) float32."""
    half_log_determinant: Single
    """Half of log det(1 + g C) over the temperature, by point and power; (n_point, n_power) float32, nats."""
    reflections: Single | NDArray[np.int16]
    """Reflections of each point, the directions that it leaves empty first, see
    :class:`localize.embedded.reflections.Reflections`; (n_point, n_number) float32 or int16."""
    couplings: Single
    """Common part of the reflections of each block, (n_point, n_coupling) float32."""
    steps: Single | None
    """Step and first number of each reflection, (n_point, 2 n_reflection) float32; None in single precision."""
    sound_whitening: Single | None
    """The same as the test of sound expects the noise, (n_number,) float32, 1/Pa; None where the
    library knows no sound."""
    beside: Single | None
    """Directions that sound does not reach, (n_direction, n) float32; None where the library knows no sound."""
    usual: float
    """Energy beside sound that noise may leave."""
    line: NDArray[np.int64]
    """Line of each point, (n_point,) int64."""
    place: NDArray[np.int64]
    """Place of each point along its line, (n_point,) int64."""

    @property
    def size(self) -> int:
        """Number of numbers of a frame where its noise is white: decimated samples of all microphones, and zeros up
        to a whole number of blocks of reflections.
        """
        return -(-len(self.microphones) * SAMPLES // BLOCK) * BLOCK

    @property
    def rank(self) -> int:
        """Number of directions of a point that touches fill."""
        return self.eigenvalues.shape[1]

    @property
    def point_count(self) -> int:
        """Number of points."""
        return len(self.eigenvalues)


def high_pass_coefficients() -> Array:
    """Coefficients of the high-pass of the streams as a state-variable filter, (4,) float64.

    Two integrators by trapezoids with g = tan(pi f / f_s) and a damping of sqrt 2: the same bilinear transform of the
    same Butterworth as in :func:`localize.live.front_end.high_pass_sections`.
    """
    g, damping = np.tan(np.pi * HIGH_PASS / SAMPLE_RATE), np.sqrt(2.0)
    first = 1 / (1 + g * (g + damping))
    return np.array([first, g * first, g * g * first, damping])


def low_pass_taps() -> Array:
    """Taps of the low-pass before the decimation, (TAPS,) float64."""
    return np.asarray(scipy.signal.firwin(TAPS, CUTOFF, fs=SAMPLE_RATE))


def embedded_tables(
    library: Library | ArrayResponse,
    precision: Precision = "float32",
    microphone_noise: NoiseChoice = "design",
) -> EmbeddedTables:
    """Tables of the decoder of an array that needs no training; it tells sound where the library has a design.

    Args:
        library: transfer functions of at least two points and two microphones.
        precision: of the reflections.
        microphone_noise: as of :class:`localize.BayesDecoder`.

    Raises:
        Refusal: an unknown precision, or as :class:`localize.BayesDecoder` and :class:`localize.SoundTest`.
    """
    check_choice("precision", precision, PRECISIONS)
    check_noise(microphone_noise)
    response = response_of(library)
    warn_of_uncovered(response)
    noise = response.noise(microphone_noise)
    options = DecoderOptions()
    rms = noise.rms if isinstance(noise, NoiseSpectrum) else noise
    whole = joint_whitening(response, assumed_noise(noise, options), None)
    triangle = np.tril_indices(SAMPLES)
    values, vectors = np.linalg.eigh(whole @ touch_covariances(response, np.eye(SAMPLES)) @ whole.T)
    filled = max(1, int((values > options.weakest_direction).sum(1).max()))
    size = -(-len(whole) // BLOCK) * BLOCK
    rank = size - (size - filled) // BLOCK * BLOCK  # blocks of reflections end where the empty directions do
    eigenvalues = np.clip(values[:, -rank:], 0, None)
    eigenvalues[:, : rank - filled] = 0.0
    determinant = np.log1p(eigenvalues[:, :, None] * options.tried_powers).sum(1) / options.temperature
    empty = _loudest_first(vectors[:, :, :-filled], values[:, -filled:], vectors[:, :, -filled:])
    vectors = _padded(np.concatenate([empty, vectors[:, :, -filled:]], axis=2), size)
    turned = [reflections(each, precision == "int16") for each in vectors]
    kind = np.int16 if precision == "int16" else np.float32
    numbers: Single | NDArray[np.int16] = np.stack([each.numbers.astype(kind) for each in turned])
    steps = [each.steps for each in turned if each.steps is not None]
    sound = None if response.ambient_response is None else SoundTest(response, microphone_noise)
    return EmbeddedTables(
        name=response.name,
        microphones=response.microphones,
        precision=precision,
        noise_rms=rms,
        silence=StreamOptions().silence_of(rms),
        whitening=whole[triangle].astype(np.float32),  # the same for every microphone
        eigenvalues=eigenvalues.astype(np.float32),
        half_log_determinant=(0.5 * determinant).astype(np.float32),
        reflections=numbers,
        couplings=np.stack([each.couplings for each in turned]),
        steps=np.stack(steps).reshape(len(steps), -1) if steps else None,
        sound_whitening=None if sound is None else whitening(noise)[triangle].astype(np.float32),
        beside=None if sound is None else sound.directions.T.astype(np.float32),
        usual=0.0 if sound is None else sound.usual(),
        line=response.line,
        place=response.place,
    )


def _padded(vectors: Array, size: int) -> Array:
    """Orthonormal columns (n_point, n, n) with further ones before them, along numbers that are always 0."""
    count, before = vectors.shape[1], size - vectors.shape[1]
    padded = np.zeros((len(vectors), size, size))
    padded[:, :count, before:] = vectors
    padded[:, count:, :before] = np.eye(before)
    return padded


def _loudest_first(empty: Array, values: Array, filled: Array) -> Array:
    """Directions that each point leaves empty, those first in which touches of the others are loudest.

    Args:
        empty: (n_point, n, n - rank), orthonormal columns.
        values: eigenvalues of each point, (n_point, rank).
        filled: their eigenvectors, (n_point, n, rank).

    Returns:
        As ``empty``, of the same spans.
    """
    share = np.clip(values, 0, None) / values.sum(1, keepdims=True)
    mean = np.einsum("pik,pk,pjk->ij", filled, share, filled, optimize=True)
    turned = [each @ np.linalg.eigh(each.T @ mean @ each)[1][:, ::-1] for each in empty]
    return np.stack(turned)
