"""The command line: one verb per job. Nothing heavy is imported before a verb needs it."""

from __future__ import annotations

import sys
import warnings
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn, TextIO

import typer

from studies.tables import show, show_check, show_fields, show_findings, table_of

if TYPE_CHECKING:
    from localize import Evaluation
    from studies.display import Display

app = typer.Typer(
    name="acoustic-fem",
    help="Design of acoustic tactile arrays: one design file in; transfer functions, a localizer and printable parts "
    "out. Begin with: [bold]acoustic-fem run array-2x6 --out demo[/bold]",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="rich",
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


class Fidelity(StrEnum):
    """What the air of a cell is computed with."""

    lumped = "lumped"
    navier_stokes = "navier-stokes"


Design = Annotated[
    str, typer.Argument(metavar="DESIGN", help="A design file, or the name of a prototype.", show_default=False)
]
LibraryFile = Annotated[
    Path, typer.Argument(metavar="LIBRARY", help="A library, from solve or run (library.nc).", show_default=False)
]


def main() -> NoReturn:
    """Run the command line: exit code 0; 1 with one line on stderr for bad input; 2 for a wrong command line."""
    warnings.showwarning = _show_warning
    try:
        app(prog_name="acoustic-fem")
    except KeyboardInterrupt:
        fail("stopped", 130)
    except (ValueError, OSError, RuntimeError) as error:
        # Every refusal of this program is one of these, with its one line.
        fail(str(error))
    sys.exit(0)


def fail(message: str, code: int = 1) -> NoReturn:
    """End with one line on stderr."""
    print("acoustic-fem: " + " ".join(message.split()), file=sys.stderr)
    sys.exit(code)


def _show_warning(
    message: Warning | str,
    category: type[Warning],
    filename: str,
    lineno: int,
    file: TextIO | None = None,
    line: str | None = None,
) -> None:
    print(f"note: {message}", file=sys.stderr)


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import PackageNotFoundError, version

        try:
            print(f"acoustic-fem {version('acoustic-fem')}")
        except PackageNotFoundError:
            print("acoustic-fem, run from a checkout without an installation")
        raise typer.Exit


@app.callback()
def _root(
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version and stop.")
    ] = False,
) -> None: ...


@app.command()
def prototypes(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="Print the design file of this one.", show_default=False)
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Write the design file here instead.", show_default=False)] = None,
) -> None:
    """List the designs that come with the program, or print one to start your own from.

    Example: [bold]acoustic-fem prototypes array-2x6 --out mine.toml[/bold]
    """
    from geometry.design_file import prototype, prototype_names, prototype_text

    if name is None and out is not None:
        raise typer.BadParameter("--out needs the NAME of a prototype")
    if name is None:
        table = table_of("prototype", "microphones", "points", "description", numbers=(1, 2))
        for known in prototype_names():
            design = prototype(known)
            table.add_row(known, str(len(design.microphones)), str(design.point_count), design.description)
        show(table)
    elif out is None:
        print(prototype_text(name), end="")
    else:
        from studies.folders import check_new_file, write_text

        check_new_file(out)
        if out.exists():
            raise ValueError(f"{out}: exists; --out must be a new file, a design is never overwritten")
        write_text(out, prototype_text(name))


@app.command()
def check(
    design: Annotated[
        str | None,
        typer.Argument(metavar="DESIGN", help="A design file, or the name of a prototype.", show_default=False),
    ] = None,
    fields: Annotated[bool, typer.Option("--fields", help="List every field of a design file and stop.")] = False,
    out: Annotated[Path | None, typer.Option(help="Write the findings here as JSON too.", show_default=False)] = None,
) -> None:
    """Validate a design: counts, wiring, distinct cells, layout, printing, validity of the models, attenuation.

    Exit code 1 where the design is not valid or a print rule fails. Takes a few seconds: parts are drawn and
    measured, nothing is solved in 3-D.

    Example: [bold]acoustic-fem check mine.toml[/bold]
    """
    if fields:
        show_fields()
        return
    if design is None:
        raise typer.BadParameter("give a DESIGN, or --fields")
    from geometry import resolve_design
    from studies.check import check_design
    from studies.folders import check_new_file, write_json

    check_new_file(out)
    resolved = resolve_design(design)
    with _display() as display, display.stage("Check") as report:
        found = check_design(resolved, report)
    show_check(found)
    if out is not None:
        write_json(out, found.to_dict())
    if found.failures:
        more = len(found.failures) - 1
        raise ValueError(
            f"{found.design.name}: cannot be printed: {found.failures[0]}" + (f" (and {more} more)" if more else "")
        )


@app.command()
def solve(
    design: Design,
    out: Annotated[Path, typer.Option(help="The library to write, netCDF.", show_default=False)],
    fidelity: Annotated[
        Fidelity, typer.Option(help="lumped: closed forms, at once; navier-stokes: 3-D cells, the one to trust.")
    ] = Fidelity.navier_stokes,
    frequencies: Annotated[
        str, typer.Option(metavar="FIRST:LAST:COUNT", help="Frequencies in Hz, evenly spaced.")
    ] = "1:100:64",
) -> None:
    """Transfer functions from every point to every microphone.

    3-D cells are kept on disk and found again by every design that shares them. For a localizer take 1:500:500:
    its touches hold white noise up to 500 Hz.

    Example: [bold]acoustic-fem solve array-2x6 --out library.nc --fidelity lumped --frequencies 1:500:500[/bold]
    """
    grid = _frequencies(frequencies)
    import acoustic_fem
    from geometry import resolve_design
    from studies.folders import check_new_file
    from studies.run import cell_lines

    check_new_file(out)
    resolved = resolve_design(design)
    with _display() as display:
        with display.stage("Cells") as report:
            library = acoustic_fem.solve(resolved, grid, fidelity=fidelity.value, progress=report)
            acoustic_fem.save(library, out)
        for line in cell_lines(library):
            display.note(line)
    print(f"{out}: {resolved.point_count} points, {len(resolved.microphones)} microphones, {len(grid)} frequencies")


@app.command()
def parts(
    design: Design,
    out: Annotated[Path, typer.Option(help="The folder to write to.", show_default=False)],
    format: Annotated[str, typer.Option(metavar="FORMATS", help="Of stl, step and 3mf, with commas.")] = "stl,step,3mf",
) -> None:
    """Files to print and to cast, the tubes to cut, and what the print rules say.

    Example: [bold]acoustic-fem parts array-2x6 --out parts --format stl,3mf[/bold]
    """
    formats = [word.strip().lower() for word in format.split(",")]
    from geometry import build_parts, export, print_report, resolve_design
    from geometry.part_files import FORMATS
    from geometry.tube import cutting_list
    from studies.folders import check_folder

    check_folder(out)
    for word in formats:
        if word not in FORMATS:
            raise typer.BadParameter(f"--format: {word!r} must be of {', '.join(FORMATS)}, with commas")
    resolved = resolve_design(design)
    with _display() as display, display.stage("Parts") as report:
        report("CAD", 0.0)
        built = build_parts(resolved)
        report("files", 0.3)
        files = export(built, out, formats)
        report("print rules", 0.6)
        printing = print_report(built, resolved.printing.process)
    table = table_of("part", "count", "volume (mm^3)", "files", numbers=(1, 2))
    for name, count in built.counts.items():
        own = [file for file in files if file.part == name]
        table.add_row(name, str(count), f"{own[0].cad_volume:.1f}", ", ".join(file.path.name for file in own))
    show(table)
    table = table_of("tube", "count", "cut length (mm)", "bore (mm)", "outside (mm)", numbers=(1, 2, 3, 4))
    for cut in cutting_list(resolved):
        use = "between points" if cut.use == "segment" else "to a microphone"
        bore, outside = cut.tube.inner_diameter, cut.tube.outer_diameter
        table.add_row(use, str(cut.count), f"{cut.cut_length:g}", f"{bore:g}", f"{outside:g}")
    show(table)
    show_findings(printing)


@app.command()
def train(
    library: LibraryFile,
    out: Annotated[Path, typer.Option(help="The folder to write the localizer to.", show_default=False)],
    seconds: Annotated[float, typer.Option(help="Time limit; fewer epochs are run where they would take longer.")] = 60,
    epochs: Annotated[int, typer.Option(help="Epochs at most.")] = 10,
    noise: Annotated[float, typer.Option(help="Microphone noise in the touches, Pa rms over 0 to 500 Hz.")] = 1e-3,
    seed: Annotated[int, typer.Option(help="Of the touches and the network.")] = 0,
) -> None:
    """Train a localizer on touches made from a library.

    Example: [bold]acoustic-fem train library.nc --out localizer --seconds 30[/bold]
    """
    import acoustic_fem
    from localize import TrainingPlan
    from localize import train as train_localizer
    from studies.folders import check_folder

    check_folder(out)
    plan = TrainingPlan(time_limit=seconds, epochs=epochs, microphone_noise=noise, seed=seed)
    loaded = acoustic_fem.load(library)
    with _display() as display, display.stage("Localizer") as report:
        report("training", 0.0)
        localizer = train_localizer(
            loaded, plan, lambda p: report(f"epoch {p.epoch} of {p.epochs}: {p.accuracy:.1%}", p.epoch / p.epochs)
        )
        localizer.save(out)
    accuracy = localizer.training["held_out_accuracy"][-1]
    print(f"{out}: {localizer.training['epochs']} epochs, {accuracy:.1%} of held-out touches named right")


@app.command()
def evaluate(
    model: Annotated[
        Path, typer.Argument(metavar="MODEL", help="A localizer, from train or run (a folder).", show_default=False)
    ],
    library: LibraryFile,
    touches: Annotated[int, typer.Option(help="Held-out touches of every point.")] = 200,
    noise: Annotated[float, typer.Option(help="Microphone noise in the touches, Pa rms over 0 to 500 Hz.")] = 1e-3,
    seed: Annotated[int, typer.Option(help="Of the touches.")] = 0,
    out: Annotated[Path | None, typer.Option(help="Write the result here as JSON too.", show_default=False)] = None,
) -> None:
    """How often a localizer names the touched point, on touches it has never heard; the Bayes decoder beside it.

    Example: [bold]acoustic-fem evaluate localizer library.nc[/bold]
    """
    from threadpoolctl import threadpool_limits

    import acoustic_fem
    from localize import BayesDecoder, load_localizer
    from localize import evaluate as evaluate_localizer
    from studies.folders import check_new_file, write_json

    check_new_file(out)
    localizer = load_localizer(model)
    loaded = acoustic_fem.load(library)
    results: dict[str, Evaluation] = {}
    with _display() as display, display.stage("Evaluation") as report, threadpool_limits(1):
        report("network", 0.0)
        results["network"] = evaluate_localizer(localizer, loaded, touches, noise, seed=seed)
        report("Bayes decoder", 0.5)
        decoder = BayesDecoder(loaded, max(noise, 1e-6))
        results["Bayes decoder"] = evaluate_localizer(decoder, loaded, touches, noise, seed=seed)
    table = table_of("", "top-1 (%)", "top-2 (%)", "within one place (%)", "most confused", numbers=(1, 2, 3))
    for name, result in results.items():
        pair = result.hardest_pair
        confused = "none" if pair is None else f"points {pair[0]} and {pair[1]}, {100 * pair[2]:.1f} %"
        shares = (f"{100 * share:.1f}" for share in (result.top1, result.top2, result.within_one))
        table.add_row(name, *shares, confused)
    show(table)
    if out is not None:
        write_json(out, {name: result.to_dict() for name, result in results.items()})


@app.command()
def run(
    design: Design,
    out: Annotated[
        Path,
        typer.Option(help="A new or empty folder, or one of an earlier run, which is replaced.", show_default=False),
    ],
) -> None:
    """Everything for one design: parts, transfer functions, localizer, figures, and report.html.

    Takes about two minutes for twelve points; a second run finds its 3-D cells on disk.

    Example: [bold]acoustic-fem run array-2x6 --out demo[/bold], then open demo/report.html
    """
    from geometry import resolve_design
    from studies.folders import claim_folder
    from studies.results import verdict

    resolved = resolve_design(design)
    claim_folder(out)
    from studies.run import run_design

    with _display() as display:
        result = run_design(resolved, out, display=display)
    print(verdict(result))
    print(f"{out / 'report.html'}")


# -- what verbs share ---------------------------------------------------------------------------------------
def _display() -> Display:
    from studies.display import Display

    return Display(sys.stderr)


def _frequencies(text: str) -> Any:
    """The grid FIRST:LAST:COUNT, (n_freq,) float64, Hz; ranges are checked where the grid is used."""
    parts = text.split(":")
    try:
        first, last, count = float(parts[0]), float(parts[1]), int(parts[2])
        if len(parts) != 3 or not 1 <= count <= 100_000:
            raise ValueError
    except (ValueError, IndexError):
        raise typer.BadParameter(
            f"--frequencies: {text!r} must be FIRST:LAST:COUNT in Hz, such as 1:100:64, with COUNT from 1 to 100000"
        ) from None
    import numpy as np

    return np.linspace(first, last, count)


if __name__ == "__main__":
    main()
