"""Page of a comparison: one file that opens without a network, in a light and in a dark scheme."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from geometry.ground.extras import is_installed
from geometry.ground.stated_times import stated_time
from geometry.ground.whole_files import write_text
from studies.comparison.compared import Comparison
from studies.comparison.compared_rows import ComparedFigure
from studies.comparison.quantities import OVERVIEW, REASONS
from studies.output.report_texts import inlined_drawing, rendered_page


def write_comparison(found: Comparison, path: Path) -> None:
    """Write the page of a comparison.

    Args:
        found: the comparison.
        path: the file.
    """
    write_text(path, render_comparison(found))


def render_comparison(found: Comparison) -> str:
    """Page of a comparison as text. Without matplotlib it has no curves and says so."""
    groups = {name: rows for name, rows in found.groups.items() if name != REASONS}
    return rendered_page(
        "comparison.html",
        found=found,
        created=stated_time(),
        overview=[_row(each) for each in groups.pop(OVERVIEW, ())],
        groups={name: [_row(each) for each in rows] for name, rows in groups.items()},
        definitions=[each.quantity for each in found.figures if each.quantity.definition],
        strengths=strengths(found),
        drawing=inlined_drawing(found.plot()) if is_installed("plots") else "",
    )


def strengths(found: Comparison) -> list[tuple[str, list[str]]]:
    """Name of each subject with the titles of the figures of the overview in which it is better than others.

    The verdict is left out, because it stands beside them.
    """
    rows = [each for each in found.groups.get(OVERVIEW, ()) if each.quantity.name != "verdict"]
    return [(name, [row.quantity.title for row in rows if place in row.best]) for place, name in enumerate(found.names)]


def _row(figure: ComparedFigure) -> dict[str, Any]:
    cells: Sequence[tuple[str, str, bool]] = [
        (text, why, place in figure.best)
        for place, (text, why) in enumerate(zip(figure.written, figure.reasons, strict=True))
    ]
    return {"title": figure.quantity.title, "definition": figure.quantity.definition, "cells": cells}
