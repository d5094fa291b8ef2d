"""Test of frames that hold room sound alone: the same pressure on all membranes, and no touch.

Sound moves all microphones by one function of frequency: with two microphones it fills half of the directions in which
a frame can lie, with four a quarter (:mod:`localize.decoders.background_test`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem import Library
from localize.decoders.background_test import BackgroundTest
from localize.decoders.decoder_options import SoundOptions
from localize.decoders.frame_covariance import ambient_covariance, check_level, check_noise
from localize.decoders.judgement import too_loud
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor


class SoundTest(BackgroundTest):
    """Test that detects sound without a touch.

    Args:
        library: library with a design, from which the response to room sound follows.
        microphone_noise: the noise there is, as of :class:`localize.BayesDecoder`.
        loudest_sound_db: level up to which sound is recognised, dB SPL, 0 to 140. The louder, the more of what lies
            below 20 Hz passes for sound: from 100 dB SPL on all of it.
        options: numbers that tune it.

    Raises:
        Refusal: an argument out of range; a library without a design; sound too far above the noise for double
            precision; or as :func:`localize.signals.array_response.response_of`.
    """

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = "design",
        loudest_sound_db: float = 80.0,
        options: SoundOptions = SoundOptions(),
    ) -> None:
        check_noise(microphone_noise)
        response = response_of(library)
        check_level(response, loudest_sound_db, "loudest_sound_db")
        self._response, self._given = response, (microphone_noise, loudest_sound_db, options)
        super().__init__(
            response.microphones,
            response.noise(microphone_noise),
            ambient_covariance(response, loudest_sound_db),
            options,
        )
        if not self.is_precise:
            remedy = ("expect more noise, or quieter sound",)
            raise too_loud("loudest_sound_db", loudest_sound_db, "dB SPL", remedy)

    def heard_by(self, microphones: tuple[str, ...]) -> SoundTest:
        """The test for some of the microphones, names of two or more."""
        return SoundTest(self._response.heard_by(microphones), *self._given)

    def is_sound(self, signals: ArrayLike | Tensor) -> NDArray[np.bool_]:
        """True if sound explains signals, on the library's sensor or on one that is made a little differently.

        Args:
            signals: (n, n_microphone, n_sample), as :meth:`p_value`.

        Returns:
            (n,) bool; True also of noise alone.

        Raises:
            Refusal: as :meth:`p_value`.
        """
        return self.explains(signals)
