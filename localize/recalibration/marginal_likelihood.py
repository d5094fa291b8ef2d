"""How likely unlabelled touches are on a sensor, and the derivative by its transfer functions.

A frame of an unknown point has the likelihood of the Bayes decoder (:mod:`localize.decoders.bayes`), the power g
profiled for each point, summed over the points, all equally likely beforehand. The derivative of its logarithm by the
covariances is that of a Gaussian's (g is at its maximum and adds nothing), and is worked out by hand down to the
transfer functions; from there to the parameters of a sensor it is left to torch.

The noise that is assumed is white and stands for what a model does not know as well. Where it is high, neighbouring
points blur into each other and the likelihood has one maximum; the lower, the sharper it is.

Powers are counted from the loudness of the frames, so that louder touches say the same of a sensor, where the noise
that is assumed is as much louder.

Fingers have no flat spectrum, and each touch has its own: a tap of 5 ms holds all frequencies alike, a press little
above the inverse of its rise. Spectra that fall are tried beside the flat one, each as likely as the others beforehand,
and summed out as the points are.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy.signal
from numpy.typing import NDArray
from scipy.special import logsumexp

from acoustic_fem.numerics.frequency_splines import interpolation
from geometry.ground.typed import Array
from localize.decoders.frame_covariance import low_pass, sampled_waves, source_density, whitening
from localize.live.front_end import high_pass_sections
from localize.recalibration.recalibration_options import RecalibrationOptions
from localize.signals.stimulus import BAND, SAMPLE_RATE
from localize.signals.threads import one_thread

Complex = NDArray[np.complex128]

FLAT = (0.0,)
"""Slopes of touches that fill the band evenly."""


@dataclass(frozen=True, eq=False)
class Evidence:
    """Evidence of frames for one sensor."""

    frames: Array
    """Log-likelihood of each frame, divided by the decoder's temperature; (n,) float64, nats."""
    probability: Array
    """Probability of each point, each row summing to 1; (n, n_point) float64."""


@dataclass(frozen=True, eq=False)
class _Eigen:
    """Covariances of touches C = B^T B, slope by slope and point by point: a table for each."""

    b: Array
    values: Array
    vectors: Array


@dataclass(frozen=True, eq=False)
class _Score:
    """Frames and tables that are near each other, with what the likelihood of each pair is made of."""

    evidence: Evidence
    along: Array
    """(n_table, n, size) of the frames along the eigenvectors."""
    frame: NDArray[np.int64]
    table: NDArray[np.int64]
    power: Array
    weight: Array
    """Probability of the table given the frame."""


class MarginalLikelihood:
    """Log-likelihood of unlabelled frames at one level of noise.

    Args:
        frequency: (n_freq,) float64, Hz, of the transfer functions, covering 1 to 100 Hz.
        frames: (n, n_microphone, 250) float64, Pa, at 1 kHz.
        noise: Pa rms over 0 to 500 Hz, white, above 0.
        slopes: of the amplitude of touches over frequency, as exponents of the frequency, one or more.
        high_pass: corner of the high-pass that the frames have passed, Hz; None for none.
        options: of the calibration.
    """

    def __init__(
        self,
        frequency: Array,
        frames: Array,
        noise: float,
        slopes: Sequence[float] = FLAT,
        high_pass: float | None = None,
        options: RecalibrationOptions = RecalibrationOptions(),
    ) -> None:
        self.noise, self.options = noise, options
        self._temperature, self._powers = options.decoder.temperature, options.decoder.tried_powers
        fine = np.arange(BAND[0], min(float(frequency[-1]), SAMPLE_RATE / 2) + 1e-9, options.frequency_step)
        turn, gain = sampled_waves(fine)
        whiten = whitening(noise)
        amplitude = np.sqrt(source_density(fine) * options.frequency_step) * gain * high_pass_gain(fine, high_pass)
        by_slope = np.stack([amplitude * fine**slope for slope in slopes])
        waves = by_slope[..., None] * (turn @ whiten.T)
        white = frames @ (whiten @ low_pass()).T
        # power 1 is that of half of the frames, at their loudest microphone and where H = 1
        loudness = np.median((white**2).sum(2).max(1))
        waves *= np.sqrt(loudness / (np.abs(waves) ** 2).sum((1, 2), keepdims=True))
        # directions that no touch moves hold noise alone, whatever the sensor
        flat = waves.reshape(-1, waves.shape[2])
        _, size, basis = np.linalg.svd(np.concatenate([flat.real, flat.imag]), full_matrices=False)
        basis = basis[size**2 > options.moved_fraction]
        self._waves = waves @ basis.T
        self._x = (white @ basis.T).reshape(len(frames), -1)
        self._even, self._odd = interpolation(frequency, fine)

    @one_thread()
    def evidence(self, h: Complex) -> Evidence:
        """Evidence of the frames for a sensor.

        Args:
            h: (n_point, n_microphone, n_freq) complex128, transfer functions, Pa/Pa.
        """
        return self._score(self._eigen(h)).evidence

    @one_thread()
    def slope(self, h: Complex) -> tuple[float, Complex]:
        """Log-likelihood of all frames, and its derivative: that by the real part of h + j that by the imaginary part.

        Args:
            h: (n_point, n_microphone, n_freq) complex128, transfer functions, Pa/Pa.

        Returns:
            Log-likelihood, nats, and (n_point, n_microphone, n_freq) complex128, nats per Pa/Pa.
        """
        eigen = self._eigen(h)
        found = self._score(eigen)
        weight = found.weight / self._temperature
        slope = np.zeros(h.shape, np.complex128)
        for table, (b, values, vectors) in enumerate(zip(eigen.b, eigen.values, eigen.vectors, strict=True)):
            chosen = found.table == table
            if not chosen.any():
                continue
            g, share = found.power[chosen][:, None], weight[chosen][:, None]
            inverse = 1 / (1 + g * values)
            seen = np.sqrt(share * g) * inverse * found.along[table][found.frame[chosen]]
            by_covariance = 0.5 * (seen.T @ seen - np.diag((share * g * inverse).sum(0)))
            by_b = b @ (2 * vectors @ by_covariance @ vectors.T)  # b is the tallest: it is multiplied once
            kind, point = divmod(table, len(h))
            slope[point] += self._by_response(by_b, kind)
        return float(found.evidence.frames.sum()), slope

    @one_thread()
    def information(self, h: Complex, jacobian: Complex) -> Array:
        """Fisher information on parameters of touches as loud as these, at the points that each may be of.

        For a Gaussian of covariance S it is tr(S^-1 dS_a S^-1 dS_b) / 2 per frame. The power of a touch is fitted with
        the parameters (its derivative is dS = C), so that its fraction is taken out (Schur complement): touches of
        unknown loudness carry no information on anything that makes a whole point louder, such as the common level of
        the microphones. Each point of a frame counts by its probability, as if it were known. A point that no frame may
        be of, or no frame above the noise, carries no information.

        Args:
            h: (n_point, n_microphone, n_freq) complex128, transfer functions, Pa/Pa.
            jacobian: (count, n_point, n_microphone, n_freq) complex128, their derivatives by the parameters, Pa/Pa per
                unit of the parameters.

        Returns:
            (count, count) float64, nats per square of that unit.
        """
        total = np.zeros((len(jacobian), len(jacobian)))
        every = self.options.information_steps
        found = self._score(self._eigen(h))
        eigen = self._eigen(h, every)
        energy = (self._x**2).sum(1)
        for table, (b, values, vectors) in enumerate(zip(eigen.b, eigen.values, eigen.vectors, strict=True)):
            chosen = (found.table == table) & (found.weight > 0)
            if not chosen.any():
                continue
            weight = found.weight[chosen]
            kind, point = divmod(table, len(h))
            # with a wrong sensor the likeliest power may be thousands of times that which is in the frame
            power = np.minimum(found.power[chosen], energy[found.frame[chosen]] / values.sum())[:, None]
            held = power.max() * values > self.options.held_fraction
            if not held.any():
                continue
            # single precision halves the time, and what comes of it only steers and weighs
            along = (b @ vectors[:, held]).astype(np.float32)
            change = along.T @ (
                self._sources(jacobian[:, point], kind, every).astype(np.float32) @ vectors.astype(np.float32)
            )
            # of each touch: g / (1 + g value), of S^-1 along the eigenvectors; C is diagonal along them too
            inverse = power / (1 + power * values)
            seen = np.sqrt((inverse[:, held] * weight[:, None]).T @ inverse).astype(np.float32)
            inside = change[..., held]
            both = inside + inside.transpose(0, 2, 1)
            louder = (inverse * values)[:, held]
            with_louder = 0.5 * np.einsum("akk->ak", both) @ (inverse[:, held] * louder).T
            both = (both * seen[:, held]).reshape(len(jacobian), -1)
            rest = (change * seen)[..., ~held].reshape(len(jacobian), -1)
            total += 0.5 * (both @ both.T) + rest @ rest.T
            total -= 2 * (with_louder * (weight / (louder**2).sum(1))) @ with_louder.T
        return total / self._temperature

    def _sources(self, h: Complex, kind: int, every: int = 1) -> Array:
        """B of (..., n_microphone, n_freq) transfer functions and one of the slopes, (..., 2 n_step, size)."""
        fine = h.real @ self._even[::every].T + 1j * (h.imag @ self._odd[::every].T)
        waves = np.sqrt(every) * self._waves[kind, ::every]
        seen = (np.moveaxis(fine, -1, -2)[..., None] * waves[:, None]).reshape(*fine.shape[:-2], len(waves), -1)
        return np.concatenate([seen.real, seen.imag], axis=-2)

    def _by_response(self, by_b: Array, kind: int) -> Complex:
        """The derivative by transfer functions, (n_microphone, n_freq), from that by B: the transpose of the above."""
        waves = self._waves[kind]
        steps = len(waves)
        by_wave = (by_b[:steps] + 1j * by_b[steps:]).reshape(steps, -1, waves.shape[1])
        by_fine = np.einsum("fms,fs->mf", by_wave, waves.conj())
        return np.asarray(by_fine.real @ self._even + 1j * (by_fine.imag @ self._odd))

    def _eigen(self, h: Complex, every: int = 1) -> _Eigen:
        b = np.concatenate([self._sources(h, kind, every) for kind in range(len(self._waves))])
        values, vectors = np.linalg.eigh(b.transpose(0, 2, 1) @ b)
        return _Eigen(b, np.maximum(values, 0), vectors)

    def _score(self, eigen: _Eigen) -> _Score:
        along = self._x @ eigen.vectors
        energy = along**2
        gain = eigen.values[..., None] * self._powers
        tried = -(energy @ (1 / (1 + gain)) + np.log1p(gain).sum(1)[:, None]).transpose(1, 0, 2)
        start = tried.argmax(-1)
        rough = np.take_along_axis(tried, start[..., None], -1)[..., 0] / (2 * self._temperature)
        frame, table = np.nonzero(rough > rough.max(1, keepdims=True) - self.options.near_points)
        level, near, held = np.log(self._powers[start[frame, table]]), energy[table, frame], eigen.values[table]
        for _ in range(self.options.power_steps):
            share = np.exp(level)[:, None] * held
            share /= 1 + share
            first = ((near * (1 - share) - 1) * share).sum(1)
            second = ((near * (1 - 2 * share) - 1) * share * (1 - share)).sum(1)
            # steps stay within the spacing of the powers tried, and where the curve bends upwards they only climb
            step = np.where(second < 0, -first / np.minimum(second, -1e-12), np.sign(first))
            level = np.clip(level + np.clip(step, -1, 1), np.log(self._powers[0]), np.log(self._powers[-1]))
        gain = np.exp(level)[:, None] * held
        fine = np.full(rough.shape, -np.inf)
        fine[frame, table] = -(near / (1 + gain) + np.log1p(gain)).sum(1) / (2 * self._temperature)
        value = logsumexp(fine, axis=1)
        share = np.exp(fine - value[:, None])
        by_point = share.reshape(len(share), len(self._waves), -1).sum(1)
        return _Score(
            Evidence(value - np.log(len(energy)), by_point), along, frame, table, np.exp(level), share[frame, table]
        )


def high_pass_gain(frequency: Array, high_pass: float | None) -> Array:
    """Gain of the high-pass of :class:`localize.live.front_end.HighPass`.

    Args:
        frequency: (n,) float64, Hz.
        high_pass: its corner, Hz; None for none.

    Returns:
        (n,) float64.
    """
    if high_pass is None:
        return np.ones(len(frequency))
    _, gain = scipy.signal.sosfreqz(high_pass_sections(high_pass), frequency, fs=SAMPLE_RATE)
    return np.asarray(np.abs(gain))
