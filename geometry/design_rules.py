"""Rules between the fields of a design: combinations that cannot be built are refused by name."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from geometry import hand, ring, shell_rules, wrap
from geometry.materials import MATERIALS
from geometry.print_processes import process_of
from geometry.refusal import Refusal

if TYPE_CHECKING:
    from geometry.design import ArrayDesign
    from geometry.design_parts import Tube

#: Thinnest wall above and below the socket of a tube and between two ports, mm: less does not survive the glue.
SOCKET_COVER = 0.1
#: Most by which shims raise the lid of a mold, mm: the pins stay in their sockets.
MOST_SHIMS = 1.0


def check_consistency(design: ArrayDesign) -> None:
    """Refuse a design whose fields, each allowed alone, do not go together.

    Raises:
        Refusal: the first broken rule, with field, value and range.
    """
    for rule in (
        _materials,
        _membrane,
        _membrane_shape,
        _mold,
        _tubes,
        _sockets,
        shell_rules.cavity_shape,
        shell_rules.shell_features,
        _sound_hole,
        _board,
        _layout,
        _cylinder,
        _hand,
        _sockets_around_microphones,
        _print_rules,
    ):
        for message in rule(design):
            raise Refusal(message)


def _materials(design: ArrayDesign) -> Iterator[str]:
    for field, name in (
        ("membrane.material", design.membrane.material),
        ("printing.material", design.printing.material),
    ):
        if name not in design.materials and name not in MATERIALS:
            yield f"{field} = {name!r} must be one of: {', '.join(sorted({*MATERIALS, *design.materials}))}"


def _membrane(design: ArrayDesign) -> Iterator[str]:
    """What the shell holds, and the proportions that ``acoustic_fem.membrane.solve_disc`` covers.

    Its widest rim, 50 radii, is beyond every rim and cavity that the fields allow.
    """
    radius, thickness = design.resonator.cavity_diameter / 2, design.membrane.thickness
    cavity = f"of resonator.cavity_diameter ({2 * radius:g} mm)"
    if thickness < 0.01 * radius:
        yield f"membrane.thickness = {thickness:g} mm must be at least {0.01 * radius:g} mm, 0.01 radii {cavity}"
    mounted, stretch = design.membrane.mounted_thickness, design.membrane.stretch
    if mounted < 0.01 * radius * (1 - 1e-9) <= thickness:
        yield (
            f"membrane.stretch = {stretch:g} must be at most {math.sqrt(thickness / (0.01 * radius)):g}, where "
            f"membrane.thickness ({thickness:g} mm) is thinned to {0.01 * radius:g} mm, 0.01 radii {cavity}"
        )
    if thickness > 2 * radius:
        yield f"membrane.thickness = {thickness:g} mm must be at most {2 * radius:g} mm, 2 radii {cavity}"
    rim, wall = design.membrane.rim_width, design.resonator.wall_thickness
    if rim < 0.05 * thickness:
        yield (
            f"membrane.rim_width = {rim:g} mm must be at least {0.05 * thickness:g} mm, "
            f"a twentieth of membrane.thickness ({thickness:g} mm)"
        )
    if rim > wall:
        yield f"membrane.rim_width = {rim:g} mm must be at most resonator.wall_thickness ({wall:g} mm)"


def _membrane_shape(design: ArrayDesign) -> Iterator[str]:
    """A rim or a boss stands on the outer face of the disc; each has its own fields."""
    membrane, cavity = design.membrane, design.resonator.cavity_diameter
    for shape, names in (("rim", ("rim_height",)), ("boss", ("boss_diameter", "boss_height"))):
        for name in names:
            value = getattr(membrane, name)
            if membrane.shape == shape and value is None:
                yield f"membrane.{name} must be given, mm, for membrane.shape = {shape!r}"
            elif membrane.shape != shape and value is not None:
                yield f"membrane.{name} = {value:g} mm needs membrane.shape = {shape!r}; it is {membrane.shape!r}"
    if membrane.shape != "flat" and membrane.stretch != 1:
        yield (
            f"membrane.stretch = {membrane.stretch:g} must be 1 for membrane.shape = {membrane.shape!r}: "
            "only a flat disc is stretched evenly"
        )
    if membrane.total_height - membrane.thickness > cavity:
        name = "rim_height" if membrane.shape == "rim" else "boss_height"
        yield (
            f"membrane.{name} = {membrane.total_height - membrane.thickness:g} mm must be at most "
            f"resonator.cavity_diameter ({cavity:g} mm)"
        )
    if membrane.boss_diameter is not None and not 0.1 * cavity <= membrane.boss_diameter <= 0.9 * cavity + 1e-9:
        yield (
            f"membrane.boss_diameter = {membrane.boss_diameter:g} mm must be between {0.1 * cavity:g} and "
            f"{0.9 * cavity:g} mm, 0.1 to 0.9 of resonator.cavity_diameter ({cavity:g} mm)"
        )


def _mold(design: ArrayDesign) -> Iterator[str]:
    """Sloping walls leave at least half of a rim or boss; shims leave the pins in their sockets."""
    membrane, mold = design.membrane, design.mold
    slopes = [("membrane.rim_width", membrane.rim_width, membrane.total_height + (membrane.rim_height or 0.0))]
    if membrane.boss_diameter is not None and membrane.boss_height is not None:
        slopes.append(("membrane.boss_diameter", membrane.boss_diameter, 2 * membrane.boss_height))
    for field, width, height in slopes:
        steepest = math.degrees(math.atan(width / 2 / height))
        if mold.draft > steepest:
            yield (
                f"mold.draft = {mold.draft:g} degrees must be at most {steepest:.3g} degrees to leave half of {field} "
                f"({width:g} mm)"
            )
    raised = mold.shim_count * mold.shim_step
    if mold.kind == "two-part" and raised > MOST_SHIMS + 1e-9:
        yield (
            f"mold.shim_count = {mold.shim_count} must be at most {int(MOST_SHIMS / mold.shim_step + 1e-9)}: shims of "
            f"mold.shim_step = {mold.shim_step:g} mm may raise the lid by {MOST_SHIMS:g} mm"
        )
    if mold.vent_diameter > mold.groove_width:
        yield (
            f"mold.vent_diameter = {mold.vent_diameter:g} mm must be at most mold.groove_width "
            f"({mold.groove_width:g} mm), into which the vents lead"
        )


def _board(design: ArrayDesign) -> Iterator[str]:
    """The board carries the package and closes the chamber."""
    microphone = design.microphone
    narrowest = min(microphone.package_length, microphone.package_width)
    if microphone.sound_hole_diameter > narrowest:
        yield (
            f"microphone.sound_hole_diameter = {microphone.sound_hole_diameter:g} mm must be at most {narrowest:g} mm, "
            "the smaller of microphone.package_length and package_width, for the package to cover it"
        )
    for side in ("length", "width"):
        value, least = getattr(microphone, f"board_{side}"), getattr(microphone, f"least_board_{side}")
        if value is not None and value < least - 1e-9:
            yield (
                f"microphone.board_{side} = {value:g} mm must be at least {least:g} mm to cover package, chamber and "
                "gasket"
            )
    if microphone.gasket_width is not None:
        for field, tube, to_microphone in _tubes_of(design):
            deepest = microphone.chamber_height / 2 - tube.outer_diameter / 2 - design.printing.glue_gap - SOCKET_COVER
            if to_microphone and microphone.gasket_depth > deepest + 1e-9:
                yield (
                    f"microphone.gasket_depth = {microphone.gasket_depth:g} mm must be at most {deepest:.3g} mm to "
                    f"stay {SOCKET_COVER:g} mm above the socket of {field}"
                )


def _tubes(design: ArrayDesign) -> Iterator[str]:
    """What a tube is in itself, and what it needs of the parts at its ends."""
    resonator, chamber, lip = design.resonator, design.microphone, design.printing.port_lip
    for field, tube, to_microphone in _tubes_of(design):
        if tube.inner_diameter >= tube.outer_diameter:
            yield (
                f"{field}.inner_diameter = {tube.inner_diameter:g} mm must be below {field}.outer_diameter "
                f"({tube.outer_diameter:g} mm)"
            )
        if tube.spring_outer_diameter > tube.outer_diameter + 1e-9:
            yield (
                f"{field}.wire_diameter = {tube.wire_diameter:g} mm must be at most "
                f"{(tube.outer_diameter - tube.inner_diameter) / 2:g} mm, the wall between bore and outside"
            )
        if tube.outer_diameter > resonator.cavity_height:
            yield (
                f"{field}.outer_diameter = {tube.outer_diameter:g} mm must be at most resonator.cavity_height "
                f"({resonator.cavity_height:g} mm)"
            )
        if tube.inner_diameter > resonator.cavity_diameter / 2:
            yield (
                f"{field}.inner_diameter = {tube.inner_diameter:g} mm must be at most half of "
                f"resonator.cavity_diameter ({resonator.cavity_diameter / 2:g} mm)"
            )
        if to_microphone and tube.inner_diameter > chamber.chamber_diameter / 2:
            yield (
                f"{field}.inner_diameter = {tube.inner_diameter:g} mm must be at most half of "
                f"microphone.chamber_diameter ({chamber.chamber_diameter / 2:g} mm)"
            )
        if tube.length < 2 * tube.stub_length:
            yield (
                f"{field}.length = {tube.length:g} mm must be at least {2 * tube.stub_length:g} mm, "
                "8 bore radii: shorter tubes have no plane-wave part"
            )
        walls = resonator.wall_thickness + (chamber if to_microphone else resonator).wall_thickness
        if tube.length <= walls:
            yield f"{field}.length = {tube.length:g} mm must be above {walls:g} mm, the two walls it passes through"
        if tube.length <= 2 * lip:
            yield f"{field}.length = {tube.length:g} mm must be above {2 * lip:g} mm, the lips of its two ports"


def _sockets(design: ArrayDesign) -> Iterator[str]:
    """Tubes are glued in sockets: counterbores that leave a lip towards the air."""
    resonator, chamber, printing = design.resonator, design.microphone, design.printing
    for field, tube, to_microphone in _tubes_of(design):
        hole = tube.outer_diameter / 2 + printing.glue_gap
        bore = tube.inner_diameter / 2
        lowest = max(bore, hole + SOCKET_COVER - resonator.floor_thickness)
        highest = resonator.cavity_height - hole - SOCKET_COVER
        if highest < lowest:
            widest = 2 * (resonator.cavity_height - bore - printing.glue_gap - SOCKET_COVER)
            yield (
                f"{field}.outer_diameter = {tube.outer_diameter:g} mm must be at most {widest:g} mm for its socket to "
                f"fit beside resonator.cavity_height ({resonator.cavity_height:g} mm)"
            )
        axis = resonator.port_axis_height
        if not lowest - 1e-9 <= axis <= highest + 1e-9:
            given = resonator.port_height is not None
            yield (
                f"resonator.port_height = {axis:g} mm {'' if given else '(the default, mid height) '}must be between "
                f"{lowest:g} and {highest:g} mm for the socket of {field} to stay in the wall"
            )
        if to_microphone and hole + SOCKET_COVER > chamber.chamber_height / 2 + 1e-9:
            yield (
                f"{field}.outer_diameter = {tube.outer_diameter:g} mm must be at most "
                f"{chamber.chamber_height - 2 * (printing.glue_gap + SOCKET_COVER):g} mm for its socket to fit beside "
                f"microphone.chamber_height ({chamber.chamber_height:g} mm)"
            )
        walls = [("resonator", resonator.cavity_diameter / 2, resonator.wall_thickness)]
        if to_microphone:
            walls.append(("microphone", chamber.chamber_diameter / 2, chamber.wall_thickness))
        for part, inside, wall in walls:
            deepest = _socket_depth(inside + wall, hole) - inside
            if printing.port_lip >= deepest:
                yield (
                    f"printing.port_lip = {printing.port_lip:g} mm must be below {deepest:g} mm, what "
                    f"{part}.wall_thickness ({wall:g} mm) leaves beside the socket of {field}"
                )


def _socket_depth(outside: float, hole: float) -> float:
    """Distance from the axis of a round shell to where a socket of that radius is wholly in its wall."""
    return math.sqrt(max(outside**2 - hole**2, 0.0))


def _sound_hole(design: ArrayDesign) -> Iterator[str]:
    chamber = design.microphone
    if chamber.sound_hole_diameter >= chamber.chamber_diameter:
        yield (
            f"microphone.sound_hole_diameter = {chamber.sound_hole_diameter:g} mm must be below "
            f"microphone.chamber_diameter ({chamber.chamber_diameter:g} mm)"
        )


def _layout(design: ArrayDesign) -> Iterator[str]:
    resonator, layout = design.resonator, design.layout
    if layout.pitch is not None:
        shortest = min(design.tube_of(line).length for line in design.lines)
        reach = resonator.cavity_diameter + shortest
        if not resonator.outer_diameter <= layout.pitch <= reach + 1e-9:
            yield (
                f"layout.pitch = {layout.pitch:g} mm must be between {resonator.outer_diameter:g} mm (shells touch) "
                f"and {reach:g} mm (tubes straight)"
            )
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


def _cylinder(design: ArrayDesign) -> Iterator[str]:
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
    surface = wrap.surface_of(design)
    assert isinstance(surface, wrap.Cylinder)
    shell = (resonator.cavity_diameter / 2, resonator.outer_diameter / 2)
    housing = (chamber.chamber_diameter / 2, chamber.chamber_diameter / 2 + chamber.wall_thickness)
    for field, tube, to_microphone in _tubes_of(design):
        (inner, outer), (inner_end, outer_end) = shell, housing if to_microphone else shell
        try:
            wrap.wound_turn(tube.length, (inner, inner_end), (outer, outer_end), surface.port_radius)
        except ValueError as error:
            yield f"{field}.length on a cylinder, layout.diameter = {layout.diameter:g} mm: {error}"


def _hand(design: ArrayDesign) -> Iterator[str]:
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


def _sockets_around_microphones(design: ArrayDesign) -> Iterator[str]:
    """Lines enter a chamber at equal angles, at a corner of a ring along its two sides, in a palm as they meet."""
    chamber, printing = design.microphone, design.printing
    at_corners = design.layout.kind == "ring"
    angles = ring.corner_angles(ring.corners(ring.side_lengths(design))) if at_corners else None
    for index, name in enumerate(design.microphones):
        ends = [design.microphone_tube_of(line) for line in design.lines if name in line.between]
        if len(ends) > 1:
            apart = 360 / len(ends) if angles is None else float(angles[index])
            if design.layout.kind == "hand":
                apart = hand.meeting_angle(design, name) or apart
            hole = max(tube.outer_diameter for tube in ends) / 2 + printing.glue_gap
            bore = max(tube.inner_diameter for tube in ends) / 2
            half = math.radians(min(apart, 360 - apart)) / 2
            # Sockets begin at the lip, bores where the round wall ends beside them; nearest are their inner corners.
            socket, mouth = ((SOCKET_COVER / 2 + r * math.cos(half)) / math.sin(half) for r in (hole, bore))
            least = 2 * max(socket - printing.port_lip, math.hypot(mouth, bore))
            if chamber.chamber_diameter < least - 1e-9:
                yield (
                    f"microphone.chamber_diameter = {chamber.chamber_diameter:g} mm must be at least {least:.4g} mm "
                    f"for the ports of the {len(ends)} lines that end at {name!r} to fit around it, "
                    f"{apart:.4g} degrees apart with {SOCKET_COVER:g} mm of wall between them"
                )


def _print_rules(design: ArrayDesign) -> Iterator[str]:
    """A rule's advice is on the safe side of its limit."""
    try:
        process_of(design.printing)
    except ValueError as error:
        yield f"printing.{error}"


def _tubes_of(design: ArrayDesign) -> Iterator[tuple[str, Tube, bool]]:
    """Every tube a design states: name of its field, itself, whether it leads to a microphone."""
    yield "tube", design.tube, False
    yield "microphone_tube", design.microphone_tube, True
    for index, line in enumerate(design.lines):
        if line.tube is not None:
            yield f"lines.{index}.tube", line.tube, False
        if line.microphone_tube is not None:
            yield f"lines.{index}.microphone_tube", line.microphone_tube, True
