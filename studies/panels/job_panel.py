"""The job of a sensor as the studio's dialogue asks for it, the designs that are proposed for it, and their plans."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import prototype, prototype_names
from geometry.ground.refusal import Kind, Refusal
from geometry.layout.arrangement import lay_out
from geometry.schema.print_processes import PROCESSES
from studies.panels.form import stated_values
from studies.proposals import PLACES, propose, question
from studies.proposals.designer_question import CONTACTS, PRINTER, TARGET
from studies.verdict import SHOWN, figure_rows

#: Answers of the dialogue: the name of each requirement, with the type of its value.
ANSWERS: Mapping[str, type] = {
    "place": str,
    "points": str,
    "microphones": int,
    "size": str,
    "around": float,
    "printer": str,
    "target": str,
    "budget": float,
}
#: Significant digits of places in a plan.
_DIGITS = 4


def job_words() -> dict[str, Any]:
    """Choices that the dialogue offers.

    Returns:
        ``places``: name and title of each, with its usual ``points``, ``microphones``, ``size`` and ``around``;
        ``printers``: name and title of each; ``printer`` and ``target``, the usual ones; ``contacts``, their names;
        ``prototypes``: name and plan of each, as of :func:`plan_of`.
    """
    return {
        "places": {
            name: {
                "title": place.words,
                "points": place.points,
                "microphones": place.microphones,
                "size": None if place.size is None else f"{place.size[0]:g}x{place.size[1]:g}",
                "around": place.around,
            }
            for name, place in PLACES.items()
        },
        "printers": {name: process.title for name, process in PROCESSES.items()},
        "printer": PRINTER,
        "target": TARGET,
        "contacts": list(CONTACTS),
        "prototypes": {name: plan_of(prototype(name)) for name in prototype_names()},
    }


def plan_of(design: ArrayDesign) -> dict[str, Any]:
    """Places in plan from which a small picture of an array is drawn.

    Returns:
        ``points``: x, y and radius of each membrane, mm; ``microphones``: x and y of each, mm; ``lines``: numbers of
        the points of each line, from 1.
    """
    layout = lay_out(design)
    radius = [design.of_kind(kind).resonator.cavity_diameter / 2 for kind in design.kinds]
    lines, first = [], 1
    for line in design.lines:
        lines.append([*range(first, first + line.points)])
        first += line.points
    return {
        "points": [
            [*map(_rounded, point.position[:2]), radius[kind]]
            for point, kind in zip(layout.points, design.kind_of_point, strict=True)
        ],
        "microphones": [[*map(_rounded, each.position[:2])] for each in layout.microphones],
        "lines": lines,
    }


def proposals_for(
    name: str, asked: Mapping[str, Any], notify: Callable[[str], None] = lambda line: None
) -> dict[str, Any]:
    """Designs that are proposed for a job, as cards show them.

    Args:
        name: of the designs.
        asked: some of :data:`ANSWERS`, as :func:`studies.propose_designs` takes them.
        notify: called with how far the search is.

    Returns:
        ``question`` in words; ``problem``: why no design works and what would, empty if one does; ``designs``: of each
        its ``strength``, ``outcome``, number of ``points``, the ``rows`` of its figures, its worst ``reasons`` in
        words, its ``plan`` and what it ``stated``, as of :func:`studies.panels.stated_values`.

    Raises:
        Refusal: a requirement that is not known, of the wrong type or out of range, or requirements that exclude each
            other.
    """
    for key, value in asked.items():
        if key not in ANSWERS:
            raise Refusal(kind=Kind.UNKNOWN, field="requirement", value=key, allowed=tuple(ANSWERS))
        wanted = (int, float) if ANSWERS[key] is float else ANSWERS[key]
        if not isinstance(value, wanted) or isinstance(value, bool):
            words = {str: "a text", int: "a whole number", float: "a number"}[ANSWERS[key]]
            raise Refusal(kind=Kind.WRONG_TYPE, field=key, value=value, allowed=words)
    wished = question(**asked)
    found = propose(wished, name, lambda step, done: notify(f"{step}, {done:.0%}"))
    return {
        "question": wished.words,
        "problem": "" if found.works else str(found.refusal()),
        "designs": [
            {
                "strength": each.strength,
                "outcome": each.verdict.outcome,
                "points": each.design.point_count,
                "rows": [list(row) for row in figure_rows(each.verdict)],
                "reasons": [each.verdict.values[rule.name].words for rule in each.verdict.broken[:SHOWN]],
                "plan": plan_of(each.design),
                "stated": stated_values(each.design),
            }
            for each in found.designs
        ],
    }


def _rounded(value: float) -> float:
    return float(f"{value:.{_DIGITS}g}")
