"""Measures of the parts against the rules of a printing process."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import geometry
from geometry.assembly.part_list import PartKind, part_set
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.formats.part_files import SharedShape, tessellation_tolerance
from geometry.ground.argument_checks import check_given
from geometry.printing.print_rules import Finding, judge_cast, judge_printed, judge_shims
from geometry.printing.tolerance import USUAL_TOLERANCE, AcousticEffect, acoustic_effects
from geometry.schema.print_processes import PrintProcess, Verdict, find_process, process_of

if TYPE_CHECKING:
    import cadquery as cq

DEFAULT_PROCESS = "sla-resin"


@dataclass(frozen=True)
class PrintReport:
    """All findings on a set of parts."""

    process: PrintProcess
    """The process that the parts are printed in."""
    findings: tuple[Finding, ...]
    """Every rule applied to every part."""
    effects: tuple[AcousticEffect, ...] = ()
    """Effects of 0.05 mm, and of the process's tolerance where that differs, on the acoustics of a design."""

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

    @property
    def supported(self) -> tuple[str, ...]:
        """Names of the parts whose overhangs or islands need supports."""
        return tuple(dict.fromkeys(finding.part for finding in self.findings if finding.needs_support))


def print_report(
    parts: Mapping[str, cq.Workplane],
    process: str | os.PathLike[str] | PrintProcess | None = None,
    design: DesignLike | None = None,
    progress: Callable[[str, float], None] | None = None,
    shapes: Sequence[SharedShape] | None = None,
) -> PrintReport:
    """Measure parts and compare them with the rules of a process.

    Walls and gaps are found by rays between the facets that are exported and measured between the faces of the
    solid, holes and pins as its cylinders and cones, overhangs and cups on the facets, as the part is laid on the
    plate, see :func:`geometry.printing.pose.find_pose`. Only the thickness of the disc is judged on cast parts.
    Gaps to what is put into a part are not in the solids: the design states them.

    Args:
        parts: of :func:`geometry.build_parts`, or some of them by :meth:`geometry.assembly.PartSet.only`, which know
            what is cast, bought and printed; or any others by name, workplanes with one solid, mm: all of them printed.
        process: name of a process, path of a process file (see :func:`geometry.schema.print_processes.find_process`),
            or a process; default: that of the design with the rules it states, else ``sla-resin``.
        design: what the parts were built from; with it the report says what the tolerance does to the acoustics.
        progress: called with the part being measured and the fraction done.
        shapes: of :func:`geometry.formats.part_files.tessellate_distinct`, where they exist already.

    Raises:
        Refusal: no such process, or no parts.
    """
    design = None if design is None else resolve_design(design)
    if process is None:
        rules = process_of(design.printing) if design is not None else find_process(DEFAULT_PROCESS)
    else:
        rules = find_process(process)
    check_given("parts", parts, remedy="give at least one part")
    tolerance = tessellation_tolerance(parts)
    facets_of = {name: shape.facets for shape in shapes or () for name in shape.names}
    known = part_set(parts)
    findings: list[Finding] = []
    for index, (name, part) in enumerate(parts.items()):
        if progress is not None:
            progress(name, index / len(parts))
        solid = part.val()
        source, kind = known.origin(name), known.kinds.get(name)
        if source == "bought":
            continue
        facets = facets_of[name] if name in facets_of else geometry.solids.tessellate(solid, tolerance)
        if source == "cast":
            findings.append(judge_cast(name, facets, rules))
            continue
        gaps = _gaps(kind, design) if design is not None else known.parameters.get(name, {})
        findings += judge_printed(name, solid, facets, rules, gaps)
        if design is not None and kind == "mold-shim":
            findings.append(judge_shims(name, design.mold.shim_step, rules))
    effects: tuple[AcousticEffect, ...] = ()
    if design is not None:
        for tolerance in dict.fromkeys((USUAL_TOLERANCE, rules.tolerance)):
            effects += acoustic_effects(design, tolerance)
    return PrintReport(rules, tuple(findings), effects)


def _gaps(kind: PartKind | None, design: ArrayDesign) -> dict[str, float]:
    """Radial gaps to what is put into a part of a design or slides on it, mm, by the keys of ``print_rules.GAPS``."""
    match kind:
        case "housing":
            return {"glue_gap": design.printing.glue_gap, "board_gap": design.microphone.board_gap}
        case "shell" | "carrier":
            return {"glue_gap": design.printing.glue_gap}
        case "mold-scraper":
            return {"guide_clearance": design.mold.pin_clearance}
        case "mold-lid" | "mold-shim" | "mold-plugs":
            return {"pin_clearance": design.mold.pin_clearance}
        case _:
            return {}
