"""What the verbs of the command line share: arguments, options and their readers."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from localize.noise import NoiseChoice
    from studies.display import Display


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
Frequencies = Annotated[str, typer.Option(metavar="FIRST:LAST:COUNT", help="Frequencies in Hz, evenly spaced.")]


def display_on_stderr() -> Display:
    """Progress for the user; what a verb finds goes to stdout."""
    from studies.display import Display

    return Display(sys.stderr)


def noise_choice(level: float | None) -> NoiseChoice:
    """``--noise`` as the localizer takes it."""
    return "design" if level is None else level


@contextmanager
def named(**options: str) -> Iterator[None]:
    """Call an argument in a refusal by the option that the user gave."""
    try:
        yield
    except ValueError as error:
        field = re.match(r"\w+", str(error))
        if field is None or field[0] not in options:
            raise
        raise ValueError(options[field[0]] + str(error)[field.end() :]) from None


def frequency_option(text: str) -> Any:
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
