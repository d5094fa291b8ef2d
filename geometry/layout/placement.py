"""Positions of the parts of one array: the result of its layout."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.typed import Array
from geometry.plan.cylinder import Frame, Surface
from geometry.plan.routing import tightest_bend
from geometry.schema.part_fields import Tube
from geometry.schema.ports import ANGLE_STEP, Port, in_common_rotation


def point_places(design: DesignLike) -> tuple[tuple[int, int], ...]:
    """The line and the place along it, both from 0, of every point of a design in the order of the points' numbers.

    Points are counted through all lines in order; a layout is not needed for that.
    """
    design = resolve_design(design)
    return tuple((line, place) for line, each in enumerate(design.lines) for place in range(each.points))


@dataclass(frozen=True)
class PointPlacement:
    """One sensing point; angles are counted from +x, anticlockwise seen from above."""

    number: int
    """Number of the point, from 1, as :func:`point_places` counts."""
    line: int
    """Index of its line in the design."""
    place: int
    """Index along its line, from 0 at the line's first microphone."""
    position: tuple[float, float]
    """Axis of the cavity in plan, mm."""
    ports: tuple[Port, Port]
    """Ports of its shell as it lies, towards the previous and the next node of the line."""

    @property
    def port_angles(self) -> tuple[float, float]:
        """Directions of the tubes towards the previous and the next node of the line, degrees."""
        return self.ports[0].angle, self.ports[1].angle

    @cached_property
    def turned(self) -> tuple[tuple[Port, ...], float]:
        """Ports in the rotation that all equal shells share, and the angle that turns them back, degrees."""
        return in_common_rotation(self.ports, ANGLE_STEP)


@dataclass(frozen=True)
class MicrophonePort:
    """Port through which one end of a line enters a microphone chamber."""

    line: int
    """Index of the line in the design."""
    end: Literal[0, 1]
    """End of the line: 0 at its first microphone, 1 at its second."""
    port: Port
    """Port as the housing lies."""

    @property
    def angle(self) -> float:
        """Direction of the tube, degrees."""
        return self.port.angle


@dataclass(frozen=True)
class MicrophonePlacement:
    """One microphone chamber and the line ends it joins, in order of (line, end)."""

    name: str
    """Name of the microphone."""
    position: tuple[float, float]
    """Axis of the chamber in plan, mm."""
    ports: tuple[MicrophonePort, ...]
    """Line ends that it joins, in order of (line, end)."""
    depth: float = 0.0
    """Distance of its ports below those of the shells, mm."""

    @cached_property
    def turned(self) -> tuple[tuple[Port, ...], float]:
        """Ports in the rotation that all equal housings share, and the angle that turns them back, degrees."""
        return in_common_rotation([each.port for each in self.ports], ANGLE_STEP)


@dataclass(frozen=True)
class TubePlacement:
    """A routed tube from one cavity wall to the next."""

    line: int
    """Index of its line in the design."""
    segment: int
    """Number of points of its line before it: 0 and n_points are the microphone tubes."""
    tube: Tube
    """The tube as the design states it."""
    path: Array
    """Axis of the bore in plan, (n, 3) float64, mm: x, y and the height above the cavities' floors; straight from axis
    to axis where places are frozen.
    """
    course: Array
    """Axis of the bore in space, (n, 3) float64, mm: the path, but for arrays on a cylinder or a body."""
    schematic: bool = False
    """True where the path is drawn to show what it joins; its length is then not the tube's."""

    @property
    def label(self) -> str:
        """Name in notes: tubes of a line count from 1 at its first microphone."""
        return f"tube {self.segment + 1} of line {self.line + 1}"

    @property
    def is_straight(self) -> bool:
        """True if its axis has no bend; schematic tubes have no known axis."""
        return not self.schematic and tightest_bend(self.course) == math.inf


@dataclass(frozen=True)
class Housings:
    """Positions of the shells and the microphones of an array, and directions of their ports."""

    points: tuple[PointPlacement, ...]
    """Every sensing point, in the order of the numbers."""
    microphones: tuple[MicrophonePlacement, ...]
    """Every microphone, in the order of the design."""
    surface: Surface
    """Surface that the shells stand on."""

    def frame(self, placement: PointPlacement | MicrophonePlacement) -> Frame:
        """Place of a point or a microphone in space.

        Its z = 0 is the floor of the resonators' cavities, for a microphone below them moved down by its depth.
        """
        frame = self.surface.frame(*placement.position)
        depth = placement.depth if isinstance(placement, MicrophonePlacement) else 0.0
        if not depth:
            return frame
        x, y, z = frame.at(0.0, 0.0, -depth).tolist()
        return Frame((x, y, z), frame.axes)


@dataclass(frozen=True)
class ArrayLayout(Housings):
    """Positions of all parts of an array."""

    tubes: tuple[TubePlacement, ...]
    """Every tube."""
