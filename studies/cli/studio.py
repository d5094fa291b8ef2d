"""The verb studio."""

from __future__ import annotations

from typing import Annotated

import typer


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
