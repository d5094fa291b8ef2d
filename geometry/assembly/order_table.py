"""Table of the order in which an array is put together, with the place of each part. Lengths mm, angles degrees."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from geometry.assembly.model import ArrayModel
from geometry.assembly.part_list import place_parts
from geometry.design.array_design import ArrayDesign
from geometry.ground.whole_files import write_text
from geometry.layout.arrangement import lay_out
from geometry.layout.cutting import cut_lengths
from geometry.layout.placement import TubePlacement
from geometry.plan.routing import tightest_bend

_COLUMNS = (
    *("line", "place", "part", "rotation (degrees)", "x (mm)", "y (mm)", "z (mm)"),
    *("port before (degrees)", "port after (degrees)", "tube to the next", "bore (mm)", "outside (mm)"),
    *("sheath length (mm)", "spring length (mm)", "turns", "bend radius (mm)"),
)
#: Further columns of a design that names kinds.
_KIND_COLUMNS = ("kind", "membrane", "kind of tube")


@dataclass(frozen=True)
class JoinedTube:
    """The tube from one place of a line to the next."""

    name: str
    """Name such as ``tube 2 of line 1``."""
    bore: float
    """Diameter of the bore, mm."""
    outside: float
    """Outside diameter, mm."""
    sheath_length: float
    """Length to which the sheath is cut, mm."""
    spring_length: float
    """Length to which the spring is cut, before it is bent, mm."""
    turns: float
    """Number of turns of the spring."""
    bend_radius: float
    """Smallest radius of its axis, mm; infinite where it lies straight."""
    schematic: bool
    """True where it is drawn to show what it joins: its bends are not known, and its spring is that of a straight tube.
    """
    kind: str = ""
    """Name of its kind; empty where a line has no pattern of tubes."""


@dataclass(frozen=True)
class AssemblyStep:
    """One place of a line, from its first microphone to its second: what stands there and what leads on."""

    line: int
    """Number of the line, from 1."""
    place: str
    """Name of the place: ``microphone A`` or ``point 3``."""
    part: str
    """Name of its shell or housing, as of its files."""
    rotation: float
    """Angle by which the part is turned about its axis, degrees, anticlockwise from above."""
    position: tuple[float, float, float]
    """Position of the part's origin, mm."""
    port_before: float | None
    """Port of the part for the tube before, in the part's own degrees; None at the first microphone."""
    port_after: float | None
    """Port for the tube that follows, in the part's own degrees; None at the second microphone."""
    tube: JoinedTube | None
    """The tube that follows; None at the second microphone."""
    kind: str = ""
    """Name of the point's kind; empty at microphones and where a line has no pattern of points."""
    membrane: str = ""
    """Name of the membrane on the point, as of its files; empty at microphones."""


def assembly_steps(array: ArrayDesign | ArrayModel) -> tuple[AssemblyStep, ...]:
    """Steps line by line from microphone to microphone; one that joins several lines stands at the end of each.

    Args:
        array: the design, or what :func:`geometry.assembly.model.array_model` put together of it already.
    """
    if isinstance(array, ArrayModel):
        design, layout, placed = array.design, array.layout, array.placed
    else:
        design, layout = array, lay_out(array)
        placed = place_parts(design, layout)
    parts = {part.group: part for part in placed if part.kind in ("shell", "housing")}
    membranes = {part.group: part.part for part in placed if part.kind == "membrane"}
    tubes = {(tube.line, tube.segment): tube for tube in layout.tubes}
    ports = {m.name: {(p.line, p.end): p.angle for p in m.ports} for m in layout.microphones}
    steps = []
    for index, line in enumerate(design.lines):
        first, second = line.between
        points = [point for point in layout.points if point.line == index]
        places: list[tuple[str, float | None, float | None]] = [
            (f"microphone {first}", None, ports[first][index, 0]),
            *((f"point {point.number}", *point.port_angles) for point in points),
            (f"microphone {second}", ports[second][index, 1], None),
        ]
        for number, (name, before, after) in enumerate(places):
            part = parts[name]
            tube = _joined(design, tubes[index, number]) if number <= line.points else None
            own = [None if angle is None else _own(angle - part.rotation) for angle in (before, after)]
            turned, cast = _own(part.rotation), membranes.get(name, "")
            kind = design.kind_at(line, number - 1) if cast else ""
            steps.append(
                AssemblyStep(index + 1, name, part.part, turned, part.position, own[0], own[1], tube, kind, cast)
            )
    return tuple(steps)


def write_assembly_table(array: ArrayDesign | ArrayModel, folder: str | os.PathLike[str]) -> tuple[Path, Path]:
    """Write ``assembly.csv`` and ``assembly.txt`` into a folder that exists; each whole or not at all.

    Args:
        array: as for :func:`assembly_steps`.
        folder: where they are written.

    Returns:
        The two paths.
    """
    steps, folder = assembly_steps(array), Path(folder)
    design = array.design if isinstance(array, ArrayModel) else array
    table, page = folder / "assembly.csv", folder / "assembly.txt"
    write_text(table, _csv(steps, _is_graded(steps)))
    write_text(page, assembly_text(design, steps))
    return table, page


def assembly_text(design: ArrayDesign, steps: Sequence[AssemblyStep] | None = None) -> str:
    """The table for people.

    Args:
        design: the array.
        steps: of :func:`assembly_steps`, where they exist already.
    """
    steps = assembly_steps(design) if steps is None else steps
    graded = _is_graded(steps)
    header: tuple[str, ...] = (
        *(("place", "kind", "part", "membrane") if graded else ("place", "part")),
        "turned",
        "ports in, out",
        "tube to the next",
        *(("kind",) if graded else ()),
        "bore x outside",
        "sheath",
        "spring",
        "bent",
    )
    rows = {step: _row(step, graded) for step in steps}
    widths = [max(len(row[k]) for row in (header, *rows.values())) for k in range(len(header))]
    lines = [
        f"Assembly of {design.name}, line by line",
        "",
        "Lengths in mm, angles in degrees anticlockwise from above. A part is turned from how its file is drawn; its",
        "ports are named by their angle in the file. Every point also takes a membrane, every microphone a board.",
    ]
    for index, line in enumerate(design.lines, start=1):
        lines += ["", f"line {index}: from microphone {line.between[0]} to microphone {line.between[1]}"]
        for cells in (header, *(row for step, row in rows.items() if step.line == index)):
            lines.append("  ".join(f"{cell:<{width}}" for cell, width in zip(cells, widths, strict=True)).rstrip())
    if any(step.tube is not None and step.tube.schematic for step in steps):
        lines += ["", "* drawn schematically: how it bends is not known, its spring is cut as if it lay straight"]
    return "\n".join(lines) + "\n"


def _row(step: AssemblyStep, graded: bool) -> tuple[str, ...]:
    ports = ", ".join("-" if angle is None else f"{angle:g}" for angle in (step.port_before, step.port_after))
    what = (step.place, step.kind, step.part, step.membrane) if graded else (step.place, step.part)
    cells = (*what, f"{step.rotation:g}", ports)
    if step.tube is None:
        return (*cells, *[""] * (6 if graded else 5))
    tube = step.tube
    bent = "*" if tube.schematic else "straight" if tube.bend_radius == float("inf") else f"to {tube.bend_radius:.3g}"
    spring = f"{tube.spring_length:g}, {tube.turns:.0f} turns"
    name = (tube.name, tube.kind) if graded else (tube.name,)
    return (*cells, *name, f"{tube.bore:g} x {tube.outside:g}", f"{tube.sheath_length:g}", spring, bent)


def _is_graded(steps: Sequence[AssemblyStep]) -> bool:
    """True where points or tubes are of named kinds: the tables then have columns for them."""
    return any(step.kind or (step.tube is not None and step.tube.kind) for step in steps)


def _csv(steps: Sequence[AssemblyStep], graded: bool) -> str:
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(_COLUMNS + (_KIND_COLUMNS if graded else ()))
    for step in steps:
        ports = ["" if angle is None else f"{angle:g}" for angle in (step.port_before, step.port_after)]
        row = [step.line, step.place, step.part, f"{step.rotation:g}", *(f"{c:.4g}" for c in step.position), *ports]
        if step.tube is not None:
            tube = step.tube
            bent = "schematic" if tube.schematic else f"{tube.bend_radius:.4g}"
            row += [tube.name, f"{tube.bore:g}", f"{tube.outside:g}", f"{tube.sheath_length:g}"]
            row += [f"{tube.spring_length:g}", f"{tube.turns:.0f}", bent]
        row += [""] * (len(_COLUMNS) - len(row))
        if graded:
            row += [step.kind, step.membrane, "" if step.tube is None else step.tube.kind]
        table.writerow(row)
    return text.getvalue()


def _joined(design: ArrayDesign, placed: TubePlacement) -> JoinedTube:
    tube, (sheath, spring) = placed.tube, cut_lengths(design, placed)
    return JoinedTube(
        name=placed.label,
        bore=tube.inner_diameter,
        outside=tube.outer_diameter,
        sheath_length=sheath,
        spring_length=spring,
        turns=spring / tube.wire_diameter,
        bend_radius=tightest_bend(placed.course),
        schematic=placed.schematic,
        kind=design.tube_kind_at(design.lines[placed.line], placed.segment),
    )


def _own(angle: float) -> float:
    """An angle in [0, 360) as parts are named, in tenths of a degree."""
    return round(angle % 360, 1) % 360
