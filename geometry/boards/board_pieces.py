"""Pieces of a circuit board: pads, tracks, vias, holes and words, in the coordinates of the housing, mm.

The axis of the chamber is the origin, the slot of the seat lies towards -x, and y points to the left of x when the
board is seen from the side of the microphone.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from geometry.solids.stroke_font import Point

Layer = Literal["top", "bottom"]


@dataclass(frozen=True)
class BoardPad:
    """Pad of a part, on the top or through the board."""

    part: str
    """Name of the part on the board."""
    number: str
    """Number of the pin."""
    net: str
    """Signal."""
    centre: Point
    """Its middle, mm."""
    size: Point
    """Sizes along x and y, mm."""
    drill: float = 0.0
    """Diameter of its plated hole, mm; 0 for a pad on the top alone."""
    is_round: bool = False
    """True for a disc."""


@dataclass(frozen=True)
class Ring:
    """Ring around the sound hole, which seals it when it is soldered."""

    number: str
    """Number of the pin."""
    net: str
    """Signal."""
    centre: Point
    """Its middle, mm."""
    inner: float
    """Inner diameter, mm."""
    outer: float
    """Outer diameter, mm."""


@dataclass(frozen=True)
class Track:
    """Track through some places."""

    net: str
    """Signal."""
    layer: Layer
    """Side of the board."""
    places: tuple[Point, ...]
    """Places that it joins, mm."""
    width: float
    """Width, mm."""


@dataclass(frozen=True)
class Via:
    """Plated hole that joins both sides, under the solder mask."""

    net: str
    """Signal."""
    centre: Point
    """Its middle, mm."""
    diameter: float
    """Diameter of the copper, mm."""
    drill: float
    """Diameter of the hole, mm."""


@dataclass(frozen=True)
class Bore:
    """Hole without copper."""

    name: str
    """Its use."""
    centre: Point
    """Its middle, mm."""
    diameter: float
    """Diameter, mm."""


@dataclass(frozen=True)
class PinMark:
    """Dot printed on the top beside pin 1 of the microphone; the package leaves it in sight."""

    centre: Point
    """Its middle, mm."""
    diameter: float
    """Diameter, mm."""


@dataclass(frozen=True)
class BoardWord:
    """Word printed on the top, upright when the slot of the seat points to the left."""

    text: str
    """Letters and digits."""
    centre: Point
    """Its middle, mm."""
    height: float
    """Height of a letter, mm."""


@dataclass(frozen=True)
class BoardPlan:
    """Circuit board of one microphone: a part that lies in the seat, a neck through its slot, a head outside."""

    microphone: str
    """Part number of the microphone."""
    title: str
    """Land pattern in words."""
    source: str
    """Source of the land pattern and of the pins."""
    outline: tuple[Point, ...]
    """Corners of the board, anticlockwise, mm."""
    thickness: float
    """Thickness of the board, mm."""
    sound_hole: Bore
    """Sound hole."""
    tie_hole: Bore
    """Hole that ties the cable to the head."""
    chamber: float
    """Diameter of the chamber below, whose axis is the origin, mm."""
    ring: Ring
    """Ring around the sound hole."""
    pads: tuple[BoardPad, ...]
    """Pads of microphone (MK1), capacitor (C1) and connector (J1)."""
    tracks: tuple[Track, ...]
    """Tracks."""
    vias: tuple[Via, ...]
    """Vias."""
    words: tuple[BoardWord, ...]
    """Words."""
    pin_mark: PinMark | None
    """Mark of pin 1 of the microphone; None where the board has no room beside the package."""
    package: tuple[Point, Point]
    """Two opposite corners of the package of the microphone, mm."""
    head: tuple[Point, Point]
    """Two opposite corners of the head, which lies outside the housing, mm."""
    pins: tuple[str, ...]
    """Signal of each pin of the microphone, pin 1 first."""
    wires: tuple[str, ...]
    """Signals of the connector, pin 1 first."""

    @property
    def holes(self) -> tuple[tuple[float, Point], ...]:
        """Diameter and centre of each hole that is drilled but for vias, mm: sound hole, tie hole, those of pins."""
        bores = [(bore.diameter, bore.centre) for bore in (self.sound_hole, self.tie_hole)]
        return (*bores, *((pad.drill, pad.centre) for pad in self.pads if pad.drill))

    @property
    def volume(self) -> float:
        """Volume of the laminate, mm^3."""
        area = sum(
            x * v - u * y for (x, y), (u, v) in zip(self.outline, self.outline[1:] + self.outline[:1], strict=True)
        )
        return self.thickness * (area / 2 - sum(math.pi / 4 * diameter**2 for diameter, _ in self.holes))

    @property
    def nets(self) -> tuple[str, ...]:
        """Signals, each once."""
        return tuple(dict.fromkeys(self.wires))

    @property
    def size(self) -> Point:
        """Length and width of the whole board, mm."""
        across, along = ([corner[k] for corner in self.outline] for k in (1, 0))
        return max(along) - min(along), max(across) - min(across)

    @property
    def in_chamber(self) -> float:
        """Distance of the edge of the sound hole to the wall of the chamber, mm."""
        return self.chamber / 2 - math.hypot(*self.sound_hole.centre) - self.sound_hole.diameter / 2
