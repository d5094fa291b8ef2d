"""Files of a kit for an array on a body: body with pockets or skin, drilling template, pattern, clash test."""

from __future__ import annotations

import csv
import io
import math
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from geometry.assembly.fit import FACET_VOLUME
from geometry.assembly.model import ArrayModel
from geometry.body.reading import Body, read_body
from geometry.carving import CarvedBodies, carve
from geometry.carving.pockets import CLEARANCE
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike
from geometry.formats.facet_files import export_facets
from geometry.ground.refusal import counted
from geometry.ground.whole_files import write_text
from geometry.schema.print_processes import PrintProcess
from geometry.solids.measure import Tessellation
from studies.kit.flat_pattern import write_pattern
from studies.kit.jobs import BUILD, PRINT
from studies.output.display import Report


@dataclass(frozen=True)
class BodyFiles:
    """Solids that were made for a body, and sentences on them."""

    carved: CarvedBodies
    """The solids and their clash test."""
    findings: tuple[str, ...]
    """Sentences on walls, clashes and the pattern."""
    shown: dict[str, Tessellation]
    """Facets of the body and of its skin, by name, for pictures of the whole."""


def body_beside(source: DesignLike, design: ArrayDesign) -> Body | None:
    """The body of a design file that lies beside it.

    Args:
        source: what the design was read from.
        design: the design.

    Returns:
        The body; None for a design without one, or where its file is not at hand.

    Raises:
        Refusal: the file of the body does not do, see :func:`geometry.body.read_body`.
    """
    stated = design.surface
    if stated is None or design.layout.frozen is None or not isinstance(source, str | os.PathLike):
        return None
    path = Path(source).parent / stated.body
    return read_body(path, stated.unit, stated.skin) if path.is_file() else None


def write_body(
    model: ArrayModel, body: Body, folder: Path, formats: Sequence[str], process: PrintProcess, report: Report
) -> BodyFiles:
    """Write ``2-print/body`` with the solids, and ``pattern-*.pdf``, ``body.txt``, ``clash-test.csv`` in ``5-build``.

    Args:
        model: the array, whose places are frozen.
        body: what it was fitted to.
        folder: of the kit.
        formats: of the files of solids; those without facets are left out.
        process: whose rule for walls is applied.
        report: shows progress.

    Raises:
        Refusal: a solid is not one closed piece, or a part clashes with the wall around it.
    """
    carved = carve(model, body, report)
    for each in carved.bodies:
        export_facets(
            each.name, each.facets, each.genus, folder / PRINT / "body", formats, each.facts, model.parts.design_toml
        )
    build = folder / BUILD
    build.mkdir(parents=True, exist_ok=True)
    stretch = write_pattern(model, build)
    findings = (*_findings(carved, process), _stretch(stretch))
    write_text(build / "body.txt", _text(model, carved, findings))
    write_text(build / "clash-test.csv", _table(carved))
    shown = {"body": Tessellation(body.vertices, body.triangles, body.faces, math.nan)}
    own = carved.bodies[0]
    shown = {own.name: own.facets} if carved.seat == "in" else {**shown, own.name: own.facets}
    return BodyFiles(carved, findings, shown)


def _findings(carved: CarvedBodies, process: PrintProcess) -> list[str]:
    label, volume = carved.worst_clash
    found = [
        f"clash test: none of {counted(len(carved.clashes), 'placed part')} shares more than {volume:.2g} mm^3 with "
        f"the wall around it ({label}; allowed {FACET_VOLUME:g} mm^3)"
    ]
    if math.isfinite(carved.thinnest):
        verdict = process.wall.verdict(carved.thinnest)
        rule = "at least" if verdict != "fail" else "less than"
        where = " and ".join(carved.between)
        found.append(
            f"the thinnest wall is {carved.thinnest:.2g} mm, between the pockets of {where}: {rule} the "
            f"{process.wall.limit:g} mm that {process.title} can print"
        )
    return found


def _stretch(stretch: tuple[float, float]) -> str:
    return (
        f"pattern: distances between neighbours are off by {100 * stretch[0]:.1f} % (rms), by {100 * stretch[1]:.0f} % "
        "at worst; use it to lay out lines, and never as a template to drill by"
    )


def _text(model: ArrayModel, carved: CarvedBodies, findings: Sequence[str]) -> str:
    """Text of ``body.txt``."""
    own = carved.bodies[0]
    kind = (
        "The body has pockets for all shells, housings and tubes. Membranes are flush with it."
        if carved.seat == "in"
        else f"The skin is {own.facts['thickness']:g} mm thick, {own.facts['gap_to_body']:g} mm above the body. "
        "It has pockets for all shells, housings and tubes. Membranes are flush with its outside."
    )
    template = carved.bodies[-1]
    lines = [
        f"Body of {model.design.name}",
        "",
        kind,
        f"Pockets are {CLEARANCE:g} mm wider than their parts on each side. All pockets and channels open outwards.",
        "So glue each line and test it for leaks on the bench. Put a drop of glue into each pocket and lay the line in",
        "from outside. The wires of the microphones leave outwards through the slots of their housings.",
        f"The template has a bush of {template.facts['hole_diameter']:g} mm along the axis of each of the "
        f"{template.facts['holes']} shells and housings.",
        "Put it on a body that you do not print, to mark or to drill by.",
        "",
        *(f"- {finding}" for finding in findings),
        "",
        *(
            f"{each.name}: {each.facets.volume:.1f} mm^3, {len(each.facets.triangles)} facets, one closed piece, "
            f"{counted(each.genus, 'way')} through it"
            for each in carved.bodies
        ),
    ]
    return "\n".join(lines) + "\n"


def _table(carved: CarvedBodies) -> str:
    """Table of the clash test."""
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["part", "volume shared with the wall (mm^3)", "allowed (mm^3)"])
    for label, volume in carved.clashes.items():
        table.writerow([label, f"{volume:.3g}", f"{FACET_VOLUME:g}"])
    return text.getvalue()
