"""What judges the frames of a stream, and goes on by the other microphones where one is dead or clipped."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from localize.decoders.judgement import ResidualTest
    from localize.decoders.sound_test import SoundTest

FEWEST = 2
"""Number of microphones that points can be told apart with."""


class StreamLocator(Protocol):
    """Locator that can listen to a stream: network, model-based decoder, and either as an ONNX file."""

    @property
    def microphones(self) -> tuple[str, ...]:
        """Names of the microphones."""

    @property
    def noise_rms(self) -> float:
        """Noise of a microphone, Pa rms."""

    def locate(self, signals: ArrayLike) -> NDArray[np.float64]:
        """Probability per point of one frame.

        Args:
            signals: (n_microphone, 250), Pa, at 1 kHz.

        Returns:
            (n_point,) float64.
        """


@dataclass(frozen=True)
class Judges:
    """What judges the frames of some microphones."""

    locator: StreamLocator
    """Names the point of a frame."""
    sound_test: SoundTest | None = None
    """Tells sound from touches; None where nobody does."""
    residual_test: ResidualTest | None = None
    """Tells what no point explains; None where nobody does."""


#: Judges of the microphones of these names, of which there are at least two.
Spare = Callable[[tuple[str, ...]], Judges]


class JudgesOfTheRest:
    """Judges of the microphones that are left, made when they are first needed.

    Args:
        microphones: names of all microphones.
        spare: makes judges of some; None if nobody can go on without any.
    """

    def __init__(self, microphones: tuple[str, ...], spare: Spare | None) -> None:
        self._microphones, self._spare = microphones, spare
        self._made: dict[tuple[str, ...], Judges] = {}

    def __call__(self, good: NDArray[np.bool_]) -> Judges | None:
        """Judges of the microphones that are (n_microphone,) good; None if these are too few."""
        names = tuple(name for name, is_good in zip(self._microphones, good, strict=True) if is_good)
        if self._spare is None or len(names) < FEWEST:
            return None
        if names not in self._made:
            self._made[names] = self._spare(names)
        return self._made[names]
