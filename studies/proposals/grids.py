"""Layouts that answer a question: rows and columns of points, and the side of their microphones."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from studies.proposals.designer_question import Question

#: Largest factor by which the shape of a grid differs from that of its room.
_WIDEST = 1.6
#: Grids that are tried for one question, those most like the room first.
GRIDS = 4


@dataclass(frozen=True)
class Grid:
    """Rows and columns of points, and where their microphones lie."""

    kind: str
    """Kind of the layout."""
    points: int
    """Number of points."""
    columns: int
    """Points in a row; of a hand on a finger; of a grid whose rows are turned in a column."""
    side: str
    """``layout.microphone_side``."""

    @property
    def rows(self) -> int:
        """Number of rows."""
        return -(-self.points // self.columns)

    def layout(self, asked: Question) -> dict[str, Any]:
        """The table of the layout in a design file."""
        own: dict[str, Any] = {"kind": self.kind, "columns": self.columns, "microphone_side": self.side}
        if asked.around is not None:
            own["diameter"] = round(asked.around / math.pi, 3)
        return own

    def lines(self, names: list[str]) -> list[dict[str, Any]]:
        """A chain of lines from microphone to microphone, of whole rows where these suffice, as equal as can be.

        Lines along fingers go to a tip and back, so all but the last have an even number of fingers. Their microphones
        then lie at the palm, where the next line begins.
        """
        pairs = list(itertools.pairwise(names))
        whole = self.points % self.columns == 0 and self.points // self.columns >= len(pairs)
        unit = self.columns if whole else 1
        count = self.points // unit
        each, more = divmod(count, len(pairs))
        counts = [each + (k < more) for k in range(len(pairs))]
        even = max(2 * round(count / len(pairs) / 2), 2)
        if self.kind == "hand" and whole and even * (len(pairs) - 1) < count:
            counts = [even] * (len(pairs) - 1) + [count - even * (len(pairs) - 1)]
        return [{"between": list(pair), "points": unit * own} for pair, own in zip(pairs, counts, strict=True)]


def grids(asked: Question, points: int) -> list[Grid]:
    """Layouts of a number of points that may answer a question, those most like the room first."""
    return list(itertools.islice(_unlimited(asked, points), 2 * GRIDS))


def _unlimited(asked: Question, points: int) -> Iterator[Grid]:
    if asked.kind == "around":
        if asked.rows in (None, 1) and asked.columns in (None, points) and asked.pitch is None:
            yield Grid("cylinder", points, points, "front")
        for columns in _columns(asked, points, 2.0):
            if 1 < columns < points and points % columns == 0:
                yield Grid("cylinder", points, columns, "ends")
        return
    if asked.kind == "hand":
        for columns in _columns(asked, points, points / 16):
            if points % columns == 0:
                yield Grid("hand", points, columns, "ends")
        return
    for columns in _columns(asked, points, _aspect(asked)):
        if asked.microphones > 2:
            yield Grid("area", points, columns, "ends")
            continue
        rows = -(-points // columns)
        both = rows % 2 == 0 and points == rows * columns
        if asked.size is None and asked.tubes_below is None:
            yield Grid("serpentine", points, columns, "left" if both and columns > 1 else "ends")
        else:
            yield Grid("serpentine", points, columns, "below")
            if asked.tubes_below is None:
                yield Grid("serpentine", points, columns, "left" if both and columns > 1 else "ends")


def _aspect(asked: Question) -> float:
    """Columns by rows that are wished."""
    return 2.0 if asked.size is None else asked.size[0] / asked.size[1]


def _columns(asked: Question, points: int, aspect: float) -> list[int]:
    """Numbers of columns, those of the wished aspect first; full rows before others of nearly the same aspect."""
    if asked.columns is not None:
        return [asked.columns] if asked.rows in (None, -(-points // asked.columns)) else []
    if asked.rows is not None:
        return [columns for columns in range(1, points + 1) if -(-points // columns) == asked.rows][:1]
    wished = math.sqrt(aspect * points)

    def unlike(columns: int) -> float:
        return abs(math.log(columns / wished))

    def last(columns: int) -> tuple[bool, int, float]:
        # a last row that is not full rather than rows over twice as long or short
        return unlike(columns) > math.log(2), -points % columns, unlike(columns)

    widest = math.inf if asked.size is None else _WIDEST  # an array within a size fills it
    possible = [
        columns
        for columns in range(1, points + 1)
        if unlike(columns) <= min(math.log(2) if points % columns else math.inf, math.log(widest))
    ]
    return sorted(possible, key=last)[:GRIDS] or sorted(range(1, points + 1), key=unlike)[:1]  # as near as there is
