"""The verb bend."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

import studies
from acoustic_fem.quantities.fidelity import ONE_DESIGN, Fidelity
from studies.bending.bending_rig import BendingRig
from studies.cli.options import Frequencies, display_on_stderr
from studies.cli.terminal_tables import say, show, table_of
from studies.output.display import number
from studies.output.frequencies import FREQUENCIES

if TYPE_CHECKING:
    from studies.bending.solution import Bending

_ANGLES = ",".join(f"{angle:g}" for angle in BendingRig.angles)


class FarEnd(StrEnum):
    """Termination of the far end of the tube."""

    microphone = "microphone"
    closed = "closed"


def bend(
    out: Annotated[Path, typer.Option(help="Folder to write to.")],
    bore: Annotated[float, typer.Option(help="Inner diameter of the tube, mm.")] = BendingRig.bore,
    length: Annotated[float, typer.Option(help="Length of the tube along its centre line, mm.")] = BendingRig.length,
    diameter: Annotated[
        float, typer.Option(help="Diameter of the cylinder on which the centre line is wound, mm.")
    ] = BendingRig.diameter,
    outside: Annotated[
        float,
        typer.Option(help="Outer diameter of the tube, mm, and so the pitch of the helix, because its turns touch."),
    ] = BendingRig.outside,
    angles: Annotated[str, typer.Option(metavar="ANGLES", help="Bending angles in degrees, with commas.")] = _ANGLES,
    end: Annotated[
        FarEnd, typer.Option(help="Far end: the microphone of array-2x6 in its chamber, or closed.")
    ] = FarEnd[BendingRig.end],
    fidelity: Annotated[
        Fidelity,
        typer.Option(help="navier-stokes is the reference; with helmholtz the computed change is 13 times too large."),
    ] = ONE_DESIGN,
    frequencies: Frequencies = FREQUENCIES,
) -> None:
    """Compute how much less a tube transmits when it is bent.

    Repeats the publication's test, with the bent bore solved in 3-D. Writes bending.png, bending.csv and bending.json:
    level and phase of the pressure at the far end over that at the near end, and their differences from the straight
    tube. Takes about ten seconds.

    Example: [bold]acoustic-fem bend --out bending --angles 0,90,180,270,360[/bold]
    """
    rig = BendingRig(bore, length, diameter, outside, _angles(angles), end.value)
    with display_on_stderr() as display:
        study = studies.bending_study(out, rig, fidelity=fidelity, frequency=frequencies, display=display)
    _show_bending(study.result)
    for file in study.files:
        say(file)


def _show_bending(result: Bending) -> None:
    grid = result.frequency
    table = table_of(
        "bent over", "arc (mm)", "largest difference (dB)", "(degrees)",
        f"Y12 of the bend at {grid[0]:g} Hz (%)", f"at {grid[-1]:g} Hz (%)", numbers=(0, 1, 2, 3, 4, 5),
    )  # fmt: skip
    rows = zip(result.rig.angles, result.largest_differences, result.bend_change, strict=True)
    for angle, (level, phase), change in rows:
        arc = result.rig.winding(angle).arc_length
        values = (arc, level, phase, *(100 * abs(change[k]) for k in (0, -1)))
        table.add_row(f"{angle:g} degrees", *(number(value) for value in values))
    show(table)
    level, phase = result.largest_differences.max(axis=0)
    say(f"largest difference from the straight tube: {number(level)} dB, {number(phase)} degrees")
    if result.unknowns:
        say(
            f"mesh: {result.unknowns} unknowns; the differences are accurate to {100 * result.mesh_error:.2g} %, "
            "estimated with a mesh twice as coarse; an error of "
            f"{100 * result.straight_error:.2g} % is subtracted, that of a straight bore"
        )


def _angles(text: str) -> tuple[float, ...]:
    """Degrees; ranges are checked where they are used."""
    try:
        return tuple(float(word) for word in text.split(","))
    except ValueError:
        raise typer.BadParameter(
            f"--angles: {text!r} must be numbers of degrees with commas, such as 0,90,180"
        ) from None
