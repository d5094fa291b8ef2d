"""Figures that objects draw of themselves: drawn without a display, and shown by a notebook that is handed them."""

from __future__ import annotations

import logging
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
    quiet_fonts()
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def quiet_fonts() -> None:
    """Keep matplotlib from naming each font that it replaces by another, unless somebody has chosen what it logs."""
    fonts = logging.getLogger("matplotlib.font_manager")
    if fonts.level == logging.NOTSET:
        fonts.setLevel(logging.ERROR)
