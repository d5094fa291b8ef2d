"""Verbs on the designs around one: tolerance, optimize."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import studies
from geometry.ground.refusal import counted
from studies.cli.options import (
    Design,
    Frequencies,
    Noise,
    OwnStock,
    Scheduler,
    Tolerances,
    WorkerCount,
    check_workers,
    display_on_stderr,
    noise_choice,
)
from studies.cli.stock_tables import tell_unsold
from studies.cli.terminal_tables import say, show, table_of, tell
from studies.output.call_defaults import BASE_SAMPLES, SEED, SENSORS, STORED_SENSORS
from studies.output.display import number
from studies.output.frequencies import FREQUENCIES
from studies.output.report_texts import percent

if TYPE_CHECKING:
    from studies.optimization.problem import Optimization
    from studies.optimization.search import Candidate
    from studies.scatter.effects import ToleranceResult
    from studies.scatter.tolerance_run import ToleranceStudy

#: Rows of the front that are printed.
_SHOWN = 10


def tolerance(
    design: Design,
    out: Annotated[Path, typer.Option(help="Folder to write to.")],
    samples: Annotated[int, typer.Option(help="Number of as-built sensors.")] = SENSORS,
    base: Annotated[
        int,
        typer.Option(
            help="Base samples of the Sobol indices; each needs ten more sensors. With 0 there are no indices."
        ),
    ] = BASE_SAMPLES,
    library: Annotated[
        int,
        typer.Option(help="Number of sensors to store in OUT/library.zarr, for training; 0 stores none."),
    ] = STORED_SENSORS,
    tolerances: Tolerances = None,
    noise: Noise = None,
    seed: Annotated[int, typer.Option(help="Seed of all draws.")] = SEED,
    frequencies: Frequencies = FREQUENCIES,
) -> None:
    """Compute how manufacturing scatter spreads the accuracy, and which tolerance matters most.

    Writes tolerance.json and tolerance.png: the spread of transfer functions and accuracy, and how much each tolerance
    contributes to it. Every tube, cavity and membrane deviates independently. Takes about half a minute for 12 points.

    Example: [bold]acoustic-fem tolerance array-2x6 --out scatter --library 2000[/bold]
    """
    with display_on_stderr() as display:
        study = studies.tolerance_study(
            design,
            out,
            samples=samples,
            base_samples=base,
            library_size=library,
            tolerances=tolerances,
            microphone_noise=noise_choice(noise),
            seed=seed,
            frequency=frequencies,
            display=display,
        )
    _show_scatter(study)
    for file in study.files:
        say(file)


def _show_scatter(study: ToleranceStudy) -> None:
    """Print how much accuracy scatter costs, then the accuracies and the effects of the quantities as tables."""
    result, summary = study.result, study.result.summary()["accuracy"]
    tell(
        f"{study.design.name}: without calibration, {percent(summary['nominal']['mean'])} of touches are assigned to "
        f"the correct point, as the mean over {counted(len(result.deviation), 'as-built sensor')}"
    )
    table = table_of(
        "predicted top-1 accuracy (%)", "mean", "5th percentile", "median", "95th percentile", numbers=(1, 2, 3, 4)
    )
    nominal = number(100 * result.nominal_accuracy, 1)
    table.add_row("nominal sensor, localizer of the nominal design", nominal, "", "", "")
    for name, title in studies.scatter.ACCURACIES.items():
        values = (number(100 * summary[name][key], 1) for key in ("mean", "q05", "median", "q95"))
        table.add_row(f"as-built sensors, {title}", *values)
    show(table)
    if result.sobol:
        _show_causes(result)
    tell(f"noise: {result.noise}")
    tell(f"fidelity {result.fidelity.words}")


def _show_causes(result: ToleranceResult) -> None:
    """Print which quantity matters most for the accuracy, and the Sobol indices of all."""
    of_accuracy = {index.quantity: index for index in result.sobol["nominal"]}
    most = max(of_accuracy.values(), key=lambda index: index.total)
    tell(
        f"The accuracy without calibration depends most on the {_in_words(most.quantity)}. Each index is the fraction "
        "of the variance to which a quantity contributes, with its standard error."
    )
    table = table_of(
        "total Sobol index", "of the signal ratios", "error", "of the accuracy", "error", numbers=(1, 2, 3, 4)
    )
    for index in result.sobol["deviation"]:
        other = of_accuracy[index.quantity]
        values = (index.total, index.error, other.total, other.error)
        table.add_row(_in_words(index.quantity), *(number(value, 2) for value in values))
    show(table)


def _in_words(quantity: str) -> str:
    return quantity.replace("_", " ")


def optimize(
    study: Annotated[str, typer.Argument(metavar="STUDY", help="Study file with a section \\[optimize].")],
    out: Annotated[Path, typer.Option(help="New folder, or that of the same search, which is continued.")],
    workers: WorkerCount = None,
    scheduler: Scheduler = None,
    own: OwnStock = None,
) -> None:
    """Search for the best designs of a study file that can be printed and laid out.

    Writes best.toml, the designs on the front, front.csv and report.html. If the search is killed, start it again to
    continue. To continue a finished search, raise optimize.trials in the file.

    Example: [bold]acoustic-fem optimize fingertip-study.toml --out fingertip[/bold]
    """
    check_workers(workers, scheduler)
    with display_on_stderr() as display:
        found = studies.optimize(study, out, workers=workers, scheduler=scheduler, display=display)
    result = found.result
    _show_front(found.problem, (result.base, *result.front[:_SHOWN]))
    say(f"{counted(len(result.candidates), 'design')} computed, {sum(count for _, count in result.refused)} rejected, "
          f"{len(result.front)} on the front")  # fmt: skip
    for file in found.files:
        say(file)
    if result.front:
        tell_unsold(found.problem.study.base.with_values(result.front[0].values))


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
