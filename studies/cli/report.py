"""The verbs report and best: what a sweep or a search found."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from geometry.refusal import Refusal
from studies.cli.options import display_on_stderr
from studies.cli.tables import show, table_of
from studies.output.display import number

if TYPE_CHECKING:
    from studies.findings.result_table import ResultTable

Results = Annotated[
    Path,
    typer.Argument(
        metavar="RESULTS",
        help="The results of a sweep (results.zarr), also while it runs, or the folder of a search.",
        show_default=False,
    ),
]


def report(
    results: Results,
    out: Annotated[Path, typer.Option(help="The page to write, HTML.", show_default=False)],
) -> None:
    """One page about a sweep or a search: main effects, pairs, trade-offs, best designs, level and phase differences.

    Everything is in the file, it opens without a network.

    Example: [bold]acoustic-fem report results.zarr --out report.html[/bold]
    """
    from studies.findings.page import write_sweep_report
    from studies.output.folders import check_new_file

    check_new_file(out)
    table = _read(results)
    with display_on_stderr() as display, display.stage("Report"):
        write_sweep_report(table, out, f"acoustic-fem best {results} {{number}} --out design-{{number}}.toml")
    print(f"{out}: {len(table.number)} designs, {sum(count for _, count in table.failures)} failed, "
          f"{table.waiting} not computed yet")  # fmt: skip


def best(
    results: Results,
    design: Annotated[
        str | None, typer.Argument(metavar="[DESIGN]", help="Number of a design, as listed.", show_default=False)
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Write its design file here.", show_default=False)] = None,
    by: Annotated[
        str | None, typer.Option(metavar="METRIC", help="What counts.", show_default="the first of the study")
    ] = None,
    count: Annotated[int, typer.Option(help="Designs to list.")] = 10,
) -> None:
    """List the best designs of a sweep or a search, or write the design file of one of them.

    Example: [bold]acoustic-fem best results.zarr --by sensitivity_force[/bold], then
    [bold]acoustic-fem best results.zarr 17 --out design-17.toml[/bold]
    """
    if (design is None) != (out is None):
        raise typer.BadParameter("give the number of a DESIGN and --out together, or neither for the list")
    if count < 1:
        raise typer.BadParameter(f"--count {count} must be at least 1")
    from studies.output.folders import check_new_file

    check_new_file(out, kept="a design")
    table = _read(results)
    if design is None or out is None:
        _show_best(table, by or table.metrics[0].name, count)
        return
    from geometry import save_design
    from studies.findings.page import design_of

    rows = {table.label(row): row for row in range(len(table.number))}
    if design not in rows:
        raise Refusal(
            f"{results}: design {design} is not among the {len(rows)} that were computed, from {table.number.min()} to "
            f"{table.number.max()}"
        )
    save_design(design_of(table, rows[design]), out)
    print(out)


def _read(results: Path) -> ResultTable:
    """A store of a sweep, or the folder of a search."""
    from studies.findings.result_table import table_of_search, table_of_sweep
    from studies.sweep.store import open_sweep

    if results.is_dir() and not (results / "zarr.json").exists():
        from studies.findings.search_files import read_search

        return table_of_search(*read_search(results))
    return table_of_sweep(open_sweep(results))


def _show_best(table: ResultTable, metric: str, count: int) -> None:
    rows = table.best(metric, count)
    columns = [table.metric(metric), *(column for column in table.metrics if column.name != metric)]
    shown = [*columns, *table.parameters]
    head = [f"{column.name}{f' ({column.unit})' * bool(column.unit)}" for column in shown]
    out = table_of("design", *head, numbers=tuple(range(len(shown) + 1)))
    for row in rows:
        cells = [column.labels[int(v)] if column.labels else number(v)
                 for column in shown for v in [float(column.values[row])]]  # fmt: skip
        out.add_row(table.label(row), *cells)
    show(out)
