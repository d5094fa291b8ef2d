"""Can it be printed? Rules of a process as data, and what is measured on the parts against them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from geometry.assembly import PartSet
from geometry.part_files import tessellation_tolerance

if TYPE_CHECKING:
    import cadquery as cq

Verdict = Literal["ok", "warn", "fail"]


@dataclass(frozen=True)
class Rule:
    """Smallest value of a measure: below ``least`` it fails, below ``advised`` it is a risk (mm)."""

    least: float
    advised: float
    source: str

    def verdict(self, value: float) -> Verdict:
        """How a measured value, mm, stands to the rule; rounding of the measure (1 micrometre) is forgiven."""
        if value < self.least - 1e-3:
            return "fail"
        return "warn" if value < self.advised - 1e-3 else "ok"


@dataclass(frozen=True)
class PrintProcess:
    """What a printing process can make; lengths in mm."""

    name: str
    title: str
    wall: Rule
    hole: Rule
    glue_gap: Rule
    """Radial gap between a tube and its socket."""
    pixel: float
    """Width of a pixel or laser spot: facets coarser than half of it show."""
    build_volume: tuple[float, float, float]
    source: str


_GUIDES = (
    "print services' resin guides (addema.se/guides-sla; layerx3d.in, SLA and DLP design rules), read as typical values"
)
_ASSUMED = "assumed for projection micro-stereolithography of 10 micrometre pixels: about ten pixels, advised twenty"

PROCESSES: dict[str, PrintProcess] = {
    "sla-resin": PrintProcess(
        name="sla-resin",
        title="desktop stereolithography, standard resin, layers of 0.05 mm",
        wall=Rule(0.2, 0.4, f"supported walls from 0.4: {_GUIDES}; below 0.2, two laser spots, none: assumed"),
        hole=Rule(0.25, 0.5, f"holes below 0.5 may close off: {_GUIDES}; below 0.25, three laser spots, all: assumed"),
        glue_gap=Rule(0.05, 0.05, f"0.1 to 0.2 on the diameter of a clearance fit: {_GUIDES}"),
        pixel=0.085,
        build_volume=(145.0, 145.0, 175.0),
        source="laser spot and build volume of a common desktop machine, assumed",
    ),
    "dlp-fine": PrintProcess(
        name="dlp-fine",
        title="projection micro-stereolithography, layers of 0.01 mm",
        wall=Rule(0.1, 0.2, _ASSUMED),
        hole=Rule(0.1, 0.2, _ASSUMED),
        glue_gap=Rule(0.01, 0.02, "assumed: one to two pixels"),
        pixel=0.01,
        build_volume=(100.0, 100.0, 75.0),
        source="pixel and build volume of a machine of this class, assumed",
    ),
}

#: Thickness of a silicone disc cast between two printed plates, whatever printed them.
CAST_THICKNESS = Rule(
    0.1,
    0.3,
    "assumed: the gap of a closed mold of printed halves is true to about 0.1 mm, which is all of a 0.1 mm disc and "
    "changes the compliance of a 0.3 mm disc by a factor of three",
)


@dataclass(frozen=True)
class Finding:
    """One rule applied to one part."""

    part: str
    rule: str
    value: float
    limit: float
    unit: str
    verdict: Verdict
    reason: str
    """Where the limit comes from, or what was measured."""


@dataclass(frozen=True)
class PrintReport:
    """All findings on a set of parts."""

    process: PrintProcess
    findings: tuple[Finding, ...]

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


def print_report(parts: Mapping[str, cq.Workplane], process: str = "sla-resin") -> PrintReport:
    """Measure parts and compare them with the rules of a process.

    Walls are measured by rays through the facets that are exported, holes as the cylinders of the solid. The
    part ``membrane`` is cast and only its thickness is judged; every other part is printed. The gap around
    the tubes is not in the solids: it is judged for parts from :func:`geometry.build_parts`, which know it.

    Args:
        parts: name to workplane with one solid, mm.
        process: name of a process in :data:`PROCESSES`.

    Raises:
        ValueError: no such process, or no parts.
    """
    if process not in PROCESSES:
        raise ValueError(f"process = {process!r} must be one of: {', '.join(PROCESSES)}")
    if not parts:
        raise ValueError("parts = {} must not be empty")
    rules = PROCESSES[process]
    tolerance = tessellation_tolerance(parts)
    parameters = parts.parameters if isinstance(parts, PartSet) else {}
    findings: list[Finding] = []
    for name, part in parts.items():
        if name == "membrane":
            findings.append(_cast_thickness(part))
            continue
        findings += _printed(name, part, rules, tolerance)
        gap = parameters.get(name, {}).get("glue_gap")
        if isinstance(gap, float):
            findings.append(_by_rule(name, "gap around tube", gap, rules.glue_gap))
    return PrintReport(rules, tuple(findings))


def _printed(name: str, part: cq.Workplane, process: PrintProcess, tolerance: float) -> list[Finding]:
    from geometry.measure import hole_diameters, inner_voids, tessellate, thinnest_wall

    solid = part.val()
    facets = tessellate(solid, tolerance)
    findings = [_by_rule(name, "thinnest wall", thinnest_wall(facets), process.wall)]
    holes = hole_diameters(solid)
    if holes:
        findings.append(_by_rule(name, "narrowest hole", holes[0], process.hole))
    voids = inner_voids(solid)
    box = solid.BoundingBox()
    # A part may be turned: its largest extent must fit the largest of the machine, and so on.
    sizes = sorted((box.xlen, box.ylen, box.zlen))
    size, room = max(zip(sizes, sorted(process.build_volume), strict=True), key=lambda pair: pair[0] / pair[1])
    half_pixel = process.pixel / 2
    findings += [
        Finding(name, "size", size, room, "mm", "ok" if size <= room else "fail", f"build volume: {process.source}"),
        Finding(
            name, "trapped volumes", voids, 0, "", "fail" if voids else "ok", "voids without a way out for liquid resin"
        ),
        Finding(
            name,
            "facets off the surface",
            facets.deviation,
            half_pixel,
            "mm",
            "ok" if facets.deviation <= half_pixel else "warn",
            f"half a pixel, as exported; {process.source}",
        ),
    ]
    return findings


def _cast_thickness(part: cq.Workplane) -> Finding:
    return _by_rule("membrane", "cast thickness", part.val().BoundingBox().zlen, CAST_THICKNESS)


def _by_rule(part: str, name: str, value: float, rule: Rule) -> Finding:
    verdict = rule.verdict(value)
    limit = rule.least if verdict == "fail" else rule.advised
    return Finding(part, name, value, limit, "mm", verdict, rule.source)
