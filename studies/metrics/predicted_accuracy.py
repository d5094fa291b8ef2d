"""Accuracy of as-built sensors by the default decoder, predicted in a fraction of a second: taps, presses, multi-sines.

A run trains and evaluates for minutes. This prediction is of its touches, its decoder, its noise and its sensors: they
are drawn with the tolerances that the decoder assumes of a sensor that nobody calibrated, whose microphones differ too,
touched, and decided by the tolerance-aware decoder, as
:class:`studies.evaluation.headline.HeadlineTouches` does, but in frequency bins (:mod:`studies.metrics.touch_bins`,
:mod:`studies.metrics.binned_decoder`). ``python -m benchmarks.as_built_accuracy`` compares it with full decoding.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.membrane.disc import KnownDiscs
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.tolerances import UNCALIBRATED, Tolerance
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray
from localize.signals.noise_model import microphone_noise
from studies.metrics.binned_arrays import BinnedArray, binned_arrays, drawn_sensors, to_bins
from studies.metrics.binned_decoder import (
    BinnedHypotheses,
    BinnedOptions,
    expected_gain,
    plain_scores,
    scores,
)
from studies.metrics.touch_bins import COUNT, NODES, TOUCHES, Touch, noise_in_bins, touch_frames

DECODERS = {False: "tolerance-aware decoder, not calibrated", True: "Bayes decoder of each sensor's own library"}
"""Decoder that an accuracy is of, by whether the sensor is calibrated."""
CALIBRATION_ERROR = 0.01
"""Error of the transfer functions of a calibrated sensor's library, one standard deviation, nepers and radians."""
FORCES = (1e-6, 100.0)
"""Least and largest force of a touch, N."""
LEAK_LEFT = 0.0075
"""Fraction, in amplitude, of what leaks into a bin of an as-built sensor from other frequencies and stays after the
decoder takes the leak away.

The decoder knows how a frame's edges smear a touch, but only for transfer functions that are right, and a hypothesis
fits an as-built sensor to a percent or so. The rest is random from microphone to microphone. It matters for slow
touches, whose spectrum falls steeply. Between 0 and 0.03 it was chosen on designs 1000 to 1039 of
benchmarks/as_built_accuracy.py and on the contacts of designs 10 to 24 of benchmarks/verdicts.py. On a sensor that
equals its library, nothing stays."""
NOMINAL_TOUCHES = 360
"""Largest number of touches of each kind on the sensor as designed; at most one per as-built sensor and point."""
SCATTER = {True: 0.19, False: 0.2}
"""Scatter of the error of a prediction m, by sqrt(m (1 - m)): of the touches of a run, and of a given force."""
LEAST_SCATTER = 0.015
"""Half of the interval of a prediction of 0 or 1. It was widened from 0.01 because one of 41 designs of
benchmarks/verdicts.py decoded 0.1 points below its interval."""
_NOISE_SEED, _CALIBRATION_SEED = 1, 2
_KEPT = 100_000_000
"""Memory of the drawn sensors of a sweep's designs that are kept for more touches, bytes."""
_SWEPT = BinnedOptions(draws=96, splits=2)
"""Half of the draws and of the hypotheses of :func:`as_built_accuracy`, because this takes two thirds of the time.
Accuracies of the same sensors differ by 1 percentage point rms."""


@dataclass(frozen=True, eq=False)
class TouchAccuracy:
    """Predicted top-1 accuracy of one kind of touches, fractions from 0 to 1."""

    mean: float
    """Mean over the sensors."""
    worst: float
    """Fifth percentile of the sensors."""
    low: float
    """Lower end of the interval that held the mean of sensors decoded in full for 9 of 10 designs."""
    high: float
    """Upper end of this interval."""
    per_point: Array
    """Fraction of the touches of each point that are assigned to it, (n_point,) float64."""

    def to_dict(self) -> dict[str, Any]:
        """Figures as JSON can hold them."""
        return {**asdict(self), "per_point": self.per_point.tolist()}


@dataclass(frozen=True, eq=False)
class NominalAccuracy:
    """Predicted top-1 accuracies of the sensor as designed."""

    taps: TouchAccuracy
    presses: TouchAccuracy
    multi_sines: TouchAccuracy


@dataclass(frozen=True, eq=False)
class AsBuiltAccuracy:
    """Predicted top-1 accuracies of as-built sensors of a design."""

    taps: TouchAccuracy
    """Accuracy for taps of a finger."""
    presses: TouchAccuracy
    """Accuracy for presses of a finger."""
    multi_sines: TouchAccuracy
    """Accuracy for the publication's multi-sine touches, whose level does not depend on a force."""
    nominal: NominalAccuracy
    """The same accuracies for the sensor as designed."""
    decoder: str
    """Decoder, in words."""
    sensors: int
    """Number of as-built sensors that were drawn."""
    force: float | None
    """Peak force of taps and presses, N; None for the peaks of a run's touches."""

    def to_dict(self) -> dict[str, Any]:
        """Figures as JSON can hold them."""
        return {
            **{touch: getattr(self, touch).to_dict() for touch in TOUCHES},
            "nominal": {touch: getattr(self.nominal, touch).to_dict() for touch in TOUCHES},
            "decoder": self.decoder,
            "sensors": self.sensors,
            "force": self.force,
        }


def as_built_accuracy(
    design: DesignLike,
    *,
    force: float | None = 0.1,
    calibrated: bool = False,
    sensors: int = 64,
    seed: int = 0,
    known: KnownDiscs | None = None,
    tolerances: Sequence[Tolerance] = UNCALIBRATED,
) -> AsBuiltAccuracy:
    """Predicted top-1 accuracies of as-built sensors of a design by the default decoder.

    Args:
        design: the array.
        force: peak force of taps and presses, N; None for peaks of 0.03 to 30 Pa in the cavity, which are the touches
            that a run is evaluated on.
        calibrated: True if each sensor is decoded by a library of its own that is right to 1 %; by default nobody
            calibrates it.
        sensors: number of as-built sensors, 4 to 1000.
        seed: seed of their deviations.
        known: membranes that need not be solved.
        tolerances: of manufacturing; by default those of a sensor that nobody calibrated, with microphones of unequal
            gain and corner, as a run has them. :data:`acoustic_fem.scatter.TOLERANCES` are a careful workshop's.

    Raises:
        Refusal: a number out of range, fewer than two points or microphones, or a design whose scatter is not known.
    """
    if force is not None:
        check_range("force", force, *FORCES, "N")
    check_range("sensors", sensors, 4, 1000, whole=True)
    plan, touches = _Plan(calibrated, sensors, tuple(tolerances), BinnedOptions()), SweptTouches(force, designed=True)
    chance = _Chance(seed)
    ((_, drawn),) = _drawn([resolve_design(design)], plan, chance, known)
    right = _right_of_design(drawn, touches, plan, chance)
    found = [_accuracy(each, SCATTER[force is None]) for each in right]
    taps, presses, sines = found[::2]
    as_designed = NominalAccuracy(*found[1::2])
    return AsBuiltAccuracy(taps, presses, sines, as_designed, DECODERS[calibrated], sensors, force)


def as_built_accuracies(designs: Sequence[DesignLike], **options: Any) -> list[AsBuiltAccuracy]:
    """Predicted top-1 accuracies of as-built sensors of several designs; options as of :func:`as_built_accuracy`."""
    return [as_built_accuracy(each, **options) for each in designs]


@dataclass(frozen=True)
class SweptTouches:
    """Touches whose accuracy is asked for."""

    force: float | None = None
    """Peak force of taps and presses, N; None for the touches of a run."""
    designed: bool = False
    """True if the sensor as designed is touched too."""


class SweptAccuracies:
    """Mean accuracies of as-built sensors of the designs of a sweep.

    They take a third of the time of :func:`as_built_accuracy`, because the decoder is followed less finely. Accuracies
    of the same sensors differ by 1 percentage point rms.

    Args:
        designs: the arrays.
        sensors: number of as-built sensors of each.
        known: membranes that need not be solved.
    """

    def __init__(self, designs: Sequence[ArrayDesign], sensors: int, known: KnownDiscs | None = None) -> None:
        self._designs, self._known = designs, known
        self._plan, self._chance = _Plan(False, sensors, UNCALIBRATED, _SWEPT), _Chance(0)
        self._kept: dict[int, _Drawn] = {}

    def of(self, asked: Mapping[int, SweptTouches]) -> dict[int, Array]:
        """Accuracies of some of the designs by their numbers.

        Args:
            asked: touches of each of them.

        Returns:
            By number the accuracies of each kind in the order of :data:`TOUCHES`, (n_kind,) float64, fractions; if the
            sensor as designed is asked for, each is followed by that of this sensor.

        Raises:
            Refusal: as :func:`as_built_accuracy`.
        """
        found: dict[int, Array] = {}

        def take(number: int, drawn: _Drawn) -> None:
            right = _right_of_design(drawn, asked[number], self._plan, self._chance)
            found[number] = np.array([each.mean() for each in right])

        for number in asked:
            if number in self._kept:
                take(number, self._kept[number])
        left = [number for number in asked if number not in self._kept]
        for place, drawn in _drawn([self._designs[number] for number in left], self._plan, self._chance, self._known):
            take(left[place], drawn)
            if sum(each.size for each in self._kept.values()) < _KEPT:
                self._kept[left[place]] = drawn
        return found


@dataclass(frozen=True)
class _Plan:
    """Sensors and decoder of a prediction."""

    calibrated: bool
    sensors: int
    tolerances: tuple[Tolerance, ...]
    options: BinnedOptions


@dataclass(frozen=True, eq=False)
class _Drawn:
    """Sensors of a design in bins."""

    array: BinnedArray
    built: ComplexArray
    """Transfer functions of as-built sensors, (n_sensor, n_point, n_microphone, n_bin), Pa/Pa."""
    tables: BinnedHypotheses | None
    """Hypotheses of the decoder; None if each sensor has a library of its own."""

    @property
    def size(self) -> int:
        """Memory of the arrays, bytes."""
        tables = 0 if self.tables is None else self.tables.response.nbytes + self.tables.shapes.nbytes
        return self.built.nbytes + tables


def _drawn(
    designs: Sequence[ArrayDesign], plan: _Plan, chance: _Chance, known: KnownDiscs | None
) -> Iterator[tuple[int, _Drawn]]:
    """Numbers of designs, and their sensors."""
    for design in designs:
        for count, field in ((design.point_count, "lines.points"), (len(design.microphones), "microphones")):
            if count < 2:
                allowed = "at least 2, because one alone tells no points apart"
                raise Refusal(kind=Kind.UNSUITABLE, field=field, value=count, allowed=allowed)
    options = None if plan.calibrated else plan.options
    rows = plan.sensors + (0 if options is None else options.draws)
    for numbers, arrays in binned_arrays(designs, known, plan.tolerances, rows):
        drawn = drawn_sensors(arrays, plan.sensors, chance.seed, options)
        for number, array, (built, tables) in zip(numbers, arrays, drawn, strict=True):
            yield number, _Drawn(array, built, tables)


def _right_of_design(drawn: _Drawn, touches: SweptTouches, plan: _Plan, chance: _Chance) -> list[NDArray[np.bool_]]:
    """True for each touch that is assigned to its point, (n_sensor, n_point).

    Kind by kind: those of as-built sensors, then those of the sensor as designed if it is asked for.
    """
    array, built, tables, force = drawn.array, drawn.built, drawn.tables, touches.force
    design, cavity = array.design, array.cavity(force)
    noise = noise_in_bins(microphone_noise(design.microphone, design_air(design)))
    again = max(1, min(plan.sensors, NOMINAL_TOUCHES // design.point_count))
    several = (built, np.repeat(array.nominal[None], again, 0)) if touches.designed else (built,)
    sets = [
        _touched(
            _frames(touch, cavity, force), of_sensors, array.nominal, noise, leak, chance.draw(kind, whose, of_sensors)
        )
        for kind, touch in enumerate(TOUCHES)
        for whose, of_sensors in enumerate(several)
        for leak in [0.0 if whose or plan.calibrated else LEAK_LEFT]
    ]
    if tables is None:
        libraries = _measured(np.concatenate([built, array.nominal[None]]), chance.seed)
        kinds = enumerate(sets)
        right = [_right_by_library(each, libraries, noise, number % len(several) == 1) for number, each in kinds]
    else:
        right = _right(sets, tables, noise, plan.options)
    return [each.reshape(-1, design.point_count) for each in right]


@dataclass(frozen=True, eq=False)
class _Touches:
    """Touches of every point of some sensors, sensor by sensor."""

    frames: ComplexArray
    """(n, n_microphone, n_bin), Pa."""
    gain: Array
    """Expected signal of each over the noise, as :func:`studies.metrics.binned_decoder.expected_gain`; (n, n_bin)."""


def _frames(
    touch: Touch, cavity: tuple[ComplexArray, ComplexArray], force: float | None
) -> tuple[ComplexArray, Array, ComplexArray]:
    """Pressures in a cavity by touches, (COUNT, n_bin), what leaks, and how each point differs, (n_point, n_bin)."""
    of_point = np.ones_like(cavity[1]) if touch == "multi_sines" else cavity[1]
    return *touch_frames(touch, cavity[0], force), of_point


class _Chance:
    """Touches of the points and the noise of each, drawn once for all designs that have equally many parts."""

    def __init__(self, seed: int) -> None:
        self.seed = seed
        self._drawn: dict[tuple[int, ...], tuple[NDArray[np.int64], ComplexArray]] = {}

    def draw(self, kind: int, whose: int, sensors: ComplexArray) -> tuple[NDArray[np.int64], ComplexArray]:
        """Number of the touch of each point of some sensors, and its noise of mean square 1 in each bin.

        (n_sensor, n_point), and as the sensors, (n_sensor, n_point, n_microphone, n_bin) complex64. Those of as-built
        sensors do not depend on others.
        """
        key = (kind, whose, *sensors.shape)
        if key not in self._drawn:
            random = np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=(_NOISE_SEED, kind, whose)))
            count, points = sensors.shape[:2]
            # Every point has the same number of each touch, so that points differ by themselves.
            order = np.stack([random.permutation(max(count, COUNT))[:count] % COUNT for _ in range(points)], 1)
            parts = random.standard_normal((2, *sensors.shape)) / np.sqrt(2)
            self._drawn[key] = order, (parts[0] + 1j * parts[1]).astype(np.complex64)
        return self._drawn[key]


def _touched(
    frames: tuple[ComplexArray, Array, ComplexArray],
    sensors: ComplexArray,
    nominal: ComplexArray,
    noise: Array,
    leak: float,
    drawn: tuple[NDArray[np.int64], ComplexArray],
) -> _Touches:
    """A touch of each point of each of the sensors.

    Args:
        frames: pressures in a cavity by touches, as of :func:`_frames`.
        sensors: transfer functions, (n_sensor, n_point, n_microphone, n_bin).
        nominal: those of the design, (n_point, n_microphone, n_bin).
        noise: mean square of the noise in each bin, (n_bin,), Pa^2.
        leak: fraction of what leaks into a bin that stays.
        drawn: touches and noise, as of :meth:`_Chance.draw`.
    """
    order, white = drawn
    near, leaked, of_point = frames
    heard = (near[order] * of_point)[:, :, None] * sensors
    left = leak * (leaked[order] * np.abs(of_point))[:, :, None] * np.abs(sensors)
    heard = heard + white * np.sqrt(noise + left**2)
    gain = expected_gain(heard, nominal, noise)
    return _Touches(heard.reshape(-1, *heard.shape[2:]), gain.reshape(-1, gain.shape[-1]))


def _right(
    sets: list[_Touches], tables: BinnedHypotheses, noise: Array, options: BinnedOptions
) -> list[NDArray[np.bool_]]:
    """True for each touch that the decoder of a sensor that nobody calibrated assigns to its point, set by set."""
    frames, gain = np.concatenate([each.frames for each in sets]), np.concatenate([each.gain for each in sets])
    named = scores(frames, gain, tables, noise, options).argmax(1)
    right = named == np.arange(len(named)) % len(tables.response)
    return np.split(right, np.cumsum([len(each.frames) for each in sets])[:-1])


def _measured(sensors: ComplexArray, seed: int) -> ComplexArray:
    """Libraries of calibrated sensors, right to :data:`CALIBRATION_ERROR`; errors are smooth over frequency."""
    random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(_CALIBRATION_SEED,)))
    error = random.standard_normal((2, *sensors.shape[:3], len(NODES))) * CALIBRATION_ERROR / np.sqrt(2)
    return np.asarray(sensors * np.exp((error[0] + 1j * error[1]) @ to_bins()))


def _right_by_library(touches: _Touches, libraries: ComplexArray, noise: Array, is_nominal: bool) -> NDArray[np.bool_]:
    """True for each touch that the library of its own sensor, the last one the nominal, assigns to its point."""
    points = libraries.shape[1]
    own = libraries[-1:] if is_nominal else libraries[:-1]
    parts = zip(np.split(touches.frames, len(own)), np.split(touches.gain, len(own)), own, strict=True)
    named = [plain_scores(frames, gain, library, noise).argmax(1) for frames, gain, library in parts]
    right = np.concatenate(named) == np.arange(len(touches.frames)) % points
    return np.asarray(right)


def _accuracy(right: NDArray[np.bool_], scatter: float) -> TouchAccuracy:
    """Accuracy from touches that were assigned correctly, (n_sensor, n_point), with the scatter of its error."""
    of_sensors = right.mean(1)
    mean = float(right.mean())
    # Few touches of a sensor spread its accuracy by chance, which is taken out of the percentile.
    spread, by_chance = of_sensors.var(), (right.var(1) / max(1, right.shape[1] - 1)).mean()
    own = np.sqrt(max(0.0, 1 - by_chance / spread)) if spread > 0 else 0.0
    worst = mean + float(own) * (float(np.percentile(of_sensors, 5)) - mean)
    half = LEAST_SCATTER + scatter * float(np.sqrt(mean * (1 - mean)))
    return TouchAccuracy(mean, worst, max(0.0, mean - half), min(1.0, mean + half), right.mean(0))
