"""Figures that objects draw of themselves: drawn without a display, and shown by a notebook that is handed them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from geometry.ground.extras import check_extras

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def new_figure(width: float, height: float) -> Figure:
    """Empty figure of a size in inches. ``figure.savefig(path)`` writes it.

    Raises:
        MissingExtra: matplotlib is not installed.
    """
    check_extras("what draws figures", "plots")
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure
