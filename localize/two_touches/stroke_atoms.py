"""Atoms: strokes on a grid at the points of an array. Their Gram matrix screens all pairs of them at once.

The power that a pair of atoms explains has a closed form by the projections of the frame on both and their product. A
pair counts only if both heights are above zero, because a finger presses and does not pull.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.signals.array_response import ArrayResponse
from localize.two_touches.stroke_model import StrokeModel
from localize.two_touches.stroke_spectra import stroke_spectra
from localize.two_touches.two_touch_options import TwoTouchOptions

_LEAST_STEP = 0.006
_TAP_HOLD, _PRESS_HOLD, _PRESS_FALL, _BLUR = 1e-3, 0.6, 0.1, 1e-3
_LEAST_APART = 1e-3


@dataclass(frozen=True, eq=False)
class Starts:
    """Hypotheses from which fits begin."""

    points: NDArray[np.int64]
    """Touched points from 0, (n_hypothesis, n_stroke) int64."""
    strokes: Array
    """As of :class:`localize.two_touches.stroke_fit.StrokeFits`, (n_hypothesis, n_stroke, 6) float64."""


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
        self.stride = 1
        """Distance of points with atoms along a line, in places."""
        while (shown := _points_with_atoms(response, self.stride)).size * shapes > options.most_atoms:
            self.stride += 1
            if self.stride > response.place.max():
                break
        self.points: NDArray[np.int64] = shown
        """Points with atoms, from 0, (n_shown,) int64."""
        spectra, _ = stroke_spectra(self._strokes, model.frequency)
        atoms = np.stack([model.sampled(spectra[:, None] * path) for path in model.paths[shown]])
        norm = np.linalg.norm(atoms, axis=-1)
        self._height = 1 / norm
        self._atoms = (atoms / norm[..., None]).reshape(-1, atoms.shape[-1]).astype(np.float32)
        self._gram = self._atoms @ self._atoms.T
        apart = 1 - self._gram**2
        # Nearly equal atoms explain nothing as a pair that one of them does not.
        self._inverse = np.where(apart > _LEAST_APART, 1 / np.maximum(apart, _LEAST_APART), 0.0).astype(np.float32)

    def projections(self, frame: Array) -> Array:
        """Projections of a white frame (n_white,) on the atoms, (n_shown, n_shape)."""
        return np.asarray((self._atoms @ frame.astype(np.float32)).reshape(len(self.points), -1), np.float64)

    def singles(self, frame: Array) -> Starts:
        """Starts of one stroke at each point with atoms, from every rise."""
        projected = self.projections(frame)
        points, strokes = [], []
        for number, point in enumerate(self.points):
            for rise in range(len(self._begins)):
                shape = self._shape(projected[number], rise)
                points.append([point])
                strokes.append([self._stroke(number, shape, projected[number, shape])])
        return Starts(np.array(points), np.array(strokes))

    def pairs(self, frame: Array) -> Starts:
        """Starts of two strokes at those pairs of points that explain most, from several pairs of rises each."""
        options, shapes = self._options, len(self._strokes)
        projected = self.projections(frame)
        flat = projected.ravel().astype(np.float32)
        own = flat[:, None] - self._gram * flat
        power = np.where((own > 0) & (own.T > 0), own**2 * self._inverse + flat**2, 0)
        power = power.reshape(len(self.points), shapes, len(self.points), shapes)
        by_rise = np.maximum.reduceat(np.maximum.reduceat(power, self._begins, axis=1), self._begins, axis=3)
        best = by_rise.max(axis=(1, 3))
        one, other = np.triu_indices(len(self.points), 1)
        points, strokes = [], []
        for pair in np.argsort(-best[one, other])[: options.screened_pairs]:
            i, j = int(one[pair]), int(other[pair])
            here = by_rise[i, :, j, :]
            for rises in np.argsort(-here, axis=None)[: options.starts]:
                if here.flat[rises] <= 0:
                    break
                a, b = self._shapes(power[i, :, j, :], *np.unravel_index(rises, here.shape))
                gram = float(self._gram[i * shapes + a, j * shapes + b])
                apart = max(1 - gram**2, _LEAST_APART)
                first = (projected[i, a] - gram * projected[j, b]) / apart
                second = (projected[j, b] - gram * projected[i, a]) / apart
                points.append([self.points[i], self.points[j]])
                strokes.append([self._stroke(i, a, first), self._stroke(j, b, second)])
        return Starts(np.array(points, np.int64).reshape(-1, 2), np.array(strokes).reshape(-1, 2, 6))

    def _rise(self, number: int) -> slice:
        """Shapes of one rise."""
        end = self._begins[number + 1] if number + 1 < len(self._begins) else len(self._strokes)
        return slice(int(self._begins[number]), int(end))

    def _shape(self, values: Array, rise: int) -> int:
        part = self._rise(rise)
        return part.start + int(values[part].argmax())

    def _shapes(self, power: Array, one: np.intp, other: np.intp) -> tuple[int, int]:
        first, second = self._rise(int(one)), self._rise(int(other))
        part = power[first, second]
        a, b = np.unravel_index(part.argmax(), part.shape)
        return first.start + int(a), second.start + int(b)

    def _stroke(self, number: int, shape: int, projected: float) -> list[float]:
        height = max(projected, 1e-3) * self._height[number, shape]
        return [*self._strokes[shape], float(np.log(height))]


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
