"""Rules that makers of cheap boards state, and how near a board comes to them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise

from geometry.boards.board_pieces import BoardPlan, Layer
from geometry.ground.argument_checks import check_range
from geometry.solids.stroke_font import Point


@dataclass(frozen=True)
class BoardRules:
    """Smallest sizes of a cheap board of two layers, mm; assumed values that several makers undercut."""

    track: float = 0.15
    """Width of a track."""
    spacing: float = 0.15
    """Distance of copper to copper of another signal."""
    edge: float = 0.2
    """Distance of copper to the edge of the board."""
    hole: float = 0.2
    """Distance of copper to a hole without copper."""
    annular: float = 0.125
    """Width of the copper around a plated hole."""
    drill: float = 0.3
    """Diameter of a hole."""
    chamber: float = 0.1
    """Distance of the sound hole to the wall of the chamber: as much as the board can move in its seat."""

    def __post_init__(self) -> None:
        """Reject a size that is not positive.

        Raises:
            Refusal: a size is not positive.
        """
        for name, value in vars(self).items():
            check_range(f"rules.{name}", value, 0, 10, "mm", excluded="low")


@dataclass(frozen=True)
class Spacing:
    """Smallest value of one rule on a board."""

    rule: str
    """Name of the field of the rules."""
    value: float
    """Smallest value on the board, mm."""
    allowed: float
    """Smallest value that is allowed, mm."""
    where: str
    """Pieces that it lies between."""

    @property
    def kept(self) -> bool:
        """True if the board keeps the rule; a micrometre of rounding is allowed."""
        return self.value >= self.allowed - 1e-3


@dataclass(frozen=True)
class _Copper:
    """Convex piece of copper: everything within a distance of its corners' hull."""

    name: str
    net: str
    layers: tuple[Layer, ...]
    corners: tuple[Point, ...]
    radius: float


def closest(plan: BoardPlan, rules: BoardRules | None = None) -> tuple[Spacing, ...]:
    """Smallest value of each rule on a board, and where it is.

    Args:
        plan: the board.
        rules: rules in place of the assumed ones.
    """
    rules = rules or BoardRules()
    copper = tuple(_copper(plan))
    edges = [*pairwise(plan.outline), (plan.outline[-1], plan.outline[0])]
    apart = [
        (_distance(one, other), f"{one.name} and {other.name}")
        for one, other in combinations(copper, 2)
        if one.net != other.net and set(one.layers) & set(other.layers)
    ]
    edge = [(_to_edges(each, edges), each.name) for each in copper]
    bores = [(plan.sound_hole, "sound hole"), (plan.tie_hole, "tie hole")]
    hole = [
        (_distance(each, _Copper(name, "", (), (bore.centre,), bore.diameter / 2)), f"{each.name} and {name}")
        for each in copper
        for bore, name in bores
    ]
    ring = plan.ring
    hole = [each for each in hole if each[1] != f"ring {ring.number} and sound hole"]
    hole.append(((ring.inner - plan.sound_hole.diameter) / 2, f"ring {ring.number} and sound hole"))
    plated = [(pad.size[0], pad.drill, f"{pad.part} pin {pad.number}") for pad in plan.pads if pad.drill]
    plated += [(via.diameter, via.drill, "via") for via in plan.vias]
    annular = [((outer - drill) / 2, name) for outer, drill, name in plated]
    drills = [(drill, name) for _, drill, name in plated] + [(bore.diameter, name) for bore, name in bores]
    tracks = [(track.width, f"track {track.net}") for track in plan.tracks]
    found = {"track": tracks, "spacing": apart, "edge": edge, "hole": hole, "annular": annular, "drill": drills}
    found["chamber"] = [(plan.in_chamber, "sound hole and wall of the chamber")]
    least = {name: min(values) for name, values in found.items()}
    return tuple(Spacing(name, value, getattr(rules, name), where) for name, (value, where) in least.items())


def _copper(plan: BoardPlan) -> Iterator[_Copper]:
    both: tuple[Layer, ...] = ("top", "bottom")
    for pad in plan.pads:
        layers: tuple[Layer, ...] = both if pad.drill else ("top",)
        (x, y), (length, width) = pad.centre, pad.size
        name = f"{pad.part} pin {pad.number}"
        if pad.is_round:
            yield _Copper(name, pad.net, layers, (pad.centre,), length / 2)
        else:
            corners = tuple((x + a * length / 2, y + b * width / 2) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
            yield _Copper(name, pad.net, layers, corners, 0.0)
    yield _Copper(f"ring {plan.ring.number}", plan.ring.net, ("top",), (plan.ring.centre,), plan.ring.outer / 2)
    for via in plan.vias:
        yield _Copper("via", via.net, both, (via.centre,), via.diameter / 2)
    for track in plan.tracks:
        for start, end in pairwise(track.places):
            yield _Copper(f"track {track.net}", track.net, (track.layer,), (start, end), track.width / 2)


def _sides(piece: _Copper) -> list[tuple[Point, Point]]:
    corners = piece.corners
    if len(corners) < 3:
        return [(corners[0], corners[-1])]
    return [*pairwise(corners), (corners[-1], corners[0])]


def _distance(one: _Copper, other: _Copper) -> float:
    """Distance of two pieces, mm; at most 0 if they touch.

    Pieces of different signals never lie wholly within each other, because a pad within another would be no pad.
    """
    return min(_apart(a, b) for a in _sides(one) for b in _sides(other)) - one.radius - other.radius


def _to_edges(piece: _Copper, edges: Sequence[tuple[Point, Point]]) -> float:
    return min(_apart(side, edge) for side in _sides(piece) for edge in edges) - piece.radius


def _apart(one: tuple[Point, Point], other: tuple[Point, Point]) -> float:
    """Distance of two straight lines, mm."""
    (a, b), (c, d) = one, other
    if _left(a, b, c) * _left(a, b, d) < 0 and _left(c, d, a) * _left(c, d, b) < 0:
        return 0.0
    return min(_to_line(a, other), _to_line(b, other), _to_line(c, one), _to_line(d, one))


def _left(a: Point, b: Point, point: Point) -> float:
    return (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])


def _to_line(point: Point, line: tuple[Point, Point]) -> float:
    (ax, ay), (bx, by) = line
    length = (bx - ax) ** 2 + (by - ay) ** 2
    along = 0.0 if length == 0 else ((point[0] - ax) * (bx - ax) + (point[1] - ay) * (by - ay)) / length
    along = min(1.0, max(0.0, along))
    return math.hypot(point[0] - ax - along * (bx - ax), point[1] - ay - along * (by - ay))
