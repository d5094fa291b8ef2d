"""The verb sweep."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING, Annotated

import typer

from studies.cli.options import Scheduler, check_workers, display_on_stderr
from studies.output.display import number

if TYPE_CHECKING:
    from studies.output.display import Report
    from studies.sweep.plan import Plan
    from studies.sweep.run import Progress, Summary

#: Kinds of reasons for failures that are listed; all are in the store.
_LISTED = 10


def sweep(
    study: Annotated[str, typer.Argument(metavar="STUDY", help="A study file.", show_default=False)],
    out: Annotated[
        Path | None,
        typer.Option(help="The store to write or to continue, such as results.zarr.", show_default=False),
    ] = None,
    workers: Annotated[
        int | None,
        typer.Option(
            help="Processes on this machine; 1 computes in this one.",
            show_default="one per core if that saves more than their start, or 1",
        ),
    ] = None,
    scheduler: Scheduler = None,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Only say how many cases and cells, how long and how much memory.")
    ] = False,
) -> None:
    """Compute many designs: every case of a study with its metrics, into one store.

    Killed and started again it goes on where it was. A case that fails keeps its reason and stops no other. Exit code 1
    where one fails by a mistake of the program.

    Example: [bold]acoustic-fem sweep study.toml --out results.zarr[/bold]
    """
    from studies.study.file import load_study

    if out is None and not dry_run:
        raise typer.BadParameter("--out is missing: the store to write, such as results.zarr")
    check_workers(workers, scheduler)
    given = load_study(study)
    if dry_run:
        from studies.sweep.plan import plan_sweep

        _print_plan(plan_sweep(given, workers), given.fidelity)
        return
    from studies.sweep.run import SweepError, run_sweep

    assert out is not None
    with display_on_stderr() as display, display.stage("Sweep") as report:
        summary = run_sweep(given, out, workers=workers, scheduler=scheduler, progress=_shown(report))
    _print_summary(summary, out)
    if wrong := summary.program_errors:
        raise SweepError(
            f"{out}: {len(wrong)} cases (the first is {min(wrong)}) failed by a mistake of the program, not by their "
            "design; when it is mended compute the study into a new store"
        )


def _shown(report: Report) -> Callable[[Progress], None]:
    """Progress on the display: at a terminal twice a second, elsewhere when a tenth more time has passed."""
    live = sys.stderr.isatty()
    started = perf_counter()
    last = -1e9

    def show(now: Progress) -> None:
        nonlocal last
        seconds = perf_counter() - started
        wait = 0.5 if live else max(5.0, 0.1 * seconds)
        if seconds - last < wait and now.done < now.total:
            return
        last = seconds
        failed = f", {now.failed} failed" if now.failed else ""
        left = "" if now.done >= now.total else f", {duration(now.remaining)} left"
        report(f"{now.done} of {now.total} {now.what}, {number(now.rate)}/s{left}{failed}", now.done / now.total)

    return show


def duration(seconds: float) -> str:
    """A time as people say it."""
    if seconds < 100:
        return f"{number(seconds)} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"


def size(count: float) -> str:
    """Bytes as people say them."""
    return f"{number(count / 1e6)} MB" if count < 1e9 else f"{number(count / 1e9)} GB"


def _print_plan(plan: Plan, fidelity: str) -> None:
    left_out = f" ({plan.left_out} more break a constraint)" if plan.left_out else ""
    print(f"cases: {plan.cases}{left_out}")
    if plan.note:
        print(f"note: {plan.note}")
    refused = sum(plan.refused.values())
    if refused:
        print(f"not valid: {refused}, which will be kept as failed; of each kind the first:")
        _print_reasons(plan.refused)
    if fidelity != "lumped":
        print(f"distinct cells ({fidelity}): {plan.cells}, of which {plan.cells_cached} are in the cache")
    print(f"expected time: {duration(plan.seconds)} with {plan.workers} worker{'s' * (plan.workers > 1)}")
    print(f"expected memory: {size(plan.memory)}")
    print(f"store: at most {size(plan.storage)}")


def _print_reasons(reasons: dict[str, int]) -> None:
    for reason, count in list(reasons.items())[:_LISTED]:
        print(f"  {count} x {reason}")
    if len(reasons) > _LISTED:
        print(f"  and {len(reasons) - _LISTED} more kinds of reasons")


def _print_summary(summary: Summary, out: Path) -> None:
    earlier = summary.cases - summary.computed
    print(
        f"{summary.cases} cases, {summary.computed} computed now in {duration(summary.seconds)}"
        + (f", {earlier} by earlier runs" if earlier else "")
    )
    if summary.cells:
        print(f"{summary.cells} distinct cells, {summary.cells_solved} solved in {duration(summary.cell_seconds)}")
    failed = sum(len(numbers) for numbers in summary.failures.values())
    if failed:
        print(f"{failed} failed, of each kind the first:")
        _print_reasons({f"{why} (case {numbers[0]})": len(numbers) for why, numbers in summary.failures.items()})
    for note in summary.notes:
        print(f"note: {note}", file=sys.stderr)
    print(out)
