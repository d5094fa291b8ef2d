"""Files of a bending study: the figure, the numbers as CSV, and everything as JSON."""

from __future__ import annotations

import csv
import io
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from geometry.ground.whole_files import made_folder, write_text
from studies.bending.solution import Bending
from studies.output.figure_style import frequency_panels, save_figure
from studies.output.folders import write_json

FIGURE, NUMBERS, RESULT = "bending.png", "bending.csv", "bending.json"


def save_bending(result: Bending, folder: Path) -> tuple[Path, ...]:
    """Write ``bending.png``, ``bending.csv`` and ``bending.json``; earlier ones are replaced. Their paths."""
    made_folder(folder)
    write_json(folder / RESULT, bending_dict(result))  # first: by it a folder is known
    figure = draw_bending(result, folder / FIGURE)
    write_text(folder / NUMBERS, bending_csv(result))
    return figure, folder / NUMBERS, folder / RESULT


def draw_bending(result: Bending, path: Path) -> Path:
    """Picture of level and phase of every angle, and of their differences to the straight tube; its path."""
    rig, frequency = result.rig, result.frequency
    level = 20 * np.log10(np.abs(result.transfer_function))
    phase = np.degrees(np.unwrap(np.angle(result.transfer_function)))
    level_change, level_unit = _scaled(result.level_difference)
    phase_change, phase_unit = _scaled(result.phase_difference)
    with frequency_panels(2) as (figure, (above, below)):
        shown = (
            (above[0], level, "level", "|H|  (dB)"),
            (above[1], phase, "phase", "arg H  (degrees)"),
            (below[0], level_change, "level less that of the straight tube", f"difference  ({level_unit}dB)"),
            (below[1], phase_change, "phase less that of the straight tube", f"difference  ({phase_unit}degrees)"),
        )
        for axis, curves, title, label in shown:
            # The curves above coincide: each is thinner than the one below it, so that all are seen.
            widths = np.linspace(6.0, 1.0, len(curves)) if axis in above else np.full(len(curves), 1.4)
            for k, (curve, width) in enumerate(zip(curves, widths, strict=True)):
                marker = "o" if len(frequency) == 1 else None
                axis.plot(frequency, curve, color=f"C{k}", linewidth=width, marker=marker)
            axis.set(title=title, ylabel=label)
        if len(frequency) > 1:
            ticks = _ticks(float(frequency[0]), float(frequency[-1]))
            below[0].set_xlim(frequency[0], frequency[-1])  # all panels share it
            below[0].set_xticks(ticks, [f"{tick:g}" for tick in ticks])
        handles = [below[0].lines[k] for k in range(len(rig.angles))]
        names = [f"{angle:g}°" for angle in rig.angles]
        figure.legend(handles, names, title="bent over", loc="outside right upper")
        figure.suptitle(
            f"Tube of {rig.length:g} mm with a bore of {rig.bore:g} mm, wound on {rig.diameter:g} mm: "
            "far over near pressure",
            fontsize=10.5,
        )
        return save_figure(figure, path)


def bending_csv(result: Bending) -> str:
    """Table of a bending study as CSV, one line per angle and frequency."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(
        ("angle_deg", "frequency_hz", "level_db", "phase_deg", "level_difference_db", "phase_difference_deg")
    )
    for angle, h, level, phase in zip(
        result.rig.angles, result.transfer_function, result.level_difference, result.phase_difference, strict=True
    ):
        columns = (result.frequency, 20 * np.log10(np.abs(h)), np.degrees(np.unwrap(np.angle(h))), level, phase)
        table.writerows((f"{angle:g}", *(f"{value:.12g}" for value in row)) for row in zip(*columns, strict=True))
    return text.getvalue()


def bending_dict(result: Bending) -> dict[str, Any]:
    """Results of a bending study as plain values; complex numbers as real and imaginary part."""

    def parts(values: np.ndarray[Any, Any]) -> dict[str, Any]:
        return {"real": values.real.tolist(), "imaginary": values.imag.tolist()}

    return {
        "rig": asdict(result.rig),
        "fidelity": result.fidelity,
        "medium": asdict(result.medium),
        "frequency_hz": result.frequency.tolist(),
        "transfer_function": parts(result.transfer_function),
        "straight_transfer_function": parts(result.straight),
        "relative_change_of_the_bend_transfer_admittance": parts(result.bend_change),
        "largest_difference_db": result.largest_differences[:, 0].tolist(),
        "largest_difference_deg": result.largest_differences[:, 1].tolist(),
        "mesh_error_of_the_differences": result.mesh_error,
        "mesh_error_of_a_straight_bore": result.straight_error,
        "unknowns": result.unknowns,
        "seconds": result.seconds,
        "made_by": result.made_by,
    }


def _ticks(low: float, high: float) -> list[float]:
    """Ticks of a logarithmic axis: 1, 2, 5 of every decade, 1 alone over more than four."""
    decades = range(int(np.floor(np.log10(low))), int(np.ceil(np.log10(high))) + 1)
    steps = (1, 2, 5) if len(decades) <= 5 else (1,)
    return [tick for power in decades for step in steps if low <= (tick := step * 10.0**power) <= high]


def _scaled(values: np.ndarray[Any, Any]) -> tuple[np.ndarray[Any, Any], str]:
    """Values over a power of ten that brings the largest to 1 to 1000, and that power for a label."""
    largest = float(np.abs(values).max(initial=0.0))
    power = 0 if largest == 0 else min(0, 3 * int(np.floor(np.log10(largest) / 3)))
    digits = str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
    return values / 10.0**power, f"10{digits} " if power else ""
