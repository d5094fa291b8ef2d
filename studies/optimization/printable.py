"""Test that a design can be printed and laid out, from its fields alone: microseconds for walls and holes.

The designs that a search may try are decided here; the parts of what it finds are then drawn and measured
(:func:`geometry.print_report`), which takes seconds.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from geometry import ArrayDesign
from geometry.design.design_file import value_of
from geometry.layout.overlaps import OverlapError, refuse_overlaps
from geometry.schema.part_fields import Tube
from geometry.schema.print_processes import PrintProcess, Rule, process_of

#: What the print rules demand: that none fails, that none is at risk, or that nothing is worse than in the base.
Demand = Literal["least", "advised", "base"]

#: Fields that a rule of the process judges as they stand.
_DIRECT = {
    "resonator.wall_thickness": "wall",
    "resonator.floor_thickness": "wall",
    "printing.port_lip": "wall",
    "microphone.wall_thickness": "wall",
    "resonator.cavity_diameter": "hole",
    "microphone.chamber_diameter": "hole",
    "microphone.sound_hole_diameter": "hole",
    "tube.inner_diameter": "hole",
    "microphone_tube.inner_diameter": "hole",
    "printing.glue_gap": "glue_gap",
    "membrane.thickness": "cast",
}
_ROUNDING = 1e-6  # mm


@dataclass(frozen=True)
class Measure:
    """Measure: one length of a design that a rule judges."""

    name: str
    """Dotted name of the field, or name of what is measured."""
    value: float
    """Length, mm."""
    rule: Rule
    """Rule that judges it."""


def measures(design: ArrayDesign) -> tuple[Measure, ...]:
    """Measures of a design: walls, holes, gaps and the cast thickness."""
    return tuple(_measures(design, process_of(design.printing)))


def _measures(design: ArrayDesign, process: PrintProcess) -> Iterator[Measure]:
    for name, kind in _DIRECT.items():
        yield Measure(name, float(value_of(design, name)), _rule(process, kind))
    resonator, chamber, gap = design.resonator, design.microphone, design.printing.glue_gap
    axis = resonator.port_axis_height
    tubes = {"tube": design.tube, "microphone_tube": design.microphone_tube}
    for index, line in enumerate(design.lines):
        for end in ("tube", "microphone_tube"):
            own: Tube | None = getattr(line, end)
            if own is not None:
                tubes[f"lines.{index}.{end}"] = own
                yield Measure(f"lines.{index}.{end}.inner_diameter", own.inner_diameter, process.hole)
    for name, tube in design.tube_kinds.items():
        tubes[f"tube_kinds.{name}"] = tube
        yield Measure(f"tube_kinds.{name}.inner_diameter", tube.inner_diameter, process.hole)
    for name, point in design.point_kinds.items():
        if point.membrane_thickness is not None:
            yield Measure(f"point_kinds.{name}.membrane_thickness", point.membrane_thickness, _rule(process, "cast"))
    lowest = min(design.of_kind(kind).resonator.cavity_height for kind in design.kinds)
    for name, tube in tubes.items():
        hole = tube.outer_diameter / 2 + gap
        yield Measure(f"wall above the socket of {name}", lowest - axis - hole, process.wall)
        yield Measure(f"wall below the socket of {name}", resonator.floor_thickness + axis - hole, process.wall)
        if name.endswith("microphone_tube"):
            yield Measure(f"wall beside the socket of {name}", chamber.chamber_height / 2 - hole, process.wall)


def _rule(process: PrintProcess, kind: str) -> Rule:
    return {"wall": process.wall, "hole": process.hole, "glue_gap": process.clearance, "cast": process.cast_thickness}[
        kind
    ]


def worst_accepted(demand: Demand) -> frozenset[str]:
    """Verdicts of :func:`geometry.print_report` on drawn parts that a demand lets pass."""
    return frozenset({"ok"}) if demand == "advised" else frozenset({"ok", "warn"})


class PrintDemand:
    """Demand that the designs of a search must meet to be printed and laid out.

    Args:
        base: the design that is varied: it names the process, and is what designs are compared with where the demand
            is "base".
        demand: see :data:`Demand`. Parts in each other's way are refused whatever is demanded.
    """

    def __init__(self, base: ArrayDesign, demand: Demand) -> None:
        self.demand: Demand = demand
        self._in_base = {measure.name: measure for measure in measures(base)}

    def least_value(self, name: str) -> float | None:
        """Smallest value of a field that is allowed, mm; None where no rule judges that field alone."""
        found = self._in_base.get(name)
        return None if found is None else self._limit(found)

    def refusals(self, design: ArrayDesign) -> list[str]:
        """Reasons why a valid design cannot be printed or laid out; empty where it can."""
        reasons = []
        for measure in measures(design):
            limit = self._limit(measure)
            if measure.value < limit - _ROUNDING:
                reasons.append(f"{measure.name} = {measure.value:.4g} mm must be at least {limit:.4g} mm to be printed")
        if not reasons:
            try:
                refuse_overlaps(design)
            except OverlapError as error:
                reasons = [str(problem) for problem in error.problems]
        return reasons

    def _limit(self, measure: Measure) -> float:
        """With "base" the advised value, or that of the base where it is below; never less than the rule's least."""
        rule = measure.rule
        if self.demand != "base":
            return rule.limit if self.demand == "least" else rule.advised
        in_base = self._in_base.get(measure.name)
        return max(rule.limit, min(rule.advised, in_base.value)) if in_base else rule.advised
