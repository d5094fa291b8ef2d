"""The report as a Markdown page with figures: everything on it comes from the report."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.verification.report import Check, Report, Study, Subject, Table

_WIDTH = 120
_COLOURS = ("#1f5fa8", "#c8501e", "#2e8b57", "#8a4fa3", "#b08a00", "#555555")
_MARKERS = "osD^vP"

_INTRO = """This page shows how accurately the equations of the [theory](theory.md) are solved. The tables with an
*order* show how
fast the error falls when the mesh is refined, and give the errors on the coarsest and on the finest mesh. The order is
the least-squares slope of log(error) over log(size), dashed in the figures. It is fitted to all meshes, or to those up
to a size that the last column gives. The tables with a *target* compare results with exact solutions, other programs or
finer meshes. Errors are relative unless a unit is given. Orders that are not as expected and missed targets are in
bold. `{command}` writes the page, and [verification.json](verification.json) has the figures of every mesh."""


def figure_name(subject: Subject) -> str:
    """File of a subject's figure, in the images folder."""
    return f"verification-{subject.key}.png"


def render(report: Report) -> str:
    """The page."""
    parts = ["# Verification", _wrapped(_INTRO.format(command=report.command)), _summary(report)]
    for subject in report.subjects:
        parts += [f"## {subject.title}", _wrapped(subject.text)]
        if subject.studies:
            parts.append(f"![{subject.title}: error against size](images/{figure_name(subject)})")
            parts.append(_orders(subject.studies))
        if subject.checks:
            parts.append(_checks(subject.checks))
        parts += [_table(table) for table in subject.tables if not table.detail]
    return "\n\n".join(parts) + "\n"


def write(report: Report, folder: Path) -> None:
    """The page and its figures."""
    images = folder / "images"
    images.mkdir(parents=True, exist_ok=True)
    for subject in report.subjects:
        if subject.studies:
            draw(subject, images / figure_name(subject))
    (folder / "verification.md").write_text(render(report), encoding="utf-8")


def draw(subject: Subject, path: Path) -> None:
    """Errors of all studies of a subject over the size, with the fitted lines."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    units = list(dict.fromkeys(study.unit for study in subject.studies))
    figure = Figure(figsize=(5.6 * len(units) + 1.2, 4.2), layout="constrained")
    FigureCanvasAgg(figure)
    for axes, unit in zip(np.atleast_1d(figure.subplots(1, len(units))), units, strict=True):
        for k, study in enumerate(study for study in subject.studies if study.unit == unit):
            colour, size = _COLOURS[k % 6], np.array([level.size for level in study.levels])
            error = np.array([level.error for level in study.levels])
            label = study.title
            if study.expected is not None:
                label += f": {study.order:.2f} (expected {study.expected:g})"
                kept = np.array([level in study.fitted for level in study.levels])
                line = np.polyfit(np.log(size[kept]), np.log(error[kept]), 1)
                axes.loglog(size[kept], np.exp(np.polyval(line, np.log(size[kept]))), "--", color=colour, linewidth=1)
            style = "none" if study.expected is not None else ":"
            axes.loglog(
                size,
                error,
                marker=_MARKERS[k % 6],
                markersize=5,
                markerfacecolor=colour if k < 6 else "white",
                color=colour,
                linestyle=style,
                linewidth=1,
                label=label,
            )
        _label_sizes(axes, [study for study in subject.studies if study.unit == unit])
        axes.set_xlabel(f"element size, {unit}" if unit == "mm" else unit)
        axes.set_ylabel("relative error")
        axes.grid(True, which="major", color="#dddddd", linewidth=0.6)
        axes.tick_params(which="both", labelsize=8)
        axes.legend(fontsize=7.5, frameon=False, loc="best")
        for side in ("top", "right"):
            axes.spines[side].set_visible(False)
    figure.savefig(path, dpi=110, metadata={"Software": None})


def _label_sizes(axes: Any, studies: Sequence[Study]) -> None:
    """Ticks at sizes in steps of about two instead of decades."""
    sizes = [level.size for study in studies for level in study.levels]
    low, high = min(sizes), max(sizes)
    ticks = [step * 10.0**power for power in range(-6, 3) for step in (1, 2, 5)]
    ticks = [tick for tick in ticks if 0.8 * low <= tick <= 1.25 * high]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.set_xticks([], minor=True)


def _summary(report: Report) -> str:
    studies, checks = list(report.studies.values()), list(report.checks.values())
    ordered = [study for study in studies if study.expected is not None]
    missed = [study.title for study in ordered if not study.as_expected] + [c.what for c in checks if not c.met]
    counts = (
        f"{sum(study.as_expected for study in ordered)} of {len(ordered)} fitted orders are as expected and "
        f"{sum(check.met for check in checks)} of {len(checks)} checks meet their target."
    )
    if missed:
        counts += " **Missed:** " + "; ".join(missed) + "."
    versions = ", ".join(f"{name} {version}" for name, version in report.versions.items())
    made = f"Made with {versions}; sparse solver {report.solver}; one thread; {report.seconds:.0f} s of processor time."
    return f"{_wrapped(counts)}\n\n{_wrapped(made)}"


def _orders(studies: Sequence[Study]) -> str:
    rows = []
    for study in studies:
        fitted = expected = ""
        if study.expected is not None:
            fitted, expected = f"{study.order:.2f}", f"{study.expected:g} ± {study.spread:g}"
        verdict = "" if study.as_expected else "**not as expected**"
        resolved = "" if study.resolved is None else f"meshes up to {study.resolved:.2g} {study.unit}"
        note = "; ".join(part for part in (verdict, resolved, study.note) if part)
        errors = f"{study.levels[0].error:.1e}, {study.levels[-1].error:.1e}"
        rows.append((study.title, study.against, fitted, expected, errors, note))
    return _against(("study", "against", "order", "expected", "error", ""), rows)


def _checks(checks: Sequence[Check]) -> str:
    rows = []
    for check in checks:
        measured, target = (
            f"{value:.1e}{check.unit and ' ' + check.unit}" if value else "0"
            for value in (check.measured, check.target)
        )
        rows.append((check.what, check.against, measured, target, "" if check.met else "**missed**", check.note))
    return _against(("what", "against", "measured", "target", "", "where"), rows)


def _against(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table; what all rows are compared with stands in its head once."""
    if len({row[1] for row in rows}) == 1 < len(rows):
        header = (f"{header[0]}, against {rows[0][1]}", *header[2:])
        rows = [(row[0], *row[2:]) for row in rows]
    return _markdown(header, rows)


def _table(table: Table) -> str:
    return f"{table.title}:\n\n{_markdown(table.header, table.rows)}"


def _markdown(header: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table; columns that are empty throughout are left out."""
    kept = [k for k in range(len(header)) if header[k] or any(row[k] for row in rows)]
    kept = [k for k in kept if any(row[k] for row in rows)]

    def line(cells: Sequence[str]) -> str:
        return "| " + " | ".join(cells[k].replace("|", "\\|") for k in kept) + " |"

    return "\n".join([line(header), "|" + "---|" * len(kept), *(line(row) for row in rows)])


def _wrapped(text: str) -> str:
    return textwrap.fill(" ".join(text.split()), _WIDTH, break_long_words=False, break_on_hyphens=False)
