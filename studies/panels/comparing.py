"""Two designs side by side: the fields in which they differ."""

from __future__ import annotations

from typing import Any

from geometry.design.array_design import ArrayDesign
from studies.panels.form import flat_values, form_of


def comparison(design: ArrayDesign, other: ArrayDesign) -> list[dict[str, Any]]:
    """Fields that two designs do not have alike, in the order of the form.

    Args:
        design: one design.
        other: another.

    Returns:
        For each field its ``name``, ``unit``, and the value ``here`` and ``there``; None where there is none.
    """
    units = {entry["name"]: entry["unit"] for each in (other, design) for entry in form_of(each)}
    here, there = flat_values(design), flat_values(other)
    names = [*here, *(name for name in there if name not in here)]
    return [
        {"name": name, "unit": units[name], "here": here.get(name), "there": there.get(name)}
        for name in names
        if here.get(name) != there.get(name)
    ]
