"""Fit of strokes to a frame: the parameters of each stroke, its height and the deviations of the sensor together.

The fit maximises the posterior probability by the method of Levenberg and Marquardt (Nocedal and Wright, Numerical
Optimization (2006), section 10.3), for many hypotheses about the touched points at once. The evidence of a hypothesis
is Laplace's approximation (MacKay, Information Theory, Inference and Learning Algorithms (2003), chapter 28), so that
each hypothesis pays for the parameters that it needs.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array, ComplexArray
from localize.two_touches.stroke_model import StrokeModel
from localize.two_touches.stroke_spectra import stroke_spectra

MEAN = np.array([0.07, np.log(0.03), np.log(0.01), np.log(0.03), np.log(0.002), 0.0])
"""Means of the prior of the parameters of a stroke, and of the logarithm of its height in Pa."""
DEVIATION = np.array([0.05, 1.0, 2.0, 1.0, 0.8, 1.5])
"""Standard deviations of the prior."""
LONGEST = np.array([0.02, 0.5, 1.0, 0.5, 0.7, 0.7])
"""Longest step of each parameter."""
SIZE = len(MEAN)


@dataclass(frozen=True, eq=False)
class StrokeFits:
    """Fits of hypotheses about the touched points."""

    points: NDArray[np.int64]
    """Touched points from 0, (n_hypothesis, n_stroke) int64."""
    strokes: Array
    """Parameters of each stroke and the logarithm of its height, (n_hypothesis, n_stroke, 6) float64."""
    deviations: Array
    """Deviations of the sensor, (n_hypothesis, n_component) float64, standard deviations."""
    misfit: Array
    """Sum of squares of the residual over its expected variance, (n_hypothesis,) float64."""
    evidence: Array
    """Logarithm of the evidence, (n_hypothesis,) float64, nats."""
    residual: Array
    """Residual of the white frame, (n_hypothesis, n_white) float64."""

    def best(self, count: int, of_points: int = 1) -> StrokeFits:
        """The hypotheses of most evidence, in its order.

        Args:
            count: largest number of hypotheses.
            of_points: largest number of them about the same points.
        """
        kept = list[int]()
        seen = Counter[tuple[int, ...]]()
        for number in np.argsort(-self.evidence).tolist():
            touched = tuple(sorted(self.points[number].tolist()))
            if seen[touched] < of_points and len(kept) < count:
                seen[touched] += 1
                kept.append(number)
        return StrokeFits(**{name: values[kept] for name, values in vars(self).items()})

    def joined(self, other: StrokeFits) -> StrokeFits:
        """These hypotheses and others."""
        return StrokeFits(
            **{name: np.concatenate([values, getattr(other, name)]) for name, values in vars(self).items()}
        )


def fit_strokes(
    model: StrokeModel,
    frame: Array,
    points: NDArray[np.int64],
    strokes: Array,
    deviations: Array,
    components: ComplexArray,
    variance: float,
    steps: int,
) -> StrokeFits:
    """Fits of hypotheses to one white frame.

    Args:
        model: of the array.
        frame: (n_white,) float64.
        points: (n_hypothesis, n_stroke) int64, from 0.
        strokes: where the fit begins, as of :class:`StrokeFits`.
        deviations: as well.
        components: of the deviations, (n_hypothesis, n_component, n_stroke, n_microphone, n_freq) complex128.
        variance: expected variance of the residual, over that of the noise.
        steps: number of steps.
    """
    count, touches = points.shape
    fit = _Fit(model, frame, points, components, variance)
    state = np.concatenate([strokes.reshape(count, -1), deviations], axis=1)
    longest = np.concatenate([np.tile(LONGEST, touches), np.ones(deviations.shape[1])])
    damping = np.full(count, 1e-2)
    residual, slopes = fit.linearised(state)
    value = fit.objective(residual, state)
    diagonal = np.arange(state.shape[1])
    for _ in range(steps):
        curvature = fit.curvature(slopes)
        gradient = (slopes @ residual[..., None])[..., 0] / variance - fit.weight * (state - fit.mean)
        curvature[:, diagonal, diagonal] *= 1 + damping[:, None]
        step = np.linalg.solve(curvature, gradient[..., None])[..., 0].clip(-longest, longest)
        trial = state + step
        moved, tilted = fit.linearised(trial)
        reached = fit.objective(moved, trial)
        better = reached < value
        damping = np.where(better, damping * 0.2, damping * 8).clip(1e-8, 1e6)
        state[better], residual[better], slopes[better] = trial[better], moved[better], tilted[better]
        value = np.where(better, reached, value)
    _, size = np.linalg.slogdet(fit.curvature(slopes))
    evidence = -value - 0.5 * (size - np.log(fit.weight).sum())
    found = state[:, : touches * SIZE].reshape(count, touches, SIZE)
    return StrokeFits(points, found, state[:, touches * SIZE :], (residual**2).sum(1) / variance, evidence, residual)


class _Fit:
    """Objective of hypotheses and its derivatives."""

    def __init__(
        self, model: StrokeModel, frame: Array, points: NDArray[np.int64], components: ComplexArray, variance: float
    ) -> None:
        self._model, self._frame, self._points, self._components = model, frame, points, components
        self._variance = variance
        touches, drawn = points.shape[1], components.shape[1]
        self.mean = np.concatenate([np.tile(MEAN, touches), np.zeros(drawn)])
        self.weight = np.concatenate([np.tile(DEVIATION**-2, touches), np.ones(drawn)])

    def objective(self, residual: Array, state: Array) -> Array:
        """Negative logarithm of the posterior up to a constant, (n_hypothesis,) nats."""
        prior = (self.weight * (state - self.mean) ** 2).sum(1)
        return np.asarray(0.5 * (residual**2).sum(1) / self._variance + 0.5 * prior)

    def curvature(self, slopes: Array) -> Array:
        """Its second derivatives without those of the model, (n_hypothesis, n_parameter, n_parameter)."""
        return np.asarray(slopes @ slopes.transpose(0, 2, 1) / self._variance + np.diag(self.weight))

    def linearised(self, state: Array) -> tuple[Array, Array]:
        """Residual (n_hypothesis, n_white), and derivatives of the frame (n_hypothesis, n_parameter, n_white)."""
        count, touches = self._points.shape
        strokes = state[:, : touches * SIZE].reshape(count, touches, SIZE)
        deviations = state[:, touches * SIZE :]
        spectra, by_parameter = stroke_spectra(strokes[..., : SIZE - 1], self._model.frequency)
        path = self._model.paths[self._points] * np.exp(strokes[..., SIZE - 1, None, None])
        if deviations.shape[1]:
            flat = self._components.reshape(count, deviations.shape[1], -1)
            path = path * np.exp((deviations[:, None] @ flat).reshape(path.shape))
        heard = path * spectra[:, :, None]
        own = path[:, :, None] * by_parameter[:, :, :, None]
        own = np.concatenate([own, heard[:, :, None]], axis=2).reshape(count, touches * SIZE, *heard.shape[2:])
        if deviations.shape[1]:
            own = np.concatenate([own, np.einsum("nkmf,nzkmf->nzmf", heard, self._components)], axis=1)
        slopes = self._model.sampled(own)
        total = slopes[:, SIZE - 1 : touches * SIZE : SIZE].sum(1)
        return self._frame - total, slopes
