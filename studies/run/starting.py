"""A design file of one's own, from what matters first: where it goes, how many points, how far apart, microphones."""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from geometry.refusal import Refusal
from studies.output.folders import check_new_file

if TYPE_CHECKING:
    from geometry.design.array_design import ArrayDesign


@dataclass(frozen=True)
class Place:
    """Where a sensor goes, and what is usual there."""

    words: str
    """The place in words."""
    base: str
    """Prototype whose parts are taken."""
    points: int
    """Usual number of points."""
    pitch: float
    """Usual distance of neighbours, mm."""
    microphones: int
    """Usual number of microphones."""
    layout: str
    """Kind of the layout with two microphones."""
    joined: str
    """Kind of the layout with more."""


#: Where a new design may go.
PLACES = {
    "flat": Place("on a flat surface", "array-2x6", 12, 18.5, 2, "serpentine", "area"),
    "fingertip": Place("on a fingertip", "fingertip-3x4", 12, 4.0, 2, "serpentine", "area"),
    "wrist": Place("around a wrist or a tool", "array-2x6", 12, 18.5, 2, "cylinder", "cylinder"),
    "hand": Place("along the fingers of a glove", "glove", 12, 21.0, 3, "hand", "hand"),
}
#: Below this pitch the parts are those of a fingertip, mm.
_SMALL = 9.0
#: Lengths that become smaller together with the pitch; other lengths stay, as tubes are bought.
_SCALED = (
    "resonator.cavity_diameter", "resonator.cavity_height", "resonator.wall_thickness", "membrane.thickness",
    "membrane.rim_width",
)  # fmt: skip
#: Sizes of the shells, against those of the prototype or as much of them as the pitch leaves, that are tried in turn.
_SIZES = (1.0, 0.9, 0.8, 0.7, 0.6, 0.5)
_LIMITS = {"points": (2, 1000), "pitch": (3.0, 100.0), "microphones": (2, 16), "diameter": (10.0, 500.0)}


def new_design(
    name: str,
    out: str | os.PathLike[str] | None = None,
    *,
    place: str = "flat",
    points: int | None = None,
    pitch: float | None = None,
    microphones: int | None = None,
    diameter: float = 60.0,
) -> ArrayDesign:
    """Write a design that can be built, made from the parts of a prototype.

    Tubes lie straight, as long as the pitch leaves between two cavities. Where shells of the prototype's size would be
    in each other's way they are made smaller; grids are tried from the most nearly square on.

    Args:
        name: of the design.
        out: a new TOML file; by default NAME.toml.
        place: one of :data:`PLACES`.
        points: number of points; by default what is usual at the place.
        pitch: distance of neighbours along their tube, mm, a few percent less in space around a wrist; by default
            what is usual at the place.
        microphones: number of microphones; by default what is usual at the place.
        diameter: of what a ``wrist`` array goes around, mm.

    Returns:
        The design, as it is in the file.

    Raises:
        Refusal: a value out of range, no layout of them that can be built, or a file that exists or cannot be written.
    """
    if place not in PLACES:
        raise Refusal(f"place = {place!r} must be of {', '.join(PLACES)}")
    usual = PLACES[place]
    points = usual.points if points is None else points
    pitch = usual.pitch if pitch is None else pitch
    microphones = usual.microphones if microphones is None else microphones
    chosen = {"points": points, "pitch": pitch, "microphones": microphones, "diameter": diameter}
    for field, (least, most) in _LIMITS.items():
        if not least <= chosen[field] <= most:
            raise Refusal(f"{field} = {chosen[field]:g} must be from {least:g} to {most:g}")
    path = Path(f"{name}.toml" if out is None else out)
    check_new_file(path, ".toml", kept="a design")
    design = _buildable(name, usual, points, pitch, microphones, diameter)
    from geometry.design.design_file import save_design

    save_design(design, path)
    return design


def _buildable(name: str, place: Place, points: int, pitch: float, microphones: int, diameter: float) -> ArrayDesign:
    """The first design of those that can be had whose parts are not in each other's way."""
    from geometry.layout.arrangement import lay_out
    from geometry.layout.overlaps import OverlapError, refuse_overlaps, schematic_notes
    from geometry.stated.fields import DesignError

    problem: Refusal | None = None
    for values, arranged in _candidates(name, place, points, pitch, microphones, diameter):
        try:
            design = _from_base(values, arranged, _parts(place, pitch)[0])
            layout = lay_out(design)
            refuse_overlaps(design, layout)
            if notes := schematic_notes(design, layout):
                raise OverlapError(*notes)
        except (DesignError, OverlapError) as error:
            problem = problem or error
        else:
            return design
    raise Refusal(f"{name}: no layout of {points} points {pitch:g} mm apart can be built: {problem}")


def _parts(place: Place, pitch: float) -> tuple[str, float]:
    """Prototype whose parts are taken, and the distance of its neighbours, mm."""
    taken = PLACES["fingertip"] if pitch < _SMALL else place
    return taken.base, taken.pitch


def _from_base(values: dict[str, Any], layout: dict[str, Any], base: str) -> ArrayDesign:
    from geometry.design.array_design import validated
    from geometry.design.changes import changed
    from geometry.design.design_file import prototype

    data = prototype(base).model_dump()
    data.update({key: value for key, value in values.items() if "." not in key}, layout=layout)
    dotted = {key: value for key, value in values.items() if "." in key}
    return validated(changed(data, dotted, str(values["name"])), str(values["name"]))


def _candidates(
    name: str, place: Place, points: int, pitch: float, microphones: int, diameter: float
) -> Iterator[tuple[dict[str, Any], dict[str, Any]]]:
    """Changes of a prototype by field, and the layout, of designs that are tried in turn."""
    from geometry.design.design_file import prototype, value_of

    named, usual = _parts(place, pitch)
    base = prototype(named)
    own = {field: value_of(base, field) for field in _SCALED}
    outer = base.resonator.outer_diameter
    # the shells keep the share of the pitch that they have in the prototype, and are never larger than there
    fit = max(1.0, pitch / usual) if pitch < _SMALL else min(1.0, pitch / usual)
    names = [chr(ord("A") + k) for k in range(microphones)]
    for size in _SIZES:
        scaled = {field: round(value * fit * size, 3) for field, value in own.items()}
        if outer * fit * size > pitch:
            continue
        length = round(pitch - scaled["resonator.cavity_diameter"], 3)
        values = {
            "name": name,
            "description": f"{points} points {place.words}, {pitch:g} mm apart",
            "microphones": names,
            **scaled,
            "tube.length": length,
        }
        for layout in _layouts(place, points, microphones, diameter):
            lines = _lines(names, points, layout["columns"])
            yield {**values, "lines": lines}, layout
            if (longest_last := [line["points"] for line in reversed(lines)]) != [line["points"] for line in lines]:
                turned = zip(lines, longest_last, strict=True)
                yield {**values, "lines": [{**line, "points": count} for line, count in turned]}, layout


def _lines(names: list[str], points: int, columns: int) -> list[dict[str, Any]]:
    """A chain of lines from microphone to microphone, of whole rows where these suffice, as equal as can be."""
    pairs = list(itertools.pairwise(names))
    unit = columns if points // columns >= len(pairs) else 1
    each, more = divmod(points // unit, len(pairs))
    return [{"between": list(pair), "points": unit * (each + (k < more))} for k, pair in enumerate(pairs)]


def _layouts(place: Place, points: int, microphones: int, diameter: float) -> Iterator[dict[str, Any]]:
    kind = place.layout if microphones == 2 else place.joined
    whole = [columns for columns in range(1, points + 1) if points % columns == 0]
    # rows half as many as columns; of a hand four fingers
    wished = points / 4 if kind == "hand" else math.sqrt(2 * points)
    for columns in sorted(whole, key=lambda columns: abs(math.log(columns / wished))):
        layout: dict[str, Any] = {"kind": kind, "columns": columns}
        if kind == "cylinder":
            layout["diameter"] = diameter
        yield layout
