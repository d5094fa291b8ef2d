"""The most points that work in a given room."""

from __future__ import annotations

import math
from dataclasses import replace

from geometry.schema.print_processes import find_process
from studies.proposals.design_search import LEAN, Found, Progress, search, silent, thorough
from studies.proposals.designer_question import Question

#: Smallest cavity, mm, and smallest tube between two shells beyond their walls, mm, that are counted on.
_CAVITY, _TUBE = 2.0, 0.4


def most_points(asked: Question, name: str, progress: Progress) -> list[Found]:
    """Designs of the largest number of points that works, the best first; of the fewest tried if none does.

    Accuracy falls as points are added, so that the number is found by halving an interval.

    Args:
        asked: the question, with a size and without a number of points.
        name: name of the designs.
        progress: called with the name of a step and the fraction done.
    """
    counts = grid_counts(asked)
    low, high = -1, len(counts)
    found: list[Found] = []
    while high - low > 1:
        middle = (low + high) // 2
        progress(f"{counts[middle]} points", 0.5 * (middle + 1) / (len(counts) + 1))
        tried = search(replace(asked, points=counts[middle]), name, counts[middle], LEAN, silent)
        if _works(tried):
            low, found = middle, tried
        else:
            high = middle
    # Few designs of each number were tried, so larger numbers may work after all.
    tried, climbed = list[Found](), False
    for points in counts[low + 1 :]:
        tried = search(replace(asked, points=points), name, points, thorough(points), progress)
        if not _works(tried):
            break
        found, climbed = tried, True
    if climbed or not found:
        return found or tried
    more = search(replace(asked, points=counts[low]), name, counts[low], thorough(counts[low]), progress)
    return more if _works(more) else found


def _works(found: list[Found]) -> bool:
    return bool(found) and found[0].verdict.outcome == "works"


def grid_counts(asked: Question) -> list[int]:
    """Numbers of points of full grids that shells leave room for, in ascending order."""
    assert asked.size is not None
    wall = max(0.8, find_process(asked.printer).wall.advised)
    shell = _CAVITY + 2 * wall
    least = max(shell, _CAVITY + 2 * wall + _TUBE) if asked.pitch is None else asked.pitch
    columns, rows = (int((side - shell) / least) + 1 for side in asked.size)
    if asked.rows is not None:
        rows = asked.rows
    if asked.columns is not None:
        columns = asked.columns
    aspect = asked.size[0] / asked.size[1]
    counts = {
        c * r
        for c in range(1, columns + 1)
        for r in range(1, rows + 1)
        if c * r >= asked.microphones and abs(math.log(c / r / aspect)) <= math.log(1.6)
    }
    return sorted(count for count in counts if count <= 400) or [max(asked.microphones, 2)]
