"""Verbs on a design: studio, check, wiring, solve, parts, run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from acoustic_fem.quantities.fidelity import Fidelity
from acoustic_fem.quantities.local_air import LocalAir
from geometry import resolve_design
from geometry.formats.part_files import FORMATS
from geometry.ground.refusal import Refusal
from studies.cli.options import (
    AIR_OPTIONS,
    Altitude,
    Design,
    Frequencies,
    Pressure,
    Temperature,
    defaults_of,
    display_on_stderr,
    frequency_option,
    named,
)
from studies.cli.terminal_tables import show, show_check, show_fields, show_findings, show_library, show_parts, table_of
from studies.output.frequencies import LIBRARY_FREQUENCIES
from studies.run.check import check_design
from studies.run.findings import verdict
from studies.run.library_files import solve_library
from studies.run.part_folder import export_parts
from studies.run.pipeline import check_points, run_design
from studies.run.wiring import wiring_table
from studies.studio.serving import serve_studio

AllowOverlaps = Annotated[bool, typer.Option("--allow-overlaps", help="Go on also where parts overlap.")]
_FIDELITY: Fidelity = defaults_of(solve_library)["fidelity"]


def studio(
    design: Annotated[
        str, typer.Argument(metavar="[DESIGN]", help="A design file, or the name of a prototype.")
    ] = "array-2x6",
    port: Annotated[
        int | None, typer.Option(help="Port to listen at; 0 for any.", show_default="8765, or the next that is free")
    ] = None,
    host: Annotated[
        str, typer.Option(metavar="ADDRESS", help="Address to listen at; another one needs --token.")
    ] = "127.0.0.1",
    token: Annotated[
        str | None,
        typer.Option(help="Key in the page's address, 16 letters and digits or more.", show_default="a secret one"),
    ] = None,
    browser: Annotated[bool, typer.Option(help="Open the page in the browser.")] = True,
) -> None:
    """A page on this machine that shows what a change of a design does: curves, the array in 3-D, points, printing.

    Every field has a slider; what cannot be is refused beside it. Nothing leaves the machine. docs/studio.md says how
    to install what it needs. Ctrl-C ends.

    Example: [bold]acoustic-fem studio array-2x6[/bold]
    """
    serve_studio(resolve_design(design), port=port, host=host, token=token, browser=browser)


def check(
    design: Annotated[
        str | None,
        typer.Argument(metavar="DESIGN", help="A design file, or the name of a prototype.", show_default=False),
    ] = None,
    fields: Annotated[bool, typer.Option("--fields", help="List every field of a design file and stop.")] = False,
    out: Annotated[Path | None, typer.Option(help="Write the findings here as JSON too.", show_default=False)] = None,
    picture: Annotated[
        Path | None,
        typer.Option(help="Draw the array here, PNG: how well each point is told.", show_default=False),
    ] = None,
) -> None:
    """Validate a design and say how good it is: counts, wiring, layout, printing, validity of the models.

    What keeps it from being made comes first, then how often a touched point is named, nominal and mis-made; exit code
    1 where the design is not valid, parts are in each other's way, or a print rule fails. Takes seconds, half a minute
    for 200 points: parts are drawn and measured, nothing is solved in 3-D.

    Example: [bold]acoustic-fem check mine.toml[/bold]
    """
    if fields:
        show_fields()
        return
    if design is None:
        raise typer.BadParameter("give a DESIGN, or --fields")
    with display_on_stderr() as display:
        found = check_design(resolve_design(design), out, picture=picture, display=display)
    show_check(found)
    if picture is not None:
        print(picture)
    if found.objection is not None:
        raise Refusal(found.objection)


def wiring(
    microphones: Annotated[int, typer.Argument(metavar="MICROPHONES", help="How many, 2 to 16.", show_default=False)],
    points: Annotated[int, typer.Argument(metavar="POINTS", help="On each line, 1 to 1000.", show_default=False)],
    out: Annotated[Path | None, typer.Option(help="Draw 2 to so many microphones, PNG.", show_default=False)] = None,
) -> None:
    """How many points so many microphones serve, for every number of lines, against the usual wirings.

    Example: [bold]acoustic-fem wiring 4 36 --out wiring.png[/bold]
    """
    found = wiring_table(microphones, points, out)
    table = table_of(
        "lines", "points", "against one transducer per point", "against rows + columns", numbers=(0, 1, 2, 3)
    )
    for counts in found:
        table.add_row(
            str(counts.lines),
            str(counts.points),
            f"{counts.gain_over_one_transducer_per_point:.4g} times",
            f"{counts.gain_over_row_column:.4g} times",
        )
    show(table)
    if out is not None:
        print(out)


def solve(
    design: Design,
    out: Annotated[
        Path, typer.Option(help="The library to write, netCDF (.nc); a measured one is kept.", show_default=False)
    ],
    fidelity: Annotated[
        Fidelity,
        typer.Option(
            help="lumped: closed forms, at once; atlas: with what 3-D adds, from a table; helmholtz: scalar 3-D cells, "
            "a cross-check; navier-stokes: 3-D cells, the one to trust."
        ),
    ] = _FIDELITY,
    frequencies: Frequencies = LIBRARY_FREQUENCIES,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """Transfer functions from every point to every microphone.

    3-D cells are kept on disk and found again by every design that shares them. The frequencies are those that a
    localizer needs, whose touches hold sound up to 500 Hz; fewer take hardly less time.

    The air is the design's, but for what is said of the place: at 2000 m the far microphone of array-2x6 hears
    up to 63 % else.

    Example: [bold]acoustic-fem solve array-2x6 --out library.nc --fidelity lumped[/bold]
    """
    grid = frequency_option(frequencies)
    with display_on_stderr() as display, named(frequency="--frequencies", **AIR_OPTIONS):
        air = LocalAir(pressure, altitude, temperature)
        library = solve_library(
            resolve_design(design), out, fidelity=fidelity, frequency=grid, air=air, display=display
        )
    show_library(out, library)


def parts(
    design: Design,
    out: Annotated[Path, typer.Option(help="The folder to write to.", show_default=False)],
    format: Annotated[str, typer.Option(metavar="FORMATS", help="Of stl, step and 3mf, with commas.")] = ",".join(
        FORMATS
    ),
    process: Annotated[
        str | None,
        typer.Option(
            metavar="PROCESS",
            help="Judge for this printing process, a name or a .toml file; default: that of the design.",
            show_default=False,
        ),
    ] = None,
    allow_overlaps: AllowOverlaps = False,
) -> None:
    """Everything to print, cast, cut, buy and assemble, with pictures, and what the print rules say.

    Writes a file of every part and format, plates with all of them in the numbers needed, print-report.html, the
    bill of materials, the array as assembly.step, array.glb and array.html, and pictures.

    Example: [bold]acoustic-fem parts array-2x6 --out parts --format stl,3mf[/bold]
    """
    formats = [word.strip().lower() for word in format.split(",")]
    for word in formats:
        if word not in FORMATS:
            raise typer.BadParameter(f"--format: {word!r} must be of {', '.join(FORMATS)}, with commas")
    with display_on_stderr() as display:
        made = export_parts(
            resolve_design(design),
            out,
            formats=formats,
            process=process,
            allow_overlaps=allow_overlaps,
            display=display,
        )
    show_parts(made)
    show_findings(made.printing)
    print(made.report)


def run(
    design: Design,
    out: Annotated[
        Path,
        typer.Option(help="A new or empty folder, or one of an earlier run, which is replaced.", show_default=False),
    ],
    allow_overlaps: AllowOverlaps = False,
) -> None:
    """Everything for one design: parts, transfer functions, localizer, figures, and report.html.

    Takes about a minute for twelve points, where nothing else runs; a second run finds its 3-D cells on disk. Runs
    of one design on one machine give the same figures, however busy it is.

    Example: [bold]acoustic-fem run array-2x6 --out demo[/bold], then open demo/report.html
    """
    resolved = resolve_design(design)
    check_points(resolved, design)  # which names the file
    with display_on_stderr() as display:
        result = run_design(resolved, out, allow_overlaps=allow_overlaps, display=display)
    print(verdict(result))
    print(f"{out / 'report.html'}")
