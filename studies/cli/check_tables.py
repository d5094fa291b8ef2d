"""Output of ``check``: the verdict and its four figures, then all other findings, folded or in full."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import studies.run
from geometry.ground.extras import is_installed
from geometry.ground.refusal import counted
from studies.cli.stock_tables import show_stock_fit
from studies.cli.terminal_tables import (
    say,
    show_findings,
    show_first,
    show_folded,
    show_narrow,
    show_notes,
    show_verdict,
    table_of,
    tell,
    tell_wrapped,
)
from studies.output.display import number
from studies.verdict import SHOWN

if TYPE_CHECKING:
    from geometry.plan.wiring_graph import WiringCounts
    from studies.run.check import DesignCheck
    from studies.run.enclosed_air import EnclosedFindings
    from studies.run.quality import DesignQuality
    from studies.run.shaking import ShakenFindings


@dataclass(frozen=True)
class _Section:
    """Part of the findings that is folded into a line unless all is asked for."""

    title: str
    """Title of the line."""
    worst: str
    """The worst finding, or the figures that matter most."""
    show: Callable[[], None]
    """Prints the whole section."""


def show_check(found: DesignCheck, *, full: bool = False) -> None:
    """Print the verdict, its reasons with their remedies, four figures, and the obstacles to making the array.

    A line for each other table follows, with its worst finding.

    Args:
        found: the findings.
        full: whether to print the tables themselves instead.
    """
    if found.verdict is not None:
        show_verdict(found.verdict)
    if full or found.problems or found.verdict is None:
        say(f"{found.design.name}: {found.buildability}")
    if not _is_stated(found):
        show_first(found.overlaps or found.misfits, "- {}")
    if found.mend:
        tell_wrapped(f"- {found.mend}")
    _show_unjudged(found)
    show_notes(found.notes, found.misfits if found.overlaps else ())
    if found.fidelity.too_large:
        tell_wrapped(f"transfer functions are {found.fidelity.words}")
    sections = list(_sections(found))
    if full:
        for section in sections:
            section.show()
        return
    show_folded("more, with --full", [(section.title, section.worst) for section in sections])


def _sections(found: DesignCheck) -> Iterator[_Section]:
    """All findings beside the verdict, in the order in which a designer needs them."""
    quality, printing = found.quality, found.printing
    contact = f"{found.coverage:.0%} by a contact of {found.design.target.contact_radius:g} mm radius"
    contact += "" if found.uncovered is None else f"; {found.uncovered.words}"
    yield _Section("coverage", contact, lambda: _show_layout(found))
    if quality is not None:
        yield _Section("accuracy in a run", quality.in_short, lambda: _show_quality(quality))
    if printing is not None:
        yield _Section("printing", studies.run.worst_of_printing(printing), lambda: show_findings(printing))
    yield _Section("parts to buy", studies.run.worst_of_stock(found.stock), lambda: show_stock_fit(found.stock))
    yield _Section("model limits", studies.run.worst_assumption(found.validity), lambda: _show_validity(found))
    yield _Section("attenuation", _weakest(found), lambda: _show_attenuation(found))
    yield _Section("enclosed air", studies.run.worst_of_air(found.enclosed), lambda: _show_enclosed(found.enclosed))
    yield _Section("motion", studies.run.worst_of_motion(found.shaken), lambda: _show_shaken(found.shaken))
    # the reasons stand above where the cells are too large for a mesh
    chosen = found.fidelity.words.partition(":")[0] if found.fidelity.too_large else found.fidelity.words
    yield _Section("fidelity", chosen, lambda: _show_fidelities(found))
    yield _Section("wiring", _points_by_microphones(found.wiring), lambda: _show_wiring(found.wiring))
    yield _Section("cells", counted(len(found.cells), "distinct cell"), lambda: _show_cells(found))
    if found.part_counts:
        words = f"{counted(sum(found.part_counts.values()), 'part')} of {counted(len(found.part_counts), 'kind')}"
        yield _Section("parts to make", words, lambda: _show_counts(found.part_counts))


def _is_stated(found: DesignCheck) -> bool:
    """True if a reason of the verdict is the only problem; a table lists those of the print rules."""
    shown = () if found.verdict is None else found.verdict.broken[:SHOWN]
    return len(found.overlaps or found.misfits) == 1 and any(rule.name == "buildable" for rule in shown)


def _show_unjudged(found: DesignCheck) -> None:
    """Print the findings that need a package which is not installed."""
    if not is_installed("train"):
        tell("accuracy is not predicted because torch is missing: pip install 'acoustic-fem[train]'")
    if found.printing is None:
        tell("fit and printing are not checked because CadQuery is missing: pip install 'acoustic-fem[cad]'")


def _show_layout(found: DesignCheck) -> None:
    length, width, height = max(found.size[:2]), min(found.size[:2]), found.size[2]
    say(f"{length:.1f} x {width:.1f} x {height:.1f} mm")
    say(found.covered)


def _show_quality(quality: DesignQuality) -> None:
    table = table_of("predicted quality", "value", "remark", numbers=(1,))
    for row in quality.lines:
        table.add_row(*row)
    show_narrow(table)


def _points_by_microphones(wiring: WiringCounts) -> str:
    lines = counted(wiring.lines, "line")
    each = f"{wiring.points_per_microphone:.3g} points per microphone"
    return f"{counted(wiring.points, 'point')} on {lines}, {each}"


def _show_wiring(wiring: WiringCounts) -> None:
    table = table_of("wiring", "", numbers=(1,))
    lines = f"microphones joined by {counted(wiring.lines, 'line')}"
    if wiring.most_lines > wiring.lines:
        lines += f"; {wiring.most_lines} are possible"
    for row in (
        (lines, str(wiring.microphones)),
        ("points", str(wiring.points)),
        ("points per microphone", f"{wiring.points_per_microphone:.3g}"),
        ("  compared with one microphone per point", f"{wiring.gain_over_one_transducer_per_point:.3g} times"),
        ("  compared with rows + columns", f"{wiring.gain_over_row_column:.3g} times"),
    ):
        table.add_row(*row)
    show_narrow(table)


def _show_cells(found: DesignCheck) -> None:
    table = table_of("distinct cell", "places", numbers=(1,))
    for cell, places in found.cells:
        table.add_row(cell.label, str(places))
    show_narrow(table)
    if found.kinds:
        table = table_of("kind", "of", "sizes", "count", numbers=(3,))
        for kind in found.kinds:
            table.add_row(kind.name or "as stated", kind.what, kind.sizes, str(kind.count))
        show_narrow(table)


def _show_fidelities(found: DesignCheck) -> None:
    table = table_of("fidelity", "computing time, and error")
    for line in found.fidelities:
        table.add_row(*line.split(": ", 1))
    show_narrow(table)


def _show_counts(counts: Mapping[str, int]) -> None:
    table = table_of("part", "count", numbers=(1,))
    for part, count in counts.items():
        table.add_row(part, str(count))
    show_narrow(table)


def _weakest(found: DesignCheck) -> str:
    """The weakest of the attenuations, which are those of the weakest point."""
    frequency, level, point = min(found.attenuation, key=lambda each: each[1])
    return f"{level:.1f} dB at {frequency:g} Hz from point {point} to its second microphone"


def _show_attenuation(found: DesignCheck) -> None:
    table = table_of("estimated attenuation", "level (dB)", "", numbers=(1,))
    for frequency, level, point in found.attenuation:
        table.add_row(f"{frequency:g} Hz", f"{level:.1f}", f"point {point} at its second-loudest microphone")
    show_narrow(table)


def _show_validity(found: DesignCheck) -> None:
    table = table_of("the models assume", "value", "limit", "", numbers=(1,))
    for item in found.validity:
        table.add_row(
            f"{item.assumption}\n  {item.meaning}",
            f"{number(item.value)} {item.unit}",
            f"{item.relation} {item.limit:g} {item.unit}",
            "ok" if item.holds else "warn",
        )
    show_narrow(table)


def _show_enclosed(enclosed: EnclosedFindings) -> None:
    if enclosed.changes:
        table = table_of("enclosed air", "pressure (Pa)", "compliance (%)", "responses (%)", numbers=(1, 2, 3))
        for change in enclosed.changes:
            table.add_row(
                change.state, f"{change.overpressure:.0f}", f"{change.compliance:+.0f}", f"{change.response:.0f}"
            )
        show_narrow(table)
    table = table_of("enclosed air", "")
    for row in enclosed.rows:
        table.add_row(*row)
    show_narrow(table)


def _show_shaken(shaken: ShakenFindings) -> None:
    table = table_of("motion without a touch", "")
    for row in shaken.rows:
        table.add_row(*row)
    show_narrow(table)
