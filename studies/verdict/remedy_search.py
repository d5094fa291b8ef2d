"""The one change of a design that helps a rule most: computed by trying values of many choices at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from acoustic_fem.batch.parameters import fits_batch
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal
from geometry.layout.arrangement import lay_out
from studies.metrics.scatter_detection import scatter_detection
from studies.output.display import Report
from studies.verdict.candidate_changes import LAST, Change, changes_of
from studies.verdict.measured import Measured
from studies.verdict.measuring import measure
from studies.verdict.rules import ACCURACY_RULES, OUTCOMES, RULES, VerdictRule, rule_named

#: Choices that can move the figure of a rule.
_ACOUSTIC = (
    "bore", "tube length", "microphone tube", "cavity diameter", "cavities in place", "cavity height",
    "membrane thickness", "membrane material", "microphones", "points",
)  # fmt: skip
CHOICES_OF: Mapping[str, tuple[str, ...]] = {
    "buildable": ("layout fix", "tube length", "microphone tube", "wall", "cavity diameter", "columns"),
    "heard": _ACOUSTIC,
    "slow": _ACOUSTIC,
    **dict.fromkeys(ACCURACY_RULES, _ACOUSTIC),
    "separate": ("tube length", "cavity diameter", "cavities in place", "columns"),
    "bottoming": ("cavity height", "membrane thickness", "membrane material", "cavity diameter", "cavities in place"),
    "printable": ("wall", "floor", "lip", "bore", "glue gap", "membrane thickness", "cavity height", "chamber height",
                  "microphone wall", "process"),
    "buyable": ("stock", "bore", "membrane thickness", "membrane material"),
    "fits": ("columns", "tube length", "microphone tube", "cavity diameter", "wall", "points"),
    "coverage": ("tube length", "cavity diameter", "cavities in place", "columns"),
    "affordable": ("microphone tube", "tube length", "microphones", "points"),
}  # fmt: skip
"""Choices that are tried for each rule."""
#: Changes whose other rules are computed: so many in all, and of each choice.
_CLOSER, _CLOSER_EACH = 8, 2
#: Gains below these are not worth a change: of an accuracy, and of any other figure as a fraction of it.
_LEAST_ACCURACY, _LEAST = 0.005, 0.01


@dataclass(frozen=True)
class Remedy:
    """Change of a design that helps one of its rules most without making another one worse."""

    changes: Mapping[str, Any]
    """New values by dotted name, as :meth:`geometry.ArrayDesign.with_values` takes them."""
    words: str
    """The change in words."""
    gain: tuple[float, float]
    """Figure of the rule before and after the change, in the unit of the rule."""
    outcome: str
    """Outcome of the rule after the change."""
    remaining: int
    """Rules that stay broken: each marginal one counts 1, and each that does not work 2."""
    changes_order: bool = False
    """True if it changes what was asked for: the number of points, or the printer."""

    def to_dict(self) -> dict[str, Any]:
        """The remedy as JSON can hold it."""
        return {
            "changes": dict(self.changes),
            "words": self.words,
            "before": self.gain[0],
            "after": self.gain[1],
            "outcome": self.outcome,
            "changes_order": self.changes_order,
        }


class Remedies:
    """Search of remedies for one design; what several rules need is computed once.

    Args:
        design: the design.
        values: figures of all its rules.
    """

    def __init__(self, design: ArrayDesign, values: Mapping[str, Measured]) -> None:
        self._design, self._values = design, values
        self._changes: dict[str, tuple[Change, ...]] = {}
        self._figures: dict[tuple[str, str], dict[str, Measured]] = {}

    def best(self, name: str, *, may_be_marginal: bool = False, progress: Report | None = None) -> Remedy | None:
        """Remedy of a rule; None if no change that was tried helps it without making another rule worse.

        Args:
            name: name of the rule.
            may_be_marginal: whether other rules may become marginal.
            progress: called with what is tried and the fraction done, 0 to 1.
        """
        report = progress or (lambda message, fraction: None)
        rule, before = rule_named(name), self._values[name].value
        if rule.outcome(before) == OUTCOMES[0]:
            return None
        changes = [change for choice in CHOICES_OF[name] for change in self._of_choice(choice)]
        report(f"{name}: {len(changes)} changes", 0.0)
        closer = self._closer(rule, changes)
        best: tuple[tuple[float, ...], Remedy] | None = None
        for number, change in enumerate(closer):
            report(f"{name}: the best {len(closer)} of {len(changes)} changes", (number + 1) / (len(closer) + 1))
            values = self._measured([change], [each.name for each in RULES])[0]
            after = values[name].value
            gain = rule.gain(before, after)
            least = _LEAST_ACCURACY if name in ACCURACY_RULES else _LEAST * max(abs(before), 1e-6)
            if not gain > least or self._breaks(values, name, may_be_marginal):
                continue
            outcome = rule.outcome(after)
            every = sum(OUTCOMES.index(values[each.name].outcome(each)) for each in RULES)
            useful = gain if name in ACCURACY_RULES else _useful(rule, before, after)
            rank = (change.choice in LAST, OUTCOMES.index(outcome), every, -useful, change.size)
            if best is None or rank < best[0]:
                best = rank, Remedy(change.values, change.words, (before, after), outcome, every, change.choice in LAST)
        return None if best is None else best[1]

    def _of_choice(self, choice: str) -> tuple[Change, ...]:
        if choice not in self._changes:
            self._changes[choice] = changes_of(self._design, (choice,))
        return self._changes[choice]

    def _breaks(self, values: Mapping[str, Measured], name: str, may_be_marginal: bool) -> bool:
        """True if another rule has a worse outcome than before, beside marginal where that is allowed."""
        least = OUTCOMES.index("marginal") if may_be_marginal else 0
        return any(
            OUTCOMES.index(values[rule.name].outcome(rule))
            > max(OUTCOMES.index(self._values[rule.name].outcome(rule)), least)
            for rule in RULES
            if rule.name != name
        )

    def _measured(self, changes: Sequence[Change], rules: Sequence[str]) -> list[dict[str, Measured]]:
        """Figures of changed designs, each computed once."""
        missing = [each for each in changes if not set(rules) <= self._figures.get(each.key, {}).keys()]
        for change, values in zip(missing, measure([each.design for each in missing], rules), strict=True):
            self._figures.setdefault(change.key, {}).update(values)
        return [self._figures[change.key] for change in changes]

    def _closer(self, rule: VerdictRule, changes: Sequence[Change]) -> list[Change]:
        """Changes that look best by the rule itself, of different choices."""
        solvable = [change for change in changes if _solvable(change.design)]
        if rule.name in ACCURACY_RULES:
            gains = self._ranked(solvable)
        else:
            before = self._values[rule.name].value
            gains = [_useful(rule, before, each[rule.name].value) for each in self._measured(solvable, [rule.name])]
        by_gain = sorted(range(len(gains)), key=lambda number: (-gains[number], solvable[number].size))
        order = [number for number in by_gain if gains[number] > 0]
        taken: dict[str, int] = {}
        chosen: list[Change] = []
        for number in order:
            change = solvable[number]
            if taken.get(change.choice, 0) < _CLOSER_EACH and len(chosen) < _CLOSER:
                taken[change.choice] = taken.get(change.choice, 0) + 1
                chosen.append(change)
        return chosen

    def _ranked(self, changes: Sequence[Change]) -> list[float]:
        """Fall of the ranking score of as-built sensors for each change; 0 where the batch does not take a design."""
        if not _has_score(self._design):
            return [0.0] * len(changes)
        scored = [number for number, change in enumerate(changes) if _has_score(change.design)]
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):  # a change may make the array silent
            before, *scores = scatter_detection([self._design, *(changes[number].design for number in scored)])
        gains = [0.0] * len(changes)
        for number, score in zip(scored, scores, strict=True):
            gains[number] = float(before - score) if np.isfinite(score) else 0.0
        return gains


def _useful(rule: VerdictRule, before: float, after: float) -> float:
    """Gain of a figure up to the limit of a design that works, beyond which more is of no use."""
    enough = min(after, rule.works) if rule.relation == "at least" else max(after, rule.works)
    return rule.gain(before, enough)


def _has_score(design: ArrayDesign) -> bool:
    return fits_batch(design) and design.point_count > 1


def _solvable(design: ArrayDesign) -> bool:
    """True if the membranes of a design are inside what can be solved, and its tubes can be laid."""
    from acoustic_fem.membrane.design_discs import design_shape

    try:
        for kind in design.kinds:
            design_shape(design.of_kind(kind))
        if design.layout.microphone_side == "below":  # tubes that are too short cannot be led down
            lay_out(design)
    except Refusal:
        return False
    return True
