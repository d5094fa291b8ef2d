"""The rules of a process applied to one part, on its solid and on its layers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

import geometry
from geometry.printing.finding import Finding, by_rule, with_note
from geometry.printing.layer_rules import judge_layers, narrowest_vent
from geometry.printing.overhangs import Cups, overhangs
from geometry.printing.pose import Pose, find_pose
from geometry.schema.print_processes import PrintProcess, Rule, Verdict

if TYPE_CHECKING:
    import cadquery as cq

    from geometry.solids.measure import Round, Tessellation

#: Entries of a part's parameters that are radial gaps to what is put into it, and how the report calls them.
GAPS = {
    "glue_gap": "gap around tube",
    "pin_clearance": "gap around pin",
    "guide_clearance": "gap of guides",
    "board_gap": "gap around board",
}
#: Facets of a casting that look up: the z of their normals; walls have a draft.
_UPWARDS = 0.5
#: Shorter than this share of its diameter a free-standing cylinder is a plate, not a pin.
_PLATE = 0.5


def judge_printed(
    name: str, solid: cq.Shape, facets: Tessellation, process: PrintProcess, parameters: Mapping[str, Any]
) -> list[Finding]:
    """Every rule of a process on a part that is printed.

    Args:
        name: of the part.
        solid: the part, one valid solid.
        facets: as exported.
        process: with its rules.
        parameters: what the part was generated from; gaps to what is put into it are judged where they are known.
    """
    from geometry.printing.walls import Faces, narrowest_gap, thinnest_wall

    faces = Faces(solid, facets)
    wall, gap = thinnest_wall(faces), narrowest_gap(faces)
    findings = [by_rule(name, "thinnest wall", wall.value, "mm", process.wall, wall.place)]
    round_ones = geometry.solids.rounds(solid)
    holes = [one for one in round_ones if one.hollow]
    if holes:
        findings.append(by_rule(name, "narrowest hole", holes[0].diameter, "mm", process.hole, holes[0].place))
    if math.isfinite(gap.value):
        findings.append(by_rule(name, "narrowest gap", gap.value, "mm", process.slot, gap.place))
    pins = [one for one in round_ones if not one.hollow and one.length > _PLATE * one.diameter]
    if pins:
        pin = max(pins, key=_aspect)
        findings.append(by_rule(name, "slenderest pin", _aspect(pin), "", process.pin_aspect, pin.place))
    for key, called in GAPS.items():
        if isinstance(parameters.get(key), float):
            findings.append(by_rule(name, called, parameters[key], "mm", process.clearance, None))
    pose = find_pose(facets, process)
    is_cup_judged = math.isfinite(process.cup_volume.advised)
    cups = Cups(facets, narrowest_vent(process, holes)) if is_cup_judged else None
    findings += _built(name, facets, process, cups, pose)
    findings += judge_layers(name, facets, process, holes, pose, cups)
    voids = geometry.solids.inner_voids(solid)
    reason = "voids from which liquid resin or powder cannot escape"
    findings.append(Finding(name, "trapped volumes", voids, 0, "", "fail" if voids else "ok", reason, None, "at most"))
    findings += [_size(name, process, pose), _facets(name, facets, process)]
    return findings


def judge_cast(name: str, facets: Tessellation, process: PrintProcess) -> Finding:
    """The one rule on a part that is cast between printed plates: its thinnest place above its flat lower face."""
    corners = facets.vertices[facets.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    upwards = corners[normals[:, 2] > _UPWARDS * np.linalg.norm(normals, axis=1)]
    thickness = float(upwards[:, :, 2].min() - facets.vertices[:, 2].min())
    return by_rule(name, "cast thickness", thickness, "mm", process.cast_thickness, None)


def judge_shims(name: str, step: float, process: PrintProcess) -> Finding:
    """Finding on shims of neighbouring steps that look alike: a warning, since they can be measured."""
    tolerance = process.tolerance
    source = f"two shims true to {tolerance:g} mm each may be the wrong way round, measure them; {process.source}"
    return by_rule(name, "step of shims", step, "mm", Rule(0.0, 2 * tolerance, source), None)


def _built(name: str, facets: Tessellation, process: PrintProcess, cups: Cups | None, pose: Pose) -> list[Finding]:
    """Findings that depend on the direction of building."""
    findings = []
    if process.overhang_angle > 0:
        hang = overhangs(facets, process.overhang_angle, pose.upside_down)
        finding = by_rule(name, "widest overhang", hang.span, "mm", process.overhang_span, hang.place)
        note = f"built {pose.words}, {hang.area:.3g} mm^2 in all are flatter than {process.overhang_angle:g} degrees"
        findings.append(with_note(finding, note))
    if cups is not None:
        cup = cups.largest(pose.upside_down)
        findings.append(by_rule(name, "sealed cup", cup.value, "mm^3", process.cup_volume, cup.place))
    return findings


def _size(name: str, process: PrintProcess, pose: Pose) -> Finding:
    size, room = max(zip(pose.size, process.build_volume, strict=True), key=lambda pair: pair[0] / pair[1])
    verdict: Verdict = "ok" if pose.fits else "fail"
    reason = f"laid {pose.words}; build volume: {process.source}"
    return Finding(name, "size", size, room, "mm", verdict, reason, None, "at most")


def _facets(name: str, facets: Tessellation, process: PrintProcess) -> Finding:
    half = process.pixel / 2
    verdict: Verdict = "ok" if facets.deviation <= half else "warn"
    reason = f"limit half a pixel, measured on the exported mesh; {process.source}"
    return Finding(name, "facets off the surface", facets.deviation, half, "mm", verdict, reason, None, "at most")


def _aspect(pin: Round) -> float:
    return pin.length / pin.diameter
