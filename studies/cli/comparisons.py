"""Verb that puts designs, runs, libraries and cases side by side."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import studies
from studies.cli.options import display_on_stderr
from studies.cli.terminal_tables import say, show, table_of, tell
from studies.comparison.quantities import OVERVIEW, REASONS

if TYPE_CHECKING:
    from studies.comparison.compared import Comparison
    from studies.comparison.compared_rows import ComparedFigure


def compare(
    subjects: Annotated[
        list[str],
        typer.Argument(
            metavar="A B ...",
            help="Two to eight design files, prototypes, folders of runs, libraries, or cases such as results.zarr#12.",
        ),
    ],
    out: Annotated[
        Path | None, typer.Option(help="Page to write (.html), which opens without a network, or all figures (.json).")
    ] = None,
    printing: Annotated[
        bool, typer.Option("--printing/--no-printing", help="Draw the parts of designs and check the print rules.")
    ] = True,
) -> None:
    """Compare designs, runs, libraries or cases of sweeps side by side.

    Prints the verdict on each, the fields that differ, and the figures with the better one named. Accuracy, smallest
    force, size and cost come first. A run also has the accuracies of its trained localizer. The page shows the transfer
    functions over each other as well. If something cannot be compared, such as arrays with different numbers of
    microphones, you see why.

    Example: [bold]acoustic-fem compare array-2x6 mine.toml --out comparison.html[/bold], or
    [bold]acoustic-fem compare results.zarr#3 results.zarr#17[/bold]
    """
    with display_on_stderr() as display:
        found = studies.compare(*subjects, out=out, printing=printing, display=display)
    groups = {name: rows for name, rows in found.groups.items() if name != REASONS}
    for name, (outcome, reason) in zip(found.names, found.verdicts, strict=True):
        if outcome:
            tell(f"{name}: {outcome}{': ' * bool(reason)}{reason}")
    _show_group(found, OVERVIEW, groups.pop(OVERVIEW, ()))
    if found.fields:
        table = table_of("field", *found.names)
        for field in found.fields:
            table.add_row(field.name, *field.written)
        show(table)
    else:
        say("no field differs")
    for name, rows in groups.items():
        _show_group(found, name, rows)
    for each in found.differences:
        if not each.why:
            tell(f"transfer functions of {each.name} differ from those of {found.names[0]} by {each.words}")
    for note in found.notes:
        tell(f"note: {note}")
    if out is not None:
        say(out)


def _show_group(found: Comparison, name: str, rows: Sequence[ComparedFigure]) -> None:
    """Print a group of figures, with the names of the better subjects in the last column if any is better."""
    ranked = any(row.best for row in rows)
    table = table_of(name.lower(), *found.names, *([found.mark] if ranked else []))
    for row in rows:
        best = [", ".join(found.names[place] for place in row.best)] if ranked else []
        table.add_row(row.quantity.title, *(text or "-" for text in row.written), *best)
    show(table)
