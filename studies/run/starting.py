"""A design file of one's own, from what matters first: where it goes, how many points, how far apart, microphones."""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from geometry.design.array_design import ArrayDesign, validated
from geometry.design.changes import changed
from geometry.design.design_file import prototype, prototype_text, save_design, value_of
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Field, Kind, Refusal, Text
from geometry.ground.whole_files import write_text
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import OverlapError, refuse_overlaps, schematic_notes
from geometry.plan import cylinder, hand
from geometry.schema.field_errors import DesignError
from studies.output.folders import check_new_file


@dataclass(frozen=True)
class Place:
    """Place of a sensor, and the usual values there."""

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
    area: tuple[float, float] = (math.inf, math.inf)
    """Longer and shorter side of the area for the shells, mm; along a limb or a finger the first alone counts."""
    area_words: str = ""
    """The area in words."""


#: Places where a new design may go. The areas are assumed, those of a large hand and forearm.
PLACES = {
    "flat": Place("on a flat surface", "array-2x6", 12, 18.5, 2, "serpentine", "area"),
    "fingertip": Place(
        *("on a fingertip", "fingertip-3x4", 12, 4.0, 2, "serpentine", "area"),
        *((40.0, 35.0), "a fingertip takes shells on 40 x 35 mm"),
    ),
    "wrist": Place(
        *("around a wrist or a tool", "array-2x6", 12, 18.5, 2, "cylinder", "cylinder"),
        *((300.0, math.inf), "a wrist or a tool takes shells over a length of 300 mm"),
    ),
    "hand": Place(
        *("along the fingers of a glove", "glove", 12, 21.0, 3, "hand", "hand"),
        *((110.0, math.inf), "a hand takes shells on five fingers of 110 mm"),
    ),
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
#: Other designs that have room and are tried for one that can be built, and their most points, as it takes seconds with
#: more; their pitches are whole millimetres.
_TRIES, _TRIED_POINTS = 6, 300


@dataclass(frozen=True)
class _Asked:
    """Requirements of the design; lengths in mm."""

    name: str
    place: Place
    points: int
    pitch: float
    microphones: int
    diameter: float


def copy_prototype(name: str, out: str | os.PathLike[str]) -> Path:
    """Write the design file of a prototype, with its comments, as the start of a design of your own.

    Args:
        name: one of :func:`geometry.prototype_names`.
        out: a new file; an existing design file is never overwritten.

    Raises:
        Refusal: no prototype of that name, or a file that exists or cannot be written.
    """
    path = Path(out)
    check_new_file(path, ".toml", kept="a design")
    write_text(path, prototype_text(name))
    return path


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
    """Write a design that can be built and fits its place, made from the parts of a prototype.

    Tubes are straight and fill the distance between two cavities. If shells of the prototype's size would overlap, they
    are made smaller. Several grids are tried, beginning with half as many rows as columns. In a plane the last row may
    have fewer points, if a grid of full rows would be more than twice as long or as short.

    Args:
        name: name of the design.
        out: a new TOML file; by default NAME.toml.
        place: one of :data:`PLACES`.
        points: number of points; the default depends on the place.
        pitch: distance between neighbours along their tube, mm; around a wrist the straight distance is a few percent
            smaller. The default depends on the place.
        microphones: number of microphones; the default depends on the place.
        diameter: diameter of the wrist or tool that a ``wrist`` array goes around, mm.

    Returns:
        The design, as it is in the file.

    Raises:
        Refusal: a value out of range, values for which no layout can be built or fits the place (the message suggests
            the nearest values that fit), or a file that exists or cannot be written.
    """
    if place not in PLACES:
        raise Refusal(kind=Kind.UNKNOWN, field="place", value=place, allowed=tuple(PLACES))
    usual = PLACES[place]
    points = usual.points if points is None else points
    pitch = usual.pitch if pitch is None else pitch
    microphones = usual.microphones if microphones is None else microphones
    chosen = {"points": points, "pitch": pitch, "microphones": microphones, "diameter": diameter}
    for field, (least, most) in _LIMITS.items():
        check_range(field, chosen[field], least, most, whole=isinstance(least, int))
    if microphones > (most := _most_microphones(usual, points)):
        allowed = f"{'2' if most == 2 else f'from 2 to {most}'} for {points} points {usual.words}"
        raise Refusal(kind=Kind.CONFLICT, field="microphones", value=microphones, allowed=allowed)

    _from_base({"name": name}, prototype(usual.base).layout.model_dump(), usual.base)
    path = Path(f"{name}.toml" if out is None else out)
    if out is None and path.exists():
        problem = "exists, and a design is never overwritten"
        remedy = ("name another file with ", Field("out"), ", or remove this one")
        raise Refusal(problem, kind=Kind.EXISTS, file=path, remedy=remedy)
    check_new_file(path, ".toml", kept="a design")
    asked = _Asked(name, usual, points, pitch, microphones, diameter)
    design = _buildable(asked)
    if isinstance(design, Refusal):
        problem = f"with a pitch of {pitch:g} mm do not fit {usual.words}: {Refusal.of(design, file=None)}"
        raise Refusal(problem, kind=Kind.CONFLICT, field="points", value=points, remedy=_instead(asked))
    save_design(design, path)
    return design


def _most_microphones(place: Place, points: int) -> int:
    """A line from microphone to microphone has one point or more; on a hand two, and a finger of its own."""
    if place.layout == "hand":
        return max(min(points // 2, hand.FINGERS) + 1, 2)
    return min(points + 1, int(_LIMITS["microphones"][1]))


def _buildable(asked: _Asked) -> ArrayDesign | Refusal:
    """The first design of those that can be had whose parts are not in each other's way, or why there is none."""
    problem: Refusal | None = None
    for values, arranged in _candidates(asked):
        try:
            design = _from_base(values, arranged, _parts(asked.place, asked.pitch)[0])
            layout = lay_out(design)
            refuse_overlaps(design, layout)
            if notes := schematic_notes(design, layout):
                raise OverlapError.of_several([Refusal(note, kind=Kind.CONFLICT) for note in notes])
        except (DesignError, OverlapError) as error:
            problem = problem or error
        else:
            return design
    return problem or Refusal(asked.place.area_words, kind=Kind.CONFLICT)


def _instead(asked: _Asked) -> Text:
    """Remedy: the next numbers of points and the next pitches that fit, each with all else as asked."""
    (least, most), (closest, widest) = _LIMITS["points"], _LIMITS["pitch"]
    # more than these do not fit, however they lie
    long, short = (side / asked.pitch + 1 for side in asked.place.area)
    rows = {"hand": hand.FINGERS, "cylinder": math.pi * (asked.diameter / asked.pitch + 4)}.get(
        asked.place.layout, short
    )
    top = int(min(most, long * rows))
    counts = (range(min(asked.points - 1, top), int(least) - 1, -1), range(asked.points + 1, top + 1))
    steps = (range(math.ceil(asked.pitch) - 1, int(closest) - 1, -1), range(int(asked.pitch) + 1, int(widest) + 1))
    fields = {
        "points": [(replace(asked, points=count) for count in each) for each in counts],
        "pitch": [(replace(asked, pitch=pitch) for pitch in each) for each in steps],
    }
    found: list[str] = []
    for field, sides in fields.items():
        if known := [f"{getattr(each, field):g}" for each in map(_next, sides) if each]:
            found += [", or " if found else "try ", Field(field), f" = {' or '.join(known)}"]
    return tuple(found)


def _next(others: Iterable[_Asked]) -> _Asked | None:
    """The first of them that can be built, of the first few whose shells fit the place."""
    fitting = (each for each in others if each.points <= _TRIED_POINTS and next(_candidates(each), None))
    return next((each for each in itertools.islice(fitting, _TRIES) if not isinstance(_buildable(each), Refusal)), None)


def _fits(asked: _Asked, shell: Mapping[str, float], columns: int, lines: list[dict[str, Any]]) -> bool:
    """True if the shells of a layout lie within the area of the place."""
    each = [line["points"] for line in lines]
    rows = sum(math.ceil(points / columns) for points in ([sum(each)] if asked.place.joined == "area" else each))
    across, along = ((count - 1) * asked.pitch + shell["outer"] for count in (columns, rows))
    long, short = asked.place.area
    if asked.place.layout == "cylinder":
        radii = ((shell["inner"] / 2,) * 2, (shell["outer"] / 2,) * 2, asked.diameter / 2 + shell["port"])
        try:
            turn = cylinder.wound_turn(asked.pitch - shell["inner"], *radii)
        except Refusal:
            return False
        return along <= long and columns * turn <= 2 * math.pi
    if asked.place.layout == "hand":
        over = 2 * math.sin(math.radians(hand.SPREAD) / 2) * (hand.PALM + (columns - 1) * asked.pitch)
        reached = over <= asked.pitch or all(line["points"] <= columns for line in lines)
        return across <= long and rows <= hand.FINGERS and reached
    return max(across, along) <= long and min(across, along) <= short


def _parts(place: Place, pitch: float) -> tuple[str, float]:
    """Prototype whose parts are taken, and the distance of its neighbours, mm."""
    taken = PLACES["fingertip"] if pitch < _SMALL else place
    return taken.base, taken.pitch


def _from_base(values: dict[str, Any], layout: dict[str, Any], base: str) -> ArrayDesign:
    data = prototype(base).model_dump()
    data.update({key: value for key, value in values.items() if "." not in key}, layout=layout)
    dotted = {key: value for key, value in values.items() if "." in key}
    return validated(changed(data, dotted, str(values["name"])), str(values["name"]))


def _candidates(asked: _Asked) -> Iterator[tuple[dict[str, Any], dict[str, Any]]]:
    """Changes of a prototype by field, and the layout, of designs that fit the place and are tried in turn."""
    place, points, pitch = asked.place, asked.points, asked.pitch
    named, usual = _parts(place, pitch)
    base = prototype(named)
    own = {field: value_of(base, field) for field in _SCALED}
    outer = base.resonator.outer_diameter
    # the shells keep the share of the pitch that they have in the prototype, and are never larger than there
    fit = max(1.0, pitch / usual) if pitch < _SMALL else min(1.0, pitch / usual)
    names = [chr(ord("A") + k) for k in range(asked.microphones)]
    for size in _SIZES:
        scaled = {field: round(value * fit * size, 3) for field, value in own.items()}
        shell = {
            "inner": scaled["resonator.cavity_diameter"],
            "outer": outer * fit * size,
            "port": base.resonator.floor_thickness + base.resonator.port_axis_height * fit * size,
        }
        if shell["outer"] > pitch:
            continue
        length = round(pitch - scaled["resonator.cavity_diameter"], 3)
        values = {
            "name": asked.name,
            "description": f"{points} points {place.words}, {pitch:g} mm apart",
            "microphones": names,
            **scaled,
            "tube.length": length,
        }
        for layout in _layouts(place, points, asked.microphones, asked.diameter):
            lines = _lines(names, points, layout["columns"])
            if not _fits(asked, shell, layout["columns"], lines):
                continue
            yield {**values, "lines": lines}, layout
            if (longest_last := [line["points"] for line in reversed(lines)]) != [line["points"] for line in lines]:
                turned = zip(lines, longest_last, strict=True)
                yield {**values, "lines": [{**line, "points": count} for line, count in turned]}, layout


def _lines(names: list[str], points: int, columns: int) -> list[dict[str, Any]]:
    """A chain of lines from microphone to microphone, of whole rows where these suffice, as equal as can be."""
    pairs = list(itertools.pairwise(names))
    unit = columns if points % columns == 0 and points // columns >= len(pairs) else 1
    each, more = divmod(points // unit, len(pairs))
    return [{"between": list(pair), "points": unit * (each + (k < more))} for k, pair in enumerate(pairs)]


def _layouts(place: Place, points: int, microphones: int, diameter: float) -> Iterator[dict[str, Any]]:
    kind = place.layout if microphones == 2 else place.joined
    # rows half as many as columns; of a hand four fingers
    wished = points / 4 if kind == "hand" else math.sqrt(2 * points)

    def unlike(columns: int) -> float:
        return abs(math.log(columns / wished))

    def last(columns: int) -> tuple[bool, int, float]:
        # a last row that is not full, in the plane, rather than rows over twice as long or short
        return unlike(columns) > math.log(2), -points % columns, unlike(columns)

    broken = kind in ("serpentine", "area")
    possible = [
        columns
        for columns in range(1, points + 1)
        if points % columns == 0 or (broken and unlike(columns) <= math.log(2))
    ]
    for columns in sorted(possible, key=last):
        layout: dict[str, Any] = {"kind": kind, "columns": columns}
        if kind == "cylinder":
            layout["diameter"] = diameter
        yield layout
