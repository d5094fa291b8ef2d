"""Parts whose places in space are stated: their frames, and smooth tubes of exact length between them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.plan.cylinder import Frame
from geometry.schema.frozen_fields import FrozenPart

#: Chords per tube.
_CHORDS = 32
#: Tubes are of their length to this fraction, and found within that many steps.
_EXACT, _STEPS = 1e-8, 60


def frame_of(part: FrozenPart) -> Frame:
    """Place of a part in space; its z is the stated normal, its x what of the stated direction is across it.

    Raises:
        Refusal: the normal has no length, or the direction is along it.
    """
    long = math.hypot(*part.normal)
    if long < 1e-9:
        raise Refusal("has no direction", kind=Kind.OUT_OF_RANGE, field="normal", value=list(part.normal))
    # Without numpy: a layout asks it of every part, and is itself asked often.
    a, b, c = (each / long for each in part.normal)
    along = a * part.x[0] + b * part.x[1] + c * part.x[2]
    u, v, w = part.x[0] - along * a, part.x[1] - along * b, part.x[2] - along * c
    across = math.hypot(u, v, w)
    if across < 1e-6 * max(math.hypot(*part.x), 1e-9):
        raise Refusal("is along the normal", kind=Kind.CONFLICT, field="x", value=list(part.x))
    u, v, w = u / across, v / across, w / across
    return Frame(part.at, ((u, v, w), (b * w - c * v, c * u - a * w, a * v - b * u), (a, b, c)))


@dataclass(frozen=True)
class FrozenSurface:
    """A surface known only where parts stand on it."""

    places: tuple[tuple[float, float], ...]
    """Place of each part in the plan, mm."""
    frames: tuple[Frame, ...]
    """Place of each part in space."""

    @cached_property
    def _at(self) -> dict[tuple[float, float], Frame]:
        return dict(zip(self.places, self.frames, strict=True))

    def frame(self, x: float, y: float) -> Frame:
        """The place of the part at (x, y) of the plan, mm."""
        return self._at[x, y]

    def outwards(self, point: Array) -> Array:
        """Normal of the part nearest to a point (3,) in space, mm: (3,) float64."""
        nearest = min(self.frames, key=lambda frame: math.dist(frame.origin, point))
        return np.array(nearest.axes[2])


@dataclass(frozen=True)
class Ways:
    """Both ends of some tubes in space, and their lengths; arrays have a row for each tube."""

    axes: tuple[Array, Array]
    """Places on the axes of the two housings at the height of the ports, (n, 3) float64, mm."""
    out: tuple[Array, Array]
    """Unit vectors in which the tube leaves each housing, (n, 3) float64."""
    inner: tuple[Array, Array]
    """Radii of the cavities, (n,) float64, mm."""
    outer: tuple[Array, Array]
    """Radii of the housings, (n,) float64, mm."""
    normals: Array
    """Mean of the normals at both ends, (n, 3) float64."""
    sides: Array
    """Side to which a longer tube bulges, (n,) float64: 1 left, -1 right."""

    def chosen(self, mask: NDArray[np.bool_]) -> Ways:
        """Ends of some of the tubes, by a mask (n,)."""
        axes, out, inner, outer = ((a[mask], b[mask]) for a, b in (self.axes, self.out, self.inner, self.outer))
        return Ways(axes, out, inner, outer, self.normals[mask], self.sides[mask])

    @property
    def mouths(self) -> tuple[Array, Array]:
        """Places where the tubes leave the housings, (n, 3) float64, mm."""
        first, last = (at + r[:, None] * u for at, r, u in zip(self.axes, self.outer, self.out, strict=True))
        return first, last

    @property
    def walls(self) -> Array:
        """Lengths within both walls, (n,) float64, mm."""
        return (self.outer[0] - self.inner[0]) + (self.outer[1] - self.inner[1])

    @property
    def shortest(self) -> Array:
        """Lengths of tubes that are straight between the walls, (n,) float64, mm."""
        first, last = self.mouths
        return np.asarray(np.linalg.norm(last - first, axis=1) + self.walls)

    @property
    def smooth(self) -> Array:
        """Lengths of the tubes as they lie best: the one nearest to an arc, (n,) float64, mm."""
        return _lengths(_Courses(self).smooth) + self.walls


def smooth_courses(ways: Ways, lengths: Array) -> Array:
    """Axes of smooth tubes of exact length between housings in space.

    A tube leaves both housings along their tangents. Between them it is the cubic nearest to an arc (handles of
    4/3 tan(b/4) R for a turn b on the radius R), with shorter handles where it must be shorter, and with a bulge to a
    side where it must be longer.

    Args:
        ways: both ends of each tube.
        lengths: of the bores from wall to wall of the cavities, (n,) float64, mm; at least ``ways.shortest``.

    Returns:
        (n, m, 3) float64, mm, from cavity wall to cavity wall.
    """
    between, courses = lengths - ways.walls, _Courses(ways)
    smooth = _lengths(courses.smooth)
    longer = between > smooth

    def course(t: Array) -> Array:
        # The length grows with the square of a small bulge: in this parameter nearly in a straight line.
        return courses.at(np.where(longer, between * np.sqrt(t), 0.0), np.where(longer, 0.0, t))

    low, high = np.zeros(len(lengths)), np.ones(len(lengths))
    f_low, f_high = smooth - between, _lengths(course(high)) - between
    t, kept = low.copy(), np.zeros(len(lengths))
    todo = np.abs(f_low) > _EXACT * between
    for _ in range(_STEPS):
        if not todo.any():
            break
        step = np.where(f_high != f_low, f_high - f_low, 1.0)
        t = np.where(todo, np.clip((low * f_high - high * f_low) / step, low, high), t)
        f = _lengths(course(t)) - between
        same = np.sign(f) == np.sign(f_low)
        # The rule of the Illinois: an end that stays twice counts half.
        f_high = np.where(same & (kept == 1), f_high / 2, f_high)
        f_low = np.where(~same & (kept == -1), f_low / 2, f_low)
        kept = np.where(same, 1, -1)
        low, f_low = np.where(same, t, low), np.where(same, f, f_low)
        high, f_high = np.where(same, high, t), np.where(same, f_high, f)
        todo &= np.abs(f) > _EXACT * between
    starts, ends = (at + r[:, None] * u for at, r, u in zip(ways.axes, ways.inner, ways.out, strict=True))
    return np.concatenate([starts[:, None], course(t), ends[:, None]], axis=1)


def _lengths(courses: Array) -> Array:
    return np.asarray(np.sqrt(np.square(np.diff(courses, axis=1)).sum(axis=2)).sum(axis=1))


#: Parameter along a tube, and the four weights of a cubic.
_S = np.linspace(0, 1, _CHORDS + 1)
_WEIGHTS = np.stack([(1 - _S) ** 3, 3 * _S * (1 - _S) ** 2, 3 * _S**2 * (1 - _S), _S**3])
#: A bulge that is flat at both ends.
_BULGE = np.sin(np.pi * _S) ** 2


class _Courses:
    """Axes of tubes between the housings, which are linear in the bulge and in what the handles are shortened by.

    Args:
        ways: both ends of each tube.
    """

    def __init__(self, ways: Ways) -> None:
        first, last = ways.mouths
        (out, back), across = ways.out, last - first
        chord = np.linalg.norm(across, axis=1)
        turn = np.arccos(np.clip(-np.einsum("nk,nk->n", out, back), -1, 1))
        half = np.minimum(turn, 3.0) / 2
        arc = np.where(turn > 1e-6, 4 / 3 * np.tan(turn / 4) / (2 * np.maximum(np.sin(half), 1e-9)), 1 / 3)
        handle = (np.minimum(arc, 1.5) * chord)[:, None]
        w0, w1, w2, w3 = _WEIGHTS[..., None]
        self._handles = w1 * (handle * out)[:, None] + w2 * (handle * back)[:, None]
        self.smooth: Array = (w0 + w1) * first[:, None] + (w2 + w3) * last[:, None] + self._handles
        """Axes nearest to an arc, (n, m, 3) float64, mm."""
        left = np.cross(ways.normals, across)
        left *= (ways.sides / np.maximum(np.linalg.norm(left, axis=1), 1e-300))[:, None]
        self._bulge = _BULGE[:, None] * left[:, None]

    def at(self, bulge: Array, shorter: Array) -> Array:
        """Axes with bulges, (n,) mm, and handles shortened by a fraction, (n,): (n, m, 3) float64, mm."""
        return np.asarray(self.smooth + bulge[:, None, None] * self._bulge - shorter[:, None, None] * self._handles)
