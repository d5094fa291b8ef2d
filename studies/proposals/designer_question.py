"""The question of a designer: how many points, where, in what room, with which machine, for which touch and price."""

from __future__ import annotations

import re
from contextlib import suppress
from dataclasses import dataclass, fields
from typing import Any, Literal

from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.plan import hand
from geometry.schema.field_errors import nearest
from geometry.schema.print_processes import PROCESSES, find_process
from geometry.schema.target import Target


@dataclass(frozen=True)
class Place:
    """Place of a sensor, and the usual values there."""

    words: str
    """The place in words."""
    points: int
    """Usual number of points."""
    microphones: int
    """Usual number of microphones."""
    pitch: float
    """Usual distance of neighbours where no size is given, mm."""
    size: tuple[float, float] | None = None
    """Usual length and width, mm; None where it has no limit."""
    around: float | None = None
    """Usual circumference of what the array goes around, mm; None where it is flat."""


PLACES = {
    "flat": Place("on a flat surface", 12, 2, 18.5),
    "fingertip": Place("on a fingertip", 12, 2, 18.5, size=(40.0, 35.0)),
    "wrist": Place("around a wrist or a tool", 12, 2, 18.5, around=188.0),
    "hand": Place("along the fingers of a glove", 12, 3, 21.0),
}
"""Places where a new design may go. Sizes are assumed: a large fingertip, and a wrist of 60 mm diameter."""
CONTACTS = {"finger": 6.0, "hand": 25.0, "foot": 30.0}
"""Kinds of contact and their radius, mm; assumed, the finger's as in a design file without a target."""
TARGET = "finger 0.1 N"
"""Usual touch."""
SHOWN = 3
"""Number of designs that are proposed."""
MOST = "most"
"""Word for the most points that work."""
PRINTER = "sla-resin"
"""Process of a desktop resin printer, which nothing but the designer's own word replaces."""
#: Points are so few that a verdict takes seconds.
_LIMITS: dict[str, tuple[float, float]] = {
    "points": (2, 256), "rows": (1, 256), "columns": (1, 256), "pitch": (3.0, 500.0), "microphones": (2, 16),
    "around": (30.0, 2000.0), "tubes_below": (1.0, 100.0), "budget": (0.01, 1e6),
}  # fmt: skip


@dataclass(frozen=True)
class Question:
    """Requirements of a new design; lengths in mm. :func:`question` makes and checks it."""

    place: str
    """Name of one of :data:`PLACES`."""
    points: int | None
    """Number of points; None: the most that work."""
    microphones: int
    """Number of microphones."""
    size: tuple[float, float] | None
    """Length and width in which the array fits with its microphones; None for no limit."""
    rows: int | None
    """Number of rows, if it is prescribed."""
    columns: int | None
    """Number of points in a row, if it is prescribed."""
    pitch: float | None
    """Distance between neighbours, if it is prescribed."""
    around: float | None
    """Circumference of what the array goes around; None where it is flat."""
    tubes_below: float | None
    """Room below the shells, into which microphones and their tubes may go; None: what they take."""
    printer: str
    """Name of the printing process."""
    touch: str
    """Contact and its force, in words."""
    force: float
    """Smallest force of a touch that must be located, N."""
    contact_radius: float
    """Radius of the area that a touch covers."""
    budget: float | None
    """Highest cost of the parts, USD; None for no limit."""

    @property
    def target(self) -> Target:
        """The target that a design file states."""
        return Target(size=self.size, force=self.force, contact_radius=self.contact_radius, budget=self.budget)

    @property
    def kind(self) -> Literal["flat", "around", "hand"]:
        """Kind of the surface."""
        if self.place == "hand":
            return "hand"
        return "flat" if self.around is None else "around"

    @property
    def words(self) -> str:
        """The question in a few words."""
        points = "the most points" if self.points is None else f"{self.points} points"
        where = f"around {self.around:g} mm" if self.around is not None else PLACES[self.place].words
        room = f" on {self.size[0]:g} x {self.size[1]:g} mm" if self.size is not None else ""
        return f"{points}{room or ' ' + where}, {self.microphones} microphones, {self.printer}"


def question(
    *,
    place: str | None = None,
    points: int | str | None = None,
    microphones: int | None = None,
    size: tuple[float, float] | str | None = None,
    rows: int | None = None,
    columns: int | None = None,
    pitch: float | None = None,
    around: float | None = None,
    tubes_below: float | str | None = None,
    printer: str = PRINTER,
    target: str = TARGET,
    budget: float | None = None,
) -> Question:
    """A question with the usual values of its place where none are given.

    Args:
        place: one of :data:`PLACES`; by default "wrist" if ``around`` is given, else "flat".
        points: number of points, or "most" for the most that work in ``size``; the default depends on the place, or is
            ``rows`` x ``columns``.
        microphones: number of microphones; the default depends on the place.
        size: length and width in which the array with its microphones must fit, mm, either way round; such as "30x30".
        rows: number of rows.
        columns: number of points in a row.
        pitch: distance between neighbours along their tube, mm.
        around: circumference of what the array goes around, mm: one row is a ring.
        tubes_below: room below the shells for microphones and their tubes, mm.
        printer: printing process.
        target: what touches and the smallest force that must be located, such as "finger 0.1 N" or "hand 1 N".
        budget: highest cost of the parts of one array, USD.

    Raises:
        Refusal: a value out of range, or values that exclude each other.
    """
    place = ("flat" if around is None else "wrist") if place is None else place
    if place not in PLACES:
        raise Refusal(kind=Kind.UNKNOWN, field="place", value=place, allowed=tuple(PLACES))
    usual = PLACES[place]
    if around is not None and usual.around is None:
        raise Refusal(f"goes around nothing {usual.words}", kind=Kind.CONFLICT, field="around", value=around)
    if printer not in PROCESSES and not printer.endswith(".toml"):
        guess = nearest(printer, list(PROCESSES))
        remedy = guess if guess.startswith("did you mean") else ""  # else it lists what is allowed once more
        raise Refusal(kind=Kind.UNKNOWN, field="printer", value=printer, allowed=tuple(PROCESSES), remedy=remedy)
    find_process(printer)
    grid = None if rows is None or columns is None else rows * columns
    wished = _points(points)
    if grid is not None and wished not in (None, grid):
        problem = f"is not rows x columns, {rows} x {columns} = {grid}"
        raise Refusal(problem, kind=Kind.CONFLICT, field="points", value=points)
    force, radius = _touch(target)
    found = Question(
        place=place,
        points=None if points == MOST else next(each for each in (wished, grid, usual.points) if each is not None),
        microphones=usual.microphones if microphones is None else microphones,
        size=usual.size if size is None else _size(size),
        rows=rows,
        columns=columns,
        pitch=pitch,
        around=usual.around if around is None else around,
        tubes_below=None if tubes_below is None else _length("tubes_below", tubes_below),
        printer=printer,
        touch=target,
        force=force,
        contact_radius=radius,
        budget=budget,
    )
    _check(found)
    return found


def _points(given: int | str | None) -> int | None:
    if given is None or given == MOST:
        return None
    try:
        return int(given) if isinstance(given, str) else given
    except ValueError:
        raise Refusal(kind=Kind.WRONG_TYPE, field="points", value=given, allowed=f"a whole number, or {MOST}") from None


def _size(given: tuple[float, float] | str) -> tuple[float, float]:
    """Longer and shorter side, mm."""
    sides: list[float] = []
    if isinstance(given, str):
        found = re.fullmatch(r"([\d.]+)\s*(?:mm)?\s*x\s*([\d.]+)\s*(?:mm)?", given.strip(), re.IGNORECASE)
        with suppress(ValueError):
            sides = [float(side) for side in found.groups()] if found else []
    else:
        sides = [float(side) for side in given]
    if len(sides) != 2:
        raise Refusal(kind=Kind.WRONG_TYPE, field="size", value=given, allowed="length x width in mm, such as 30x30")
    return max(sides), min(sides)


def _length(field: str, given: float | str) -> float:
    """A length in mm, with or without its unit."""
    try:
        return float(given.strip().removesuffix("mm")) if isinstance(given, str) else float(given)
    except ValueError:
        raise Refusal(kind=Kind.WRONG_TYPE, field=field, value=given, allowed="a length in mm, such as 5mm") from None


def _touch(given: str) -> tuple[float, float]:
    """Force, N, and radius of the contact, mm."""
    found = re.fullmatch(r"(?:([a-z]+)\s+)?([\d.eE+-]+)\s*N?", given.strip())
    word, text = found.groups() if found else (None, "")
    try:
        return float(text), CONTACTS[word or "finger"]
    except (ValueError, KeyError):
        allowed = f"one of {', '.join(CONTACTS)} and a force, such as {TARGET}"
        raise Refusal(kind=Kind.WRONG_TYPE, field="target", value=given, allowed=allowed) from None


def _check(asked: Question) -> None:
    stated: dict[str, Any] = {each.name: getattr(asked, each.name) for each in fields(asked)}
    for field, (least, most) in _LIMITS.items():
        if stated[field] is not None:
            check_range(field, stated[field], least, most, whole=isinstance(least, int))
    check_range("target", asked.force, 1e-6, 100.0, "N")
    if asked.size is not None:
        for side in asked.size:
            check_range("size", side, 5.0, 5000.0, "mm")
    if asked.points is None:
        if asked.size is None:
            problem = "needs a size, in which the most points are searched"
            raise Refusal(problem, kind=Kind.MISSING, field="points", value="most", remedy="give size")
        return
    most = most_microphones(asked)
    if asked.microphones > most:
        allowed = f"{'2' if most == 2 else f'from 2 to {most}'} for {asked.points} points {PLACES[asked.place].words}"
        raise Refusal(kind=Kind.CONFLICT, field="microphones", value=asked.microphones, allowed=allowed)


def most_microphones(asked: Question) -> int:
    """Largest number of microphones: each line has a point or more, on a hand two and a finger of its own."""
    points = asked.points or int(_LIMITS["points"][1])
    if asked.kind == "hand":
        return max(min(points // 2, hand.FINGERS) + 1, 2)
    if asked.kind == "around":
        return 2
    return min(points + 1, int(_LIMITS["microphones"][1]))
