"""Files of a diagnosis of many sensors: tables as CSV and JSON, and a page for a browser."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from geometry.ground.extras import is_installed
from geometry.ground.stated_times import stated_time
from geometry.ground.whole_files import write_text
from localize.diagnosis.as_built_estimates import AsBuiltEstimate
from studies.inference.diagnosed_sensors import BatchDiagnosis, DiagnosedSensor
from studies.output.display import number
from studies.output.figure_style import WIDTH, figure_in_style
from studies.output.folders import write_json
from studies.output.report_texts import inlined_drawing, percent, rendered_page

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Columns of ``sensors.csv`` and of ``parameters.csv``.
_SENSORS = ("sensor", "recording", "result", "verdict", "finding", "probability", "touches", "misfit",
            "modulus_of_batch", "modulus_low", "modulus_high", "reasons", "advice")  # fmt: skip
_PARAMETERS = ("sensor", "quantity", "part", "value", "low", "high", "measured")
#: Class of the style for each result.
_MARKS = {"pass": "ok", "fail": "fail", "no diagnosis": "warn"}
#: Most sensors whose modulus is drawn one by one.
_DRAWN = 60


def write_batch(batch: BatchDiagnosis) -> None:
    """Write ``sensors.csv``, ``parameters.csv``, ``sensors.json`` and ``report.html`` into the folder of a batch."""
    folder = batch.folder
    write_text(folder / "sensors.csv", _table(_SENSORS, map(_sensor_row, batch.sensors)))
    write_text(folder / "parameters.csv", _table(_PARAMETERS, _parameter_rows(batch.sensors)))
    write_json(
        folder / "sensors.json",
        {"design": batch.design, "counts": batch.counts, "sensors": [each.summary() for each in batch.sensors]},
    )
    write_text(batch.page, render_batch(batch))


def render_batch(batch: BatchDiagnosis) -> str:
    """Page of a batch as text. Without matplotlib it has no drawing and says so."""
    return rendered_page(
        "diagnosed_sensors.html",
        batch=batch,
        created=stated_time(),
        rows=[_page_row(each) for each in batch.sensors],
        limits=_limit_rows(batch),
        drawn=_DRAWN,
        drawing=_drawing(batch),
        plots=is_installed("plots"),
    )


def _table(columns: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(columns)
    table.writerows(rows)
    return text.getvalue()


def _sensor_row(sensor: DiagnosedSensor) -> list[object]:
    modulus = sensor.batch_modulus
    figures = ["", "", ""] if modulus is None else [f"{x:.4g}" for x in (modulus.value, modulus.low, modulus.high)]
    return [
        sensor.sensor,
        sensor.recording.name,
        sensor.result,
        sensor.verdict,
        sensor.text,
        "" if sensor.probability is None else f"{sensor.probability:.4f}",
        sensor.touches,
        sensor.found.get("misfit", ""),
        *figures,
        "; ".join(sensor.reasons),
        " ".join(sensor.found.get("advice", ())),
    ]


def _parameter_rows(sensors: Iterable[DiagnosedSensor]) -> Iterable[list[object]]:
    for sensor in sensors:
        for each in sensor.parameters:
            figures = [f"{value:.5g}" for value in (each.value, each.low, each.high)]
            yield [sensor.sensor, each.quantity, each.part, *figures, "yes" if each.measured else "no"]


def _page_row(sensor: DiagnosedSensor) -> dict[str, Any]:
    """Cells of a sensor on the page."""
    modulus = sensor.batch_modulus
    return {
        "sensor": sensor,
        "mark": _MARKS[sensor.result],
        "probability": "" if sensor.probability is None else percent(sensor.probability),
        "modulus": "" if modulus is None else _interval(modulus),
        "measured": [(each, _interval(each)) for each in sensor.parameters if each.measured],
        "all": len(sensor.parameters),
    }


def _interval(estimate: AsBuiltEstimate) -> str:
    """Value with its interval."""
    return f"{number(estimate.value)} ({number(estimate.low)} to {number(estimate.high)})"


def _limit_rows(batch: BatchDiagnosis) -> list[tuple[str, str]]:
    """Limits in words."""
    limits = batch.limits
    rows = [
        ("touches of a recording", f"at least {limits.touches}"),
        ("hole of a leak", f"at most {number(limits.leak)} mm" if limits.leak else "none"),
        ("bore of a tube over the design's", f"at least {number(limits.blocked_tube)}"),
        ("lack of level of a microphone", f"at most {number(limits.quiet_microphone)} dB"),
        ("reversed or exchanged microphones", "none"),
    ]
    return rows + [(name, f"{number(low)} to {number(high)}") for name, (low, high) in limits.parameters.items()]


def _drawing(batch: BatchDiagnosis) -> str:
    """Modulus of the membranes of every sensor with its interval, as SVG; empty if it cannot be drawn."""
    found = [(each, modulus) for each in batch.sensors if (modulus := each.batch_modulus) is not None]
    return inlined_drawing(_drawn_moduli(batch, found[:_DRAWN])) if found and is_installed("plots") else ""


def _drawn_moduli(batch: BatchDiagnosis, found: Sequence[tuple[DiagnosedSensor, AsBuiltEstimate]]) -> Figure:
    colours = {"pass": "#2a6f97", "fail": "#c0392b"}
    with figure_in_style((WIDTH, 0.9 + 0.24 * len(found))) as figure:
        panel = figure.subplots()
        place = list(range(len(found)))
        for result, colour in colours.items():
            own = [k for k in place if found[k][0].result == result]
            values = np.array([[found[k][1].value, found[k][1].low, found[k][1].high] for k in own]).reshape(-1, 3)
            if len(own):
                errors = np.abs(values[:, 1:] - values[:, :1]).T
                panel.errorbar(values[:, 0], own, xerr=errors, fmt="o", color=colour, markersize=4, label=result)
        limits = batch.limits.parameters.get("modulus_of_batch")
        if limits is not None:
            panel.axvspan(*limits, color="#1d6b37", alpha=0.12, linewidth=0)
        panel.set_yticks(place, [each.sensor for each, _ in found])
        panel.set_ylim(len(found) - 0.4, -0.6)
        panel.set_xlabel("modulus of all membranes, over that of the library")
        panel.legend(loc="best")
        return figure
