"""Questions like one that no design answers, which some design does answer."""

from __future__ import annotations

import time
from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from itertools import zip_longest
from typing import Any

from geometry.ground.refusal import Field, Text
from studies.proposals.design_search import Found, Progress, Screened, judge, look
from studies.proposals.designer_question import CONTACTS, Question, most_microphones

SECONDS = 6.0
"""Processor time after which no further question is tried, s."""
#: Factors by which points and sizes are tried, and numbers of microphones.
_FEWER, _SIZES, _COUNTS = (0.8, 0.64, 0.5, 0.36, 0.25, 0.16), (1.25, 0.8, 1.6, 0.6, 0.45), (3, 4, 6, 8, 11, 16)
#: Designs that are looked at for each question, and the error up to which the best of them is given a verdict.
_DRAWS, _PROMISING = 24, 0.15
#: Number of answers that a refusal states.
_TOLD = 2

#: Rules that only another room or another touch can mend.
_OF_ROOM = {"coverage", "separate"}
#: Values of a question that change, by name, and their words.
Change = tuple[dict[str, Any], tuple[str, ...]]


@dataclass(frozen=True, eq=False)
class Alternative:
    """A question that differs from another in a few values, and a design that answers it."""

    question: Question
    """The other question."""
    text: Text
    """Its changes, as pieces of a sentence: names of arguments and their values."""
    found: Found
    """The design with its verdict."""


def alternatives(
    asked: Question, name: str, progress: Progress, broken: Collection[str] = ()
) -> tuple[Alternative, ...]:
    """Questions like one that no design answers, each with a design that works; at most two.

    Args:
        asked: the question.
        name: name of the designs.
        progress: called with the name of a step and the fraction done.
        broken: names of the rules of the verdict that its best design breaks.
    """
    begun = time.process_time()
    told: list[Alternative] = []
    for other, text, best in _promising(asked, name, set(broken)):
        spent = time.process_time() - begun
        progress("what would work instead", min(spent / SECONDS, 1.0))
        found = None if best is None or best.error > _PROMISING else judge(best)
        if found is not None and found.verdict.outcome == "works":
            told.append(Alternative(other, text, found))
        if spent > (SECONDS / 2 if told else SECONDS) or len(told) == _TOLD:
            break
    progress("what would work instead", 1.0)
    return tuple(told)


def _promising(asked: Question, name: str, broken: set[str]) -> Iterator[tuple[Question, Text, Screened | None]]:
    """Other questions, their changes in words, and the best design of each that breaks no rule of closed forms.

    First those with one change, the smallest change of each kind first; then those with two, of which the first alone
    leaves only the accuracy to be improved. No design comes with a question that is not promising.
    """
    fields = {"size": list(_sizes(asked)), "target": list(_targets(asked))}
    if not broken & _OF_ROOM:
        fields |= {"microphones": list(_microphones(asked)), "points": list(_points(asked))}
    halves: list[tuple[str, Change]] = []
    for steps in zip_longest(*fields.values()):
        for field, step in zip(fields, steps, strict=True):
            if step is None:
                continue
            other = replace(asked, **step[0])
            best = look(other, name, other.points or 0, _DRAWS)
            sound = best is not None and sum(best.merit[:2]) == 0
            if sound:
                halves.append((field, step))
            yield other, step[1], best if sound else None
    for field, (values, text) in halves:
        half = replace(asked, **values)
        for second in (*_microphones(half), *_points(half)):
            if field in second[0]:
                continue
            other = replace(half, **second[0])
            best = look(other, name, other.points or 0, _DRAWS)
            sound = best is not None and sum(best.merit[:2]) == 0
            yield other, (*text, " and ", *second[1]), best if sound else None


def _microphones(asked: Question) -> Iterator[Change]:
    for count in _COUNTS:
        if asked.microphones < count <= most_microphones(asked) and asked.kind == "flat":
            yield {"microphones": count}, (Field("microphones"), f" = {count}")


def _sizes(asked: Question) -> Iterator[Change]:
    if asked.size is None or asked.pitch is not None:
        return
    for factor in _SIZES:
        sides = (float(f"{factor * asked.size[0]:.2g}"), float(f"{factor * asked.size[1]:.2g}"))
        yield {"size": sides}, (Field("size"), f" = {sides[0]:g}x{sides[1]:g}")


def _points(asked: Question) -> Iterator[Change]:
    if asked.rows is not None or asked.columns is not None or asked.points is None:
        return
    known = {asked.points}
    for factor in _FEWER:
        # of full rows, so that the last one is not short
        side = max(round((factor * asked.points) ** 0.5), 1)
        fewer = max(side * round(factor * asked.points / side), asked.microphones, 2)
        if fewer < asked.points and fewer not in known:
            known.add(fewer)
            yield {"points": fewer}, (Field("points"), f" = {fewer}")


def _targets(asked: Question) -> Iterator[Change]:
    for word, radius in CONTACTS.items():
        if radius > asked.contact_radius and asked.size is not None and min(asked.size) > 10 * radius:
            force = 10 * asked.force
            touch = f"{word} {force:g} N"
            yield {"contact_radius": radius, "force": force, "touch": touch}, (Field("target"), f" = '{touch}'")
