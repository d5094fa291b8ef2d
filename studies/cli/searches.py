"""The verb optimize."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from geometry.refusal import Refusal
from studies.cli.options import Scheduler, WorkerCount, check_workers, display_on_stderr
from studies.cli.tables import show, table_of
from studies.output.display import number

if TYPE_CHECKING:
    from studies.optimization.problem import Optimization
    from studies.optimization.search import Candidate

#: Rows of the front that are printed.
_SHOWN = 10


def optimize(
    study: Annotated[
        str, typer.Argument(metavar="STUDY", help="A study file with a section \\[optimize].", show_default=False)
    ],
    out: Annotated[
        Path, typer.Option(help="A new folder, or that of the same search, which is continued.", show_default=False)
    ],
    workers: WorkerCount = None,
    scheduler: Scheduler = None,
) -> None:
    """Search the best designs of a study, of those that can be printed and laid out.

    Writes best.toml, the designs on the front, front.csv and report.html. Killed and started again it goes on where
    it was; with more optimize.trials in the file it goes on beyond.

    Example: [bold]acoustic-fem optimize fingertip-study.toml --out fingertip[/bold]
    """
    check_workers(workers, scheduler)
    from studies.findings.search_files import check_printed, save_search
    from studies.optimization.problem import load_optimization
    from studies.optimization.search import journal_exists, optimize as search
    from studies.output.folders import check_folder

    problem = load_optimization(study)
    check_folder(out)
    if out.is_dir() and any(out.iterdir()) and not journal_exists(out):
        raise Refusal(f"{out}: holds files that no search made; --out must be a new folder, or one of this search")
    out.mkdir(parents=True, exist_ok=True)
    with display_on_stderr() as display:
        with display.stage("Search") as report:
            result = search(problem, out, workers=workers, scheduler=scheduler, progress=report)
        if not result.front:
            raise Refusal(
                f"{problem.study.name}: none of {problem.trials} designs keeps the limits "
                f"({'; '.join(map(str, problem.limits)) or 'none'}): widen the parameters, or loosen them"
            )
        with display.stage("Parts") as report:
            result = check_printed(problem, result, report)
        if not result.front:
            raise Refusal(f"{problem.study.name}: of no design of the front do the drawn parts pass the print rules")
        files = save_search(problem, result, out)
    _show_front(problem, (result.base, *result.front[:_SHOWN]))
    print(f"{len(result.candidates)} designs computed, {sum(count for _, count in result.refused)} refused, "
          f"{len(result.front)} on the front")  # fmt: skip
    for file in files:
        print(file)


def _show_front(problem: Optimization, rows: tuple[Candidate, ...]) -> None:
    metrics = problem.metrics
    table = table_of(
        "design", *(f"{metric.name}{f' ({metric.unit})' * (metric.unit != '1')}" for metric in metrics),
        numbers=tuple(range(1, len(metrics) + 1)),
    )  # fmt: skip
    for each in rows:
        name = "base" if each.number == -1 else f"{each.number}"
        table.add_row(name, *(number(each.metrics[metric.name]) for metric in metrics))
    show(table)
