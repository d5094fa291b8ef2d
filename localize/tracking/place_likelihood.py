"""Likelihood of any place of a contact, with its slope, from the whole frame up to 250 Hz.

The decoder of points low-passes frames at 115 Hz, which classifies points as well. Places between two points differ far
less, and half of the information on a tap of 10 to 30 ms lies above 115 Hz: with it the bound of Cramér and Rao on its
place is 0.02 to 0.04 pitch, without it 0.1 to 0.3.

A frame x is B(w)^T s + noise: s the contact's sound as white numbers, B(w) the sum over the membranes of the share w of
each in the contact times what the microphones hear of it. With the noise white the covariance is g B^T B + 1, of
power g; all of it is reckoned among the numbers of s, which are fewer than those of x (Rasmussen and Williams 2006,
appendix A.3). The slope follows from w alone, and its square gives the information on the place as of Gauss and Newton.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import scipy.fft
import scipy.linalg
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.decoders.frame_covariance import (
    HUM,
    INTEGRATION_STEP,
    SOURCE_RMS,
    ambient_waves,
    random_waves,
)
from localize.signals.array_response import ArrayResponse
from localize.signals.disturbances import MAINS
from localize.signals.frames import FRAME
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.stimulus import BAND, SAMPLE_RATE
from localize.tracking.footprints import footprint_response, fractions_at, pitch_of
from localize.tracking.tracking_options import PositionOptions


class Slope(NamedTuple):
    """Likelihood around a place."""

    value: float
    """Log-likelihood, nats."""
    gradient: Array
    """Slope of it; (2,) float64, nats/mm."""
    information: Array
    """Information on the place, the inverse of a covariance; (2, 2) float64, 1/mm^2."""


class PlaceLikelihood:
    """Likelihood of places of a contact from frames.

    Args:
        response: of a library with a design.
        contact_radius_mm: radius of the contact, mm.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        ambient: level of room sound, dB SPL; None for a quiet room.
        options: numbers that tune the search.
    """

    def __init__(
        self,
        response: ArrayResponse,
        contact_radius_mm: float,
        microphone_noise: NoiseChoice,
        ambient: float | None,
        options: PositionOptions = PositionOptions(),
    ) -> None:
        self._response, self._radius, self.options = response, contact_radius_mm, options
        self.pitch = pitch_of(response)
        top = min(options.top_frequency, float(response.frequency[-1]))
        # Cosines of a frame, 2 Hz apart: white noise stays white, and what lies above the library's end is left out.
        cosines = scipy.fft.dct(np.eye(FRAME), norm="ortho", axis=0)[: int(2 * FRAME * top / SAMPLE_RATE)]
        count = len(response.microphones)
        whole = _noise_covariance(response, response.noise(microphone_noise), ambient, options.top_frequency)
        both = np.kron(np.eye(count), cosines)
        lower = np.linalg.cholesky(both @ whole @ both.T)
        self._reduce = scipy.linalg.solve_triangular(lower, both, lower=True).T.copy()
        self._heard = self._sources(top)

    def _sources(self, top: float) -> Array:
        """Response of the microphones to each membrane, as a sum of white sources; (n_point, n_source, n)."""
        response = footprint_response(self._response, np.eye(self._response.point_count), top)
        lowest, top = self.options.lowest_frequency, min(top, float(response.frequency[-1]))
        frequency = np.arange(lowest, top + 1e-9, INTEGRATION_STEP)
        amplitude = np.sqrt(_contact_density(frequency, self.options.fall) * INTEGRATION_STEP)
        turn = np.exp(2j * np.pi * frequency[:, None] * np.arange(FRAME) / SAMPLE_RATE)
        heard = response.at(frequency)
        gram = np.zeros((2 * len(frequency),) * 2)
        for of_point in heard:
            waves = random_waves(of_point, amplitude, turn) @ self._reduce
            gram += waves @ waves.T
        energy, axes = np.linalg.eigh(gram)
        axes = axes[:, energy > self.options.faintest]
        return np.stack([axes.T @ (random_waves(each, amplitude, turn) @ self._reduce) for each in heard])

    def white(self, frames: Array) -> Array:
        """Frames (n, n_microphone, 250), Pa, where all noise is white of variance 1; (n, size)."""
        return np.asarray(frames.reshape(len(frames), -1) @ self._reduce)

    def reaches(self, place: Array) -> bool:
        """True if a contact at a place (2,) mm reaches a membrane."""
        return len(self._shares(place[None])[0]) > 0

    def slope(self, place: Array, x: Array, power: Array) -> Slope | None:
        """Log-likelihood of a place (2,) mm with its slope, of white frames (n, size) of powers (n,) together.

        None where the contact reaches no membrane.
        """
        step = self.options.slope_step * self.pitch
        on, share = self._shares(place + step * np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]]))
        if not len(on):
            return None
        heard = self._heard[on]
        sources = np.tensordot(share[0], heard, 1)
        turned = np.stack([share[1] - share[2], share[3] - share[4]]) / (2 * step)
        square = sources @ sources.T
        value, gradient, information = 0.0, np.zeros(2), np.zeros((2, 2))
        for frame, of_frame in zip(x, power, strict=True):
            lower = scipy.linalg.cholesky(square + np.eye(len(square)) / of_frame, lower=True, check_finite=False)
            source = scipy.linalg.cho_solve((lower, True), sources @ frame, check_finite=False)
            left = frame - source @ sources
            value -= 0.5 * (frame @ left + len(square) * np.log(of_frame)) + np.log(np.diag(lower)).sum()
            moved = turned @ np.einsum("psn,s->pn", heard, source)
            gradient += moved @ left
            known = scipy.linalg.solve_triangular(lower, sources @ moved.T, lower=True, check_finite=False)
            information += moved @ moved.T - known.T @ known
        return Slope(float(value), gradient, information)

    def likeliest(self, place: Array, x: Array) -> tuple[float, Array]:
        """Log-likelihood of a place (2,) mm at the likeliest power of each frame, nats, and these powers, (n,)."""
        power, energy, rest = self._spectrum(place, x)
        gain = np.outer(self.options.tried_powers, power)
        value = 0.5 * (energy @ (gain / (1 + gain)).T - np.log1p(gain).sum(1))
        return float((value.max(1) - 0.5 * (energy.sum(1) + rest)).sum()), self.options.tried_powers[value.argmax(1)]

    def along(self, places: Array, x: Array) -> Array:
        """Log-likelihoods of places (n, 2) mm, of white frames together, with noise as the best of them has it; (n,)
        nats.
        """
        best = max(places, key=lambda place: self.likeliest(place, x)[0])
        scaled = x / self.noise_scale(best, x)[:, None]
        return np.array([self.likeliest(place, scaled)[0] for place in places])

    def noise_scale(self, place: Array, x: Array) -> Array:
        """Factor by which the noise of each frame exceeds the given noise, if a contact is at a place (2,) mm; (n,)."""
        power, energy, rest = self._spectrum(place, x)
        gain = np.outer(self.options.tried_powers[::3], power)
        fit, lost = gain / (1 + gain), np.log1p(gain).sum(1)
        # (scale, power, frame)
        wide = self.options.noise_scales[:, None, None] ** 2
        value = (fit @ energy.T - (energy.sum(1) + rest)) / wide - lost[:, None]
        best = 0.5 * value.max(1) - x.shape[1] * np.log(self.options.noise_scales)[:, None]
        return np.asarray(self.options.noise_scales[best.argmax(0)])

    def _spectrum(self, place: Array, x: Array) -> tuple[Array, Array, Array]:
        """Powers of the sources of a place, (n_source,), energies of frames along them, (n, n_source), and the rest."""
        on, share = self._shares(place[None])
        sources = np.tensordot(share[0], self._heard[on], 1)
        power, axes = np.linalg.eigh(sources @ sources.T)
        power = np.maximum(power, self.options.faintest * 1e-6)
        energy = (x @ sources.T @ axes) ** 2 / power
        return power, energy, (x**2).sum(1) - energy.sum(1)

    def _shares(self, place: Array) -> tuple[NDArray[np.int64], Array]:
        """Membranes that are covered from any of the places (n, 2) mm, and their shares, of norm 1; (n, n_covered)."""
        share = fractions_at(self._response, self._radius, place)
        on = np.flatnonzero(share.any(0))
        return on, share[:, on] / np.maximum(np.linalg.norm(share[:, on], axis=1, keepdims=True), 1e-12)


def _contact_density(frequency: Array, fall: float) -> Array:
    """Power density of a contact of power 1, Pa^2/Hz."""
    fallen = (BAND[1] / np.maximum(frequency, BAND[1])) ** fall
    return np.asarray(SOURCE_RMS**2 / (BAND[1] - BAND[0]) * fallen)


def _noise_covariance(
    response: ArrayResponse, noise: float | NoiseSpectrum, ambient: float | None, top: float
) -> Array:
    """Covariance of noise, hum and sound in the samples of a frame, microphone by microphone, Pa^2."""
    lag = np.arange(FRAME)[:, None] / SAMPLE_RATE
    if isinstance(noise, NoiseSpectrum):
        at_lag = np.cos(2 * np.pi * lag * np.arange(len(noise.power))) @ noise.power
    else:
        at_lag = noise**2 * (lag[:, 0] == 0)
    lines = np.outer(np.arange(1, int(top / max(MAINS)) + 1), MAINS).ravel()
    at_lag = at_lag + HUM**2 * np.cos(2 * np.pi * lag * lines).sum(1)
    alone = np.kron(np.eye(len(response.microphones)), scipy.linalg.toeplitz(at_lag))
    if ambient is None:
        return np.asarray(alone)
    heard, amplitude, frequency = ambient_waves(response, ambient)
    waves = random_waves(heard, amplitude, np.exp(2j * np.pi * frequency[:, None] * lag[:, 0]))
    return np.asarray(alone + waves.T @ waves)
