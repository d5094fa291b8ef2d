"""The verb wiring."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from studies.cli.tables import show, table_of


def wiring(
    microphones: Annotated[int, typer.Argument(metavar="MICROPHONES", help="How many, 2 to 16.", show_default=False)],
    points: Annotated[int, typer.Argument(metavar="POINTS", help="On each line, 1 to 1000.", show_default=False)],
    out: Annotated[Path | None, typer.Option(help="Draw 2 to so many microphones, PNG.", show_default=False)] = None,
) -> None:
    """How many points so many microphones serve, for every number of lines, against the usual wirings.

    Example: [bold]acoustic-fem wiring 4 36 --out wiring.png[/bold]
    """
    from studies.output.folders import check_new_file
    from studies.run.wiring import draw_wirings, wirings

    found = wirings(microphones, points)
    check_new_file(out)
    table = table_of(
        "lines", "points", "against one transducer per point", "against rows + columns", numbers=(0, 1, 2, 3)
    )
    for counts in found:
        table.add_row(
            str(counts.lines),
            str(counts.points),
            f"{counts.gain_over_one_transducer_per_point:.4g} times",
            f"{counts.gain_over_row_column:.4g} times",
        )
    show(table)
    if out is not None:
        print(draw_wirings(out, microphones, points))
