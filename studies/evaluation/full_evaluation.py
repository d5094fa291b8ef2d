"""Evaluation of localizers: their headlines, and their accuracy when one condition is changed at a time."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from datetime import datetime
from typing import Any

from acoustic_fem import Library
from acoustic_fem.library.provenance import versions
from geometry.ground.stated_times import stated_time
from localize.evaluation.accuracy import check_evaluation
from localize.evaluation.conditions import Outcome, evaluate_conditions, evaluate_sensors
from localize.signals.array_response import ArrayResponse
from localize.signals.locator import Locator
from localize.signals.noise_model import NoiseChoice
from studies.evaluation.evaluated_sensors import AS_BUILT, RIGS, SENSORS, scattered_sensors
from studies.evaluation.headline import LEAST, SENSOR_SEED, Headline, HeadlineTouches, Progress

#: Fractions of the tolerances with which sensors are evaluated beside the headline's.
SCATTER = (0.25, 0.5)
#: Touches per point in a condition, as a fraction of those of the headline.
SHARE = 0.1


@dataclass(frozen=True)
class LocalizerResult:
    """Results of one localizer."""

    name: str
    """Name of the localizer."""
    headline: Headline
    """Results on taps and presses on as-built sensors, and those beside them."""
    outcomes: tuple[Outcome, ...]
    """Results under each condition, which has taps and presses unless it says otherwise."""

    def to_dict(self) -> dict[str, Any]:
        """Results as JSON can hold them."""
        return {**self.headline.to_dict(), "conditions": [asdict(outcome) for outcome in self.outcomes]}


@dataclass(frozen=True)
class FullEvaluation:
    """Results of all localizers: what the report shows."""

    design: str
    """Name of the design."""
    points: tuple[int, ...]
    """Numbers of the points."""
    results: tuple[LocalizerResult, ...]
    """Results of each localizer, in the order in which they were given."""
    created: datetime
    """Time at which the evaluation was made."""
    provenance: dict[str, Any]
    """Design, fidelity, library, seed and versions."""
    unscattered: str = ""
    """Reason for which as-built sensors are left out; empty if they are evaluated."""

    def to_dict(self) -> dict[str, Any]:
        """Results as JSON can hold them."""
        return {
            "design": self.design,
            "created": self.created.isoformat(timespec="seconds"),
            "provenance": self.provenance,
            **{each.name: each.to_dict() for each in self.results},
        }


def evaluate_fully(
    locators: dict[str, Locator],
    library: Library,
    response: ArrayResponse,
    touches: int,
    microphone_noise: NoiseChoice,
    seed: int,
    progress: Progress,
) -> FullEvaluation:
    """Headlines of localizers, then their results on a library under each condition that it allows, and on sensors of
    other tolerances.

    Args:
        locators: by name.
        library: of a design.
        response: of that library.
        touches: held-out touches per point of the headline, see
            :class:`studies.evaluation.headline.HeadlineTouches`; in a condition a tenth as many, at least 600 of all
            points together, but never more.
        microphone_noise: of the microphones, where the condition is not the noise.
        seed: seed of the touches.
        progress: function that is called with the name of the step and the fraction done.

    Raises:
        Refusal: as :func:`localize.evaluate`.
    """
    for locator in locators.values():
        check_evaluation(locator, response, touches, microphone_noise)
    few = min(touches, max(round(SHARE * touches), math.ceil(LEAST / response.point_count)))
    progress("touches", 0.0)
    held_out = HeadlineTouches(library, response, touches, microphone_noise, seed)
    made, _ = scattered_sensors(library, response, SENSOR_SEED, SENSORS, SCATTER)
    found = []
    for number, (name, locator) in enumerate(locators.items()):
        stage = _stage(progress, name, number / len(locators), 1 / len(locators))
        stage("headline", 0.0)
        headline = held_out.headline(locator)
        outcomes = evaluate_conditions(locator, response, few, microphone_noise, seed, stage)
        stage(AS_BUILT, 1.0)
        if made:
            few_each = max(1, few // SENSORS)
            outcomes += evaluate_sensors(locator, response, made, few_each, microphone_noise, seed)
            outcomes += [headline.outcome, *(each for each in headline.outcomes if each.group == RIGS)]
        found.append(LocalizerResult(name, headline, tuple(outcomes)))
    return FullEvaluation(
        design=response.name,
        points=tuple(range(1, response.point_count + 1)),
        results=tuple(found),
        created=stated_time(),
        provenance={
            **versions(seed, ("numpy", "scipy", "torch", "onnxruntime")),
            "design": response.provenance["design"],
            "fidelity": library.fidelity,
            "library": dict(library.provenance),
        },
        unscattered=held_out.unscattered,
    )


def _stage(progress: Progress, name: str, begin: float, size: float) -> Progress:
    """Progress of one localizer as part of the whole."""
    return lambda what, share: progress(f"{name}: {what}", begin + size * share)
