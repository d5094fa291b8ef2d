"""An array in plan as a figure: shells with their numbers, tubes and microphones."""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.figures import new_figure
from geometry.layout.arrangement import lay_out

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Number of points up to which each carries its number.
_NUMBERED = 64


def draw_plan(design: DesignLike) -> Figure:
    """Array in plan, mm, as it is laid out: numbered points, tubes and microphones.

    Raises:
        MissingExtra: matplotlib is not installed.
        DesignError: not a design, or one that cannot be laid out.
    """
    design = resolve_design(design)
    figure = new_figure(8.0, 4.2)
    from matplotlib.patches import Circle

    layout, axes = lay_out(design), figure.subplots()
    for tube in layout.tubes:
        axes.plot(*tube.path[:, :2].T, color="#777777", linewidth=1.2, zorder=1)
    radius = design.resonator.outer_diameter / 2
    for point in layout.points:
        axes.add_patch(Circle(point.position, radius, facecolor="#9ecae1", edgecolor="#333333", zorder=2))
        if len(layout.points) <= _NUMBERED:
            axes.annotate(str(point.number), point.position, ha="center", va="center", fontsize=8)
    for microphone in layout.microphones:
        axes.plot(*microphone.position, "s", color="#1d4d2b", markersize=9, zorder=3)
        axes.annotate(microphone.name, microphone.position, xytext=(0, 9), textcoords="offset points", ha="center")
    axes.set(xlabel="x  (mm)", ylabel="y  (mm)", aspect="equal", title=design.name)
    axes.margins(0.06)
    axes.autoscale_view()
    return figure
