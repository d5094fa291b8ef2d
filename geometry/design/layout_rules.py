"""Rules of layouts: what a ring, an area, a cylinder and a hand need of the lengths of a design."""

from __future__ import annotations

from collections.abc import Iterator

from geometry.ground.refusal import Refusal
from geometry.plan import area, cylinder, hand, ring
from geometry.schema.array_fields import StatedArray


def plane_rules(design: StatedArray) -> Iterator[str]:
    """The pitch lets tubes reach; the lines of a ring join neighbours and close it."""
    resonator, layout = design.resonator, design.layout
    if layout.pitch is not None:
        shortest = min(
            tube.length for line in design.lines for tube in (design.inner_tubes_of(line) or (design.tube_of(line),))
        )
        reach = resonator.cavity_diameter + shortest
        if not resonator.outer_diameter <= layout.pitch <= reach + 1e-9:
            yield f"layout.pitch = {layout.pitch:g} mm {_pitch_must(layout.pitch, resonator.outer_diameter, reach)}"
    if layout.kind == "ring":
        count = len(design.microphones)
        if count < 3:
            yield f"layout.kind = 'ring' needs at least 3 microphones, the corners of a polygon; there are {count}"
        place = {name: index for index, name in enumerate(design.microphones)}
        for index, line in enumerate(design.lines):
            if (place[line.between[0]] - place[line.between[1]]) % count not in (1, count - 1):
                yield (
                    f"lines.{index}.between = {list(line.between)} must join neighbours of {list(design.microphones)} "
                    "for layout.kind = 'ring'"
                )
        sides = ring.side_lengths(design)
        lengths = [side for side in sides if side is not None]
        others = sum(lengths) - max(lengths)
        if len(lengths) == count and max(lengths) > (1 - 1e-9) * others:
            start = sides.index(max(lengths))
            pair = (design.microphones[start], design.microphones[(start + 1) % count])
            index = next(index for index, line in enumerate(design.lines) if set(line.between) == set(pair))
            yield (
                f"layout.kind = 'ring': lines.{index}, {max(lengths):g} mm from microphone to microphone, must be "
                f"shorter than the other lines together ({others:g} mm) for the ring to close"
            )


def _pitch_must(pitch: float, touching: float, straight: float) -> str:
    """What is wrong with a pitch, and one that can be built: where tubes are bowed, only the layout shows which can."""
    wrong = f"is below {touching:g} mm, where shells touch" if pitch < touching else "is more than its tubes reach"
    return f"{wrong}; it must be left out, or {straight:g} mm: the tubes then lie straight"


def area_rules(design: StatedArray) -> Iterator[str]:
    """The lines of an area follow each other over a grid, with straight tubes, and meet at its edge."""
    if design.layout.kind != "area":
        return
    if design.layout.pitch is not None:
        pitch = design.layout.pitch
        yield f"layout.pitch = {pitch:g} mm must not be given for layout.kind = 'area': its tubes never bow"
        return
    if not area.is_chain(design):
        yield (
            "lines must follow each other for layout.kind = 'area': each begins at the microphone at which the one "
            "before it ends, and no microphone joins more than two"
        )
        return
    if area.is_closed(design) and not area.has_way_back(design):
        yield (
            f"layout.columns = {design.layout.columns} must divide the {design.point_count} points into at least 2 "
            "rows for lines in a circle, of at least 2 points each, the number of points being even"
        )
        return
    inside = area.ends_inside(design)
    if inside:
        name = design.lines[inside[0]].between[1]
        yield (
            f"lines.{inside[0]}.points = {design.lines[inside[0]].points} puts microphone {name!r} between the points "
            "of an area; lines must end at its edge"
        )
        return
    for what, lengths in zip(("rows", "columns"), area.tube_lengths(design), strict=True):
        if len(lengths) > 1:
            yield (
                f"layout.kind = 'area' needs tubes of one length along its {what}; they have "
                f"{', '.join(f'{length:g}' for length in sorted(lengths))} mm"
            )
            return
    lacking, name = area.shortest_reach(design)
    if name:
        yield (
            f"microphone_tube.length must be larger: the two tubes that microphone {name!r} joins are {lacking:.3g} mm "
            "too short together to meet beside the area"
        )


def cylinder_rules(design: StatedArray) -> Iterator[str]:
    """A cylinder has a diameter, no pitch, and tubes that reach around it."""
    layout, resonator, chamber = design.layout, design.resonator, design.microphone
    if layout.kind != "cylinder":
        if layout.diameter is not None:
            yield f"layout.diameter = {layout.diameter:g} mm goes with layout.kind = 'cylinder', not {layout.kind!r}"
        return
    if layout.diameter is None:
        yield "layout.diameter is missing: layout.kind = 'cylinder' needs the diameter the shells stand on, in mm"
        return
    if layout.pitch is not None:
        yield f"layout.pitch = {layout.pitch:g} mm must not be given for layout.kind = 'cylinder': its tubes never bow"
    surface = cylinder.surface_of(design)
    assert isinstance(surface, cylinder.Cylinder)
    shell = (resonator.cavity_diameter / 2, resonator.outer_diameter / 2)
    housing = (chamber.chamber_diameter / 2, chamber.chamber_diameter / 2 + chamber.wall_thickness)
    for field, tube, to_microphone in design.stated_tubes():
        (inner, outer), (inner_end, outer_end) = shell, housing if to_microphone else shell
        try:
            cylinder.wound_turn(tube.length, (inner, inner_end), (outer, outer_end), surface.port_radius)
        except Refusal as error:
            yield f"{field}.length on a cylinder, layout.diameter = {layout.diameter:g} mm: {error}"


def hand_rules(design: StatedArray) -> Iterator[str]:
    """A hand has at most five fingers, tubes long enough to reach the next, and two points or more per line."""
    layout = design.layout
    if layout.kind != "hand":
        for field, value in (("palm", layout.palm), ("spread", layout.spread)):
            if value is not None:
                yield f"layout.{field} = {value:g} goes with layout.kind = 'hand', not {layout.kind!r}"
        return
    for index, line in enumerate(design.lines):
        if line.points == 1:
            yield (
                f"lines.{index}.points = 1 must be at least 2 for layout.kind = 'hand': both tubes of a finger's only "
                "point would leave towards the wrist"
            )
            return
    fingers = sum(hand.fingers_of(design))
    if fingers > hand.FINGERS:
        yield (
            f"layout.columns = {layout.columns} points per finger makes {fingers} fingers; must be enough for at most "
            f"{hand.FINGERS}, each line beginning on a finger of its own"
        )
        return
    beyond, longest = hand.longest_step(design)
    if beyond > 1e-9:
        yield (
            f"layout.spread = {layout.spread or hand.SPREAD:g} degrees must be smaller, or the tube of lines.{longest} "
            f"({design.tube_of(design.lines[longest]).length:g} mm) {beyond:.3g} mm longer, to reach the next finger"
        )
