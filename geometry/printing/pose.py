"""How a part lies on the plate of its machine: which side up, and turned to fit. The report judges it as it lies."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from geometry.ground.typed import Array
from geometry.printing.overhangs import hanging_area
from geometry.schema.print_processes import PrintProcess

if TYPE_CHECKING:
    from geometry.solids.measure import Tessellation

#: Free at every side of a plate, and between the boxes of parts, mm: a brim, supports and a knife go in.
MARGIN = 3.0
#: Turns about the vertical that are tried, degrees: as drawn, across, then between.
_TURNS = (0.0, 90.0, *(float(turn) for turn in range(5, 90, 5)), *(float(turn) for turn in range(95, 180, 5)))


@dataclass(frozen=True)
class Pose:
    """How a part is laid: turned over about its x where it is built upside down, then turned about the vertical."""

    upside_down: bool
    """True where the part is built from its top."""
    turn: float
    """Angle by which it is turned about the vertical, degrees."""
    size: tuple[float, float, float]
    """Size of its box as it lies, mm."""
    fits: bool
    """True where it lies within the build volume."""

    @property
    def rotation(self) -> Array:
        """The (3, 3) float64 matrix from the part's own directions to those of the plate."""
        return _rotation(self.upside_down, self.turn)

    @property
    def words(self) -> str:
        """Words that tell the pose in the report."""
        turned = f", turned by {self.turn:g} degrees" if self.turn else ""
        return ("upside down" if self.upside_down else "as drawn") + turned


def find_pose(facets: Tessellation, process: PrintProcess) -> Pose:
    """Lay a part on the side on which less hangs, and turn it about the vertical where it does not fit as drawn.

    It is never laid on another side: what hangs and what is sealed would be others.

    Args:
        facets: of the part, z upwards.
        process: its build volume, and the angle from which faces hang; powder carries all, as drawn.
    """
    angle = process.overhang_angle
    drawn, over = (hanging_area(facets, angle, way) if angle > 0 else 0.0 for way in (False, True))
    upside_down = over < drawn - 1e-6
    poses = (_laid(facets, upside_down, turn, process) for turn in _TURNS)
    return next((pose for pose in poses if pose.fits), _laid(facets, upside_down, 0.0, process))


def _laid(facets: Tessellation, upside_down: bool, turn: float, process: PrintProcess) -> Pose:
    x, y, z = np.ptp(facets.vertices @ _rotation(upside_down, turn).T, axis=0).tolist()
    room = np.asarray(process.build_volume)
    return Pose(upside_down, turn, (x, y, z), bool((np.array([x, y, z]) <= room + 1e-6).all()))


def _rotation(upside_down: bool, turn: float) -> Array:
    cos, sin = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    about_z = np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
    return about_z @ np.diag([1.0, -1.0, -1.0]) if upside_down else about_z
