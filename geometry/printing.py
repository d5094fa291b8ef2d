"""Can it be printed? What is measured on the parts against the rules of a process."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from geometry.assembly import PartSet
from geometry.part_files import SharedShape, origin, tessellation_tolerance
from geometry.print_processes import PrintProcess, Verdict, find_process, process_of
from geometry.print_rules import Finding, judge_cast, judge_printed
from geometry.print_tolerance import AcousticEffect, acoustic_effects

if TYPE_CHECKING:
    import cadquery as cq

    from geometry.design import ArrayDesign

DEFAULT_PROCESS = "sla-resin"


@dataclass(frozen=True)
class PrintReport:
    """All findings on a set of parts."""

    process: PrintProcess
    findings: tuple[Finding, ...]
    effects: tuple[AcousticEffect, ...] = ()
    """What the tolerance of the process does to the acoustics, where the design is known."""

    @property
    def verdict(self) -> Verdict:
        """The worst of all findings."""
        verdicts = {finding.verdict for finding in self.findings}
        return "fail" if "fail" in verdicts else "warn" if "warn" in verdicts else "ok"

    @property
    def problems(self) -> tuple[Finding, ...]:
        """Findings that are not ``ok``, failures first."""
        bad = [finding for finding in self.findings if finding.verdict != "ok"]
        return tuple(sorted(bad, key=lambda finding: finding.verdict == "warn"))


def print_report(
    parts: Mapping[str, cq.Workplane],
    process: str | os.PathLike[str] | PrintProcess | None = None,
    design: ArrayDesign | None = None,
    progress: Callable[[str, float], None] | None = None,
    shapes: Sequence[SharedShape] | None = None,
) -> PrintReport:
    """Measure parts and compare them with the rules of a process.

    Walls and gaps are measured by rays between the facets that are exported, holes and pins as the cylinders and
    cones of the solid, overhangs and cups on the facets, built along z as drawn or upside down. Parts named
    ``membrane...`` are cast and only their thickness is judged; every other part is printed. Gaps to what is put
    into a part are not in the solids: they are judged for parts from :func:`geometry.build_parts`, which know them.

    Args:
        parts: name to workplane with one solid, mm.
        process: name of a process, path of a process file (see :func:`geometry.print_processes.find_process`), or
            a process; default: that of the design with the rules it states, else ``sla-resin``.
        design: what the parts were built from; with it the report says what the tolerance does to the acoustics.
        progress: called with the part being measured and the fraction done.
        shapes: of :func:`geometry.part_files.tessellate_distinct`, where they exist already.

    Raises:
        ValueError: no such process, or no parts.
    """
    if process is None:
        rules = process_of(design.printing) if design is not None else find_process(DEFAULT_PROCESS)
    else:
        rules = find_process(process)
    if not parts:
        raise ValueError("parts = {} must not be empty")
    from geometry.measure import tessellate

    tolerance = tessellation_tolerance(parts)
    facets_of = {name: shape.facets for shape in shapes or () for name in shape.names}
    parameters = parts.parameters if isinstance(parts, PartSet) else {}
    findings: list[Finding] = []
    for index, (name, part) in enumerate(parts.items()):
        if progress is not None:
            progress(name, index / len(parts))
        solid = part.val()
        source = origin(name)
        if source == "cast":
            findings.append(judge_cast(name, solid.BoundingBox().zlen, rules))
        elif source == "printed":
            facets = facets_of[name] if name in facets_of else tessellate(solid, tolerance)
            known = dict(parameters.get(name, {}))
            if design is not None and name.startswith("mold-lid"):
                known["pin_clearance"] = design.mold.pin_clearance
            findings += judge_printed(name, solid, facets, rules, known)
    effects = acoustic_effects(design, rules.tolerance) if design is not None else ()
    return PrintReport(rules, tuple(findings), effects)
