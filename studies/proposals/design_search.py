"""Search for designs that answer a question: many by closed forms, the best of them by the verdict."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Refusal
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import OverlapError, refuse_overlaps, schematic_notes
from geometry.schema.field_errors import DesignError
from studies.metrics.scatter_detection import scatter_detection
from studies.proposals.candidates import Candidates, Sizes
from studies.proposals.designer_question import Question
from studies.proposals.grids import Grid, grids
from studies.proposals.quick_discs import QuickDiscs
from studies.verdict import OUTCOMES, RULES, Verdict, measure
from studies.verdict.measured import Measured
from studies.verdict.part_rules import CLEAR, bottoming
from studies.verdict.tap_levels import loudest_taps, tap_levels

#: Rules whose figures closed forms give in milliseconds.
QUICK = ("slow", "separate", "bottoming", "printable", "coverage", "affordable")
#: Those of them that need the layout alone.
_OF_LAYOUT = ("separate", "printable", "coverage", "affordable")
#: Loss at 10 Hz from the touched cavity to the second microphone up to which noise hardly counts, dB, and the error
#: that each decibel beyond adds: fitted to predicted accuracies of arrays of 36 points on four microphones.
_LOSS, _PER_DECIBEL = 20.0, 0.01
#: Error that clipped taps count as, so that a design without them comes first unless it is much less accurate.
_CLIPPED = 0.2
#: Error beyond which the verdict is known before it is computed.
_HOPELESS = 0.7
#: Fraction of a round that drawing takes, for the progress.
_DRAWING = 0.4
#: Number of designs whose membranes are pressed by finite elasticity while others are sought.
_PRESSED = 4
#: Number of points beyond which fewer designs are tried.
_MANY = 48


@dataclass(frozen=True)
class Effort:
    """How much is tried."""

    draws: int = 480
    """Designs that are drawn for the first layout of a question; of each further one a quarter."""
    judged: int = 5
    """Designs of a round that are given a verdict."""
    near: int = 160
    """Designs that are drawn near the best ones in each further round."""
    rounds: int = 4
    """Rounds at most."""


LEAN = Effort(draws=48, judged=1, near=32, rounds=2)
"""Effort for one of many numbers of points."""


def thorough(points: int) -> Effort:
    """Effort for the answer to a question; less where a verdict takes seconds."""
    return Effort() if points <= _MANY else Effort(draws=max(4800 // points, 24), judged=1, near=40, rounds=2)


@dataclass(frozen=True, eq=False)
class Found:
    """One design with its verdict."""

    design: ArrayDesign
    """The design."""
    verdict: Verdict
    """Verdict on it."""
    sizes: Sizes
    """Sizes that were drawn."""
    grid: Grid
    """Its layout."""

    @property
    def merit(self) -> tuple[float, ...]:
        """Key by which designs are sorted, the best first: broken rules, clipped taps, the least accuracy."""
        clipped = float(self.verdict.above_overload > 0)
        return *_broken(self.verdict.values), clipped, -self.accuracy

    @property
    def is_whole(self) -> bool:
        """True where the design works and no tap of the target's force is clipped."""
        return self.verdict.outcome == "works" and self.verdict.above_overload <= 0

    @property
    def accuracy(self) -> float:
        """Least accuracy of as-built sensors over the kinds of touches, 0 to 1; 0 where it is not known."""
        return _accuracy(self.verdict.values)


@dataclass(frozen=True, eq=False)
class Screened:
    """One design as closed forms see it."""

    design: ArrayDesign
    """The design."""
    sizes: Sizes
    """Sizes that were drawn."""
    grid: Grid
    """Its layout."""
    values: dict[str, Measured]
    """Figures of rules of the verdict by their names."""
    error: float
    """Error under scatter, with what the loss adds."""
    clipped: bool = False
    """True where a tap of the target's force is louder than the microphone's overload."""

    @property
    def merit(self) -> tuple[int, int, float]:
        """Key by which designs are sorted, the best first."""
        failed, marginal, missed = _broken(self.values)
        return failed, marginal, self.error + missed + (_CLIPPED if self.clipped else 0.0)


Progress = Callable[[str, float], None]


def silent(step: str, fraction: float) -> None:
    """Report no progress."""


def search(asked: Question, name: str, points: int, effort: Effort, progress: Progress) -> list[Found]:
    """Designs of a number of points with their verdicts, the best first; empty where none can be built.

    Args:
        asked: the question.
        name: name of the designs.
        points: number of points.
        effort: how much is tried.
        progress: called with the name of a step and the fraction done.
    """
    layouts = [Candidates(asked, name, grid) for grid in grids(asked, points)]
    found: list[Found] = []
    for number in range(effort.rounds):
        told = partial(
            _told, progress, f"{points} points, round {number + 1} of {effort.rounds}", number, effort.rounds
        )
        hopeless = False
        if number == 0:
            pool = _first(layouts, effort.draws, told)
            if not pool:
                return []
            hopeless = is_hopeless(pool[0])
        else:
            best = found[0]
            told("designs like the best", 0.0)
            own = next(each for each in layouts if each.grid == best.grid)
            pool = screened(own, own.drawn(effort.near, [each.sizes for each in found[:2]]))
        pool.sort(key=lambda each: each.merit)
        found += _judged(pool, 1 if hopeless else effort.judged, found, told)
        found.sort(key=lambda each: each.merit)
        enough = found and found[0].is_whole and number + 1 >= min(2, effort.rounds)
        if not found or enough or hopeless:
            break
    progress(f"{points} points", 1.0)
    return found


def _told(progress: Progress, name: str, number: int, rounds: int, step: str, fraction: float) -> None:
    """Report a step of a round, from 0, with the fraction of the round that is done."""
    progress(f"{name}: {step}", (number + fraction) / rounds)


def look(asked: Question, name: str, points: int, draws: int) -> Screened | None:
    """The best of a few designs as closed forms see it, in a fraction of a second.

    Rules of the layout take the least time, so they are computed first. None if no design keeps them.
    """
    for grid in grids(asked, points)[:1]:
        layout = Candidates(asked, name, grid)
        drawn = layout.drawn(draws)
        values = measure([design for design, _ in drawn], _OF_LAYOUT) if drawn else []
        kept = [each for each, own in zip(drawn, values, strict=True) if not any(_broken(own)[:2])]
        return min(screened(layout, kept), key=lambda each: each.merit, default=None)
    return None


def obstacle(asked: Question) -> str:
    """Reason in words why no design answers a question at all."""
    points = asked.points or asked.microphones
    layouts = grids(asked, points)
    if not layouts:
        return f"{points} points have no such rows and columns"
    return Candidates(asked, "none", layouts[0]).obstacle


def judge(candidate: Screened) -> Found | None:
    """The verdict on a design; None where it cannot be built."""
    return next(iter(_judged([candidate], 1, ())), None)


def is_hopeless(best: Screened) -> bool:
    """True where even the best of many designs breaks a rule of closed forms, or is confused under scatter."""
    failed, marginal, error = best.merit
    return failed + marginal > 0 or error - (_CLIPPED if best.clipped else 0.0) > _HOPELESS


def _first(layouts: Sequence[Candidates], draws: int, progress: Progress = silent) -> list[Screened]:
    """Designs of the layouts, the best first; of later layouts only if those of the first are not promising."""
    pool: list[Screened] = []
    for place, layout in enumerate(layouts):
        if pool and not is_hopeless(min(pool, key=lambda each: each.merit)):
            break  # the layout most like the room will do
        progress(f"designs of layout {place + 1}", _DRAWING * place / len(layouts))
        pool += screened(layout, layout.drawn(draws if place == 0 else draws // 4))
    return sorted(pool, key=lambda each: each.merit)


def screened(layout: Candidates, drawn: Sequence[tuple[ArrayDesign, Sizes]]) -> list[Screened]:
    """Drawn designs with the figures that closed forms give.

    If the deflection of the membrane keeps all of them from working, the best of those whose estimate is not clear are
    pressed by finite elasticity.
    """
    if not drawn:
        return []
    designs = [design for design, _ in drawn]
    known = QuickDiscs(designs)
    levels = tap_levels(designs, known)
    values = measure(designs, QUICK, known=known, estimated=True, levels=levels)
    loss = np.array([each.loss_to_second.max() for each in levels])
    for own, level in zip(values, levels, strict=True):
        own["heard"] = Measured(float(level.second.min()), "")
    with np.errstate(all="ignore"):  # where nothing is received at all
        errors = scatter_detection([_longest_line(design) for design in designs], known)
    # Beyond some loss the noise confuses more points than the scatter.
    errors = np.where(np.isfinite(errors), errors, 1.0) + _PER_DECIBEL * np.maximum(loss - _LOSS, 0.0)
    loudest = np.array([taps.max() for taps in loudest_taps(designs, known)])
    clipped = loudest > np.array([design.microphone.overload for design in designs])
    found = [
        Screened(design, sizes, layout.grid, own, float(error), bool(over))
        for (design, sizes), own, error, over in zip(drawn, values, errors, clipped, strict=True)
    ]
    if all(any(each.merit[:2]) for each in found):
        unclear = [each for each in found if CLEAR[0] < each.values["bottoming"].value < CLEAR[1]]
        for each in sorted(unclear, key=lambda each: each.merit)[:_PRESSED]:
            each.values["bottoming"] = bottoming(each.design, known)
    return found


def _longest_line(design: ArrayDesign) -> ArrayDesign:
    """The longest line of a design with its two microphones alone: points of one line are confused most easily."""
    line = max(design.lines, key=lambda each: each.points)
    return design.model_copy(update={"microphones": line.between, "lines": (line,)})


def _judged(pool: Iterable[Screened], count: int, before: Sequence[Found], progress: Progress = silent) -> list[Found]:
    """The first of a pool that can be built and differ from each other, with their verdicts."""
    found: list[Found] = []
    known = {_mark(each.design) for each in before}
    for each in pool:
        if len(found) == count:
            break
        if _mark(each.design) in known or not can_be_built(each.design):
            continue
        known.add(_mark(each.design))
        progress(f"verdict {len(found) + 1} of {count}", _DRAWING + (1 - _DRAWING) * len(found) / count)
        verdict = Verdict(each.design)
        verdict.values  # noqa: B018  computed here, so that the progress is that of the work
        found.append(Found(each.design, verdict, each.sizes, each.grid))
    return found


def can_be_built(design: ArrayDesign) -> bool:
    """True where no part is in another's way and every microphone lies at its tubes' length."""
    try:
        layout = lay_out(design)
        refuse_overlaps(design, layout)
    except (DesignError, OverlapError, Refusal):
        return False
    return not schematic_notes(design, layout)


def _mark(design: ArrayDesign) -> tuple[object, ...]:
    """Equal for designs that differ by too little to be shown beside each other."""
    tube, membrane = design.tube, design.membrane
    return (
        design.layout.columns, design.layout.microphone_side, tube.inner_diameter, membrane.thickness,
        membrane.material, round(design.resonator.cavity_diameter), design.microphone.model,
    )  # fmt: skip


def _broken(values: Mapping[str, Measured]) -> tuple[int, int, float]:
    """Numbers of rules that do not work and that are marginal, and by how much their limits are missed."""
    known = {rule.name: (rule, values[rule.name].value) for rule in RULES if rule.name in values}
    outcomes = [OUTCOMES.index(rule.outcome(value)) for rule, value in known.values()]
    missed = 0.0
    for rule, value in known.values():
        if rule.outcome(value) != "works":
            missed += min(abs(value - rule.works) / max(abs(rule.works), 1e-3), 100.0)
    return outcomes.count(2), outcomes.count(1), missed if outcomes.count(1) + outcomes.count(2) else 0.0


def _accuracy(values: Mapping[str, Measured]) -> float:
    """Least accuracy of as-built sensors; 0 where it is not known."""
    rates = [values[name].value for name in ("taps", "presses", "multi-sines")]
    return 0.0 if any(math.isnan(rate) for rate in rates) else min(rates)
