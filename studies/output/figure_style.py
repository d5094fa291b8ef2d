"""The style of all figures: widths, colours, panels, and how they are written."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from geometry.ground.whole_files import made_folder, whole_file
from localize.signals.stimulus import BAND
from studies.output.folders import as_picture, check_drawing

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


DPI = 130


WIDTH = 9.6


"""Width of a figure, inches; the report shows figures at most this wide."""


_STYLE: dict[Any, Any] = {
    "font.size": 9.5,
    "axes.titlesize": 10.5,
    "axes.grid": True,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "lines.linewidth": 1.4,
    "legend.frameon": False,
}


def crop_picture(path: Path, margin: int = 16) -> None:
    """Cut away the white around a picture but for ``margin`` pixels; a picture that is all white is left as it is."""
    check_drawing()
    from matplotlib.image import imread, imsave

    pixels = imread(path)
    edges = []
    for axis in (1, 0):
        inked = np.flatnonzero((pixels[..., :3] < 1).any(axis=(axis, 2)))
        if not len(inked):
            return
        edges.append(slice(max(inked[0] - margin, 0), inked[-1] + margin + 1))
    with whole_file(path) as beside:
        imsave(beside, pixels[edges[0], edges[1], :3])


@contextmanager
def frequency_panels(rows: int) -> Iterator[tuple[Figure, list[list[Axes]]]]:
    """Figure with rows of two panels over a logarithmic frequency axis."""
    with figure_in_style((WIDTH, 0.5 + 2.7 * rows)) as figure:
        grid = figure.subplots(rows, 2, squeeze=False, sharex=True)
        for axis in grid.flat:
            axis.set_xscale("log")
            axis.set_xlim(*BAND)
            axis.set_xticks([1, 2, 5, 10, 20, 50, 100], ["1", "2", "5", "10", "20", "50", "100"])
            axis.minorticks_off()
        for axis in grid[-1]:
            axis.set_xlabel("frequency  (Hz)")
        yield figure, [list(row) for row in grid]


@contextmanager
def figure_in_style(size: tuple[float, float], **style: Any) -> Iterator[Figure]:
    """Empty figure of a size in inches, in the report's style; drawn without a display and forgotten afterwards."""
    check_drawing()
    import matplotlib as mpl
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    settings: dict[Any, Any] = {**_STYLE, **style}
    with mpl.rc_context():
        mpl.rcdefaults()  # whatever a matplotlibrc says, such as that texts are set by LaTeX
        mpl.rcParams.update(settings)
        figure = Figure(figsize=size, layout="constrained")
        FigureCanvasAgg(figure)
        yield figure


def line_colours(count: int) -> NDArray[np.float64]:
    """Colour of each point in perceptual order, RGBA; (count, 4) float64. The palest yellow is left out, it is lost on
    white.
    """
    import matplotlib as mpl

    return np.asarray(mpl.colormaps["viridis"](np.linspace(0, 0.93, count)))


def save_figure(figure: Figure, path: str | os.PathLike[str]) -> Path:
    """Write a figure and close it, in the format of the path's suffix; missing folders are made. The path.

    Raises:
        Refusal: the suffix is not that of a format of pictures.
    """
    path = as_picture(path)
    made_folder(path.parent)
    with whole_file(path) as beside:
        figure.savefig(beside, dpi=DPI)
    return path
