"""The parts of an array: each distinct shape once, how many of it, and where they go."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import write_design
from geometry.layout.arrangement import lay_out
from geometry.layout.placement import (
    ArrayLayout,
    MicrophonePlacement,
    PointPlacement,
    microphone_ports,
    point_ports,
)
from geometry.molds.mold import MoldKind, mold_counts, mold_kinds
from geometry.plan.cylinder import FLAT, Axes
from geometry.stated.ports import ANGLE_STEP, Port, in_common_rotation

if TYPE_CHECKING:
    import cadquery as cq


#: What a part of an array is.
Kind = Literal["shell", "carrier", "membrane", "housing", "board", "package", "spring", "sheath"] | MoldKind
#: Where a part comes from.
Origin = Literal["printed", "cast", "bought"]
#: Kinds that are not printed.
_ORIGINS: dict[Kind, Origin] = {
    "membrane": "cast",
    "board": "bought",
    "package": "bought",
    "spring": "bought",
    "sheath": "bought",
}


class PartSet(dict[str, "cq.Workplane"]):
    """Parts by name, each in its own coordinates (mm), with what they were generated from.

    ``parameters`` has for each part the numbers and words written into its 3MF file: what matters most of it, and
    under ``design_toml`` the text of the whole design, from which :func:`build_parts` draws the part of that name
    again. ``counts`` has how many of it one array needs, 0 for single shells beside a carrier. ``kinds`` has what each
    part is, for parts of an array: where it comes from, and what is put into it, follow from that.
    """

    def __init__(self) -> None:
        super().__init__()
        self.parameters: dict[str, dict[str, float | int | str]] = {}
        self.counts: dict[str, int] = {}
        self.kinds: dict[str, Kind] = {}

    def origin(self, name: str) -> Origin:
        """Where a part comes from; one of no kind is printed."""
        kind = self.kinds.get(name)
        return "printed" if kind is None else _ORIGINS.get(kind, "printed")

    def only(self, *names: str) -> PartSet:
        """Some of the parts, in this order, with all that is known of them.

        Raises:
            KeyError: no part has the name.
        """
        chosen = PartSet()
        chosen.update({name: self[name] for name in names})
        chosen.parameters = {name: self.parameters[name] for name in names if name in self.parameters}
        chosen.counts = {name: self.counts[name] for name in names if name in self.counts}
        chosen.kinds = {name: self.kinds[name] for name in names if name in self.kinds}
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
    kind: Kind
    """What it is."""
    label: str
    """Name of this copy."""
    position: tuple[float, float, float]
    """Where the origin of its own coordinates lies, mm."""
    rotation: float
    """Angle by which it is turned about its own z, degrees."""
    axes: Axes = FLAT
    """Directions of its x, y and z, as rows; on a flat array those of its own coordinates."""
    group: str = ""
    """What it belongs to: ``point 3``, ``microphone A``, ``tube 2 of line 1``."""

    @property
    def matrix(self) -> NDArray[np.float64]:
        """The (4, 4) float64 matrix that moves the part into place, mm."""
        cos, sin = math.cos(math.radians(self.rotation)), math.sin(math.radians(self.rotation))
        matrix = np.eye(4)
        matrix[:3, :3] = np.array(self.axes).T @ np.array([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]])
        matrix[:3, 3] = self.position
        return matrix


def build_parts(design: ArrayDesign, layout: ArrayLayout | None = None) -> PartSet:
    """Draw every distinct part of a design.

    Args:
        design: the array.
        layout: where its parts lie, where it is known already.

    Returns:
        ``shell-straight``, ``shell-corner-90``, ... one per distinct set of port angles; ``membrane``;
        ``mold-base``, ``mold-lid``, ... in which membranes are cast, see :func:`geometry.molds.mold.build_mold`;
        ``microphone-housing``, with the angles of further ports where lines meet; ``microphone-board``. Where
        tubes of different diameters are used, the names of shells and housings end in bore x outside
        of their ports' tubes. With ``printing.carrier`` also ``carrier``, the shells of all points in one piece:
        the single shells are then spares, needed 0 times.

    Raises:
        Refusal: a part is not one valid solid.
    """
    from geometry.molds.mold import build_mold
    from geometry.solids.carrier import array_carrier
    from geometry.solids.housing import build_board, build_housing
    from geometry.solids.membrane import build_membrane
    from geometry.solids.shell import build_shell

    plan = _plan(design, layout)
    resonator, membrane, microphone, printing = design.resonator, design.membrane, design.microphone, design.printing
    parts = PartSet()
    about = _common_parameters(design)
    for name, ports in plan.shells.items():
        parts[name] = build_shell(resonator, membrane, printing, ports, design.shell)
        parts.parameters[name] = {**about["shell"], **about["joints"], "ports": _describe(ports)}
    parts["membrane"] = build_membrane(design)
    mold = build_mold(design)
    parts.update(mold.parts)
    for name, ports in plan.housings.items():
        parts[name] = build_housing(microphone, printing, ports)
        parts.parameters[name] = {**about["chamber"], **about["joints"], "ports": _describe(ports)}
    parts["microphone-board"] = build_board(microphone)
    parts.parameters["microphone-board"] = about["board"]
    parts.parameters["membrane"] = about["disc"]
    for name in mold.parts:
        parts.parameters[name] = {**about["disc"], **about["mold"]}
    for step in range(1, design.mold.shim_count + 1):
        if (name := f"mold-shim-{step}") in mold.parts:
            raised = step * design.mold.shim_step
            parts.parameters[name] |= {"raises_lid": raised, "height": design.mold.land_height + raised}
    if printing.carrier != "none":
        carrier = array_carrier(design, [plan.shells[name] for name, _ in plan.point_shells])
        parts["carrier"] = carrier.part
        own = {"shells": len(carrier.places), "necks": carrier.necks}
        parts.parameters["carrier"] = {**about["shell"], **about["joints"], **own}
    parts.counts, parts.kinds = _counts(design, plan), _kinds(design, plan)
    text = write_design(design.completed())
    for name in parts:
        head: dict[str, float | int | str] = {"design": design.name, "count": parts.counts[name]}
        parts.parameters[name] = {**head, **parts.parameters[name], "design_toml": text}
    return parts


def _common_parameters(design: ArrayDesign) -> dict[str, dict[str, float | int | str]]:
    """What parts were drawn from, by what they have in common."""
    from geometry.solids.membrane import membrane_radius

    resonator, membrane, microphone, printing = design.resonator, design.membrane, design.microphone, design.printing
    return {
        "joints": {"glue_gap": printing.glue_gap, "port_lip": printing.port_lip},
        "shell": {
            "shape": resonator.shape,
            "cavity_diameter": resonator.cavity_diameter,
            "cavity_height": resonator.cavity_height,
            "wall_thickness": resonator.wall_thickness,
            "floor_thickness": resonator.floor_thickness,
            "port_height": resonator.port_axis_height,
        },
        "disc": {
            "diameter": 2 * membrane_radius(resonator, membrane),
            "thickness": membrane.thickness,
            "material": membrane.material,
        },
        "mold": {"kind": design.mold.kind, "scale": design.mold.scale, "draft": design.mold.draft},
        "chamber": {
            "chamber_diameter": microphone.chamber_diameter,
            "chamber_height": microphone.chamber_height,
            "board_length": microphone.board_size[0],
            "board_width": microphone.board_size[1],
            "wall_thickness": microphone.wall_thickness,
        },
        "board": {
            "length": microphone.board_size[0],
            "width": microphone.board_size[1],
            "sound_hole_diameter": microphone.sound_hole_diameter,
            "sound_hole_length": microphone.sound_hole_length,
            "model": microphone.model,
        },
    }


def part_counts(design: ArrayDesign) -> dict[str, int]:
    """How many of each part one array needs, by the names of :func:`build_parts` (one mold serves all)."""
    return _counts(design, _plan(design))


def place_parts(design: ArrayDesign, layout: ArrayLayout) -> tuple[PlacedPart, ...]:
    """Where every copy of every made part lies; the floors of resonators' cavities lie at z = 0 of a flat array."""
    plan, placed = _plan(design, layout), []
    kinds = _kinds(design, plan)

    def put(
        part: str, label: str, at: PointPlacement | MicrophonePlacement, height: float, turn: float, group: str
    ) -> None:
        frame = layout.frame(at)
        x, y, z = (round(float(c), 9) + 0.0 for c in frame.at(0.0, 0.0, height))
        placed.append(PlacedPart(part, kinds[part], label, (x, y, z), turn, frame.axes, group))

    top = design.resonator.cavity_height
    for point, (name, turn) in zip(layout.points, plan.point_shells, strict=True):
        group = f"point {point.number}"
        put(name, f"shell {point.number}", point, 0.0, turn, group)
        put("membrane", f"membrane {point.number}", point, top, 0.0, group)
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
class _Plan:
    """Ports of each distinct shell and housing by name; name and rotation at each place of the layout."""

    shells: dict[str, tuple[Port, ...]]
    housings: dict[str, tuple[Port, ...]]
    point_shells: tuple[tuple[str, float], ...]
    microphone_housings: tuple[tuple[str, float], ...]


def _plan(design: ArrayDesign, layout: ArrayLayout | None = None) -> _Plan:
    layout = layout or lay_out(design)
    at_points = []
    for point in layout.points:
        at_points.append(in_common_rotation(point_ports(design, point), ANGLE_STEP))
    at_microphones = [in_common_rotation(microphone_ports(design, each), ANGLE_STEP) for each in layout.microphones]
    shells, point_shells = _named(at_points, _shell_name)
    housings, microphone_housings = _named(at_microphones, _housing_name)
    return _Plan(shells, housings, point_shells, microphone_housings)


def _named(
    places: Sequence[tuple[tuple[Port, ...], float]], base_name: Callable[[tuple[Port, ...]], str]
) -> tuple[dict[str, tuple[Port, ...]], tuple[tuple[str, float], ...]]:
    """Name the distinct sets of ports, in order of first use."""
    distinct = tuple(dict.fromkeys(ports for ports, _ in places))
    tubes_differ = len({(p.bore_diameter, p.tube_diameter) for ports in distinct for p in ports}) > 1
    names = {ports: base_name(ports) + (_tubes_suffix(ports) if tubes_differ else "") for ports in distinct}
    return {name: ports for ports, name in names.items()}, tuple((names[ports], turn) for ports, turn in places)


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
        "membrane": len(plan.point_shells),
        **mold_counts(design),
        **{name: used[name] for name in plan.housings},
        "microphone-board": len(plan.microphone_housings),
        **({"carrier": 1} if carried else {}),
    }


def _kinds(design: ArrayDesign, plan: _Plan) -> dict[str, Kind]:
    carried: dict[str, Kind] = {} if design.printing.carrier == "none" else {"carrier": "carrier"}
    return {
        **dict.fromkeys(plan.shells, "shell"),
        "membrane": "membrane",
        **mold_kinds(design),
        **dict.fromkeys(plan.housings, "housing"),
        "microphone-board": "board",
        **carried,
    }


def _describe(ports: Sequence[Port]) -> str:
    return "; ".join(f"{p.angle:g} deg, bore {p.bore_diameter:g}, tube {p.tube_diameter:g}" for p in ports)
