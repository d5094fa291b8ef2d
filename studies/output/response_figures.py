"""Figures of a library and of a localizer, as PNG files."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray as xr
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from localize.signals.stimulus import BAND
from studies.metrics.pairs import microphone_ratios
from studies.metrics.separation import Separability
from studies.output.figure_style import WIDTH, figure_in_style, frequency_panels, line_colours, save_figure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LARGEST_LEGEND = 24
"""Number of points up to which each curve has a legend entry; beyond, a colour bar names the numbers."""
LARGEST_NUMBERED_MATRIX = 16
"""Number of points up to which the cells of a matrix carry their numbers."""


@dataclass(frozen=True)
class CurvePanel:
    """Panel of a figure over frequency, with a curve for each point."""

    title: str
    """Title of the panel."""
    label: str
    """Quantity and unit of its values."""
    values: NDArray[np.float64]
    """Curves, (n_point, n_freq) float64."""
    limit: float | None = None
    """Bound of the magnitude of the values, drawn dashed."""


def transfer_panels(transfer_function: xr.DataArray) -> list[CurvePanel]:
    """Level (dB) and unwrapped phase (degrees) at each microphone."""
    h, _ = in_band(transfer_function)
    panels = []
    for m, name in enumerate(transfer_function["microphone"].values):
        level, phase = 20 * np.log10(np.abs(h[:, m])), np.degrees(np.unwrap(np.angle(h[:, m])))
        panels.append(CurvePanel(f"microphone {name}: level", "|H|  (dB)", level))
        panels.append(CurvePanel(f"microphone {name}: phase", "arg H  (degrees)", phase))
    return panels


def difference_panels(transfer_function: xr.DataArray) -> list[CurvePanel]:
    """Level difference, ILD (dB), and unwrapped phase difference, IPD (degrees), of each pair of microphones."""
    ratios = microphone_ratios(transfer_function)[..., _inside(transfer_function)]
    panels = []
    for p, (a, b) in enumerate(combinations([str(name) for name in transfer_function["microphone"].values], 2)):
        level, phase = 20 * np.log10(np.abs(ratios[:, p])), np.degrees(np.unwrap(np.angle(ratios[:, p])))
        panels.append(CurvePanel(f"ILD of {a} and {b}", f"20 log |{a} / {b}|  (dB)", level))
        panels.append(CurvePanel(f"IPD of {a} and {b}", f"arg ({a} / {b})  (degrees)", phase))
    return panels


def comparison_panels(
    transfer_function: xr.DataArray, reference: xr.DataArray, limits: tuple[float, float]
) -> list[CurvePanel]:
    """Deviation in magnitude (%) and phase (degrees) from a reference on the same grid, with a limit for each."""
    ratio = in_band(transfer_function)[0] / in_band(reference)[0]
    words, panels = "lumped - Navier-Stokes", []
    for m, name in enumerate(transfer_function["microphone"].values):
        magnitude, phase = 100 * (np.abs(ratio[:, m]) - 1), np.degrees(np.angle(ratio[:, m]))
        panels.append(CurvePanel(f"microphone {name}: magnitude", f"{words}  (%)", magnitude, limits[0]))
        panels.append(CurvePanel(f"microphone {name}: phase", f"{words}  (degrees)", phase, limits[1]))
    return panels


def draw_transfer_functions(transfer_function: xr.DataArray, path: str | os.PathLike[str]) -> Path:
    """Picture of level (dB) and unwrapped phase (degrees) against frequency, a row per microphone, a curve per point.

    Args:
        transfer_function: (n_point, n_microphone, n_freq) complex, Pa/Pa; dimensions point, microphone, frequency (Hz).
        path: of the PNG, which is handed back.
    """
    return _draw_panels(transfer_function, transfer_panels(transfer_function), path)


def draw_differences(transfer_function: xr.DataArray, path: str | os.PathLike[str]) -> Path:
    """Picture of ILD (dB) and unwrapped IPD (degrees) against frequency, a row per microphone pair, a curve per point.

    Args:
        transfer_function: (n_point, n_microphone, n_freq) complex, Pa/Pa; dimensions point, microphone, frequency (Hz).
        path: of the PNG, which is handed back.
    """
    return _draw_panels(transfer_function, difference_panels(transfer_function), path)


def draw_comparison(
    transfer_function: xr.DataArray,
    reference: xr.DataArray,
    path: str | os.PathLike[str],
    limits: tuple[float, float],
) -> Path:
    """Picture of the deviation in magnitude (%) and phase (degrees) from a reference on the same grid, limits dashed.

    Args:
        transfer_function: (n_point, n_microphone, n_freq) complex, Pa/Pa; dimensions point, microphone, frequency (Hz).
        reference: same shape as ``transfer_function``, Pa/Pa.
        path: of the PNG, which is handed back.
        limits: in magnitude, percent, and in phase, degrees.
    """
    return _draw_panels(transfer_function, comparison_panels(transfer_function, reference, limits), path)


def _draw_panels(transfer_function: xr.DataArray, panels: Sequence[CurvePanel], path: str | os.PathLike[str]) -> Path:
    """Picture of panels, two to a row."""
    frequency = in_band(transfer_function)[1]
    with frequency_panels(len(panels) // 2) as (figure, rows):
        for axis, panel in zip((axis for row in rows for axis in row), panels, strict=True):
            _curves(axis, frequency, panel.values)
            axis.set(title=panel.title, ylabel=panel.label)
            for bound in () if panel.limit is None else (-panel.limit, panel.limit):
                axis.axhline(bound, color="#b03030", linestyle="--", linewidth=1)
        _name_points(figure, transfer_function["point"].values)
        return save_figure(figure, path)


def draw_separability(separability: Separability, path: str | os.PathLike[str]) -> Path:
    """Picture of the combined distance of every pair of points; the hardest pair and those equally hard are framed."""
    from matplotlib.colors import LogNorm

    distance = separability.combined.copy()
    np.fill_diagonal(distance, np.nan)
    finite = distance[np.isfinite(distance) & (distance > 0)]
    low = float(finite.min()) if finite.size else 1e-3
    high = max(float(finite.max()) if finite.size else 1.0, 1.01 * low)
    with _matrix_panel() as (figure, axes):
        _matrix(
            axes,
            figure,
            distance,
            separability.points,
            lambda value: f"{value:.2f}" if value < 10 else f"{value:.0f}",
            norm=LogNorm(low, high),
            cmap="viridis",
            plain_scale=high < 1000 * low,  # numbers instead of powers of ten
            bar="distance, log scale (0.1 = 0.87 dB or 5.7 degrees)",
        )
        for pair in separability.equally_hard:
            i, j = (separability.points.index(number) for number in pair)
            _frame_cell(axes, i, j)
            _frame_cell(axes, j, i)
        axes.set(title="distance of points; framed: the hardest pair to tell apart", xlabel="point", ylabel="point")
        return save_figure(figure, path)


def percent_of_touches(confusion: NDArray[np.int64]) -> NDArray[np.float64]:
    """Percent of the touches of the row's point that were assigned to the column's point; 0 without touches.

    Args:
        confusion: (n_point, n_point) int64 counts.

    Returns:
        (n_point, n_point) float64.
    """
    return np.asarray(100 * confusion / np.maximum(confusion.sum(axis=1, keepdims=True), 1))


def draw_confusion(
    confusion: NDArray[np.int64], points: Sequence[int | str], path: str | os.PathLike[str], what: str = "point"
) -> Path:
    """Picture of the percent of the touches of the row's point for which the column's point was named.

    White is never, and colours are logarithmic, for what is to be seen are the few percent beside the diagonal.

    Args:
        confusion: (n_point, n_point) int64, touches of the row's point named the column's.
        points: numbers of the points, or names of other classes.
        path: of the PNG, which is handed back.
        what: name of the classes.
    """
    from matplotlib.colors import LogNorm

    with _matrix_panel() as (figure, axes):
        _matrix(
            axes,
            figure,
            np.ma.masked_equal(percent_of_touches(confusion), 0.0),
            points,
            lambda value: "" if value == 0 else f"{value:.1f}" if value < 99.95 else "100",
            norm=LogNorm(0.1, 100.0, clip=True),
            cmap="Blues",
            plain_scale=True,
            bar=f"touches of the row's {what} (%)",
        )
        axes.set(title=f"touched and named {what}s", xlabel=f"named {what}", ylabel=f"touched {what}")
        if any(isinstance(each, str) and len(each) > 2 for each in points):
            axes.tick_params("x", rotation=90)
        return save_figure(figure, path)


def draw_training(loss: Sequence[float], accuracy: Mapping[str, Sequence[float]], path: str | os.PathLike[str]) -> Path:
    """Picture of mean loss, nats, and of the share of errors (1 - accuracy) on each set of held-out touches, by epoch.

    Returns:
        Its path.
    """
    epoch = np.arange(1, len(loss) + 1)
    with figure_in_style((WIDTH, 3.2)) as figure:
        left, right = figure.subplots(1, 2)
        left.semilogy(epoch, loss)
        left.set(title="training touches", xlabel="epoch", ylabel="cross-entropy  (nats)")
        for name, share in accuracy.items():
            errors = 100 * (1 - np.asarray(share))
            right.semilogy(epoch, np.where(errors > 0, errors, np.nan), label=name)
        right.set(title="held-out touches; no value: no error", xlabel="epoch", ylabel="classified wrongly  (%)")
        if len(accuracy) > 1:
            right.legend()
        return save_figure(figure, path)


# -- curves ---------------------------------------------------------------------------------------------


def _curves(axis: Axes, frequency: NDArray[np.float64], values: NDArray[np.float64]) -> None:
    """A curve per row; between the frequencies of the grid a cubic spline, as the localizer reads a library."""
    if len(frequency) >= 4:
        fine = np.geomspace(frequency[0], frequency[-1], 300)
        values = CubicSpline(np.log(frequency), values, axis=-1)(np.log(fine))
        frequency = fine
    for colour, curve in zip(line_colours(len(values)), values, strict=True):
        axis.plot(frequency, curve, color=colour)


def _name_points(figure: Figure, points: NDArray[np.int64]) -> None:
    import matplotlib as mpl
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import ListedColormap, Normalize
    from matplotlib.lines import Line2D

    colours = line_colours(len(points))
    if len(points) <= LARGEST_LEGEND:
        handles = [Line2D([], [], color=colour, linewidth=2.5) for colour in colours]
        figure.legend(
            handles, [str(int(p)) for p in points], title="point", loc="outside right upper", labelspacing=0.45
        )
        return
    scale = ScalarMappable(Normalize(float(points[0]), float(points[-1])), ListedColormap(list(map(tuple, colours))))
    figure.colorbar(scale, ax=figure.axes, label="point", shrink=0.6, ticks=mpl.ticker.MaxNLocator(integer=True))


# -- matrices -------------------------------------------------------------------------------------------
@contextmanager
def _matrix_panel() -> Iterator[tuple[Figure, Axes]]:
    """One square panel."""
    with figure_in_style((6.6, 5.6), **{"axes.grid": False}) as figure:
        yield figure, figure.subplots()


def _matrix(
    axes: Axes,
    figure: Figure,
    values: NDArray[np.float64],
    points: Sequence[int | str],
    label: Any,
    bar: str,
    plain_scale: bool,
    **scale: Any,
) -> None:
    picture = axes.imshow(values, **scale)
    legend = figure.colorbar(picture, ax=axes, label=bar, shrink=0.85)
    if plain_scale:
        legend.ax.yaxis.set_major_formatter("{x:g}")
        low, high = picture.get_clim()
        # Over many decades numbers between the powers of ten would lie on each other.
        legend.ax.yaxis.set_minor_formatter("" if 0 < low < high / 100 else "{x:g}")
    step = -(-len(points) // 24)
    ticks = list(range(0, len(points), step))
    axes.set_xticks(ticks, [str(points[k]) for k in ticks])
    axes.set_yticks(ticks, [str(points[k]) for k in ticks])
    axes.tick_params(length=0)
    if len(points) > LARGEST_NUMBERED_MATRIX:
        return
    for row, line in enumerate(values):
        for column, value in enumerate(line):
            if np.isfinite(value) and not np.ma.is_masked(value):
                red, green, blue, _ = picture.cmap(picture.norm(value))
                dark = 0.299 * red + 0.587 * green + 0.114 * blue < 0.55
                axes.text(
                    column, row, label(value), ha="center", va="center", fontsize=7, color="white" if dark else "black"
                )


def _frame_cell(axes: Axes, column: int, row: int) -> None:
    from matplotlib.patches import Rectangle

    axes.add_patch(Rectangle((column - 0.5, row - 0.5), 1, 1, fill=False, edgecolor="#d62728", linewidth=2.5))


# -- files ----------------------------------------------------------------------------------------------
def _inside(transfer_function: xr.DataArray) -> NDArray[np.bool_]:
    frequency = np.asarray(transfer_function["frequency"].values, np.float64)
    return np.asarray((frequency >= BAND[0] - 1e-9) & (frequency <= BAND[1] + 1e-9))


def in_band(transfer_function: xr.DataArray) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:
    """Values (point, microphone, frequency) and frequencies within 1 to 100 Hz."""
    inside = _inside(transfer_function)
    values = transfer_function.transpose("point", "microphone", "frequency").values[..., inside]
    return np.asarray(values, np.complex128), np.asarray(transfer_function["frequency"].values, np.float64)[inside]
