"""How well a localizer does where things are not as they were in training: one condition changed at a time.

Sensors that are made differently from their design need a model of their scatter, which is not this package's:
:func:`evaluate_sensors` takes their transfer functions from whoever has one.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import scipy.stats
from numpy.typing import NDArray

from localize.evaluation.accuracy import Evaluation, Reliability, check_evaluation, wilson_interval
from localize.evaluation.held_out import TAPS_AND_PRESSES, TouchedSensors, TouchKinds, decide
from localize.live.stream_options import HIGH_PASS
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import FRAME
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice
from localize.signals.stimulus_kinds import STIMULI

NOISES = (0.0, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1)
"""Levels of white noise, Pa rms over 0 to 500 Hz; 1e-3 is 60 dB below 94 dB SPL."""
AMBIENT_LEVELS = (50.0, 60.0, 70.0, 80.0, 90.0)
"""Levels of the sound outside, dB SPL."""
LENGTHS = (250, 500, 750, 1000)
"""Lengths of the signals, samples: one to four frames."""


@dataclass(frozen=True)
class Condition:
    """Condition that departs in one thing from the usual evaluation."""

    group: str
    """Name of what is changed."""
    name: str
    """Name of what it is changed to, in words with the unit."""
    value: float | None
    """Number that it is changed to, in its unit, where it is one."""
    sensor: dict[str, Any] = field(default_factory=dict)
    """Arguments of :class:`localize.evaluation.held_out.TouchedSensors` that differ."""
    kinds: TouchKinds | None = None
    """Kinds of the touches, where these differ."""
    samples: int = FRAME
    """Length of each signal, samples."""


@dataclass(frozen=True)
class Outcome:
    """Result of a localizer under a condition; shares run from 0 to 1."""

    group: str
    """Name of what is changed."""
    name: str
    """Name of what it is changed to, in words with the unit."""
    value: float | None
    """Number that it is changed to, in its unit, where it is one."""
    signals: str
    """Name of the touches, in the plural."""
    sensors: int
    """Number of sensors."""
    top1: float
    """Share of touches whose most probable point is the right one."""
    top2: float
    """Share of touches whose right point is among the two most probable ones."""
    within_one: float
    """Share of touches whose most probable point is the right one or a neighbour on its line."""
    expected_calibration_error: float
    """Expected calibration error of the stated probabilities, over the touches of all sensors."""
    touches: int
    """Number of touches, of all sensors together."""
    low: float
    """Lower end of the 95 % interval of top-1: of touches by :func:`localize.evaluation.accuracy.wilson_interval`;
    where there were several sensors, of their mean by Student's t, for they differ more than chance."""
    high: float
    """Upper end of that interval, of one."""
    worst: float | None = None
    """Top-1 of the worst sensor, of one, where there were several."""


def conditions(response: ArrayResponse) -> tuple[Condition, ...]:
    """Conditions that an array allows: ambient sound needs a design that tells what it does."""
    loud = AMBIENT_LEVELS if response.ambient_response is not None else ()
    return (
        *(Condition("microphone noise", f"{rms:g} Pa", rms, {"microphone_noise": rms}) for rms in NOISES),
        *(Condition("ambient sound", f"{level:g} dB SPL", level, {"ambient": level}) for level in loud),
        *(
            Condition("stimulus", name, None, kinds=TouchKinds(name, (source,), HIGH_PASS))
            for name, source in STIMULI.items()
        ),
        *(Condition("length", f"{count} ms", float(count), samples=count) for count in LENGTHS),
    )


def evaluate_conditions(
    localizer: Locator,
    response: ArrayResponse,
    touches_per_point: int,
    microphone_noise: NoiseChoice,
    seed: int = 0,
    progress: Callable[[str, float], None] | None = None,
    *,
    kinds: TouchKinds = TAPS_AND_PRESSES,
) -> list[Outcome]:
    """Results of a localizer under one condition after the other.

    Args:
        localizer: anything that :func:`localize.evaluate` takes.
        response: the array that is touched.
        touches_per_point: in each condition, rounded to as many of each kind.
        microphone_noise: where the condition is not the noise.
        seed: any non-negative integer.
        progress: called with the condition and the fraction done.
        kinds: the touches, where the condition is not the stimulus.

    Raises:
        Refusal: as :func:`localize.evaluate`.
    """
    check_evaluation(localizer, response, touches_per_point, microphone_noise)
    chosen = conditions(response)
    found = []
    for number, condition in enumerate(chosen):
        if progress:
            progress(f"{condition.group} {condition.name}", number / len(chosen))
        sensors = TouchedSensors(response, **{"microphone_noise": microphone_noise, "seed": seed, **condition.sensor})
        touched = condition.kinds or kinds
        touches = sensors.touches(touched, of_each_kind(touches_per_point, touched), condition.samples)
        results = decide(localizer, touches).by_sensor()
        found.append(outcome_of(condition.group, condition.name, condition.value, touched.name, results))
    return found


def evaluate_sensors(
    localizer: Locator,
    response: ArrayResponse,
    sensors: Sequence[tuple[str, float | None, NDArray[np.complex128]]],
    touches_per_point: int,
    microphone_noise: NoiseChoice,
    seed: int = 0,
    group: str = "as-built sensors",
    *,
    kinds: TouchKinds = TAPS_AND_PRESSES,
) -> list[Outcome]:
    """Results of a localizer on sensors that were made differently from the library's.

    Args:
        localizer: anything that :func:`localize.evaluate` takes.
        response: the array of the library.
        sensors: sets of sensors: name, scatter where it is a number, and (n_sensor, n_point, n_microphone, n_freq)
            complex128 transfer functions on the frequencies of the library, Pa/Pa.
        touches_per_point: of each sensor, rounded to as many of each kind.
        microphone_noise: as :func:`localize.evaluate`.
        seed: any non-negative integer.
        group: of the outcomes.
        kinds: the touches.

    Raises:
        Refusal: as :func:`localize.evaluate`.
    """
    check_evaluation(localizer, response, touches_per_point, microphone_noise)
    found = []
    for name, value, made in sensors:
        sensors_touched = TouchedSensors(response, microphone_noise, seed, sensors=made)
        touches = sensors_touched.touches(kinds, of_each_kind(touches_per_point, kinds))
        found.append(outcome_of(group, name, value, kinds.name, decide(localizer, touches).by_sensor()))
    return found


def of_each_kind(touches: float, kinds: TouchKinds) -> int:
    """Number of touches of each kind, at least one, where so many are wanted of all kinds together."""
    return max(1, round(touches / len(kinds.sources)))


def outcome_of(group: str, name: str, value: float | None, signals: str, results: Sequence[Evaluation]) -> Outcome:
    """Outcome of results on the touches of one sensor, or of several that have as many touches each."""

    def mean(field: str) -> float:
        return float(np.mean([getattr(result, field) for result in results]))

    low, high = interval_of(results)
    return Outcome(
        group=group,
        name=name,
        value=value,
        signals=signals,
        sensors=len(results),
        top1=mean("top1"),
        top2=mean("top2"),
        within_one=mean("within_one"),
        expected_calibration_error=Reliability.pooled([result.reliability for result in results]).expected_error,
        touches=sum(result.touches for result in results),
        low=low,
        high=high,
        worst=min(result.top1 for result in results) if len(results) > 1 else None,
    )


def interval_of(results: Sequence[Evaluation], name: str = "top1") -> tuple[float, float]:
    """95 % interval of ``top1``, ``top2`` or ``within_one``: Wilson's of the touches of one sensor; of several sensors
    Student's t of their mean, because they differ more than chance.
    """
    shares = np.array([getattr(result, name) for result in results])
    if len(shares) == 1:
        return wilson_interval(float(shares[0]), results[0].touches)
    half = scipy.stats.t.ppf(0.975, len(shares) - 1) * shares.std(ddof=1) / np.sqrt(len(shares))
    low, high = np.clip([shares.mean() - half, shares.mean() + half], 0.0, 1.0)
    return float(low), float(high)
