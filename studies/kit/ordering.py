"""Order list of a kit: every line of the bill with spares, and electronics, tools and consumables beside the bill."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, replace
from typing import Literal, get_args

from geometry.assembly.bill import Bill, BillItem, Waste
from geometry.assembly.part_list import PartSet
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_range
from geometry.molds.mold import MoldKind
from geometry.schema.print_processes import PrintProcess
from geometry.stock import Resin, Sheath, Sleeve, Spring, StockMicrophone, StockPart, catalogue
from studies.kit.build_facts import Cast, glue_of
from studies.kit.cutting_template import SPARE_PIECES, rough_length
from studies.kit.logger_levels import expected_levels
from studies.kit.microphone_wiring import coupling_capacitor
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
    *("nitrile-gloves", "release-agent", "mixing-cups", "syringe", "blunt-needle", "modelling-clay", "hose", "tee"),
    *("paper-wipes", "solder-paste", "tape"),
)
#: Pieces of a consumable where one does not do: a syringe each for silicone, for the glue of membranes, for the gauge.
PIECES = {"syringe": 3}
#: Consumables of a process that prints with resin.
OF_RESIN = ("isopropanol",)
#: Tools by their name in the catalogue.
TOOLS = (
    *("safety-glasses", "tweezers", "scalpel", "side-cutter", "caliper", "scale", "loupe", "soldering-iron"),
    *("hot-air", "multimeter", "clearing-wire", "flat-blade", "rod"),
)
#: Electronics of each microphone by their name in the catalogue, and in addition those of an analog one.
OF_MICROPHONE, OF_ANALOG = ("decoupling-capacitor", "connector", "cable"), ("coupling-capacitor",)
#: Tools for heat-shrink sleeves, and for resin.
OF_SLEEVES, OF_RESIN_TOOLS = ("heat-gun",), ("cure-lamp", "wash-pot")
#: Materials of sheaths that cyanoacrylate does not hold without a primer, and the primer by its name in the catalogue.
UNGLUED, OF_UNGLUED = ("polyethylene", "polyolefin", "PTFE"), ("primer",)


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
class Pack:
    """Amount of one part as it is bought."""

    part: StockPart
    """The part."""
    needed: float
    """Amount that the order list has of it, in its unit."""
    bought: float
    """Amount of whole packs that hold this, in its unit."""

    @property
    def cost(self) -> float:
        """Cost of the packs."""
        return self.bought * self.part.price


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
        return math.fsum(pack.cost for pack in self.packs)

    @property
    def packs(self) -> tuple[Pack, ...]:
        """Every part but electronics as it is bought: in whole packs where :data:`PACKS` has one."""
        amounts: dict[StockPart, float] = {}
        for line in self.lines:
            if line.part is not None and line.purpose in _WITHOUT_ELECTRONICS:
                amounts[line.part] = amounts.get(line.part, 0.0) + line.ordered
        return tuple(Pack(part, amount, _packed(part, amount)) for part, amount in amounts.items() if amount)

    @property
    def cost_of_everything(self) -> float:
        """Cost of whole packs and electronics together."""
        return self.cost_of_packs + self.cost("electronics")

    def costs_csv(self) -> str:
        """Costs as CSV: whole packs of each part, then the electronics, and sums that are those of the rows above."""
        text = io.StringIO()
        table = csv.writer(text, lineterminator="\n")
        table.writerow(["what", "needed", "bought", "unit", f"unit price ({self.bill.currency})", "cost"])
        for pack in self.packs:
            amounts = (f"{pack.needed:.4g}", f"{pack.bought:.4g}")
            table.writerow([pack.part.name, *amounts, pack.part.unit, f"{pack.part.price:g}", f"{pack.cost:.2f}"])
        table.writerow(["sum of whole packs", "", "", "", "", f"{self.cost_of_packs:.2f}"])
        for line in self.lines:
            if line.purpose == "electronics" and line.part is not None and line.ordered:
                amounts = (f"{line.needed:.4g}", f"{line.ordered:.4g}")
                table.writerow([line.item, *amounts, line.unit, f"{line.part.price:g}", f"{line.cost:.2f}"])
        table.writerow(["sum of electronics", "", "", "", "", f"{self.cost('electronics'):.2f}"])
        table.writerow(["everything", "", "", "", "", f"{self.cost_of_everything:.2f}"])
        return text.getvalue()

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
    design: ArrayDesign,
    bill: Bill,
    work: Sequence[Work],
    process: PrintProcess,
    casts: Sequence[Cast],
    spares: Spares | None = None,
) -> OrderList:
    """Order list of one array.

    Args:
        design: the array.
        bill: its bill of materials.
        work: of :func:`studies.kit.work_hours.work_of`.
        process: printing process.
        casts: casts of the membranes, whose cups hold more than the membranes.
        spares: fractions of spares in place of the assumed ones.
    """
    spares, sold = spares or Spares(), catalogue()
    resin = process.name in ("sla-resin", "dlp-fine")
    sleeved = any(item.part is not None and item.part.kind == "sleeve" for item in bill.items)
    cups = {cast.membrane: cast for cast in casts}
    lines = _joined([_line(item, spares, cups.get(item.item)) for item in bill.items])
    consumables = (OF_RESIN if resin else ()) + (OF_UNGLUED if _needs_primer(bill) else ()) + CONSUMABLES
    extras: list[tuple[Purpose, str]] = [("consumable", role) for role in consumables]
    extras += [("tool", role) for role in (OF_RESIN_TOOLS if resin else ()) + (OF_SLEEVES if sleeved else ()) + TOOLS]
    for purpose, role in extras:
        part = sold.sundry(role).part
        note = "not in the catalogue" if part is None else part.note
        name = role.replace("-", " ")
        lines.append(OrderLine(purpose, name, PIECES.get(role, 1), 0, "piece", part, name, note))
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
    values = (
        {}
        if first is None
        else {
            "coupling-capacitor": f"{coupling_capacitor(first):g} uF, ",
            "input-resistor": f"{first.input_resistance / 1e3:g} kOhm, ",
        }
    )
    for role in roles:
        line = _sundry(role, count, float(spare_pieces(count, spares.bought)))
        yield replace(line, note=values.get(role, "") + line.note)
    yield _sundry("controller" if digital else "battery-holder", 1, 0)
    for number, each in enumerate(levels.logger for levels in logger):
        if each is not None:
            instead = f"in place of {first.name}; {each.note}" if number and first is not None else each.note
            yield OrderLine("electronics", "data logger", 0 if number else 1, 0, "piece", each, each.name, instead)


def _sundry(role: str, count: int, spare: float) -> OrderLine:
    part = catalogue().sundry(role).part
    note, name = "not in the catalogue" if part is None else part.note, role.replace("-", " ")
    return OrderLine("electronics", name, count, spare, "piece", part, name, note)


def spare_pieces(count: int, fraction: float) -> int:
    """Spare pieces of a number of pieces: a fraction of them, at least one; none of none."""
    return max(1, math.ceil(fraction * count)) if count else 0


def printed_spares(parts: PartSet) -> dict[str, int]:
    """Spare pieces of each printed part of the array; a mold is made once."""
    fraction = Spares().made
    return {
        name: spare_pieces(parts.counts[name], fraction)
        for name in parts
        if parts.origin(name) == "printed" and parts.kinds[name] not in get_args(MoldKind)
    }


def _line(item: BillItem, spares: Spares, cast: Cast | None) -> OrderLine:
    """A line of the bill with its spares; a mold is made once, and silicone is mixed by the cup."""
    needed, note = item.quantity, item.note
    if item.use == "tooling":
        spare = 0.0
    elif cast is not None:
        needed = cast.casts * cast.batch
        spare = 0.0 if cast.spare >= spare_pieces(cast.needed, spares.made) else cast.batch
        note = f"{note}; {cast.casts} x {cast.batch_grams:.3g} g to mix{', and one cup for spares' if spare else ''}"
    elif item.use in ("printed", "cast"):
        number = spare_pieces(item.count, spares.made)
        spare = item.quantity / item.count * number if item.count else 0.0
        note = f"{note}; {number} spare"
    elif item.unit == "piece":
        spare = float(spare_pieces(item.count, spares.bought))
    elif item.unit == "m":
        needed, words = _length(item)
        note += words
        # A piece of each row is cut as a spare.
        spare = max(spares.tube * needed, SPARE_PIECES * needed / item.count)
    else:
        spare = spares.glue * item.quantity
    purpose: Purpose = "molds" if item.use == "tooling" else "array"
    return OrderLine(purpose, item.item, needed, spare, item.unit, item.part, item.bought_as, note)


def _length(item: BillItem) -> tuple[float, str]:
    """Length of all pieces of spring or sheath, m, and what a shop must know of them."""
    part, loss = item.part, Waste().cutting_loss
    if isinstance(part, Sleeve):
        rough = rough_length(1000 * item.quantity / item.count - loss)
        return item.count * (rough + loss) / 1000, f"; sleeves cut {rough:g} mm long before they shrink"
    if isinstance(part, Spring) and (item.to_order or not part.maker):
        return item.quantity, "; wound to order: send order-tubes.txt, which has the inner diameter and the pitch"
    return item.quantity, ""


def _joined(lines: Sequence[OrderLine]) -> list[OrderLine]:
    """Lines, those of one item that is bought by the metre as one."""
    found: dict[object, OrderLine] = {}
    for number, line in enumerate(lines):
        key: object = (line.item, line.bought_as) if line.unit == "m" else number
        if key in found:
            first = found[key]
            notes = dict.fromkeys((*first.note.split("; "), *line.note.split("; ")))
            # The place of each piece first, then what a shop must know.
            words = "; ".join(sorted(notes, key=lambda note: not note.startswith("cut to")))
            line = replace(first, needed=first.needed + line.needed, spare=first.spare + line.spare, note=words)
        found[key] = line
    return list(found.values())


def _needs_primer(bill: Bill) -> bool:
    """True if a tube whose sheath few glues hold is glued with cyanoacrylate."""
    glue = glue_of(bill, "tube")
    sheaths = (item.part for item in bill.items if isinstance(item.part, Sheath))
    return glue is not None and "cyanoacrylate" in glue.chemistry and any(each.material in UNGLUED for each in sheaths)


def _packed(part: StockPart, amount: float) -> float:
    """Amount of whole packs that hold an amount."""
    pack = PACKS.get(part.kind, 0.0)
    if not pack or (isinstance(part, Resin) and set(part.processes) <= set(SERVICES)):
        return amount
    return math.ceil(amount / pack) * pack


def _words(quantity: float, unit: str) -> str:
    if unit == "m" and quantity < 1:
        return f"{1000 * quantity:.0f} mm"
    return f"{quantity:.0f} pcs" if unit == "piece" else f"{quantity:.3g} {unit}"
