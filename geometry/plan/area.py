"""The plan of an area: one path over a grid that all lines follow, one after the other, with microphones around it.

Where the lines form a chain the path goes along the rows, every second one backwards. Where they form a circle it
comes back to its beginning: it goes up and down the columns above the lowest row and returns along that row, or the
same with rows and columns exchanged. It begins where every microphone comes to lie at the edge.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from geometry.ground.typed import Array
from geometry.plan.meeting import angle_between, meetings
from geometry.schema.array_fields import StatedArray

Cell = tuple[int, int]


def is_chain(design: StatedArray) -> bool:
    """True where each line begins at the microphone at which the one before it ends, and no microphone joins three."""
    lines = design.lines
    follows = all(one.between[1] == other.between[0] for one, other in pairwise(lines))
    return follows and len({line.between[0] for line in lines}) == len(lines)


def is_closed(design: StatedArray) -> bool:
    """True where the last line ends at the microphone at which the first one begins."""
    return design.lines[-1].between[1] == design.lines[0].between[0]


def grid_of(design: StatedArray) -> tuple[int, int]:
    """Columns and rows of the grid; the last row need not be full."""
    columns = min(design.layout.columns, design.point_count)
    return columns, -(-design.point_count // columns)


def has_closed_path(design: StatedArray) -> bool:
    """True where a path over all places of the grid can come back to its beginning."""
    columns, rows = grid_of(design)
    even = columns * rows % 2 == 0 and columns * rows == design.point_count
    return even and min(columns, rows) > 1


def cells_of(design: StatedArray) -> list[list[Cell]]:
    """Column and row of the points of each line.

    The path of a circle begins at the first place from which no end of a line lies inside; at its first where there is
    none, see :func:`ends_inside`.
    """
    columns, rows = grid_of(design)
    if not is_closed(design):
        path = [(k if row % 2 == 0 else columns - 1 - k, row) for row in range(rows) for k in range(columns)]
        return _cut(path[: design.point_count], design)
    path = _circle(columns, rows) if columns % 2 == 0 else [(x, y) for y, x in _circle(rows, columns)]
    starts = (_cut(path[start:] + path[:start], design) for start in range(len(path)))
    return next((cells for cells in starts if not _joints_inside(cells, True, columns, rows)), _cut(path, design))


def ends_inside(design: StatedArray) -> tuple[int, ...]:
    """Indices of the lines at whose end the microphone would lie between points."""
    return _joints_inside(cells_of(design), is_closed(design), *grid_of(design))


def tube_lengths(design: StatedArray) -> tuple[set[float], set[float]]:
    """Lengths of the tubes along the rows, and of those along the columns, mm."""
    found: tuple[set[float], set[float]] = (set(), set())
    for line, cells in zip(design.lines, cells_of(design), strict=True):
        for tube, (one, other) in zip(design.segments_of(line), pairwise(cells), strict=True):
            found[one[0] == other[0]].add(tube.length)
    return found


def area_positions(design: StatedArray) -> list[Array]:
    """Axes of the points of each line in plan, (n_point, 2) float64, mm; the first column and row at 0."""
    along, across = tube_lengths(design)
    fallback = along | across or {design.tube.length}
    pitch = [design.resonator.cavity_diameter + max(lengths or fallback) for lengths in (along, across)]
    return [np.array(cells, np.float64) * pitch for cells in cells_of(design)]


def outside_at(design: StatedArray, positions: list[Array], microphone: str) -> Array | None:
    """Place outside the area where the two straight tubes that end at a microphone meet.

    Args:
        design: the array.
        positions: (n, 2) float64, mm, of :func:`area_positions`.
        microphone: its name.

    Returns:
        (2,) float64, mm, in plan; None where only one tube ends there, or the two do not reach.
    """
    ends = _ends(design, positions, microphone)
    if len(ends) != 2:
        return None
    (first, first_reach), (second, second_reach) = ends
    middle = np.vstack(positions).mean(axis=0)
    places = meetings(first, second, first_reach, second_reach)
    return max(places, key=lambda place: float(np.linalg.norm(place - middle)), default=None)


def outside_angle(design: StatedArray, microphone: str) -> float | None:
    """Angle between the two straight tubes that meet at a microphone, degrees; None where no two tubes do."""
    positions = area_positions(design)
    place = outside_at(design, positions, microphone)
    if place is None:
        return None
    (first, _), (second, _) = _ends(design, positions, microphone)
    return angle_between(place, first, second)


def shortest_reach(design: StatedArray) -> tuple[float, str]:
    """Length by which the tubes to a microphone are too short to meet, at worst, mm (at most 0: all reach), and its
    name.
    """
    positions = area_positions(design)
    lacking = [(0.0, "")]
    for name in design.microphones:
        ends = _ends(design, positions, name)
        if len(ends) == 2:
            (first, first_reach), (second, second_reach) = ends
            apart = float(np.linalg.norm(second - first))
            lacking.append((max(apart - first_reach - second_reach, abs(first_reach - second_reach) - apart), name))
    return max(lacking)


def _ends(design: StatedArray, positions: list[Array], microphone: str) -> list[tuple[Array, float]]:
    """Last points of the lines that end at a microphone, and how far its tubes reach from them, mm."""
    ends = [
        (line, points, line.between.index(microphone))
        for line, points in zip(design.lines, positions, strict=True)
        if microphone in line.between
    ]
    return [(points[-end], design.microphone_reach_of(line, end)) for line, points, end in ends]


def _circle(columns: int, rows: int) -> list[Cell]:
    """A path over all places of a grid of an even number of columns that comes back beside its beginning."""
    path = [(column, 0) for column in range(columns)]
    for column in range(columns - 1, -1, -1):
        upwards = (columns - 1 - column) % 2 == 0
        path += [(column, row) for row in (range(1, rows) if upwards else range(rows - 1, 0, -1))]
    return path


def _cut(path: list[Cell], design: StatedArray) -> list[list[Cell]]:
    """The path, cut into the lines."""
    stops = np.cumsum([0, *(line.points for line in design.lines)]).tolist()
    return [path[start:stop] for start, stop in pairwise(stops)]


def _joints_inside(cells: list[list[Cell]], closed: bool, columns: int, rows: int) -> tuple[int, ...]:
    """Lines whose end and the beginning of the next do not lie together at one edge of the grid."""
    followers = [*cells[1:], *(cells[:1] if closed else [])]
    return tuple(
        index
        for index, (own, after) in enumerate(zip(cells, followers, strict=False))
        if not any(
            one[axis] == other[axis] == edge
            for one, other in [(own[-1], after[0])]
            for axis, edge in ((0, 0), (0, columns - 1), (1, 0), (1, rows - 1))
        )
    )
