"""Bodies of an array as upright prisms: shells with their feet, housings with the seats of their boards."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.design.shell_rules import FOOT_EDGE, ledge_height, seat_underside
from geometry.ground.typed import Array
from geometry.layout.placement import ArrayLayout, MicrophonePlacement, PointPlacement
from geometry.plan.cylinder import Frame
from geometry.plan.routing import unit
from geometry.schema.ports import foot_directions

#: Directions that are tried for a plane between two bodies; what is then not parted is said to overlap.
_TRIES = 200


@dataclass(frozen=True)
class Prism:
    """All places no further than a radius from a convex outline in plan, between two heights of a frame."""

    body: int
    """Number of the body that it is a part of: points first, then microphones."""
    frame: Frame
    """Place in space."""
    corners: Array
    """Corners of the outline in the frame's plan: one, two, or four in their order around; (n, 2) float64, mm."""
    radius: float
    """Distance from the outline to the side, mm."""
    heights: tuple[float, float]
    """Heights of both ends in the frame, mm."""
    is_trunk: bool = False
    """True where tubes end in it: the round wall of a shell or a chamber, and the seat on a chamber."""

    @property
    def reach(self) -> float:
        """Radius of a ball around the frame's origin that holds the prism, mm."""
        across = float(np.linalg.norm(self.corners, axis=1).max()) + self.radius
        return math.hypot(across, max(map(abs, self.heights)))

    def gaps(self, points: Array) -> Array:
        """Distances of points (n, 3) in space from the prism, (n,) float64, mm; negative inside.

        In plan the way out of a body is sideways, although its lid or floor may be nearer.
        """
        seen = self.frame.seen(points)
        low, high = self.heights
        beside = _from_outline(seen[:, :2], self.corners) - self.radius
        above = np.maximum(low - seen[:, 2], seen[:, 2] - high)
        outside = np.hypot(np.maximum(beside, 0), np.maximum(above, 0))
        return np.where(above > 0, outside, beside)

    def furthest(self, direction: Array) -> Array:
        """Point of the prism that lies furthest in a direction, both (3,) float64 in space, mm."""
        own = np.asarray(self.frame.axes) @ direction
        across = own[:2]
        length = math.hypot(*across)
        place = self.corners[int(np.argmax(self.corners @ across))]
        if length > 0:
            place = place + self.radius / length * across
        return self.frame.at(float(place[0]), float(place[1]), self.heights[1] if own[2] > 0 else self.heights[0])


def prisms(design: ArrayDesign, layout: ArrayLayout) -> Iterator[Prism]:
    """Everything that stands in an array, in the order of its points and microphones."""
    for number, point in enumerate(layout.points):
        yield from _shell(design, layout, number, point)
    for number, microphone in enumerate(layout.microphones):
        yield from _housing(design, layout, len(layout.points) + number, microphone)


def _shell(design: ArrayDesign, layout: ArrayLayout, body: int, point: PointPlacement) -> Iterator[Prism]:
    line, features, frame = design.lines[point.line], design.shell, layout.frame(point)
    resonator, membrane = design.resonator_at(line, point.place), design.membrane_at(line, point.place)
    top = resonator.cavity_height + ledge_height(resonator, membrane, design.printing)
    outer = resonator.outer_diameter / 2
    yield Prism(body, frame, np.zeros((1, 2)), outer, (-resonator.floor_thickness, top), is_trunk=True)
    if not features.feet:
        return
    ports, turn = point.turned
    half = features.foot_hole / 2 + FOOT_EDGE
    out = outer + features.foot_length - half
    for angle in foot_directions([port.angle for port in ports], features.feet):
        corners = np.array([np.zeros(2), out * unit(angle + turn)])
        yield Prism(body, frame, corners, half, (-resonator.floor_thickness, 0.0))


def _housing(design: ArrayDesign, layout: ArrayLayout, body: int, placed: MicrophonePlacement) -> Iterator[Prism]:
    microphone, frame = design.microphone, layout.frame(placed)
    floor = design.resonator.port_axis_height - microphone.chamber_height / 2
    radius, seat = microphone.chamber_diameter / 2 + microphone.wall_thickness, floor + microphone.chamber_height
    yield Prism(body, frame, np.zeros((1, 2)), radius, (floor - microphone.wall_thickness, seat), is_trunk=True)
    ports, turn = placed.turned
    hole = max(port.tube_diameter for port in ports) / 2 + design.printing.glue_gap
    x, y = unit(turn)
    along, across = (side / 2 + microphone.board_gap + microphone.wall_thickness for side in microphone.board_size)
    signs = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * np.array([along, across])
    corners = signs @ np.array([[x, y], [-y, x]])
    top = seat + microphone.sound_hole_length + microphone.package_height
    yield Prism(body, frame, corners, 0.0, (floor + seat_underside(microphone, hole), top), is_trunk=True)


def depth(first: Prism, second: Prism) -> float:
    """How far two prisms are in each other, mm; negative where they are not: no less than the smaller gap of both.

    Two upright cylinders by their axes. Others by planes between them (Gilbert 1966): where none is found they
    overlap, by how much is then an upper bound.
    """
    if first.frame.axes == second.frame.axes and len(first.corners) == len(second.corners) == 1:
        own_x, own_y = first.corners[0]
        x, y, z = second.frame.seen(np.array([first.frame.at(float(own_x), float(own_y), 0.0)]))[0]
        apart = max(second.heights[0] - first.heights[1] - z, first.heights[0] + z - second.heights[1])
        beside = math.hypot(x - second.corners[0, 0], y - second.corners[0, 1]) - first.radius - second.radius
        return -max(float(beside), float(apart))
    offset = _middle(first) - _middle(second)
    least = math.inf
    for _ in range(_TRIES):
        length = float(np.linalg.norm(offset))
        if length < 1e-12:
            break
        step = first.furthest(-offset) - second.furthest(offset)
        inside = -float(offset @ step) / length
        least = min(least, inside)
        if inside < 0:
            break
        change = step - offset
        fraction = -float(offset @ change) / max(float(change @ change), 1e-300)
        offset = offset + min(max(fraction, 0.0), 1.0) * change
    return least


def _middle(prism: Prism) -> Array:
    x, y = prism.corners.mean(axis=0)
    return prism.frame.at(float(x), float(y), sum(prism.heights) / 2)


def _from_outline(places: Array, corners: Array) -> Array:
    """Distances of places (n, 2) from a convex outline (k, 2), (n,) float64, mm; negative inside."""
    if len(corners) == 1:
        return np.hypot(*(places - corners[0]).T)
    ends = np.roll(corners, -1, axis=0) if len(corners) > 2 else corners[1:]
    starts = corners[: len(ends)]
    offset = ends - starts
    off = places[:, None] - starts
    fraction = np.clip(np.einsum("nkc,kc->nk", off, offset) / np.einsum("kc,kc->k", offset, offset), 0, 1)
    nearest = np.linalg.norm(off - fraction[..., None] * offset, axis=2).min(axis=1)
    if len(corners) > 2:
        left = offset[:, 0] * off[:, :, 1] - offset[:, 1] * off[:, :, 0]
        nearest = np.where((left >= 0).all(axis=1), -nearest, nearest)
    return nearest
