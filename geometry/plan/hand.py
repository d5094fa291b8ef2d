"""The plan of a glove: fingers that fan out from the wrist, each with a few points of one line.

A line runs up its first finger, over to the next one and down, and so on; every line begins on a finger of its
own. Along a finger the tubes lie straight; from finger to finger they bow out to their exact length.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from geometry.ground.typed import Array
from geometry.plan.meeting import angle_between, meetings
from geometry.plan.routing import unit
from geometry.schema.array_fields import StatedArray

#: Fingers of a hand, with the thumb.
FINGERS = 5
#: Where a design gives none: wrist to knuckles of a medium hand, mm; fingers some 20 mm apart at their ends, degrees.
PALM, SPREAD = 80.0, 9.0


def fingers_of(design: StatedArray) -> list[int]:
    """Number of fingers that each line takes."""
    return [math.ceil(line.points / design.layout.columns) for line in design.lines]


def finger_positions(design: StatedArray) -> list[Array]:
    """Axes of the points of each line in plan, (n_point, 2) float64, mm; the wrist at (0, 0), fingers towards +y."""
    fingers, columns = fingers_of(design), design.layout.columns
    palm, spread = design.layout.palm or PALM, design.layout.spread or SPREAD
    runs, first = [], 0
    for line, count in zip(design.lines, fingers, strict=True):
        place = np.arange(line.points)
        finger, step = place // columns, place % columns
        step = np.where(finger % 2 == 0, step, columns - 1 - step)
        reach = palm + step * design.pitch_of(line)
        angle = 90 + spread * ((sum(fingers) - 1) / 2 - first - finger)
        runs.append(reach[:, None] * np.array([unit(a) for a in angle]))
        first += count
    return runs


def longest_step(design: StatedArray) -> tuple[float, int]:
    """Length by which a line's tubes are too short for its points at worst, mm (negative: all reach), and the line."""
    excess = []
    for index, (line, positions) in enumerate(zip(design.lines, finger_positions(design), strict=True)):
        reach = design.resonator.cavity_diameter + design.tube_of(line).length
        excess += [(float(np.linalg.norm(b - a)) - reach, index) for a, b in pairwise(positions)]
    return max(excess, default=(-math.inf, 0))


def meeting_angle(design: StatedArray, microphone: str) -> float | None:
    """Angle between the two straight tubes that meet at a microphone, degrees; None where no two tubes do."""
    positions = finger_positions(design)
    meeting = meeting_at(design, positions, microphone)
    if meeting is None:
        return None
    first, second = (
        points[-line.between.index(microphone)]
        for line, points in zip(design.lines, positions, strict=True)
        if microphone in line.between
    )
    return angle_between(meeting, first, second)


def meeting_at(design: StatedArray, positions: list[Array], microphone: str) -> Array | None:
    """Place where the two straight tubes that end at a microphone meet.

    Args:
        design: the array.
        positions: axes of the points of each line in plan, (n_point, 2) float64, mm.
        microphone: its name.

    Returns:
        (2,) float64, mm, in plan: of the two places the one nearer to the wrist; None where no two tubes meet.
    """
    ends = [(line, points) for line, points in zip(design.lines, positions, strict=True) if microphone in line.between]
    if len(ends) != 2:
        return None
    points = [points[-line.between.index(microphone)] for line, points in ends]
    reach = [design.microphone_reach_of(line, line.between.index(microphone)) for line, _ in ends]
    places = meetings(points[0], points[1], reach[0], reach[1])
    return min(places, key=lambda place: float(np.linalg.norm(place)), default=None)
