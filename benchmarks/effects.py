"""What single effects change of H: ``python benchmarks/effects.py`` writes tables of docs/theory.md."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from rubber import HEAD, largest_changes, transfer_function

import geometry
from geometry import ArrayDesign
from geometry.files.writing import replace_section

PAGE = Path(__file__).parents[1] / "docs" / "theory.md"
END = "<!-- end {name} -->"
BEGIN = "<!-- {name}: made by benchmarks/effects.py -->"


def with_smooth_bores(design: ArrayDesign) -> ArrayDesign:
    """The design with round bores without grooves in all its tubes."""
    return design.with_values(dict.fromkeys(_bores(design), "smooth"))


def _bores(design: ArrayDesign) -> Iterator[str]:
    yield "tube.bore"
    if "microphone_tube" not in design.followers:
        yield "microphone_tube.bore"
    for index, line in enumerate(design.lines):
        yield from (f"lines.{index}.{name}.bore" for name in ("tube", "microphone_tube") if getattr(line, name))
    yield from (f"tube_kinds.{name}.bore" for name in design.tube_kinds)


def main() -> None:
    """Write the tables."""
    rows = []
    for name in geometry.prototype_names():
        design = geometry.prototype(name)
        now, before = transfer_function(design), transfer_function(with_smooth_bores(design))
        rows.append(f"| `{name}` | {largest_changes(now, before)} |")
    _replace("bores", "prototype, bore of its springs for a smooth one", rows)


def _replace(name: str, first: str, rows: list[str]) -> None:
    lines = [line.format(first) for line in HEAD]
    replace_section(PAGE, BEGIN.format(name=name), END.format(name=name), [*lines, *rows, ""])


if __name__ == "__main__":
    main()
