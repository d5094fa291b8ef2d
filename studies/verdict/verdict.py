"""Verdict on a design: whether it will work, why not, and the change that helps most."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.shown import Shown
from geometry.layout.size import array_size
from geometry.schema.target import Target
from studies.metrics.build import cost
from studies.output.display import Report
from studies.verdict.accuracies import TOUCHES
from studies.verdict.measured import Measured
from studies.verdict.measuring import Drawn, measure
from studies.verdict.remedy_search import Remedies, Remedy
from studies.verdict.rules import OUTCOMES, RULES, SHOWN, Outcome, VerdictRule, rule_named, worst
from studies.verdict.tap_levels import loudest_taps

#: Rules to which the drawn parts add.
_OF_DRAWN = ("buildable", "printable")
#: Rule that a fix keeps first.
_BUYABLE = rule_named("buyable")
#: Changes that :meth:`Verdict.fixed` makes at most.
_MOST_CHANGES = 8


@dataclass(frozen=True)
class Reason:
    """Rule that a design breaks."""

    rule: str
    """Name of the rule."""
    outcome: Outcome
    """Outcome of the rule, "marginal" or "does not work"."""
    words: str
    """The reason in words, with its figures."""
    value: float
    """Figure of the rule; NaN if it is not known."""
    limit: float
    """Limit of the figure for a design that works."""
    unit: str
    """Unit of value and limit; "1" for ratios."""
    points: tuple[int, ...]
    """Numbers of the points concerned, from 1; empty if it is the design as a whole."""
    remedy: Remedy | None
    """Change that helps most; None if none that was tried helps, or beyond the first three reasons."""

    def to_dict(self) -> dict[str, Any]:
        """The reason as JSON can hold it."""
        return {
            "rule": self.rule,
            "outcome": self.outcome,
            "words": self.words,
            "value": _or_none(self.value),
            "limit": self.limit,
            "unit": self.unit,
            "points": list(self.points),
            "remedy": None if self.remedy is None else self.remedy.to_dict(),
        }


@dataclass(frozen=True)
class VerdictFigures:
    """The four figures beside a verdict."""

    taps: float
    """Top-1 accuracy of taps on as-built sensors without calibration, 0 to 1; NaN where it is not known."""
    smallest_force: float
    """Smallest force of a tap that every point can locate: two microphones receive it with the signal-to-noise ratio
    of the rule ``heard``, N; NaN where it is not known."""
    size: tuple[float, float, float]
    """Extent of the array along x, y and z, mm."""
    cost: float
    """Cost of the materials of one array, USD, at assumed prices."""


class Verdict(Shown):
    """Verdict on a design by the rules of :data:`studies.verdict.RULES`.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        target: size, force, contact and budget; by default those that the design states.
        drawn: findings on the drawn parts; by default the parts are not drawn.

    Raises:
        Refusal: no such design, or a membrane outside what can be solved.
    """

    def __init__(self, design: DesignLike, target: Target | None = None, *, drawn: Drawn | None = None) -> None:
        found = resolve_design(design)
        self.design = found if target is None else found.model_copy(update={"target": target})
        self._drawn = drawn
        self._progress: Report | None = None

    def compute(self, progress: Report, *, fixes: bool = False) -> None:
        """Compute the reasons with their remedies now, because they can take minutes for a large design.

        Args:
            progress: called with what is computed and the fraction done, 0 to 1.
            fixes: whether to compute the fixes, too.
        """
        self._progress = progress
        try:
            len(self.reasons)
            if fixes:
                len(self.fixes)
        finally:
            self._progress = None

    @cached_property
    def values(self) -> Mapping[str, Measured]:
        """Figures of all rules by name; the value of a rule that does not apply is NaN."""
        if self._progress is not None:
            self._progress("figures of all rules", 0.0)
        return measure([self.design], drawn=self._drawn)[0]

    @property
    def outcome(self) -> Outcome:
        """The worst outcome of all rules."""
        return worst([self.values[rule.name].outcome(rule) for rule in RULES])

    @cached_property
    def reasons(self) -> tuple[Reason, ...]:
        """Rules that the design breaks, the worst first; the first three with a remedy where there is one."""
        remedies = dict(zip(self.broken, self._remedies(self._progress), strict=False))
        return tuple(self._reason(rule, remedies.get(rule)) for rule in self.broken)

    def _remedies(self, report: Report | None) -> list[Remedy | None]:
        """Remedies of the first reasons."""
        found, count = list[Remedy | None](), min(SHOWN, len(self.broken))
        for place, rule in enumerate(self.broken[:SHOWN]):
            found.append(self._search.best(rule.name, progress=_part(report, place, count)))
        return found

    @cached_property
    def _search(self) -> Remedies:
        # Changes are tried without their drawings, so they are compared with the design without its own.
        plain = {} if self._drawn is None else measure([self.design], _OF_DRAWN)[0]
        return Remedies(self.design, {**self.values, **plain})

    @property
    def broken(self) -> tuple[VerdictRule, ...]:
        """Rules that the design breaks, the worst first; of the kinds of touches only the worst one."""
        outcomes = {rule.name: self.values[rule.name].outcome(rule) for rule in RULES}
        bad = [rule for rule in RULES if outcomes[rule.name] != "works"]
        kinds = [rule for rule in bad if rule.name in TOUCHES]
        hardest = min(kinds, key=lambda rule: self.values[rule.name].value, default=None)
        bad = [rule for rule in bad if rule.name not in TOUCHES or rule is hardest]
        return tuple(sorted(bad, key=lambda rule: -OUTCOMES.index(outcomes[rule.name])))

    @cached_property
    def figures(self) -> VerdictFigures:
        """As-built accuracy of taps, smallest tap, size and cost."""
        heard = self.values["heard"].value
        limit = next(rule.works for rule in RULES if rule.name == "heard")
        return VerdictFigures(
            taps=self.values["taps"].value,
            smallest_force=self.design.target.force * 10 ** ((limit - heard) / 20),
            size=array_size(self.design),
            cost=float(cost(self.design)),
        )

    @cached_property
    def loudest_tap(self) -> float:
        """Largest output of a microphone during a tap of the target's force on any point, Pa at 1 kHz.

        No rule judges it, because the overload of many microphones is not published but assumed.
        """
        return float(loudest_taps([self.design])[0].max())

    @property
    def above_overload(self) -> float:
        """Level of the loudest tap above the overload of the microphone, dB; above 0 this tap is clipped."""
        return 20 * math.log10(max(self.loudest_tap, 1e-30) / self.design.microphone.overload)

    @property
    def not_judged(self) -> tuple[str, ...]:
        """Names of the rules that do not apply to the design."""
        values = ((rule.name, self.values[rule.name]) for rule in RULES)
        return tuple(name for name, found in values if math.isnan(found.value) and not found.unknown)

    @cached_property
    def fixes(self) -> tuple[Remedy, ...]:
        """Remedies that :meth:`fixed` applies, one after the other."""
        return self._fixed[0]

    def fixed(self) -> ArrayDesign:
        """The design with remedies applied, one after the other, until it works or none is left.

        A design that cannot be bought is first changed to the nearest parts that can, even if an accuracy becomes
        marginal by it. Each other remedy is computed anew for the design that the changes before it gave, and the one
        that leaves the fewest broken rules is taken. The number of points and the printer stay as they are.
        """
        return self._fixed[1]

    @cached_property
    def _fixed(self) -> tuple[tuple[Remedy, ...], ArrayDesign]:
        now, made = self, list[Remedy]()
        while len(made) < _MOST_CHANGES:
            remedy = now._bought() or now._next(_part(self._progress, len(made), _MOST_CHANGES))
            if remedy is None:
                break
            made.append(remedy)
            now = Verdict(now.design.with_values(remedy.changes))
        return tuple(made), now.design

    def _bought(self) -> Remedy | None:
        """Change to parts that can be bought; None if the design has them, or no change gives them."""
        remedy = self._search.best("buyable", may_be_marginal=True) if _BUYABLE in self.broken else None
        return remedy if remedy is not None and remedy.outcome == OUTCOMES[0] else None

    def _next(self, report: Report | None) -> Remedy | None:
        """The remedy that leaves the fewest broken rules and keeps what was asked for."""
        useful = (each for each in self._remedies(report) if each is not None and not each.changes_order)
        return min(useful, key=lambda each: each.remaining, default=None)

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        facts = {f"{place}. {reason.rule}": reason.words for place, reason in enumerate(self.reasons[:SHOWN], 1)}
        return f"Verdict on {self.design.name}: {self.outcome}", facts

    def to_dict(self) -> dict[str, Any]:
        """The verdict as JSON can hold it."""
        figures = self.figures
        return {
            "outcome": self.outcome,
            "reasons": [reason.to_dict() for reason in self.reasons],
            "figures": {
                "as_built_taps": _or_none(figures.taps),
                "smallest_force_n": _or_none(figures.smallest_force),
                "size_mm": list(figures.size),
                "cost_usd": figures.cost,
                "loudest_tap_pa": _or_none(self.loudest_tap),
                "overload_pa": self.design.microphone.overload,
            },
            "rules": {
                rule.name: {
                    "value": _or_none(self.values[rule.name].value),
                    "unit": rule.unit,
                    "outcome": None if rule.name in self.not_judged else self.values[rule.name].outcome(rule),
                }
                for rule in RULES
            },
            "not_judged": list(self.not_judged),
            "target": self.design.target.model_dump(mode="json"),
        }

    def _reason(self, rule: VerdictRule, remedy: Remedy | None) -> Reason:
        found = self.values[rule.name]
        return Reason(
            rule.name, found.outcome(rule), found.words, found.value, rule.works, rule.unit, found.points, remedy
        )


def _part(report: Report | None, place: int, count: int) -> Report | None:
    """Report of one of several parts of a job; None without one of the job."""
    if report is None:
        return None
    return lambda message, fraction: report(message, (place + fraction) / count)


def _or_none(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
