"""A circuit board as a KiCad project: a board file in the format of KiCad 7, and the project with the rules."""

from __future__ import annotations

import json
import uuid
from collections.abc import Iterator, Sequence
from itertools import pairwise

from geometry.boards.board_pieces import BoardPad, BoardPlan, PinMark
from geometry.boards.board_rules import BoardRules
from geometry.solids.stroke_font import Point

#: Version of the format, which KiCad 7 writes and later ones read.
_VERSION = 20221018
#: Middle of the sheet, where the axis of the chamber lies, mm; KiCad's y points down.
SHEET = (100.0, 100.0)
#: Space of the solder mask around a pad, mm.
MASK = 0.05
_NAMES = uuid.UUID("6f0b9d51-2f44-5a0c-9a53-6a1a5f3c9d11")
_LAYERS = (
    (0, "F.Cu", "signal"), (31, "B.Cu", "signal"), (34, "B.Paste", "user"), (35, "F.Paste", "user"),
    (36, "B.SilkS", "user"), (37, "F.SilkS", "user"), (38, "B.Mask", "user"), (39, "F.Mask", "user"),
    (41, "Cmts.User", "user"), (44, "Edge.Cuts", "user"), (46, "B.CrtYd", "user"), (47, "F.CrtYd", "user"),
    (48, "B.Fab", "user"), (49, "F.Fab", "user"),
)  # fmt: skip
_COPPER = {"top": "F.Cu", "bottom": "B.Cu"}


def kicad_board(plan: BoardPlan) -> str:
    """Text of the ``.kicad_pcb`` file of a board."""
    return "\n".join(["(kicad_pcb", *(f"  {line}" for line in _lines(plan)), ")"]) + "\n"


def kicad_project(plan: BoardPlan, name: str, rules: BoardRules | None = None) -> str:
    """Text of the ``.kicad_pro`` file of a board of that file name."""
    rules = rules or BoardRules()
    limits = {
        "min_clearance": rules.spacing,
        "min_copper_edge_clearance": rules.edge,
        "min_hole_clearance": rules.hole,
        "min_through_hole_diameter": rules.drill,
        "min_track_width": rules.track,
        "min_via_annular_width": rules.annular,
    }
    width = min(track.width for track in plan.tracks)
    default = {"name": "Default", "clearance": rules.spacing, "track_width": width}
    project = {
        "board": {"design_settings": {"rules": limits}},
        "meta": {"filename": f"{name}.kicad_pro", "version": 1},
        "net_settings": {"classes": [default], "meta": {"version": 3}},
    }
    return json.dumps(project, indent=2) + "\n"


def _lines(plan: BoardPlan) -> Iterator[str]:
    yield f'(version {_VERSION}) (generator "acoustic_fem")'
    yield f"(general (thickness {_number(plan.thickness)}))"
    yield '(paper "A4")'
    yield "(layers"
    for number, name, kind in _LAYERS:
        yield f'  ({number} "{name}" {kind})'
    yield ")"
    yield f"(setup (pad_to_mask_clearance {_number(MASK)}))"
    yield '(net 0 "")'
    for net in plan.nets:
        yield f'(net {_net(plan, net)} "{net}")'
    yield from _microphone(plan)
    yield from _part(plan, "J1", "connector, 1.27 mm", "through_hole")
    yield from _part(plan, "C1", "100 nF, 0402", "smd")
    tie = plan.tie_hole
    yield from _footprint("H1", tie.name, tie.centre, "through_hole", [_unplated(tie.diameter, (0.0, 0.0), "tie")])
    for start, end in pairwise((*plan.outline, plan.outline[0])):
        ends = f"(start {_place(start)}) (end {_place(end)})"
        yield (
            f'(gr_line {ends} (stroke (width 0.05) (type default)) (layer "Edge.Cuts") {_stamp("edge", *start, *end)})'
        )
    for track in plan.tracks:
        for start, end in pairwise(track.places):
            yield (
                f"(segment (start {_place(start)}) (end {_place(end)}) (width {_number(track.width)}) "
                f'(layer "{_COPPER[track.layer]}") (net {_net(plan, track.net)}) {_stamp(track.layer, *start, *end)})'
            )
    for via in plan.vias:
        yield (
            f"(via (at {_place(via.centre)}) (size {_number(via.diameter)}) (drill {_number(via.drill)}) "
            f'(layers "F.Cu" "B.Cu") (net {_net(plan, via.net)}) {_stamp("via", *via.centre)})'
        )
    about = (f"Board of microphone {plan.microphone}, {plan.title}", plan.source)
    for line, text in enumerate(about):
        place = (plan.outline[0][0], plan.outline[0][1] - 6 - 2 * line)
        yield (
            f'(gr_text "{_plain(text)}" (at {_place(place)}) (layer "Cmts.User") {_stamp("about", line)} '
            "(effects (font (size 1 1) (thickness 0.15))))"
        )
    for word in plan.words:
        font = f"(font (size {_number(word.height)} {_number(word.height)}) (thickness 0.1))"
        yield (
            f'(gr_text "{word.text}" (at {_place(word.centre)}) (layer "F.SilkS") {_stamp(word.text, *word.centre)} '
            f"(effects {font}))"
        )


def _microphone(plan: BoardPlan) -> Iterator[str]:
    """Footprint of the microphone: its pads, the ring, the sound hole and the outline of the package."""
    centre, ring = plan.sound_hole.centre, plan.ring
    mean, broad = (ring.inner + ring.outer) / 4, (ring.outer - ring.inner) / 2
    shapes = [_surface(plan, pad, centre) for pad in plan.pads if pad.part == "MK1"]
    # The anchor of a pad of free shape lies on its copper, so it stands on the ring and not in the hole.
    circle = f"(gr_circle (center {_number(-mean)} 0) (end 0 0) (width {_number(broad)}) (fill none))"
    shapes.append(
        f'(pad "{ring.number}" smd custom (at {_number(mean)} 0) (size {_number(broad)} {_number(broad)}) '
        f'(layers "F.Cu" "F.Paste" "F.Mask") (net {_net(plan, ring.net)} "{ring.net}") '
        f"(options (clearance outline) (anchor circle)) (primitives {circle}) {_stamp('ring', mean)})"
    )
    shapes.append(_unplated(plan.sound_hole.diameter, (0.0, 0.0), "sound hole"))
    low, high = ((x - centre[0], y - centre[1]) for x, y in plan.package)
    for name, layer, more in (("package", "F.Fab", 0.0), ("courtyard", "F.CrtYd", 0.1)):
        shapes.append(
            f"(fp_rect (start {_number(low[0] - more)} {_number(-high[1] - more)}) "
            f"(end {_number(high[0] + more)} {_number(-low[1] + more)}) (stroke (width 0.05) (type default)) "
            f'(fill none) (layer "{layer}") {_stamp(name, *low)})'
        )
    if plan.pin_mark is not None:
        shapes += [_dot(plan.pin_mark, centre, layer) for layer in ("F.SilkS", "F.Fab")]
    yield from _footprint("MK1", plan.microphone, centre, "smd", shapes)


def _dot(mark: PinMark, centre: Point, layer: str) -> str:
    """Mark of pin 1 in the coordinates of the footprint."""
    x, y = mark.centre[0] - centre[0], centre[1] - mark.centre[1]
    # The line is as wide as the radius it is drawn on, so that the disc is full in programs that fill nothing.
    return (
        f"(fp_circle (center {_number(x)} {_number(y)}) (end {_number(x + mark.diameter / 4)} {_number(y)}) "
        f"(stroke (width {_number(mark.diameter / 2)}) (type solid)) (fill none) "
        f'(layer "{layer}") {_stamp("pin 1", layer)})'
    )


def _part(plan: BoardPlan, name: str, value: str, kind: str) -> Iterator[str]:
    pads = [pad for pad in plan.pads if pad.part == name]
    centre = pads[0].centre
    yield from _footprint(name, value, centre, kind, [_surface(plan, pad, centre) for pad in pads])


def _footprint(name: str, value: str, centre: Point, kind: str, shapes: Sequence[str]) -> Iterator[str]:
    yield f'(footprint "acoustic-fem:{name}" (layer "F.Cu") {_stamp(name, *centre)}'
    yield f"  (at {_place(centre)})"
    yield f"  (attr {kind})"
    for role, text in (("reference", name), ("value", value)):
        font = "(effects (font (size 0.5 0.5) (thickness 0.08)))"
        yield f'  (fp_text {role} "{_plain(text)}" (at 0 0) (layer "F.Fab") {_stamp(name, role)} {font})'
    for shape in shapes:
        yield f"  {shape}"
    yield ")"


def _surface(plan: BoardPlan, pad: BoardPad, centre: Point) -> str:
    x, y = pad.centre[0] - centre[0], -(pad.centre[1] - centre[1])
    form = "circle" if pad.is_round else "rect"
    kind = f"thru_hole {form}" if pad.drill else f"smd {form}"
    layers = '"*.Cu" "*.Mask"' if pad.drill else '"F.Cu" "F.Paste" "F.Mask"'
    drill = f" (drill {_number(pad.drill)})" if pad.drill else ""
    return (
        f'(pad "{pad.number}" {kind} (at {_number(x)} {_number(y)}) (size {_number(pad.size[0])} '
        f'{_number(pad.size[1])}){drill} (layers {layers}) (net {_net(plan, pad.net)} "{pad.net}") '
        f"{_stamp(pad.part, pad.number)})"
    )


def _unplated(diameter: float, place: Point, name: str) -> str:
    size = _number(diameter)
    return (
        f'(pad "" np_thru_hole circle (at {_number(place[0])} {_number(place[1])}) (size {size} {size}) (drill {size}) '
        f'(layers "*.Cu" "*.Mask") {_stamp(name)})'
    )


def _net(plan: BoardPlan, name: str) -> int:
    return plan.nets.index(name) + 1


def _place(point: Point) -> str:
    """Place on the sheet, whose y points down."""
    return f"{_number(SHEET[0] + point[0])} {_number(SHEET[1] - point[1])}"


def _number(value: float) -> str:
    return f"{round(value, 6) + 0.0:.6f}".rstrip("0").rstrip(".")


def _plain(text: str) -> str:
    return text.replace("\\", "/").replace('"', "'")


def _stamp(*what: object) -> str:
    """Identity of a piece, the same in every writing of one board."""
    return f"(tstamp {uuid.uuid5(_NAMES, ' '.join(map(str, what)))})"
