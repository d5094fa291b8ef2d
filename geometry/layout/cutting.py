"""The tubes of an array: their ports in the housings, and the cutting list - they are bought, not printed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.layout.arrangement import lay_out
from geometry.layout.placement import ArrayLayout, TubePlacement
from geometry.plan.routing import turning
from geometry.schema.part_fields import Tube

#: Axes that turn by less are straight, rad: the rounding of directions.
_STRAIGHT = 1e-3


@dataclass(frozen=True)
class Cut:
    """Equal pieces of tube."""

    use: Literal["segment", "microphone"]
    """Place of the tube: ``segment`` between points, ``microphone`` from the end of a line."""
    tube: Tube
    """The tube as the design states it."""
    cut_length: float
    """Length of the sheath along the axis, mm: its ends stop on the lips of the ports, which carry on the bore to the
    walls.
    """
    count: int
    """Number of pieces."""
    spring_length: float
    """Length of the coil before it is bent, mm, see :func:`spring_length`."""
    lines: tuple[int, ...]
    """Numbers of the lines that it is for, from 1."""
    kind: str = ""
    """Name of the kind of tube that a pattern gives; empty where there is no pattern."""

    @property
    def total_length(self) -> float:
        """Length of all sheaths, without what the saw takes, mm."""
        return self.count * self.cut_length

    @property
    def turns(self) -> float:
        """Number of turns of one coil."""
        return self.spring_length / self.tube.wire_diameter

    @property
    def place(self) -> str:
        """Words that say where it goes: ``between points of lines 2, 4``."""
        where = "between points of" if self.use == "segment" else "to microphones of"
        kind = f", kind {self.kind}" if self.kind else ""
        return f"{where} line{'s' if len(self.lines) > 1 else ''} {', '.join(map(str, self.lines))}{kind}"


def spring_length(tube: Tube, length: float, bend: float) -> float:
    """Length to which a close-wound coil is cut that lies in a bent tube, mm.

    In a bend its turns touch on the inside and gape on the axis. The wires touch at half a mean coil diameter D from
    the axis, so a turn takes the angle w / (R - D / 2) of an axis of radius R, w the wire, and w R / (R - D / 2) of its
    length. Over a bend by the angle b the coil grows by b D / 2, whatever R: a coil as long as the axis would push the
    tube out of its sockets by that.

    Args:
        tube: its spring.
        length: of the axis between the lips of the ports, mm.
        bend: angle by which the axis turns in all, radians.
    """
    return length - bend * (tube.spring_outer_diameter - tube.wire_diameter) / 2


def cut_lengths(design: ArrayDesign, placed: TubePlacement) -> tuple[float, float]:
    """Lengths of sheath and spring of one tube, mm; one that is drawn schematically is taken as straight."""
    tube, bend = placed.tube, 0.0 if placed.schematic else turning(placed.course)
    sheath = round(tube.length - 2 * design.printing.port_lip, 6)
    # In hundredths, finer than any blade, so that pieces which differ by rounding are one.
    return sheath, round(spring_length(tube, sheath, bend), 2) if bend > _STRAIGHT else sheath


def cutting_list(design: DesignLike, layout: ArrayLayout | None = None) -> tuple[Cut, ...]:
    """Every kind of piece with its count, in order of first use, those to microphones before the others.

    Args:
        design: the array.
        layout: layout of the array, if you have it already.
    """
    design = resolve_design(design)
    layout = lay_out(design) if layout is None else layout
    pieces: dict[tuple[Literal["segment", "microphone"], Tube, str, float, float], list[int]] = {}
    last = [line.points for line in design.lines]
    # The two ends of each line come first.
    tubes = sorted(layout.tubes, key=lambda placed: (placed.line, placed.segment not in (0, last[placed.line])))
    for placed in tubes:
        use: Literal["segment", "microphone"] = "microphone" if placed.segment in (0, last[placed.line]) else "segment"
        kind = design.tube_kind_at(design.lines[placed.line], placed.segment)
        pieces.setdefault((use, placed.tube, kind, *cut_lengths(design, placed)), []).append(placed.line + 1)
    return tuple(
        Cut(use, tube, sheath, len(lines), spring, tuple(sorted(set(lines))), kind)
        for (use, tube, kind, sheath, spring), lines in pieces.items()
    )
