"""Where the parts of one array lie: the result of its layout."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from geometry.plan.cylinder import Cylinder, Frame, Plane
from geometry.stated.parts import Tube


@dataclass(frozen=True)
class PointPlacement:
    """One sensing point. Lengths mm, angles degrees from +x, anticlockwise seen from above."""

    number: int
    """From 1, counted through all lines in order."""
    line: int
    """Index of its line in the design."""
    place: int
    """Index along its line, from 0 at the line's first microphone."""
    position: tuple[float, float]
    """Axis of the cavity."""
    port_angles: tuple[float, float]
    """Directions of the tubes towards the previous and the next node of the line."""


@dataclass(frozen=True)
class MicrophonePort:
    """Where one end of a line enters a microphone chamber."""

    line: int
    end: Literal[0, 1]
    """0: the line's first microphone, 1: its second."""
    angle: float


@dataclass(frozen=True)
class MicrophonePlacement:
    """One microphone chamber and the line ends it joins, in order of (line, end)."""

    name: str
    position: tuple[float, float]
    ports: tuple[MicrophonePort, ...]


@dataclass(frozen=True)
class TubePlacement:
    """A routed tube from one cavity wall to the next.

    ``segment`` k runs before point k of its line; 0 and n_points are the microphone tubes.
    """

    line: int
    segment: int
    tube: Tube
    path: NDArray[np.float64]
    """(n, 3) float64, mm, along the axis of the bore, in plan: x, y and the height above the cavities' floors."""
    course: NDArray[np.float64]
    """(n, 3) float64, mm, along the axis of the bore in space: the path, but for arrays on a cylinder."""
    schematic: bool = False
    """The path is drawn to show what is joined; its length is not the tube's."""

    @property
    def label(self) -> str:
        """Name in notes: tubes of a line count from 1 at its first microphone."""
        return f"tube {self.segment + 1} of line {self.line + 1}"


@dataclass(frozen=True)
class ArrayLayout:
    """The whole array. ``notes`` says what is drawn but could not be built as drawn."""

    points: tuple[PointPlacement, ...]
    microphones: tuple[MicrophonePlacement, ...]
    tubes: tuple[TubePlacement, ...]
    notes: tuple[str, ...]
    surface: Plane | Cylinder

    def frame(self, placement: PointPlacement | MicrophonePlacement) -> Frame:
        """Where a point or a microphone stands in space; the floors of resonators' cavities lie at its z = 0."""
        return self.surface.frame(*placement.position)
