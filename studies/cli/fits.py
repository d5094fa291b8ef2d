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
    """Lay an array on a body from your CAD program, and write the place of every part to a file.

    Reads the body from STEP, STL, 3MF, OBJ or PLY. Spreads the points evenly over the region, connects neighbouring
    points into lines that do not cross, and finds room for the microphones. Writes the file that layout.places names.
    A body is never repaired. If it cannot be used, the command says what to change in your CAD program. Guide:
    docs/robot.md.

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
