"""The array unrolled at full scale as PDF: where each numbered shell goes, for the bench on which lines are glued."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from geometry.assembly.model import ArrayModel
from geometry.ground.typed import Array
from geometry.ground.whole_files import whole_file
from geometry.surface.in_space import plan_in_space
from studies.kit.cutting_template import PAGES, SCALE_BAR
from studies.output.figure_style import figure_in_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Margin of a page, height of its title with the bar, and what neighbouring pages share, mm.
_MARGIN, _HEAD, _SHARED = 12.0, 26.0, 10.0


def write_pattern(model: ArrayModel, folder: Path) -> tuple[float, float]:
    """Write ``pattern-a4.pdf`` and ``pattern-letter.pdf`` into a folder that exists.

    Returns:
        Root mean square and largest of what distances between neighbours are off in the pattern, as fractions.
    """
    found = plan_in_space(model.design, model.layout)
    stretch = found.stretch, found.worst
    for page in PAGES:
        with whole_file(folder / f"pattern-{page}.pdf") as beside:
            _write(model, beside, page, stretch)
    return stretch


def _write(model: ArrayModel, path: Path, page: str, stretch: tuple[float, float]) -> None:
    from matplotlib.backends.backend_pdf import PdfPages

    width, height = PAGES[page]
    room = width - 2 * _MARGIN, height - 2 * _MARGIN - _HEAD
    low, high = _extent(model)
    # In the middle of a page that has room for all.
    low = low - np.maximum(np.array(room) - (high - low), 0) / 2
    columns, rows = (max(1, math.ceil((high[k] - low[k] - _SHARED) / (room[k] - _SHARED) - 1e-9)) for k in (0, 1))
    title = f"{model.design.name}: pattern"
    with PdfPages(path, metadata={"Title": title}) as file:
        for row in range(rows):
            for column in range(columns):
                corner = low + np.array([column * (room[0] - _SHARED), row * (room[1] - _SHARED)])
                with figure_in_style((width / 25.4, height / 25.4), **{"pdf.fonttype": 42}) as figure:
                    figure.set_layout_engine("none")  # a millimetre of the axes is one of the paper
                    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
                    axes.set(xlim=(0, width), ylim=(0, height))
                    axes.set_axis_off()
                    number = row * columns + column + 1
                    _head(axes, f"{title}, page {number} of {rows * columns}", height, stretch, rows * columns > 1)
                    inner = figure.add_axes((_MARGIN / width, _MARGIN / height, room[0] / width, room[1] / height))
                    inner.set(xlim=(corner[0], corner[0] + room[0]), ylim=(corner[1], corner[1] + room[1]))
                    inner.set_axis_off()
                    _parts(inner, model)
                    file.savefig(figure)


def _extent(model: ArrayModel) -> tuple[Array, Array]:
    """Corners of what the pattern shows, (2,) float64 each, mm."""
    layout = model.layout
    places = np.array([p.position for p in layout.points] + [m.position for m in layout.microphones])
    beside = max(model.design.resonator.outer_diameter, *model.design.microphone.board_size)
    return places.min(axis=0) - beside, places.max(axis=0) + beside


def _head(axes: Axes, title: str, height: float, stretch: tuple[float, float], tiled: bool) -> None:
    top = height - _MARGIN
    axes.text(_MARGIN, top, title, fontsize=12, va="top")
    words = (
        f"Seen from outside. Print at 100 %. Distances between neighbours are off by {100 * stretch[0]:.1f} % (rms), "
        f"by {100 * stretch[1]:.0f} % at worst."
    )
    axes.text(_MARGIN, top - 7, words, fontsize=8, va="top")
    if tiled:
        axes.text(_MARGIN, top - 11, f"Pages share a strip of {_SHARED:g} mm.", fontsize=8, va="top")
    bar = top - 19
    axes.plot([_MARGIN, _MARGIN + SCALE_BAR], [bar, bar], color="black", linewidth=0.8)
    for end in (0.0, SCALE_BAR):
        axes.plot([_MARGIN + end] * 2, [bar - 1.5, bar + 1.5], color="black", linewidth=0.8)
    axes.text(_MARGIN + SCALE_BAR + 3, bar, f"{SCALE_BAR:g} mm", fontsize=8, va="center")


def _parts(axes: Axes, model: ArrayModel) -> None:
    from matplotlib.patches import Circle

    design, layout = model.design, model.layout
    for tube in layout.tubes:
        (x0, y0, _), (x1, y1, _) = tube.path[0], tube.path[-1]
        axes.plot([x0, x1], [y0, y1], color="#8a8a8a", linewidth=0.8, zorder=1)
        middle = (x0 + x1) / 2, (y0 + y1) / 2
        axes.text(*middle, f"{tube.tube.length:g}", fontsize=4, color="#555555", ha="center", va="center", zorder=4)
    outer = design.resonator.outer_diameter / 2
    for point in layout.points:
        axes.add_patch(Circle(point.position, outer, facecolor="white", edgecolor="black", linewidth=0.5, zorder=2))
        size = min(9.0, 0.9 * outer * 72 / 25.4)
        axes.text(*point.position, str(point.number), fontsize=size, ha="center", va="center", zorder=3)
    chamber = design.microphone.chamber_diameter / 2 + design.microphone.wall_thickness
    for microphone in layout.microphones:
        circle = Circle(microphone.position, chamber, facecolor="white", edgecolor="#4f7f6b", linewidth=1.0, zorder=2)
        axes.add_patch(circle)
        axes.text(
            *microphone.position, microphone.name, fontsize=7, color="#4f7f6b", ha="center", va="center", zorder=3
        )
