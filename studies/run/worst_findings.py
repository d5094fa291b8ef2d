"""The worst finding of each table of a check or a report, in a few words."""

from __future__ import annotations

import math
from collections.abc import Sequence

from geometry.ground.refusal import counted
from geometry.printing.print_rules import Finding
from geometry.printing.printability import PrintReport
from geometry.stock import StockFit
from localize.signals.stimulus import BAND
from studies.metrics.pairs import worst_heard
from studies.output.display import number
from studies.output.report_texts import percent, with_worst
from studies.run.enclosed_air import EnclosedFindings
from studies.run.findings import point_rows
from studies.run.run_result import RunResult
from studies.run.shaking import ShakenFindings
from studies.run.validity import Validity


def worst_assumption(validity: Sequence[Validity]) -> str:
    """The assumption of the models that is worst in its limit, and how many fail.

    Args:
        validity: assumptions with their limits.
    """
    worst = max(validity, key=_used)
    broken = [item for item in validity if not item.holds]
    if not broken:
        return f"all {len(validity)} kept; nearest: {worst.assumption}"
    return f"{len(broken)} of {len(validity)} broken; {worst.assumption}: {_value_and_limit(worst)}"


def worst_of_printing(printing: PrintReport) -> str:
    """The print verdict, and the finding that is farthest beyond its limit.

    Args:
        printing: findings on the parts.
    """
    if not printing.problems:
        return "ok"
    first, *more = printing.problems
    worst = max((each for each in printing.problems if each.verdict == first.verdict), key=_used)
    words = f"{worst.verdict}: {worst.rule} {_value_and_limit(worst)}"
    return f"{words}, {len(more)} more" if more else words


def worst_of_stock(fit: StockFit) -> str:
    """How many parts can be bought, and the sizes that cannot.

    Args:
        fit: a design against the catalogue.
    """
    if fit.bought:
        return f"all {len(fit.parts)} in the catalogue"
    first, *more = [*fit.missing, *(change.field for change in fit.changes)]
    return f"{first} is not in the catalogue" + (f", {len(more)} more" if more else "")


def worst_of_air(enclosed: EnclosedFindings) -> str:
    """The state of the enclosed air that changes the responses most.

    Args:
        enclosed: effect of enclosed air on a design.
    """
    if not enclosed.changes:
        return f"not checked: {enclosed.unknown}"
    worst = max(enclosed.changes, key=lambda change: change.response)
    return f"{worst.state}: responses change by {worst.response:.0f} %"


def worst_of_motion(shaken: ShakenFindings) -> str:
    """The motion that looks like the strongest touch.

    Args:
        shaken: effect of motion on a design.
    """
    if not shaken.states:
        return f"not checked: {shaken.unknown}"
    worst = max(shaken.states, key=lambda each: each.force)
    beside = "" if worst.clear else f", yours is {1e3 * shaken.target:.2g} mN"
    return f"{worst.state} looks like a touch of {1e3 * worst.force:.2g} mN{beside}"


def folded_sections(result: RunResult) -> dict[str, tuple[str, str]]:
    """Title and worst finding of each section of a report, by the name of the section.

    Args:
        result: a run.
    """
    library, design, network = result.library, result.design, result.network
    first, second = result.separability.hardest_pairs[0]
    level, phase, _ = result.separability.between(first, second)
    weakest, point = worst_heard(library.transfer_function, BAND[1])
    least = min(point_rows(result), key=lambda row: float(row["found"]))
    counts = result.part_counts
    notes = [*result.layout_notes, "drawn to scale"]
    size = f"{counted(design.point_count, 'point')}, {counted(len(design.microphones), 'microphone')}"
    sections = {
        "accuracy": ("Accuracy", f"{with_worst(network.top1, network.worst)} of {network.signals}"),
        "key": ("Key figures", size),
        "array": ("The array", notes[0]),
        "apart": ("Separability of the points", f"{first} and {second} are {level:.2g} dB and {phase:.2g}° apart"),
        "transfer": ("Transfer functions", f"{number(weakest, 1)} dB at {BAND[1]:g} Hz from point {point}"),
        "points": ("Every point", f"point {least['point']}: {percent(float(least['found']))}"),
        "print": ("Can it be printed?", worst_of_printing(result.printing)),
        "parts": ("Parts to make", f"{counted(sum(counts.values()), 'part')} of {counted(len(counts), 'kind')}"),
        "cells": ("Cells", f"{counted(len(library.provenance['cells']), 'distinct cell')}"),
        "validity": ("Validity of the models", worst_assumption(result.validity)),
        "provenance": ("Provenance", f"fidelity {library.fidelity}"),
    }
    if result.disagreement is not None:
        off = f"up to {percent(result.disagreement.magnitude)} and {result.disagreement.phase:.2g}° apart"
        sections["lumped"] = ("Closed forms against 3-D cells", off)
    return sections


def _used(item: Validity | Finding) -> float:
    """Part of a limit that is used; above 1 the limit is broken."""
    low, high = (item.limit, item.value) if item.relation == "at least" else (item.value, item.limit)
    if low <= 0:
        return 0.0
    return low / high if high > 0 else math.inf


def _value_and_limit(item: Validity | Finding) -> str:
    """Value of a finding with its limit, in its unit."""
    return f"{number(item.value)} {item.unit} (limit {item.limit:.3g} {item.unit})".replace(" )", ")")
