"""The bill of materials: what one array takes of everything, which part that is, and what it costs.

Volumes are those of the solids, lengths those of the cutting list. Parts and prices are those of the catalogue.
"""

from __future__ import annotations

import csv
import io
import json
import math
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, get_args

from geometry.assembly.part_list import PartSet, build_parts
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range
from geometry.ground.whole_files import made_folder, write_text
from geometry.layout.cutting import Cut, cutting_list
from geometry.layout.placement import ArrayLayout
from geometry.molds.mold import MoldKind
from geometry.schema.part_fields import BOARD_SEAL, Tube
from geometry.stock import Found, StockPart, StockParts, catalogue

if TYPE_CHECKING:
    import cadquery as cq

Use = Literal["printed", "cast", "bought", "tooling"]


@dataclass(frozen=True)
class Waste:
    """Fractions of materials that are lost; every value is an assumption to be replaced."""

    resin_factor: float = field(default=1.3, metadata={"least": 1.0})
    """Resin used per resin in the parts, a ratio, for supports and what stays in the tank."""
    silicone_factor: float = field(default=2.0, metadata={"least": 1.0})
    """Silicone mixed per silicone in the membranes, a ratio, for the overflow and the cup."""
    cutting_loss: float = 0.5
    """Length of spring and sheath lost per cut, mm."""

    def __post_init__(self) -> None:
        """Reject a loss that is not a positive number.

        Raises:
            Refusal: a value is negative or not finite, or a factor below 1.
        """
        for each in fields(self):
            least = each.metadata.get("least", 0.0)
            check_range(f"waste.{each.name}", getattr(self, each.name), least, math.inf, excluded="high")


@dataclass(frozen=True)
class BillItem:
    """One line of the bill."""

    item: str
    """Name of the material or part in the array."""
    use: Use
    """How it comes into the array, or that it is a tool."""
    count: int
    """Number of pieces."""
    quantity: float
    """Quantity of all pieces together, with what is lost, in ``unit``."""
    unit: Literal["ml", "m", "piece"]
    """Unit of the quantity."""
    part: StockPart | None
    """Part of the catalogue that it is bought as; None if the catalogue has no such kind."""
    to_order: bool = False
    """True if the catalogue lacks it: the part is then the nearest one, and the price is that part's."""
    note: str = ""
    """A remark for people."""

    @property
    def unit_price(self) -> float:
        """Price per unit, USD."""
        if self.part is None:
            return 0.0
        return self.part.price

    @property
    def cost(self) -> float:
        """Cost of all pieces, USD."""
        return self.quantity * self.unit_price

    @property
    def bought_as(self) -> str:
        """Name of its part; of one made to order also that it is only the nearest."""
        if self.part is None:
            return "not in the catalogue"
        return f"made to order; nearest: {self.part.name}" if self.to_order else self.part.name

    def to_dict(self) -> dict[str, Any]:
        """The line as JSON knows it, with maker, part number, price, its date and the sources."""
        known = ("maker", "part_number", "price_date", "price_source", "source")
        bought = {name: "" if self.part is None else getattr(self.part, name) for name in known}
        own = {each.name: getattr(self, each.name) for each in fields(self) if each.name != "part"}
        return {
            **own,
            "bought_as": self.bought_as,
            **bought,
            "unit_price": self.unit_price,
            "cost": round(self.cost, 4),
        }


@dataclass(frozen=True)
class Bill:
    """Bill of materials of one array; costs are in USD."""

    design: str
    """Name of the design."""
    items: tuple[BillItem, ...]
    """Every line of the bill."""
    waste: Waste
    """Losses that the quantities include."""
    resin_ml: float
    """Resin in the parts that stay in the array, without supports, ml."""
    tooling_resin_ml: float
    """Resin in the molds, which serve many arrays, ml."""
    silicone_ml: float
    """Silicone in the membranes, ml."""
    tube_m: float
    """Length of sheath, cut to length, m; springs of bent tubes are a little shorter."""
    currency: str = "USD"
    """Currency of all prices."""

    @property
    def cost(self) -> float:
        """Cost of the materials of one array, without its tools and without work."""
        return sum(item.cost for item in self.items if item.use != "tooling")

    @property
    def tooling_cost(self) -> float:
        """Cost of the molds."""
        return sum(item.cost for item in self.items if item.use == "tooling")

    @property
    def priced(self) -> str:
        """Dates and sources of the prices, in words."""
        parts = [item.part for item in self.items if item.part is not None]
        dates = sorted({part.price_date for part in parts})
        span = " to ".join(dict.fromkeys((dates[0], dates[-1]))) if dates else ""
        return f"prices of {span}, {', '.join(sorted({part.price_source for part in parts}))}"

    def to_dict(self) -> dict[str, object]:
        """The bill as JSON knows it."""
        rows = [item.to_dict() for item in self.items]
        return {**asdict(replace(self, items=())), "items": rows, "cost": self.cost, "tooling_cost": self.tooling_cost}

    def to_csv(self) -> str:
        """The bill as CSV: one line per item, with a header."""
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        sold = ("maker", "part_number", "price_date", "price_source", "source")
        table.writerow(
            ["item", "use", "count", "quantity", "unit", f"unit price ({self.currency})", "cost", "bought as"]
            + [name.replace("_", " ") for name in sold]
            + ["note"]
        )
        for item in self.items:
            row = [item.item, item.use, item.count, f"{item.quantity:.4g}", item.unit, f"{item.unit_price:g}"]
            plain = item.to_dict()
            table.writerow([*row, f"{item.cost:.2f}", item.bought_as, *(plain[name] for name in sold), item.note])
        return text.getvalue()

    def __str__(self) -> str:
        rows = [("item", "pieces", "quantity", "cost", "bought as", "note")]
        rows += [
            (
                *(item.item, str(item.count), f"{item.quantity:.3g} {item.unit}", f"{item.cost:.2f}"),
                *(item.bought_as, item.note),
            )
            for item in self.items
        ]
        widths = [max(len(row[k]) for row in rows) for k in range(5)]
        lines = []
        for name, *numbers, bought, note in rows:
            aligned = [f"{cell:>{width}}" for cell, width in zip(numbers, widths[1:4], strict=True)]
            lines.append("  ".join([f"{name:<{widths[0]}}", *aligned, f"{bought:<{widths[4]}}", note]).rstrip())
        total = f"array {self.cost:.2f} {self.currency}, molds {self.tooling_cost:.2f} {self.currency}"
        waste = self.waste
        lost = (
            f"Quantities include what is lost: resin x {waste.resin_factor:g}, silicone x {waste.silicone_factor:g}, "
            f"{waste.cutting_loss:g} mm a cut. Spares, packs, and the rest in a cup of silicone come on top."
        )
        return "\n".join([f"Bill of materials of one {self.design}", "", *lines, "", lost, f"{total}; {self.priced}"])


def bill_of_materials(
    design: DesignLike,
    parts: PartSet | None = None,
    layout: ArrayLayout | None = None,
    *,
    stock: StockParts | None = None,
    waste: Waste | None = None,
) -> Bill:
    """Resin, silicone, springs, sheaths, microphones, gaskets and glue that one array needs, with their cost.

    Each line names the part of the catalogue that it is bought as. If the catalogue lacks a part, its line says so and
    names the nearest part with its price.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        parts: parts from :func:`geometry.build_parts`, if you have them already.
        layout: layout of the array, if you have it already.
        stock: parts that can be bought, with their prices; by default :func:`geometry.stock.catalogue`.
        waste: losses in place of the assumed ones.
    """
    design = resolve_design(design)
    parts = build_parts(design, layout) if parts is None else parts
    sold, waste = stock or catalogue(), waste or Waste()
    volumes = _millilitres(parts)
    made = [name for name in parts if parts.origin(name) != "bought" and parts.counts[name]]
    items = [_made(name, _use(parts, name), volumes[name], parts.counts[name], design, sold, waste) for name in made]
    cuts = cutting_list(design, layout)
    items += _tubes(cuts, sold, waste)
    count = len(design.microphones)
    model = design.microphone.model
    items.append(_piece(model, count, sold.microphone_part(design.microphone)))
    items.append(_piece("microphone-board", count, sold.sundry("microphone-board")))
    items += _joints(design, cuts, sold)
    used = {
        use: math.fsum(volumes[item.item] * item.count for item in items if item.use == use)
        for use in ("printed", "tooling", "cast")
    }
    length = math.fsum(cut.total_length for cut in cuts) / 1000
    return Bill(design.name, tuple(items), waste, used["printed"], used["tooling"], used["cast"], length)


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


def _made(
    name: str, use: Use, volume: float, count: int, design: ArrayDesign, sold: StockParts, waste: Waste
) -> BillItem:
    """A printed or cast part."""
    if use == "cast":
        found, factor, material = sold.silicone(design), waste.silicone_factor, design.membrane.material
    else:
        found, factor, material = sold.resin(design), waste.resin_factor, design.printing.material
    return BillItem(name, use, count, volume * count * factor, "ml", found.part, not found.exact, material)


def spring_title(tube: Tube) -> str:
    """Name of the item that is the spring of a tube."""
    return f"spring {tube.spring_outer_diameter:g} mm, wire {tube.wire_diameter:g} mm"


def sheath_title(tube: Tube) -> str:
    """Name of the item that is the sheath of a tube, or the tubing that is one of smooth bore."""
    over = "" if tube.bore == "smooth" else " over the spring"
    return f"sheath {tube.outer_diameter:g} mm outside{over}"


def _tubes(cuts: Sequence[Cut], sold: StockParts, waste: Waste) -> Iterator[BillItem]:
    """Springs, then sheaths: pieces of a length, bought by the metre. A smooth bore is a tubing without a spring."""
    lost = waste.cutting_loss
    for cut in cuts:
        found = sold.spring(cut.tube)
        if found is not None:
            title = spring_title(cut.tube)
            words = f"cut to {cut.spring_length:g} mm, {cut.turns:.0f} turns, {cut.place}"
            yield _of_length(title, cut.count, cut.spring_length + lost, found, words)
    for cut in cuts:
        title = sheath_title(cut.tube)
        words = f"cut to {cut.cut_length:g} mm, {cut.place}"
        yield _of_length(title, cut.count, cut.cut_length + lost, sold.sheath(cut.tube), words)


def _joints(design: ArrayDesign, cuts: Sequence[Cut], sold: StockParts) -> Iterator[BillItem]:
    """Gaskets, and the glue of each kind of joint."""
    microphone, count = design.microphone, len(design.microphones)
    joints = {
        "tube": (2 * sum(cut.count for cut in cuts), "two per tube"),
        "membrane": (design.point_count, "one each"),
    }
    if microphone.gasket_width is None:
        joints["board"] = count, "one each"
    else:
        inside = microphone.chamber_diameter + 2 * BOARD_SEAL
        outside = inside + 2 * microphone.gasket_width
        sizes = f"ring of {inside:g} x {outside:g} mm, thicker than its groove of {microphone.gasket_depth:g} mm"
        yield replace(_piece("gasket", count, sold.sundry("gasket")), note=sizes)
    for joint, (number, note) in joints.items():
        glue = next(iter(sold.glues(joint)), None)
        volume = 0.0 if glue is None else number * glue.joint_volume
        yield BillItem(f"glue of {joint} joints", "bought", number, volume, "ml", glue, note=note)


def _piece(name: str, count: int, found: Found) -> BillItem:
    return BillItem(name, "bought", count, count, "piece", found.part, not found.exact)


def _of_length(title: str, count: int, length: float, found: Found, words: str) -> BillItem:
    """Pieces of a length in mm, bought by the metre."""
    return BillItem(title, "bought", count, count * length / 1000, "m", found.part, not found.exact, words)
