"""Verbs on many designs: sweep, report, best."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import studies
from geometry.ground.refusal import Kind, counted, in_one_line
from studies.cli.options import OwnStock, Scheduler, check_workers, display_on_stderr
from studies.cli.stock_tables import tell_unsold
from studies.cli.terminal_tables import say, show, table_of, tell
from studies.output.call_defaults import BEST_DESIGNS
from studies.output.display import duration, number

if TYPE_CHECKING:
    from studies.findings.reporting import BestDesigns
    from studies.sweep.plan import Plan
    from studies.sweep.summary import Summary

#: Kinds of reasons for failures that are listed; all are in the store.
_LISTED = 10
Results = Annotated[
    Path,
    typer.Argument(
        metavar="RESULTS", help="Results of a sweep (results.zarr), even while it runs, or the folder of a search."
    ),
]


def sweep(
    study: Annotated[str, typer.Argument(metavar="STUDY", help="Study file: docs/studies.md.")],
    out: Annotated[Path | None, typer.Option(help="Store to write or to continue, such as results.zarr.")] = None,
    workers: Annotated[
        int | None,
        typer.Option(
            help="Number of worker processes on this machine; 1 starts none. Default: one per core if that saves time.",
        ),
    ] = None,
    scheduler: Scheduler = None,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Print the number of cases and cells, the time and the memory, then stop.")
    ] = False,
    own: OwnStock = None,
) -> None:
    """Compute the metrics of many designs, every case of a study file.

    Writes one store with all cases. If the sweep is killed, start it again to continue. The base design of the study
    must be valid. A case that cannot be built is stored with its reason and does not stop the others. The exit code is
    1 if no case could be computed, or if one failed because of a bug in the program.

    Example: [bold]acoustic-fem sweep study.toml --out results.zarr[/bold]
    """
    if out is None and not dry_run:
        raise typer.BadParameter("--out is missing: the store to write, such as results.zarr")
    check_workers(workers, scheduler)
    if dry_run:
        given = studies.load_study(study)
        with display_on_stderr() as display:
            plan = studies.plan_sweep(given, workers, display=display)
        _print_plan(plan, given)
        return
    assert out is not None
    with display_on_stderr() as display:
        summary = studies.run_sweep(study, out, workers=workers, scheduler=scheduler, display=display).summary
    _print_summary(summary, out)
    if summary.objection is not None:
        raise studies.sweep.SweepError(summary.objection, kind=Kind.NO_RESULT, file=out)


def report(results: Results, out: Annotated[Path, typer.Option(help="Page to write, HTML.")]) -> None:
    """Write one page about a sweep or a search.

    The page shows main effects, pairs, trade-offs, the best designs, and level and phase differences. It is one file
    that opens without a network.

    Example: [bold]acoustic-fem report results.zarr --out report.html[/bold]
    """
    with display_on_stderr() as display:
        table = studies.sweep_report(results, out, display=display)
    tell(
        f"{out}: {counted(len(table.number), 'design')}, {sum(count for _, count in table.failures)} failed, "
        f"{table.waiting} not computed yet"
    )


def best(
    results: Results,
    design: Annotated[str | None, typer.Argument(metavar="[DESIGN]", help="Number of a design in the list.")] = None,
    out: Annotated[Path | None, typer.Option(help="Design file to write.")] = None,
    by: Annotated[
        str | None,
        typer.Option(
            metavar="METRIC",
            help="Metric to sort by. Default: the first metric of a search; of a sweep, the first metric that "
            "includes noise.",
        ),
    ] = None,
    count: Annotated[int, typer.Option(help="Number of designs to list.")] = BEST_DESIGNS,
) -> None:
    """List the best designs of a sweep or a search, or write the file of one.

    Example: [bold]acoustic-fem best results.zarr --by sensitivity_force[/bold], then
    [bold]acoustic-fem best results.zarr 17 --out design-17.toml[/bold]
    """
    if (design is None) != (out is None):
        missing = (
            "--out is missing: the design file to write, such as design-17.toml" if out is None else "DESIGN is missing"
        )
        raise typer.BadParameter(f"{missing}; DESIGN must be a number of the list; give both or neither")
    if design is None or out is None:
        _show_best(studies.best_designs(results, by, count))
        return
    tell_unsold(studies.save_best_design(results, design, out))
    say(out)


def _show_best(best: BestDesigns) -> None:
    table = best.table
    columns = [best.metric, *(column for column in table.metrics if column.name != best.metric.name)]
    shown = [*columns, *table.parameters]
    head = [f"{column.name}{f' ({column.unit})' * bool(column.unit)}" for column in shown]
    out = table_of("design", *head, numbers=tuple(range(len(shown) + 1)))
    for row in best.rows:
        cells = [column.labels[int(v)] if column.labels else number(v)
                 for column in shown for v in [float(column.values[row])]]  # fmt: skip
        out.add_row(table.label(row), *cells)
    show(out)


def size(count: float) -> str:
    """Bytes in words: MB below 1 GB, GB above."""
    return f"{number(count / 1e6)} MB" if count < 1e9 else f"{number(count / 1e9)} GB"


def _print_plan(plan: Plan, study: studies.Study) -> None:
    left_out = f" ({plan.left_out} more break a constraint)" if plan.left_out else ""
    say(f"cases: {plan.cases}{left_out}")
    if plan.sampled:
        say(f"estimated from {plan.sampled} of {plan.cases + plan.left_out} cases, drawn at random")
    if plan.note:
        say(f"note: {plan.note}")
    refused = sum(plan.refused.values())
    if refused:
        say(f"not valid: {refused}, which will be stored as failed; the first of each kind:")
        _print_reasons(plan.refused)
    if outside := sum(plan.outside.values()):
        fate = (
            'which will be stored as failed (outside = "navier-stokes" in the study solves them in 3-D)'
            if study.outside == "fail"
            else "which will be solved in 3-D"
        )
        say(f"outside the atlas: {outside}, {fate}; the first of each kind:")
        _print_reasons(plan.outside)
    if plan.cells:
        say(f"distinct cells ({study.solid_fidelity}): {plan.cells}, of which {plan.cells_cached} are in the cache")
    say(f"expected time: {duration(plan.seconds)} with {counted(plan.workers, 'worker')}")
    say(f"expected memory: {size(plan.memory)}")
    say(f"store: at most {size(plan.storage)}")


def _print_reasons(reasons: dict[str, int]) -> None:
    for reason, count in list(reasons.items())[:_LISTED]:
        say(f"  {count} x {reason}")
    if len(reasons) > _LISTED:
        say(f"  and {counted(len(reasons) - _LISTED, 'more kind')} of reasons")


def _print_summary(summary: Summary, out: Path) -> None:
    earlier = summary.cases - summary.computed
    say(
        f"{counted(summary.cases, 'case')}, {summary.computed} computed now in {duration(summary.seconds)}"
        + (f", {earlier} by earlier runs" if earlier else "")
    )
    if summary.cells:
        say(
            f"{counted(summary.cells, 'distinct cell')}, {summary.cells_solved} solved in "
            f"{duration(summary.cell_seconds)}"
        )
    failed = sum(len(numbers) for numbers in summary.failures.values())
    if failed:
        say(f"{failed} failed, the first of each kind:")
        _print_reasons({f"{why} (case {numbers[0]})": len(numbers) for why, numbers in summary.failures.items()})
    for note in summary.notes:
        print(f"note: {in_one_line(note)}", file=sys.stderr)
    say(out)
