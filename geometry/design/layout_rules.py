"""Rules of layouts: what a ring, an area, a cylinder and a hand need of the lengths of a design."""

from __future__ import annotations

from collections.abc import Iterator

from geometry.ground.refusal import Kind, Refusal
from geometry.plan import area, cylinder, hand, ring
from geometry.schema.array_fields import StatedArray
from geometry.schema.field_errors import conflict


def plane_rules(design: StatedArray) -> Iterator[Refusal]:
    """The pitch lets tubes reach; the lines of a ring join neighbours and close it."""
    resonator, layout = design.resonator, design.layout
    if layout.pitch is not None:
        shortest = min(
            tube.length for line in design.lines for tube in (design.inner_tubes_of(line) or (design.tube_of(line),))
        )
        reach = resonator.cavity_diameter + shortest
        if not resonator.outer_diameter <= layout.pitch <= reach + 1e-9:
            # Where tubes are bowed only the layout shows which pitches can be built.
            touching = f"is below {resonator.outer_diameter:g} mm, where shells touch"
            yield conflict(
                "layout.pitch",
                layout.pitch,
                problem=touching if layout.pitch < resonator.outer_diameter else "is more than its tubes reach",
                remedy=f"leave it out, or give {reach:g} mm: the tubes then lie straight",
            )
    if layout.kind == "ring":
        count = len(design.microphones)
        if count < 3:
            problem = f"needs at least 3 microphones, the corners of a polygon, not {count}"
            yield conflict("layout.kind", "ring", problem=problem, unit="")
        place = {name: index for index, name in enumerate(design.microphones)}
        for index, line in enumerate(design.lines):
            if (place[line.between[0]] - place[line.between[1]]) % count not in (1, count - 1):
                yield Refusal(
                    f"must join neighbours of {list(design.microphones)} for layout.kind = 'ring'",
                    kind=Kind.CONFLICT,
                    field=f"lines.{index}.between",
                    value=list(line.between),
                )
        sides = ring.side_lengths(design)
        lengths = [side for side in sides if side is not None]
        others = sum(lengths) - max(lengths)
        if len(lengths) == count and max(lengths) > (1 - 1e-9) * others:
            start = sides.index(max(lengths))
            pair = (design.microphones[start], design.microphones[(start + 1) % count])
            index = next(index for index, line in enumerate(design.lines) if set(line.between) == set(pair))
            problem = (
                f"is {max(lengths):g} mm from microphone to microphone; it must be shorter than the other lines "
                f"together ({others:g} mm) for the ring to close"
            )
            yield conflict(f"lines.{index}", problem=problem)


def area_rules(design: StatedArray) -> Iterator[Refusal]:
    """The lines of an area follow each other over a grid, with straight tubes, and meet at its edge."""
    if design.layout.kind != "area":
        return
    if design.layout.pitch is not None:
        pitch = design.layout.pitch
        yield conflict("layout.pitch", pitch, problem="is not allowed for layout.kind = 'area': its tubes never bow")
        return
    if not area.is_chain(design):
        problem = (
            "must follow each other for layout.kind = 'area': each begins at the microphone at which the one before "
            "it ends, and no microphone joins more than two"
        )
        yield conflict("lines", problem=problem)
        return
    if area.is_closed(design) and not area.has_closed_path(design):
        yield Refusal(
            (
                f"must divide the {design.point_count} points into at least 2 rows for lines in a circle, of at least 2"
                " points each, the number of points being even"
            ),
            kind=Kind.CONFLICT,
            field="layout.columns",
            value=design.layout.columns,
        )
        return
    inside = area.ends_inside(design)
    if inside:
        name = design.lines[inside[0]].between[1]
        yield Refusal(
            f"puts microphone {name!r} between the points of an area",
            kind=Kind.CONFLICT,
            field=f"lines.{inside[0]}.points",
            value=design.lines[inside[0]].points,
            remedy="let lines end at its edge",
        )
        return
    for what, lengths in zip(("rows", "columns"), area.tube_lengths(design), strict=True):
        if len(lengths) > 1:
            found = ", ".join(f"{length:g}" for length in sorted(lengths))
            problem = f"needs tubes of one length along its {what}, which have {found} mm"
            yield conflict("layout.kind", "area", problem=problem, unit="")
            return
    lacking, name = area.shortest_reach(design)
    if name:
        yield Refusal(
            kind=Kind.CONFLICT,
            field="microphone_tube.length",
            allowed=(
                f"larger: the two tubes that microphone {name!r} joins are {lacking:.3g} mm too short together to meet "
                "beside the area"
            ),
        )


def cylinder_rules(design: StatedArray) -> Iterator[Refusal]:
    """A cylinder has a diameter, no pitch, and tubes that reach around it."""
    layout, resonator, chamber = design.layout, design.resonator, design.microphone
    if layout.kind != "cylinder":
        if layout.diameter is not None:
            problem = f"goes with layout.kind = 'cylinder', not {layout.kind!r}"
            yield conflict("layout.diameter", layout.diameter, problem=problem)
        return
    if layout.diameter is None:
        allowed = "given in mm, of the cylinder that the shells stand on, for layout.kind = 'cylinder'"
        yield Refusal(kind=Kind.MISSING, field="layout.diameter", allowed=allowed)
        return
    if layout.pitch is not None:
        problem = "is not allowed for layout.kind = 'cylinder': its tubes never bow"
        yield conflict("layout.pitch", layout.pitch, problem=problem)
    surface = cylinder.surface_of(design)
    assert isinstance(surface, cylinder.Cylinder)
    shell = (resonator.cavity_diameter / 2, resonator.outer_diameter / 2)
    housing = (chamber.chamber_diameter / 2, chamber.chamber_diameter / 2 + chamber.wall_thickness)
    for field, tube, to_microphone in design.stated_tubes():
        (inner, outer), (inner_end, outer_end) = shell, housing if to_microphone else shell
        try:
            cylinder.wound_turn(tube.length, (inner, inner_end), (outer, outer_end), surface.port_radius)
        except Refusal as error:
            where = f"on the cylinder of layout.diameter = {layout.diameter:g} mm"
            yield Refusal.of(error, field=f"{field}.length", allowed=f"{error.allowed} {where}")


def hand_rules(design: StatedArray) -> Iterator[Refusal]:
    """A hand has at most five fingers, tubes long enough to reach the next, and two points or more per line."""
    layout = design.layout
    if layout.kind != "hand":
        for field, value, unit in (("palm", layout.palm, "mm"), ("spread", layout.spread, "degrees")):
            if value is not None:
                problem = f"goes with layout.kind = 'hand', not {layout.kind!r}"
                yield conflict(f"layout.{field}", value, problem=problem, unit=unit)
        return
    for index, line in enumerate(design.lines):
        if line.points == 1:
            allowed = (
                "at least 2 for layout.kind = 'hand': both tubes of a finger's only point would leave towards the wrist"
            )
            yield conflict(f"lines.{index}.points", 1, allowed, unit="")
            return
    fingers = sum(hand.fingers_of(design))
    if fingers > hand.FINGERS:
        yield conflict(
            "layout.columns",
            layout.columns,
            problem=f"points per finger makes {fingers} fingers, each line beginning on a finger of its own",
            unit="",
            remedy=f"give enough for at most {hand.FINGERS}",
        )
        return
    beyond, longest = hand.longest_step(design)
    if beyond > 1e-9:
        length = design.tube_of(design.lines[longest]).length
        yield conflict(
            "layout.spread",
            layout.spread or hand.SPREAD,
            problem=f"is too wide for the tube of lines.{longest} ({length:g} mm) to reach the next finger",
            unit="degrees",
            remedy=f"give a smaller spread, or a tube that is {beyond:.3g} mm longer",
        )
