"""The command line: one verb per job. Nothing heavy is imported before a verb needs it."""

from __future__ import annotations

import re
import signal
import sys
import traceback
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn, TextIO

import typer

from studies.tables import show, show_check, show_fields, show_findings, table_of

if TYPE_CHECKING:
    from localize import Evaluation
    from localize.noise import NoiseChoice
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
    helmholtz = "helmholtz"
    navier_stokes = "navier-stokes"


Design = Annotated[
    str, typer.Argument(metavar="DESIGN", help="A design file, or the name of a prototype.", show_default=False)
]
LibraryFile = Annotated[
    Path, typer.Argument(metavar="LIBRARY", help="A library, from solve or run (library.nc).", show_default=False)
]
Noise = Annotated[
    float | None,
    typer.Option(
        help="White noise of the microphones instead, Pa rms over 0 to 500 Hz.", show_default="that of the design's"
    ),
]
#: White noise that the Bayes decoder assumes where touches have less, Pa rms.
LEAST_NOISE = 1e-6


def main() -> NoReturn:
    """Run the command line: exit code 0; 1 with one line on stderr for bad input; 2 for a wrong command line."""
    warnings.showwarning = _show_warning
    signal.signal(signal.SIGTERM, _stop)
    try:
        app(prog_name="acoustic-fem")
    except KeyboardInterrupt:
        fail("stopped", 130)
    except (ValueError, OSError, RuntimeError) as error:
        if not _is_refusal(error):
            raise  # a mistake of the program: its traceback says where
        fail(f"{error.filename}: {error.strerror}" if isinstance(error, OSError) else str(error))
    sys.exit(0)


def _stop(*_: object) -> NoReturn:
    """End in order when told to: child programs are ended and temporary folders removed on the way out."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)  # a second one would cut that short
    fail("stopped", 143)


def _is_refusal(error: Exception) -> bool:
    """Whether an error tells the user what is wrong: one that our own code raises on purpose, or a file's."""
    if isinstance(error, OSError):
        return error.filename is not None
    if type(error) is RuntimeError:
        return False
    last = traceback.extract_tb(error.__traceback__)[-1]
    rooms = [Path(__file__).resolve().parents[1] / room for room in ("geometry", "acoustic_fem", "localize", "studies")]
    return Path(last.filename).resolve().parent in rooms and (last.line or "").startswith("raise ")


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
        Fidelity,
        typer.Option(
            help="lumped: closed forms, at once; helmholtz: scalar 3-D cells, a cross-check; "
            "navier-stokes: 3-D cells, the one to trust."
        ),
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
        with display.stage("Cells") as report, _named(frequency="--frequencies"):
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
    seconds: Annotated[
        float | None,
        typer.Option(
            help="Cut training short where it would take longer; the result then depends on the machine.",
            show_default="no limit",
        ),
    ] = None,
    epochs: Annotated[int, typer.Option(help="How many epochs, of 200 touches of every point.")] = 20,
    noise: Noise = None,
    seed: Annotated[int, typer.Option(help="Of the touches and the network.")] = 0,
) -> None:
    """Train a localizer on touches made from a library.

    Example: [bold]acoustic-fem train library.nc --out localizer --epochs 10[/bold]
    """
    import acoustic_fem
    from studies.folders import check_folder

    check_folder(out)
    from localize import TrainingPlan
    from localize import train as train_localizer
    from localize.dataset import response_of

    with _named(time_limit="--seconds", epochs="--epochs", microphone_noise="--noise", seed="--seed"):
        plan = TrainingPlan(time_limit=seconds, epochs=epochs, microphone_noise=_noise(noise), seed=seed)
    loaded = response_of(acoustic_fem.load(library))
    with _display() as display, display.stage("Localizer") as report:
        report("training", 0.0)
        localizer = train_localizer(
            loaded, plan, lambda p: report(f"epoch {p.epoch} of {p.epochs}: {p.accuracy:.1%}", p.epoch / p.epochs)
        )
        localizer.save(out)
    accuracy = localizer.training["held_out_accuracy"][-1]
    short = f", cut short by --seconds {seconds:g}" if localizer.training["cut_short"] else ""
    print(f"{out}: {localizer.training['epochs']} epochs{short}, {accuracy:.1%} of held-out touches named right")


@app.command()
def evaluate(
    model: Annotated[
        Path, typer.Argument(metavar="MODEL", help="A localizer, from train or run (a folder).", show_default=False)
    ],
    library: LibraryFile,
    touches: Annotated[int, typer.Option(help="Held-out touches of every point.")] = 200,
    noise: Noise = None,
    seed: Annotated[int, typer.Option(min=0, help="Of the touches.")] = 0,
    out: Annotated[Path | None, typer.Option(help="Write the result here as JSON too.", show_default=False)] = None,
) -> None:
    """How often a localizer names the touched point, on touches it has never heard; the Bayes decoder beside it.

    Example: [bold]acoustic-fem evaluate localizer library.nc[/bold]
    """
    import acoustic_fem
    from studies.folders import check_new_file, write_json

    check_new_file(out)
    from localize import BayesDecoder, load_localizer
    from localize import evaluate as evaluate_localizer
    from localize.dataset import response_of
    from localize.evaluation import check_evaluation

    localizer = load_localizer(model)
    loaded = response_of(acoustic_fem.load(library))
    level = _noise(noise)
    with _named(touches_per_point="--touches", microphone_noise="--noise"):
        check_evaluation(localizer, loaded, touches, level)
        decoder = BayesDecoder(loaded, level if level == "design" else max(level, LEAST_NOISE))
    results: dict[str, Evaluation] = {}
    with _display() as display, display.stage("Evaluation") as report:
        report("network", 0.0)
        results["network"] = evaluate_localizer(localizer, loaded, touches, level, seed=seed)
        report("Bayes decoder", 0.5)
        results["Bayes decoder"] = evaluate_localizer(decoder, loaded, touches, level, seed=seed)
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

    Takes about a minute for twelve points, where nothing else runs; a second run finds its 3-D cells on disk. Runs
    of one design on one machine give the same figures, however busy it is.

    Example: [bold]acoustic-fem run array-2x6 --out demo[/bold], then open demo/report.html
    """
    from geometry import resolve_design
    from studies.results import verdict
    from studies.run import check_points, run_design

    resolved = resolve_design(design)
    check_points(resolved, design)
    with _display() as display:
        result = run_design(resolved, out, display=display)
    print(verdict(result))
    print(f"{out / 'report.html'}")


# -- what verbs share ---------------------------------------------------------------------------------------
def _display() -> Display:
    from studies.display import Display

    return Display(sys.stderr)


def _noise(level: float | None) -> NoiseChoice:
    return "design" if level is None else level


@contextmanager
def _named(**options: str) -> Iterator[None]:
    """Call an argument in a refusal by the option that the user gave."""
    try:
        yield
    except ValueError as error:
        field = re.match(r"\w+", str(error))
        if field is None or field[0] not in options:
            raise
        raise ValueError(options[field[0]] + str(error)[field.end() :]) from None


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
