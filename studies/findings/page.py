"""One page about a sweep or a search: what each parameter does, what must be traded, and the best designs.

Everything is in the file, the plotting program included (4.5 MB): it opens without a network.
"""

from __future__ import annotations

import json
from importlib import resources
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import studies
from acoustic_fem.atlas import QuickFidelity, quick_fidelity
from geometry import ArrayDesign
from geometry.design.design_file import value_of, write_design
from geometry.ground.whole_files import write_text
from studies.findings.result_table import Column, ResultTable, effect, pair_map
from studies.output.display import number
from studies.output.report_texts import rendered_page

#: Designs that are drawn one by one; of more, all that lie on a front and a sample of the others.
LARGEST_CLOUD = 8_000
#: Rows of the table of best designs, for each metric.
BEST = 10
#: Points whose level and phase differences are drawn; of more, evenly chosen ones.
DRAWN_POINTS = 24
_DIGITS = 5


def write_sweep_report(table: ResultTable, path: Path, command: str) -> None:
    """Write the page of a sweep or a search.

    Args:
        table: at least one design.
        path: the file.
        command: how a reader gets the file of a design, with ``{number}`` in it.
    """
    write_text(path, render_sweep(table, command))


def render_sweep(table: ResultTable, command: str) -> str:
    """Page of a sweep or a search as text; arguments as :func:`write_sweep_report`."""
    from plotly.offline import get_plotlyjs

    best = _best(table)
    return rendered_page(
        "sweep_report.html",
        script=(resources.files(studies) / "templates" / "sweep_report.js").read_text(encoding="utf-8"),
        plotly=get_plotlyjs(),
        table=table,
        shares=_shares(table),
        failed=sum(count for _, count in table.failures),
        drawn=min(len(table.number), LARGEST_CLOUD),
        ranges=[(column, _range_text(column)) for column in table.parameters],
        metrics=[(column, _range_text(column)) for column in table.metrics],
        data=_in_script(
            {
                "command": command,
                "parameters": [_about(column) for column in table.parameters],
                "free": len(table.free),
                "metrics": [_about(column) for column in table.metrics],
                "leading": table.metrics.index(table.leading),
                "cloud": _cloud(table, best),
                "effects": _effects(table),
                "maps": _maps(table),
                "best": {name: [int(table.number[row]) for row in rows] for name, rows in best.items()},
                "base": dict(table.base_metrics),
                "baseValues": {column.name: value_of(table.base, column.name) for column in table.parameters},
                "designs": _designs(table, best),
                "families": _families(table, best),
            }
        ),
    )


def design_of(table: ResultTable, row: int) -> ArrayDesign:
    """Design of a row, named after the study and its number."""
    design = table.base.with_values(table.values(row) if row >= 0 else {})
    name = f"{table.base.name}-{table.label(row)}"[:80]
    origin = f"Design {table.label(row)} of the study {table.title}; base {table.base.name}"
    return design.with_values({"name": name, "description": origin})


def _in_script(content: dict[str, Any]) -> str:
    """JSON that may stand in a script element: nothing in it ends the element."""
    text = json.dumps(content, allow_nan=False, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")


def _about(column: Column) -> dict[str, Any]:
    return column.words | {
        "caution": column.caution,
        "integral": bool(not column.labels and np.all(column.values == np.round(column.values))),
    }


def _numbers(values: NDArray[np.float64]) -> list[float | None]:
    return [float(f"{value:.{_DIGITS}g}") if np.isfinite(value) else None for value in values.tolist()]


def _best(table: ResultTable) -> dict[str, list[int]]:
    return {column.name: table.best(column.name, BEST) for column in table.metrics}


def _cloud(table: ResultTable, best: dict[str, list[int]]) -> dict[str, Any]:
    """The designs that are drawn one by one."""
    rows = np.arange(len(table.number))
    if len(rows) > LARGEST_CLOUD:
        wanted = np.union1d(table.fronts(), np.concatenate([np.array(each) for each in best.values()]))
        others = np.setdiff1d(rows, wanted)
        sample = np.random.default_rng(0).choice(others, max(LARGEST_CLOUD - len(wanted), 0), replace=False)
        rows = np.union1d(wanted, sample)
    return {
        "number": table.number[rows].tolist(),
        "parameters": [_numbers(column.values[rows]) for column in table.parameters],
        "metrics": [_numbers(column.values[rows]) for column in table.metrics],
    }


def _effects(table: ResultTable) -> list[list[dict[str, Any]]]:
    """Per metric and parameter that has values of its own."""
    found = []
    for metric in table.metrics:
        row = []
        for parameter in table.free:
            own = effect(parameter, metric)
            row.append(
                {key: _numbers(getattr(own, key)) for key in ("centres", "mean", "low", "high")} | {"share": own.share}
            )
        found.append(row)
    return found


def _shares(table: ResultTable) -> list[tuple[Column, list[float]]]:
    """Per metric the share of its variance that each parameter with values of its own explains alone."""
    return [(metric, [effect(parameter, metric).share for parameter in table.free]) for metric in table.metrics]


def _maps(table: ResultTable) -> list[dict[str, Any]]:
    """Per pair of parameters, for each metric."""
    found = []
    for first, second in combinations(range(len(table.free)), 2):
        a, b = table.parameters[first], table.parameters[second]
        entry: dict[str, Any] = {"first": first, "second": second, "means": []}
        for metric in table.metrics:
            x, y, means = pair_map(a, b, metric)
            entry["x"], entry["y"] = _numbers(x), _numbers(y)
            entry["means"].append([_numbers(line) for line in means])
        found.append(entry)
    return found


def _designs(table: ResultTable, best: dict[str, list[int]]) -> dict[str, str]:
    """The design files of all rows of the tables of best designs, by number."""
    rows = sorted({row for each in best.values() for row in each})
    return {str(table.number[row]): write_design(design_of(table, row)) for row in rows}


def _families(table: ResultTable, best: dict[str, list[int]]) -> list[dict[str, Any]]:
    """Level and phase differences of the points: of the base, and of the best design by each metric."""
    chosen: dict[int, list[str]] = {}
    for name, rows in best.items():
        chosen.setdefault(rows[0], []).append(table.metric(name).title)
    found = [_family("the base design", table.base, table)]
    for row, titles in chosen.items():
        found.append(_family(f"design {table.label(row)}, best in {', '.join(titles)}", design_of(table, row), table))
    return found


def _family(title: str, design: ArrayDesign, table: ResultTable) -> dict[str, Any]:
    lumped = table.fidelity == "lumped"
    fidelity = QuickFidelity("lumped") if lumped else quick_fidelity(design, table.frequency)
    if fidelity.outside:
        title = f"{title} ({fidelity.words})"
    library = acoustic_fem.solve(design, table.frequency, fidelity.name)
    response = library.transfer_function.transpose("point", "microphone", "frequency").values
    first, last = design.microphones[0], design.microphones[-1]
    count = len(response)
    drawn = np.unique(np.linspace(0, count - 1, min(count, DRAWN_POINTS)).round().astype(int))
    ratio = response[drawn, 0] / response[drawn, -1]
    phase = np.degrees(np.unwrap(np.angle(ratio), axis=1))
    phase -= 360 * np.round(phase[:, :1] / 360)
    return {
        "title": title,
        "pair": f"{first} over {last}",
        "frequency": _numbers(table.frequency),
        "points": (drawn + 1).tolist(),
        "of": count,
        "level": [_numbers(line) for line in 20 * np.log10(np.abs(ratio))],
        "phase": [_numbers(line) for line in phase],
    }


def _range_text(column: Column) -> str:
    if column.labels:
        return ", ".join(column.labels)
    low, high = float(column.values.min()), float(column.values.max())
    unit = f" {column.unit}" if column.unit else ""
    return f"{number(low)}{unit}" if low == high else f"{number(low)} to {number(high)}{unit}"
