"""The verb tolerance."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from geometry.refusal import Refusal
from studies.cli.options import Design, Frequencies, Noise, Tolerances, display_on_stderr, frequency_option, named
from studies.cli.tables import show, table_of
from studies.output.display import number


def tolerance(
    design: Design,
    out: Annotated[Path, typer.Option(help="The folder to write to.", show_default=False)],
    samples: Annotated[int, typer.Option(help="Sensors made with scatter.")] = 256,
    base: Annotated[int, typer.Option(help="Of the Sobol indices: ten times as many sensors; 0 for none.")] = 128,
    library: Annotated[
        int, typer.Option(help="Sensors to store in OUT/library.zarr, for training; 0 for none.", show_default=True)
    ] = 0,
    tolerances: Tolerances = None,
    noise: Noise = None,
    seed: Annotated[int, typer.Option(help="Of all draws.")] = 0,
    frequencies: Frequencies = "1:100:64",
) -> None:
    """What manufacturing scatter does: spread of transfer functions and accuracy, and which tolerance matters most.

    Every tube, cavity and membrane deviates by itself. Lumped fidelity, about half a minute for 12 points:
    tolerance.json and tolerance.png.

    Example: [bold]acoustic-fem tolerance array-2x6 --out scatter --library 2000[/bold]
    """
    grid = frequency_option(frequencies)
    if seed < 0:
        raise typer.BadParameter(f"--seed: {seed} must be 0 or above")
    if not 0 <= library <= 1_000_000:
        raise typer.BadParameter(f"--library: {library} must be from 0 to 1000000")
    from geometry import resolve_design
    from studies.output.folders import check_folder
    from studies.scatter.effects import ACCURACIES, tolerance_study
    from studies.scatter.files import save_tolerance
    from studies.scatter.perturbed_library import write_perturbed_library
    from studies.scatter.tolerances import TOLERANCES, read_tolerances

    check_folder(out)
    resolved = resolve_design(design)
    scatter = TOLERANCES if tolerances is None else read_tolerances(tolerances)
    store = out / "library.zarr"
    if library and store.exists():
        raise Refusal(f"{store}: exists; a library is never overwritten")
    options = {name: f"--{name}" for name in ("samples", "base", "noise")}
    with named(frequency="--frequencies", count="--library", **options), display_on_stderr() as display:
        with display.stage("Scatter") as report:
            result = tolerance_study(
                resolved, grid, samples=samples, base=base, tolerances=scatter, noise=noise, seed=seed, progress=report
            )
        files = save_tolerance(result, out)
        if library:
            with display.stage("Library") as report:
                write_perturbed_library(store, resolved, library, grid, tolerances=scatter, seed=seed, progress=report)
            files = (*files, store)
    table = table_of("predicted top-1 (%)", "mean", "5 %", "median", "95 %", numbers=(1, 2, 3, 4))
    summary = result.summary()
    for name, title in ACCURACIES.items():
        spread = summary["accuracy"][name]
        table.add_row(title, *(number(100 * spread[key], 1) for key in ("mean", "q05", "median", "q95")))
    show(table)
    if result.sobol:
        table = table_of("total Sobol index", "ratios", "+-", "top-1", "+-", numbers=(1, 2, 3, 4))
        of_accuracy = {index.quantity: index for index in result.sobol["nominal"]}
        for index in result.sobol["deviation"]:
            other = of_accuracy[index.quantity]
            shares = (index.total, index.error, other.total, other.error)
            table.add_row(index.quantity.replace("_", " "), *(number(share, 2) for share in shares))
        show(table)
    print(f"{resolved.name} as designed: {number(100 * result.nominal_accuracy, 1)} %; noise: {result.noise}")
    for file in files:
        print(file)
