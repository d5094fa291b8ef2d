"""Results of a sweep or a search, read back: a page, the best designs, the design file of one."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

import studies
from geometry import save_design
from geometry.ground.argument_checks import check_range
from geometry.ground.file_checks import check_local
from geometry.ground.refusal import Kind, Refusal, counted
from studies.findings.result_table import Column, ResultTable, table_of_search, table_of_sweep, with_base_metrics
from studies.output.call_defaults import BEST_DESIGNS
from studies.output.display import Display
from studies.output.folders import check_new_file
from studies.sweep.results import is_sweep, open_sweep


@dataclass(frozen=True, eq=False)
class BestDesigns:
    """Best designs by one metric."""

    table: ResultTable
    """Table of all designs that were computed."""
    metric: Column
    """Column of the metric that counts."""
    rows: tuple[int, ...]
    """Rows of the table, best first."""


def read_results(results: str | os.PathLike[str]) -> ResultTable:
    """Table of the designs of a sweep or a search with their parameters and metrics.

    Args:
        results: the store of a sweep (``results.zarr``), also while it runs, or the folder of a search.

    Raises:
        Refusal: it is neither, or holds no design that was computed.
    """
    check_local(results, field="results")
    place = Path(results)
    if place.is_dir() and not is_sweep(place):
        return table_of_search(*studies.findings.read_search(place))
    return table_of_sweep(open_sweep(place))


def sweep_report(
    results: str | os.PathLike[str], out: str | os.PathLike[str], *, display: Display | None = None
) -> ResultTable:
    """Page about a sweep or a search: main effects, pairs, trade-offs, best designs, level and phase differences.

    Args:
        results: results of a sweep or of a search, see :func:`read_results`.
        out: the page to write, HTML; an earlier one is replaced. It opens without a network.
        display: shows progress.

    Returns:
        Contents of the page.

    Raises:
        Refusal: as :func:`read_results`, or a file that cannot be written.
    """
    path = Path(out)
    check_new_file(path, ".html")
    table = read_results(results)
    with (display or Display()).stage("Report"):
        table = with_base_metrics(table)
        studies.findings.write_sweep_report(
            table, path, f"acoustic-fem best {results} {{number}} --out design-{{number}}.toml"
        )
    return table


def best_designs(results: str | os.PathLike[str], by: str | None = None, count: int = BEST_DESIGNS) -> BestDesigns:
    """Best designs of a sweep or a search by one metric.

    Args:
        results: results of a sweep or of a search, see :func:`read_results`.
        by: name of the metric to rank by; by default the first metric of a search, or the first metric of a sweep that
            includes noise.
        count: largest number of designs, at least 1.

    Raises:
        Refusal: as :func:`read_results`, no such metric, or a count below 1.
    """
    check_range("count", count, 1, whole=True)
    table = read_results(results)
    metric = table.metric(by) if by else table.leading
    return BestDesigns(table, metric, tuple(table.best(metric.name, count)))


def save_best_design(results: str | os.PathLike[str], design: str | int, out: str | os.PathLike[str]) -> Path:
    """Write the design file of one design of a sweep or a search.

    Args:
        results: results of a sweep or of a search, see :func:`read_results`.
        design: number of the design, or its name in the list.
        out: a new file; an existing design file is never overwritten.

    Raises:
        Refusal: as :func:`read_results`, no such design, or a file that exists or cannot be written.
    """
    path = Path(out)
    check_new_file(path, ".toml", kept="a design")
    table = read_results(results)
    rows = {table.label(row): row for row in range(len(table.number))}
    if str(design) not in rows:
        numbers = f"from {table.number.min()} to {table.number.max()}"
        raise Refusal(
            f"must be one of the {counted(len(rows), 'number')} that {results} has, {numbers}",
            kind=Kind.UNKNOWN,
            field="design",
            value=str(design),
        )
    save_design(studies.findings.design_of(table, rows[str(design)]), path)
    return path
