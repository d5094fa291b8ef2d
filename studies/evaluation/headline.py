"""Headline accuracy of a localizer: taps and presses on as-built sensors, and beside it what it is made up of.

Beside it are taps and presses apart, both on virtual rigs, which deviate in ways that no decoder is given, and on the
nominal sensor; then the publication's multi-sine touches, on as-built sensors and on the nominal one. No sensor is
calibrated.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from typing import Any

from acoustic_fem import Library
from localize.evaluation.accuracy import Evaluation, check_evaluation
from localize.evaluation.conditions import Outcome, interval_of, of_each_kind, outcome_of
from localize.evaluation.held_out import (
    MULTI_SINES,
    PRESSES,
    TAPS,
    TAPS_AND_PRESSES,
    HeldOutTouches,
    TouchedSensors,
    TouchKinds,
    decide,
)
from localize.signals.array_response import ArrayResponse
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice
from studies.evaluation.evaluated_sensors import AS_BUILT, RIG_COUNT, RIGS, SENSORS, rig_sensors, scattered_sensors

Progress = Callable[[str, float], None]
#: Name of the decoder that models manufacturing tolerances.
TOLERANT = "tolerance-aware decoder"
#: Group of the results on the sensor of the library.
NOMINAL = "nominal sensor"
#: Seed that the sensors are drawn with, and their fraction of the tolerances of a sensor that nobody calibrated.
SENSOR_SEED, WHOLE = 1, 1.0
#: Group, name and value of the results on each kind of sensors.
_NOMINAL: tuple[str, str, float | None] = (NOMINAL, "as designed", None)
_RIGS: tuple[str, str, float | None] = (RIGS, "uncalibrated", None)
_AS_BUILT: tuple[str, str, float | None] = (AS_BUILT, f"{WHOLE:g} of the tolerances", WHOLE)
#: Touches of each figure beside the headline, if there may be as many: their interval is then at most 4 points either
#: way.
LEAST = 600


@dataclass(frozen=True, eq=False, repr=False)
class Headline(Evaluation):
    """Results on taps and presses on all as-built sensors together, and those beside them.

    Where as-built sensors are not known, the headline is of taps and presses on the nominal sensor.
    """

    of_sensors: tuple[Evaluation, ...]
    """Results on each of the sensors."""
    outcomes: tuple[Outcome, ...]
    """Results beside the headline, in the order in which they are shown."""
    multi_sines: Evaluation
    """Results on multi-sine touches on the nominal sensor."""
    unscattered: str = ""
    """Reason for which as-built sensors are not among them; empty where they are."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        title, facts = super().shown()
        worst = {} if self.worst is None else {"top-1 accuracy on the worst sensor": f"{self.worst:.1%}"}
        beside = {f"top-1 accuracy for {name}": f"{each.top1:.1%}" for name, each in self.beside}
        return title, {"touches": self.signals, **facts, **worst, **beside}

    @property
    def sensors(self) -> int:
        """Number of the sensors of the headline."""
        return len(self.of_sensors)

    @property
    def signals(self) -> str:
        """Touches of the headline, and the sensors that they are on."""
        return f"{TAPS_AND_PRESSES.name} on {sensors_in_words(NOMINAL if self.unscattered else AS_BUILT, self.sensors)}"

    @property
    def worst(self) -> float | None:
        """Top-1 accuracy on the worst of several sensors; None if there is one."""
        return min(each.top1 for each in self.of_sensors) if self.sensors > 1 else None

    @property
    def outcome(self) -> Outcome:
        """The headline as an outcome."""
        sensors = _NOMINAL if self.unscattered else _AS_BUILT
        return outcome_of(*sensors, TAPS_AND_PRESSES.name, self.of_sensors)

    @property
    def beside(self) -> tuple[tuple[str, Outcome], ...]:
        """Results beside the headline, each with its touches and sensors in words."""
        return tuple(
            (f"{each.signals} on {sensors_in_words(each.group, each.sensors)}", each) for each in self.outcomes
        )

    def interval(self, name: str = "top1") -> tuple[float, float]:
        """95 % interval of ``top1``, ``top2`` or ``within_one``, by
        :func:`localize.evaluation.conditions.interval_of`.
        """
        return interval_of(self.of_sensors, name)

    def to_dict(self) -> dict[str, Any]:
        """Results as JSON can hold them."""
        found = {key: value for key, value in super().to_dict().items() if key != "by_components"}
        return {
            "signals": self.signals,
            **found,
            "worst": self.worst,
            "sensors": [each.top1 for each in self.of_sensors],
            "beside": [asdict(each) for each in self.outcomes],
            "multi_sines": self.multi_sines.to_dict(),
            **({"unscattered": self.unscattered} if self.unscattered else {}),
        }


def sensors_in_words(group: str, count: int) -> str:
    """Sensors of a result, for a sentence."""
    return f"the {NOMINAL}" if group not in (AS_BUILT, RIGS) else f"{count} {group}"


class HeadlineTouches:
    """Held-out touches of a headline, made once for all localizers; :meth:`headline` evaluates a localizer on them.

    Args:
        library: of a design.
        response: of that library.
        touches: held-out touches per point of the headline, on all its sensors together and half of them taps, but at
            least one tap and one press on each sensor. Beside the headline so many that all points together have 600,
            if they may be as many.
        microphone_noise: of the microphones.
        seed: seed of the touches.
    """

    def __init__(
        self, library: Library, response: ArrayResponse, touches: int, microphone_noise: NoiseChoice, seed: int
    ) -> None:
        few = min(touches, math.ceil(LEAST / response.point_count))
        made, self.unscattered = scattered_sensors(library, response, SENSOR_SEED, SENSORS, (WHOLE,))
        nominal = TouchedSensors(response, microphone_noise, seed)
        self._nominal = _touches(nominal, TAPS_AND_PRESSES, touches if self.unscattered else few, 1)
        self._multi_sines = _touches(nominal, MULTI_SINES, few, 1)
        if not self.unscattered:
            as_built = TouchedSensors(response, microphone_noise, seed, sensors=made[0][-1])
            self._as_built = _touches(as_built, TAPS_AND_PRESSES, touches, SENSORS)
            self._as_built_multi_sines = _touches(as_built, MULTI_SINES, few, SENSORS)
            found = rig_sensors(library, response, SENSOR_SEED, RIG_COUNT)[0][-1]
            rigs = TouchedSensors(response, microphone_noise, seed, sensors=found)
            self._rigs = _touches(rigs, TAPS_AND_PRESSES, few, RIG_COUNT)

    def headline(self, locator: Locator) -> Headline:
        """Headline of a localizer."""
        decided = decide(locator, self._nominal if self.unscattered else self._as_built)
        sensors = _NOMINAL if self.unscattered else _AS_BUILT
        outcomes = [
            outcome_of(*sensors, kinds.name, decided.by_sensor(number)) for number, kinds in enumerate((TAPS, PRESSES))
        ]
        multi_sines = decide(locator, self._multi_sines).evaluation()
        if not self.unscattered:
            rigs, nominal, sines = (
                decide(locator, each).by_sensor() for each in (self._rigs, self._nominal, self._as_built_multi_sines)
            )
            outcomes += [
                outcome_of(*_RIGS, TAPS_AND_PRESSES.name, rigs),
                outcome_of(*_NOMINAL, TAPS_AND_PRESSES.name, nominal),
                outcome_of(*_AS_BUILT, MULTI_SINES.name, sines),
            ]
        outcomes.append(outcome_of(*_NOMINAL, MULTI_SINES.name, [multi_sines]))
        return Headline(
            **vars(decided.evaluation()),
            of_sensors=tuple(decided.by_sensor()),
            outcomes=tuple(outcomes),
            multi_sines=multi_sines,
            unscattered=self.unscattered,
        )


def _touches(sensors: TouchedSensors, kinds: TouchKinds, touches: int, count: int) -> HeldOutTouches:
    """Touches per point, of all kinds and all of so many sensors together."""
    return sensors.touches(kinds, of_each_kind(touches / count, kinds))


def evaluate_headlines(
    locators: dict[str, Locator],
    library: Library,
    response: ArrayResponse,
    touches: int,
    microphone_noise: NoiseChoice,
    seed: int,
    progress: Progress,
) -> dict[str, Headline]:
    """Headline of each localizer by its name; eight seconds for three localizers of 12 points on one core.

    Args:
        locators: by name.
        library: of a design.
        response: of that library.
        touches: held-out touches per point, see :class:`HeadlineTouches`.
        microphone_noise: of the microphones.
        seed: seed of the touches.
        progress: function that is called with the name of the step and the fraction done.

    Raises:
        Refusal: as :func:`localize.evaluate`.
    """
    for locator in locators.values():
        check_evaluation(locator, response, touches, microphone_noise)
    progress("touches", 0.0)
    held_out = HeadlineTouches(library, response, touches, microphone_noise, seed)
    found = {}
    for number, (name, locator) in enumerate(locators.items()):
        progress(name, (1 + number) / (1 + len(locators)))
        found[name] = held_out.headline(locator)
    return found
