"""The distinct cells of a design: an array of many points has only a few air volumes that differ.

A cell is the air of one resonator or microphone chamber with a short stub of every tube. Cells that
differ by a rotation, a reflection or the order of their ports are acoustically one; they are brought to
one canonical form here, so that each is meshed and solved once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from geometry.design import STUB_LENGTH_IN_RADII, ArrayDesign
from geometry.layout import ArrayLayout

#: Angles closer than this are one cell, degrees.
ANGLE_STEP = 0.1


@dataclass(frozen=True, order=True)
class CellPort:
    """A tube port of a cell: direction seen from the cell's axis (degrees) and bore (mm)."""

    angle: float
    bore_diameter: float

    @property
    def stub_length(self) -> float:
        """Length of the stub that belongs to the cell, mm."""
        return STUB_LENGTH_IN_RADII * self.bore_diameter / 2


@dataclass(frozen=True)
class Cell:
    """Air of one resonator or microphone chamber with tube stubs: a cylinder with an opening on top.

    The opening is the membrane (as wide as the cavity, length 0) or the microphone's sound hole.
    Lengths in mm.
    """

    kind: Literal["resonator", "microphone"]
    diameter: float
    height: float
    port_height: float
    ports: tuple[CellPort, ...]
    opening_diameter: float
    opening_length: float

    @property
    def label(self) -> str:
        """Short name for progress displays and reports."""
        ports = ", ".join(f"{p.angle:g} deg bore {p.bore_diameter:g}" for p in self.ports)
        return f"{self.kind} {self.diameter:g} x {self.height:g} mm ({ports})"


@dataclass(frozen=True)
class CellUse:
    """One place of the array that a cell fills: ``order[k]`` is the cell's port at the place's k-th tube."""

    cell: Cell
    order: tuple[int, ...]


@dataclass(frozen=True)
class CellCatalogue:
    """Cells of an array: per point (tubes to the previous and to the next node) and per microphone.

    The tubes of a microphone are ordered as :attr:`geometry.layout.MicrophonePlacement.ports`.
    """

    points: tuple[CellUse, ...]
    microphones: tuple[CellUse, ...]

    @property
    def distinct(self) -> tuple[Cell, ...]:
        """Every cell that must be solved, in order of first use."""
        return tuple(dict.fromkeys(use.cell for use in self.points + self.microphones))


def canonical_ports(ports: Sequence[CellPort]) -> tuple[tuple[CellPort, ...], tuple[int, ...]]:
    """Bring ports to canonical rotation, reflection and order.

    Returns:
        The canonical ports, and for each given port its place among them.
    """
    candidates = []
    for reference in ports:
        for sense in (1.0, -1.0):
            turned = [
                CellPort(
                    round(round(sense * (port.angle - reference.angle) / ANGLE_STEP) * ANGLE_STEP % 360.0, 6),
                    port.bore_diameter,
                )
                for port in ports
            ]
            ranked = sorted((port, k) for k, port in enumerate(turned))
            candidates.append((tuple(port for port, _ in ranked), [k for _, k in ranked]))
    best, ranking = min(candidates, key=lambda candidate: candidate[0])
    return best, tuple(ranking.index(k) for k in range(len(best)))


def cell_catalogue(design: ArrayDesign, layout: ArrayLayout) -> CellCatalogue:
    """Distinct cells of a design whose parts lie as the layout says."""
    resonator, microphone = design.resonator, design.microphone
    points = []
    for placement in layout.points:
        line = design.lines[placement.line]
        segment, outer = design.tube_of(line), design.microphone_tube_of(line)
        before = outer if placement.place == 0 else segment
        after = outer if placement.place == line.points - 1 else segment
        ports, order = canonical_ports(
            [
                CellPort(angle, tube.inner_diameter)
                for angle, tube in zip(placement.port_angles, (before, after), strict=True)
            ]
        )
        points.append(
            CellUse(
                Cell(
                    kind="resonator",
                    diameter=resonator.cavity_diameter,
                    height=resonator.cavity_height,
                    port_height=resonator.port_axis_height,
                    ports=ports,
                    opening_diameter=resonator.cavity_diameter,
                    opening_length=0.0,
                ),
                order,
            )
        )
    microphones = []
    for housing in layout.microphones:
        ports, order = canonical_ports(
            [
                CellPort(port.angle, design.microphone_tube_of(design.lines[port.line]).inner_diameter)
                for port in housing.ports
            ]
        )
        microphones.append(
            CellUse(
                Cell(
                    kind="microphone",
                    diameter=microphone.chamber_diameter,
                    height=microphone.chamber_height,
                    port_height=microphone.chamber_height / 2,
                    ports=ports,
                    opening_diameter=microphone.sound_hole_diameter,
                    opening_length=microphone.sound_hole_length,
                ),
                order,
            )
        )
    return CellCatalogue(tuple(points), tuple(microphones))
