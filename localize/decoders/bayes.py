"""The decoder that needs no training: maximum likelihood over points, from the library alone.

If point i is touched, the microphones' samples of a frame, stacked into one vector x, are a zero-mean Gaussian with
covariance g C_i + N: C_i from :mod:`localize.decoders.frame_covariance`, g the unknown power of the touch, N the
covariance of the noise. The likelihood of each point, maximised over g, ranks the points (Gaussian-process
classification; Rasmussen and Williams 2006, chapter 2, for the likelihood). In coordinates where N is the identity, the
eigenvectors of C_i make the likelihood a sum over a few dozen terms.

Sound from outside presses on all membranes alike: at each frequency it adds a covariance of rank one to N, whose
shape the library knows and whose level is assumed, or found among several as the likeliest.

A touch with few spectral lines fills far fewer of those terms than a flat spectrum, so that the likelihood weighs the
noise of the empty ones too high against the shape of the signal: the decoder assumes a fraction of the given noise,
and divides its log-likelihoods by a temperature, so that its probabilities are as sure as they are right.
"""

from __future__ import annotations

import numpy as np

from acoustic_fem import Library
from localize.decoders.decoder_options import DecoderOptions
from localize.decoders.frame_covariance import SAMPLES, touch_covariances
from localize.decoders.library_decoder import PointDecoder
from localize.decoders.surroundings import Ambient, Surroundings
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread


class BayesDecoder(PointDecoder):
    """Gaussian-process maximum likelihood over the points of one array.

    Args:
        library: transfer functions that cover 1 to 100 Hz, of at least two points and two microphones; touches are
            taken to be silent above their last frequency, with a warning where that is below 500 Hz.
        microphone_noise: the noise floor to assume: "design" for that of the library's design, see
            :mod:`localize.signals.noise_model`; or white, Pa rms over 0 to 500 Hz, 1e-9 to 10. It also stands for what
            the library does not know; a higher one is kinder to a sensor that differs from its design.
        ambient: pink sound around, the same pressure on all membranes: its level in dB SPL, 0 to 140; None for
            quiet; or several levels, such as :data:`ROOM`, of which each frame takes the likeliest. Tables, and where
            there is sound also time, grow with their number. Needs a library with a design.
        options: numbers that tune it.

    Raises:
        Refusal: the library does not cover 1 to 100 Hz, the noise or the sound is outside its range, or sound or the
            noise of a design is assumed without a design.
    """

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = "design",
        ambient: Ambient = None,
        options: DecoderOptions = DecoderOptions(),
    ) -> None:
        response = response_of(library)
        around = Surroundings.of(response, microphone_noise, ambient)
        touched = touch_covariances(response, np.eye(SAMPLES))
        super().__init__(response, around, touched, options)

    def heard_by(self, microphones: tuple[str, ...]) -> BayesDecoder:
        """The decoder of the same array by some of its microphones; as of :class:`localize.Locator`."""
        rest = self.response.heard_by(microphones)
        return BayesDecoder(rest, self.microphone_noise, self.ambient, self.options)
