"""Ports, lengths and sides of the tubes between parts on a body: few shells differ, and nothing bends too far."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from geometry.ground.typed import Array
from geometry.plan.frozen import Ways, smooth_courses

#: Least angle between the two ports of a shell, degrees.
LEAST_ANGLE = 45.0
#: Steps of the lengths that are tried, mm, below the stated one.
_FINER = (0.2, 0.1, 0.05, 0.02, 0.01)
#: By how much more than a tube needs its bends are wide if they can be, so that studies may vary its bore.
_SLACK = 0.5
#: Number of equal lengths that are tried of one step.
_LENGTHS = 7
#: Slack for which a finer step of the lengths is chosen, and the finest step that is chosen for it, mm.
_WORTH, _FINE = 0.1, 0.1


def directions(places: Array, normals: Array, targets: Array) -> Array:
    """Unit vectors across the normals towards targets, all (n, 3) float64."""
    way = targets - places
    way = way - np.einsum("nc,nc->n", way, normals)[:, None] * normals
    return np.asarray(way / np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-12))


def turned(vectors: Array, normals: Array, angles: Array) -> Array:
    """Vectors across normals, turned about these by angles, radians; (n, 3) float64."""
    cos, sin = np.cos(angles)[:, None], np.sin(angles)[:, None]
    return np.asarray(cos * vectors + sin * np.cross(normals, vectors))


def rounded_ports(forward: Array, backward: Array, normals: Array, step: float) -> tuple[Array, Array, float]:
    """Directions to the next part turned so that the angle to the one before is a multiple of a step.

    Both tubes turn by half of what is rounded away.

    Args:
        forward: unit vectors towards the next part, (n, 3) float64.
        backward: the same towards the one before.
        normals: of the shells.
        step: degrees.

    Returns:
        Turned forward vectors (n, 3), angles from these to the ports before in degrees (n,), and the largest turn of a
        tube in degrees.
    """
    across = np.einsum("nc,nc->n", np.cross(forward, backward), normals)
    angle = np.degrees(np.arctan2(across, np.einsum("nc,nc->n", forward, backward))) % 360
    least = math.ceil(LEAST_ANGLE / step - 1e-9) * step
    wanted = np.clip(np.round(angle / step) * step, least, 360 - least)
    half = (wanted - angle) / 2
    return turned(forward, normals, np.radians(-half)), wanted, float(np.abs(half).max(initial=0.0))


def bends(courses: Array) -> Array:
    """Smallest radius of each axis, (n,) float64, mm, of polylines (n, m, 3): of circles through three places."""
    a, b = courses[:, 1:-1] - courses[:, :-2], courses[:, 2:] - courses[:, 1:-1]
    lengths = (np.linalg.norm(each, axis=2) for each in (a, b, a + b))
    first, second, chord = lengths
    area = np.linalg.norm(np.cross(a, b), axis=2)
    radius = np.where(area > 1e-9 * first * second, first * second * chord / np.maximum(2 * area, 1e-300), np.inf)
    return np.asarray(radius.min(axis=1))


def chosen_lengths(
    ways: Ways, stated: float, smallest: Array, least: Array, obstacles: Array, reach: float
) -> tuple[Array, Array, float]:
    """Lengths in steps, and the side to which each tube bulges.

    Each tube has the coarsest step at which it bends no further than it may, or a finer one at which it bends less.

    Args:
        ways: both ends of each tube.
        stated: coarsest step, mm.
        smallest: radius to which each tube may be bent, (n,) mm.
        least: length below which a tube is too short for its walls, (n,) mm.
        obstacles: axes of the shells, (k, 3) mm.
        reach: radius of a shell, mm, within which its own tubes do not count as near.

    Returns:
        Lengths (n,), sides (n,) and the finest step, mm.
    """
    smooth = np.maximum(ways.smooth, least)
    count = len(smooth)
    lengths, sides, bent, coarse = smooth.copy(), np.ones(count), np.full(count, -np.inf), np.zeros(count)
    for step in _steps(stated):
        longer = np.ceil(smooth / step - 1e-6) * step
        shorter = np.floor(smooth / step + 1e-6) * step
        possible = (shorter >= ways.shortest + 1e-6) & (shorter >= least - 1e-9)
        options = []
        for own in (longer, np.where(possible, shorter, longer)):
            for side in (1.0, -1.0):
                score, slack = _judged(ways, own, side, smallest, obstacles, reach, reach)
                options.append((score, own, np.full(count, side), slack))
        best = np.argmax(np.stack([score for score, *_ in options]), axis=0)
        pick = np.arange(count)
        own, side_of, slack = (np.stack(column)[best, pick] for column in list(zip(*options, strict=True))[1:])
        # A finer step for a wider bend is worth its cut down to a tenth of a millimetre only.
        better = np.where(bent < -1e-6, slack > bent + 1e-9, (slack > bent + _WORTH) & (step >= _FINE - 1e-9))
        lengths, sides = np.where(better, own, lengths), np.where(better, side_of, sides)
        bent, coarse = np.where(better, slack, bent), np.where(better, step, coarse)
        if bent.min() > (_SLACK - _WORTH if step > _FINE + 1e-9 else -1e-6):
            break
    return np.asarray(np.round(lengths, 6), np.float64), sides, float(coarse.min())


def equal_length(
    ways: Ways, stated: float, smallest: Array, least: Array, obstacles: Array, reach: float
) -> tuple[float, Array, float]:
    """One length of all tubes, in steps, and the side to which each of them bulges.

    Lengths are tried from that of the longest straight tube to that of the tube that lies longest. The step is the
    coarsest one at which no tube bends further than it may, or the one at which they bend least.

    Args:
        ways: both ends of each tube.
        stated: coarsest step, mm.
        smallest: radius to which each tube may be bent, (n,) mm.
        least: length below which a tube is too short for its walls, (n,) mm.
        obstacles: axes of the shells and the microphones, (k, 3) mm.
        reach: radius of a shell, mm, within which its own tubes do not count as near.

    Returns:
        Length, mm, sides (n,) and the step, mm.
    """
    shortest = float(np.maximum(ways.shortest + 1e-6, least).max())
    longest = max(shortest, float(np.maximum(ways.smooth, least).max()))
    found = list[tuple[float, float, Array, float]]()
    for step in _steps(stated):
        low, high = (math.ceil(each / step - 1e-6) for each in (shortest, longest))
        for count in sorted({round(each) for each in np.linspace(low, high, _LENGTHS)}):
            length = round(count * step, 6)
            own = np.full(len(least), length)
            (left, slack_left), (right, slack_right) = (
                _judged(ways, own, side, smallest, obstacles, reach, 2 * reach) for side in (1.0, -1.0)
            )
            is_left = left >= right
            worst = float(np.where(is_left, slack_left, slack_right).min())
            found.append((worst, length, np.where(is_left, 1.0, -1.0), step))
        if max(worst for worst, *_ in found) >= 0:
            break
    _, length, sides, step = max(found, key=lambda each: each[0])
    return length, sides, step


def _steps(stated: float) -> tuple[float, ...]:
    """Steps of lengths that are tried, mm, the coarsest first."""
    return (stated, *(each for each in _FINER if each < stated - 1e-9))


def _judged(
    ways: Ways, lengths: Array, side: float, smallest: Array, obstacles: Array, reach: float, most: float
) -> tuple[Array, Array]:
    """How good tubes of some lengths are that bulge to a side, and by what fraction they bend less than they may.

    Distances from obstacles above ``most``, mm, are all as good.
    """
    courses = smooth_courses(replace(ways, sides=np.full(len(lengths), side)), lengths)
    slack = np.minimum(bends(courses) / smallest - 1, _SLACK)
    room = np.minimum(_room(courses, obstacles, reach), most) / most
    return 10 * np.minimum(slack, 0.0) + 0.1 * slack + 0.01 * room, slack


def _room(courses: Array, obstacles: Array, reach: float) -> Array:
    """Distance of the middle of each course from the nearest axis that is not at its ends, (n,) float64, mm."""
    middles = courses[:, courses.shape[1] // 2]
    apart = np.linalg.norm(middles[:, None] - obstacles[None], axis=2)
    ends = np.minimum(
        np.linalg.norm(courses[:, None, 0] - obstacles[None], axis=2),
        np.linalg.norm(courses[:, None, -1] - obstacles[None], axis=2),
    )
    return np.asarray(np.where(ends > reach, apart, np.inf).min(axis=1, initial=1e9))
