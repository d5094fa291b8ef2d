"""The verb that lays an array on a body."""

from __future__ import annotations

from typing import Annotated

import typer

import studies
from geometry.ground.refusal import counted
from studies.cli.options import display_on_stderr
from studies.cli.terminal_tables import say, tell


def fit(
    design: Annotated[
        str, typer.Argument(metavar="DESIGN", help='Design file with a table [surface] and layout.kind = "surface".')
    ],
) -> None:
    """Lay an array on a body from your CAD, and write the places that the design names.

    Reads the body from STEP, STL, 3MF, OBJ or PLY. Points spread evenly over the region, each line joins near points
    without crossing, and microphones stand where there is room. Writes the file that layout.places names. Nothing of
    the body is repaired: if it does not do, the command says what to change in your CAD program. Guide: docs/robot.md.

    Example: [bold]acoustic-fem fit finger.toml[/bold], then acoustic-fem check finger.toml
    """
    with display_on_stderr() as display:
        fitted, places = studies.fit_design(design, display=display)
    for finding in fitted.findings:
        tell(f"- {finding}")
    tell(
        f"{fitted.design.name}: {counted(fitted.design.point_count, 'point')} laid without overlaps; no place of the "
        f"region is further than {fitted.uncovered:.2g} mm from a membrane"
    )
    say(places)
