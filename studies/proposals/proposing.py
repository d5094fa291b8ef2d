"""Designs that answer a question, at most three with their trade, and what would work where none does."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Field, Kind, Refusal, Text
from geometry.ground.shown import Shown
from studies.proposals.design_search import Found, Progress, obstacle, search, silent, thorough
from studies.proposals.designer_question import SHOWN, Question, question
from studies.proposals.drawn_designs import drawn_findings
from studies.proposals.most_points import most_points
from studies.proposals.other_questions import Alternative, alternatives
from studies.verdict import Drawn, Verdict, force_in_words


@dataclass(frozen=True, repr=False, eq=False)
class Proposal(Shown):
    """One design that is proposed."""

    design: ArrayDesign
    """The design."""
    verdict: Verdict
    """Verdict on it, which holds its accuracy, smallest tap, size and cost."""
    strength: str
    """Strength of the design among those proposed, in words."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        figures, design = self.verdict.figures, self.design
        return f"Proposal {design.name}: {self.verdict.outcome}", {
            "strength": self.strength,
            "points": design.point_count,
            "size (mm)": " x ".join(f"{side:.1f}" for side in figures.size),
            "smallest tap": force_in_words(figures.smallest_force),
            "as-built taps": f"{figures.taps:.1%}",
            "cost (USD)": f"{figures.cost:.2f}",
        }

    def to_dict(self) -> dict[str, Any]:
        """The proposal as JSON can hold it."""
        return {
            "strength": self.strength,
            "points": self.design.point_count,
            "verdict": self.verdict.to_dict(),
            "design": self.design.model_dump(mode="json"),
        }


@dataclass(frozen=True, repr=False, eq=False)
class Proposals(Shown):
    """Answer to a question."""

    question: Question
    """The question."""
    designs: tuple[Proposal, ...]
    """Designs with their verdicts, the best first; empty if nothing can be built."""
    alternatives: tuple[Alternative, ...]
    """Changes of the question with which a design works; only if none of :attr:`designs` does."""

    @property
    def works(self) -> bool:
        """True where the best design works."""
        return bool(self.designs) and self.designs[0].verdict.outcome == "works"

    @cached_property
    def problem(self) -> str:
        """Reason in one sentence why no design works; empty if one does."""
        if self.works:
            return ""
        if not self.designs:
            if self._is_too_narrow:
                return f"{self.question.around:g} mm around is {self._diameter:.0f} mm wide without the shells"
            return obstacle(self.question)
        verdict = self.designs[0].verdict
        return verdict.values[verdict.broken[0].name].words

    @property
    def remedy(self) -> Text:
        """Pieces of a sentence on the changes of the question with which a design works."""
        pieces: list[str] = []
        for each in self.alternatives:
            pieces += [*([", or "] if pieces else ["try "]), *each.text]
        return tuple(pieces)

    @property
    def _diameter(self) -> float:
        """Diameter of what the array goes around, mm; 0 where it is flat."""
        return (self.question.around or 0.0) / math.pi

    @property
    def _is_too_narrow(self) -> bool:
        """True where the size is below the diameter, so that there is no ring, and no part of a turn has room."""
        size = self.question.size
        return not self.designs and size is not None and max(size) < self._diameter

    def refusal(self) -> Refusal:
        """The error of a question that no design answers."""
        asked = self.question
        if self._is_too_narrow:
            assert asked.size is not None
            problem = f"is too small: {self.problem}, and a part of a turn has no room for the points"
            size = f"{asked.size[0]:g}x{asked.size[1]:g}"
            remedy = ("leave out ", Field("size"), ", or ", Field("around"))
            return Refusal(problem, kind=Kind.CONFLICT, field="size", value=size, remedy=remedy)
        value = "most" if asked.points is None else asked.points
        problem = f"has no design that works: {self.problem}"
        return Refusal(problem, kind=Kind.CONFLICT, field="points", value=value, remedy=self.remedy)

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        facts = {
            f"{number}. {each.strength}": f"{each.verdict.outcome}, {each.verdict.figures.taps:.1%} of taps, "
            f"{each.verdict.figures.cost:.2f} USD"
            for number, each in enumerate(self.designs, 1)
        }
        return f"Proposals for {self.question.words}", facts | ({"problem": self.problem} if self.problem else {})


def propose_designs(name: str = "design", *, progress: Progress | None = None, **asked: Any) -> Proposals:
    """Search designs that answer a question, made of parts that can be bought.

    Layouts and sizes are drawn from a fixed seed, so that the same question has the same answer. All are ranked by
    closed forms, and the best are given a verdict.

    Args:
        name: name of the designs.
        progress: function that is called with the name of a step and the fraction done.
        asked: requirements by name, as of :func:`studies.proposals.designer_question.question`.

    Returns:
        At most three designs with their verdicts; if none works, also what would.

    Raises:
        Refusal: a value out of range, or values that exclude each other.
    """
    return propose(question(**asked), name, progress)


def propose(asked: Question, name: str, progress: Progress | None = None) -> Proposals:
    """The answer to a question; arguments as for :func:`propose_designs`."""
    told = progress or silent
    with warnings.catch_warnings():
        # check gives these warnings for the design that is chosen
        warnings.simplefilter("ignore", ModelLimitWarning)
        if asked.points is None:
            found = most_points(asked, name, told)
        else:
            found = search(asked, name, asked.points, thorough(asked.points), told)
        designs = _chosen(_sound(found, told))
        if designs and designs[0].verdict.outcome == "works":
            return Proposals(asked, designs, ())
        if Proposals(asked, designs, ())._is_too_narrow:
            return Proposals(asked, designs, ())
        broken = [rule.name for rule in designs[0].verdict.broken] if designs else []
        return Proposals(asked, designs, alternatives(asked, name, told, broken))


def _sound(found: Sequence[Found], progress: Progress) -> list[Found]:
    """Found designs without those that would be proposed and that do not go together as drawn, the best first.

    Drawing takes seconds, so that only designs that would be proposed and work by closed forms are drawn. Where all
    are unsound, the best one stays with a verdict that says so.
    """
    left, unsound = list(found), list[tuple[Found, Drawn]]()
    drawn: set[int] = set()
    while new := [
        each.design for each in _chosen(left) if each.verdict.outcome == "works" and id(each.design) not in drawn
    ]:
        progress(f"parts of design {len(drawn) + 1}", 1.0)
        drawn.add(id(new[0]))
        findings = drawn_findings(new[0])
        if findings != Drawn():
            (bad,) = (each for each in left if each.design is new[0])
            left.remove(bad)
            unsound.append((bad, findings))
    if left or not unsound:
        return left
    best, findings = unsound[0]
    return [replace(best, verdict=Verdict(best.design, drawn=findings))]


def _chosen(found: Sequence[Found]) -> tuple[Proposal, ...]:
    """The best design, and of those with an equally good verdict the cheapest and that with the lightest touch.

    A design that is best at several things is proposed once, so that every strength is true of all that are proposed.
    """
    if not found:
        return ()
    best, *others = found
    equal = [each for each in others if each.verdict.outcome == best.verdict.outcome] or others
    wishes: dict[str, Callable[[Found], float]] = {
        "most accurate": lambda each: -each.accuracy,
        "cheapest": lambda each: each.verdict.figures.cost,
        "lightest touch": lambda each: each.verdict.figures.smallest_force,
    }
    strengths: dict[Found, list[str]] = {best: []}
    for strength, figure in wishes.items():
        pick = min((best, *equal), key=figure)  # the first of equal ones
        if pick in strengths or len(strengths) < SHOWN:
            strengths.setdefault(pick, []).append(strength)
    if len(strengths) < SHOWN:
        thinnest = min((best, *equal), key=lambda each: each.verdict.figures.size[2])
        strengths.setdefault(thinnest, ["thinnest"])
    for each in equal:
        if len(strengths) < SHOWN:
            strengths.setdefault(each, [])
    return tuple(
        Proposal(each.design, each.verdict, ", ".join(own) or ("fewest problems" if each is best else "next best"))
        for each, own in strengths.items()
    )
