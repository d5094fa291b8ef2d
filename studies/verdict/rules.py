"""Rules of the verdict on a design, as data: the figure of each, its limits, and why they are there.

docs/verdict.md prints this table. A rule that does not apply to a design, such as its size if no size is stated, has no
figure and is not judged.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from geometry.ground.refusal import Kind, Refusal
from geometry.schema.field_errors import nearest
from geometry.schema.print_processes import Relation

#: Outcome of a verdict, from best to worst.
Outcome = Literal["works", "marginal", "does not work"]
OUTCOMES: tuple[Outcome, ...] = ("works", "marginal", "does not work")
"""Outcomes of a rule and of a verdict, from the best to the worst."""

SHOWN = 3
"""Number of reasons that a summary shows, and that get a remedy."""
ACCURACY_RULES = ("designed", "taps", "presses", "multi-sines")
"""Rules whose figures take as-built sensors and a decoder, and so the most time."""

#: Rounding that is forgiven at a limit, as a fraction of the limit.
_ROUNDING = 1e-6


@dataclass(frozen=True)
class VerdictRule:
    """Rule of the verdict: a figure of the design and its limits."""

    name: str
    """Name of the rule, as results and JSON have it."""
    figure: str
    """Definition of the figure, in words."""
    unit: str
    """Unit of the figure; "1" for ratios."""
    relation: Relation
    """Relation that the figure must have to its limits."""
    works: float
    """Limit for a design that works."""
    marginal: float
    """Limit for a design that is marginal; beyond it the design does not work."""
    needs: str
    """Facts that the figure needs, in words."""
    why: str
    """Reason for the limits, with its source."""

    def outcome(self, value: float) -> Outcome:
        """Outcome of the rule for a value of its figure; "works" if the value is not a number, as nothing is judged."""
        if math.isnan(value):
            return "works"
        if self._holds(value, self.works):
            return "works"
        return "marginal" if self._holds(value, self.marginal) else "does not work"

    def gain(self, before: float, after: float) -> float:
        """Improvement of the figure, in its unit; negative if it gets worse.

        Args:
            before: value of the figure before a change.
            after: its value after the change.
        """
        return after - before if self.relation == "at least" else before - after

    def _holds(self, value: float, limit: float) -> bool:
        spare = _ROUNDING * max(abs(limit), 1e-3)
        return value >= limit - spare if self.relation == "at least" else value <= limit + spare


_DRAWN = "the layout, and the parts where the extra cad is installed"
_TOUCHES = "transfer functions (closed forms), noise of the air and of the microphones, force and contact of the target"
_SENSORS = (
    "the default decoder, on random as-built sensors and microphones with the tolerances that it assumes for a sensor "
    "that nobody calibrated"
)

#: Rules of the verdict, in the order of the page on it.
RULES: tuple[VerdictRule, ...] = (
    VerdictRule(
        "buildable", "parts that overlap, tubes bent too far and parts that do not go together", "1", "at most", 0, 0,
        _DRAWN, "parts in each other's way cannot be put together",
    ),
    VerdictRule(
        "heard", "signal-to-noise ratio, at the second-loudest microphone, of a tap of the target's force for the "
        "point where it is lowest", "dB", "at least", 20, 13, _TOUCHES,
        "a decoder compares two microphones, so both must receive the tap. At 20 dB a matched filter measures the "
        "level to 10 %. At 13 dB it detects nine taps of ten with one false alarm in a thousand (Kay, Fundamentals of "
        "Statistical Signal Processing II, 1998, section 4.3)",
    ),
    VerdictRule(
        "designed", "top-1 accuracy of the sensor as designed, for the worst of taps, presses and multi-sines", "1",
        "at least", 0.98, 0.9, "transfer functions, noise, and the default decoder",
        "without tolerances, one touch in fifty at the wrong point is already more than a user of a keypad accepts. "
        "Our choice",
    ),
    VerdictRule(
        "taps", "top-1 accuracy of taps on as-built sensors, mean of the sensors", "1", "at least", 0.95, 0.8, _SENSORS,
        "a user may repeat one tap in twenty but not one in five. Our choice",
    ),
    VerdictRule(
        "presses", "top-1 accuracy of presses on as-built sensors, mean of the sensors", "1", "at least", 0.95, 0.8,
        _SENSORS, "as for taps. Presses have low frequencies, where points differ least. Our choice",
    ),
    VerdictRule(
        "multi-sines", "top-1 accuracy of multi-sine touches on as-built sensors, mean of the sensors", "1", "at least",
        0.95, 0.8, _SENSORS, "as for taps. These are the touches of the publication",
    ),
    VerdictRule(
        "slow", "smallest distance of two points over 3 to 10 Hz: rms of the logarithm of the ratio of their "
        "microphone ratios, nepers and radians", "1", "at least", 0.08, 0.03, "transfer functions (closed forms)",
        "microphones of one type differ by 5 % (one standard deviation of +-1 dB), so the ratio of two is off by 7 %. "
        "A slow press gives a decoder little more than this ratio. The rule shows why presses fail, and takes only a "
        "millisecond in searches. All eight designs below 0.01 in benchmarks/verdicts.py also break the rule on "
        "presses, whose prediction includes such microphones",
    ),
    VerdictRule(
        "separate", "force on a neighbour's membrane, as a fraction of that on the touched one, for a contact of the "
        "target's radius in the middle of a point", "1", "at most", 0.1, 0.5, "the layout, and Hertz's law of contact",
        "if a contact presses two points, no single point is correct. At 0.1 the other point is 20 dB weaker. Our "
        "choice",
    ),
    VerdictRule(
        "bottoming", "deflection of the membrane at the target's force, as a fraction of the height of the cavity, or "
        "that force as a fraction of the one that tears the membrane if this is more", "1", "at most", 0.5, 1,
        "the elastic membrane, Hertz's law of contact, force and contact of the target",
        "the membrane may not touch the floor; from half the height on it covers the ports of the tubes. An estimate "
        "decides clear cases: the linear deflection reduced by the stretching of the membrane (Timoshenko and "
        "Woinowsky-Krieger, Theory of Plates and Shells, 1959, article 97). Between a third and one and a half of the "
        "height, finite elasticity decides (acoustic_fem.membrane.press_limits). Its deflection was 0.5 to 1.4 times "
        "the estimate for eleven designs. Both are too large by the part of the force that the air carries",
    ),
    VerdictRule(
        "printable", "smallest ratio of a printed wall, hole or gap, or of a cast disc, to the limit of the process",
        "1", "at least", 1, 1, "the design's sizes, and the print report of the parts where the extra cad is installed",
        "below the limit of the process the part breaks, or its hole is closed; sources: docs/parts.md, print rules",
    ),
    VerdictRule(
        "buyable", "largest change of a size or a part that makes the design one of parts of the catalogue, as a "
        "fraction; 1 if nothing in the catalogue fits", "1", "at most", 0.01, 0.35, "the catalogue of parts",
        "a part that no shop sells must be made. Sizes change by less than a third, because then the sensor stays much "
        "the same (geometry.stock)",
    ),
    VerdictRule(
        "fits", "length and width of the array by those of the target, the larger ratio", "1", "at most", 1, 1,
        "the layout, and the size of the target", "the size is the designer's. The array may be turned by 90 degrees",
    ),
    VerdictRule(
        "coverage", "fraction of the area in which a contact of the target's radius touches a membrane", "1",
        "at least", 0.5, 0.05, "the layout, and the contact of the target",
        "below 0.5, most touches at a random place miss all points. Below 0.05, nineteen of twenty do. Our choice",
    ),
    VerdictRule(
        "affordable", "cost of the materials of one array by the budget of the target", "1", "at most", 1, 1.25,
        "the bill of materials, and the budget of the target", "prices are assumed, and good to about a quarter",
    ),
)  # fmt: skip


def rule_named(name: str) -> VerdictRule:
    """The rule of a name.

    Raises:
        Refusal: no such rule.
    """
    names = [rule.name for rule in RULES]
    if name not in names:
        raise Refusal(kind=Kind.UNKNOWN, field="rule", value=name, remedy=nearest(name, names))
    return RULES[names.index(name)]


def worst(outcomes: list[Outcome]) -> Outcome:
    """The worst of some outcomes; "works" if there are none."""
    return max(outcomes, key=OUTCOMES.index, default="works")
