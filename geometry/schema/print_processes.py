"""Printing processes as data: what each can make, where the figures come from, and how to state your own."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any, Literal

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import read_toml
from geometry.schema.field_errors import model_of
from geometry.schema.manufacture import Printing, PrintRules

#: Verdict of a rule of a process on a part.
Verdict = Literal["ok", "warn", "fail"]
#: Relation that a measure must have to its limit.
Relation = Literal["at least", "at most"]

#: Rounding of a measure that is forgiven, in its unit (mm: a micrometre).
_ROUNDING = 1e-3


@dataclass(frozen=True)
class Rule:
    """Limits of a measure: beyond ``limit`` it fails, between that and ``advised`` it is a risk."""

    limit: float
    """Value beyond which a measure fails, in the unit of the rule."""
    advised: float
    """Value from which on there is no risk, in the unit of the rule."""
    source: str
    """Source of the figures."""
    relation: Relation = "at least"
    """How a measure must stand to the limit."""

    def verdict(self, value: float) -> Verdict:
        """Verdict on a measured value, in the unit of the limit."""
        sign = 1 if self.relation == "at least" else -1
        if sign * (value - self.limit) < -_ROUNDING:
            return "fail"
        return "warn" if sign * (value - self.advised) < -_ROUNDING else "ok"


#: Thickness of a silicone disc cast between two printed plates.
CAST_THICKNESS = Rule(
    0.1,
    0.3,
    "assumed: the gap of a closed mold of printed halves is true to about 0.1 mm, which is all of a 0.1 mm disc and "
    "changes the compliance of a 0.3 mm disc by a factor of three",
)


@dataclass(frozen=True)
class PrintProcess:
    """Limits of a printing process."""

    name: str
    """Name by which designs and commands call it."""
    title: str
    """Title, for people."""
    wall: Rule
    """Rule for the thickness of walls, mm."""
    hole: Rule
    """Rule for the diameter of round holes, mm."""
    slot: Rule
    """Rule for the width of gaps between walls, mm: grooves, engraved marks."""
    clearance: Rule
    """Rule for the radial gap between parts that are put into each other, mm."""
    pin_aspect: Rule
    """Rule for the height over diameter of free-standing pins."""
    pixel: float
    """Width of a pixel, laser spot or nozzle, mm: facets coarser than half of it show."""
    tolerance: float
    """Amount by which a printed length may be off, mm, plus or minus."""
    build_volume: tuple[float, float, float]
    """Width, depth and height of the machine, mm."""
    source: str
    """Source of pixel, tolerance and build volume."""
    overhang_angle: float = 0.0
    """Angle from the horizontal, degrees: faces that look down and are flatter hang; 0 where powder carries them."""
    overhang_span: Rule = Rule(math.inf, math.inf, "powder carries every overhang", "at most")
    """Rule for the width of what hangs without support, mm."""
    cup_volume: Rule = Rule(math.inf, math.inf, "no liquid and no film that could hold a cup", "at most")
    """Rule for the volume that the part and the resin's film seal off while it is printed, mm^3."""
    layer: float = 0.05
    """Height of a layer, mm."""
    bleed: float = 0.0
    """Depth to which light hardens resin below a layer, mm; 0 where nothing is hardened by light."""
    first_layers: float = 0.0
    """Number of layers at the plate that are exposed longer than the others, so that the part sticks."""
    cast_thickness: Rule = CAST_THICKNESS
    """Rule for the thickness of what is cast in printed molds, mm."""


#: Fields of a process that are rules, and those that are plain numbers.
RULES = tuple(field.name for field in fields(PrintProcess) if field.type == "Rule")
#: Fields of a process that are numbers and no rules.
NUMBERS = ("overhang_angle", "pixel", "tolerance", "layer", "bleed", "first_layers")

_SLA = "print services' resin guides (addema.se/guides-sla; layerx3d.in, SLA and DLP design rules)"
_MICRO = "assumed for projection micro-stereolithography of 10 micrometre pixels"
_FDM = "guides for material extrusion (neway3dp.com/services/material-extrusion; arti90.com/en/design-clues)"
_MJF = "guides for Multi Jet Fusion (3faktur.com, chapter 3; tronix3d.com/design-guidelines; rapidmade.com, MJF)"
_SUCTION = "assumed: the film pulls on a sealed cup at every layer; tilt the part or vent the cup"

PROCESSES: dict[str, PrintProcess] = {
    "sla-resin": PrintProcess(
        name="sla-resin",
        title="desktop stereolithography, standard resin, layers of 0.05 mm",
        wall=Rule(0.2, 0.4, f"advised 0.4 mm for supported walls: {_SLA}; limit 0.2 mm, two laser spots: assumed"),
        hole=Rule(
            0.25, 0.5, f"advised 0.5 mm, smaller holes may close: {_SLA}; limit 0.25 mm, three laser spots: assumed"
        ),
        slot=Rule(0.1, 0.4, f"advised 0.4 mm, as for engraved details: {_SLA}; limit 0.1 mm, a laser spot: assumed"),
        clearance=Rule(0.05, 0.05, f"diameters in a clearance fit differ by 0.1 to 0.2 mm: {_SLA}"),
        pin_aspect=Rule(12.0, 5.0, "assumed: thin pins bend as they are peeled off the film", "at most"),
        overhang_angle=19.0,
        overhang_span=Rule(
            math.inf, 1.0, f"no support needed up to 1 mm wide, or if steeper than 19 degrees: {_SLA}", "at most"
        ),
        cup_volume=Rule(math.inf, 100.0, _SUCTION, "at most"),
        pixel=0.085,
        tolerance=0.05,
        layer=0.05,
        bleed=0.1,
        first_layers=8,
        build_volume=(145.0, 145.0, 175.0),
        source="laser spot, tolerance of small lengths, first layers, overcure of two layers and build volume of a "
        "common desktop machine: assumed; print services state a tolerance of 0.15 mm for whole parts "
        "(hycubeworks.in/design_guide)",
    ),
    "dlp-fine": PrintProcess(
        name="dlp-fine",
        title="projection micro-stereolithography, layers of 0.01 mm",
        wall=Rule(0.1, 0.2, f"{_MICRO}: ten pixels, advised twenty"),
        hole=Rule(0.1, 0.2, f"{_MICRO}: ten pixels, advised twenty"),
        slot=Rule(0.03, 0.1, f"{_MICRO}: three pixels, advised ten"),
        clearance=Rule(0.01, 0.02, f"{_MICRO}: one to two pixels"),
        pin_aspect=Rule(12.0, 6.0, "assumed: thin pins bend as they are peeled off the film", "at most"),
        overhang_angle=15.0,
        overhang_span=Rule(
            math.inf,
            1.0,
            f"{_MICRO}; no support needed up to 1 mm wide, or if steeper than 15 degrees: knowledge.envisiontec.com",
            "at most",
        ),
        cup_volume=Rule(math.inf, 100.0, _SUCTION, "at most"),
        pixel=0.01,
        tolerance=0.02,
        layer=0.01,
        bleed=0.02,
        first_layers=10,
        build_volume=(100.0, 100.0, 75.0),
        source="pixel, tolerance, first layers, overcure of two layers and build volume of such a machine, assumed",
    ),
    "fdm": PrintProcess(
        name="fdm",
        title="material extrusion, nozzle of 0.4 mm, layers of 0.1 mm",
        wall=Rule(0.8, 1.2, f"limit 0.8 mm, advised 1.2 mm: {_FDM}"),
        hole=Rule(0.8, 2.0, f"advised 2 mm: {_FDM}; limit 0.8 mm, two beads: assumed"),
        slot=Rule(0.4, 0.6, f"advised 0.6 mm, as for details: {_FDM}; limit 0.4 mm, the nozzle: assumed"),
        clearance=Rule(0.1, 0.25, f"diameters differ by 0.2 mm for connections, 0.5 mm advised: {_FDM}"),
        pin_aspect=Rule(8.0, 4.0, "assumed: thin pins have no time to cool", "at most"),
        overhang_angle=45.0,
        overhang_span=Rule(
            math.inf, 5.0, f"no support needed for bridges up to 5 mm, or if steeper than 45 degrees: {_FDM}", "at most"
        ),
        pixel=0.4,
        tolerance=0.2,
        layer=0.1,
        build_volume=(220.0, 220.0, 250.0),
        source=f"tolerance: {_FDM}; nozzle and build volume of a common machine, assumed",
    ),
    "mjf": PrintProcess(
        name="mjf",
        title="Multi Jet Fusion, polyamide 12, layers of 0.08 mm",
        wall=Rule(0.5, 1.0, f"limit 0.5 mm, advised 1 mm: {_MJF}"),
        hole=Rule(0.5, 1.0, f"limit 0.5 mm in a wall of 1 mm: {_MJF}; advised 1 mm, so that the powder comes out"),
        slot=Rule(0.5, 0.5, f"limit 0.5 mm: {_MJF}"),
        clearance=Rule(
            0.2, 0.4, f"advised 0.4 mm between parts that are joined: {_MJF}; limit 0.2 mm, below it they jam: assumed"
        ),
        pin_aspect=Rule(20.0, 10.0, f"a shaft of 0.5 mm may be 10 mm high: {_MJF}; half of this is advised", "at most"),
        pixel=0.08,
        tolerance=0.3,
        layer=0.08,
        build_volume=(380.0, 284.0, 380.0),
        source=f"layer, tolerance and build volume: {_MJF}",
    ),
}


def find_process(process: str | os.PathLike[str] | PrintProcess) -> PrintProcess:
    """A process by name, from a TOML file, or itself.

    A file states what differs from a built-in process: ``base`` (its name), then any of the keys of
    ``[printing.rules]`` in a design file, and ``name``, ``title`` and ``source``.

    Raises:
        Refusal: no such process, a file that cannot be read, or one with a key or value that is not allowed.
    """
    if isinstance(process, PrintProcess):
        return process
    if isinstance(process, str) and process in PROCESSES:
        return PROCESSES[process]
    path = Path(process)
    if path.suffix != ".toml":
        allowed = f"one of: {', '.join(PROCESSES)}; or a .toml file"
        raise Refusal(kind=Kind.UNKNOWN, field="process", value=str(process), allowed=allowed)
    given = read_toml(path, "a file of a process", Refusal)
    if not given:  # what was cut short to nothing would be taken for the default
        remedy = f"give base, one of: {', '.join(PROCESSES)}, or a rule"
        raise Refusal("has nothing in it", kind=Kind.MISSING, file=path, remedy=remedy)
    base = given.pop("base", "sla-resin")
    if not isinstance(base, str) or base not in PROCESSES:
        raise Refusal(kind=Kind.UNKNOWN, file=path, field="base", value=base, allowed=PROCESSES)
    words = {key: given.pop(key) for key in ("name", "title", "source") if key in given}
    for key, value in words.items():
        if not isinstance(value, str) or not value:
            raise Refusal(kind=Kind.WRONG_TYPE, file=path, field=key, value=value, allowed="a text")
    rules = model_of(PrintRules, given, str(path), "process", Refusal)
    source = words.pop("source", path.name)
    try:
        changed = with_rules(PROCESSES[base], rules.model_dump(exclude_none=True), source, "")
    except Refusal as error:
        raise Refusal.of(error, file=path) from None
    return replace(changed, **{"name": path.stem, **words})


def process_of(printing: Printing) -> PrintProcess:
    """The process of a design with the rules that the design states itself."""
    return with_rules(PROCESSES[printing.process], printing.rules.model_dump(exclude_none=True), "the design file")


def with_rules(
    process: PrintProcess, values: Mapping[str, Any], source: str = "given", table: str = "rules."
) -> PrintProcess:
    """A process with some of its figures replaced.

    Args:
        process: the one to start from.
        values: by the keys of ``[printing.rules]``: ``wall`` is the limit of the rule ``wall``, ``wall_advised``
            what is advised; lengths mm, angles degrees. A limit beyond what is advised moves that along.
        source: written to every changed figure.
        table: put before a key to name its field.

    Raises:
        Refusal: no such key, a value that is not a finite number above 0, or advice that breaks its limit.
    """
    known = [*RULES, *(f"{rule}_advised" for rule in RULES), *NUMBERS, "build_volume"]
    for key, value in values.items():
        if key not in known:
            raise Refusal(kind=Kind.UNKNOWN, field=f"{table}{key}", remedy=f"known: {', '.join(known)}")
        numbers = value if key == "build_volume" and len(value) == 3 else [value]
        for number in numbers:
            if not isinstance(number, int | float) or isinstance(number, bool) or not 0 < number < math.inf:
                allowed = f"{'three numbers' if len(numbers) > 1 else 'a number'} above 0"
                raise Refusal(kind=Kind.OUT_OF_RANGE, field=f"{table}{key}", value=value, allowed=allowed)
    changed: dict[str, Any] = {}
    for name in RULES:
        rule: Rule = getattr(process, name)
        if name not in values and f"{name}_advised" not in values:
            continue
        limit = float(values.get(name, rule.limit))
        stricter = max if rule.relation == "at least" else min
        advised = float(values.get(f"{name}_advised", stricter(rule.advised, limit)))
        if stricter(advised, limit) != advised:
            allowed = f"{rule.relation} {name} ({limit:g})"
            raise Refusal(kind=Kind.CONFLICT, field=f"{table}{name}_advised", value=advised, allowed=allowed)
        changed[name] = Rule(limit, advised, source, rule.relation)
    changed |= {name: float(values[name]) for name in NUMBERS if name in values}
    if "build_volume" in values:
        changed["build_volume"] = tuple(float(side) for side in values["build_volume"])
    if {*NUMBERS, "build_volume"} & changed.keys():
        changed["source"] = f"{source}; else {process.source}"
    return replace(process, **changed)
