"""The distinct cells of a design: an array of many points has only a few air volumes that differ.

A cell is the air of one resonator or microphone chamber with a short stub of every tube. Cells that
differ by a rotation, a reflection or the order of their ports are acoustically one; they are brought to
one canonical form here, so that each is meshed and solved once.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal

from geometry.design.array_design import ArrayDesign
from geometry.layout.placement import Housings
from geometry.schema.cavity_shapes import Box, Dome, wall_distance
from geometry.schema.part_fields import Resonator
from geometry.schema.ports import ANGLE_STEP, CellPort, Port, in_common_rotation, port_rank


@dataclass(frozen=True)
class Cell:
    """Air of one resonator or microphone chamber with tube stubs and an opening on top.

    It is a cylinder where no other shape is given. The opening is the membrane (as wide as the cavity, length 0)
    or the microphone's sound hole.
    """

    kind: Literal["resonator", "microphone"]
    """Part that the air belongs to."""
    diameter: float
    """Diameter of the cavity, mm."""
    height: float
    """Height of the cavity, mm."""
    port_height: float
    """Height above the floor of the ports that state none of their own, mm."""
    ports: tuple[CellPort, ...]
    """Tube ports in canonical order."""
    opening_diameter: float
    """Diameter of the membrane or of the sound hole, mm."""
    opening_length: float
    """Length of the sound hole, mm; 0 under a membrane."""
    shape: Box | Dome | None = None
    """Shape of the cavity; None for a cylinder."""

    @property
    def label(self) -> str:
        """Short name for progress displays and reports."""
        ports = ", ".join(f"{p.angle:g} deg bore {p.bore_diameter:g}" for p in self.ports)
        shape = "" if self.shape is None else f"{type(self.shape).__name__.lower()} "
        return f"{self.kind} {shape}{self.diameter:g} x {self.height:g} mm ({ports})"

    @property
    def smallest_extent(self) -> float:
        """Height or width of the cavity, whichever is less, mm."""
        sides = (self.shape.length, self.shape.width) if isinstance(self.shape, Box) else ()
        return min(self.height, self.diameter, *sides)

    def height_of(self, port: CellPort) -> float:
        """Height of a port's axis above the floor, mm."""
        return self.port_height if port.height is None else port.height

    def mouth_of(self, port: CellPort) -> float:
        """Distance from the axis to where the port's axis meets the wall of the cavity, mm."""
        return wall_distance(self.shape, self.diameter / 2, self.height_of(port), port.angle)

    def bore_of(self, port: CellPort) -> float:
        """Length of a stub from the wall of the cavity, mm; stubs count from the cavity's radius."""
        return self.diameter / 2 + port.stub_length - self.mouth_of(port)


@dataclass(frozen=True)
class CellUse:
    """Use of a cell at one place of the array: ``order[k]`` is the cell's port at the place's k-th tube."""

    cell: Cell
    """The cell in its canonical form."""
    order: tuple[int, ...]
    """Index of the cell's port at each of the place's tubes."""


@dataclass(frozen=True)
class CellCatalogue:
    """Cells of an array: per point (tubes to the previous and to the next node) and per microphone.

    The tubes of a microphone are ordered as :attr:`geometry.layout.placement.MicrophonePlacement.ports`.
    """

    points: tuple[CellUse, ...]
    """Cell at each point, its tubes to the previous and to the next node of the line."""
    microphones: tuple[CellUse, ...]
    """Cell at each microphone, its tubes in the order of the microphone's ports."""

    @property
    def distinct(self) -> tuple[Cell, ...]:
        """Every cell that must be solved, in order of first use."""
        return tuple(dict.fromkeys(use.cell for use in self.points + self.microphones))


def canonical_ports(
    ports: Sequence[CellPort], shape: Box | Dome | None = None
) -> tuple[tuple[CellPort, ...], tuple[int, ...]]:
    """Bring ports to canonical rotation, reflection and order.

    Args:
        ports: at any angles; those of a box as seen from its own x axis.
        shape: of the cavity: a box is turned and reflected into itself only.

    Returns:
        The canonical ports, and for each given port its place among them.
    """
    return _canonical(tuple(ports), shape)


@lru_cache(maxsize=256)  # designs of a study have the same few angles
def _canonical(ports: tuple[CellPort, ...], shape: Box | Dome | None) -> tuple[tuple[CellPort, ...], tuple[int, ...]]:
    turns = [port.angle for port in ports]
    if isinstance(shape, Box):
        turns = [0.0, 90.0, 180.0, 270.0] if shape.length == shape.width else [0.0, 180.0]
    candidates = []
    for turn in turns:
        for sense in (1.0, -1.0):
            moved = [
                CellPort(
                    round(round(sense * (port.angle - turn) / ANGLE_STEP) * ANGLE_STEP % 360.0, 6),
                    port.bore_diameter,
                    port.height,
                )
                for port in ports
            ]
            ranked = sorted(range(len(moved)), key=[port_rank(port) for port in moved].__getitem__)
            candidates.append((tuple(moved[k] for k in ranked), ranked))
    best, ranking = min(candidates, key=lambda candidate: [port_rank(port) for port in candidate[0]])
    return best, tuple(ranking.index(k) for k in range(len(best)))


def resonator_cell(resonator: Resonator, ports: Sequence[Port], bores: Sequence[float] | None = None) -> CellUse:
    """The air that a shell with these ports leaves, in its canonical form.

    Args:
        resonator: as :func:`geometry.solids.shell.build_shell` takes it.
        ports: as it takes them, at any angles: a box lies as in the one shell that serves all its rotations.
        bores: of the tubes for the air, mm, one per port; by default those of the ports.
    """
    shape, own = resonator.cavity_shape, resonator.port_axis_height
    placed = [replace(port, height=None if port.height == own else port.height) for port in ports]
    bores = bores or [port.bore_diameter for port in ports]
    turn = in_common_rotation(placed, ANGLE_STEP)[1]
    canonical, order = canonical_ports(
        [CellPort(port.angle - turn, bore, port.height) for port, bore in zip(placed, bores, strict=True)], shape
    )
    cell = Cell(
        kind="resonator",
        diameter=resonator.cavity_diameter,
        height=resonator.cavity_height,
        port_height=max(own, max(bores) / 2),  # a bore on the floor that counts as wider stays above it
        ports=canonical,
        opening_diameter=resonator.cavity_diameter,
        opening_length=0.0,
        shape=shape,
    )
    return CellUse(cell, order)


def cell_catalogue(design: ArrayDesign, layout: Housings) -> CellCatalogue:
    """Distinct cells of a design whose parts lie as the layout says."""
    microphone = design.microphone
    known: dict[object, CellUse] = {}
    tubes_of = [design.tubes_of(line) for line in design.lines]
    points = []
    for placement in layout.points:
        line, place = design.lines[placement.line], placement.place
        tubes = tubes_of[placement.line][place : place + 2]
        what = (design.kind_at(line, place), placement.port_angles, tubes)
        if what not in known:
            bores = [tube.acoustic_diameter for tube in tubes]
            known[what] = resonator_cell(design.resonator_at(line, place), placement.ports, bores)
        points.append(known[what])
    microphones = []
    for housing in layout.microphones:
        bores = [design.microphone_tube_of(design.lines[end.line]).acoustic_diameter for end in housing.ports]
        canonical, order = canonical_ports(
            [CellPort(end.angle, bore) for end, bore in zip(housing.ports, bores, strict=True)]
        )
        microphones.append(
            CellUse(
                Cell(
                    kind="microphone",
                    diameter=microphone.chamber_diameter,
                    height=microphone.chamber_height,
                    port_height=microphone.chamber_height / 2,
                    ports=canonical,
                    opening_diameter=microphone.sound_hole_diameter,
                    opening_length=microphone.sound_hole_length,
                ),
                order,
            )
        )
    return CellCatalogue(tuple(points), tuple(microphones))
