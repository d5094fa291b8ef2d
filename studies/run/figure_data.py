"""Figures of a report as data, which the script of its page draws so that a reader can point at them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from acoustic_fem import Library
from geometry.ground.typed import Array
from studies.output.response_figures import (
    CurvePanel,
    comparison_panels,
    difference_panels,
    in_band,
    percent_of_touches,
    transfer_panels,
)
from studies.run.findings import AGREEMENT
from studies.run.run_result import RunResult

#: Significant digits of a value that is drawn.
_DIGITS = 5


def figure_data(result: RunResult) -> dict[str, dict[str, Any]]:
    """Figures of a run by name: curves over frequency, and matrices of pairs of points."""
    library, name = result.library, result.design.name
    found = {
        "transfer-functions": _curves(library, transfer_panels(library.transfer_function)),
        "differences": _curves(library, difference_panels(library.transfer_function)),
    }
    if result.lumped is not None:
        same_grid = library.transfer_function.sel(frequency=result.lumped.frequency)
        limits = (100 * AGREEMENT[0], AGREEMENT[1])
        panels = comparison_panels(result.lumped.transfer_function, same_grid, limits)
        found["comparison"] = _curves(result.lumped, panels)
    points = [int(point) for point in result.separability.points]
    framed = [[points.index(point) for point in pair] for pair in result.separability.equally_hard]
    distance = result.separability.combined.copy()
    np.fill_diagonal(distance, np.nan)
    found["separability"] = _matrix(distance, points, framed, row="point", column="point", unit="")
    percent = percent_of_touches(result.network.confusion)
    found["confusion"] = _matrix(percent, points, [], row="touched point", column="located point", unit=" %")
    return {figure: {**own, "name": f"{name}-{figure}"} for figure, own in found.items()}


def _curves(library: Library, panels: Sequence[CurvePanel]) -> dict[str, Any]:
    transfer_function = library.transfer_function
    return {
        "kind": "curves",
        "points": transfer_function["point"].values.tolist(),
        "frequency": _rounded(in_band(transfer_function)[1]),
        "panels": [
            {"title": panel.title, "label": panel.label.replace("  ", " "), "values": _rounded(panel.values)}
            | ({} if panel.limit is None else {"limit": panel.limit})
            for panel in panels
        ],
    }


def _matrix(values: Array, points: Sequence[int], framed: list[list[int]], **words: Any) -> dict[str, Any]:
    return {"kind": "matrix", "points": [*points], "values": _rounded(values), "framed": framed, **words}


def _rounded(values: Array) -> list[Any]:
    """Values with few digits, as lists; None where there is none."""
    if values.ndim > 1:
        return [_rounded(each) for each in values]
    return [float(f"{value:.{_DIGITS}g}") if np.isfinite(value) else None for value in values.tolist()]
