"""Verbs that begin a design: prototypes, new."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from geometry.design.design_file import prototype_names, prototype_text, stated_prototype
from geometry.ground.refusal import counted
from geometry.layout.size import array_size
from studies.cli.options import asked, defaults_of
from studies.cli.terminal_tables import say, show, table_of, tell
from studies.run.starting import PLACES, copy_prototype, new_design

_PLACE: str = defaults_of(new_design)["place"]
_DIAMETER: float = defaults_of(new_design)["diameter"]


def prototypes(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="Prototype whose design file is printed.")
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Write the design file to this file instead.")] = None,
) -> None:
    """List the designs that come with the program, or print the file of one.

    Example: [bold]acoustic-fem prototypes array-2x6 --out mine.toml[/bold]
    """
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
        copy_prototype(name, out)


def new(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Name of the design.")],
    place: Annotated[
        str | None, typer.Option(help="Place of the array: flat, fingertip, wrist or hand. Default: flat.")
    ] = None,
    points: Annotated[int | None, typer.Option(help="Number of points. Default: 12.")] = None,
    pitch: Annotated[
        float | None,
        typer.Option(metavar="MM", help="Distance between neighbouring points. Default: depends on the place."),
    ] = None,
    microphones: Annotated[int | None, typer.Option(help="Number of microphones. Default: 2, or 3 on a hand.")] = None,
    diameter: Annotated[
        float | None, typer.Option(metavar="MM", help=f"Diameter of the wrist. Default: {_DIAMETER:g}.")
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Design file to write. Default: NAME.toml.")] = None,
) -> None:
    """Start a design of your own from its place, number of points, pitch and microphones.

    Writes a design file. On a terminal you are asked for the options that you did not give. The design takes its parts
    from a prototype, in a layout that can be built and that fits the place. You can change every value of the file.

    Example: [bold]acoustic-fem new mine --place wrist --points 16 --pitch 15[/bold]
    """
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
    say(path)
    size = " x ".join(f"{side:.0f}" for side in array_size(design))
    tell(f"{design.description}; {counted(len(design.microphones), 'microphone')}, {design.layout.kind}, {size} mm")
    tell(f"next: acoustic-fem check {path} --picture {path.with_suffix('.png')}")
