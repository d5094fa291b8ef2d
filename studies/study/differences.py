"""In what two studies differ, in words."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any


def first_difference(stored: Mapping[str, Any], wanted: Mapping[str, Any]) -> str:
    """In words, the first field in which two studies differ; empty where they do not."""
    wanted = json.loads(json.dumps(wanted))
    stored = json.loads(json.dumps(stored))
    for name in wanted:
        if stored.get(name) != wanted[name]:
            if name == "base":
                return "its base design is not the same"
            if name == "frequency":
                ends = [f"{grid[0]:g}:{grid[-1]:g}:{len(grid)}" for grid in (stored[name], wanted[name])]
                return f"its frequencies are {ends[0]}, not {ends[1]}"
            if name == "vary":
                return _parameter_difference(stored[name], wanted[name])
            return f"it has {name} = {stored.get(name)!r}, not {wanted[name]!r}"
    return ""


def other_table(stored: str, installed: str) -> str:
    """In words, that cells are of another table of the atlas than is installed; empty where they are not.

    Args:
        stored: digest of their table, empty where none was noted.
        installed: digest of the installed one, empty at other fidelities.
    """
    if not installed or stored == installed:
        return ""
    table = f"table {stored}" if stored else "a table without a digest"
    return f"its cells are of {table} of the atlas, not of {installed}, which is installed"


def _parameter_difference(stored: list[Any], wanted: list[Any]) -> str:
    old, new = ({each["name"]: each for axis in axes for each in axis} for axes in (stored, wanted))
    for name in [*new, *old]:
        if name not in old:
            return f"it does not vary {name}"
        if name not in new:
            return f"it varies {name}"
        if json.dumps(old[name]) != json.dumps(new[name]):
            return f"its values of {name} are not the same"
    return "its parameters are grouped or ordered otherwise"
