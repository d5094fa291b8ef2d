"""What one array costs in money and hours: kits of several designs, as ``acoustic-fem parts`` counts them.

``python -m benchmarks.cost --write`` writes the table of docs/cost.md, in some minutes of one core. Prices are those of
the catalogue, most of them assumed; spares and minutes are assumed.
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

import geometry
from geometry.assembly.model import array_model
from geometry.formats.part_files import tessellate_distinct
from geometry.ground.whole_files import replace_section
from geometry.printing.plates import export_plates
from geometry.schema.print_processes import process_of
from studies.kit.kit_files import order_of
from studies.kit.ordering import printed_spares

DOCS = Path(__file__).parents[1] / "docs"
BEGIN, END = "<!-- costs: made by benchmarks/cost.py -->", "<!-- end of the costs -->"
DESIGNS = ("array-2x6", "glove", "large-area-64", "line-2", "fingertip-4x6", "wristband-16")
HEAD = (
    "| design | points | parts of one array (USD) | with spares (USD) | molds (USD) | consumables (USD) | "
    "tools (USD) | all, in whole packs (USD) | hours of work | hours of waiting |"
)


def row(name: str) -> str:
    """Row of one design."""
    example = DOCS / "examples" / f"{name}.toml"
    design = geometry.load_design(example) if example.exists() else geometry.prototype(name)
    process, model = process_of(design.printing), array_model(design)
    shapes = tessellate_distinct(model.parts)
    with tempfile.TemporaryDirectory() as folder:
        plates = export_plates(model.parts, folder, process, shapes, printed_spares(model.parts))
    order = order_of(model, len(plates.plates), process)
    split = [order.cost(purpose) for purpose in ("array", "molds", "consumable", "tool")]
    money = " | ".join(
        f"{each:.1f}" if each < 10 else f"{each:.0f}" for each in (order.bill.cost, *split, order.cost_of_packs)
    )
    return f"| {name} | {design.point_count} | {money} | {order.hours:.0f} | {order.waiting:.0f} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("designs", nargs="*", default=DESIGNS, help="names of prototypes or examples")
    parser.add_argument("--write", action="store_true", help="write the table of docs/cost.md")
    asked = parser.parse_args()
    lines = [HEAD, "|---|" + "---:|" * 9]
    for name in asked.designs:
        lines.append(row(name))
        print(lines[-1], flush=True)
    if asked.write:
        replace_section(DOCS / "cost.md", BEGIN, END, lines)


if __name__ == "__main__":
    main()
