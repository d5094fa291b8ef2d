"""Ports of housings and of cells, through which tubes enter, and the wall that they leave between them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

from geometry.schema.cavity_shapes import web
from geometry.schema.part_fields import SOCKET_COVER, STUB_LENGTH_IN_RADII

#: Angles closer than this are one cell and one printed part, degrees.
ANGLE_STEP = 0.1


@dataclass(frozen=True, order=True)
class Port:
    """Place where a tube enters a housing, and what the tube is there."""

    angle: float
    """Direction of the tube from the housing's axis, degrees."""
    bore_diameter: float
    """Diameter of the tube's bore, mm."""
    tube_diameter: float
    """Outside diameter of the tube, mm."""
    height: float | None = None
    """Height of its axis above the floor of the cavity, mm; None: that of the housing's ports."""


@dataclass(frozen=True, order=True)
class CellPort:
    """A tube port of a cell."""

    angle: float
    """Direction of the tube from the cell's axis, degrees."""
    bore_diameter: float
    """Diameter of the tube's bore, mm."""
    height: float | None = None
    """Height of its axis above the floor, mm; None: that of the cell's ports."""

    @property
    def stub_length(self) -> float:
        """Length of the stub that belongs to the cell, mm."""
        return STUB_LENGTH_IN_RADII * self.bore_diameter / 2


def port_web(
    ports: tuple[Port, Port], mouths: tuple[float, float], shoulder: float, glue_gap: float, rise: float = 0.0
) -> float:
    """Least material between two ports of a housing, bores and sockets, mm; see :func:`web`.

    Args:
        ports: at their angles.
        mouths: from the axis to the wall where the bores begin, mm.
        shoulder: from the axis to where the sockets begin, mm.
        glue_gap: around the tubes in their sockets, mm.
        rise: difference of the ports' heights, mm.
    """
    holes = []
    for port, mouth in zip(ports, mouths, strict=True):
        bore = port.bore_diameter / 2
        # The sides of a bore reach further in than its axis: the wall is round.
        begin = math.sqrt(max(mouth**2 - bore**2, 0.0))
        holes.append(((begin, bore), (shoulder, port.tube_diameter / 2 + glue_gap)))
    turn = ports[0].angle - ports[1].angle
    return min(web(first, second, turn, rise) for first, second in product(*holes))


def web_problem(
    ports: tuple[Port, Port], mouths: tuple[float, float], shoulder: float, glue_gap: float, rise: float = 0.0
) -> str:
    """Why two ports of a housing, named by their angles, do not leave enough wall between them; empty where they do.

    Args: see :func:`port_web`.
    """
    wall = port_web(ports, mouths, shoulder, glue_gap, rise)
    where = f"at {ports[0].angle:g} and {ports[1].angle:g} deg"
    if wall <= 0:
        return f"{where} overlap"
    if wall < SOCKET_COVER - 1e-9:
        return (
            f"{where} leave a wall of {wall:.3g} mm between them; it must be at least {SOCKET_COVER:g} mm: turn them "
            "apart, or widen the cavity or printing.port_lip"
        )
    return ""


def in_common_rotation(ports: Sequence[Port], step: float) -> tuple[tuple[Port, ...], float]:
    """Ports in the one rotation that all equal housings share, and the angle that turns them back.

    The direction that comes to lie along x is also that of a box's first side. Only rotations are tried: a
    mirrored housing is another part, since its floor stays below.

    Args:
        ports: of a housing, at any angles.
        step: to which angles are rounded, degrees.
    """
    candidates = []
    for reference in ports:
        moved = [
            replace(port, angle=round(round((port.angle - reference.angle) / step) * step % 360.0, 6)) for port in ports
        ]
        moved.sort(key=port_rank)
        candidates.append((tuple(moved), reference.angle))
    return min(candidates, key=lambda candidate: (*map(port_rank, candidate[0]), candidate[1]))


def port_rank(port: Port | CellPort) -> tuple[float, ...]:
    """Key that ports are sorted by; those without a height of their own come first."""
    return tuple(-1.0 if size is None else size for size in vars(port).values())


def largest_gap(angles: Sequence[float]) -> tuple[float, float]:
    """Middle and width of the widest gap between angles of directions, degrees."""
    ranked = sorted(angle % 360 for angle in angles)
    gaps = [
        ((after - before) % 360 or 360.0, before) for before, after in zip(ranked, ranked[1:] + ranked[:1], strict=True)
    ]
    width, start = max(gaps, key=lambda gap: (round(gap[0], 6), -gap[1]))
    return (start + width / 2) % 360, width


def least_angle(angles: Sequence[float]) -> float:
    """Smallest angle between neighbouring directions, at least two of them, degrees."""
    ranked = sorted(angle % 360 for angle in angles)
    return min((after - before) % 360 for before, after in zip(ranked, ranked[1:] + ranked[:1], strict=True))


def foot_directions(ports: Sequence[float], count: int) -> list[float]:
    """Directions of mounting feet, degrees, each in the middle of the widest gap that ports and feet before it leave.

    Args:
        ports: directions of the ports of a shell, degrees.
        count: number of feet.
    """
    taken = list(ports)
    for _ in range(count):
        taken.append(largest_gap(taken)[0])
    return taken[len(ports) :]
