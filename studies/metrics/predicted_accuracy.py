"""Accuracy of as-built sensors by the default decoder, predicted in a fraction of a second: taps, presses, multi-sines.

A run trains and evaluates for minutes. This prediction is of its touches, its decoder, its noise and its sensors: they
are drawn with the tolerances that the decoder assumes of a sensor that nobody calibrated, whose microphones differ too,
touched, and decided by the tolerance-aware decoder, as
:class:`studies.evaluation.headline.HeadlineTouches` does, but in frequency bins (:mod:`studies.metrics.touch_bins`,
:mod:`studies.metrics.binned_decoder`). ``python -m benchmarks.as_built_accuracy`` compares it with full decoding.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.batch.network import batch_response
from acoustic_fem.library.touch_pressure import membranes_in_vacuo
from acoustic_fem.membrane.design_discs import design_disc, design_rubber
from acoustic_fem.membrane.disc import DiscResponse, KnownDiscs
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from acoustic_fem.scatter.air_and_rubber import DrawnAirAndRubber
from acoustic_fem.scatter.as_built_sensors import AsBuiltSensors
from acoustic_fem.scatter.tolerances import UNCALIBRATED, ScatteredDesign, Tolerance
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray
from geometry.schema.array_fields import Air
from localize.decoders.decoder_options import HypothesisOptions
from localize.signals.noise_model import microphone_noise
from localize.signals.stimulus import SCALED_AT
from studies.metrics.binned_decoder import (
    BinnedHypotheses,
    BinnedOptions,
    binned_hypotheses,
    expected_gain,
    plain_scores,
    scores,
)
from studies.metrics.touch_bins import BINS, COUNT, NODES, TOUCHES, Touch, from_nodes, noise_in_bins, touch_frames

DECODERS = {False: "tolerance-aware decoder, not calibrated", True: "Bayes decoder of each sensor's own library"}
"""Decoder that an accuracy is of, by whether the sensor is calibrated."""
CALIBRATION_ERROR = 0.01
"""Error of the transfer functions of a calibrated sensor's library, one standard deviation, nepers and radians."""
FORCES = (1e-6, 100.0)
"""Least and largest force of a touch, N."""
SILENT = 1e-9
"""Transfer function below which a microphone detects nothing of a point, Pa/Pa."""
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
_DRAWN: dict[tuple[Air, int], DrawnAirAndRubber] = {}
_NOISE_SEED, _CALIBRATION_SEED = 1, 2
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
    right = _right_of_design(resolve_design(design), force, calibrated, sensors, _Chance(seed), known, tolerances)
    found = [_accuracy(each, SCATTER[force is None]) for each in right]
    taps, presses, sines = found[::2]
    as_designed = NominalAccuracy(*found[1::2])
    return AsBuiltAccuracy(taps, presses, sines, as_designed, DECODERS[calibrated], sensors, force)


def as_built_accuracies(designs: Sequence[DesignLike], **options: Any) -> list[AsBuiltAccuracy]:
    """Predicted top-1 accuracies of as-built sensors of several designs; options as of :func:`as_built_accuracy`."""
    return [as_built_accuracy(each, **options) for each in designs]


def swept_accuracies(
    designs: Sequence[ArrayDesign], *, sensors: int, known: KnownDiscs | None = None
) -> Mapping[str, Array]:
    """Mean accuracies of as-built sensors of the designs of a sweep for a run's touches, (n_design,) of each kind.

    This takes a third of the time of :func:`as_built_accuracy`, because the sensor as designed is left out and the
    decoder is followed less finely. Accuracies of the same sensors differ by 1 percentage point rms.

    Args:
        designs: the arrays.
        sensors: number of as-built sensors of each.
        known: membranes that need not be solved.

    Raises:
        Refusal: as :func:`as_built_accuracy`.
    """
    chance = _Chance(0)
    rows = [
        [each.mean() for each in _right_of_design(design, None, False, sensors, chance, known, swept=_SWEPT)]
        for design in designs
    ]
    return dict(zip(TOUCHES, np.array(rows).T, strict=True))


def _right_of_design(
    design: ArrayDesign,
    force: float | None,
    calibrated: bool,
    sensors: int,
    chance: _Chance,
    known: KnownDiscs | None,
    tolerances: Sequence[Tolerance] = UNCALIBRATED,
    swept: BinnedOptions | None = None,
) -> list[NDArray[np.bool_]]:
    """True for each touch that is assigned to its point, (n_sensor, n_point).

    Kind by kind: those of as-built sensors, then those of the sensor as designed, which a sweep leaves out.
    """
    for count, field in ((design.point_count, "lines.points"), (len(design.microphones), "microphones")):
        if count < 2:
            allowed = "at least 2, because one alone tells no points apart"
            raise Refusal(kind=Kind.UNSUITABLE, field=field, value=count, allowed=allowed)
    options = swept or BinnedOptions()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ModelLimitWarning)
        array = _BinnedArray(design, known, tolerances)
        built = array.built(sensors, chance.seed)
        tables = None if calibrated else array.hypotheses(options)
        cavity = array.cavity(force)
    noise = noise_in_bins(microphone_noise(design.microphone, design_air(design)))
    again = max(1, min(sensors, NOMINAL_TOUCHES // design.point_count))
    several = (built, np.repeat(array.nominal[None], again, 0)) if swept is None else (built,)
    sets = [
        _touched(
            _frames(touch, cavity, force), of_sensors, array.nominal, noise, leak, chance.draw(kind, whose, of_sensors)
        )
        for kind, touch in enumerate(TOUCHES)
        for whose, of_sensors in enumerate(several)
        for leak in [0.0 if whose or calibrated else LEAK_LEFT]
    ]
    if tables is None:
        libraries = _measured(np.concatenate([built, array.nominal[None]]), chance.seed)
        right = [_right_by_library(each, libraries, noise, number % 2 == 1) for number, each in enumerate(sets)]
    else:
        right = _right(sets, tables, noise, options)
    return [each.reshape(-1, design.point_count) for each in right]


class _BinnedArray:
    """Transfer functions of a design and of sensors about it in bins."""

    def __init__(self, design: ArrayDesign, known: KnownDiscs | None, tolerances: Sequence[Tolerance]) -> None:
        self._design, self._known, self._air = design, known, design_air(design)
        self._unknown = ScatteredDesign(design, UNCALIBRATED, known)
        alike = tuple(tolerances) == UNCALIBRATED
        self._scattered = self._unknown if alike else ScatteredDesign(design, tolerances, known)
        both = np.sort(np.concatenate([NODES, BINS]))
        self._response = batch_response(self._scattered.nominal, self._scattered.topology, both, self._air)
        self._at_nodes = np.searchsorted(both, NODES)
        found = _floored(np.asarray(self._response.transfer_function[0]))
        self.nominal: ComplexArray = found[..., np.searchsorted(both, BINS)]
        """Transfer functions of the design, (n_point, n_microphone, n_bin), Pa/Pa."""
        self._on_nodes = found[..., self._at_nodes]

    def built(self, count: int, seed: int) -> ComplexArray:
        """Transfer functions of as-built sensors, (count, n_point, n_microphone, n_bin), Pa/Pa."""
        factors = self._factors(self._scattered, count, seed, None)
        return np.asarray(self.nominal * np.exp(factors @ _to_bins()))

    def hypotheses(self, options: BinnedOptions) -> BinnedHypotheses:
        """Hypotheses of the decoder."""
        assumed = HypothesisOptions()
        drawn = _air_and_rubber(self._design, options.draws)
        factors = self._factors(self._unknown, options.draws, assumed.seed, drawn)
        return binned_hypotheses(self.nominal, factors, np.abs(self._on_nodes), _to_bins(), options)

    def cavity(self, force: float | None) -> tuple[ComplexArray, ComplexArray]:
        """Pressures in the cavities per stroke: at the nodes, and of each point over that in bins.

        (n_node,), and (n_point, n_bin); Pa/N with a force, otherwise over the value at 30 Hz.
        """
        design = self._design

        def of_kind(alike: ArrayDesign) -> DiscResponse:
            return design_disc(alike, known=self._known).response(NODES, design_rubber(alike))

        flow = 2j * np.pi * NODES * membranes_in_vacuo(design, of_kind).volume_per_force
        per_force = flow * np.asarray(self._response.point_impedance[0])[:, self._at_nodes]
        level = np.log(np.abs(per_force)) + 1j * np.unwrap(np.angle(per_force))
        if force is None:
            level = level - (level.real @ from_nodes(np.array([SCALED_AT])))
        mean = level.mean(0)
        return np.exp(mean), np.exp((level - mean) @ _to_bins())

    def _factors(
        self, scattered: ScatteredDesign, count: int, seed: int, drawn: DrawnAirAndRubber | None
    ) -> ComplexArray:
        """Logarithms of the factors of sensors, (count, n_point, n_microphone, n_node) complex64."""
        sensors = AsBuiltSensors(scattered, NODES, self._air)
        ratio = _floored(sensors.transfer_functions(scattered.draws(0, count, seed), drawn)) / self._on_nodes
        return np.asarray(np.log(np.abs(ratio)) + 1j * np.unwrap(np.angle(ratio)), np.complex64)


def _air_and_rubber(design: ArrayDesign, count: int) -> DrawnAirAndRubber | None:
    """Air and rubber that the decoder assumes of its draws; kept, because designs of a batch share their air."""
    assumed, key = HypothesisOptions(), (design.air, count)
    if assumed.air_and_rubber is None:
        return None
    if key not in _DRAWN:
        _DRAWN.clear()
        _DRAWN[key] = assumed.air_and_rubber.draws(0, count, assumed.seed, design, design_air(design))
    return _DRAWN[key]


def _floored(response: ComplexArray) -> ComplexArray:
    """Transfer functions of at least :data:`SILENT`: below, rounding would be all that distinguishes sensors."""
    return np.where(np.abs(response) < SILENT, SILENT, response)


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
    return np.asarray(sensors * np.exp((error[0] + 1j * error[1]) @ _to_bins()))


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


@lru_cache(maxsize=1)
def _to_bins() -> Array:
    """Matrix from values at the nodes to those in bins, (n_node, n_bin)."""
    return from_nodes(BINS)
