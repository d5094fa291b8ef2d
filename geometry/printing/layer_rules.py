"""Rules on the layers that a slicer makes of a part, as it lies on the plate and as its own file stands."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from geometry.printing.bleed import open_bores
from geometry.printing.finding import Finding, by_rule, with_note
from geometry.printing.overhangs import Cups
from geometry.printing.pose import MARGIN, Pose
from geometry.printing.slices import Slices
from geometry.schema.print_processes import PrintProcess, Rule

if TYPE_CHECKING:
    from geometry.solids.measure import Round, Tessellation

#: Islands are printed only where a support carries them.
ISLANDS = Rule(math.inf, 0.0, "a layer that begins in the air needs a support", "at most")
#: Rule for the fraction of a lying bore that overcure leaves open.
OPEN_BORE = Rule(0.1, 0.6, "assumed: half of the section is a flow resistance of four; pass a wire through such bores")
#: Rule for the fraction of the height that is exposed as first layers.
FIRST_LAYERS = Rule(
    math.inf,
    0.25,
    "assumed: first layers are squeezed and overexposed, measure their height",
    "at most",
)
#: Rule for the free border of the plate, mm.
BORDER = Rule(0.0, MARGIN, "assumed: room for a brim and for the feet of supports")


def judge_layers(
    name: str,
    facets: Tessellation,
    process: PrintProcess,
    bores: list[Round],
    pose: Pose,
    cups: Cups | None,
) -> list[Finding]:
    """Findings on the layers of one printed part.

    Args:
        name: of the part.
        facets: as exported.
        process: with its rules and the height of its layers.
        bores: round holes of the part.
        pose: as it lies on the plate.
        cups: of the part; None where the process seals none.
    """
    slices = Slices(facets, pose.rotation, process.layer, process.pixel)
    findings = [*_hanging(name, slices, process), _thin(name, slices, process)]
    if process.bleed > 0 and (open_ones := open_bores(slices, bores, process.bleed, process.tolerance)):
        worst = open_ones[0]
        found = by_rule(name, "bore after overcure", worst.left, "of its area", OPEN_BORE, worst.bore.place)
        bore = f"bore of {worst.bore.diameter:.3g} mm that lies in layers of {process.layer:g} mm"
        light = f"light hardens {process.bleed:g} mm below and {process.tolerance:g} mm beside them"
        findings.append(with_note(found, f"{bore}, {light}"))
    if process.first_layers > 0:
        overexposed = min(process.first_layers * process.layer / pose.size[2], 1.0)
        found = by_rule(name, "height in first layers", overexposed, "", FIRST_LAYERS, None)
        findings.append(with_note(found, f"{process.first_layers:g} layers of {process.layer:g} mm"))
    if process.overhang_angle > 0 and pose.fits:
        border = min((room - own) / 2 for room, own in zip(process.build_volume[:2], pose.size[:2], strict=True))
        findings.append(by_rule(name, "free border of the plate", border, "mm", BORDER, None))
    if pose.upside_down and cups is not None:
        findings.append(_single_file(name, process, cups))
    return findings


def narrowest_vent(process: PrintProcess, bores: list[Round]) -> float:
    """Width of the narrowest vent that is looked for in a cup, mm: the part's own narrowest bore, if it stays open."""
    advised = process.hole.advised
    return max(min(bores[0].diameter, advised) if bores else advised, process.hole.limit)


def _hanging(name: str, slices: Slices, process: PrintProcess) -> list[Finding]:
    """Islands and the reach of overhangs; powder carries both."""
    if process.overhang_angle <= 0:
        return []
    islands = slices.islands()
    first = islands[0].place if islands else None
    found = by_rule(name, "islands", len(islands), "", ISLANDS, first)
    if islands:
        layers = ", ".join(str(layer + 1) for layer in dict.fromkeys(island.layer for island in islands))
        found = with_note(found, f"they begin in layer {layers} of {len(slices.sections)}")
    reach = slices.overhang(process.overhang_angle)
    return [found, by_rule(name, "reach of overhang", reach.span, "mm", process.overhang_span, reach.place)]


def _thin(name: str, slices: Slices, process: PrintProcess) -> Finding:
    walls = slices.thin_walls()
    width = min((wall.width for wall in walls), default=2 * process.pixel)
    place = min(walls, key=lambda wall: wall.width).place if walls else None
    rule = Rule(process.pixel, 2 * process.pixel, "narrower walls are one row of pixels, or none, in every layer")
    found = by_rule(name, "wall in pixels", width, "mm", rule, place)
    if walls:
        return with_note(found, f"largest such place {walls[0].area:.2g} mm^2 in a layer")
    return with_note(found, "no wall is narrower than two pixels")


def _single_file(name: str, process: PrintProcess, cups: Cups) -> Finding:
    """Finding on the part's own file, which stands as drawn, where the plate has it upside down."""
    cup = cups.largest()
    found = by_rule(name, "sealed cup of its own file", cup.value, "mm^3", process.cup_volume, cup.place)
    return with_note(found, "the file of the single part stands as drawn; turn it upside down as on the plate")
