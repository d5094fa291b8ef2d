"""Tables of parts that can be bought: the catalogue, and what a design takes of it."""

from __future__ import annotations

from collections.abc import Iterable

from geometry.design.design_file import DesignLike
from geometry.stock import StockFit, StockPart, catalogue
from studies.cli.terminal_tables import show, show_narrow, table_of, tell


def show_parts_sold(parts: Iterable[StockPart]) -> None:
    """Parts of a catalogue, one a row."""
    table = table_of("kind", "maker", "part number", "size", "price (USD)", "per", "of", "source", numbers=(4,))
    for part in parts:
        table.add_row(
            *(part.kind, part.maker, part.part_number, part.size, f"{part.price:g}", part.unit, part.price_date),
            "; ".join(filter(None, (part.source, part.note))),
        )
    show(table)


def show_stock_fit(fit: StockFit) -> None:
    """Parts that a design is bought as, then what cannot be bought and the nearest that can."""
    table = table_of("parts to buy", "part", "size", "price (USD)", "per", numbers=(3,))
    for role, part in fit.parts.items():
        table.add_row(role, part.name, part.size if part.part_number else "", f"{part.price:g}", part.unit)
    show_narrow(table)
    if fit.bought:
        return
    table = table_of("cannot be bought", "design", "nearest", "part")
    for change in fit.changes:
        table.add_row(change.field, _plain(change.old), _plain(change.new), change.part.name)
    for field in fit.missing:
        nearest = fit.nearest.get(field)
        table.add_row(field, "made to order", "", "none in the catalogue" if nearest is None else nearest.name)
    show_narrow(table)
    if fit.missing:
        tell("no shop is known for what is made to order: docs/stock.md says how to add a part of your own")


def tell_unsold(design: DesignLike) -> None:
    """One line for each part of a design that was written which cannot be bought."""
    fit = catalogue().fit(design)
    for change in fit.changes:
        size = f"{change.field} = {_plain(change.old)}"
        tell(f"note: {size} cannot be bought; the nearest is {_plain(change.new)}: {change.part.name}")
    for field in fit.missing:
        nearest = fit.nearest.get(field)
        words = "" if nearest is None else f"; the nearest part is {nearest.name}"
        tell(f"note: {field} is made to order{words}")


def _plain(value: object) -> str:
    return f"{value:g}" if isinstance(value, float) else str(value)
