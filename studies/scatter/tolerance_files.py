"""The files of a tolerance study: figures as JSON and a picture."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from geometry.ground.whole_files import made_folder
from localize.signals.stimulus import BAND
from studies.output.figure_style import WIDTH, figure_in_style as new_figure, save_figure
from studies.output.folders import write_json
from studies.scatter.effects import ACCURACIES, ToleranceResult

SUMMARY = "tolerance.json"


def save_tolerance(result: ToleranceResult, folder: Path) -> tuple[Path, ...]:
    """Write tolerance.json and tolerance.png into a folder; their paths."""
    made_folder(folder)
    summary = folder / SUMMARY
    write_json(summary, result.summary())
    return summary, draw_tolerance(result, folder / "tolerance.png")


def draw_tolerance(result: ToleranceResult, path: Path) -> Path:
    """Picture of the spread of a ratio of microphones, of the accuracies, and of what matters most; its path."""
    with new_figure((WIDTH, 3.4)) as figure:
        spread, shares, causes = figure.subplots(1, 3)
        inside = (result.frequency >= BAND[0]) & (result.frequency <= BAND[1])
        grid = result.frequency[inside]
        points = sorted({0, len(result.nominal) // 2, len(result.nominal) - 1})
        for point in points:
            ratio = result.transfer_function[:, point, 0] / result.transfer_function[:, point, 1]
            level = 20 * np.log10(np.abs(ratio[:, inside]))
            low, high = np.quantile(level, [0.05, 0.95], axis=0)
            at = 20 * np.log10(np.abs(result.nominal[point, 0, inside] / result.nominal[point, 1, inside]))
            (line,) = spread.plot(grid, at, label=f"point {point + 1}")
            spread.fill_between(grid, low, high, color=line.get_color(), alpha=0.25, linewidth=0)
        spread.set(title="ILD of first two microphones: nominal, 5 to 95 %", xlabel="frequency (Hz)", ylabel="ILD (dB)")
        spread.title.set_fontsize(8.5)
        spread.legend()
        values = [100 * result.accuracy[name] for name in ACCURACIES][::-1]
        labels = [title.replace(", ", ",\n") for title in ACCURACIES.values()][::-1]
        shares.boxplot(values, orientation="horizontal", whis=(5, 95), widths=0.5, flierprops={"markersize": 2})
        shares.set_yticks(range(1, len(labels) + 1), labels, fontsize=7)
        shares.axvline(100 * result.nominal_accuracy, color="C0", linewidth=1, linestyle="--")
        shares.set(title="predicted top-1; box 25 to 75 %, whiskers 5 to 95 %", xlabel="top-1 (%); dashed: as designed")
        shares.title.set_fontsize(8.5)
        if result.sobol:
            indices = result.sobol["deviation"][::-1]
            place = np.arange(len(indices))
            causes.barh(place, [index.total for index in indices], xerr=[index.error for index in indices])
            causes.set_yticks(place, [index.quantity.replace("_", " ") for index in indices], fontsize=7)
        causes.set(title="what matters most for the ratios", xlabel="total Sobol index")
        causes.title.set_fontsize(8.5)
        return save_figure(figure, path)
