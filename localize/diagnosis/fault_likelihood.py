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

import numpy as np
import scipy.linalg
from numpy.typing import NDArray

from geometry.ground.typed import Array, ComplexArray
from localize.diagnosis.fault_libraries import Tables
from localize.diagnosis.touch_spectra import TouchSpectra

LONGEST_STEP, FARTHEST = 2.0, 3.5
"""Longest step, and largest value, of a deviation, standard deviations."""


@dataclass(frozen=True, eq=False)
class Fitted:
    """A hypothesis, fitted to touches."""

    evidence: float
    """Logarithm of the evidence, nats, up to a constant that all hypotheses share."""
    deviations: Array
    """Most probable deviations, (n_deviation,) float64, standard deviations."""
    point: NDArray[np.int64]
    """Index of the likeliest point of each touch, (n_touch,) int64."""
    misfit: float
    """Mean square of the residual over its expected variance, a ratio."""
    precision: Array
    """Inverse of the covariance of the deviations, (n_deviation, n_deviation) float64."""


class TouchLikelihood:
    """Likelihood of the touches of a recording.

    Args:
        spectra: of the touches.
        known: index of the point of each touch, (n_touch,) int64; -1 where it is not known.
        mismatch: fraction of a microphone's signal that even the correct sensor does not explain.
    """

    def __init__(self, spectra: TouchSpectra, known: NDArray[np.int64], mismatch: float) -> None:
        self.spectra, self.known, self._mismatch = spectra, known, mismatch
        self._x = spectra.spectrum
        self._by_frequency = np.ascontiguousarray(self._x.transpose(2, 1, 0))  # (n_freq, n_microphone, n_window)
        self._power = (np.abs(self._x) ** 2).sum(1)  # (n_window, n_freq)
        self._of_touch = np.eye(len(spectra.start))[spectra.touch].T

    def by_point(self, h: ComplexArray, spread: ComplexArray | None, mismatch: float) -> Array:
        """(n_touch, n_point) log-likelihoods; ``spread`` is the covariance of the logarithms of h."""
        h = h / self.spectra.noise
        power = np.abs(h) ** 2  # (n_point, n_microphone, n_freq)
        whole = power.sum(1)
        free = h.shape[1] - 1
        own = mismatch**2 * (whole - (power**2).sum(1) / whole) / free
        if spread is not None:
            diagonal = np.einsum("pmmf->pmf", spread).real
            across = np.einsum("pmf,pmnf,pnf->pf", power, spread, power).real / whole
            own = own + np.maximum((power * diagonal).sum(1) - across, 0.0) / free
        along = h.conj().transpose(2, 0, 1) @ self._by_frequency  # (n_freq, n_point, n_window)
        explained = (along.real**2 + along.imag**2) / whole.T[:, :, None]
        residual = np.maximum(self._power.T[:, None] - explained, 0.0)
        variance = 1.0 + explained * (own / whole).T[:, :, None]
        score = -(residual / variance + free * np.log(variance)).sum(0)  # (n_point, n_window)
        return self._of_touch @ score.T

    def fitted(
        self,
        tables: Tables,
        mismatches: Sequence[float],
        deviations: Array | None = None,
        point: NDArray[np.int64] | None = None,
    ) -> Fitted:
        """Fit a hypothesis.

        Args:
            tables: of the hypothesis, about some deviations.
            mismatches: mismatch of each step, descending to that of the likelihood: with a large one the first points
                need not be right.
            deviations: to begin with; None begins with those of the tables, and counts them as noise of each frequency
                on its own where the first points are chosen.
            point: index of the point of each touch, which stays to the end; None for the likeliest ones of each step.
        """
        spread, given = tables.spread if deviations is None else None, point is not None
        deviations = tables.deviations if deviations is None else deviations
        for number, mismatch in enumerate(mismatches):
            now = tables.at(deviations)
            if not given or point is None:
                point = self._points(now, None if number else spread, mismatch)
            point = np.where(self.known >= 0, self.known, point)
            _, change = self._step(tables, now, point, deviations, mismatch)
            deviations = np.clip(deviations + np.clip(change, -LONGEST_STEP, LONGEST_STEP), -FARTHEST, FARTHEST)
        now = tables.at(deviations)
        point = self._points(now, None, self._mismatch)
        return self._step(tables, now, point, deviations, self._mismatch)[0]

    def _points(self, h: ComplexArray, spread: ComplexArray | None, mismatch: float) -> NDArray[np.int64]:
        likeliest = self.by_point(h, spread, mismatch).argmax(1)
        return np.where(self.known >= 0, self.known, likeliest)

    def _step(
        self, tables: Tables, now: ComplexArray, point: NDArray[np.int64], deviations: Array, mismatch: float
    ) -> tuple[Fitted, Array]:
        """Evidence at some deviations, and the Gauss-Newton step from there."""
        size, free = len(deviations), self._x.shape[1] - 1
        of_windows = point[self.spectra.touch]
        is_touched = np.zeros(len(now), bool)
        is_touched[of_windows] = True
        touched, of_window = np.flatnonzero(is_touched), (np.cumsum(is_touched) - 1)[of_windows]
        h = now[touched] / self.spectra.noise  # (n_touched, n_microphone, n_freq)
        power = np.abs(h) ** 2
        whole = power.sum(1)
        own = mismatch**2 * (whole - (power**2).sum(1) / whole) / free
        beside, unit = h[of_window], across(h)
        source = (beside.conj() * self._x).sum(1) / whole[of_window]  # (n_window, n_freq)
        residual = (unit[of_window] * self._x[:, None]).sum(2)  # (n_window, free, n_freq)
        square, loudness = (np.abs(residual) ** 2).sum(1), np.abs(source) ** 2
        variance = 1.0 + loudness * own[of_window]
        score = -float((square / variance + free * np.log(variance)).sum())
        misfit = float((square / variance).mean()) / free
        # Sums over the windows of each point, because the derivatives are those of the point.
        members = np.eye(len(touched))[of_window].T
        weight = np.sqrt(members @ (loudness / variance))  # (n_touched, n_freq)
        pull = np.tensordot(members, source.conj()[:, None] * residual / variance[:, None], 1)
        pull /= np.maximum(weight, 1e-150)[:, None]
        # Across h, the derivative of the first microphone can be taken off all, so it is not needed.
        turned = (unit[:, :, 1:] * h[:, None, 1:]) * weight[:, None, None]  # (n_touched, free, free, n_freq)
        derivatives = tables.relative[:, touched]
        changed = np.sum([derivatives[:, :, None, k] * turned[:, :, k] for k in range(free)], axis=0)
        flat = np.ascontiguousarray(changed).reshape(size, -1).view(np.float64)
        slope = 2 * (flat @ pull.ravel().view(np.float64)) - deviations
        precision = 2 * (flat @ flat.T)
        precision[np.diag_indices(size)] += 1.0
        root, _ = scipy.linalg.cho_factor(precision, lower=True, check_finite=False)
        change = scipy.linalg.cho_solve((root, True), slope, check_finite=False)
        evidence = score - 0.5 * float(deviations @ deviations) + 0.5 * float(slope @ change)
        evidence -= float(np.log(np.diagonal(root)).sum())
        return Fitted(evidence, deviations, point, misfit, precision), np.asarray(change, np.float64)


def across(h: ComplexArray) -> ComplexArray:
    """Conjugates of unit vectors across h and each other, by a Householder reflection.

    Args:
        h: (n_point, n_microphone, n_freq) complex128.

    Returns:
        (n_point, n_microphone - 1, n_microphone, n_freq) complex128.
    """
    unit = h / np.sqrt((np.abs(h) ** 2).sum(1, keepdims=True))
    phasor = unit[:, :1] / np.maximum(np.abs(unit[:, :1]), 1e-150)
    unit = unit * phasor.conj()
    first, others = unit[:, 0].real, unit[:, 1:]
    found = np.empty((len(h), h.shape[1] - 1, *h.shape[1:]), np.complex128)
    found[:, :, 0] = -others
    found[:, :, 1:] = -others[:, :, None] * others[:, None].conj() / (1 + first)[:, None, None]
    for k in range(h.shape[1] - 1):
        found[:, k, 1 + k] += 1
    return found
