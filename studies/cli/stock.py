"""The verb that lists the parts that can be bought, and those of one design."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

import studies
from geometry.stock import KINDS
from studies.cli.options import OwnStock
from studies.cli.stock_tables import show_parts_sold, show_stock_fit
from studies.cli.terminal_tables import say


def stock(
    kind: Annotated[
        str | None, typer.Argument(metavar="[KIND]", help=f"Kind of part: {', '.join(KINDS)}. Default: all.")
    ] = None,
    design: Annotated[
        str | None,
        typer.Option(metavar="DESIGN", help="List the parts of this design, and its sizes that nobody sells."),
    ] = None,
    own: OwnStock = None,
    out: Annotated[Path | None, typer.Option(help="JSON file to write the list to.")] = None,
) -> None:
    """List the parts that can be bought, with makers, sizes, prices and sources.

    Studies, searches and the studio take sizes from this list unless you write stock = "off". Add parts of your own
    with --stock, with the environment variable ACOUSTIC_FEM_STOCK, or in a file stock.toml beside the design. Guide:
    docs/stock.md.

    Example: [bold]acoustic-fem stock spring[/bold]
    """
    found = studies.list_stock(kind, design=design, out=out)
    if found.fit is None:
        show_parts_sold(found.parts)
    else:
        show_stock_fit(found.fit)
    if out is not None:
        say(out)
