"""The simple baseline of docs/evidence/decoder.md: which point's responses line up with the microphones' spectra.

Each microphone's frame is Fourier transformed under a Hann window. At one frequency the microphones' amplitudes X are,
if point i is touched, its transfer functions h_i times one unknown source amplitude, plus noise of power s per
microphone. With the amplitude and the noise's own scale profiled out, M microphones give the log-likelihood

    -(M - 1) log(|X|^2 - |h_i^H X|^2 / |h_i|^2 + s)

up to a constant, summed over frequencies (the generalised likelihood ratio of a signal in a known direction and noise
of unknown power; Kraut and Scharf 1999, the adaptive coherence estimator). It takes a source that lasts longer than the
frame: the window mixes neighbouring frequencies and forgets what came before it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from localize import ArrayResponse
from localize.signals import BAND, FRAME, SAMPLE_RATE


class RatioBaseline:
    """Likelihood ratio per frequency, the points' scores summed over 4 to 100 Hz.

    Args:
        response: transfer functions that cover 1 to 100 Hz.
        microphone_noise: white, Pa rms over 0 to 500 Hz: residuals below it count as none.
    """

    def __init__(self, response: ArrayResponse, microphone_noise: float) -> None:
        bins = np.arange(1, int(BAND[1] * FRAME / SAMPLE_RATE) + 1)
        h = response.at(bins * SAMPLE_RATE / FRAME)
        self._direction = (h / np.linalg.norm(h, axis=1, keepdims=True)).conj().transpose(2, 1, 0)
        window = np.hanning(FRAME + 1)[:FRAME]
        self._transform = window[:, None] * np.exp(-2j * np.pi * np.outer(np.arange(FRAME), bins) / FRAME)
        self._floor = float(microphone_noise**2 * (window**2).sum())

    def log_likelihood(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihood of every point, (n, n_point) in nats, of frames (n, n_microphone, 250) in Pa."""
        spectrum = (frames @ self._transform).transpose(2, 0, 1)
        along = np.abs(spectrum @ self._direction) ** 2
        whole = (np.abs(spectrum) ** 2).sum(2, keepdims=True)
        residual = np.maximum(whole - along, 0.0) + self._floor
        return np.asarray(-(frames.shape[1] - 1) * np.log(residual).sum(0))

    def locate(self, frames: NDArray[np.float64]) -> NDArray[np.intp]:
        """The likeliest point of each frame, (n,)."""
        return np.asarray(self.log_likelihood(frames).argmax(1))
