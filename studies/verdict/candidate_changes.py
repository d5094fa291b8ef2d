"""Changes of a design that may help it: single choices of a designer, each with the fields that go along with it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import value_of
from geometry.layout.remedies import fix_values
from geometry.schema.field_errors import DesignError
from geometry.schema.part_fields import Tube
from geometry.schema.print_processes import PROCESSES
from geometry.stock import TubePart, catalogue

#: Factors by which lengths are tried; lengths are rounded to a twentieth of a millimetre.
_LENGTHS = (0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.15, 1.3, 1.5, 1.75, 2.0, 2.5, 3.0)
_STEP = 0.05
#: Factors by which numbers of points are tried.
_FEWER = (0.9, 0.75, 0.6, 0.5)
_MOST_MICROPHONES = 16
#: Difference of sizes that are the same, mm.
_SAME = 1e-3
#: Largest ratio by which a bought size is changed.
_LARGEST = 4.0
#: Spare height of a cavity and of a chamber around a tube's socket, mm.
_COVER = 0.5


@dataclass(frozen=True)
class Change:
    """A change of a design by one choice."""

    choice: str
    """Choice that is changed, such as ``bore``."""
    values: Mapping[str, Any]
    """New values by dotted name."""
    words: str
    """The change in words, such as ``a bore of 0.7 mm in place of 0.44 mm``."""
    design: ArrayDesign
    """The changed design."""
    size: float
    """Largest ratio by which a number changes, as a logarithm; 0 where only words change."""

    @property
    def key(self) -> tuple[str, str]:
        """Key of the change among those of one design."""
        return self.choice, self.words


def changes_of(design: ArrayDesign, choices: tuple[str, ...] = ()) -> tuple[Change, ...]:
    """Changes of a design that give a valid design, each once.

    Args:
        design: the design.
        choices: names of the choices, of :data:`CHOICES`; by default all.
    """
    found: dict[str, Change] = {}
    for choice in choices or tuple(CHOICES):
        for words, values in CHOICES[choice](design):
            try:
                changed = design.with_values(values)
            except DesignError:
                continue
            if changed != design:
                found.setdefault(f"{choice}: {words}", Change(choice, values, words, changed, _size(design, values)))
    return tuple(found.values())


def _size(design: ArrayDesign, values: Mapping[str, Any]) -> float:
    """Largest ratio by which a number of a design changes, as a logarithm."""
    pairs = ((new, value_of(design, name)) for name, new in values.items() if isinstance(new, int | float))
    return max((abs(math.log(new / old)) for new, old in pairs if isinstance(old, int | float) and new * old > 0),
               default=0.0)  # fmt: skip


Values = dict[str, Any]
_Words = Iterator[tuple[str, Values]]


def _scaled(value: float, factors: tuple[float, ...] = _LENGTHS, step: float = _STEP) -> Iterator[float]:
    for factor in factors:
        rounded = round(round(value * factor / step) * step, 6)
        if rounded > 0 and abs(rounded - value) > 1e-9:
            yield rounded


def _tables(design: ArrayDesign, to_microphones: bool | None = None) -> Iterator[tuple[str, Tube]]:
    """Tables of tubes that the design states, without those that follow others."""
    for name, tube, outer in design.stated_tubes():
        if name not in design.followers and to_microphones in (None, outer):
            yield name, tube


# -- tubes ------------------------------------------------------------------------------------------
def _bores(design: ArrayDesign) -> _Words:
    now, printing = design.tube.inner_diameter, design.printing
    for part in _tube_parts(design.tube):
        if abs(part.inner_diameter - now) < _SAME or not 1 / _LARGEST < part.inner_diameter / now < _LARGEST:
            continue
        inside = f", {part.spring.name}" if part.spring is not None else ""
        words = f"a bore of {part.inner_diameter:.3g} mm in place of {now:.3g} mm{inside}"
        values = {f"{name}.{key}": value for name, _ in _tables(design) for key, value in part.values.items()}
        yield words, values
        height = round(part.outer_diameter + 2 * (printing.glue_gap + _COVER), 2)
        fields = ("resonator.cavity_height", "microphone.chamber_height")
        room = {field: height for field in fields if value_of(design, field) < height}
        if room:
            yield f"{words}, in cavities and chambers of at least {height:g} mm", {**values, **room}


def _tube_parts(tube: Tube) -> Iterator[TubePart]:
    """Parts of the catalogue for a tube with a bore like its own, one for each bore."""
    stock = catalogue().tubes
    parts = (
        stock.smooth(tube)
        if tube.bore == "smooth"
        else [near[0] for spring in stock.enclosed if (near := stock.around(spring, tube.sheath_wall))]
    )
    seen: set[float] = set()
    for part in parts:
        if round(part.inner_diameter, 3) not in seen:
            seen.add(round(part.inner_diameter, 3))
            yield part


def _tube_lengths(design: ArrayDesign) -> _Words:
    length = design.tube.length
    inner = list(_tables(design, to_microphones=False))
    for new in _scaled(length):
        values: Values = {f"{name}.length": round(tube.length * new / length, 6) for name, tube in inner}
        pitch = design.layout.pitch
        if pitch is not None:
            values["layout.pitch"] = round(pitch + new - length, 6)
        yield f"tubes of {new:g} mm in place of {length:g} mm", values


def _microphone_tubes(design: ArrayDesign) -> _Words:
    length = design.microphone_tube.length
    outer = [name for name, _ in _tables(design, to_microphones=True)] or ["microphone_tube"]
    for new in _scaled(length):
        values: Values = {f"{name}.length": new for name in outer}
        if outer == ["microphone_tube"] and "microphone_tube" in design.followers:
            values = {"microphone_tube": {**design.microphone_tube.model_dump(), "length": new}}
        yield f"tubes of {new:g} mm to the microphones in place of {length:g} mm", values


# -- shells and membranes ---------------------------------------------------------------------------
def _cavity_diameters(design: ArrayDesign) -> _Words:
    now, pitch = design.resonator.cavity_diameter, design.layout.pitch
    for new in _scaled(now):
        words = f"cavities {new:g} mm wide in place of {now:g} mm"
        yield words, {"resonator.cavity_diameter": new}
        if pitch is not None:
            yield f"{words}, on the same pitch", _same_pitch(design, new)


def _same_pitch(design: ArrayDesign, diameter: float) -> Values:
    """Wider or narrower cavities with tubes that are so much shorter or longer."""
    more = diameter - design.resonator.cavity_diameter
    inner = {f"{name}.length": round(tube.length - more, 6) for name, tube in _tables(design, to_microphones=False)}
    return {"resonator.cavity_diameter": diameter, **inner}


def _denser(design: ArrayDesign) -> _Words:
    """Other cavities where the points stay: what is wider takes the length of the tubes."""
    now = design.resonator.cavity_diameter
    for new in _scaled(now):
        yield f"cavities {new:g} mm wide in place of {now:g} mm, where the points stay", _same_pitch(design, new)


def _one_length(field: str, what: str, factors: tuple[float, ...] = _LENGTHS) -> Callable[[ArrayDesign], _Words]:
    def tried(design: ArrayDesign) -> _Words:
        now = value_of(design, field)
        if isinstance(now, (int, float)):
            for new in _scaled(now, factors):
                yield f"{what} of {new:g} mm in place of {now:g} mm", {field: new}

    return tried


def _thicknesses(design: ArrayDesign) -> _Words:
    now = design.membrane.thickness
    for new in catalogue().sizes("membrane.thickness"):
        if abs(float(new) - now) > _SAME and 1 / _LARGEST < float(new) / now < _LARGEST:
            yield f"membranes {new:g} mm thick in place of {now:g} mm", {"membrane.thickness": new}


def _materials(design: ArrayDesign) -> _Words:
    now = design.membrane.material
    for name in catalogue().sizes("membrane.material"):
        if name != now:
            yield f"membranes of {name} in place of {now}", {"membrane.material": name}


def _walls(design: ArrayDesign) -> _Words:
    now = design.resonator.wall_thickness
    for new in _scaled(now):
        rim = min(design.membrane.rim_width, new)
        words = f"walls of {new:g} mm in place of {now:g} mm"
        yield words, {"resonator.wall_thickness": new, "membrane.rim_width": rim}


# -- the array --------------------------------------------------------------------------------------
def _microphones(design: ArrayDesign) -> _Words:
    """More microphones along a chain of lines over an area, where no line has tubes or a pattern of its own."""
    now = len(design.microphones)
    plain = all(line.tube is line.microphone_tube is line.pattern is None for line in design.lines)
    if not plain or design.layout.kind not in ("serpentine", "area"):
        return
    points = design.point_count
    for count in range(now + 1, min(_MOST_MICROPHONES, points) + 1):
        names = [chr(ord("A") + number) for number in range(count)]
        each, more = divmod(points, count - 1)
        lines = [
            {"between": (names[number], names[number + 1]), "points": each + (number < more)}
            for number in range(count - 1)
        ]
        straight = design.resonator.cavity_diameter + design.tube.length
        pitch = design.layout.pitch
        values: Values = {"microphones": names, "lines": lines, "layout.kind": "area"}
        if pitch is not None:
            if abs(pitch - straight) > 1e-6:
                values["tube.length"] = round(pitch - design.resonator.cavity_diameter, 6)
            values["layout.pitch"] = None
        between = f"{each} to {each + 1}" if more else f"{each}"
        yield f"{count} microphones in place of {now}, {between} points between two", values


def _columns(design: ArrayDesign) -> _Words:
    now = design.layout.columns
    if design.layout.kind in ("serpentine", "area", "cylinder"):
        for new in range(2, min(design.point_count, 40) + 1):
            if new != now:
                yield f"rows of {new} points in place of {min(now, design.point_count)}", {"layout.columns": new}


def _points(design: ArrayDesign) -> _Words:
    now = design.point_count
    for factor in _FEWER:
        lines = {f"lines.{k}.points": max(1, round(line.points * factor)) for k, line in enumerate(design.lines)}
        if sum(lines.values()) < now and all(line.pattern is None for line in design.lines):
            yield f"{sum(lines.values())} points in place of {now}", lines


def _processes(design: ArrayDesign) -> _Words:
    now = design.printing.process
    for name, process in PROCESSES.items():
        if name != now:
            yield f"{process.title} ({name}) in place of {now}", {"printing.process": name}


def _stock(design: ArrayDesign) -> _Words:
    found = catalogue().fit(design)
    if found.changes:
        parts = ", ".join(dict.fromkeys(change.part.name for change in found.changes))
        yield f"the nearest parts that can be bought: {parts}", {change.field: change.new for change in found.changes}


def _fixes(design: ArrayDesign) -> _Words:
    words, values = fix_values(design)
    if values:
        yield words, values


CHOICES: Mapping[str, Callable[[ArrayDesign], _Words]] = {
    "bore": _bores,
    "tube length": _tube_lengths,
    "microphone tube": _microphone_tubes,
    "cavity diameter": _cavity_diameters,
    "cavities in place": _denser,
    "cavity height": _one_length("resonator.cavity_height", "a cavity height"),
    "membrane thickness": _thicknesses,
    "membrane material": _materials,
    "wall": _walls,
    "floor": _one_length("resonator.floor_thickness", "a floor thickness"),
    "lip": _one_length("printing.port_lip", "a port lip"),
    "glue gap": _one_length("printing.glue_gap", "a glue gap", (1.0, 2.0, 3.0, 4.0)),
    "microphone wall": _one_length("microphone.wall_thickness", "a housing wall"),
    "chamber height": _one_length("microphone.chamber_height", "a chamber height"),
    "microphones": _microphones,
    "columns": _columns,
    "points": _points,
    "process": _processes,
    "layout fix": _fixes,
    "stock": _stock,
}
"""Choices by name, each with the function that tries values of it."""
LAST = ("points", "process")
"""Choices that change what was asked for; they are proposed only if no other change helps."""
