"""The verb that lists the parts that can be bought, and those of one design."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from geometry.stock import KINDS, catalogue
from studies.cli.options import OwnStock
from studies.cli.stock_tables import show_parts_sold, show_stock_fit
from studies.cli.terminal_tables import say
from studies.output.folders import check_new_file, write_json


def stock(
    kind: Annotated[
        str, typer.Argument(metavar="[KIND]", help=f"Kind of part: {', '.join(KINDS)}. Default: all.")
    ] = "",
    design: Annotated[
        str | None,
        typer.Option(metavar="DESIGN", help="List the parts of this design, and what of it cannot be bought."),
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
    if kind and design is not None:
        raise typer.BadParameter("give a KIND or --design, not both")
    check_new_file(out, ".json")
    sold = catalogue()
    if design is not None:
        fit = sold.fit(design)
        show_stock_fit(fit)
        content: dict[str, Any] = fit.to_dict()
    else:
        parts = sold.listed(kind)
        show_parts_sold(parts)
        content = {"parts": [part.to_dict() for part in parts]}
    if out is not None:
        write_json(out, content)
        say(out)
