"""Springs and sheaths in the words of their makers, because many sizes are no numbered part of any maker."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from geometry.assembly.bill import sheath_title, spring_title
from geometry.design.array_design import ArrayDesign
from geometry.ground.whole_files import write_text
from geometry.layout.cutting import Cut, cutting_list
from geometry.layout.placement import ArrayLayout
from geometry.schema.part_fields import Tube
from geometry.stock import Sheath, Sleeve, Spring, StockPart, Tubing, catalogue
from studies.kit.jobs import CUT
from studies.kit.ordering import OrderList

#: Name of the file that makers are sent.
TUBE_FILE = "order-tubes.txt"
#: What a rod must be longer than the longest piece, mm: it is held at one end while it is cut.
_HELD = 10.0
#: Steel of the wire; any stainless spring steel serves, because the spring only holds the bore open.
_STEEL = "stainless spring steel 1.4310 (AISI 302, EN 10270-3)"


@dataclass(frozen=True)
class TubeOrder:
    """One size of spring or sheath that an array takes."""

    tube: Tube
    """Tube that it is for."""
    longest: float
    """Longest piece that is cut of it, mm."""
    length: float
    """Length to order, with spares and cutting loss, m."""
    spare: float
    """Part of the length that is spare, m."""
    part: StockPart | None
    """Row of the catalogue; None if it has no such size."""

    @property
    def rod(self) -> float:
        """Shortest useful rod, mm, in whole 5 mm."""
        return 5.0 * math.ceil((self.longest + _HELD) / 5)

    @property
    def length_words(self) -> str:
        """Length to order, and how much of it is spare."""
        needed, spare = 1000 * (self.length - self.spare), 1000 * self.spare
        return f"{1000 * self.length:.0f} mm: {needed:.0f} mm for the array and {spare:.0f} mm spare"

    @property
    def is_numbered(self) -> bool:
        """True if a maker keeps it as a numbered part."""
        return self.part is not None and bool(self.part.maker)

    @property
    def row(self) -> str:
        """Row of the catalogue, with its source."""
        return "no row has this size" if self.part is None else f"{self.part.name}: {self.part.source}"


@dataclass(frozen=True)
class SpringOrder(TubeOrder):
    """One size of spring."""

    @property
    def turns(self) -> float:
        """Turns in a millimetre: they touch."""
        return 1 / self.tube.wire_diameter

    @property
    def size(self) -> str:
        """Sizes that a maker needs."""
        tube, wire = self.tube, self.tube.wire_diameter
        return (
            f"wire {wire:g} mm, {tube.spring_outer_diameter:g} mm outside, {tube.inner_diameter:g} mm inside, "
            f"pitch {wire:g} mm (turns touch, {self.turns:.3g} turns a mm)"
        )

    @property
    def source(self) -> str:
        """Words on who sells it."""
        if self.part is not None and self.is_numbered:
            return f"bought as {self.part.name}"
        return f"wound to order: send {TUBE_FILE} to makers of micro springs or of coils for guide wires"

    def rows(self) -> Iterator[tuple[str, str]]:
        """Rows of the page that a maker is sent."""
        tube, wire = self.tube, self.tube.wire_diameter
        tolerance = self.part.tolerance if isinstance(self.part, Spring) else Spring.model_fields["tolerance"].default
        yield "form", "close-wound coil without hooks, straight, turns touch, ends cut square"
        yield "wire", f"{wire:g} mm, {_STEEL}"
        yield "outside diameter", f"{tube.spring_outer_diameter:g} mm, plus or minus {tolerance:g} mm"
        yield "inside diameter", f"{tube.inner_diameter:g} mm"
        yield "pitch", f"{wire:g} mm, the diameter of the wire ({self.turns:.3g} turns a mm)"
        yield "hand of winding", "either"
        yield "length in all", self.length_words
        yield "delivered", f"by the metre, or in rods of at least {self.rod:g} mm; {CUT} has the pieces cut from it"
        yield "catalogue", self.row
        yield "check on arrival", f"{round(10 * self.turns)} turns on 10 mm under a loupe, and no gap between turns"
        passing = f"a straight wire a little thinner than {tube.inner_diameter:g} mm goes through"
        yield "", f"the caliper reads {tube.spring_outer_diameter:g} mm; {passing}"


@dataclass(frozen=True)
class SheathOrder(TubeOrder):
    """One size of sheath, or of tubing that is a tube of smooth bore."""

    nearest: StockPart | None
    """Row of the catalogue that comes nearest to its size; None if no row has its kind."""

    @property
    def fitting(self) -> str:
        """How it comes onto its spring."""
        tube, part = self.tube, self.nearest
        if tube.bore == "smooth":
            return f"The tubing of {tube.outer_diameter:g} mm has no spring: cut it to its final length."
        spring = f"the spring of {tube.spring_outer_diameter:g} mm"
        if isinstance(part, Sleeve):
            sizes = f"bore {part.supplied_diameter:g} mm as supplied and {part.recovered_diameter:g} mm shrunk freely"
            return (
                f"Slide the heat-shrink sleeve ({part.material or 'sleeve'}, {sizes}), which you have cut too long, "
                f"over {spring}. Shrink it at 90 to 120 \N{DEGREE SIGN}C from the middle outwards, turning it, until "
                f"it lies tight and is {tube.outer_diameter:g} mm outside. Then trim it on the template to the final "
                "length of its row."
            )
        name = "The tubing" if part is None else part.name
        return f"{name} does not shrink: slide {spring} into it until both ends are flush."

    @property
    def words(self) -> str:
        """Part, size, length and who sells it."""
        name = "tubing" if self.part is None else self.part.name
        size = f"{name}, {self.tube.outer_diameter:g} mm outside in the array, {self.length_words}"
        return size if self.is_numbered else f"{size}; no numbered part of a maker: send {TUBE_FILE}"

    def rows(self) -> Iterator[tuple[str, str]]:
        """Rows of the page that a maker is sent."""
        tube, part = self.tube, self.part
        within = tube.inner_diameter if tube.bore == "smooth" else tube.spring_outer_diameter
        forms = {"sleeve": "heat-shrink sleeve", "tubing": "tubing of plain wall, which does not shrink"}
        yield "form", forms.get("" if part is None else part.kind, "tubing of plain wall, or heat-shrink sleeve")
        if isinstance(part, Sheath) and part.material:
            yield "material", part.material
        if isinstance(part, Sleeve):
            yield "as supplied", f"bore {part.supplied_diameter:g} mm"
            wall = f"wall {part.recovered_wall:g} mm, plus or minus {part.tolerance:g} mm"
            yield "shrunk freely", f"bore {part.recovered_diameter:g} mm, {wall}"
        elif isinstance(part, Tubing):
            yield "as supplied", f"bore {part.inner_diameter:g} mm, {part.outer_diameter:g} mm outside"
        inside = "bore" if tube.bore == "smooth" else "over a spring of"
        yield "in the array", f"{inside} {within:g} mm, {tube.outer_diameter:g} mm outside"
        yield "length in all", self.length_words
        yield "delivered", f"by the metre, or in pieces of at least {self.rod:g} mm; {CUT} has the pieces cut from it"
        yield "catalogue", self.row
        fits = "its bore is open" if tube.bore == "smooth" else "it slides over the spring"
        yield "check on arrival", f"{fits}, and a finished tube goes into the sockets of a printed shell"


def spring_orders(design: ArrayDesign, layout: ArrayLayout, order: OrderList) -> tuple[SpringOrder, ...]:
    """Sizes of springs that an array takes; none if all tubes are smooth.

    Args:
        design: the array.
        layout: where its parts lie.
        order: its order list, which has the lengths.
    """
    coiled = [(spring_title(cut.tube), cut) for cut in cutting_list(design, layout) if cut.tube.bore != "smooth"]
    sold, found = catalogue(), []
    for title, tube, longest in _sizes(coiled):
        row = sold.spring(tube)
        part = row.part if row is not None and row.exact else None
        found.append(SpringOrder(tube, longest, *_length(order, title), part))
    return tuple(found)


def sheath_orders(design: ArrayDesign, layout: ArrayLayout, order: OrderList) -> tuple[SheathOrder, ...]:
    """Sizes of sheaths and tubings that an array takes; arguments as for :func:`spring_orders`."""
    cuts = [(sheath_title(cut.tube), cut) for cut in cutting_list(design, layout)]
    sold, found = catalogue(), []
    for title, tube, longest in _sizes(cuts):
        row = sold.sheath(tube)
        found.append(SheathOrder(tube, longest, *_length(order, title), row.part if row.exact else None, row.part))
    return tuple(found)


def _sizes(cuts: Sequence[tuple[str, Cut]]) -> Iterator[tuple[str, Tube, float]]:
    """Each title once, with a tube of that size and its longest piece, mm."""
    for title in dict.fromkeys(title for title, _ in cuts):
        own = [cut for name, cut in cuts if name == title]
        yield title, own[0].tube, max(cut.cut_length for cut in own)


def _length(order: OrderList, title: str) -> tuple[float, float]:
    """Length that the order list has of an item, and the spare part of it, m."""
    lines = [line for line in order.lines if line.item == title]
    return math.fsum(line.ordered for line in lines), math.fsum(line.spare for line in lines)


def write_tube_order(springs: Sequence[SpringOrder], sheaths: Sequence[SheathOrder], folder: Path) -> None:
    """Write ``order-tubes.txt`` into a folder that exists; nothing if all are numbered parts of a maker."""
    lines = list(_lines(springs, sheaths))
    if lines:
        write_text(folder / TUBE_FILE, "\n".join(lines) + "\n")


def _lines(springs: Sequence[SpringOrder], sheaths: Sequence[SheathOrder]) -> Iterator[str]:
    wound, drawn = ([each for each in own if not each.is_numbered] for own in (springs, sheaths))
    if wound or drawn:
        yield "Springs and sheaths that are no numbered part of a maker we know, so this page names only kinds of"
        yield "makers. Send them this page, and ask for a price and a delivery time. None of them was asked yet."
    if wound:
        yield ""
        yield "Springs hold the bores of the tubes open and bear no load. Ask makers of micro springs, or of coils for"
        yield "guide wires."
    for number, each in enumerate(wound, start=1):
        yield from _table(f"Spring {number}", each.rows())
    if drawn:
        yield ""
        yield "Sheaths make the tubes tight. Ask makers of medical tubing and of thin heat-shrink sleeves."
    for number, other in enumerate(drawn, start=1):
        yield from _table(f"Sheath {number}", other.rows())


def _table(title: str, rows: Iterator[tuple[str, str]]) -> Iterator[str]:
    yield ""
    yield title
    for name, words in rows:
        yield f"  {name:17} {words}"
