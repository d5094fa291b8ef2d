"""Value of a rule's figure on a design, and the words for it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import groupby

from studies.verdict.rules import Outcome, VerdictRule


@dataclass(frozen=True)
class Measured:
    """Value of the figure of one rule on one design."""

    value: float
    """Value in the unit of the rule; NaN if the rule does not apply to the design."""
    words: str = ""
    """Sentence on the value, without a full stop: what is wrong where the rule is broken."""
    points: tuple[int, ...] = ()
    """Numbers of the points that are concerned, from 1; empty if it is the design as a whole."""
    unknown: bool = False
    """True if the rule applies to the design, but its figure cannot be computed; the value is then NaN."""

    def outcome(self, rule: VerdictRule) -> Outcome:
        """Outcome of the rule; "marginal" if its figure is not known, because the design may or may not work."""
        return "marginal" if self.unknown else rule.outcome(self.value)


MOST_PARTS = 5
"""Most numbers or ranges of numbers that a sentence lists."""
NOT_JUDGED = Measured(math.nan)
"""Value of a rule that does not apply."""


def points_in_words(points: Sequence[int]) -> str:
    """Numbers of points in words, such as ``points 3 and 5 to 9``.

    Args:
        points: at least one number, ascending.
    """
    parts: list[str] = []
    for _, run in groupby(enumerate(points), lambda each: each[1] - each[0]):
        numbers = [number for _, number in run]
        parts += [f"{numbers[0]} to {numbers[-1]}"] if len(numbers) > 2 else map(str, numbers)
    if len(parts) > MOST_PARTS:
        return f"{len(points)} points, such as {parts[0]}"
    listed = parts[0] if len(parts) == 1 else f"{', '.join(parts[:-1])} and {parts[-1]}"
    return f"{'point' if len(points) == 1 else 'points'} {listed}"
