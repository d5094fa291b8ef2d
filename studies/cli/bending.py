"""The verb bend."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from acoustic_fem.quantities.fidelity import Fidelity
from studies.bending.bending_rig import BendingRig
from studies.bending.bending_run import bending_study
from studies.bending.solution import Bending
from studies.cli.options import Frequencies, defaults_of, display_on_stderr, frequency_option, named
from studies.cli.terminal_tables import show, table_of
from studies.output.display import number
from studies.output.frequencies import FREQUENCIES

_FIDELITY: Fidelity = defaults_of(bending_study)["fidelity"]
_ANGLES = ",".join(f"{angle:g}" for angle in BendingRig.angles)


class FarEnd(StrEnum):
    """What closes the far end of the tube."""

    microphone = "microphone"
    closed = "closed"


def bend(
    out: Annotated[Path, typer.Option(help="The folder to write to.", show_default=False)],
    bore: Annotated[float, typer.Option(help="Inner diameter of the tube, mm.")] = BendingRig.bore,
    length: Annotated[float, typer.Option(help="Of the tube along its centre line, mm.")] = BendingRig.length,
    diameter: Annotated[
        float, typer.Option(help="Of the cylinder on which the centre line is wound, mm.")
    ] = BendingRig.diameter,
    outside: Annotated[
        float, typer.Option(help="Outer diameter of the tube, mm: the turns of a helix touch.")
    ] = BendingRig.outside,
    angles: Annotated[str, typer.Option(metavar="ANGLES", help="Degrees wound, with commas.")] = _ANGLES,
    end: Annotated[
        FarEnd, typer.Option(help="The far end: the microphone of array-2x6 in its chamber, or nothing.")
    ] = FarEnd[BendingRig.end],
    fidelity: Annotated[
        Fidelity,
        typer.Option(help="navier-stokes: the one to trust; helmholtz: makes the change 13 times too large."),
    ] = _FIDELITY,
    frequencies: Frequencies = FREQUENCIES,
) -> None:
    """Does a tube transmit less when it is bent? The publication's rig, the bent bore solved in 3-D.

    Level and phase of the pressure at the far end over that at the near end, and their differences to the straight
    tube: bending.png, bending.csv and bending.json. Takes about ten seconds.

    Example: [bold]acoustic-fem bend --out bending --angles 0,90,180,270,360[/bold]
    """
    grid = frequency_option(frequencies)
    wound = _angles(angles)
    names = ("bore", "length", "diameter", "outside", "angles", "end", "fidelity")
    with named(frequency="--frequencies", **{name: f"--{name}" for name in names}), display_on_stderr() as display:
        rig = BendingRig(bore, length, diameter, outside, wound, end.value)
        study = bending_study(out, rig, fidelity=fidelity, frequency=grid, display=display)
    _show_bending(study.result)
    for file in study.files:
        print(file)


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
    print(f"largest difference to the straight tube: {number(level)} dB, {number(phase)} degrees")
    if result.unknowns:
        print(
            f"mesh: {result.unknowns} unknowns; the differences are good to {100 * result.mesh_error:.2g} %, by a mesh "
            f"twice as coarse; {100 * result.straight_error:.2g} % of a straight bore's admittance taken out"
        )


def _angles(text: str) -> tuple[float, ...]:
    """Degrees; ranges are checked where they are used."""
    try:
        return tuple(float(word) for word in text.split(","))
    except ValueError:
        raise typer.BadParameter(
            f"--angles: {text!r} must be numbers of degrees with commas, such as 0,90,180"
        ) from None
