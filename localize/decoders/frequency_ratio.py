"""The simple baseline: which point's transfer functions line up with the microphones' spectra.

Each microphone's frame is Fourier transformed under a Hann window. At one frequency the microphones' amplitudes X are,
if point i is touched, its transfer functions h_i times one unknown source amplitude, plus noise of power s per
microphone. With the amplitude and the noise's own scale profiled out, M microphones give the log-likelihood

    -(M - 1) log(|X|^2 - |h_i^H X|^2 / |h_i|^2 + s)

up to a constant, summed over frequencies (the generalised likelihood ratio of a signal in a known direction and noise
of unknown power; Kraut and Scharf 1999, the adaptive coherence estimator). It takes a source that lasts longer than the
frame: the window mixes neighbouring frequencies and forgets what came before it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import torch
from numpy.typing import ArrayLike, NDArray
from torch import Tensor

from localize.decoders.frame_covariance import check_noise
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import FRAME, checked_signals, combined_probability, cut_frames
from localize.signals.stimulus import BAND, SAMPLE_RATE
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from acoustic_fem import Library


class FrequencyRatioDecoder:
    """Likelihood ratio per frequency, the points' scores summed over 4 to 100 Hz.

    Args:
        library: transfer functions that cover 1 to 100 Hz, of at least two points and two microphones.
        microphone_noise: white, Pa rms over 0 to 500 Hz, 1e-9 to 10: residuals below it count as none.

    Raises:
        Refusal: the library does not cover 1 to 100 Hz, or the noise is outside its range.
    """

    def __init__(self, library: Library | ArrayResponse, microphone_noise: float = 1e-3) -> None:
        check_noise(microphone_noise)
        response = response_of(library)
        self.microphones = response.microphones
        self.line = response.line
        self.place = response.place
        self.microphone_noise = microphone_noise
        bins = np.arange(1, int(BAND[1] * FRAME / SAMPLE_RATE) + 1)
        h = response.at(bins * SAMPLE_RATE / FRAME)
        self._direction = (h / np.linalg.norm(h, axis=1, keepdims=True)).conj().transpose(2, 1, 0)
        time = np.arange(FRAME)
        window = np.hanning(FRAME + 1)[:FRAME]
        self._transform = window[:, None] * np.exp(-2j * np.pi * np.outer(time, bins) / FRAME)
        self._floor = float(microphone_noise**2 * (window**2).sum())

    @property
    def point_count(self) -> int:
        """Number of sensing points."""
        return len(self.line)

    @one_thread()
    def locate(self, signals: ArrayLike | Tensor) -> NDArray[np.float64]:
        """Where the array was touched, as :meth:`localize.BayesDecoder.locate`.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n_point,) or (n, n_point) float64. The frequencies are not independent: these probabilities are too sure.

        Raises:
            Refusal: wrong number of channels, too few samples, a value that is not finite, a silent channel.
        """
        batch, batched = checked_signals(signals, self.microphones)
        frames = cut_frames(batch)
        score = self.log_likelihood(frames.flatten(0, 1).numpy())
        probability = combined_probability(torch.from_numpy(score).unflatten(0, frames.shape[:2])).numpy()
        return probability if batched else probability[0]

    def log_likelihood(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihood of every point.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_point) float64, nats, up to a constant per frame.
        """
        spectrum = (frames @ self._transform).transpose(2, 0, 1)
        along = np.abs(spectrum @ self._direction) ** 2
        whole = (np.abs(spectrum) ** 2).sum(2, keepdims=True)
        residual = np.maximum(whole - along, 0.0) + self._floor
        return np.asarray(-(len(self.microphones) - 1) * np.log(residual).sum(0))
