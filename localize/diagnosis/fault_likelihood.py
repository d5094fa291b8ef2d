r"""Likelihood of touches on a sensor with a fault, whatever its scatter, its air and the points of the touches.

A touch at a point is a source s(f) of any spectrum: x = h s + e at the microphones, whose noise is white of variance
1. The best source leaves r = x - h (h^H x) / |h|^2, which has as many components as there are microphones, less one.
Their variance is that of the noise and of a mismatch, a fraction of each microphone's own signal. Deviations z of the
sensor, standard normal and common to all touches, change h, so r changes by -P (dh/dz) s, with P the projection off h
(variable projection; Golub and Pereyra 1973). Each fault is fitted by Gauss-Newton steps over z, and in each step every
touch takes its likeliest point. The evidence is the Laplace approximation of the integral over z.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import scipy.linalg
import scipy.special
from numpy.typing import NDArray

from geometry.ground.typed import Array, ComplexArray
from localize.diagnosis.fault_libraries import Tables
from localize.diagnosis.touch_spectra import TouchSpectra

LONGEST_STEP, FARTHEST = 2.0, 3.5
"""Longest step, and largest value, of a deviation, standard deviations."""
TOGETHER = 16
"""Number of fits that are worked on at once: with more, their arrays leave the processor's cache."""
FACTORS = 12
"""Number of variances that are multiplied before a logarithm is taken."""


@dataclass(frozen=True, eq=False)
class Fitted:
    """A hypothesis, fitted to touches."""

    evidence: float
    """Logarithm of the evidence, nats, up to a constant that all hypotheses share."""
    peak: float
    """Log-likelihood with the prior, at the deviations, nats, up to the same constant."""
    deviations: Array
    """Most probable deviations, (n_deviation,) float64, standard deviations."""
    point: NDArray[np.int64]
    """Index of the likeliest point of each touch, (n_touch,) int64."""
    misfit: float
    """Mean square of the residual over its expected variance, a ratio."""
    precision: Array
    """Inverse of the covariance of the deviations, (n_deviation, n_deviation) float64."""


class Begin(NamedTuple):
    """Where a fit begins."""

    tables: Tables
    """Tables of the hypothesis, about some deviations."""
    deviations: Array | None = None
    """Deviations, (n_deviation,) float64; None begins with those of the tables, and counts them as noise of each
    frequency on its own where the first points are chosen."""
    point: NDArray[np.int64] | None = None
    """Index of the point of each touch, (n_touch,) int64, which stays to the end; None for the likeliest ones of each
    step."""


class TouchLikelihood:
    """Likelihood of the touches of a recording.

    Args:
        spectra: of the touches.
        known: index of the point of each touch, (n_touch,) int64; -1 where it is not known.
        mismatch: fraction of a microphone's signal that even the correct sensor does not explain.
        temperature: divisor of log-likelihoods where they become probabilities.
    """

    def __init__(
        self, spectra: TouchSpectra, known: NDArray[np.int64], mismatch: float, temperature: float = 1.0
    ) -> None:
        self.spectra, self.known = spectra, known
        self._mismatch, self._temperature = mismatch, temperature
        self._x = spectra.spectrum
        self._pairs = np.triu_indices(self._x.shape[1], 1)
        one, other = (self._x[:, each] for each in self._pairs)
        square, product = np.abs(self._x) ** 2, 2 * one * other.conj()
        parts = np.concatenate([square, product.real, -product.imag], axis=1)  # (n_window, n_microphone^2, n_freq)
        self._products = np.ascontiguousarray(parts.transpose(2, 1, 0))
        self._power = np.ascontiguousarray(square.sum(1).T)[:, None]  # (n_freq, 1, n_window)
        self._of_touch = np.eye(len(spectra.start))[spectra.touch]  # (n_window, n_touch)

    def by_point(self, h: ComplexArray, spread: ComplexArray | None, mismatch: float) -> Array:
        """Log-likelihoods of each touch at each point.

        Args:
            h: (..., n_point, n_microphone, n_freq) complex128.
            spread: covariance of the logarithms of h over those of the first microphone, (..., n_point,
                n_microphone - 1, n_microphone - 1, n_freq) complex128.
            mismatch: fraction of a microphone's signal that even the correct sensor does not explain.

        Returns:
            (..., n_touch, n_point) float64.
        """
        h = h / self.spectra.noise
        power = h.real**2 + h.imag**2
        whole, free = power.sum(-2), h.shape[-2] - 1
        own = mismatch**2 * (whole - (power**2).sum(-2) / whole) / free
        if spread is not None:
            diagonal = np.einsum("...mmf->...mf", spread).real
            others = power[..., 1:, :]
            pairs = others[..., :, None, :] * spread.real * others[..., None, :, :]
            own = own + np.maximum((others * diagonal).sum(-2) - pairs.sum((-3, -2)) / whole, 0.0) / free
        # The power along h is a sum over the products of two microphones each.
        one, other = self._pairs
        products = h[..., one, :].conj() * h[..., other, :] / whole[..., None, :]
        parts = np.concatenate([power / whole[..., None, :], products.real, products.imag], axis=-2)
        # (..., n_freq, n_point, n_window)
        explained = np.ascontiguousarray(np.moveaxis(parts, -1, -3)) @ self._products
        residual = np.maximum(self._power - explained, 0.0)
        explained *= np.swapaxes(own / whole, -1, -2)[..., None]
        variance = np.add(explained, 1.0, out=explained)
        residual /= variance
        score = residual.sum(-3)
        # Logarithms take long, and a product of so many variances does not overflow.
        for first in range(0, h.shape[-1], FACTORS):
            score += free * np.log(variance[..., first : first + FACTORS, :, :].prod(-3))
        return np.asarray(-np.swapaxes(score @ self._of_touch, -1, -2))

    def fitted(self, begun: Sequence[Begin], mismatches: Sequence[float]) -> list[Fitted]:
        """Fits of hypotheses.

        Args:
            begun: where each fit begins.
            mismatches: mismatch of each step, descending to that of the likelihood: with a large one the first points
                need not be right.
        """
        found: list[Fitted] = []
        for first in range(0, len(begun), TOGETHER):
            found += self._fitted(begun[first : first + TOGETHER], mismatches)
        return found

    def _fitted(self, begun: Sequence[Begin], mismatches: Sequence[float]) -> list[Fitted]:
        tables = [each.tables for each in begun]
        deviations = np.stack(
            [each.tables.deviations if each.deviations is None else each.deviations for each in begun]
        )
        given = np.array([each.point is not None for each in begun])
        free = np.full(len(self.known), -1)
        point = np.stack([free if each.point is None else each.point for each in begun])
        first = np.array([each.point is None and each.deviations is None for each in begun])
        for number, mismatch in enumerate(mismatches):
            now = np.stack([each.at(own) for each, own in zip(tables, deviations, strict=True)])
            if not given.all():
                likeliest = self._points(now, ~given & ~first if not number else ~given, mismatch)
                if not number and first.any():
                    own = np.flatnonzero(first)
                    spread = np.stack([tables[k].spread for k in own])
                    likeliest[own] = self.by_point(now[own], spread, mismatch).argmax(-1)
                point = np.where(given[:, None], point, likeliest)
            point = np.where(self.known >= 0, self.known, point)
            change = self._steps(tables, now, point, deviations, mismatch).change
            deviations = np.clip(deviations + np.clip(change, -LONGEST_STEP, LONGEST_STEP), -FARTHEST, FARTHEST)
        now = np.stack([each.at(own) for each, own in zip(tables, deviations, strict=True)])
        by_point = self.by_point(now, None, self._mismatch)
        point = np.where(self.known >= 0, self.known, by_point.argmax(-1))
        last = self._steps(tables, now, point, deviations, self._mismatch)
        more = self._of_other_points(by_point)
        return [
            Fitted(
                float(last.evidence[k] + more[k]),
                float(last.peak[k] + more[k]),
                deviations[k],
                point[k],
                float(last.misfit[k]),
                last.precision[k],
            )
            for k in range(len(begun))
        ]

    def _of_other_points(self, by_point: Array) -> Array:
        """Evidence beside that of the likeliest points, (n_fit,) float64: touches are spread over all points.

        A sensor on which only some points explain the touches is less likely than one on which any do, such as a dead
        microphone against a leak beside it.

        Args:
            by_point: log-likelihoods (n_fit, n_touch, n_point) float64.
        """
        scores = by_point[:, self.known < 0] / self._temperature
        return self._temperature * (scipy.special.logsumexp(scores, axis=-1) - scores.max(-1)).sum(-1)

    def _points(self, h: ComplexArray, asked: NDArray[np.bool_], mismatch: float) -> NDArray[np.int64]:
        """Likeliest points of the fits that ask for them, (n_fit, n_touch) int64."""
        found = np.full((len(h), len(self.known)), -1)
        if asked.any():
            found[asked] = self.by_point(h[asked], None, mismatch).argmax(-1)
        return found

    def _steps(
        self, tables: Sequence[Tables], now: ComplexArray, point: NDArray[np.int64], deviations: Array, mismatch: float
    ) -> _Steps:
        """Evidence of fits at some deviations, and the Gauss-Newton steps from there."""
        count, free = len(now), self._x.shape[1] - 1
        of_window = point[:, self.spectra.touch]  # (n_fit, n_window)
        h = now / self.spectra.noise  # (n_fit, n_point, n_microphone, n_freq)
        power = h.real**2 + h.imag**2
        whole = power.sum(2)
        own = mismatch**2 * (whole - (power**2).sum(2) / whole) / free
        unit = across(h.reshape(-1, *h.shape[2:])).reshape(*h.shape[:2], free, *h.shape[2:])
        row = np.arange(count)[:, None]
        source = (h.conj()[row, of_window] * self._x).sum(2) / whole[row, of_window]  # (n_fit, n_window, n_freq)
        residual = (unit[row, of_window] * self._x[:, None]).sum(3)  # (n_fit, n_window, free, n_freq)
        square = (residual.real**2 + residual.imag**2).sum(2)
        loudness = source.real**2 + source.imag**2
        variance = 1.0 + loudness * own[row, of_window]
        expected = square / variance
        score = -(expected + free * np.log(variance)).sum((1, 2))
        misfit = expected.mean((1, 2)) / free
        # Sums over the windows of each point, because the derivatives are those of the point.
        members = (of_window[:, None] == np.arange(h.shape[1])[:, None]).astype(np.float64)
        weight = np.sqrt(members @ (loudness / variance))  # (n_fit, n_point, n_freq)
        force = source.conj()[:, :, None] * residual / variance[:, :, None]
        pull = (members @ force.reshape(count, len(self._x), -1)).reshape(*weight.shape[:2], free, -1)
        pull /= np.maximum(weight, 1e-150)[:, :, None]
        # Across h, the derivative of the first microphone can be taken off all, so it is not needed.
        turned = (unit[:, :, :, 1:] * h[:, :, None, 1:]) * weight[:, :, None, None]
        size = deviations.shape[1]
        slope, change, roots = np.empty((3, count, size))
        precision, prior = np.empty((count, size, size)), np.eye(size)
        changed = np.empty((size, h.shape[1], free, h.shape[3]), np.complex128)
        flat, pulls = changed.reshape(size, -1).view(np.float64), pull.reshape(count, -1).view(np.float64)
        for number, each in enumerate(tables):
            each.derivatives_times(turned[number], changed)
            np.dot(flat, pulls[number], out=slope[number])
            np.dot(flat, flat.T, out=precision[number])
            slope[number] = 2 * slope[number] - deviations[number]
            precision[number] = 2 * precision[number] + prior
            root, change[number], failed = scipy.linalg.lapack.dposv(precision[number], slope[number], lower=1)
            if failed:
                raise np.linalg.LinAlgError(f"the precision of {each.fault} is not positive definite")
            roots[number] = np.diagonal(root)
        peak = score - 0.5 * (deviations**2).sum(1)
        evidence = peak + 0.5 * (slope * change).sum(1) - np.log(roots).sum(1)
        return _Steps(evidence, peak, misfit, precision, change)


class _Steps(NamedTuple):
    """Fits at some deviations, and the steps from there."""

    evidence: Array
    """As :attr:`Fitted.evidence`, (n_fit,) float64."""
    peak: Array
    """As :attr:`Fitted.peak`, (n_fit,) float64."""
    misfit: Array
    """As :attr:`Fitted.misfit`, (n_fit,) float64."""
    precision: Array
    """As :attr:`Fitted.precision`, (n_fit, n_deviation, n_deviation) float64."""
    change: Array
    """Change of the deviations, (n_fit, n_deviation) float64."""


def across(h: ComplexArray) -> ComplexArray:
    """Conjugates of unit vectors across h and each other, by a Householder reflection.

    Args:
        h: (n_point, n_microphone, n_freq) complex128.

    Returns:
        (n_point, n_microphone - 1, n_microphone, n_freq) complex128.
    """
    power = h.real**2 + h.imag**2
    unit = h / np.sqrt(power.sum(1, keepdims=True))
    phasor = h[:, :1] / np.maximum(np.sqrt(power[:, :1]), 1e-150)
    unit = unit * phasor.conj()
    first, others = unit[:, 0].real, unit[:, 1:]
    found = np.empty((len(h), h.shape[1] - 1, *h.shape[1:]), np.complex128)
    found[:, :, 0] = -others
    found[:, :, 1:] = -others[:, :, None] * others[:, None].conj() / (1 + first)[:, None, None]
    for k in range(h.shape[1] - 1):
        found[:, k, 1 + k] += 1
    return found
