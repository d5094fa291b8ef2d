"""Touches that the decoder as C is compared on, and what Python decides of them."""

from __future__ import annotations

import functools
import warnings
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import geometry
import localize
from acoustic_fem import Library
from acoustic_fem.scatter import ScatteredDesign, scatter_factors
from localize.live.events import Decision
from localize.live.stream_options import HIGH_PASS
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.stimulus_kinds import STIMULI

LIMIT = 0.5
"""Pressure from which on microphones are clipped, Pa: some of the touches reach it."""

#: In the order of ``touch_state``.
STATES = ("no touch", "fading", "sound", "touch", "unreadable")


@dataclass(frozen=True, eq=False)
class Decided:
    """Decisions on a stretch of samples."""

    sample: NDArray[np.int64]
    """Samples up to the end of the frame, (n,)."""
    state: tuple[str, ...]
    level: NDArray[np.float64]
    """Pa rms, (n,)."""
    point: NDArray[np.int64]
    """From 1; 0 where none is touched; (n,)."""
    posterior: NDArray[np.float64]
    """Probabilities, (n, n_point); NaN where no point is touched."""


def decided_in_python(array: Library | ArrayResponse, samples: NDArray[np.float32]) -> Decided:
    """Decisions of the stream with the decoder and the sound test about them, in its own chunks."""
    response = response_of(array)
    stream = localize.TouchStream(
        localize.BayesDecoder(response, "design"),
        limit=LIMIT,
        options=localize.StreamOptions(HIGH_PASS, follow=False, fade=True),
        sound_test=localize.SoundTest(response, "design"),
    )
    events = [event for k in range(0, samples.shape[1], 4000) for event in stream.push(samples[:, k : k + 4000])]
    decisions = [event for event in events if isinstance(event, Decision)]
    unknown = np.full(response.point_count, np.nan)
    return Decided(
        np.array([round(1000 * each.time) for each in decisions]),
        tuple(each.state for each in decisions),
        np.array([each.level for each in decisions]),
        np.array([each.point or 0 for each in decisions]),
        np.array([unknown if each.distribution is None else each.distribution for each in decisions]),
    )


def calibrated(library: Library, seed: int = 11) -> ArrayResponse:
    """The array of a sensor that came out otherwise than it was designed, as a calibration would know it: no two of its
    lines are alike, nor its ends.
    """
    response = response_of(library)
    factors = scatter_factors(ScatteredDesign(library.design), library.medium, response.frequency, 1, seed)[0]
    return replace(response, transfer_function=response.transfer_function * factors)


@functools.cache
def array_of(name: str, is_calibrated: bool) -> ArrayResponse:
    """Responses of a prototype as designed, or of an as-built sensor as calibrated without error; lumped."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "entrance loss", UserWarning)
        library = acoustic_fem.solve(geometry.prototype(name), np.arange(1.0, 501.0), "lumped")
        return calibrated(library) if is_calibrated else response_of(library)


@functools.cache
def decided_of(
    name: str, is_calibrated: bool, takes: int, apart: bool = True, seed: int = 3
) -> tuple[NDArray[np.float32], Decided]:
    """So many touches of each kind of such an array, and what Python decides of them."""
    response = array_of(name, is_calibrated)
    samples = touches(response, seed, takes, apart)
    return samples, decided_in_python(response, samples)


def in_the_wake(samples: NDArray[np.float32], decided: Decided) -> NDArray[np.bool_]:
    """Decisions before which a microphone was clipped since the last gap: what is left of that in the high-pass is
    explained by no point.
    """
    count = np.arange(samples.shape[1])
    gap = np.maximum.accumulate(np.where(np.isnan(samples).any(0), count, -1))
    clipped = np.maximum.accumulate(np.where((np.abs(samples) >= LIMIT).any(0), count, -1))
    return np.asarray((clipped > gap)[decided.sample - 1])


def touches(response: ArrayResponse, seed: int, takes: int, apart: bool = True) -> NDArray[np.float32]:
    """Signals of taps and multi-sine touches of a second one after the other, some clipped, some as quiet as noise.

    Args:
        response: of the array that is touched.
        seed: of the touches.
        takes: of each kind.
        apart: True if samples are lost between them, so that no frame contains two.

    Returns:
        (n_microphone, n) float32, Pa.
    """
    made = []
    for kind in ("taps", "multi-sines"):
        generator = localize.TouchGenerator(response, seed, "evaluation", "design", stimuli=STIMULI[kind])
        made.append(generator.samples(0, takes).signals.double().numpy())
    one_by_one = [each for pair in zip(*made, strict=True) for each in pair]
    loudness = np.resize([1.0, 2.0, 0.03, 1.0, 0.003, 1.0, 0.3, 3.0], len(one_by_one))
    parts, random, noise = [], np.random.default_rng(seed), localize.BayesDecoder(response, "design").noise_rms
    for number, (signal, factor) in enumerate(zip(one_by_one, loudness, strict=True)):
        # A quiet touch is not heard with less noise.
        hiss = noise * random.standard_normal(signal.shape) if factor < 1 else 0.0
        parts.append(np.clip(factor * signal + hiss, -LIMIT, LIMIT))
        if apart or number % 8 == 7:
            parts.append(np.full((len(signal), 3), np.nan))
            # Behind a gap a touch is only located if the frame that holds it begins in quiet.
            parts.append(noise * random.standard_normal((len(signal), 300)))
    return np.concatenate(parts, axis=1).astype(np.float32)
