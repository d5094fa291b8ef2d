"""Design files whose places are to be fitted: read without them, and written beside the design once they are found."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import tomlkit

from geometry.body.reading import read_body
from geometry.design.array_design import ArrayDesign, validated
from geometry.design.design_file import design_document, load_design
from geometry.design.frozen_rules import inputs_of
from geometry.design.places_file import names_places, save_places
from geometry.ground.refusal import Kind
from geometry.ground.text_files import read_toml
from geometry.ground.whole_files import check_own_kind, write_text
from geometry.schema.array_fields import Layout
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
    design = unfitted(data, str(path))
    assert design.surface is not None
    return FitTask(design, path.parent / design.surface.body, places)


def open_design(path: str | os.PathLike[str]) -> ArrayDesign:
    """The design of a file; one whose places are still to be fitted as a serpentine.

    Raises:
        DesignError: the file is not a design, or does not go with its places.
    """
    path = Path(path)
    data = read_toml(path, "a design file", DesignError)
    if "surface" in data and names_places(data) and not (path.parent / data["layout"]["places"]).exists():
        return read_fit(path).design
    return load_design(path)


def unfitted(data: Mapping[str, Any], source: str) -> ArrayDesign:
    """The array of a design file whose places are not found yet, as a serpentine.

    Args:
        data: tables of the file.
        source: its name, for messages.

    Raises:
        DesignError: not a design, or it states what the fit finds.
    """
    lines = data.get("lines")
    pitched = isinstance(data["surface"], Mapping) and data["surface"].get("pitch") is not None
    if isinstance(lines, list):
        lines = [_line(number, line, pitched, source) for number, line in enumerate(lines)]
    return validated({**data, "layout": {"kind": "serpentine"}, "lines": lines}, source)


def text_with_places(design: ArrayDesign, places: str) -> str:
    """Text of a design file that names a file of places, which also has the lengths of the lines.

    Args:
        design: the array with its table ``[surface]``, fitted or not.
        places: name of the file.
    """
    assert design.surface is not None
    plain = Layout(kind="serpentine")
    lines = tuple(line.model_copy(update={"lengths": None}) for line in design.lines)
    document = design_document(design.model_copy(update={"layout": plain, "lines": lines}))
    table = tomlkit.table()
    table.add("kind", "surface")
    table.add("places", places)
    document["layout"] = table
    if design.surface.pitch is not None:  # the fit counts the points
        for line in document["lines"]:
            line.pop("points")
    return tomlkit.dumps(document)


def save_fitted(design: ArrayDesign, folder: Path) -> Path:
    """Write a fitted array as its design file and, beside it, the file of places that this names.

    Returns:
        Path of the design file.
    """
    path = folder / f"{design.name}.toml"
    save_places(design, folder / f"{design.name}.places.json")
    write_text(path, text_with_places(design, f"{design.name}.places.json"))
    return path


def _line(number: int, line: Any, pitched: bool, path: str) -> Any:
    """A line as it is before the fit."""
    if not isinstance(line, Mapping):
        return line
    for field in ("lengths", "pattern"):
        if line.get(field) is not None:
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
