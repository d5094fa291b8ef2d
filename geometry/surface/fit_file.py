"""Design files whose places are to be fitted: read without them, and written beside the design once they are found."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from geometry.body.reading import read_body
from geometry.design.array_design import ArrayDesign, validated
from geometry.design.design_file import load_design
from geometry.design.frozen_rules import inputs_of
from geometry.design.places_file import names_places, save_places
from geometry.ground.refusal import Kind
from geometry.ground.text_files import read_toml
from geometry.ground.whole_files import check_own_kind
from geometry.schema.field_errors import DesignError
from geometry.surface.surface_fit import FittedSurface, fit_surface


@dataclass(frozen=True)
class FitTask:
    """Array of a design file, its body and the file for its places."""

    design: ArrayDesign
    """The array with its table ``[surface]``, as a serpentine."""
    body: Path
    """File of the body."""
    places: Path
    """File that the places are written to."""


def read_fit(path: str | os.PathLike[str]) -> FitTask:
    """A design file whose places need not exist yet.

    Raises:
        DesignError: the file is not a design, names no body or no file of places, or states what the fit finds.
    """
    path = Path(path)
    data = read_toml(path, "a design file", DesignError)
    if "surface" not in data:
        allowed = "a table with the body and the pitch, which the fit needs"
        raise DesignError(kind=Kind.MISSING, file=path, field="surface", allowed=allowed)
    if not names_places(data) or data["layout"].get("kind") != "surface":
        allowed = 'a table of kind = "surface" and places = "NAME.places.json", which the fit writes'
        raise DesignError(kind=Kind.MISSING, file=path, field="layout", allowed=allowed)
    places = path.parent / data["layout"]["places"]
    check_own_kind(places, ".json", DesignError)
    lines = data.get("lines")
    pitched = isinstance(data["surface"], Mapping) and "pitch" in data["surface"]
    if isinstance(lines, list):
        lines = [_line(number, line, pitched, path) for number, line in enumerate(lines)]
    design = validated({**data, "layout": {"kind": "serpentine"}, "lines": lines}, str(path))
    assert design.surface is not None
    return FitTask(design, path.parent / design.surface.body, places)


def _line(number: int, line: Any, pitched: bool, path: Path) -> Any:
    """A line as it is before the fit."""
    if not isinstance(line, Mapping):
        return line
    for field in ("lengths", "pattern"):
        if field in line:
            problem = "is not for a design that is fitted: the fit finds the lengths, and all its points are alike"
            raise DesignError(problem, kind=Kind.CONFLICT, file=path, field=f"lines.{number}.{field}")
    if pitched and "points" in line:
        problem = "is not allowed beside surface.pitch, from which the fit counts the points"
        raise DesignError(
            problem, kind=Kind.CONFLICT, file=path, field=f"lines.{number}.points", remedy="leave one of the two out"
        )
    return {"points": 1, **line} if pitched else line


def fit_design(
    path: str | os.PathLike[str], report: Callable[[str, float], None] = lambda text, fraction: None
) -> tuple[FittedSurface, Path]:
    """Lay the array of a design file on its body, and write the file of places that the design names.

    Args:
        path: the design file.
        report: called with what is done, in words, and the fraction of the work that is behind.

    Returns:
        The array with its findings, and the file that was written.

    Raises:
        Refusal: the design, the body or the region does not do, or parts overlap in every try.
    """
    task = read_fit(path)
    stated = task.design.surface
    assert stated is not None
    report(f"reading {task.body.name}", 0.0)
    shell = task.design.resonator.outer_diameter
    body = read_body(task.body, stated.unit, stated.skin, 3 * shell)
    fitted = fit_surface(task.design, body, inputs_of(stated), report)
    save_places(fitted.design, task.places)
    load_design(path)
    return fitted, task.places
