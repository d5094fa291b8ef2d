"""Transfer functions of a library as a figure: level, phase, and their differences between microphones."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import TYPE_CHECKING, Literal, get_args

import numpy as np
import xarray as xr

from geometry.ground.argument_checks import check_choice
from geometry.ground.figures import new_figure
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Quantity = Literal["level", "phase", "ild", "ipd"]
#: Quantity -> axis title.
_TITLES = {
    "level": "level |H|  (dB)",
    "phase": "phase of H  (degrees)",
    "ild": "level difference  (dB)",
    "ipd": "phase difference  (degrees)",
}
#: Number of points up to which each curve has an entry in the legend.
_NAMED = 24


def plot_responses(
    transfer_function: xr.DataArray, quantity: Quantity = "level", microphones: Sequence[str] | None = None
) -> Figure:
    """Figure with a panel for each microphone, or each pair of them, and a curve for each point.

    Args:
        transfer_function: (point, microphone, frequency) complex, Pa/Pa.
        quantity: "level" or "phase" of the transfer function, or "ild" or "ipd", its level or phase difference between
            two microphones.
        microphones: names of those that are shown; by default all.

    Raises:
        Refusal: an unknown quantity or microphone, or a difference of one microphone.
        MissingExtra: matplotlib is not installed.
    """
    check_choice("quantity", quantity, get_args(Quantity))
    known = [str(name) for name in transfer_function["microphone"].values]
    for name in microphones or ():
        check_choice("microphones", name, known, kind=Kind.UNKNOWN)
    chosen = list(microphones) if microphones is not None else known
    if len(chosen) < (1 if quantity in ("level", "phase") else 2):
        allowed = "at least two, for a difference" if chosen else "at least one"
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="microphones", value=chosen, allowed=allowed)
    h = transfer_function.transpose("microphone", "point", "frequency")
    values = {name: np.asarray(h.values[known.index(name)], np.complex128) for name in chosen}
    panels = list(_panels(values, quantity))
    figure = new_figure(8.0, 0.6 + 2.7 * len(panels))
    grid = figure.subplots(len(panels), 1, squeeze=False, sharex=True)[:, 0]
    import matplotlib as mpl

    points = transfer_function["point"].values
    colours = mpl.colormaps["viridis"](np.linspace(0, 0.93, len(points)))
    for axes, (title, curves) in zip(grid, panels, strict=True):
        for point, colour, curve in zip(points, colours, curves, strict=True):
            axes.semilogx(transfer_function["frequency"].values, curve, color=colour, label=str(point))
        axes.set(title=title, ylabel=_TITLES[quantity])
        axes.grid(visible=True, color="#dddddd")
    grid[-1].xaxis.set_major_formatter("{x:g}")
    grid[-1].xaxis.set_minor_formatter("")
    grid[-1].set_xlabel("frequency  (Hz)")
    if len(points) <= _NAMED:
        figure.legend(*grid[0].get_legend_handles_labels(), title="point", loc="outside right upper")
    return figure


def _panels(values: dict[str, ComplexArray], quantity: Quantity) -> Iterator[tuple[str, Array]]:
    """Title and curves, (n_point, n_freq), of each panel."""
    if quantity in ("level", "phase"):
        pairs = [(f"microphone {name}", h) for name, h in values.items()]
    else:
        pairs = [(f"{a} over {b}", values[a] / values[b]) for a, b in combinations(values, 2)]
    for title, ratio in pairs:
        if quantity in ("level", "ild"):
            yield title, 20 * np.log10(np.abs(ratio))
        else:
            yield title, np.degrees(np.unwrap(np.angle(ratio), axis=-1))
