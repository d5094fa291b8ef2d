"""Accuracies that the verdict judges: of the sensor as designed and of as-built sensors that nobody calibrated."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from acoustic_fem.batch.parameters import fits_batch
from acoustic_fem.membrane.disc import KnownDiscs
from geometry.design.array_design import ArrayDesign
from geometry.ground.extras import is_installed
from geometry.ground.refusal import Refusal
from studies.verdict.tap_levels import covered_forces

if TYPE_CHECKING:
    from studies.metrics.predicted_accuracy import TouchAccuracy

#: Kinds of touches by the names of their rules, and in words.
TOUCHES = {"taps": "taps", "presses": "presses", "multi-sines": "multi-sine touches"}
#: As-built sensors of designs of up to so many points; of larger ones fewer, for each takes the square of its points.
SENSORS, SENSORS_UP_TO, _LEAST_SENSORS = 64, 36, 8
#: Designs of more points have no accuracy, for it would take minutes.
MOST_POINTS = 256


@dataclass(frozen=True, eq=False)
class Accuracies:
    """Accuracies of one design, by the names of the rules of their touches."""

    designed: Mapping[str, TouchAccuracy]
    """Accuracies of the sensor as designed."""
    as_built: Mapping[str, TouchAccuracy]
    """Accuracies of as-built sensors."""


def accuracies(designs: Sequence[ArrayDesign], known: KnownDiscs | None = None) -> list[Accuracies | str]:
    """Accuracies of each design for touches of the force of its target; a text where they are not known.

    The text says why. It is empty for a design of one point, which has nothing to tell apart.

    Args:
        designs: the designs.
        known: membranes that need not be solved.
    """
    return [_of_design(design, known) for design in designs]


def unknown_accuracy(design: ArrayDesign) -> str | None:
    """Reason why the accuracies of a design are not known; empty for a design of one point, None if they are known."""
    points = design.point_count
    if points < 2:
        return ""
    if points > MOST_POINTS:
        return f"the design has more than {MOST_POINTS} points"
    if not fits_batch(design):
        return "its cavities or membranes have no closed form"
    if not is_installed("train"):
        return "torch is missing"
    return None


def tap_force(design: ArrayDesign) -> float:
    """Peak force of the taps and presses whose accuracies are judged, N."""
    return float(covered_forces(design).min())


def _of_design(design: ArrayDesign, known: KnownDiscs | None) -> Accuracies | str:
    unknown = unknown_accuracy(design)
    if unknown is not None:
        return unknown
    from studies.metrics.predicted_accuracy import as_built_accuracy  # needs torch, without which verbs print help

    points = design.point_count
    sensors = max(_LEAST_SENSORS, min(SENSORS, round(SENSORS * (SENSORS_UP_TO / points) ** 2)))
    try:
        found = as_built_accuracy(design, force=tap_force(design), sensors=sensors, known=known)
    except Refusal as error:
        return str(error)
    of = {name: name.replace("-", "_") for name in TOUCHES}
    return Accuracies(
        {name: getattr(found.nominal, attribute) for name, attribute in of.items()},
        {name: getattr(found, attribute) for name, attribute in of.items()},
    )
