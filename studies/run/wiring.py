"""How many points microphones serve, as a picture: lines in series against one transducer per point and rows + columns.

Counting rules of the paper; :func:`geometry.plan.wiring_graph.wiring_counts` has them.
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from geometry.ground.argument_checks import check_range
from geometry.plan.wiring_graph import WiringCounts, wiring_counts
from studies.output.figure_style import WIDTH, figure_in_style, save_figure
from studies.output.folders import new_picture

MOST_MICROPHONES, MOST_POINTS = 16, 1000


def wirings(microphones: int, points_per_line: int) -> tuple[WiringCounts, ...]:
    """Wirings for every number of lines that joins so many microphones: M - 1 in a chain to all M (M - 1) / 2 pairs.

    Args:
        microphones: M, 2 to 16.
        points_per_line: N, 1 to 1000.

    Raises:
        Refusal: a number out of range.
    """
    for name, value, least, most in (
        ("microphones", microphones, 2, MOST_MICROPHONES),
        ("points_per_line", points_per_line, 1, MOST_POINTS),
    ):
        check_range(name, value, least, most, whole=True)
    fewest, most_lines = microphones - 1, microphones * (microphones - 1) // 2
    return tuple(wiring_counts(microphones, [points_per_line] * lines) for lines in range(fewest, most_lines + 1))


def wiring_table(
    microphones: int, points_per_line: int, out: str | os.PathLike[str] | None = None
) -> tuple[WiringCounts, ...]:
    """Number of points that a number of microphones can serve, for every number of lines that connects them; drawn if
    you give ``out``.

    Args:
        microphones: M, 2 to 16.
        points_per_line: N, 1 to 1000.
        out: a file for the picture of :func:`draw_wirings`; a name without a suffix gets ``.png``.

    Raises:
        Refusal: a number out of range, or a file that cannot be written.
    """
    found = wirings(microphones, points_per_line)
    path = new_picture(out)
    if path is not None:
        draw_wirings(path, microphones, points_per_line)
    return found


def draw_wirings(path: str | os.PathLike[str], microphones: int, points_per_line: int) -> Path:
    """Picture of points, and points per transducer relative to the two usual wirings, over the number of microphones.

    Args:
        path: of the picture; a name without a suffix gets ``.png``.
        microphones: M, the largest number drawn, at least 2.
        points_per_line: N.

    Raises:
        Refusal: as :func:`wirings`.
    """
    from matplotlib.ticker import MaxNLocator

    counts = [wirings(count, points_per_line) for count in range(2, microphones + 1)]
    number = np.arange(2, microphones + 1)
    with figure_in_style((WIDTH, 3.4)) as figure:
        left, right = figure.subplots(1, 2)
        chain, full = (np.array([every[end].points for every in counts]) for end in (0, -1))
        left.fill_between(number, chain, full, color="#1f5f8b", alpha=0.15)
        left.plot(number, full, "o-", color="#1f5f8b", label="every pair of microphones: N M (M - 1) / 2")
        left.plot(number, chain, "o--", color="#1f5f8b", label="a chain: N (M - 1)")
        left.plot(number, number, color="#777777", label="one transducer per point: M")
        left.set(title=f"points, N = {points_per_line} per line", yscale="log")
        for field, colour, what in (
            ("gain_over_one_transducer_per_point", "#1f5f8b", "one transducer per point: N (M - 1) / 2"),
            ("gain_over_row_column", "#b5651d", "M rows + N columns: (M - 1)(M + N) / (2 M)"),
        ):
            right.plot(number, [getattr(every[-1], field) for every in counts], "o-", color=colour, label=what)
        right.set(title="points per transducer, every pair joined, relative to", ylim=(0, None))
        for axes in (left, right):
            axes.set_xlabel("microphones M")
            axes.xaxis.set_major_locator(MaxNLocator(integer=True))
            axes.legend(fontsize=8)
        return save_figure(figure, path)
