"""Test of frames that hold the motion of the sensor, and sound, but no touch."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem import Library
from geometry.ground.refusal import Field, Kind, Refusal
from localize.decoders.background_test import BackgroundTest
from localize.decoders.decoder_options import SoundOptions
from localize.decoders.frame_covariance import ambient_covariance, check_level, check_noise
from localize.decoders.hand_motion import HandMotion
from localize.decoders.judgement import too_loud
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import checked_signals
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor

MISMATCH = 0.08
"""Fraction of a frame, in amplitude, that motion may leave beside its directions on an as-built sensor, gains apart: at
the frequencies of a hand, the vents of the microphones differ by more than at those of sound."""
FEWEST_DIRECTIONS = 10
"""Least number of directions of a frame that motion must leave free."""


class MotionTest(BackgroundTest):
    """Test that detects the motion of the sensor, with room sound or without, in frames without a touch.

    A touch whose microphones follow each other as those of a moved sensor is taken for motion, unless it is louder than
    the largest acceleration: slow touches on a sealed sensor are such. Without ``motion`` they are touches.

    Args:
        library: library with a design, or its response.
        motion: of the same array.
        microphone_noise: the noise there is, as of :class:`localize.BayesDecoder`.
        loudest_sound_db: level up to which sound beside the motion is recognised, dB SPL, 0 to 140.
        options: numbers that tune it.

    Raises:
        Refusal: an argument out of range; a sensor that is moved in as many directions as it has microphones, so that
            any touch may be motion; motion or sound too far above the noise for double precision; or as
            :func:`localize.signals.array_response.response_of`.
    """

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        motion: HandMotion,
        microphone_noise: NoiseChoice = "design",
        loudest_sound_db: float = 80.0,
        options: SoundOptions = SoundOptions(mismatch=MISMATCH),
    ) -> None:
        check_noise(microphone_noise)
        response = response_of(library)
        check_level(response, loudest_sound_db, "loudest_sound_db")
        self.motion = motion.heard_by(response.microphones)
        self._response, self._given = response, (motion, microphone_noise, loudest_sound_db, options)
        covariance = self.motion.covariance + ambient_covariance(response, loudest_sound_db)
        super().__init__(response.microphones, response.noise(microphone_noise), covariance, options)
        if not self.is_precise:
            remedy = ("expect more noise, slower motion or quieter sound",)
            raise too_loud("motion", motion.largest, "m/s2", remedy)
        if self.freedom < FEWEST_DIRECTIONS:
            raise Refusal(
                "leaves nothing to tell a touch by, because the sensor is moved in as many directions as it has "
                "microphones",
                kind=Kind.UNSUITABLE,
                field="motion",
                value=motion.largest,
                unit="m/s2",
                remedy=("record an accelerometer and give its file as ", Field("acceleration")),
            )

    def heard_by(self, microphones: tuple[str, ...]) -> MotionTest:
        """The test for some of the microphones, names of two or more."""
        return MotionTest(self._response.heard_by(microphones), *self._given)

    def is_motion(self, signals: ArrayLike | Tensor, noise_ratio: float = 1.0) -> NDArray[np.bool_]:
        """True if motion explains signals, and they are no louder than it can be.

        Args:
            signals: (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.
            noise_ratio: as of :meth:`beside`.

        Returns:
            (n,) bool; True also of noise alone.

        Raises:
            Refusal: as :meth:`p_value`.
        """
        batch, _ = checked_signals(signals, self.microphones)
        found, most = self.beside(batch, noise_ratio)
        return np.asarray((found <= most) & (np.abs(batch).max((1, 2)) <= self.motion.loudest + 5 * self.noise_rms))
