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
from localize.two_touches.stroke_spectra import StrokeSpectra, stroke_spectra

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
    variance: Array,
    steps: int,
) -> StrokeFits:
    """Fits of hypotheses to one white frame.

    Args:
        model: of the array.
        frame: (n_white,) float64.
        points: (n_hypothesis, n_stroke) int64, from 0.
        strokes: where the fit begins, as of :class:`StrokeFits`.
        deviations: as well.
        components: of the deviations, as :meth:`localize.two_touches.path_deviations.PathDeviations.of_points` has
            them.
        variance: expected variance of the residual, over that of the noise, (n_white,) float64.
        steps: largest number of steps.
    """
    count, touches = points.shape
    fit = _Fit(model, frame, points, components, variance)
    state = np.concatenate([strokes.reshape(count, -1), deviations], axis=1)
    longest = np.concatenate([np.tile(LONGEST, touches), np.ones(deviations.shape[1])])
    diagonal = np.arange(state.shape[1])
    every = np.arange(count)
    begun = fit.reached(every, state)
    residual, slopes = fit.residual(begun), fit.slopes(begun)
    value = fit.objective(residual, state)
    damping = np.full(count, 1e-2)
    moving = every
    for number in range(steps):
        if number == steps // 2:
            bound = max(float(np.median(value)), float(value.min()) + _HOPELESS)
            moving = moving[value[moving] <= bound]
        if not len(moving):
            break
        curvature = fit.curvature(slopes[moving])
        gradient = (slopes[moving] @ residual[moving, :, None])[..., 0] - fit.weight * (state[moving] - fit.mean)
        curvature[:, diagonal, diagonal] *= 1 + damping[moving, None]
        step = np.linalg.solve(curvature, gradient[..., None])[..., 0].clip(-longest, longest)
        trial = state[moving] + step
        there = fit.reached(moving, trial)
        left = fit.residual(there)
        reached = fit.objective(left, trial)
        better = reached < value[moving]
        # Derivatives cost most, so they are computed only where a step is taken.
        taken = moving[better]
        gain = value[taken] - reached[better]
        damping[moving] = np.where(better, damping[moving] * 0.2, damping[moving] * 8).clip(1e-8, 1e6)
        state[taken], residual[taken], value[taken] = trial[better], left[better], reached[better]
        slopes[taken] = fit.slopes(there.chosen(better))
        ended = damping[moving] > _LARGEST_DAMPING
        ended[better] = gain < _LEAST_GAIN
        moving = moving[~ended]
    _, size = np.linalg.slogdet(fit.curvature(slopes))
    evidence = -value - 0.5 * (size - np.log(fit.weight).sum())
    found = state[:, : touches * SIZE].reshape(count, touches, SIZE)
    misfit = (residual**2).sum(1)
    return StrokeFits(points, found, state[:, touches * SIZE :], misfit, evidence)


def residual_information(
    model: StrokeModel,
    frame: Array,
    points: NDArray[np.int64],
    strokes: Array,
    components: ComplexArray,
    variance: Array,
) -> tuple[Array, Array]:
    """Residuals of hypotheses, and their information once small changes of all parameters are taken for unknown.

    Args:
        model: of the array.
        frame: (n_white,) float64.
        points: (n_hypothesis, n_stroke) int64, from 0.
        strokes: as of :class:`StrokeFits`.
        components: as of :func:`fit_strokes`.
        variance: as of :func:`fit_strokes`.

    Returns:
        Residuals over their expected deviation, (n_hypothesis, n_white) float64, and the inverse of their covariance,
        (n_hypothesis, n_white, n_white) float64.
    """
    count = len(points)
    fit = _Fit(model, frame, points, components, variance)
    state = np.concatenate([strokes.reshape(count, -1), np.zeros((count, components.shape[1]))], axis=1)
    there = fit.reached(np.arange(count), state)
    slopes = fit.slopes(there)
    information = np.eye(len(frame)) - slopes.swapaxes(1, 2) @ np.linalg.solve(fit.curvature(slopes), slopes)
    return fit.residual(there), information


_LEAST_GAIN = 1e-4
"""Gain of a step that is taken, nats, below which a fit has ended."""
_HOPELESS = 30.0
"""Lag behind the best hypothesis, nats, with which the worse half of the hypotheses ends after half of the steps."""
_LARGEST_DAMPING = 1e5
"""Damping above which a fit has ended, because no step helps."""


@dataclass(frozen=True, eq=False)
class _Reached:
    """Hypotheses with some parameters."""

    components: NDArray[np.complex64]
    """Coefficients of the components, (n_hypothesis, n_microphone, n_component, n_stroke n_term)."""
    strokes: StrokeSpectra
    paths: ComplexArray
    """With the height of each stroke and the deviations, (n_hypothesis, n_stroke, n_microphone, n_freq)."""
    heard: ComplexArray
    """Spectra of each stroke at the microphones, of the same shape."""

    def chosen(self, mask: NDArray[np.bool_]) -> _Reached:
        return _Reached(self.components[mask], self.strokes.chosen(mask), self.paths[mask], self.heard[mask])


class _Fit:
    """Objective of hypotheses and its derivatives."""

    def __init__(
        self, model: StrokeModel, frame: Array, points: NDArray[np.int64], components: ComplexArray, variance: Array
    ) -> None:
        self._model, self._frame, self._points = model, frame, points
        self._components = components.astype(model.paths.dtype)
        self._root, self._smooth = 1 / np.sqrt(variance), model.smooth.astype(np.float32)
        touches, self._drawn = points.shape[1], components.shape[1]
        by_microphone = components.transpose(0, 3, 1, 2, 4).reshape(len(points), components.shape[3], self._drawn, -1)
        self._by_microphone = by_microphone.astype(np.complex64)
        self.mean = np.concatenate([np.tile(MEAN, touches), np.zeros(self._drawn)])
        self.weight = np.concatenate([np.tile(DEVIATION**-2, touches), np.ones(self._drawn)])

    def objective(self, residual: Array, state: Array) -> Array:
        """Negative logarithm of the posterior up to a constant, (n_hypothesis,) nats."""
        prior = (self.weight * (state - self.mean) ** 2).sum(1)
        return np.asarray(0.5 * (residual**2).sum(1) + 0.5 * prior)

    def curvature(self, slopes: Array) -> Array:
        """Its second derivatives without those of the model, (n_hypothesis, n_parameter, n_parameter)."""
        return np.asarray(slopes @ slopes.transpose(0, 2, 1) + np.diag(self.weight))

    def reached(self, numbers: NDArray[np.int64], state: Array) -> _Reached:
        """Some of the hypotheses, by their numbers, with parameters (n_chosen, n_parameter)."""
        count, touches = len(numbers), self._points.shape[1]
        precise = state.astype(self._model.frequency.dtype)
        strokes = precise[:, : touches * SIZE].reshape(count, touches, SIZE)
        spectra = stroke_spectra(strokes[..., : SIZE - 1], self._model.frequency)
        coefficients = np.einsum("nk,nksmt->nsmt", precise[:, touches * SIZE :], self._components[numbers])
        change = coefficients @ self._model.smooth + strokes[..., SIZE - 1, None, None]
        paths = self._model.paths[self._points[numbers]] * np.exp(change)
        return _Reached(self._by_microphone[numbers], spectra, paths, paths * spectra.spectrum[:, :, None])

    def residual(self, there: _Reached) -> Array:
        """Residual of the frame over its expected deviation, (n_chosen, n_white) float64."""
        return (self._frame - self._model.sampled(there.heard.sum(1)).reshape(-1, len(self._frame))) * self._root

    def slopes(self, there: _Reached) -> Array:
        """Derivatives of the frame over the same deviation by the parameters, (n_chosen, n_parameter, n_white) float64.

        They are computed in single precision, which halves the time, because they only steer the fit and weigh it. The
        residual has the precision of the model.
        """
        heard = there.heard.astype(np.complex64).swapaxes(1, 2)
        paths = there.paths.astype(np.complex64).swapaxes(1, 2)
        count, microphones, touches, frequencies = heard.shape
        own = touches * SIZE
        found = np.empty((count, microphones, own + self._drawn, frequencies), np.complex64)
        of_strokes = found[:, :, :own].reshape(count, microphones, touches, SIZE, frequencies)
        derivatives = there.strokes.derivatives(self._model.frequency)
        np.multiply(paths[:, :, :, None], derivatives[:, None], out=of_strokes[..., : SIZE - 1, :])
        of_strokes[..., SIZE - 1, :] = heard
        by_term = heard[:, :, :, None] * self._smooth
        by_term = by_term.reshape(count, microphones, touches * len(self._smooth), frequencies)
        np.matmul(there.components, by_term, out=found[:, :, own:])
        white = self._model.sampled(found).transpose(0, 2, 1, 3).astype(np.float64)
        return white.reshape(count, own + self._drawn, len(self._frame)) * self._root
