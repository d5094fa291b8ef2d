"""The verb convert."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer


def convert(
    library: Annotated[
        Path, typer.Argument(metavar="LIBRARY", help="A library: .nc, .sofa, .npz or .csv.", show_default=False)
    ],
    out: Annotated[
        Path,
        typer.Option(help="The file to write, of another such suffix; a measured library is kept.", show_default=False),
    ],
) -> None:
    """A library in another format: netCDF, SOFA (AES69-2022, GeneralTF-E), NPZ or CSV, and back to the last digit.

    Example: [bold]acoustic-fem convert library.nc --out library.sofa[/bold]
    """
    from acoustic_fem.library.exchange import FORMATS, export, load_exchanged
    from studies.output.folders import check_new_library

    check_new_library(out, FORMATS)
    loaded = load_exchanged(library)
    export(loaded, out)
    points, microphones, frequencies = (loaded.transfer_function.sizes[k] for k in ("point", "microphone", "frequency"))
    print(f"{out}: {points} points, {microphones} microphones, {frequencies} frequencies")
