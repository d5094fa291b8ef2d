"""The tubes of an array: their ports in the housings, and the cutting list - they are bought, not printed."""

from __future__ import annotations

from dataclasses import dataclass

from geometry.design import ArrayDesign, Tube


@dataclass(frozen=True, order=True)
class Port:
    """Where a tube enters a housing: direction in degrees, bore and outside of the tube in mm."""

    angle: float
    bore_diameter: float
    tube_diameter: float
    height: float | None = None
    """Of its axis above the floor of the cavity, mm; None: that of the housing's ports."""


@dataclass(frozen=True)
class Cut:
    """Equal pieces of tube, lengths in mm."""

    use: str
    """``segment`` between points or ``microphone`` from the end of a line."""
    tube: Tube
    cut_length: float
    """Of the piece: its ends stop on the lips of the ports, which carry on the bore to the cavity walls."""
    count: int

    @property
    def total_length(self) -> float:
        """Length of all pieces, without the saw."""
        return self.count * self.cut_length


def cutting_list(design: ArrayDesign) -> tuple[Cut, ...]:
    """Every kind of piece with its count, in order of first use."""
    counts: dict[tuple[str, Tube], int] = {}
    for line in design.lines:
        for use, tube, count in (
            ("microphone", design.microphone_tube_of(line), 2),
            ("segment", design.tube_of(line), line.points - 1),
        ):
            counts[use, tube] = counts.get((use, tube), 0) + count
    lips = 2 * design.printing.port_lip
    return tuple(Cut(use, tube, round(tube.length - lips, 6), count) for (use, tube), count in counts.items() if count)
