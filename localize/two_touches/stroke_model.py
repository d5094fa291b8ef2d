"""Model of frames of a stream: strokes, through the membranes and the array, behind the high-pass of the stream."""

from __future__ import annotations

import numpy as np
import scipy.signal

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray
from localize.decoders.frame_covariance import floor_covariance, low_pass
from localize.live.front_end import high_pass_sections
from localize.live.stream_options import HIGH_PASS
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import FRAME
from localize.signals.noise_model import NoiseChoice
from localize.signals.stimulus import SAMPLE_RATE, SCALED_AT

STEP = 0.5
"""Step of the frequencies, Hz: a frame repeats after 2 s."""
HIGHEST = 124.5
"""Highest frequency, Hz: the low-pass of a frame ends below."""


class StrokeModel:
    """Model of white frames of an array.

    A stroke of height one makes 1 Pa in the cavity at 30 Hz, as for the strokes of the touch generator.

    Args:
        response: the array, with the pressures in its cavities by forces.
        microphone_noise: as of :class:`localize.BayesDecoder`.

    Raises:
        Refusal: bare transfer functions, which know no membranes.
    """

    def __init__(self, response: ArrayResponse, microphone_noise: NoiseChoice) -> None:
        self.frequency = np.arange(STEP, HIGHEST + STEP / 2, STEP)
        transfer, cavity = response.between(self.frequency)
        _, scale = response.between(np.array([SCALED_AT]))
        if cavity is None or scale is None:
            problem = "has bare transfer functions; strokes need the membranes of a design"
            raise Refusal(problem, kind=Kind.UNSUITABLE, field="library")
        self.paths: ComplexArray = transfer * (cavity / np.abs(scale))[:, None]
        """Pressure at each microphone by the height of a stroke, (n_point, n_microphone, n_freq) complex128."""
        covariance = floor_covariance(response.noise(microphone_noise))
        self._reduce = np.linalg.solve(np.linalg.cholesky(covariance), low_pass())
        _, passed = scipy.signal.sosfreqz(high_pass_sections(HIGH_PASS), self.frequency, fs=SAMPLE_RATE)
        turn = np.exp(2j * np.pi * self.frequency[:, None] * np.arange(FRAME) / SAMPLE_RATE)
        sampling = 2 * STEP * passed[:, None] * turn @ self._reduce.T
        self._sampling = np.concatenate([sampling.real, -sampling.imag])
        # Of every second frequency: a frame then repeats after 1 s, which is enough for a first look.
        half = 2 * sampling[1::2]
        self._half_sampling = np.concatenate([half.real, -half.imag])

    def coarse(self) -> StrokeModel:
        """The same model by every second frequency."""
        other: StrokeModel = object.__new__(StrokeModel)
        other.frequency, other.paths = self.frequency[1::2], self.paths[..., 1::2]
        other._reduce, other._sampling = self._reduce, self._half_sampling
        return other

    def white(self, frame: Array) -> Array:
        """White samples of a frame, (n_microphone, 250) Pa -> (n_white,)."""
        return np.asarray((frame @ self._reduce.T).ravel())

    def sampled(self, spectra: ComplexArray) -> Array:
        """White samples of spectra at the microphones, (..., n_microphone, n_freq) Pa s -> (..., n_white)."""
        flat = np.concatenate([spectra.real, spectra.imag], axis=-1)
        white = flat.reshape(-1, flat.shape[-1]) @ self._sampling
        return np.asarray(white.reshape(*spectra.shape[:-2], -1))
