"""The parts of an array: each distinct shape once, how many of it, and where they go."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeVar

import numpy as np

import geometry
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design, write_design
from geometry.design.shell_rules import ledge_height
from geometry.ground.typed import Array
from geometry.layout.arrangement import lay_out
from geometry.layout.placement import ArrayLayout, MicrophonePlacement, PointPlacement
from geometry.molds.mold import MoldKind, build_mold, mold_counts, mold_kinds, molds_of
from geometry.plan.cylinder import FLAT, Axes
from geometry.schema.manufacture import Printing
from geometry.schema.part_fields import Membrane, Resonator
from geometry.schema.ports import Port
from geometry.solids.membrane import build_membrane, membrane_radius

if TYPE_CHECKING:
    import cadquery as cq


_T = TypeVar("_T")

#: Kind of a part of an array.
PartKind = Literal["shell", "carrier", "membrane", "housing", "board", "package", "spring", "sheath", "base"] | MoldKind
#: Where a part comes from.
Origin = Literal["printed", "cast", "bought"]
#: Kinds that are not printed.
_ORIGINS: dict[PartKind, Origin] = {
    "membrane": "cast",
    "board": "bought",
    "package": "bought",
    "spring": "bought",
    "sheath": "bought",
}


class PartSet(dict[str, "cq.Workplane"]):
    """Parts by name, each in its own coordinates (mm), with what they were generated from.

    ``parameters`` has for each part the numbers and words written into its 3MF file: what matters most of it.
    ``design_toml`` is the text of the whole design, written into each 3MF file too, from which :func:`build_parts`
    draws the parts again; empty for parts of no array. ``counts`` has how many of it one array needs, 0 for single
    shells beside a carrier. ``kinds`` has what each part is, for parts of an array: where it comes from, and what
    is put into it, follow from that. ``placed`` has where every copy lies, as :func:`place_parts` gives it.
    """

    def __init__(self) -> None:
        super().__init__()
        self.design_toml = ""
        self.parameters: dict[str, dict[str, float | int | str]] = {}
        self.counts: dict[str, int] = {}
        self.kinds: dict[str, PartKind] = {}
        self.placed: tuple[PlacedPart, ...] = ()

    def origin(self, name: str) -> Origin:
        """Origin of a part; a part of no kind is printed."""
        kind = self.kinds.get(name)
        return "printed" if kind is None else _ORIGINS.get(kind, "printed")

    def only(self, *names: str) -> PartSet:
        """Some of the parts, in this order, with all that is known of them.

        Raises:
            KeyError: no part has the name.
        """
        chosen = PartSet()
        chosen.update({name: self[name] for name in names})
        chosen.design_toml = self.design_toml
        chosen.parameters = {name: self.parameters[name] for name in names if name in self.parameters}
        chosen.counts = {name: self.counts[name] for name in names if name in self.counts}
        chosen.kinds = {name: self.kinds[name] for name in names if name in self.kinds}
        chosen.placed = tuple(part for part in self.placed if part.part in names)
        return chosen


def part_set(parts: Mapping[str, cq.Workplane]) -> PartSet:
    """Parts of an array as they are; any others as parts of no kind, of which nothing is known but their names."""
    if isinstance(parts, PartSet):
        return parts
    plain = PartSet()
    plain.update(parts)
    return plain


@dataclass(frozen=True)
class PlacedPart:
    """One copy of a part in the array: turned about its z by ``rotation`` degrees, laid along ``axes``, moved (mm)."""

    part: str
    """Name of the part."""
    kind: PartKind
    """Kind of the part."""
    label: str
    """Name of this copy."""
    position: tuple[float, float, float]
    """Position of the origin of its own coordinates, mm."""
    rotation: float
    """Angle by which it is turned about its own z, degrees."""
    axes: Axes = FLAT
    """Directions of its x, y and z, as rows; on a flat array those of its own coordinates."""
    group: str = ""
    """Owner of the part: ``point 3``, ``microphone A``, ``tube 2 of line 1``."""

    @property
    def matrix(self) -> Array:
        """The (4, 4) float64 matrix that moves the part into place, mm."""
        cos, sin = math.cos(math.radians(self.rotation)), math.sin(math.radians(self.rotation))
        matrix = np.eye(4)
        matrix[:3, :3] = np.array(self.axes).T @ np.array([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]])
        matrix[:3, 3] = self.position
        return matrix


def build_parts(design: DesignLike, layout: ArrayLayout | None = None) -> PartSet:
    """Draw every distinct part of a design.

    Args:
        design: the array: a design, the path of its file, or the name of a prototype.
        layout: layout of the array, if you have it already.

    Returns:
        ``shell-straight``, ``shell-corner-90``, ... one per distinct set of port angles; ``membrane``;
        ``mold-base``, ``mold-lid``, ... in which membranes are cast, see :func:`geometry.molds.mold.build_mold`;
        ``microphone-housing``, with the angles of further ports where lines meet; ``microphone-board``. Where
        tubes of different diameters are used, the names of shells and housings end in bore x outside
        of their ports' tubes; where kinds of points differ, those of shells in ``h`` and the height of the cavity
        and ``t`` and the thickness of the membrane that the ledge is for, those of membranes and molds in the
        thickness. With ``printing.carrier`` also ``carrier``, the shells of all points in one piece:
        the single shells are then spares, needed 0 times. With ``base.kind = "plate"`` also ``base``, or ``base-1``,
        ``base-2``, ... where the plate is larger than the printer.

    Raises:
        Refusal: a part is not one valid solid.
    """
    design = resolve_design(design)
    return draw_parts(design, layout or lay_out(design))


def draw_parts(design: ArrayDesign, layout: ArrayLayout) -> PartSet:
    """Parts of a design whose parts lie as the layout says, see :func:`build_parts`."""
    plan = _plan(design, layout)
    microphone, printing = design.microphone, design.printing
    parts = PartSet()
    about = _common_parameters(design)
    for name, form in plan.shells.items():
        parts[name] = geometry.solids.build_shell(form.resonator, form.membrane, printing, form.ports, design.shell)
        own = _shell_parameters(form.resonator)
        parts.parameters[name] = {**own, **about["joints"], "ports": _describe(form.ports)}
    for name, alike in plan.alike.items():
        parts[name] = build_membrane(alike)
        parts.parameters[name] = disc = _disc_parameters(alike)
        of_kind = name.removeprefix("membrane")
        molds = {part + of_kind: solid for part, solid in build_mold(alike).parts.items()}
        parts.update(molds)
        for part in molds:
            parts.parameters[part] = {**disc, **about["mold"]}
        for step in range(1, design.mold.shim_count + 1):
            if (part := f"mold-shim-{step}{of_kind}") in molds:
                raised = step * design.mold.shim_step
                parts.parameters[part] |= {"raises_lid": raised, "height": design.mold.land_height + raised}
    for name, ports in plan.housings.items():
        parts[name] = geometry.solids.build_housing(microphone, printing, ports)
        parts.parameters[name] = {**about["chamber"], **about["joints"], "ports": _describe(ports)}
    parts["microphone-board"] = geometry.boards.board_solid(design)
    parts.parameters["microphone-board"] = about["board"]
    if printing.carrier != "none":
        carrier = geometry.solids.array_carrier(design, [plan.shells[name].ports for name, _ in plan.point_shells])
        parts["carrier"] = carrier.part
        joined = {"shells": len(carrier.places), "necks": carrier.necks}
        parts.parameters["carrier"] = {**_shell_parameters(design.resonator), **about["joints"], **joined}
    parts.counts, parts.kinds = _counts(design, plan), _kinds(design, plan)
    parts.placed = _placed(design, layout, plan, parts.kinds)
    if design.base.kind != "none":
        _add_base(parts, design, layout)
    parts.design_toml = write_design(design.completed())
    for name in parts:
        head: dict[str, float | int | str] = {"design": design.name, "count": parts.counts[name]}
        parts.parameters[name] = {**head, **parts.parameters[name]}
    return parts


def _add_base(parts: PartSet, design: ArrayDesign, layout: ArrayLayout) -> None:
    """Draw the base plate, whose pieces lie where they are drawn."""
    base = geometry.assembly.plan_base(design, layout)
    pieces = geometry.solids.draw_base(base)
    for number, piece in enumerate(pieces, 1):
        name = "base" if len(pieces) == 1 else f"base-{number}"
        parts[name], parts.counts[name], parts.kinds[name] = piece, 1, "base"
        parts.parameters[name] = {"seats": len(base.seats), "saddles": len(base.saddles), "pieces": len(pieces)}
        parts.placed += (PlacedPart(name, "base", name, (0.0, 0.0, 0.0), 0.0, FLAT, "base"),)


def _common_parameters(design: ArrayDesign) -> dict[str, dict[str, float | int | str]]:
    """Parameters that parts were drawn from, by what the parts have in common."""
    microphone, printing, board = design.microphone, design.printing, geometry.boards.shown_board(design)
    length, width = microphone.board_size if board is None else board.size
    return {
        "joints": {"glue_gap": printing.glue_gap, "port_lip": printing.port_lip},
        "mold": {"kind": design.mold.kind, "scale": design.mold.scale, "draft": design.mold.draft},
        "chamber": {
            "chamber_diameter": microphone.chamber_diameter,
            "chamber_height": microphone.chamber_height,
            "board_length": microphone.board_size[0],
            "board_width": microphone.board_size[1],
            "wall_thickness": microphone.wall_thickness,
        },
        "board": {
            "length": round(length, 6),
            "width": round(width, 6),
            "sound_hole_diameter": microphone.sound_hole_diameter,
            "sound_hole_length": microphone.sound_hole_length,
            "model": microphone.model,
        },
    }


def _shell_parameters(resonator: Resonator) -> dict[str, float | int | str]:
    return {
        "shape": resonator.shape,
        "cavity_diameter": resonator.cavity_diameter,
        "cavity_height": resonator.cavity_height,
        "wall_thickness": resonator.wall_thickness,
        "floor_thickness": resonator.floor_thickness,
        "port_height": resonator.port_axis_height,
    }


def _disc_parameters(design: ArrayDesign) -> dict[str, float | int | str]:
    return {
        "diameter": 2 * membrane_radius(design.resonator, design.membrane),
        "thickness": design.membrane.thickness,
        "material": design.membrane.material,
    }


def part_counts(design: ArrayDesign) -> dict[str, int]:
    """How many of each part one array needs, by the names of :func:`build_parts` (one mold serves all)."""
    return _counts(design, _plan(design, lay_out(design)))


def place_parts(design: ArrayDesign, layout: ArrayLayout) -> tuple[PlacedPart, ...]:
    """Position of every copy of every part; the floors of resonators' cavities lie at z = 0 of a flat array."""
    plan = _plan(design, layout)
    return _placed(design, layout, plan, _kinds(design, plan))


def _placed(
    design: ArrayDesign, layout: ArrayLayout, plan: _Plan, kinds: Mapping[str, PartKind]
) -> tuple[PlacedPart, ...]:
    placed = []

    def put(
        part: str, label: str, at: PointPlacement | MicrophonePlacement, height: float, turn: float, group: str
    ) -> None:
        frame = layout.frame(at)
        x, y, z = (round(float(c), 9) + 0.0 for c in frame.at(0.0, 0.0, height))
        placed.append(PlacedPart(part, kinds[part], label, (x, y, z), turn, frame.axes, group))

    for point, (name, turn), membrane in zip(layout.points, plan.point_shells, plan.point_membranes, strict=True):
        group = f"point {point.number}"
        put(name, f"shell {point.number}", point, 0.0, turn, group)
        put(membrane, f"membrane {point.number}", point, plan.shells[name].resonator.cavity_height, 0.0, group)
    # The middle of a chamber is at the height of the resonators' ports.
    floor = design.resonator.port_axis_height - design.microphone.chamber_height / 2
    for microphone, (name, turn) in zip(layout.microphones, plan.microphone_housings, strict=True):
        group = f"microphone {microphone.name}"
        put(name, group, microphone, floor, turn, group)
        put(
            "microphone-board",
            f"board {microphone.name}",
            microphone,
            floor + design.microphone.chamber_height,
            turn,
            group,
        )
    return tuple(placed)


# -- distinct housings ----------------------------------------------------------------------------------
@dataclass(frozen=True)
class _Form:
    """Sizes and ports that a shell is drawn from."""

    resonator: Resonator
    membrane: Membrane
    """One that its ledge is for: those of other thickness have the same ledge, or none."""
    ports: tuple[Port, ...]


@dataclass(frozen=True)
class _Plan:
    """Each distinct shell, housing and membrane by name, and what stands at each place of the layout."""

    shells: dict[str, _Form]
    housings: dict[str, tuple[Port, ...]]
    alike: dict[str, ArrayDesign]
    """For each membrane the design whose points all have it, see :func:`molds_of`."""
    point_shells: tuple[tuple[str, float], ...]
    point_membranes: tuple[str, ...]
    microphone_housings: tuple[tuple[str, float], ...]


def _plan(design: ArrayDesign, layout: ArrayLayout) -> _Plan:
    at_points = [point.turned for point in layout.points]
    at_microphones = [microphone.turned for microphone in layout.microphones]
    forms = _forms(design, layout, [ports for ports, _ in at_points])
    of_ports = _named([form.ports for form in forms], _shell_name)
    of_sizes = _size_suffixes(forms, design.printing)
    names = {form: of_ports[form.ports] + of_sizes[form] for form in forms}
    housings = _named([ports for ports, _ in at_microphones], _housing_name)
    alike = molds_of(design)
    membranes = {own.membrane: name for name, own in alike.items()}
    places = [(design.lines[point.line], point.place) for point in layout.points]
    return _Plan(
        {name: form for form, name in names.items()},
        {name: ports for ports, name in housings.items()},
        alike,
        tuple((names[form], turn) for form, (_, turn) in zip(forms, at_points, strict=True)),
        tuple(membranes[design.membrane_at(*place)] for place in places),
        tuple((housings[ports], turn) for ports, turn in at_microphones),
    )


def _forms(design: ArrayDesign, layout: ArrayLayout, ports: Sequence[tuple[Port, ...]]) -> list[_Form]:
    """Form of the shell of each point, given its ports; shells that are alike have one form."""
    known: dict[object, _Form] = {}
    forms = []
    for point, own in zip(layout.points, ports, strict=True):
        line = design.lines[point.line]
        form = _Form(design.resonator_at(line, point.place), design.membrane_at(line, point.place), own)
        key = (form.resonator, ledge_height(form.resonator, form.membrane, design.printing), own)
        forms.append(known.setdefault(key, form))
    return forms


def _size_suffixes(forms: Sequence[_Form], printing: Printing) -> dict[_Form, str]:
    """Ends of the names of shells that differ in the height of their cavities or in their ledges."""
    high = len({form.resonator.cavity_height for form in forms}) > 1
    ledges = len({ledge_height(form.resonator, form.membrane, printing) for form in forms}) > 1
    return {
        form: (f"-h{form.resonator.cavity_height:g}" if high else "")
        + (f"-t{form.membrane.thickness:g}" if ledges else "")
        for form in forms
    }


def _named(
    places: Sequence[tuple[Port, ...]], base_name: Callable[[tuple[Port, ...]], str]
) -> dict[tuple[Port, ...], str]:
    """Names of the distinct sets of ports, in order of first use."""
    distinct = tuple(dict.fromkeys(places))
    tubes_differ = len({(p.bore_diameter, p.tube_diameter) for ports in distinct for p in ports}) > 1
    return {ports: base_name(ports) + (_tubes_suffix(ports) if tubes_differ else "") for ports in distinct}


def _tubes_suffix(ports: tuple[Port, ...]) -> str:
    tubes = [f"-{port.bore_diameter:g}x{port.tube_diameter:g}" for port in ports]
    return tubes[0] if len(set(tubes)) == 1 else "".join(tubes)


def _shell_name(ports: tuple[Port, ...]) -> str:
    angle = ports[1].angle
    return "shell-straight" if angle == 180 else f"shell-corner-{angle:g}"


def _housing_name(ports: tuple[Port, ...]) -> str:
    return "microphone-housing" + "".join(f"-{port.angle:g}" for port in ports[1:])


def _counts(design: ArrayDesign, plan: _Plan) -> dict[str, int]:
    used = Counter(name for name, _ in plan.point_shells + plan.microphone_housings)
    carried = design.printing.carrier != "none"
    return {
        **{name: 0 if carried else used[name] for name in plan.shells},
        **_of_membranes(plan, Counter(plan.point_membranes), mold_counts),
        **{name: used[name] for name in plan.housings},
        "microphone-board": len(plan.microphone_housings),
        **({"carrier": 1} if carried else {}),
    }


def _of_membranes(
    plan: _Plan, of_casts: Mapping[str, _T], of_mold: Callable[[ArrayDesign], Mapping[str, _T]]
) -> dict[str, _T]:
    """Something of every membrane and of the parts of its mold, by name."""
    found: dict[str, _T] = {}
    for name, alike in plan.alike.items():
        found[name] = of_casts[name]
        found |= {part + name.removeprefix("membrane"): value for part, value in of_mold(alike).items()}
    return found


def _kinds(design: ArrayDesign, plan: _Plan) -> dict[str, PartKind]:
    carried: dict[str, PartKind] = {} if design.printing.carrier == "none" else {"carrier": "carrier"}
    return {
        **dict.fromkeys(plan.shells, "shell"),
        **_of_membranes(plan, dict.fromkeys(plan.point_membranes, "membrane"), mold_kinds),
        **dict.fromkeys(plan.housings, "housing"),
        "microphone-board": "board",
        **carried,
    }


def _describe(ports: Sequence[Port]) -> str:
    return "; ".join(f"{p.angle:g} deg, bore {p.bore_diameter:g}, tube {p.tube_diameter:g}" for p in ports)
