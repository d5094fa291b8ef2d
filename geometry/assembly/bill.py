"""The bill of materials: what one array takes of everything, and what that costs.

Volumes are those of the solids, lengths those of the cutting list. Prices are data: replace them with your own.
"""

from __future__ import annotations

import csv
import io
import json
import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal, get_args

from geometry.assembly.part_list import PartSet, build_parts
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range
from geometry.ground.whole_files import made_folder, write_text
from geometry.layout.cutting import Cut, cutting_list
from geometry.layout.placement import ArrayLayout
from geometry.molds.mold import MoldKind
from geometry.schema.part_fields import BOARD_SEAL

if TYPE_CHECKING:
    import cadquery as cq

Use = Literal["printed", "cast", "bought", "tooling"]


@dataclass(frozen=True)
class Prices:
    """Prices of materials and fractions of them that are lost; every value is an assumption to be replaced."""

    currency: str = "USD"
    """Currency of all prices."""
    resin: float = 0.06
    """Price of photopolymer, in your currency, per ml."""
    silicone: float = 0.04
    """Price of silicone, both parts mixed, in your currency, per ml."""
    spring: float = 3.0
    """Price of close-wound coil spring, per metre."""
    sheath: float = 0.5
    """Price of heat-shrink or catheter tube, per metre."""
    microphone: float = 1.5
    """Price of a MEMS microphone, in your currency."""
    board: float = 0.3
    """Price of the board that carries a microphone, in your currency."""
    gasket: float = 0.05
    """Price of the gasket under a board, in your currency."""
    glue: float = 0.01
    """Price of the glue of one joint: of a tube, a membrane or a board."""
    resin_factor: float = field(default=1.3, metadata={"least": 1.0})
    """Resin used per resin in the parts, a ratio, for supports and what stays in the tank."""
    silicone_factor: float = field(default=2.0, metadata={"least": 1.0})
    """Silicone mixed per silicone in the membranes, a ratio, for the overflow and the cup."""
    cutting_loss: float = 0.5
    """Length of spring and sheath lost per cut, mm."""
    source: str = "assumed: orders of magnitude of small retail quantities in 2025, no quotation"
    """Source of the values."""

    def __post_init__(self) -> None:
        """Reject prices that are not positive numbers.

        Raises:
            Refusal: a value is negative or not finite, or a factor below 1.
        """
        for each in fields(self):
            value, least = getattr(self, each.name), each.metadata.get("least", 0.0)
            if isinstance(value, (int, float)):
                check_range(f"prices.{each.name}", value, least, math.inf, excluded="high")


@dataclass(frozen=True)
class BillItem:
    """One line of the bill."""

    item: str
    """Name of the material or part."""
    use: Use
    """How it comes into the array, or that it is a tool."""
    count: int
    """Number of pieces."""
    quantity: float
    """Quantity of all pieces together, with what is lost, in ``unit``."""
    unit: Literal["ml", "m", "pieces"]
    """Unit of the quantity."""
    unit_price: float
    """Price per unit, in the currency of the bill."""
    note: str = ""
    """A remark for people."""

    @property
    def cost(self) -> float:
        """Cost of all pieces, in the currency of the bill."""
        return self.quantity * self.unit_price


@dataclass(frozen=True)
class Bill:
    """Bill of materials of one array; costs are in ``prices.currency``."""

    design: str
    """Name of the design."""
    items: tuple[BillItem, ...]
    """Every line of the bill."""
    prices: Prices
    """Prices that the costs follow from."""
    resin_ml: float
    """Resin in the parts that stay in the array, without supports, ml."""
    tooling_resin_ml: float
    """Resin in the molds, which serve many arrays, ml."""
    silicone_ml: float
    """Silicone in the membranes, ml."""
    tube_m: float
    """Length of sheath, cut to length, m; springs of bent tubes are a little shorter."""

    @property
    def cost(self) -> float:
        """Cost of the materials of one array, without its tools and without work."""
        return sum(item.cost for item in self.items if item.use != "tooling")

    @property
    def tooling_cost(self) -> float:
        """Cost of the molds."""
        return sum(item.cost for item in self.items if item.use == "tooling")

    def to_dict(self) -> dict[str, object]:
        """The bill as JSON knows it."""
        rows = [{**asdict(item), "cost": round(item.cost, 4)} for item in self.items]
        return {**asdict(replace(self, items=())), "items": rows, "cost": self.cost, "tooling_cost": self.tooling_cost}

    def to_csv(self) -> str:
        """The bill as CSV: one line per item, with a header."""
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        table.writerow(
            ["item", "use", "count", "quantity", "unit", f"unit price ({self.prices.currency})", "cost", "note"]
        )
        for item in self.items:
            row = [item.item, item.use, item.count, f"{item.quantity:.4g}", item.unit, f"{item.unit_price:g}"]
            table.writerow([*row, f"{item.cost:.2f}", item.note])
        return text.getvalue()

    def __str__(self) -> str:
        rows = [("item", "pieces", "quantity", "cost", "note")]
        rows += [
            (item.item, str(item.count), f"{item.quantity:.3g} {item.unit}", f"{item.cost:.2f}", item.note)
            for item in self.items
        ]
        widths = [max(len(row[k]) for row in rows) for k in range(4)]
        lines = []
        for *cells, note in rows:
            aligned = [f"{cell:>{width}}" for cell, width in zip(cells[1:], widths[1:], strict=True)]
            lines.append("  ".join([f"{cells[0]:<{widths[0]}}", *aligned, note]).rstrip())
        money = self.prices.currency
        return "\n".join(
            [
                f"Bill of materials of one {self.design}",
                "",
                *lines,
                "",
                f"array {self.cost:.2f} {money}, molds {self.tooling_cost:.2f} {money}; prices {self.prices.source}",
            ]
        )


def bill_of_materials(
    design: DesignLike, parts: PartSet | None = None, prices: Prices | None = None, layout: ArrayLayout | None = None
) -> Bill:
    """Resin, silicone, springs, sheaths, microphones, gaskets and glue that one array needs, with their cost.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        parts: parts from :func:`geometry.build_parts`, if you have them already.
        prices: prices in place of the assumed ones.
        layout: layout of the array, if you have it already.
    """
    design = resolve_design(design)
    parts = build_parts(design, layout) if parts is None else parts
    prices = prices or Prices()
    volumes = _millilitres(parts)
    made = [name for name in parts if parts.origin(name) != "bought" and parts.counts[name]]
    items = [_made(name, _use(parts, name), volumes[name], parts.counts[name], design, prices) for name in made]
    cuts = cutting_list(design, layout)
    items += _springs(cuts, prices) + _sheaths(cuts, prices)
    microphone, count = design.microphone, len(design.microphones)
    items.append(BillItem(microphone.model, "bought", count, count, "pieces", prices.microphone))
    items.append(BillItem("microphone-board", "bought", count, count, "pieces", prices.board))
    joints, note = 2 * sum(cut.count for cut in cuts) + design.point_count, "two per tube, one per membrane"
    if microphone.gasket_width is None:
        joints, note = joints + count, f"{note}, one per board"
    else:
        inside = microphone.chamber_diameter + 2 * BOARD_SEAL
        outside = inside + 2 * microphone.gasket_width
        sizes = f"ring of {inside:g} x {outside:g} mm, thicker than its groove of {microphone.gasket_depth:g} mm"
        items.append(BillItem("gasket", "bought", count, count, "pieces", prices.gasket, sizes))
    items.append(BillItem("glue joint", "bought", joints, joints, "pieces", prices.glue, note))
    used = {
        use: math.fsum(volumes[item.item] * item.count for item in items if item.use == use)
        for use in ("printed", "tooling", "cast")
    }
    length = math.fsum(cut.total_length for cut in cuts) / 1000
    return Bill(design.name, tuple(items), prices, used["printed"], used["tooling"], used["cast"], length)


def write_bill(bill: Bill, folder: str | os.PathLike[str]) -> tuple[Path, Path, Path]:
    """Write ``bill.csv``, ``bill.json`` and ``bill.txt``; existing files are replaced only by complete ones.

    Returns:
        The three paths.
    """
    folder = made_folder(folder)
    texts = {
        "bill.csv": bill.to_csv(),
        "bill.json": json.dumps(bill.to_dict(), indent=2) + "\n",
        "bill.txt": f"{bill}\n",
    }
    for name, text in texts.items():
        write_text(folder / name, text)
    table, record, page = (folder / name for name in texts)
    return table, record, page


def _millilitres(parts: Mapping[str, cq.Workplane]) -> dict[str, float]:
    return {name: part.val().Volume() / 1000 for name, part in parts.items()}


def _use(parts: PartSet, name: str) -> Use:
    """Use of a part; molds are tools."""
    return "tooling" if parts.kinds.get(name) in get_args(MoldKind) else parts.origin(name)


def _made(name: str, use: Use, volume: float, count: int, design: ArrayDesign, prices: Prices) -> BillItem:
    """A printed or cast part."""
    if use == "cast":
        quantity = volume * count * prices.silicone_factor
        return BillItem(name, "cast", count, quantity, "ml", prices.silicone, design.membrane.material)
    quantity = volume * count * prices.resin_factor
    return BillItem(name, use, count, quantity, "ml", prices.resin, design.printing.material)


def _springs(cuts: Sequence[Cut], prices: Prices) -> list[BillItem]:
    items = []
    for cut in cuts:
        title = f"spring {cut.tube.spring_outer_diameter:g} mm, wire {cut.tube.wire_diameter:g} mm"
        words = f"cut to {cut.spring_length:g} mm, {cut.turns:.0f} turns, {cut.place}"
        items.append(_of_length(title, cut.count, cut.spring_length + prices.cutting_loss, prices.spring, words))
    return items


def _sheaths(cuts: Sequence[Cut], prices: Prices) -> list[BillItem]:
    items = []
    for cut in cuts:
        title = f"sheath {cut.tube.outer_diameter:g} mm outside over the spring"
        words = f"cut to {cut.cut_length:g} mm, {cut.place}"
        items.append(_of_length(title, cut.count, cut.cut_length + prices.cutting_loss, prices.sheath, words))
    return items


def _of_length(title: str, count: int, length: float, price: float, words: str) -> BillItem:
    """Pieces of a length in mm, bought by the metre."""
    return BillItem(title, "bought", count, count * length / 1000, "m", price, words)
