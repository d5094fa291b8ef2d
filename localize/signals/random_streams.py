"""Random numbers of which every sample owns a fixed block, so that any sample can be made again alone.

Sample ``i`` of a stream owns a fixed block of one counter-based Philox sequence (Salmon et al. 2011, "Parallel random
numbers: as easy as 1, 2, 3"), whose key is a ``numpy.random.SeedSequence`` child of (seed, purpose, kind). Samples are
therefore independent, a block of consecutive ones is drawn in one call, and none depends on what was drawn before.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Literal, get_args

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import torch
    from torch import Tensor

#: What a stream of random numbers is for; no two share any.
Purpose = Literal["training", "held-out", "evaluation"]
PURPOSES: tuple[Purpose, ...] = get_args(Purpose)
"""All purposes; streams of different ones never share a number."""
# Their numbers are part of the keys: new ones come last.
StreamKind = Literal[
    "stimulus",
    "microphone",
    "ambient",
    "mismatch",
    "taps",
    "friction",
    "pulse wave",
    "recording",
    "mixture",
    "recorded frame",
    "finger",
    "stylus",
    "feather",
    "brush",
    "rolling ball",
    "insect",
    "falling grain",
    "air puff",
    "tap",
    "double tap",
    "press",
    "slide",
    "pulse",
    "stroke",
    "roughness",
    "recorded order",
    "presses",
    "slides",
    "tap strokes",
    "press strokes",
    "slide strokes",
    "high-pass",
]
_KINDS: tuple[StreamKind, ...] = get_args(StreamKind)


#: Words that are made into numbers together.
_TOGETHER = 2**14
_LEAST, _MOST = np.float32(2.0**-26), np.float32(1 - 2.0**-24)


def random_words(
    seed: int, purpose: Purpose, kind: StreamKind, start: int, count: int, words: int
) -> NDArray[np.uint64]:
    """Random words of consecutive samples; sample i always gets the same ones.

    Args:
        seed: any non-negative integer.
        purpose: streams of different purposes never share a number, whatever the seed.
        kind: what the numbers are for; the same holds for kinds.
        start: index of the first sample.
        count: how many samples.
        words: per sample.

    Returns:
        (count, words) uint64.
    """
    child = np.random.SeedSequence(seed, spawn_key=(PURPOSES.index(purpose), _KINDS.index(kind)))
    philox = np.random.Philox(child)
    # Philox makes four words per count of its counter, so every sample starts at a multiple of four.
    padded = -(-words // 4) * 4
    philox.advance(start * (padded // 4))
    return philox.random_raw(count * padded).reshape(count, padded)[:, :words]


def uniform(words: NDArray[np.uint64], device: torch.device | str = "cpu") -> Tensor:
    """Two numbers in (0, 1) from each word.

    Args:
        words: (n, n_word) uint64, or any other shape.
        device: where the result shall be.

    Returns:
        (..., 2) float32.
    """
    import torch

    halves = torch.from_numpy(np.ascontiguousarray(words).view(np.int32).reshape(*words.shape, 2)).to(device)
    # The ends are kept out: zero has no logarithm, and one would be a choice beyond the last.
    return halves.to(torch.float32).mul_(2.0**-32).add_(0.5).clamp_(float(_LEAST), float(_MOST))


def complex_normal(words: NDArray[np.uint64], device: torch.device | str = "cpu") -> Tensor:
    """A complex number from each word, real and imaginary part normal with variance 1 (Box and Muller 1958).

    Args:
        words: (n, n_word) uint64, or any other shape.
        device: where the result shall be.

    Returns:
        Same shape as the words, complex64, the same on all devices.
    """
    import torch

    numbers = np.empty(words.shape, np.complex64)
    fill_normal(words.reshape(-1, words.shape[-1]), numbers.reshape(-1, words.shape[-1]))
    return torch.from_numpy(numbers).to(device)


def fill_normal(words: NDArray[np.uint64], numbers: NDArray[np.complex64]) -> None:
    """Fill an array with the numbers of :func:`complex_normal`.

    Args:
        words: (n, n_word) uint64, the words of a row side by side in memory.
        numbers: (n, n_word) complex64, filled; its rows too lie side by side.
    """
    parts = numbers.view(np.float32)
    # By NumPy, whose functions take a third of the time of torch's; as many at once as stay in the processor's cache.
    several = max(1, _TOGETHER // words.shape[1])
    for first in range(0, len(words), several):
        made, halves = parts[first : first + several], words[first : first + several].view(np.int32)
        radius, angle = halves[:, ::2].astype(np.float32), halves[:, 1::2].astype(np.float32)
        radius *= np.float32(2.0**-32)
        radius += np.float32(0.5)
        np.log(np.maximum(radius, _LEAST, out=radius), out=radius)
        radius *= np.float32(-2)
        np.sqrt(radius, out=radius)
        angle *= np.float32(2 * math.pi * 2.0**-32)  # from -pi to pi, which is half a turn off
        np.multiply(np.cos(angle), np.negative(radius, out=radius), out=made[:, ::2])
        np.multiply(np.sin(angle, out=angle), radius, out=made[:, 1::2])


def choice(number: Tensor, count: Tensor | int) -> Tensor:
    """Integers in [0, count) from numbers in (0, 1); same shape as the number and as the count, int64."""
    return (number * count).long()


def between(low: float, high: float, number: Tensor) -> Tensor:
    """Numbers from low to high, evenly spread, from numbers in (0, 1); same shape as these, float32."""
    return low + (high - low) * number


def log_between(low: float, high: float, number: Tensor) -> Tensor:
    """Numbers from low to high, their logarithms evenly spread, from numbers in (0, 1); same shape as these,
    float32.
    """
    import torch

    return torch.exp(between(math.log(low), math.log(high), number))
