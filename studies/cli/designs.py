"""Verbs on a design: prototypes, studio, check, wiring, solve, parts, run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from acoustic_fem.quantities.fidelity import Fidelity
from geometry.formats.names import FORMATS
from geometry.ground.refusal import Refusal, counted
from studies.cli.options import (
    AIR_OPTIONS,
    Altitude,
    Design,
    Frequencies,
    Pressure,
    Temperature,
    asked,
    defaults_of,
    display_on_stderr,
    frequency_option,
    named,
)
from studies.cli.terminal_tables import (
    show,
    show_check,
    show_fields,
    show_findings,
    show_library,
    show_parts,
    table_of,
    tell,
)
from studies.output.frequencies import LIBRARY_FREQUENCIES
from studies.run.library_files import solve_library
from studies.run.starting import PLACES, new_design

AllowOverlaps = Annotated[bool, typer.Option("--allow-overlaps", help="Go on also where parts overlap.")]
_FIDELITY: Fidelity = defaults_of(solve_library)["fidelity"]
_PLACE: str = defaults_of(new_design)["place"]
_DIAMETER: float = defaults_of(new_design)["diameter"]


def prototypes(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="Print the design file of this one.", show_default=False)
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Write the design file here instead.", show_default=False)] = None,
) -> None:
    """List the designs that come with the program, or print one to start your own from.

    Example: [bold]acoustic-fem prototypes array-2x6 --out mine.toml[/bold]
    """
    from geometry.design.design_file import prototype_names, prototype_text, stated_prototype

    if name is None and out is not None:
        raise typer.BadParameter("--out needs the NAME of a prototype")
    if name is None:
        table = table_of("prototype", "microphones", "points", "description", numbers=(1, 2))
        for known in prototype_names():
            design = stated_prototype(known)
            table.add_row(known, str(len(design.microphones)), str(design.point_count), design.description)
        show(table)
    elif out is None:
        print(prototype_text(name), end="")
    else:
        from studies.run.prototypes import copy_prototype

        copy_prototype(name, out)


def new(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Of the design.", show_default=False)],
    place: Annotated[
        str | None,
        typer.Option(help="Where it goes: flat, fingertip, wrist or hand.", show_default="asked, or flat"),
    ] = None,
    points: Annotated[int | None, typer.Option(help="How many.", show_default="asked, or 12")] = None,
    pitch: Annotated[
        float | None,
        typer.Option(metavar="MM", help="Distance of neighbours.", show_default="asked, or usual at the place"),
    ] = None,
    microphones: Annotated[int | None, typer.Option(help="How many.", show_default="asked, or 2; 3 on a hand")] = None,
    diameter: Annotated[
        float | None,
        typer.Option(metavar="MM", help="Of what a wrist's goes around.", show_default=f"asked, or {_DIAMETER:g}"),
    ] = None,
    out: Annotated[Path | None, typer.Option(help="A new file.", show_default="NAME.toml")] = None,
) -> None:
    """Start a design of your own: where it goes, how many points, how far apart, how many microphones.

    What no option says is asked on a terminal, and usual elsewhere. The design has the parts of a prototype, in a
    layout that can be built and has room there; every value of the file is yours to change.

    Example: [bold]acoustic-fem new mine --place wrist --points 16 --pitch 15[/bold]
    """
    from geometry.layout.size import array_size

    place = asked(place, f"Where does it go ({', '.join(PLACES)})?", _PLACE) or _PLACE
    usual = PLACES.get(place)
    if usual is not None:  # an unknown place is refused below
        points = asked(points, "How many points?", usual.points)
        pitch = asked(pitch, "How far apart, mm?", usual.pitch)
        microphones = asked(microphones, "How many microphones?", usual.microphones)
        if usual.layout == "cylinder":
            diameter = asked(diameter, "Diameter of what it goes around, mm?", _DIAMETER)
    diameter = _DIAMETER if diameter is None else diameter
    design = new_design(name, out, place=place, points=points, pitch=pitch, microphones=microphones, diameter=diameter)
    path = out or Path(f"{name}.toml")
    print(path)
    size = " x ".join(f"{side:.0f}" for side in array_size(design))
    tell(f"{design.description}; {counted(len(design.microphones), 'microphone')}, {design.layout.kind}, {size} mm")
    tell(f"next: acoustic-fem check {path} --picture {path.with_suffix('.png')}")


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
    from geometry import resolve_design
    from studies.studio.serving import serve_studio

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
    from geometry import resolve_design
    from studies.run.check import check_design

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
    from studies.run.wiring import wiring_table

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
    from acoustic_fem.quantities.local_air import LocalAir
    from geometry import resolve_design

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
    from geometry import resolve_design
    from studies.run.part_folder import export_parts

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
    from geometry import resolve_design
    from studies.run.findings import verdict
    from studies.run.pipeline import check_points, run_design

    resolved = resolve_design(design)
    check_points(resolved, design)  # which names the file
    with display_on_stderr() as display:
        result = run_design(resolved, out, allow_overlaps=allow_overlaps, display=display)
    print(verdict(result))
    print(f"{out / 'report.html'}")
