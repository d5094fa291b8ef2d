"""Microphones and lines as a graph: what may be wired, and the paper's counting rules."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from geometry.ground.argument_checks import check_range, out_of_range
from geometry.ground.refusal import Kind, Refusal, counted


@dataclass(frozen=True)
class WiringCounts:
    """Figures of how economical a wiring is (counting rules of the paper)."""

    microphones: int
    """Number of microphones, M."""
    lines: int
    """Number of lines."""
    points: int
    """Number of points of all lines together."""
    most_lines: int
    """Largest number of lines between that many microphones, M(M-1)/2."""
    points_per_microphone: float
    """Number of points per microphone."""
    gain_over_one_transducer_per_point: float
    """Points per transducer, by those of an array with one transducer at every point; a ratio."""
    gain_over_row_column: float
    """Points per transducer, by those of row-column addressing of M x N points; a ratio."""


def check_topology(microphones: Sequence[str], lines: Sequence[tuple[tuple[str, str], int]]) -> None:
    """Refuse wirings that cannot be decoded or built.

    Args:
        microphones: their names.
        lines: per line the two microphones at its ends and its number of points.

    Raises:
        Refusal: with the field, the value and what is allowed.
    """
    names = list(microphones)
    duplicates = sorted({name for name in names if names.count(name) > 1})
    if duplicates:
        problem = f"must be different names; {duplicates[0]!r} appears twice"
        raise Refusal(problem, kind=Kind.CONFLICT, field="microphones", value=names)
    most = len(names) * (len(names) - 1) // 2
    if len(lines) > most:
        count = counted(len(names), "microphone")
        problem = f"has {len(lines)} entries for {count}; it must have at most M(M-1)/2 = {most}"
        raise Refusal(problem, kind=Kind.CONFLICT, field="lines")
    pairs: dict[frozenset[str], int] = {}
    for index, ((first, second), _) in enumerate(lines):
        between: dict[str, Any] = {"field": f"lines.{index}.between", "value": [first, second]}
        if first == second or not {first, second} <= set(names):
            kind = Kind.CONFLICT if first == second else Kind.UNKNOWN
            raise Refusal(kind=kind, allowed=f"two different microphones of {names}", **between)
        pair = frozenset((first, second))
        if pair in pairs:
            problem = f"joins the same two microphones as lines.{pairs[pair]}"
            raise Refusal(problem, kind=Kind.CONFLICT, **between)
        pairs[pair] = index
    reached = {names[0]}
    while True:
        more = {name for pair in pairs for name in pair if pair & reached} - reached
        if not more:
            break
        reached |= more
    for name in names:
        if name not in reached:
            on_line = any(name in pair for pair in pairs)
            problem = f"has {name!r}, which {f'cannot be reached from {names[0]!r}' if on_line else 'is on no line'}"
            remedy = f"let the lines connect all of {names}"
            raise Refusal(problem, kind=Kind.CONFLICT, field="microphones", remedy=remedy)


def wiring_counts(microphones: int, points_per_line: Sequence[int]) -> WiringCounts:
    """Counting figures of a wiring of M microphones with N points per line (N: the mean).

    Points per transducer are points / M; one transducer per point has 1, and row-column addressing of
    M x N points has M N / (M + N). With all M(M-1)/2 lines the ratios become the paper's N(M-1)/2 and
    (M-1)(M+N)/(2M).

    Args:
        microphones: M, at least 2.
        points_per_line: points of each line, at least 1; M - 1 lines, which connect all microphones in a chain, to
            M(M-1)/2, one for every pair.

    Raises:
        Refusal: a number out of range.
    """
    check_range("microphones", microphones, 2)
    most = microphones * (microphones - 1) // 2
    if not microphones - 1 <= len(points_per_line) <= most:
        allowed = f"M-1 = {microphones - 1} to M(M-1)/2 = {most} lines for {counted(microphones, 'microphone')}"
        raise Refusal(kind=Kind.CONFLICT, field="points_per_line", value=list(points_per_line), allowed=allowed)
    if min(points_per_line) < 1:
        raise out_of_range("points_per_line", list(points_per_line), "at least 1 each")
    points = sum(points_per_line)
    per_line = points / len(points_per_line)
    per_microphone = points / microphones
    return WiringCounts(
        microphones=microphones,
        lines=len(points_per_line),
        points=points,
        most_lines=most,
        points_per_microphone=per_microphone,
        gain_over_one_transducer_per_point=per_microphone,
        gain_over_row_column=per_microphone * (microphones + per_line) / (microphones * per_line),
    )
