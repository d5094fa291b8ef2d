"""The print report as JSON for programs and as one HTML page for people, which needs no network."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterable
from dataclasses import asdict
from importlib import resources
from pathlib import Path
from typing import Any

import geometry
from geometry.formats.part_files import ExportedFile
from geometry.ground.page_parts import page_parts
from geometry.ground.whole_files import write_text
from geometry.printing.printability import PrintReport
from geometry.schema.print_processes import NUMBERS, RULES, Rule

_ORDER = {"fail": 0, "warn": 1, "ok": 2}


def report_content(report: PrintReport, files: Iterable[ExportedFile] = ()) -> dict[str, Any]:
    """Content of a print report as JSON can hold it; numbers that are not finite become null.

    Args:
        report: of :func:`geometry.print_report`.
        files: of :func:`geometry.export`, listed with their deviation and volume error.
    """
    process = report.process
    rules = {name: asdict(getattr(process, name)) for name in RULES}
    return _finite(
        {
            "process": {
                "name": process.name,
                "title": process.title,
                "rules": rules,
                **{name: getattr(process, name) for name in NUMBERS},
                "build_volume": list(process.build_volume),
                "source": process.source,
            },
            "verdict": report.verdict,
            "findings": [asdict(finding) for finding in report.findings],
            "acoustic_effects": [asdict(effect) for effect in report.effects],
            "files": [
                {
                    "name": file.path.name,
                    "part": file.part,
                    "also": list(file.also),
                    "count": file.count,
                    "format": file.format,
                    "triangles": file.triangles,
                    "deviation_mm": file.linear_deviation,
                    "cad_volume_mm3": file.cad_volume,
                    "volume_error": file.volume_error,
                }
                for file in files
            ],
        }
    )


def write_report(
    report: PrintReport, folder: str | os.PathLike[str], title: str, files: Iterable[ExportedFile] = ()
) -> tuple[Path, Path]:
    """Write ``print-report.json`` and ``print-report.html``; each is there as a whole or not at all.

    Args:
        report: of :func:`geometry.print_report`.
        folder: exists.
        title: what the report is of.
        files: of :func:`geometry.export`.

    Returns:
        Paths of the two files.
    """
    content = report_content(report, files)
    folder = Path(folder)
    written = folder / "print-report.json", folder / "print-report.html"
    write_text(written[0], json.dumps(content, indent=1, allow_nan=False) + "\n")
    write_text(written[1], render(report, title, content))
    return written


def render(report: PrintReport, title: str, content: dict[str, Any]) -> str:
    """The HTML page of a report and of its content, see :func:`report_content`."""
    import jinja2

    environment = jinja2.Environment(
        autoescape=True, undefined=jinja2.StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    environment.filters |= {"number": _number, "percent": _percent, "place": _place, "fraction": _percentage}
    template = environment.from_string(
        (resources.files(geometry) / "templates" / "print-report.html").read_text(encoding="utf-8")
    )
    process = report.process
    rules: list[tuple[str, Rule]] = [(name.replace("_", " "), getattr(process, name)) for name in RULES]
    style, script = page_parts()
    return template.render(
        style=style,
        script=script,
        title=title,
        report=report,
        process=process,
        rules=rules,
        parts=list(dict.fromkeys(finding.part for finding in report.findings)),
        findings=sorted(report.findings, key=lambda finding: _ORDER[finding.verdict]),
        files=content["files"],
    )


def _number(value: float | None) -> str:
    if value is None:
        return ""
    return f"{value:.3g}" if math.isfinite(value) else "none"


def _percent(change: float | None) -> str:
    if change is None:
        return "closed"
    return f"{100 * change:+.3g} %".replace("-", "\N{MINUS SIGN}")


def _percentage(error: float) -> str:
    """Per cent with four decimals and no negative zero."""
    return f"{round(100 * error, 4) + 0.0:.4f}".replace("-", "\N{MINUS SIGN}")


def _place(place: tuple[float, float, float] | None) -> str:
    return "" if place is None else ", ".join(f"{0.0 + round(x, 2):g}" for x in place).replace("-", "\N{MINUS SIGN}")


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
