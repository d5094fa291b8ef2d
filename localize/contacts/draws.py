"""Random numbers of one contact: a fixed row of numbers that it owns, handed out in order."""

from __future__ import annotations

import math
from typing import TypedDict

import numpy as np
from numpy.typing import NDArray

from localize.signals.random_streams import Purpose, StreamKind, random_words, uniform

_WORDS = 128
TREMOR = (6.0, 12.0)
"""Band of the tremor of a hand, Hz: that of healthy people is 8 to 12 Hz (Elble and Koller, Tremor, 1990)."""
SWAY = (0.3, 3.0)
"""Band in which a hand that means to press evenly drifts, Hz; ours."""


class Stream(TypedDict, total=False):
    """Random numbers that a contact owns: keyword arguments of all functions that draw one."""

    seed: int
    """Seed, any non-negative integer; 0 where it is not given."""
    purpose: Purpose
    """Purpose: streams of different ones never share a number; "evaluation" where it is not given."""
    sample: int
    """Index of the contact in the stream; 0 where it is not given."""


class Draws:
    """Numbers of one contact, the same whatever was drawn for others.

    Args:
        kind: of the contact.
        seed: as of :class:`Stream`.
        purpose: as of the same.
        sample: as of the same.
    """

    def __init__(self, kind: StreamKind, seed: int = 0, purpose: Purpose = "evaluation", sample: int = 0) -> None:
        drawn = uniform(random_words(seed, purpose, kind, sample, 1, _WORDS))
        self._left = iter(drawn.numpy().astype(np.float64).ravel().tolist())

    def between(self, limits: tuple[float, float]) -> float:
        """A number from the first to the second, evenly spread."""
        return limits[0] + (limits[1] - limits[0]) * next(self._left)

    def log_between(self, limits: tuple[float, float]) -> float:
        """A number from the first to the second, its logarithm evenly spread."""
        return math.exp(self.between((math.log(limits[0]), math.log(limits[1]))))

    def noise(self, time: NDArray[np.float64], band: tuple[float, float], waves: int = 8) -> NDArray[np.float64]:
        """Noise of mean square one at some times: waves of frequencies in a band.

        Args:
            time: (n,) float64, s.
            band: Hz.
            waves: how many; each takes two numbers.

        Returns:
            (n,) float64.
        """
        total = np.zeros_like(time)
        for _ in range(waves):
            frequency, phase = self.between(band), self.between((0.0, 2 * math.pi))
            total += np.cos(2 * math.pi * frequency * time + phase)
        return total * math.sqrt(2 / waves)

    def hand(self, time: NDArray[np.float64], unsteadiness: float) -> NDArray[np.float64]:
        """Factor on the force of a hand: it sways and trembles.

        Args:
            time: (n,) float64, s.
            unsteadiness: rms of the factor about one; a third of it is tremor.

        Returns:
            (n,) float64, above zero.
        """
        moved = unsteadiness * (0.94 * self.noise(time, SWAY) + 0.33 * self.noise(time, TREMOR))
        return np.asarray(np.exp(moved - unsteadiness**2 / 2))
