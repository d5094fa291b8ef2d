"""Rules of stated lengths and of frozen places: every tube and part has one, and tubes reach."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Iterator

from geometry.design.kind_rules import GRADED_LAYOUTS
from geometry.design.shell_rules import membrane_top
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.plan.frozen import frame_of
from geometry.plan.frozen_ways import ways_of
from geometry.schema.array_fields import StatedArray
from geometry.schema.field_errors import conflict
from geometry.schema.frozen_fields import FrozenPart, FrozenPlaces
from geometry.schema.part_fields import STUB_LENGTH_IN_RADII
from geometry.schema.surface_fields import SurfaceFit

#: How far a stated course may be from the length of its tube: a fraction of it, and mm.
_NEAR = (0.02, 0.05)
#: What to do where the places are not those of the design.
_AGAIN = "fit again"


def length_rules(design: StatedArray) -> Iterator[Refusal]:
    """A line that states lengths has one for each tube, each long enough for its walls."""
    walls = design.resonator.wall_thickness
    for number, line in enumerate(design.lines):
        if line.lengths is None:
            continue
        field = f"lines.{number}.lengths"
        if len(line.lengths) != line.points + 1:
            problem = f"has {counted(len(line.lengths), 'length')} for {counted(line.points + 1, 'tube')}"
            yield conflict(field, problem=problem, remedy=f"give {line.points + 1}, one more than points")
            return
        if design.layout.kind not in GRADED_LAYOUTS:
            yield conflict(
                field,
                problem=f"is not allowed for layout.kind = {design.layout.kind!r}, whose tubes have one length",
                remedy=f"choose a layout.kind of: {', '.join(GRADED_LAYOUTS)}",
            )
            return
        for segment, tube in enumerate(design.tubes_of(line)):
            end = segment in (0, line.points)
            through = walls + (design.microphone if end else design.resonator).wall_thickness
            least = max(STUB_LENGTH_IN_RADII * tube.inner_diameter, through, 2 * design.printing.port_lip)
            if tube.length <= least - 1e-9 or tube.length <= through:
                allowed = f"above {least:g} mm, for its walls, its lips and 8 bore radii"
                yield conflict(f"{field}.{segment}", tube.length, allowed)
                return


def surface_rules(design: StatedArray) -> Iterator[Refusal]:
    """Frozen places are those of the design, and its tubes reach between them."""
    layout, frozen = design.layout, design.layout.frozen
    if layout.kind != "surface":
        if frozen is not None:
            yield conflict("layout.frozen", problem=f"goes with layout.kind = 'surface', not {layout.kind!r}")
        return
    if frozen is None:
        yield Refusal(
            kind=Kind.MISSING,
            field="layout.places",
            allowed="the name of a file of places, for layout.kind = 'surface'",
            remedy="acoustic-fem fit writes one",
        )
        return
    if layout.pitch is not None:
        problem = "is not allowed for layout.kind = 'surface', whose places are frozen"
        yield conflict("layout.pitch", layout.pitch, problem=problem, remedy="change [surface], and fit again")
        return
    for rule in (_counts, _inputs, _sizes, _frames):
        found = next(rule(design, frozen), None)
        if found is not None:
            yield found
            return
    yield from _tubes(design, frozen)


def _counts(design: StatedArray, frozen: FrozenPlaces) -> Iterator[Refusal]:
    tubes = sum(line.points + 1 for line in design.lines)
    for field, parts, count, what in (
        ("points", frozen.points, design.point_count, "point"),
        ("microphones", frozen.microphones, len(design.microphones), "microphone"),
        ("tubes", frozen.tubes, tubes if frozen.tubes else 0, "tube"),
        ("cells", frozen.cells, design.point_count if frozen.cells else 0, "point"),
    ):
        if len(parts) != count:
            problem = f"has {counted(len(parts), 'place')} for {counted(count, what)}"
            yield conflict(f"layout.frozen.{field}", problem=problem, remedy=_AGAIN)
    for number, cell in enumerate(frozen.cells):
        if list(cell.distances) != sorted(cell.distances) or cell.distances[0] < 0:
            problem = "must be zero or more, in ascending order"
            yield conflict(f"layout.frozen.cells.{number}.distances", problem=problem)
    for number, point in enumerate(frozen.points):
        yield from _ports(f"layout.frozen.points.{number}.ports", point, 2, "a point")
    for number, (name, part) in enumerate(zip(design.microphones, frozen.microphones, strict=True)):
        ends = sum(line.between.count(name) for line in design.lines)
        yield from _ports(f"layout.frozen.microphones.{number}.ports", part, ends, f"microphone {name!r}")


def _ports(field: str, part: FrozenPart, count: int, what: str) -> Iterator[Refusal]:
    if len(part.ports) != count:
        problem = f"has {counted(len(part.ports), 'direction')}; {what} has {counted(count, 'tube')}"
        yield conflict(field, problem=problem)


def _sizes(design: StatedArray, frozen: FrozenPlaces) -> Iterator[Refusal]:
    for field, (name, value) in sizes_of(design).items():
        made_for = getattr(frozen.sizes, field)
        near = _FLUSH if field == "membrane_height" else 0.0
        if made_for is not None and not math.isclose(made_for, value, rel_tol=1e-9, abs_tol=near):
            problem = f"makes the {name} {value:g} mm; the frozen places were fitted for {made_for:g} mm"
            yield conflict(_STATED_BY[field], problem=problem, remedy=_AGAIN)


#: Field of a design that sets each of the frozen sizes.
_STATED_BY = {
    "shell_diameter": "resonator.wall_thickness",
    "cavity_diameter": "resonator.cavity_diameter",
    "chamber_diameter": "microphone.chamber_diameter",
    "seat_length": "microphone.board_length",
    "seat_width": "microphone.board_width",
    "floor_thickness": "resonator.floor_thickness",
    "membrane_height": "resonator.cavity_height",
}
#: Fields of ``[surface]`` that the first fitted places did not have, with the values that describe what they were
#: fitted to. These are no defaults: if a default changes one day, places that were fitted before are not taken for new.
_LATER = {"tubes": "as they lie"}
#: How far membranes may stand above or below a body in whose pockets their shells lie, mm; assumed.
_FLUSH = 0.1


def sizes_of(design: StatedArray) -> dict[str, tuple[str, float]]:
    """Words and value, mm, of the sizes that frozen places are made for, by their fields."""
    microphone = design.microphone
    seat = [side + 2 * (microphone.board_gap + microphone.wall_thickness) for side in microphone.board_size]
    upright = {}
    if design.surface is not None and design.surface.seat == "in":
        upright["membrane_height"] = ("tops of the membranes above the floors of the cavities", membrane_top(design))
    elif design.surface is not None:
        upright["floor_thickness"] = ("floors", design.resonator.floor_thickness)
    return {
        "cavity_diameter": ("cavities", design.resonator.cavity_diameter),
        "shell_diameter": ("shells", design.resonator.outer_diameter),
        "chamber_diameter": ("chambers", microphone.chamber_diameter),
        "seat_length": ("length of the microphones' seats", seat[0]),
        "seat_width": ("width of the microphones' seats", seat[1]),
        **upright,
    }


#: Fields whose values fix the outside of parts, and so the places that a fit found for them.
_FITTED = (
    "layout.pitch",
    "resonator.cavity_diameter",
    "resonator.wall_thickness",
    "microphone.chamber_diameter",
    "microphone.wall_thickness",
    "microphone.board_length",
    "microphone.board_width",
    "microphone.board_gap",
)
#: The same of shells in pockets of the body, and of shells on it.
_FITTED_BY_SEAT = {"in": "resonator.cavity_height", "on": "resonator.floor_thickness"}


def check_variable(design: StatedArray, name: str) -> None:
    """Refuse to vary a field of a design that frozen places or stated lengths have settled.

    Args:
        design: the array.
        name: dotted name of one of its fields.

    Raises:
        Refusal: the places were fitted for the field's value, or lengths of the lines take its place.
    """
    group, _, field = name.rpartition(".")
    fitted = (*_FITTED, *(() if design.surface is None else (_FITTED_BY_SEAT[design.surface.seat],)))
    if design.layout.frozen is not None and (name in fitted or group.partition(".")[0] == "surface"):
        problem = "cannot vary, because the places of the array were fitted for its value"
        raise conflict(name, problem=problem, remedy="change it in the design, and fit again for each value")
    if field == "length" and all(line.lengths is not None for line in design.lines):
        problem = "changes nothing, because every line states the lengths of its tubes"
        raise conflict(name, problem=problem, remedy="leave it out")


def inputs_of(stated: SurfaceFit) -> str:
    """SHA-256 of what an array is fitted to."""
    # A later field counts if it says anything new, so that places stay valid that were fitted before there was one.
    later = {name for name, before in _LATER.items() if getattr(stated, name) == before}
    return hashlib.sha256(stated.model_dump_json(exclude=later).encode()).hexdigest()


def _inputs(design: StatedArray, frozen: FrozenPlaces) -> Iterator[Refusal]:
    if design.surface is not None and frozen.inputs and frozen.inputs != inputs_of(design.surface):
        yield conflict("surface", problem="has changed since the places were fitted", remedy=_AGAIN)


def _frames(design: StatedArray, frozen: FrozenPlaces) -> Iterator[Refusal]:
    seen: dict[tuple[float, float], str] = {}
    for group in ("points", "microphones"):
        for number, part in enumerate(getattr(frozen, group)):
            field = f"layout.frozen.{group}.{number}"
            try:
                frame_of(part)
            except Refusal as error:
                yield Refusal.of(error, field=f"{field}.{error.field}")
            if part.plan in seen:
                problem = f"is also that of {seen[part.plan]}; every part needs a place of its own in the plan"
                yield conflict(f"{field}.plan", list(part.plan), problem=problem)
            seen[part.plan] = field


def _tubes(design: StatedArray, frozen: FrozenPlaces) -> Iterator[Refusal]:
    """Tubes reach from wall to wall, and stated courses have their length."""
    ways, number = ways_of(design, frozen), 0
    shortest = ways.shortest.tolist()
    for index, line in enumerate(design.lines):
        for segment, tube in enumerate(design.tubes_of(line)):
            course = frozen.tubes[number].course if frozen.tubes else ()
            field = design.tube_fields_of(index)[segment]
            field = field if line.lengths is not None else f"{field}.length"
            if course:
                length = sum(map(math.dist, course[:-1], course[1:]))
                if abs(length - tube.length) > _NEAR[0] * tube.length + _NEAR[1]:
                    problem = f"is {tube.length:.4g} mm; its stated course is {length:.4g} mm long"
                    yield conflict(field, problem=problem)
                    return
            elif tube.length < shortest[number] - 1e-6:
                allowed = f"at least {shortest[number]:.4g} mm to reach between the frozen places"
                yield conflict(field, tube.length, allowed)
                return
            number += 1
