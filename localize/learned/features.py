"""Level and phase differences of microphone pairs over time and frequency: what the network looks at.

A frame of 250 samples at 1 kHz is continued by its last sample 250 times and analysed by a Morlet wavelet at 64
linear frequencies from 1 to 100 Hz. Over the last 47 samples of the frame, the ratio of every pair of microphones is
averaged over 16 consecutive samples, which gives 64 x 32 values per map. Each pair gives three maps: its level 20 log10
|X1/X2| in dB, and the real and imaginary part of the averaged unit phasor of X1 conj(X2), whose angle is the phase
difference and whose length falls below 1 where the phase is not steady. Phasors, unlike angles, have no jump. One more
map shows where there is a signal at all, because ratios elsewhere mean nothing: the power of all microphones together,
in dB below its maximum over the frame. It halves the errors and is ours, not the paper's.

If a network is trained for the sound of rooms, it gets a second set of these maps, made after noise and room sound have
been whitened. Whitening leaves little of the sound: it presses on all membranes alike, so that it takes up one of three
microphones' dimensions at each frequency. This is ours too.

The paper's own choice is there for comparison: level and phase difference alone, two maps per pair. Its phases are
averaged as phasors too, so that the mean of two angles beside the jump at pi lies there and not at zero.

Continuation and wavelet are one fixed linear map from 250 samples to 64 x 47 complex values. Its numerical rank is
low, so that it is applied as two small real factors.
"""

from __future__ import annotations

import functools
import math
from itertools import combinations
from typing import Literal

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from geometry.ground.refusal import Kind, Refusal
from localize.learned.wavelets import BANDWIDTH, CONTINUATION, FREQUENCIES, GRID, TAIL, wavelet_frequencies
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE

AVERAGE = 16
"""Number of samples over which ratios are averaged."""
COLUMNS = TAIL - AVERAGE + 1
"""Number of columns of a map."""
FeatureChoice = Literal["phasors", "paper", "rooms"]
"""Choice of the maps: level, phasor and power; the paper's level and phase difference alone; or the first of them
twice, of the frame and of what is left of it where sound is taken out."""
MAPS_PER_PAIR: dict[FeatureChoice, int] = {"phasors": 3, "paper": 2, "rooms": 6}
OF_POWER: dict[FeatureChoice, int] = {"phasors": 1, "paper": 0, "rooms": 2}
"""Maps of the power of all microphones."""
DECIBEL = 10 / math.log(10)
"""Level of a ratio of powers over its natural logarithm, dB."""
RANK = 64
"""Rank of the two factors of the linear map."""
POWER_RANGE = 60.0
"""Range of the power, dB: weaker parts of a frame are drawn as this far below its maximum."""


def map_count(microphones: int, choice: FeatureChoice = "phasors") -> int:
    """Number of maps of an array: three for every pair of microphones and one of the power, or twice as many, or the
    paper's two.

    Raises:
        Refusal: an unknown choice.
    """
    if choice not in MAPS_PER_PAIR:
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="features", value=choice, allowed=MAPS_PER_PAIR)
    return MAPS_PER_PAIR[choice] * microphones * (microphones - 1) // 2 + OF_POWER[choice]


class PairFeatures(nn.Module):
    """Module that makes maps (n, n_map, 64, 32) of a batch of frames (n, n_microphone, 250).

    Pairs run (1, 2), (1, 3), ..., (2, 3), ...; maps of a pair are level in dB, real and imaginary part of the
    phasor, and the power comes last; with ``choice="paper"`` they are level in dB and phase in rad, and that is all.
    With ``choice="rooms"`` those of the frame come first, then those of what :meth:`take_out` leaves of it: all, before
    it was called.

    Nothing but real matrix products and functions of one value: it runs on any device and can be exported.

    Raises:
        Refusal: an unknown choice.
    """

    analysis: Tensor
    """First factor of continuation and wavelet; (250, 64) float64."""
    synthesis: Tensor
    """Second factor of continuation and wavelet; (64, 2 * 64 * 47) float32, real rows first, then imaginary ones."""
    averaging: Tensor
    """Means over 16 consecutive samples as a matrix, seven times as fast as pooling; (47, 32) float32."""
    of_white: Tensor
    """The first factor behind what makes sound white, of rooms alone; (n_microphone * 250, n_microphone * 64)
    float64."""

    def __init__(self, microphones: int, choice: FeatureChoice = "phasors") -> None:
        super().__init__()
        analysis, synthesis = _factors()
        # Where a wavelet hears little of a loud frame, its value is a small difference of large ones. What the first,
        # small matrix rounds differs from one library to another, and with it the ratios: it is in double precision.
        self.register_buffer("analysis", torch.from_numpy(analysis), persistent=False)
        self.register_buffer("synthesis", torch.from_numpy(synthesis.astype(np.float32)), persistent=False)
        start = np.arange(TAIL)[:, None] - np.arange(COLUMNS)
        weights = np.where((start >= 0) & (start < AVERAGE), 1 / AVERAGE, 0.0)
        self.register_buffer("averaging", torch.from_numpy(weights.astype(np.float32)), persistent=False)
        self.pairs = tuple(combinations(range(microphones), 2))
        self.map_count = map_count(microphones, choice)
        self.choice = choice
        if choice == "rooms":
            self.register_buffer("of_white", torch.block_diag(*[self.analysis] * microphones))

    def take_out(self, covariance: NDArray[np.float64]) -> None:
        """Make noise and sound white in the second half of the maps of rooms, each microphone changed the least.

        Args:
            covariance: of the signals without a touch, microphone by microphone; (n_microphone * 250,) * 2 float64,
                Pa^2, as of :func:`localize.decoders.frame_covariance.whole_frame_covariance`.
        """
        power, waves = np.linalg.eigh(covariance)
        white = torch.from_numpy((waves / np.sqrt(power)) @ waves.T).unflatten(1, (-1, FRAME))
        self.of_white.copy_((white @ self.analysis.cpu()).flatten(1))

    def transform(self, frames: Tensor) -> tuple[Tensor, Tensor]:
        """Real and imaginary part of the wavelet transform.

        Args:
            frames: (..., 250) float32, Pa.

        Returns:
            Two of (..., 64, 47) float32, Pa.
        """
        return self._waves(frames.double() @ self.analysis)

    def forward(self, frames: Tensor) -> Tensor:
        """Maps of a batch of frames; a common gain of all microphones changes nothing.

        Args:
            frames: (n, n_microphone, 250) float32, Pa, at 1 kHz.

        Returns:
            (n, n_map, 64, 32) float32.
        """
        # Scaled so that powers neither overflow nor vanish.
        exact = _scaled(frames.double())
        shares = exact @ self.analysis
        if self.choice == "rooms":
            left = _scaled((exact.flatten(1) @ self.of_white).unflatten(1, (-1, RANK)))
            shares = torch.stack([shares, left], 1)
        else:
            shares = shares[:, None]
        maps = self._maps(*self._waves(shares.flatten(0, 1)))
        return maps.unflatten(0, (-1, shares.shape[1])).flatten(1, 2)

    def _waves(self, shares: Tensor) -> tuple[Tensor, Tensor]:
        """Result of the first factor, (..., 64), to real and imaginary part of the transform, (..., 64, 47)."""
        parts = (shares.to(self.synthesis.dtype) @ self.synthesis).unflatten(-1, (2, FREQUENCIES, TAIL))
        return parts.select(-3, 0), parts.select(-3, 1)

    def _log(self, values: Tensor) -> Tensor:
        """Natural logarithm, in training on a processor by NumPy, which takes a third of the time of torch."""
        if self.training and values.device.type == "cpu" and not torch.compiler.is_compiling():
            return torch.from_numpy(np.log(values.numpy()))
        return values.log()

    def _maps(self, real: Tensor, imag: Tensor) -> Tensor:
        """(n, n_map, 64, 32) of a transform, (n, n_microphone, 64, 47) each."""
        power = torch.addcmul(real * real, imag, imag).clamp_min_(1e-30)
        level, inverse = self._log(power), power.rsqrt()
        cosine, sine = real * inverse, imag * inverse
        in_decibel = DECIBEL * self.averaging
        maps: list[Tensor] = []
        for a, b in self.pairs:
            along = torch.addcmul(cosine[:, a] * cosine[:, b], sine[:, a], sine[:, b])
            across = torch.addcmul(sine[:, a] * cosine[:, b], cosine[:, a], sine[:, b], value=-1)
            maps += [(level[:, a] - level[:, b]) @ in_decibel, along @ self.averaging, across @ self.averaging]
        if self.choice == "paper":
            averaged = torch.stack(maps, 1).unflatten(1, (len(self.pairs), 3))
            phase = torch.atan2(averaged[:, :, 2], averaged[:, :, 1])
            return torch.stack([averaged[:, :, 0], phase], 2).flatten(1, 2)
        total = self._log(functools.reduce(torch.add, power.unbind(1)) @ self.averaging)
        shown = (total - total.amax((-2, -1), keepdim=True)).mul_(DECIBEL).clamp_min_(-POWER_RANGE)
        return torch.stack([*maps, shown], 1)


def _scaled(values: Tensor) -> Tensor:
    """Values (n, n_microphone, k) of a frame over their largest one."""
    return values / values.abs().amax((-2, -1), keepdim=True)


def _wavelet_spectra() -> NDArray[np.float64]:
    """(64, GRID) float64; zero at negative frequencies."""
    frequency = np.fft.fftfreq(GRID, 1 / SAMPLE_RATE)
    centre = wavelet_frequencies()[:, None]
    return np.where(frequency > 0, np.exp(-0.5 * (2 * np.pi * BANDWIDTH * (frequency / centre - 1)) ** 2), 0.0)


@functools.lru_cache(maxsize=1)
def _factors() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Continuation and wavelet as (250, 64) and (64, 2 * 64 * 47): real rows first, then imaginary ones.

    Rows are weighted alike: each wavelet has its peak at one, whatever its frequency.
    """
    kernel = np.fft.ifft(_wavelet_spectra(), axis=-1)
    time = np.arange(FRAME - TAIL, FRAME)[:, None]
    sample = np.arange(FRAME + CONTINUATION)[None, :]
    dense = kernel[:, (time - sample) % GRID]
    dense[..., FRAME - 1] += dense[..., FRAME:].sum(-1)
    dense = dense[..., :FRAME].reshape(FREQUENCIES * TAIL, FRAME)
    u, s, vt = np.linalg.svd(np.concatenate([dense.real, dense.imag]), full_matrices=False)
    return vt[:RANK].T * s[:RANK], np.ascontiguousarray(u[:, :RANK].T)
