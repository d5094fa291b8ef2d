"""Atoms: strokes on a grid at the points of an array. Their Gram matrix screens all pairs of them at once.

The power that a pair of atoms explains has a closed form by the projections of the frame on both and their product. A
pair counts only if both heights are above zero, because a finger presses and does not pull.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.signals.array_response import ArrayResponse
from localize.two_touches.stroke_model import StrokeModel
from localize.two_touches.stroke_spectra import stroke_spectra
from localize.two_touches.two_touch_options import TwoTouchOptions

SingleArray: TypeAlias = NDArray[np.float32]

_LEAST_STEP = 0.006
_TAP_HOLD, _PRESS_HOLD, _PRESS_FALL, _BLUR = 1e-3, 0.6, 0.1, 1e-3
_LEAST_APART = 1e-3
_LEAST_HEIGHT = 1e-4
"""Height with which a stroke begins at least, Pa."""


@dataclass(frozen=True, eq=False)
class Starts:
    """Hypotheses from which fits begin."""

    points: NDArray[np.int64]
    """Touched points from 0, (n_hypothesis, n_stroke) int64."""
    strokes: Array
    """As of :class:`localize.two_touches.stroke_fit.StrokeFits`, (n_hypothesis, n_stroke, 6) float64."""

    def joined(self, other: Starts) -> Starts:
        """These hypotheses and others."""
        return Starts(np.concatenate([self.points, other.points]), np.concatenate([self.strokes, other.strokes]))

    def of_first(self, count: int) -> Starts:
        """Hypotheses about the first ``count`` combinations of points."""
        seen = list(dict.fromkeys(tuple(each) for each in self.points.tolist()))[:count]
        mask = [tuple(each) in seen for each in self.points.tolist()]
        return Starts(self.points[mask], self.strokes[mask])


class StrokeAtoms:
    """Atoms of an array.

    Args:
        model: of the array.
        response: the array, for its lines.
        options: of the decoder.
    """

    def __init__(self, model: StrokeModel, response: ArrayResponse, options: TwoTouchOptions) -> None:
        self._options = options
        every = 1 if response.point_count <= options.few_points else options.few_rises
        self._strokes, self._begins = _grid(options, every)
        shapes = len(self._strokes)
        stride = 1
        while (shown := _points_with_atoms(response, stride)).size * shapes > options.most_atoms:
            stride += 1
            if stride > response.place.max():
                break
        self.points: NDArray[np.int64] = shown
        """Points with atoms, from 0, (n_shown,) int64."""
        spectra = stroke_spectra(self._strokes, model.frequency).spectrum
        atoms = np.stack([model.sampled(spectra[:, None] * path).reshape(shapes, -1) for path in model.paths[shown]])
        self._atoms = atoms.reshape(-1, atoms.shape[-1]).astype(np.float32)

    def _weighed(self, frame: Array, variance: Array) -> tuple[SingleArray, SingleArray, SingleArray]:
        """Atoms of norm one over the expected deviation of the residual, the projections on them and their heights."""
        root = (1 / np.sqrt(variance)).astype(np.float32)
        atoms = self._atoms * root
        norm = np.sqrt(np.einsum("aw,aw->a", atoms, atoms))
        atoms /= norm[:, None]
        return atoms, np.asarray(atoms @ (frame * root).astype(np.float32)), np.asarray(1 / norm)

    def singles(self, frame: Array, variance: Array) -> Starts:
        """Starts of one stroke at each point with atoms, from every rise.

        Args:
            frame: white, (n_white,) float64.
            variance: expected variance of the residual, (n_white,) float64.
        """
        _, projected, height = self._weighed(frame, variance)
        shapes = len(self._strokes)
        points, strokes = [], []
        for number, point in enumerate(self.points):
            own = slice(number * shapes, (number + 1) * shapes)
            for rise in range(len(self._begins)):
                shape = self._shape(projected[own], rise)
                points.append([point])
                strokes.append([self._stroke(shape, projected[own][shape] * height[own][shape])])
        return Starts(np.array(points), np.array(strokes))

    def pairs(self, frame: Array, variance: Array, count: int) -> Starts:
        """Starts of two strokes at those pairs of points that explain most, from several pairs of rises each.

        Args:
            frame: white, (n_white,) float64.
            variance: expected variance of the residual, (n_white,) float64.
            count: number of pairs of points.
        """
        by_rise, atoms, projected, height = self._screened(frame, variance)
        options, shapes = self._options, len(self._strokes)
        best = by_rise.max(axis=(1, 3))
        one, other = np.triu_indices(len(self.points), 1)
        points, strokes = [], []
        for pair in np.argsort(-best[one, other])[:count]:
            i, j = int(one[pair]), int(other[pair])
            here = by_rise[i, :, j, :]
            first, second = (slice(number * shapes, (number + 1) * shapes) for number in (i, j))
            gram = atoms[first] @ atoms[second].T
            power = _explained(projected[first], projected[second], gram)
            for rises in np.argsort(-here, axis=None)[: options.starts]:
                if here.flat[rises] <= 0:
                    break
                a, b = self._shapes(power, *np.unravel_index(rises, here.shape))
                between = float(gram[a, b])
                apart = max(1 - between**2, _LEAST_APART)
                heights = (
                    (projected[first][a] - between * projected[second][b]) / apart * height[first][a],
                    (projected[second][b] - between * projected[first][a]) / apart * height[second][b],
                )
                points.append([self.points[i], self.points[j]])
                strokes.append([self._stroke(shape, own) for shape, own in zip((a, b), heights, strict=True)])
        return Starts(np.array(points, np.int64).reshape(-1, 2), np.array(strokes).reshape(-1, 2, 6))

    def another(
        self, residual: Array, information: Array, variance: Array, count: int
    ) -> tuple[NDArray[np.int64], Array]:
        """Strokes that explain most of a residual beside small changes of those which are there.

        Args:
            residual: over its expected deviation, (n_white,) float64.
            information: inverse of its covariance, (n_white, n_white) float64.
            variance: expected variance of the residual, (n_white,) float64.
            count: number of strokes; no two of them have the same point and rise.

        Returns:
            Points from 0, (n_start,) int64, and their strokes, (n_start, 6) float64.
        """
        root = 1 / np.sqrt(variance)
        atoms = self._atoms * root.astype(np.float32)
        own = np.einsum("aw,aw->a", atoms @ information.astype(np.float32), atoms)
        along = atoms @ (information @ residual).astype(np.float32)
        usual = np.einsum("aw,aw->a", atoms, atoms)
        explained = np.where((along > 0) & (own > _LEAST_APART * usual), along**2 / np.maximum(own, 1e-30), 0.0)
        explained = explained.reshape(len(self.points), len(self._strokes))
        best = np.maximum.reduceat(explained, self._begins, axis=1)
        points, strokes = [], []
        for each in np.argsort(-best, axis=None)[:count]:
            number, rise = np.unravel_index(each, best.shape)
            shape = self._shape(explained[number], int(rise))
            place = int(number) * len(self._strokes) + shape
            points.append(self.points[number])
            strokes.append(self._stroke(shape, float(along[place] / max(own[place], 1e-30))))
        return np.array(points), np.array(strokes)

    def _screened(self, frame: Array, variance: Array) -> tuple[SingleArray, SingleArray, SingleArray, SingleArray]:
        """Largest power that a pair of points explains by each pair of rises; atoms, projections and heights.

        The power is (n_shown, n_rise, n_shown, n_rise) float32, and 0 below the diagonal of the points.
        """
        atoms, projected, height = self._weighed(frame, variance)
        shapes, rises, points = len(self._strokes), len(self._begins), len(self.points)
        found = np.zeros((points, rises, points, rises), np.float32)
        for number in range(points - 1):
            own, others = slice(number * shapes, (number + 1) * shapes), slice((number + 1) * shapes, None)
            power = _explained(projected[own], projected[others], atoms[own] @ atoms[others].T)
            power = np.maximum.reduceat(power, self._begins, axis=0).reshape(rises, -1, shapes)
            found[number, :, number + 1 :] = np.maximum.reduceat(power, self._begins, axis=2)
        return found, atoms, projected, height

    def _rise(self, number: int) -> slice:
        """Shapes of one rise."""
        end = self._begins[number + 1] if number + 1 < len(self._begins) else len(self._strokes)
        return slice(int(self._begins[number]), int(end))

    def _shape(self, values: SingleArray, rise: int) -> int:
        part = self._rise(rise)
        return part.start + int(values[part].argmax())

    def _shapes(self, power: SingleArray, one: np.intp, other: np.intp) -> tuple[int, int]:
        first, second = self._rise(int(one)), self._rise(int(other))
        part = power[first, second]
        a, b = np.unravel_index(part.argmax(), part.shape)
        return first.start + int(a), second.start + int(b)

    def _stroke(self, shape: int, height: float) -> list[float]:
        return [*self._strokes[shape], float(np.log(max(height, _LEAST_HEIGHT)))]


def _explained(one: SingleArray, other: SingleArray, gram: SingleArray) -> SingleArray:
    """Power that pairs of atoms explain, (n_one, n_other) float32; 0 if not both heights are above 0.

    Args:
        one: projections on the first atoms, (n_one,) float32.
        other: on the second ones, (n_other,) float32.
        gram: products of these atoms, (n_one, n_other) float32.
    """
    first = one[:, None] - gram * other
    second = other - gram * one[:, None]
    apart = 1 - gram**2
    # Nearly equal atoms explain nothing as a pair that one of them does not.
    power = first**2 / np.maximum(apart, _LEAST_APART)
    power *= apart > _LEAST_APART
    power += other**2
    power *= (first > 0) & (second > 0)
    return np.asarray(power)


def _grid(options: TwoTouchOptions, every: int) -> tuple[Array, NDArray[np.int64]]:
    """Strokes (n_shape, 5), those of each rise together, and where each rise begins."""
    found: list[list[float]] = []
    begins = []
    kinds = [(rise, _TAP_HOLD, rise) for rise in options.rises[::every]]
    kinds += [(rise, _PRESS_HOLD, _PRESS_FALL) for rise in options.press_rises[::every]]
    for rise, hold, fall in kinds:
        begins.append(len(found))
        for onset in np.arange(0, options.last_onset + 1e-9, every * max(_LEAST_STEP, rise / 3)):
            found.append([onset + rise / 2, np.log(rise), np.log(hold), np.log(fall), np.log(_BLUR)])
    return np.array(found), np.array(begins)


def _points_with_atoms(response: ArrayResponse, stride: int) -> NDArray[np.int64]:
    """Every so many-th point of each line, from half of that on."""
    first = response.place - response.place.min()
    return np.flatnonzero(first % stride == min(stride // 2, int(first.max())))
