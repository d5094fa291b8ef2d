"""The form of a design: every field that it has, with the unit, range, choices and words that its model declares."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel

from geometry.design.array_design import ArrayDesign
from geometry.design.changes import as_lists
from geometry.design.field_values import declared_at, field_values
from geometry.schema.materials import MATERIALS
from geometry.stock import catalogue

#: Ends of the names of fields whose text is the name of a material.
_MATERIAL = "material"
#: Beginnings of the names of fields of frozen places, and of what they are fitted to.
_FITTED = ("layout.frozen.", "surface.")


def stated_values(design: ArrayDesign) -> dict[str, Any]:
    """Fields of a design, as tables and lists that JSON can hold; a design is made from it again by ``validated``.

    Tables that follow others are left out, so that they go on to follow.
    """
    values: dict[str, Any] = as_lists(design.model_dump(mode="json"))
    return {name: value for name, value in values.items() if name not in design.followers}


def form_of(design: ArrayDesign) -> list[dict[str, Any]]:
    """The fields of a design as a form shows them, in the order of its file.

    Frozen places and what they are fitted to are left out: the panel of the body has them.

    Args:
        design: the design, whose lines, kinds and materials have fields each of their own.

    Returns:
        For every value a table: ``name`` (dotted, as :meth:`geometry.ArrayDesign.with_values` takes it), ``group``
        (what the field belongs to), ``label``, ``kind`` ("number", "count", "text", "flag" or "list"), ``unit``,
        ``allowed`` (in words), ``lowest`` and ``highest`` (None where there is none), ``choices``, ``suggestions``,
        ``optional``, ``description`` and ``value``.
    """
    fields = field_values(design).items()
    return [_entry(name, value, design) for name, value in fields if not name.startswith(_FITTED)]


def sizes_sold(design: ArrayDesign) -> dict[str, list[float]]:
    """Sizes that can be bought of each field of a form that is a size of a bought part, ascending, in its unit."""
    sold = catalogue()
    values = field_values(design)
    names = (name for name, value in values.items() if isinstance(value, float) and sold.has_sizes(name))
    return {name: [float(size) for size in sold.sizes(name, design)] for name in names}


def addable_tables(design: ArrayDesign) -> dict[str, dict[str, Any]]:
    """Tables that a design does not state and may: with them it has the same parts as without.

    Returns:
        By dotted name what a table would state: a tube, or a pattern of kinds, for each line without one of its own,
        a further kind of points or of tubes, and a material of one's own.
    """
    found: dict[str, dict[str, Any]] = {}
    for number, line in enumerate(design.lines):
        if line.tube is None and (line.pattern is None or line.pattern.tubes is None):
            found[f"lines.{number}.tube"] = _plain(design.tube)
        if line.microphone_tube is None:
            found[f"lines.{number}.microphone_tube"] = _plain(design.microphone_tube)
        if line.pattern is None and design.point_kinds:
            found[f"lines.{number}.pattern"] = {"points": [next(iter(design.point_kinds))] * line.points}
    own = {
        "cavity_height": design.resonator.cavity_height,
        "membrane_thickness": design.membrane.thickness,
        "leak_diameter": design.resonator.leak_diameter,
    }
    found[f"point_kinds.{_unused('kind', design.point_kinds)}"] = own
    found[f"tube_kinds.{_unused('tube', design.tube_kinds)}"] = _plain(design.tube)
    found[f"materials.{_unused('material', design.materials)}"] = _plain(design.material(design.membrane.material))
    return found


def removable_tables(design: ArrayDesign) -> list[str]:
    """Dotted names of tables without which a line is as all lines are."""
    tables = ("tube", "microphone_tube", "pattern")
    return [f"lines.{k}.{each}" for k, line in enumerate(design.lines) for each in tables if getattr(line, each)]


def _plain(section: BaseModel) -> dict[str, Any]:
    values: dict[str, Any] = as_lists(section.model_dump(mode="json"))
    return values


def _unused(stem: str, known: Mapping[str, Any]) -> str:
    return next(name for name in (f"{stem}_{k}" for k in range(1, len(known) + 2)) if name not in known)


def _entry(name: str, value: Any, design: ArrayDesign) -> dict[str, Any]:
    field = declared_at(name)
    group, _, last = name.rpartition(".")
    kinds = {"a number": "number", "a whole number": "count", "true or false": "flag", "a list": "list"}
    low, high = (bound if math.isfinite(bound) else None for bound in field.range)
    return {
        "name": name,
        "group": group,
        "label": last.replace("_", " "),
        "kind": kinds.get(field.kind, "text"),
        "unit": field.unit,
        "allowed": field.allowed,
        "lowest": low,
        "highest": high,
        "choices": list(field.choices),
        "suggestions": _suggestions(last, design),
        "optional": field.optional,
        "description": field.description,
        "value": value,
    }


def _suggestions(last: str, design: ArrayDesign) -> list[str]:
    """Names that a text may be, where the package knows them."""
    return sorted({**MATERIALS, **design.materials}) if last.endswith(_MATERIAL) else []
