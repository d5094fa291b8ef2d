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
from localize.two_touches.path_deviations import smooth_functions

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
        self._set_sampling(2 * STEP * passed[:, None] * turn @ self._reduce.T)
        self.smooth = smooth_functions(self.frequency)
        """Functions of the deviations of paths, (n_term, n_freq) float64."""

    def coarse(self) -> StrokeModel:
        """The same model by every second frequency and in single precision, which is enough for a first look.

        A frame then repeats after 1 s.
        """
        other: StrokeModel = object.__new__(StrokeModel)
        other.frequency = self.frequency[1::2].astype(np.float32)
        other.paths = self.paths[..., 1::2].astype(np.complex64)
        other.smooth = self.smooth[:, 1::2].astype(np.float32)
        other._reduce = self._reduce
        other._set_sampling(2 * self._by_frequency[1::2])
        return other

    def white(self, frame: Array) -> Array:
        """White samples of a frame, (n_microphone, 250) Pa -> (n_white,)."""
        return np.asarray((frame @ self._reduce.T).ravel())

    def sampled(self, spectra: ComplexArray) -> Array:
        """White samples of spectra (..., n_freq) complex128 or complex64, Pa s.

        Returns:
            (..., n_reduced) of their precision. Those of all microphones, one after the other, are a white frame.
        """
        flat = np.ascontiguousarray(spectra).reshape(-1, spectra.shape[-1])
        is_single = spectra.dtype == np.complex64
        white = flat.view(flat.real.dtype) @ (self._single if is_single else self._sampling)
        return np.asarray(white.reshape(*spectra.shape[:-1], white.shape[1]))

    def _set_sampling(self, by_frequency: ComplexArray) -> None:
        self._by_frequency = by_frequency
        # Real and imaginary parts in turn, as a complex number has them in memory.
        parts = np.stack([by_frequency.real, -by_frequency.imag], axis=1)
        self._sampling = parts.reshape(-1, by_frequency.shape[1])
        self._single = self._sampling.astype(np.float32)
