"""Headline figures of a localizer: multi-sine touches on the nominal sensor, beside them what they do not promise.

Taps on the same sensor, and the same sines on sensors that are not calibrated: made with a workshop's tolerances, which
the tolerance-aware decoder models, and virtual rigs, which deviate in ways that no decoder is given.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from acoustic_fem import Library
from localize import evaluate
from localize.evaluation.accuracy import Evaluation
from localize.evaluation.conditions import Outcome, conditions, evaluate_conditions, evaluate_sensors
from localize.signals.array_response import ArrayResponse
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice
from studies.evaluation.full_evaluation import LEAST, RIG_GROUP, RIGS, Progress, rig_sensors, scattered_sensors

#: Signals of a headline figure.
SIGNALS = "multi-sine touches on the nominal sensor"
#: Name of the decoder that models manufacturing tolerances.
TOLERANT = "tolerance-aware decoder"
#: Number of as-built sensors, the seed that they are drawn with, and their fraction of the workshop's tolerances.
SENSORS, SENSOR_SEED, WHOLE = 8, 1, 1.0


@dataclass(frozen=True, eq=False)
class Headline(Evaluation):
    """Results on multi-sine touches on the nominal sensor, and what stands beside them."""

    outcomes: tuple[Outcome, ...]
    """Results on taps, then on as-built sensors and on virtual rigs where these are known."""
    sensors: int = SENSORS
    """Number of the as-built sensors."""
    unscattered: str = ""
    """Reason for which as-built sensors are not among them; empty where they are."""

    @classmethod
    def of(cls, overall: Evaluation, outcomes: Sequence[Outcome], sensors: int, unscattered: str) -> Headline:
        """Headline of an evaluation, with those of the outcomes that belong beside it."""
        chosen = tuple(each for each in outcomes if is_beside(each.group, each.name, each.value))
        return cls(**vars(overall), outcomes=chosen, sensors=sensors, unscattered=unscattered)

    @property
    def signals(self) -> str:
        """Signals of the headline figures."""
        return SIGNALS

    @property
    def beside(self) -> tuple[tuple[str, Outcome], ...]:
        """Results beside the headline, each with its signals."""
        made = f"multi-sine touches on {self.sensors} as-built sensors"
        of_rigs = f"multi-sine touches on {RIGS} virtual rigs"

        def signals(each: Outcome) -> str:
            if each.worst is None:
                return f"{each.name} on the nominal sensor"
            return of_rigs if each.group == RIG_GROUP else made

        return tuple((signals(each), each) for each in self.outcomes)

    def to_dict(self) -> dict[str, Any]:
        """Results as JSON can hold them."""
        own = {"signals": SIGNALS, "conditions": [asdict(each) for each in self.outcomes]}
        return {**super().to_dict(), **own, **({"unscattered": self.unscattered} if self.unscattered else {})}


def is_beside(group: str, name: str, value: float | None) -> bool:
    """True for conditions beside the headline: taps, sensors with the whole tolerances, virtual rigs."""
    return (
        (group, name) == ("stimulus", "taps")
        or (group == "as-built sensors" and value == WHOLE)
        or (group == RIG_GROUP)
    )


def evaluate_headlines(
    locators: dict[str, Locator],
    library: Library,
    response: ArrayResponse,
    touches: int,
    microphone_noise: NoiseChoice,
    seed: int,
    progress: Progress,
) -> dict[str, Headline]:
    """Headline of each localizer by its name. Three seconds for the sensors, then one for each localizer of 12 points.

    Args:
        locators: by name.
        library: of a design.
        response: of that library.
        touches: held-out touches per point; beside the headline so many that all points together have 600, if they
            may be as many.
        microphone_noise: of the microphones.
        seed: seed of the touches.
        progress: function that is called with the name of the step and the fraction done.
    """
    progress("as-built sensors", 0.0)
    made, unscattered = scattered_sensors(library, response, SENSOR_SEED, SENSORS, (WHOLE,))
    rigs = [] if unscattered else rig_sensors(library, response, SENSOR_SEED, RIGS)
    few = min(touches, math.ceil(LEAST / response.point_count))
    wanted = [each for each in conditions(response) if is_beside(each.group, each.name, each.value)]
    found = {}
    for number, (name, locator) in enumerate(locators.items()):
        progress(name, (1 + number) / (1 + len(locators)))
        overall = evaluate(locator, response, touches, microphone_noise, seed=seed)
        outcomes = evaluate_conditions(locator, response, few, microphone_noise, seed, wanted=wanted)
        outcomes += evaluate_sensors(locator, response, made, max(1, few // SENSORS), microphone_noise, seed)
        outcomes += evaluate_sensors(locator, response, rigs, max(1, few // RIGS), microphone_noise, seed, RIG_GROUP)
        found[name] = Headline.of(overall, outcomes, SENSORS, unscattered)
    return found
