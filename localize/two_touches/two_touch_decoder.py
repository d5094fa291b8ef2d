"""Decoder of one, two or three touches at once, each the stroke of a membrane.

Two microphones give two equations for two unknown waveforms at every frequency, so any two points of a line explain any
frame if their waveforms are free. A touch of a finger is not free: it rises, is held, and falls. With such strokes the
points, the times and the heights of two touches are determined.

All pairs of strokes on a grid are screened first (:mod:`localize.two_touches.stroke_atoms`), the best ones are fitted
(:mod:`localize.two_touches.stroke_fit`), together with the deviations of the sensor from its library
(:mod:`localize.two_touches.path_deviations`). There are two touches if the evidence of the best pair exceeds that of
the best point by a threshold.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import softmax

from acoustic_fem import Library
from acoustic_fem.scatter.tolerances import Tolerance
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.frame_covariance import check_noise
from localize.decoders.hypotheses import bare_library
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import FRAME
from localize.signals.noise_model import NoiseChoice
from localize.signals.threads import one_thread
from localize.two_touches.path_deviations import PathDeviations
from localize.two_touches.stroke_atoms import Starts, StrokeAtoms
from localize.two_touches.stroke_fit import SIZE, StrokeFits, fit_strokes, residual_information
from localize.two_touches.stroke_model import StrokeModel
from localize.two_touches.two_touch_options import TwoTouchOptions


@dataclass(frozen=True)
class FoundTouch:
    """One of the touches of a frame."""

    best: int
    """Most probable point, from 1."""
    probability: float
    """Probability that this point was touched, 0 to 1."""
    time: float
    """Time at which its stroke had risen by half, s after the beginning of the frame."""
    height: float
    """Height of its stroke, Pa in the cavity at 30 Hz."""
    held: float
    """Time for which the stroke is held, s; beyond the end of the frame it is a guess."""
    least_probability: float = 0.5
    """Probability below which the point counts as unknown."""

    @property
    def point(self) -> int | None:
        """Most probable point, from 1; None if it is not probable enough."""
        return self.best if self.probability >= self.least_probability else None


@dataclass(frozen=True)
class TouchesAtOnce:
    """Touches of one frame."""

    touches: tuple[FoundTouch, ...]
    """Touches in the order of time."""
    gain: float
    """Evidence of two touches over that of one, nats, over the misfit of two if that is above 1; 0 if one touch leaves
    so little that two were not tried."""
    misfit: float
    """Mean square of the residual over what is expected, a ratio; far above 1 if no strokes explain the frame."""

    @property
    def points(self) -> tuple[int | None, ...]:
        """Points of the touches, in the order of time."""
        return tuple(touch.point for touch in self.touches)


class TwoTouchDecoder:
    """Decoder of several touches at once, for frames behind the high-pass of a stream.

    Args:
        library: transfer functions of a design that cover 1 to 100 Hz.
        microphone_noise: as of :class:`localize.BayesDecoder`.
        tolerances: of manufacturing, of a sensor that nobody calibrated, such as
            :data:`acoustic_fem.scatter.UNCALIBRATED`; None if the library was measured on the sensor.
        options: numbers that tune it.

    Raises:
        Refusal: bare transfer functions, too many points, tolerances of a design whose scatter is not known, or as
            :class:`localize.BayesDecoder`.
    """

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = "design",
        tolerances: Sequence[Tolerance] | None = None,
        options: TwoTouchOptions = TwoTouchOptions(),
    ) -> None:
        check_noise(microphone_noise)
        response = response_of(library)
        if response.point_count > options.most_points:
            problem = (
                f"has {response.point_count} points; touches at once are found among at most {options.most_points}"
            )
            raise Refusal(problem, kind=Kind.UNSUITABLE, field="library")
        self.array, self.options = response.array, options
        self._model = StrokeModel(response, microphone_noise)
        if tolerances is None:
            self._deviations = PathDeviations.of_calibration(response, options)
        elif isinstance(library, ArrayResponse):
            raise bare_library()
        else:
            self._deviations = PathDeviations.of_tolerances(library, response, tolerances, options)
            self._model.paths = self._model.paths * np.exp(self._deviations.mean @ self._model.smooth)
        self._coarse = self._model.coarse()
        self._atoms = StrokeAtoms(self._model, response, options)
        self._line, self._place = response.line, response.place
        longest = int(np.bincount(response.line).max())
        # The first moves along a line are an eighth to a quarter of its length, each later one is half as long.
        self._reaches = tuple(2**k for k in reversed(range(max(1, int(np.log2(longest)) - 1))))

    @one_thread()
    def locate(self, frame: ArrayLike) -> TouchesAtOnce:
        """Touches of one frame.

        Args:
            frame: (n_microphone, 250) float64, Pa, at 1 kHz, behind the high-pass of a stream. The touches begin in its
                first half.

        Raises:
            Refusal: another shape, or a value that is not finite.
        """
        samples = np.asarray(frame, np.float64)
        expected = len(self.array.microphones), FRAME
        if samples.shape != expected or not np.isfinite(samples).all():
            problem = f"has shape {samples.shape}; it must hold finite values of shape {expected}"
            raise Refusal(problem, kind=Kind.WRONG_TYPE, field="frame")
        white = self._model.white(samples)
        found = self._fitted(white, self._atoms.singles(white, self._screened(white)))
        gain = 0.0
        for count in range(2, min(self.options.most, len(self._place)) + 1):
            # More strokes gain at most what the residual costs.
            if found.misfit[0] / 2 <= self.options.threshold:
                break
            more = self._with_one_more(white, found)
            # A residual that two touches do not explain either is no evidence for two.
            unexplained = max(1.0, float(more.misfit[0]) / len(white))
            better = float(more.evidence[0] - found.evidence[0]) / unexplained
            gain = better if count == 2 else gain
            if better <= self.options.threshold:
                break
            found = more
        return self._answer(found, gain, len(white))

    def _with_one_more(self, white: Array, found: StrokeFits) -> StrokeFits:
        """Fits of hypotheses of one more stroke than those found, the best first."""
        starts = self._with_another(white, found.points[: self.options.widened], found.strokes[: self.options.widened])
        if found.points.shape[1] > 1:
            return self._fitted(white, starts)
        first, *others = self.options.screened_pairs
        pairs = self._atoms.pairs(white, self._screened(white), max(self.options.screened_pairs))
        fits = self._fitted(white, starts.joined(pairs.of_first(first)))
        for count in others:
            if fits.misfit[0] <= self.options.fits * len(white):
                break
            fits = fits.joined(self._fitted(white, pairs.of_first(count))).best(len(fits.points))
        return fits

    def _fitted(self, white: Array, starts: Starts) -> StrokeFits:
        """Fits of the hypotheses that explain a frame best, the best first."""
        first, *others, last = self.options.stages
        fits = self._stage(self._coarse, white, starts.points, starts.strokes, None, first)
        for _ in range(self.options.exchanges if fits.points.shape[1] > 1 else 0):
            starts, best = self._exchanged(white, fits), fits.evidence[0]
            fits = fits.joined(self._stage(self._coarse, white, starts.points, starts.strokes, None, first))
            fits = fits.best(first[0], first[1])
            if fits.evidence[0] < best + 1.0:
                break
        fits = self._climbed(self._coarse, white, fits, first, self._reaches)
        for stage in others:
            fits = self._stage(self._model, white, fits.points, fits.strokes, fits.deviations, stage)
            fits = self._climbed(self._model, white, fits, stage, (1,))
        return self._stage(self._model, white, fits.points, fits.strokes, fits.deviations, last)

    def _climbed(
        self, model: StrokeModel, white: Array, fits: StrokeFits, stage: tuple[int, int, float, int, int],
        reaches: tuple[int, ...],
    ) -> StrokeFits:  # fmt: skip
        """Fits after the points of the best ones were moved along their lines, as long as that helps.

        Args:
            model: of the stage.
            white: the frame.
            fits: of the stage.
            stage: its numbers.
            reaches: places by which points are moved, one after the other.
        """
        keep, of_points = stage[:2]
        tried = {tuple(sorted(each)) for each in fits.points.tolist()}
        for reach in reaches:
            for _ in range(self.options.moves):
                points, strokes = self._moved(fits, reach, tried)
                if not len(points):
                    break
                best = fits.evidence[0]
                more = self._stage(model, white, points, strokes, None, stage)
                fits = fits.joined(more).best(keep, of_points)
                if fits.evidence[0] < best + 1.0:
                    break
        return fits

    def _stage(
        self, model: StrokeModel, white: Array, points: NDArray[np.int64], strokes: Array, deviations: Array | None,
        stage: tuple[int, int, float, int, int],
    ) -> StrokeFits:  # fmt: skip
        """Fits of one stage; without deviations (None) they begin at none."""
        keep, of_points, error, steps, count = stage
        variance = self._variance(white, max(error, self.options.relative_error))
        components = self._deviations.of_points(points, count)
        begin = np.zeros((len(points), components.shape[1]))
        if deviations is not None:
            shared = min(deviations.shape[1], begin.shape[1])
            begin[:, :shared] = deviations[:, :shared]
        fits = fit_strokes(model, white, points, strokes, begin, components, variance, steps)
        return fits.best(keep, of_points)

    def _screened(self, white: Array) -> Array:
        """Expected variance of a residual of atoms, (n_white,)."""
        return self._variance(white, self.options.stages[0][2])

    def _variance(self, white: Array, error: float) -> Array:
        """Expected variance of a residual, (n_white,): noise, and a fraction of each microphone's own signal."""
        power = (white.reshape(len(self.array.microphones), -1) ** 2).mean(1)
        return np.repeat(1 + error**2 * power, len(white) // len(power))

    def _moved(
        self, fits: StrokeFits, reach: int, tried: set[tuple[int, ...]]
    ) -> tuple[NDArray[np.int64], Array]:  # fmt: skip
        """Hypotheses about points ``reach`` places beside those of the best ones.

        Combinations of points in ``tried`` are left out, and the new ones are added to it.
        """
        points, strokes = list[tuple[int, ...]](), list[Array]()
        leading = fits.best(self.options.widened)
        for each, own in zip(leading.points.tolist(), leading.strokes, strict=True):
            for moved in product(*(self._near(point, reach) for point in each)):
                if len(set(moved)) == len(moved) and tuple(sorted(moved)) not in tried:
                    tried.add(tuple(sorted(moved)))
                    points.append(moved)
                    strokes.append(own)
        return np.array(points), np.array(strokes)

    def _near(self, point: int, reach: int) -> list[int]:
        """A point, and those of its line so many places beside it."""
        beside = np.abs(self._place - self._place[point])
        return np.flatnonzero((self._line == self._line[point]) & ((beside == reach) | (beside == 0))).tolist()

    def _with_another(self, white: Array, points: NDArray[np.int64], strokes: Array) -> Starts:
        """Hypotheses with one more stroke each, from what they leave of the frame."""
        variance, most = self._screened(white), self.options.another
        components = self._deviations.of_points(points, self.options.stages[0][-1])
        left, information = residual_information(self._coarse, white, points, strokes, components, variance)
        more_points, more_strokes = [], []
        for each, own, residual, precise in zip(points.tolist(), strokes, left, information, strict=True):
            for point, stroke in zip(*self._atoms.another(residual, precise, variance, most), strict=True):
                if point not in each:
                    more_points.append([*each, int(point)])
                    more_strokes.append([*own, stroke])
        shape = -1, points.shape[1] + 1
        return Starts(np.array(more_points, np.int64).reshape(shape), np.array(more_strokes).reshape(*shape, SIZE))

    def _exchanged(self, white: Array, fits: StrokeFits) -> Starts:
        """The best hypotheses with each of their strokes in turn sought anew beside the others."""
        leading, touches = fits.best(self.options.widened), fits.points.shape[1]
        others = [[k for k in range(touches) if k != number] for number in range(touches)]
        points = np.concatenate([leading.points[:, each] for each in others])
        return self._with_another(white, points, np.concatenate([leading.strokes[:, each] for each in others]))

    def _answer(self, fits: StrokeFits, gain: float, size: int) -> TouchesAtOnce:
        misfit = float(fits.misfit[0]) / size
        # What nothing explains does not tell points apart.
        probability = softmax(fits.evidence / max(1.0, misfit))
        if fits.points.shape[1] > 1:
            probability *= 1 - self.options.missed
        touches = []
        for point, stroke in zip(fits.points[0].tolist(), fits.strokes[0], strict=True):
            share = float(probability[(fits.points == point).any(1)].sum())
            touches.append(
                FoundTouch(
                    best=point + 1,
                    probability=share,
                    time=float(stroke[0]),
                    height=float(np.exp(stroke[SIZE - 1])),
                    held=float(np.exp(stroke[2])),
                    least_probability=self.options.likely,
                )
            )
        return TouchesAtOnce(tuple(sorted(touches, key=lambda touch: touch.time)), gain, misfit)
