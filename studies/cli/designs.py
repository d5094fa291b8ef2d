"""Verbs on a design: studio, check, wiring, solve, parts, run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

import acoustic_fem
import geometry
import studies
from acoustic_fem.quantities.fidelity import ONE_DESIGN, Fidelity
from geometry.formats.part_files import FORMATS
from geometry.ground.refusal import Kind, Refusal, counted, in_one_line
from studies.cli.check_tables import show_check
from studies.cli.options import Altitude, Design, Frequencies, OwnStock, Pressure, Temperature, display_on_stderr
from studies.cli.terminal_tables import (
    say,
    show,
    show_fields,
    show_findings,
    show_folded,
    show_library,
    show_parts,
    show_verdict,
    table_of,
    tell,
)
from studies.output.folders import as_picture, check_new_file
from studies.output.frequencies import LIBRARY_FREQUENCIES
from studies.verdict import worse_lines

#: Exit code of a design that is marginal.
_MARGINAL = 3

AllowOverlaps = Annotated[bool, typer.Option("--allow-overlaps", help="Continue although parts overlap.")]


def studio(
    design: Annotated[
        str, typer.Argument(metavar="[DESIGN]", help="A design file, or the name of a prototype.")
    ] = "array-2x6",
    port: Annotated[
        int | None, typer.Option(help="Port of the page; 0 for any. Default: 8765, or the next free one.")
    ] = None,
    host: Annotated[
        str,
        typer.Option(
            metavar="ADDRESS",
            help="Address of this machine at which the page opens. Other machines can reach "
            "the page unless you keep the default.",
        ),
    ] = "127.0.0.1",
    browser: Annotated[bool, typer.Option(help="Open the page in the browser.")] = True,
    own: OwnStock = None,
) -> None:
    """Edit a design in the browser and see at once what each change does.

    The page shows curves, the array in 3-D, the accuracy of each point and the print rules. If a value is not allowed,
    its field says why. Nothing leaves your machine, and nothing is written until you save. Press
    Ctrl-C to end. Guide: docs/studio.md.

    Example: [bold]acoustic-fem studio array-2x6[/bold]
    """
    studies.serve_studio(design, port=port, host=host, browser=browser)


def check(
    design: Annotated[
        str | None, typer.Argument(metavar="DESIGN", help="A design file, or the name of a prototype.")
    ] = None,
    fields: Annotated[bool, typer.Option("--fields", help="List every field of a design file, then stop.")] = False,
    out: Annotated[Path | None, typer.Option(help="JSON file to write the findings to.")] = None,
    picture: Annotated[
        Path | None, typer.Option(help="File to draw the predicted accuracy of each point in: .png, .pdf or .svg.")
    ] = None,
    own: OwnStock = None,
    fix: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE", help="New design file to write, with the changes that help most, one after the other."
        ),
    ] = None,
    full: Annotated[bool, typer.Option("--full", help="Print every table of the findings.")] = False,
) -> None:
    """Say whether a design will work, why not, and which change helps most.

    The verdict comes first: works, marginal or does not work, with the worst reasons and a computed remedy for each.
    Four figures follow: as-built accuracy of taps, smallest tap, size and cost. Every other table, such as the print
    rules and the parts to buy, is reduced to one line with its worst finding. --full prints the tables. The exit code
    is 0 if the design works, 3 if it is marginal, and 1 if it does not work or cannot be read. With --fix the exit code
    is that of the fixed design. Parts are drawn and measured but nothing is solved in 3-D, so it takes seconds. Guide:
    docs/verdict.md.

    Example: [bold]acoustic-fem check mine.toml --fix fixed.toml[/bold]
    """
    if fields:
        show_fields()
        return
    if design is None:
        raise typer.BadParameter("give a DESIGN, or --fields")
    if fix is not None:
        check_new_file(fix, ".toml", kept="a design", option="fix")
    with display_on_stderr() as display:
        found = studies.check_design(design, out, picture=picture, display=display)
    show_check(found, full=full)
    if picture is not None:
        say(as_picture(picture))
    verdict = found.verdict
    if fix is not None and verdict is not None:
        verdict = _fixed(verdict, fix)
    elif found.error is not None:
        raise found.error
    if verdict is not None:
        _end(verdict)


def _fixed(verdict: studies.Verdict, path: Path) -> studies.Verdict:
    """Verdict on the design with the remedies applied, which is written to a new file if there are any."""
    if verdict.outcome == "works":
        tell(f"the design works already, so nothing is changed and {path} is not written")
        return verdict
    with display_on_stderr() as display, display.stage("Fix") as report:
        verdict.compute(report, fixes=True)
        fixed = studies.Verdict(verdict.fixed())
        fixed.compute(report)
    if not verdict.fixes:
        tell(f"no change that was tried helps, so {path} is not written")
        return verdict
    for remedy in verdict.fixes:
        tell(f"changed: {remedy.words}")
    geometry.save_design(verdict.fixed(), path)
    say(path)
    for line in worse_lines(verdict, fixed):
        tell(line)
    show_verdict(fixed)
    return fixed


def _end(verdict: studies.Verdict) -> None:
    """End with exit code 3 if a design is marginal.

    Raises:
        Refusal: it does not work.
    """
    if verdict.outcome == "marginal":
        raise typer.Exit(_MARGINAL)
    if verdict.outcome == "does not work":
        reason = verdict.reasons[0]
        remedy = "" if reason.remedy is None else f"try {reason.remedy.words}"
        raise Refusal(f"does not work: {reason.words}", kind=Kind.UNSUITABLE, file=verdict.design.name, remedy=remedy)


def wiring(
    microphones: Annotated[int, typer.Argument(metavar="MICROPHONES", help="Number of microphones, 2 to 16.")],
    points: Annotated[int, typer.Argument(metavar="POINTS", help="Points on each line, 1 to 1000.")],
    out: Annotated[
        Path | None, typer.Option(help="File to draw the counts for 2 to MICROPHONES in: .png, .pdf or .svg.")
    ] = None,
) -> None:
    """Compare how many points a given number of microphones can serve with different wirings.

    Prints a row for every possible number of lines, and compares it with one transducer for each point and with rows
    and columns.

    Example: [bold]acoustic-fem wiring 4 36 --out wiring.png[/bold]
    """
    found = studies.wiring_table(microphones, points, out)
    table = table_of(
        "lines", "points", "compared with one transducer per point", "with rows + columns", numbers=(0, 1, 2, 3)
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
        say(as_picture(out))


def solve(
    design: Design,
    out: Annotated[Path, typer.Option(help="Library to write, netCDF (.nc). A measured one is never overwritten.")],
    fidelity: Annotated[
        Fidelity,
        typer.Option(
            help="lumped: closed forms, instant; atlas: corrected by a table of 3-D solutions; helmholtz: scalar 3-D "
            "cells, a cross-check; navier-stokes: 3-D cells, the reference."
        ),
    ] = ONE_DESIGN,
    frequencies: Frequencies = LIBRARY_FREQUENCIES,
    pressure: Pressure = None,
    altitude: Altitude = None,
    temperature: Temperature = None,
) -> None:
    """Compute the transfer functions from every point to every microphone.

    Writes a library. 3-D cells are kept on disk, so a cell that an earlier design had too is not solved again. The
    default frequencies are those that a localizer needs, because touches contain energy up to 500 Hz. Fewer
    frequencies save hardly any time.

    Give the altitude or the pressure of the place if it differs from the design's, because air matters: at 2000 m the
    signal of the far microphone of array-2x6 changes by up to 63 %.

    Example: [bold]acoustic-fem solve array-2x6 --out library.nc --fidelity lumped[/bold]
    """
    air = acoustic_fem.LocalAir(pressure, altitude, temperature)
    with display_on_stderr() as display:
        library = studies.solve_library(design, out, fidelity=fidelity, frequency=frequencies, air=air, display=display)
    show_library(out, library)


def parts(
    design: Design,
    out: Annotated[Path, typer.Option(help="Folder to write to.")],
    format: Annotated[
        str, typer.Option(metavar="FORMATS", help="File formats, with commas: stl, step, 3mf.")
    ] = ",".join(FORMATS),
    process: Annotated[
        str | None,
        typer.Option(
            metavar="PROCESS", help="Printing process to check for, a name or a .toml file. Default: the design's."
        ),
    ] = None,
    allow_overlaps: AllowOverlaps = False,
    own: OwnStock = None,
) -> None:
    """Write everything needed to print, cast, buy and assemble a design.

    Writes a folder for each job, in the order of work: 1-buy with the order list, 2-print with plates, single parts and
    print-report.html, 3-cast with the mold, 4-cut with a template at full scale, and 5-build with the build manual,
    the order of assembly, the array for CAD and browsers, and the record that calibrate reads back.

    Example: [bold]acoustic-fem parts array-2x6 --out parts --format stl,3mf[/bold]
    """
    formats = [word.strip().lower() for word in format.split(",")]
    for word in formats:
        if word not in FORMATS:
            raise typer.BadParameter(f"--format: {word!r} must be of {', '.join(FORMATS)}, with commas")
    with display_on_stderr() as display:
        made = studies.export_parts(
            design, out, formats=formats, process=process, allow_overlaps=allow_overlaps, display=display
        )
    show_parts(made)
    show_findings(made.printing)
    say(made.report)
    say(made.manual)


def run(
    design: Design,
    out: Annotated[Path, typer.Option(help="New or empty folder, or that of an earlier run, which is replaced.")],
    allow_overlaps: AllowOverlaps = False,
) -> None:
    """Do everything for one design: parts, transfer functions, localizer and report.

    Writes the folder of the verb parts, the library, the trained localizer, report.html, and MANIFEST.json with the
    SHA-256 of every file. Twelve points take about a minute. A second run is faster because its 3-D cells are on disk.
    Runs of one design on one machine give identical figures. The files are identical too if you set SOURCE_DATE_EPOCH,
    because the files then state that time instead of the clock's.

    Example: [bold]acoustic-fem run array-2x6 --out demo[/bold], then open demo/report.html
    """
    with display_on_stderr() as display:
        result = studies.run_design(design, out, allow_overlaps=allow_overlaps, display=display)
    show_verdict(result.verdict)
    show_folded("more, in report.html", studies.run.folded_sections(result).values())
    say(f"{out / 'report.html'}")


def verify(folder: Annotated[Path, typer.Argument(metavar="FOLDER", help="Folder of a run.")]) -> None:
    """Check that the folder of a run holds exactly the files that the run wrote.

    Compares every file with its SHA-256 in MANIFEST.json, which the run writes last. Lists the files that were changed,
    that are missing and that the run did not write; the exit code is then 1. A manifest does not
    replace a signature: it finds damage and accidents, but not a person who also rewrites the manifest.

    Example: [bold]acoustic-fem verify demo[/bold]
    """
    found = studies.verify_run(folder)
    table = table_of("file", "state")
    for state, names in (("changed", found.changed), ("missing", found.missing), ("extra", found.extra)):
        for name in names:
            table.add_row(in_one_line(name), state)
    if found.complete:
        tell(f"{counted(len(found.unchanged), 'file')}, all as the run wrote them")
        return
    show(table)
    raise Refusal(
        f"{len(found.changed)} changed, {len(found.missing)} missing and {len(found.extra)} extra "
        f"beside {counted(len(found.unchanged), 'unchanged file')}",
        kind=Kind.DAMAGED,
        file=folder,
    )
