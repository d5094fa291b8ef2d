"""Springs in the words of a spring maker, because no maker was found that keeps them as numbered parts."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from geometry.assembly.bill import spring_title
from geometry.design.array_design import ArrayDesign
from geometry.ground.whole_files import write_text
from geometry.layout.cutting import cutting_list
from geometry.layout.placement import ArrayLayout
from geometry.schema.part_fields import Tube
from geometry.stock import Spring, catalogue
from studies.kit.jobs import CUT
from studies.kit.ordering import OrderList

#: Name of the file that a maker is sent.
SPRING_FILE = "order-spring.txt"
#: What a rod must be longer than the longest piece, mm: it is held at one end while it is cut.
_HELD = 10.0
#: Steel of the wire; any stainless spring steel serves, because the spring only holds the bore open.
_STEEL = "stainless spring steel 1.4310 (AISI 302, EN 10270-3)"


@dataclass(frozen=True)
class SpringOrder:
    """One size of spring that an array takes."""

    outer: float
    """Outside diameter, mm."""
    wire: float
    """Diameter of the wire, mm."""
    tolerance: float
    """Tolerance of the outside diameter, plus or minus, mm."""
    longest: float
    """Longest piece that is cut of it, mm."""
    length: float
    """Length to order, with spares and cutting loss, m."""
    part: Spring | None
    """Row of the catalogue; None if it has no such size."""

    @property
    def inner(self) -> float:
        """Inside diameter, which is the bore of the tube, mm."""
        return round(self.outer - 2 * self.wire, 6)

    @property
    def turns(self) -> float:
        """Turns in a millimetre: they touch."""
        return 1 / self.wire

    @property
    def rod(self) -> float:
        """Shortest useful rod, mm, in whole 5 mm."""
        return 5.0 * math.ceil((self.longest + _HELD) / 5)

    @property
    def size(self) -> str:
        """Sizes that a maker needs."""
        return (
            f"wire {self.wire:g} mm, {self.outer:g} mm outside, {self.inner:g} mm inside, pitch {self.wire:g} mm "
            f"(turns touch, {self.turns:.3g} turns a mm)"
        )

    @property
    def source(self) -> str:
        """Words on who sells it."""
        if self.part is not None and self.part.maker:
            return f"bought as {self.part.name}"
        return f"wound to order: send {SPRING_FILE} to makers of micro springs or of coils for guide wires"


def spring_orders(design: ArrayDesign, layout: ArrayLayout, order: OrderList) -> tuple[SpringOrder, ...]:
    """Sizes of springs that an array takes; none if all tubes are smooth.

    Args:
        design: the array.
        layout: where its parts lie.
        order: its order list, which has the lengths.
    """
    pieces: dict[str, tuple[Tube, float]] = {}
    for cut in cutting_list(design, layout):
        if cut.tube.bore != "smooth":
            title = spring_title(cut.tube)
            longest = max(cut.spring_length, pieces[title][1] if title in pieces else 0.0)
            pieces[title] = cut.tube, longest
    lengths = {line.item: line.ordered for line in order.lines if line.item in pieces}
    return tuple(_order(tube, longest, lengths[title]) for title, (tube, longest) in pieces.items())


def _order(tube: Tube, longest: float, length: float) -> SpringOrder:
    found = catalogue().spring(tube)
    known = found.part if found is not None and found.exact and isinstance(found.part, Spring) else None
    tolerance = Spring.model_fields["tolerance"].default if known is None else known.tolerance
    return SpringOrder(tube.spring_outer_diameter, tube.wire_diameter, tolerance, longest, length, known)


def write_spring_order(orders: Sequence[SpringOrder], folder: Path) -> None:
    """Write ``order-spring.txt`` into a folder that exists; nothing if no tube has a spring."""
    if orders:
        write_text(folder / SPRING_FILE, "\n".join(_lines(orders)) + "\n")


def _lines(orders: Sequence[SpringOrder]) -> Iterator[str]:
    yield "Springs to order"
    yield ""
    yield "The springs hold the bores of the tubes open. They bear no load."
    if any(each.part is None or not each.part.maker for each in orders):
        yield "No maker was found that keeps these sizes as numbered parts. Send this page to makers of micro springs"
        yield "or of coils for guide wires, and ask for a price and a delivery time. None of them was asked yet."
    for number, each in enumerate(orders, start=1):
        yield ""
        yield f"Spring {number}"
        for name, words in _rows(each):
            yield f"  {name:17} {words}"


def _rows(order: SpringOrder) -> Iterator[tuple[str, str]]:
    part = order.part
    yield "form", "close-wound coil without hooks, straight, turns touch, ends cut square"
    yield "wire", f"{order.wire:g} mm, {_STEEL}"
    yield "outside diameter", f"{order.outer:g} mm, plus or minus {order.tolerance:g} mm"
    yield "inside diameter", f"{order.inner:g} mm"
    yield "pitch", f"{order.wire:g} mm, the diameter of the wire ({order.turns:.3g} turns a mm)"
    yield "hand of winding", "either"
    yield "length in all", f"{1000 * order.length:.0f} mm, spares included"
    yield (
        "delivered",
        f"by the metre, or in rods of at least {order.rod:g} mm; {CUT} has the pieces that are cut from it",
    )
    yield "catalogue", "no row has this size" if part is None else f"{part.name}: {part.source}"
    yield "check on arrival", f"{round(10 * order.turns)} turns on 10 mm under a loupe, and no gap between turns"
    yield (
        "",
        f"the caliper reads {order.outer:g} mm; a straight wire a little thinner than {order.inner:g} mm goes through",
    )
