"""The verdict in words: for the terminal, reports and the studio."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from studies.output.display import number
from studies.output.report_texts import percent
from studies.verdict.rules import ACCURACY_RULES, RULES, SHOWN, VerdictRule, rule_named

if TYPE_CHECKING:
    from studies.verdict.remedy_search import Remedy
    from studies.verdict.verdict import Verdict


#: Figures that get worse by less than this fraction are not worth a word.
_WORSE = 0.05
#: Outcome of one rule after a remedy, in words that cannot be read as the verdict on the design.
_AFTER = {
    "works": "keeps the rule",
    "marginal": "the rule is then marginal",
    "does not work": "still breaks the rule",
}


def value_in_words(rule: VerdictRule, value: float) -> str:
    """Value of a rule's figure with its unit."""
    if rule.name in ACCURACY_RULES or rule.name in ("coverage", "buyable"):
        return percent(value)
    return f"{number(value)} {rule.unit}" if rule.unit != "1" else number(value)


def remedy_in_words(rule: str, remedy: Remedy) -> str:
    """A remedy with the value of the rule before and after it."""
    if rule == "buyable":
        return f"{remedy.words}: the parts can then be bought"
    own = rule_named(rule)
    before, after = (value_in_words(own, value) for value in remedy.gain)
    return f"{remedy.words}: {before} becomes {after} ({_AFTER[remedy.outcome]})"


def reason_lines(verdict: Verdict) -> Iterator[str]:
    """Lines on the worst reasons, each with its remedy, how many more there are, and on taps that are clipped."""
    for reason in verdict.reasons[:SHOWN]:
        yield f"- {reason.words}"
        if reason.remedy is not None:
            yield f"  try {remedy_in_words(reason.rule, reason.remedy)}"
    more = verdict.reasons[SHOWN:]
    if more:
        yield f"- also: {', '.join(reason.rule for reason in more)}"
    yield from overload_lines(verdict)


def overload_lines(verdict: Verdict) -> Iterator[str]:
    """A line on taps that are clipped; none where no tap is."""
    if verdict.above_overload > 0:
        force, overload = verdict.design.target.force, verdict.design.microphone.overload
        yield (
            f"- not judged: a tap of {force:g} N reaches {number(verdict.loudest_tap)} Pa, "
            f"{verdict.above_overload:.1f} dB above the overload of the microphone ({overload:g} Pa), so it is clipped;"
            " a microphone with a higher overload records it without clipping"
        )


def worse_lines(before: Verdict, after: Verdict) -> Iterator[str]:
    """Lines on the rules whose figures a change made worse by more than a twentieth.

    Args:
        before: verdict on the design before the change.
        after: verdict on the changed design.
    """
    for rule in RULES:
        old, new = before.values[rule.name].value, after.values[rule.name].value
        if rule.gain(old, new) < -_WORSE * abs(old):
            yield f"worse by the change: {rule.name}, {value_in_words(rule, old)} becomes {value_in_words(rule, new)}"


def figure_rows(verdict: Verdict) -> tuple[tuple[str, str, str], ...]:
    """Rows of the four figures: name, value, remark."""
    figures, force = verdict.figures, verdict.figures.smallest_force
    length, width = max(figures.size[:2]), min(figures.size[:2])
    taps = "not known" if math.isnan(figures.taps) else percent(figures.taps)
    limit = rule_named("heard").works
    return (
        ("as-built accuracy of taps", taps, f"taps of {verdict.design.target.force:g} N, not calibrated"),
        ("smallest tap", force_in_words(force), f"a tap {limit:g} dB above the noise at two microphones"),
        (
            "size",
            f"{length:.1f} x {width:.1f} x {figures.size[2]:.1f} mm",
            "with tubes and microphones; heads of boards stick out",
        ),
        ("cost", f"{figures.cost:.2f} USD", "materials of one array, assumed prices"),
    )


def force_in_words(force: float) -> str:
    """A force in the unit that suits it."""
    if not math.isfinite(force):
        return "not known"
    for unit, size in (("N", 1.0), ("mN", 1e-3), ("uN", 1e-6)):
        if force >= size:
            return f"{number(force / size)} {unit}"
    return f"{number(force / 1e-9)} nN"


def rule_rows() -> tuple[tuple[str, str, str, str, str, str], ...]:
    """Rows of the table of rules: name, figure, limit of works, limit of marginal, needs, why."""
    return tuple(
        (
            rule.name,
            rule.figure,
            f"{rule.relation} {value_in_words(rule, rule.works)}",
            f"{rule.relation} {value_in_words(rule, rule.marginal)}",
            rule.needs,
            rule.why,
        )
        for rule in RULES
    )
