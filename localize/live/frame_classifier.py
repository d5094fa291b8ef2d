"""Classifier of the frames of a stream, which goes on with the other microphones if one is dead or clipped."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from localize.decoders.judgement import ResidualTest
from localize.decoders.motion_test import MotionTest
from localize.decoders.sound_test import SoundTest
from localize.signals.locator import Locator

FEWEST = 2
"""Least number of microphones that can distinguish points."""


@dataclass(frozen=True)
class FrameClassifier:
    """Locator and tests for the frames of some microphones."""

    locator: Locator
    """Names the point of a frame."""
    sound_test: SoundTest | None = None
    """Tells sound from touches; None where nothing does."""
    residual_test: ResidualTest | None = None
    """Rejects frames that no point explains; None where nothing does."""
    motion_test: MotionTest | None = None
    """Detects frames that hold only motion of the sensor; None where nothing does."""

    def heard_by(self, microphones: tuple[str, ...]) -> FrameClassifier:
        """The same for some of the microphones, names of two or more."""
        return FrameClassifier(
            self.locator.heard_by(microphones),
            None if self.sound_test is None else self.sound_test.heard_by(microphones),
            None if self.residual_test is None else self.residual_test.heard_by(microphones),
            None if self.motion_test is None else self.motion_test.heard_by(microphones),
        )


class Fallback:
    """Classifiers for the microphones that are left, made when they are first needed, which takes up to seconds.

    Args:
        whole: classifier of all microphones.
        allowed: whether there is a fallback; it also needs a locator that goes on without a microphone.
    """

    def __init__(self, whole: FrameClassifier, allowed: bool) -> None:
        self._whole, self._allowed = whole, allowed and not whole.locator.needs_all_microphones
        self._made: dict[tuple[str, ...], FrameClassifier] = {}

    def __call__(self, good: NDArray[np.bool_]) -> FrameClassifier | None:
        """Classifier of the microphones that are (n_microphone,) good; None if these are too few."""
        if good.all():
            return self._whole
        names = tuple(name for name, is_good in zip(self._whole.locator.microphones, good, strict=True) if is_good)
        if not self._allowed or len(names) < FEWEST:
            return None
        if names not in self._made:
            self._made[names] = self._whole.heard_by(names)
        return self._made[names]
