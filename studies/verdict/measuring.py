"""Figures of all rules on designs: the quick ones of many at once, and the accuracies of few."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from acoustic_fem.membrane.disc import KnownDiscs
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import counted
from geometry.printing.print_rules import Finding
from studies.output.report_texts import percent
from studies.verdict import part_rules
from studies.verdict.accuracies import TOUCHES, Accuracies, accuracies
from studies.verdict.measured import NOT_JUDGED, Measured, points_in_words
from studies.verdict.rules import ACCURACY_RULES, RULES, rule_named
from studies.verdict.tap_levels import LOSS_AT, SLOW, TapLevels, tap_levels

ALL_RULES = tuple(each.name for each in RULES)
"""Names of all rules."""
#: Rules whose figures follow from sizes.
_OF_SIZES: Mapping[str, Callable[[ArrayDesign], Measured]] = {
    "separate": part_rules.separate,
    "buyable": part_rules.buyable,
    "fits": part_rules.fits,
    "coverage": part_rules.covered,
    "affordable": part_rules.affordable,
}


@dataclass(frozen=True)
class Drawn:
    """Findings on the drawn parts of a design, which the extra ``cad`` makes."""

    misfits: tuple[str, ...] = ()
    """Lines on what keeps the parts from being put together."""
    failures: tuple[Finding, ...] = ()
    """Findings of the print report that failed."""


def measure(
    designs: Sequence[ArrayDesign],
    rules: Sequence[str] = ALL_RULES,
    *,
    drawn: Drawn | None = None,
    known: KnownDiscs | None = None,
    estimated: bool = False,
    levels: Sequence[TapLevels] | None = None,
) -> list[dict[str, Measured]]:
    """Values of the figures of some rules on each design, by the names of the rules.

    Args:
        designs: the designs.
        rules: names of the rules.
        drawn: findings on the parts, which then are those of every design.
        known: membranes that need not be solved.
        estimated: whether the estimate of the deflection of membranes also decides where it is not clear.
        levels: levels of taps on the designs, if you have them already.

    Raises:
        Refusal: a membrane outside what can be solved.
    """
    parts = drawn or Drawn()
    found: list[dict[str, Measured]] = [{} for _ in designs]
    if levels is None:
        levels = tap_levels(designs, known) if {"heard", "slow"} & set(rules) else []
    rates = accuracies(designs, known) if any(name in rules for name in ACCURACY_RULES) else []
    for number, (design, values) in enumerate(zip(designs, found, strict=True)):
        for name in rules:
            if name == "heard":
                values[name] = _heard(design, levels[number])
            elif name == "slow":
                values[name] = _slow(levels[number])
            elif name in ACCURACY_RULES:
                values[name] = _accuracy(name, rates[number])
            elif name == "bottoming":
                values[name] = part_rules.bottoming(design, known, estimated=estimated)
            elif name == "buildable":
                values[name] = part_rules.buildable(design, parts.misfits)
            elif name == "printable":
                values[name] = part_rules.printable(design, parts.failures)
            else:
                values[name] = _OF_SIZES[name](design)
    return found


def _heard(design: ArrayDesign, levels: TapLevels) -> Measured:
    rule, second = rule_named("heard"), levels.second
    weakest = int(second.argmin())
    outcome = rule.outcome(float(second[weakest]))
    limit = rule.marginal if outcome == "does not work" else rule.works
    points = tuple(int(number) + 1 for number in np.flatnonzero(second < limit))
    verb = "cannot be heard" if outcome == "does not work" else "can hardly be heard"
    loss, tubes = levels.loss_to_second[weakest], tubes_to_second(design, weakest)
    words = (
        f"{points_in_words(points)} {verb} at two microphones: {loss:.0f} dB of loss at {LOSS_AT:g} Hz through "
        f"{counted(tubes, 'tube')}, {second[weakest]:.0f} dB of signal to noise"
        if points
        else f"a tap of {design.target.force:g} N is {second[weakest]:.0f} dB above the noise at two microphones"
    )
    return Measured(float(second[weakest]), words, points)


def _slow(levels: TapLevels) -> Measured:
    if not np.isfinite(levels.slow):
        return NOT_JUDGED
    low, high = SLOW
    words = (
        f"points {levels.alike[0]} and {levels.alike[1]} are nearly alike from {low:g} to {high:g} Hz, the band of "
        f"slow presses: their ratios of microphones differ by only {100 * levels.slow:.1f} %"
    )
    return Measured(float(levels.slow), words, levels.alike)


def tubes_to_second(design: ArrayDesign, point: int) -> int:
    """Number of tubes from a point, from 0, to the farther end of its line."""
    for line in design.lines:
        if point < line.points:
            return max(point + 1, line.points - point)
        point -= line.points
    raise AssertionError("no such point")


def _accuracy(name: str, found: Accuracies | str) -> Measured:
    if isinstance(found, str):
        if name != "taps" or not found:
            return NOT_JUDGED
        return Measured(math.nan, f"the accuracy of as-built sensors is not known: {found}", unknown=True)
    rule = rule_named(name)
    of_kinds = found.designed if name == "designed" else {name: found.as_built[name]}
    touches = min(of_kinds, key=lambda kind: of_kinds[kind].mean)
    rate = of_kinds[touches]
    limit = rule.marginal if rule.outcome(rate.mean) == "does not work" else rule.works
    points = tuple(int(number) + 1 for number in np.flatnonzero(rate.per_point < limit))
    where = f", fewest at {points_in_words(points)}" if 0 < len(points) < len(rate.per_point) else ""
    share = f"{percent(rate.mean)} of {TOUCHES[touches]}"
    if name == "designed":
        return Measured(
            rate.mean, f"even the sensor as designed assigns only {share} to the correct point{where}", points
        )
    between = f"({percent(rate.low)} to {percent(rate.high)})"
    words = f"as-built sensors that nobody calibrated assign {share} to the correct point {between}{where}"
    return Measured(rate.mean, words, points)
