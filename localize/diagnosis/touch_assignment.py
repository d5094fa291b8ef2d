r"""Points of all touches together, with the deviations of the sensor integrated over instead of fitted.

A sensor whose points are all taken for their neighbours explains most touches, so a fit that begins with the likeliest
point of each touch can end there. Here the deviations z of a hypothesis stay uncertain: a Gaussian with precision
:math:`\Lambda` and linear term :math:`\eta`, at first the prior. Touch t at point p adds :math:`G_{tp}` and
:math:`b_{tp}` of its linearised residual, and its marginal likelihood given the touches before is

.. math:: c_{tp} + (\eta + b)^T (\Lambda + G)^{-1} (\eta + b) / 2 - \eta^T \Lambda^{-1} \eta / 2
          - \log(|\Lambda + G| / |\Lambda|) / 2

Touches are taken one after the other, and the likeliest assignments of those so far are kept (beam search).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.diagnosis.fault_libraries import Tables
from localize.diagnosis.fault_likelihood import TouchLikelihood, across

WITHIN = 60.0
"""Lead of the likeliest point of a touch alone, nats, beyond which a point is not tried."""
LEAST = 0.03
"""Information about a combination of deviations by all touches below which touches do not determine it."""


def likeliest_assignments(
    likelihood: TouchLikelihood, tables: Tables, deviations: Array, mismatch: float, kept: int
) -> list[NDArray[np.int64]]:
    """Likeliest points of all touches on a sensor of one hypothesis, the best assignment first, (n_touch,) int64 each.

    Args:
        likelihood: of the touches.
        tables: of the hypothesis.
        deviations: about which the residuals are linearised, (n_deviation,), in standard deviations.
        mismatch: fraction of a microphone's signal that even the correct sensor does not explain.
        kept: number of assignments that are kept.
    """
    score, information, pull, prior = _linearised(likelihood, tables, deviations, mismatch)
    touches, points, size = pull.shape
    allowed = np.ones((touches, points), bool)
    stated = likelihood.known >= 0
    allowed[stated] = np.eye(points, dtype=bool)[likelihood.known[stated]]
    alone = np.where(allowed, log_integral(np.eye(size) + information, prior + pull) + score, -np.inf)
    ranked = np.sort(alone, axis=1)
    certain = ranked[:, -1] - ranked[:, -2] if points > 1 else ranked[:, -1]
    # Score of the touches so far, precision and linear term of each state.
    scores, precision, linear = np.zeros(1), np.eye(size)[None], prior[None]
    chosen = np.full((1, touches), -1, np.int64)
    order = np.argsort(-certain, kind="stable")
    for number, touch in enumerate(order):
        tried = np.flatnonzero(alone[touch] > alone[touch].max() - WITHIN)
        total = precision[:, None] + information[touch, tried]
        vector = linear[:, None] + pull[touch, tried]
        gathered = scores[:, None] + score[touch, tried]
        state, place = np.indices(gathered.shape).reshape(2, -1)
        # The likelihoods of the states are only needed where states are dropped, and in the end.
        if len(state) > kept or number == len(order) - 1:
            each = gathered + log_integral(total, vector)
            best = np.argsort(-each, axis=None, kind="stable")[:kept]
            state, place = state[best], place[best]
        scores, precision, linear = gathered[state, place], total[state, place], vector[state, place]
        chosen = chosen[state]
        chosen[:, touch] = tried[place]
    return list(chosen)


def log_integral(precision: Array, linear: Array) -> Array:
    """Logarithm of the integral of exp(-z P z / 2 + b z) over z, up to a constant, (...) float64.

    Args:
        precision: P, (..., n, n) float64.
        linear: b, (..., n) float64.
    """
    size = linear.shape[-1]
    # The last row of the Cholesky factor of P with b below it is L^-1 b, and the logarithm of |P| is on the diagonal.
    joined = np.empty((*linear.shape[:-1], size + 1, size + 1))
    joined[..., :size, :size] = precision
    joined[..., size, :size] = joined[..., :size, size] = linear
    joined[..., size, size] = np.finfo(np.float64).max ** 0.5
    root = np.linalg.cholesky(joined)
    logarithm = np.log(np.diagonal(root, axis1=-2, axis2=-1)[..., :size]).sum(-1)
    return np.asarray(0.5 * (root[..., size, :size] ** 2).sum(-1) - logarithm)


def _linearised(
    likelihood: TouchLikelihood, tables: Tables, deviations: Array, mismatch: float
) -> tuple[Array, Array, Array, Array]:
    """Score (n_touch, n_point), information (n_touch, n_point, n, n), pull (n_touch, n_point, n) and prior (n,).

    The n combinations of deviations are those that touches of all points determine.
    """
    spectra = likelihood.spectra
    h = tables.at(deviations) / spectra.noise
    power = np.abs(h) ** 2
    whole, free = power.sum(1), h.shape[1] - 1
    own = mismatch**2 * (whole - (power**2).sum(1) / whole) / free
    unit = across(h)  # (n_point, free, n_microphone, n_freq)
    source = np.einsum("pmf,wmf->wpf", h.conj(), spectra.spectrum) / whole
    residual = np.einsum("pnmf,wmf->wpnf", unit, spectra.spectrum)
    loudness = np.abs(source) ** 2
    variance = 1.0 + loudness * own
    windows = -((np.abs(residual) ** 2).sum(2) / variance + free * np.log(variance)).sum(2)  # (n_window, n_point)
    turned = unit[:, :, 1:] * h[:, None, 1:]
    changed = np.empty((len(deviations), *residual.shape[1:]), np.complex128)  # (n_deviation, n_point, free, n_freq)
    tables.derivatives_times(turned, changed)
    of_touch = np.eye(len(spectra.start))[spectra.touch].T
    of_windows = of_touch @ (loudness / variance).reshape(len(residual), -1)
    weight = of_windows.reshape(-1, *loudness.shape[1:])  # (n_touch, n_point, n_freq)
    pushed = source.conj()[:, :, None] * residual / variance[:, :, None]
    force = (of_touch @ pushed.reshape(len(residual), -1)).reshape(-1, *residual.shape[1:])
    by_point = changed.transpose(1, 0, 2, 3)
    typical = weight.max(0)
    flat = (by_point * np.sqrt(typical)[:, None, None]).transpose(1, 0, 2, 3).reshape(len(deviations), -1)
    flat = np.ascontiguousarray(flat).view(np.float64)
    values, vectors = np.linalg.eigh(2 * flat @ flat.T)
    basis = vectors[:, values > LEAST]
    points, size = len(by_point), basis.shape[1]
    real = basis.T @ np.ascontiguousarray(by_point.reshape(points, len(deviations), -1)).view(np.float64)
    # Products of two combinations each, once for all touches: (n_point, n_freq, size, size).
    parts = real.reshape(points, size, free, -1, 2).transpose(0, 3, 1, 2, 4).reshape(points, -1, size, 2 * free)
    products = (parts @ parts.transpose(0, 1, 3, 2)).reshape(points, -1, size * size)
    information = 2 * np.swapaxes(weight.transpose(1, 0, 2) @ products, 0, 1).reshape(-1, points, size, size)
    forces = np.ascontiguousarray(force.reshape(len(force), points, -1)).view(np.float64)
    pull = 2 * (real @ forces.transpose(1, 2, 0)).transpose(2, 0, 1)
    return of_touch @ windows, information, pull, -basis.T @ deviations
