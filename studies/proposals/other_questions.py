"""Questions like one that no design answers, which some design does answer."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace
from itertools import zip_longest
from typing import Any

from geometry.ground.refusal import Field, Text
from studies.proposals.design_search import Found, Progress, Screened, judge, look
from studies.proposals.designer_question import CONTACTS, Question, most_microphones

#: Number of questions after which no further one is tried, and once an answer is known. Processor time would make the
#: answers depend on the machine.
_QUESTIONS, _ONCE_TOLD = 14, 6
#: Factors by which points and sizes are tried, and numbers of microphones.
_FEWER, _SIZES, _COUNTS = (0.8, 0.64, 0.5, 0.36, 0.25, 0.16), (1.25, 0.8, 1.6, 0.6, 0.45), (3, 4, 6, 8, 11, 16)
#: Factors by which a budget and a force are tried.
_DEARER, _GENTLER = (1.25, 1.6, 2.5, 4.0), (0.5, 0.2, 0.1, 0.02)
#: Least ratio of two numbers of microphones that are tried.
_APART = 1.2
#: Designs that are looked at for each question, times its points, and the error up to which the best gets a verdict.
_DRAWS, _PROMISING = 2400, 0.3
#: Factor of these where an option is left out, because then all else stays as it was wished.
_MORE = 6
#: Number of answers that a refusal states.
_TOLD = 2

#: Options that a question works without.
_PRESCRIBED = ("pitch", "rows", "columns", "tubes_below")
#: Rules that only another room or another touch can keep.
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
    told: list[Alternative] = []
    for number, (other, text, best) in enumerate(_promising(asked, name, set(broken)), 1):
        progress("what would work instead", min(number / _QUESTIONS, 1.0))
        known = any(_is_more(text, each.text) for each in told)
        found = None if known or best is None or best.error > _PROMISING else judge(best)
        if found is not None and found.verdict.outcome == "works":
            told.append(Alternative(other, text, found))
        if number >= (_ONCE_TOLD if told else _QUESTIONS) or len(told) == _TOLD:
            break
    progress("what would work instead", 1.0)
    return tuple(told)


def _is_more(text: Text, other: Text) -> bool:
    """True where a change is another one and more, or changes the same options further."""
    own, known = ([piece for piece in each if isinstance(piece, Field)] for each in (text, other))
    return text[: len(other)] == other or own == known


def _promising(asked: Question, name: str, broken: set[str]) -> Iterator[tuple[Question, Text, Screened | None]]:
    """Other questions, their changes in words, and the best design of each that breaks no rule of closed forms.

    First those with one change, the smallest change of each kind first; then those with two, of which the first alone
    leaves only the accuracy to be improved. Where a rule of the layout is broken, the first change that keeps it is
    taken further. No design comes with a question that is not promising.
    """
    fields = {
        "prescribed": list(_freed(asked)),
        "budget": list(_budgets(asked, broken)),
        "size": list(_sizes(asked, broken)),
        "target": list(_targets(asked, broken)),
    }
    if not broken & _OF_ROOM:
        fields |= {"microphones": list(_microphones(asked)), "points": list(_points(asked))}
    halves: list[tuple[str, Change]] = []
    for steps in zip_longest(*fields.values()):
        for field, step in zip(fields, steps, strict=True):
            if step is None:
                continue
            other = replace(asked, **step[0])
            best = look(other, name, other.points or 0, _draws(other) * (_MORE if field == "prescribed" else 1))
            sound = best is not None and sum(best.merit[:2]) == 0
            if sound:
                halves.append((field, step))
            yield other, step[1], best if sound else None
        if halves and broken & _OF_ROOM:
            break  # the rules of the layout are kept, so that only the accuracy is left
    for field, (values, text) in halves:
        half = replace(asked, **values)
        for second in (*_microphones(half), *_points(half)):
            if field in second[0]:
                continue
            other = replace(half, **second[0])
            best = look(other, name, other.points or 0, _draws(other))
            sound = best is not None and sum(best.merit[:2]) == 0
            yield other, (*text, " and ", *second[1]), best if sound else None


def _draws(asked: Question) -> int:
    """Designs that are looked at: each takes the longer the more points it has."""
    return min(max(_DRAWS // (asked.points or 1), 24), 100)


def _freed(asked: Question) -> Iterator[Change]:
    for field in _PRESCRIBED:
        if getattr(asked, field) is not None:
            yield {field: None}, ("without ", Field(field))


def _microphones(asked: Question) -> Iterator[Change]:
    for count in _counts(asked.points):
        if asked.microphones < count <= most_microphones(asked) and asked.kind == "flat":
            yield {"microphones": count}, (Field("microphones"), f"={count}")


def _counts(points: int | None) -> list[int]:
    """Numbers of microphones in ascending order; those whose lines have equally many points, if there are several."""
    even = [count for count in range(3, 17) if points and points % (count - 1) == 0]
    kept: list[int] = []
    for count in even:
        if not kept or count >= _APART * kept[-1]:
            kept.append(count)
    return kept if len(kept) > 1 else list(_COUNTS)


def _sizes(asked: Question, broken: set[str]) -> Iterator[Change]:
    if asked.size is None or asked.pitch is not None:
        return
    for factor in _SIZES:
        if broken & _OF_ROOM == ({"coverage"} if factor > 1 else {"separate"}):
            continue  # points that lie too far apart want no more room, and those too near no less
        sides = (float(f"{factor * asked.size[0]:.2g}"), float(f"{factor * asked.size[1]:.2g}"))
        yield {"size": sides}, (Field("size"), f"='{sides[0]:g}x{sides[1]:g}'")


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
            yield {"points": fewer}, (Field("points"), f"={fewer}")


def _budgets(asked: Question, broken: set[str]) -> Iterator[Change]:
    if asked.budget is None or "affordable" not in broken:
        return
    for factor in _DEARER:
        budget = float(f"{factor * asked.budget:.2g}")
        yield {"budget": budget}, (Field("budget"), f"={budget:g}")


def _targets(asked: Question, broken: set[str]) -> Iterator[Change]:
    if "bottoming" in broken:
        word = next(word for word, radius in CONTACTS.items() if radius == asked.contact_radius)
        for factor in _GENTLER:
            force = float(f"{factor * asked.force:.2g}")
            touch = f"{word} {force:g} N"
            yield {"force": force, "touch": touch}, (Field("target"), f"='{touch}'")
        return
    for word, radius in CONTACTS.items():
        if radius > asked.contact_radius and asked.size is not None and min(asked.size) > 10 * radius:
            force = 10 * asked.force
            touch = f"{word} {force:g} N"
            yield {"contact_radius": radius, "force": force, "touch": touch}, (Field("target"), f"='{touch}'")
