"""Rows of the panel that compares the pinned design with the current one, by the rules of every comparison."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from geometry.design.array_design import ArrayDesign
from studies.comparison.compared_rows import compared_figures, differing_fields
from studies.comparison.comparing import compare
from studies.comparison.own_figures import OwnFigure
from studies.panels.cad_panel import CallbackDisplay

#: File of the page that compares two designs.
COMPARISON = "comparison.html"
#: Characters that are kept of the name of a design, to which its role is added.
LONGEST_NAME = 60


def field_rows(now: ArrayDesign, pinned: ArrayDesign) -> list[dict[str, Any]]:
    """Fields that the current and the pinned design do not have alike, in the order of a design file.

    Returns:
        For each field its ``name``, ``unit``, and the value ``here`` and ``there``, which is that of the pinned design;
        None where the design does not have the field.
    """
    return [
        {"name": each.name, "unit": each.unit, "here": each.values[0], "there": each.values[1]}
        for each in differing_fields([now, pinned])
    ]


def figure_rows(now: Mapping[str, float | None], pinned: Mapping[str, float | None]) -> list[dict[str, Any]]:
    """Figures of the current and of the pinned design side by side.

    Args:
        now: value of each of :data:`studies.comparison.FIGURES` for the current design, None if it is not known.
        pinned: the same for the pinned design.

    Returns:
        For each figure its ``name``, ``title``, ``unit`` and ``definition``; the value ``here`` and ``there``, and the
        two as ``texts`` with their unit, the pinned one first; ``better``, which is "better", "worse" or empty for the
        current design.
    """
    both = [{name: OwnFigure(value) for name, value in each.items()} for each in (pinned, now)]
    return [
        {
            "name": row.quantity.name,
            "title": row.quantity.title,
            "unit": row.quantity.unit,
            "definition": row.quantity.definition,
            "there": row.values[0],
            "here": row.values[1],
            "texts": list(row.written),
            "better": {(): "", (0,): "worse", (1,): "better"}[row.best],
        }
        for row in compared_figures(both)
    ]


def make_comparison(
    now: ArrayDesign, pinned: ArrayDesign, folder: str, notify: Callable[[str], None] = lambda line: None
) -> str:
    """Write the page that compares the pinned design with the current one.

    Args:
        now: the current design.
        pinned: the pinned design.
        folder: exists and is empty.
        notify: called with what is being done.

    Returns:
        Path of the page, in the folder.

    Raises:
        Refusal: as :func:`studies.compare`.
    """
    path = Path(folder) / COMPARISON
    both = [
        each.with_values({"name": f"{each.name[:LONGEST_NAME]}-{word}"})
        for each, word in ((pinned, "pinned"), (now, "now"))
    ]
    compare(*both, out=path, display=CallbackDisplay(notify))
    return str(path)
