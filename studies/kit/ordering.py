"""Order list of a kit: every line of the bill with spares, and electronics, tools and consumables beside the bill."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from typing import Literal

from geometry.assembly.bill import Bill, BillItem
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_range
from geometry.schema.print_processes import PrintProcess
from geometry.stock import Resin, StockMicrophone, StockPart, catalogue
from studies.kit.logger_levels import expected_levels
from studies.kit.work_hours import COUNTED, Work

#: What a line of the list is for.
Purpose = Literal["array", "molds", "electronics", "consumable", "tool"]
_WITHOUT_ELECTRONICS: tuple[Purpose, ...] = ("array", "molds", "consumable", "tool")
#: Smallest packs that shops sell, in the unit of the part; assumed. Printing services sell by the ml.
PACKS = {"resin": 1000.0, "silicone": 900.0, "glue": 20.0, "spring": 1.0, "sleeve": 1.0, "tubing": 1.0}
#: Processes whose material is a service's, so that nobody buys a pack of it.
SERVICES = ("dlp-fine", "mjf")
#: Consumables by their name in the catalogue; resins need isopropanol too.
CONSUMABLES = (
    *("nitrile-gloves", "release-agent", "mixing-cups", "syringe", "modelling-clay", "hose", "tee", "paper-wipes"),
)
#: Consumables of a process that prints with resin.
OF_RESIN = ("isopropanol",)
#: Tools by their name in the catalogue.
TOOLS = ("tweezers", "scalpel", "side-cutter", "caliper", "scale", "loupe", "soldering-iron")
#: Electronics of each microphone by their name in the catalogue, and in addition those of an analog one.
OF_MICROPHONE, OF_ANALOG = ("decoupling-capacitor", "connector", "cable"), ("coupling-capacitor",)
#: Tools for heat-shrink sleeves, and for resin.
OF_SLEEVES, OF_RESIN_TOOLS = ("heat-gun",), ("cure-lamp", "wash-pot")


@dataclass(frozen=True)
class Spares:
    """Fractions of pieces that are ordered or made in addition; every value is an assumption to be replaced."""

    made: float = 0.1
    """Spare printed and cast pieces per piece, at least one of each."""
    tube: float = 0.15
    """Spare length of spring and sheath per length."""
    bought: float = 0.25
    """Spare microphones, boards and gaskets per piece, at least one of each."""
    glue: float = 0.5
    """Spare glue per glue, for what stays in the nozzle."""

    def __post_init__(self) -> None:
        """Reject a fraction that is not a number of at least 0.

        Raises:
            Refusal: a value is negative or not finite.
        """
        for each in fields(self):
            check_range(f"spares.{each.name}", getattr(self, each.name), 0, math.inf, excluded="high")


@dataclass(frozen=True)
class OrderLine:
    """One line of the order list."""

    purpose: Purpose
    """Use of the item."""
    item: str
    """Name of the item."""
    needed: float
    """Quantity that the array takes, waste included, in ``unit``."""
    spare: float
    """Quantity in addition, in ``unit``."""
    unit: str
    """Unit of the quantities."""
    part: StockPart | None
    """Part of the catalogue; None if the catalogue has no such kind."""
    bought_as: str
    """Name of that part, or that it is made to order."""
    note: str = ""
    """A remark for people."""

    @property
    def ordered(self) -> float:
        """Quantity to order, spares included."""
        return self.needed + self.spare

    @property
    def cost(self) -> float:
        """Cost with spares, in the currency of the bill."""
        return 0.0 if self.part is None else self.ordered * self.part.price

    @property
    def amount(self) -> str:
        """Quantity to order in words."""
        return _words(self.ordered, self.unit)


@dataclass(frozen=True)
class OrderList:
    """Everything that one array takes, with spares, prices and hours."""

    bill: Bill
    """Bill of materials, without spares."""
    lines: tuple[OrderLine, ...]
    """All lines: array, molds, electronics, consumables, tools."""
    work: tuple[Work, ...]
    """Work that the array takes."""
    spares: Spares
    """Fractions of spares."""

    def cost(self, *purposes: Purpose) -> float:
        """Cost of the lines of some purposes, by default of all but the electronics.

        Electronics are counted apart, because a laboratory has a data logger that costs more than the sensor.
        """
        return math.fsum(line.cost for line in self.lines if line.purpose in (purposes or _WITHOUT_ELECTRONICS))

    @property
    def cost_of_packs(self) -> float:
        """Cost of all lines but electronics if everything that the packs of :data:`PACKS` hold is bought whole."""
        amounts: dict[StockPart, float] = {}
        for line in self.lines:
            if line.part is not None and line.purpose in _WITHOUT_ELECTRONICS:
                amounts[line.part] = amounts.get(line.part, 0.0) + line.ordered
        return math.fsum(_packed(part, amount) * part.price for part, amount in amounts.items())

    @property
    def hours(self) -> float:
        """Hours of work."""
        return math.fsum(work.hours for work in self.work)

    @property
    def waiting(self) -> float:
        """Hours of waiting."""
        return math.fsum(work.waits for work in self.work)

    def to_csv(self) -> str:
        """The list as CSV: one line per item, with a header."""
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        price = f"unit price ({self.bill.currency})"
        sold_as = ("bought as", "maker", "part number", "source", "note")
        table.writerow(["for", "item", "needed", "spare", "order", "unit", price, "cost", *sold_as])
        for line in self.lines:
            part = line.part
            sold = ("", "", "") if part is None else (part.maker, part.part_number, part.source)
            quantities = [f"{value:.4g}" for value in (line.needed, line.spare, line.ordered)]
            price = f"{0.0 if part is None else part.price:g}"
            cost = f"{line.cost:.2f}"
            bought = [line.bought_as, *sold, line.note]
            table.writerow([line.purpose, line.item, *quantities, line.unit, price, cost, *bought])
        return text.getvalue()

    def work_csv(self) -> str:
        """The work as CSV: one line per kind of work, with a header."""
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        table.writerow(["job", "work", "pieces", "minutes a piece", "hours of work", "hours of waiting", "counted"])
        for each in self.work:
            row = [each.job, each.name, each.pieces, f"{each.minutes:g}", f"{each.hours:.2f}", f"{each.waits:g}"]
            table.writerow([*row, COUNTED])
        return text.getvalue()


def order_list(
    design: ArrayDesign, bill: Bill, work: Sequence[Work], process: PrintProcess, spares: Spares | None = None
) -> OrderList:
    """Order list of one array.

    Args:
        design: the array.
        bill: its bill of materials.
        work: of :func:`studies.kit.work_hours.work_of`.
        process: printing process.
        spares: fractions of spares in place of the assumed ones.
    """
    spares, sold = spares or Spares(), catalogue()
    resin = process.name in ("sla-resin", "dlp-fine")
    sleeved = any(item.part is not None and item.part.kind == "sleeve" for item in bill.items)
    lines = [_line(item, spares) for item in bill.items]
    extras: list[tuple[Purpose, str]] = [("consumable", role) for role in (OF_RESIN if resin else ()) + CONSUMABLES]
    extras += [("tool", role) for role in (OF_RESIN_TOOLS if resin else ()) + (OF_SLEEVES if sleeved else ()) + TOOLS]
    for purpose, role in extras:
        part = sold.sundry(role).part
        note = "not in the catalogue" if part is None else part.note
        lines.append(OrderLine(purpose, role.replace("-", " "), 1, 0, "piece", part, role.replace("-", " "), note))
    lines += _electronics(design, spares)
    order: dict[Purpose, int] = {"array": 0, "molds": 1, "electronics": 2, "consumable": 3, "tool": 4}
    return OrderList(bill, tuple(sorted(lines, key=lambda line: order[line.purpose])), tuple(work), spares)


def _electronics(design: ArrayDesign, spares: Spares) -> Iterator[OrderLine]:
    """Parts that are soldered to the microphones, and data loggers, of which one is ordered."""
    sold, count = catalogue(), len(design.microphones)
    logger = expected_levels(design).loggers
    first = logger[0].logger if logger else None
    part = sold.microphone(design.microphone.model)
    digital = isinstance(part, StockMicrophone) and part.output != "analog"
    roles = OF_MICROPHONE if digital else (*OF_MICROPHONE, *OF_ANALOG)
    if first is not None and first.coupling == "DC":
        roles = (*roles, "input-resistor")
    for role in roles:
        yield _sundry(role, count, float(max(1, math.ceil(spares.bought * count))))
    yield _sundry("controller" if digital else "battery-holder", 1, 0)
    for number, each in enumerate(levels.logger for levels in logger):
        if each is not None:
            instead = f"in place of {first.name}; {each.note}" if number and first is not None else each.note
            yield OrderLine("electronics", "data logger", 0 if number else 1, 0, "piece", each, each.name, instead)


def _sundry(role: str, count: int, spare: float) -> OrderLine:
    part = catalogue().sundry(role).part
    note, name = "not in the catalogue" if part is None else part.note, role.replace("-", " ")
    return OrderLine("electronics", name, count, spare, "piece", part, name, note)


def _line(item: BillItem, spares: Spares) -> OrderLine:
    """A line of the bill with its spares; a mold is made once."""
    if item.use == "tooling":
        spare = 0.0
    elif item.use in ("printed", "cast"):
        piece = item.quantity / item.count if item.count else 0.0
        spare = piece * max(1, math.ceil(spares.made * item.count)) if item.count else 0.0
    elif item.unit == "piece":
        spare = float(max(1, math.ceil(spares.bought * item.quantity)))
    else:
        spare = (spares.tube if item.unit == "m" else spares.glue) * item.quantity
    purpose: Purpose = "molds" if item.use == "tooling" else "array"
    return OrderLine(purpose, item.item, item.quantity, spare, item.unit, item.part, item.bought_as, item.note)


def _packed(part: StockPart, amount: float) -> float:
    """Amount of whole packs that hold an amount."""
    pack = PACKS.get(part.kind, 0.0)
    if not pack or (isinstance(part, Resin) and set(part.processes) <= set(SERVICES)):
        return amount
    return math.ceil(amount / pack) * pack


def _words(quantity: float, unit: str) -> str:
    return f"{quantity:.0f} pcs" if unit == "piece" else f"{quantity:.3g} {unit}"
