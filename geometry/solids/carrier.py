"""Shells joined for printing: a row or a sheet of them in one piece, with necks that snap off. Lengths in mm.

Between neighbours lies a web as thick as the floor, and between a web and a shell a short neck, the only thing to
break. Webs lie at the height of the floor, below the sockets, so that the shells stay open at the top.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import cadquery as cq

from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_given
from geometry.schema.field_errors import conflict
from geometry.schema.manufacture import Printing
from geometry.schema.part_fields import Resonator
from geometry.schema.ports import Port
from geometry.solids.round_solids import one_solid
from geometry.solids.shell import build_shell

#: Length of a neck, and the width of the webs.
_NECK_LENGTH = 0.6
_WEB_WIDTH = 1.5
#: How far a neck reaches into shell and web, so that they become one.
_ROOT = 0.1


@dataclass(frozen=True)
class Carrier:
    """Shells joined in one piece."""

    part: cq.Workplane
    """All shells in one solid, mm."""
    places: tuple[tuple[float, float], ...]
    """Axis of each shell, mm, in the order given."""
    necks: int
    """Number of necks to snap."""


def carrier_places(count: int, kind: str, pitch: float) -> tuple[tuple[float, float], ...]:
    """Places of the shells of a carrier, mm: side by side along x, or in rows of about as many as there are rows.

    Args:
        count: number of shells.
        kind: ``"row"`` or ``"sheet"``.
        pitch: from axis to axis, mm.
    """
    columns = count if kind == "row" else math.ceil(math.sqrt(count))
    return tuple((pitch * (k % columns), -pitch * (k // columns)) for k in range(count))


def array_carrier(design: ArrayDesign, ports: Sequence[Sequence[Port]]) -> Carrier:
    """All shells of an array in one piece, numbered where ``shell.label`` asks for it.

    Args:
        design: the array.
        ports: of the shell of each point, in the order of their numbers from 1; fewer draw the first ones.

    Raises:
        Refusal: as :func:`geometry.solids.shell.build_shell` and :func:`build_carrier`.
    """
    numbered, alike = design.shell.label != "none", [design.of_kind(kind) for kind in design.kinds]
    drawn: dict[tuple[object, ...], cq.Workplane] = {}
    shells = []
    for number, (of_point, kind) in enumerate(zip(ports, design.kind_of_point, strict=False), 1):
        label = str(number) if numbered else None
        key = (*of_point, kind, label)
        if key not in drawn:
            resonator, membrane = alike[kind].resonator, alike[kind].membrane
            drawn[key] = build_shell(resonator, membrane, design.printing, of_point, design.shell, label)
        shells.append(drawn[key])
    return build_carrier(design.resonator, design.printing, shells)


def build_carrier(resonator: Resonator, printing: Printing, shells: Sequence[cq.Workplane]) -> Carrier:
    """Join shells by webs and necks into one solid, as ``printing.carrier`` says.

    Args:
        resonator: what the shells were drawn from.
        printing: kind of carrier, gap between shells and size of the necks.
        shells: at least one, each with its axis at the origin; without feet.

    Raises:
        Refusal: no carrier is asked for, there are no shells, necks thicker than the floor, a shell that reaches
            beyond its outer diameter, or the drawn carrier is not one valid solid.
    """
    kind, gap, neck = printing.carrier, printing.carrier_gap, printing.carrier_neck
    if kind == "none":
        raise conflict("printing.carrier", "none", "'row' or 'sheet' for shells to be joined", unit="")
    check_given("shells", shells, remedy="give the shells that a carrier joins")
    if neck > resonator.floor_thickness:
        allowed = f"at most resonator.floor_thickness ({resonator.floor_thickness:g} mm)"
        raise conflict("printing.carrier_neck", neck, allowed)
    outer = resonator.outer_diameter / 2
    for number, shell in enumerate(shells):
        box = shell.val().BoundingBox()
        reach = max(-box.xmin, box.xmax, -box.ymin, box.ymax)
        if reach > outer + (gap - 2 * _NECK_LENGTH) / 2:
            most = outer + (gap - 2 * _NECK_LENGTH) / 2
            problem = (
                f"reaches {reach:.4g} mm from its axis; it must stay within {most:.4g} mm, half of "
                "printing.carrier_gap beyond its wall"
            )
            raise conflict(f"shells.{number}", problem=problem)
    pitch = 2 * outer + gap
    places = carrier_places(len(shells), kind, pitch)
    taken = {(round(x / pitch), round(y / pitch)) for x, y in places}
    link = _link(resonator, outer, gap, neck)
    links: list[cq.Shape] = []
    for x, y in places:
        for right, down, turn in ((1, 0, 0.0), (0, 1, -90.0)):
            if (round(x / pitch) + right, round(y / pitch) - down) in taken:
                turned = [piece.rotate(cq.Vector(), cq.Vector(0, 0, 1), turn) for piece in link]
                links += [piece.translate(cq.Vector(x, y, 0)) for piece in turned]
    solids = [shell.val().translate(cq.Vector(x, y, 0)) for shell, (x, y) in zip(shells, places, strict=True)]
    whole = solids[0].fuse(*solids[1:], *links) if len(solids) > 1 else solids[0]
    return Carrier(one_solid(whole, "carrier"), places, len(links) // 3 * 2)


def _link(resonator: Resonator, outer: float, gap: float, neck: float) -> tuple[cq.Solid, cq.Solid, cq.Solid]:
    """The web from a shell at the origin to its neighbour along x, and its two necks."""
    floor, width = resonator.floor_thickness, max(_WEB_WIDTH, neck)
    # The wall is round: at the edge of a neck it has drawn back by this much.
    sagitta = outer - math.sqrt(max(outer**2 - (neck / 2) ** 2, 0.0))
    web = _bar(outer + _NECK_LENGTH, outer + gap - _NECK_LENGTH, width, floor, -floor)
    near = _bar(outer - sagitta - _ROOT, outer + _NECK_LENGTH + _ROOT, neck, neck, -floor)
    far = _bar(outer + gap - _NECK_LENGTH - _ROOT, outer + gap + sagitta + _ROOT, neck, neck, -floor)
    return web, near, far


def _bar(start: float, end: float, width: float, height: float, bottom: float) -> cq.Solid:
    return cq.Solid.makeBox(end - start, width, height, cq.Vector(start, -width / 2, bottom))
