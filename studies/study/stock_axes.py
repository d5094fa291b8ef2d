"""Parameters of bought parts: a range becomes the sizes in it that can be bought, with what follows from each.

The bore of a tube is that of a spring, which has a wire, and a sheath that goes over it. So a parameter of a tube
becomes several that go together. A range with a step of its own states what can be had, so it stays as it is.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from geometry import ArrayDesign
from geometry.design.design_file import value_of
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.part_fields import Tube
from geometry.stock import Catalogue, TubePart
from geometry.stock.tube_stock import SAME, SPRING_FIELDS, TUBE_FIELDS
from studies.study.parameter import Parameter

#: A table of the file, and the parameters that go together.
Group = tuple[str, tuple[Parameter, ...]]
#: Places from 0 to 1 at which a group of ranges is looked at to find where each size begins.
_PLACES = 1024
_OF_SHEATHS = ("outer_diameter", "sheath_wall")


def stocked(groups: Sequence[Group], base: ArrayDesign, stock: Catalogue, in_grid: bool) -> list[Group]:
    """Groups of parameters whose bought sizes are those of the catalogue; parameters of one tube become one group.

    Args:
        groups: each with the name of its table: ``vary`` for a parameter on its own, else a group of ``together``.
        base: the design that is varied.
        stock: the catalogue.
        in_grid: True for a grid, whose ranges have a number of values, or all sizes.

    Raises:
        Refusal: a range without a size that can be bought, or a listed value that cannot.
    """
    found: list[Group] = []
    tubes: dict[str, list[Parameter]] = {}
    for table, axis in groups:
        if not any(_bought(each, stock) for each in axis):
            found.append((table, axis))
        elif len(axis) > 1:
            found.append((table, _Together(base, stock, table).axis(axis, in_grid)))
        elif (place := _tube_table(axis[0].name)) is not None:
            if place not in tubes:
                found.append((f"tube {place}", ()))
            tubes.setdefault(place, []).append(axis[0])
        else:
            sizes = stock.sizes(axis[0].name)
            found.append((table, (_listed(axis[0], _wished(axis[0], sizes, table, in_grid)),)))
    ready = {f"tube {place}": _tube_axis(place, each, base, stock, in_grid) for place, each in tubes.items()}
    return [("vary", ready[table]) if table in ready else (table, axis) for table, axis in found]


def _bought(parameter: Parameter, stock: Catalogue) -> bool:
    return stock.has_sizes(parameter.name) and not parameter.step


def _tube_table(name: str) -> str | None:
    """Table of a tube that a dotted name is a bought field of."""
    table, _, field = name.rpartition(".")
    return table if field in TUBE_FIELDS else None


def _listed(parameter: Parameter, values: Iterable[float]) -> Parameter:
    return Parameter(parameter.name, values=tuple(values))


def _wished(parameter: Parameter, sizes: Iterable[Any], table: str, in_grid: bool) -> tuple[float, ...]:
    """Sizes that a parameter stands for: those of its list, or of its range, in a grid as many as that has.

    Raises:
        Refusal: a value of the list is not a size, or the range is without one.
    """
    known = np.array(sorted(float(each) for each in sizes))
    place = f"{table}.{parameter.name}"
    if parameter.values:
        found = []
        for value in parameter.values:
            near = known[np.argmin(np.abs(known - float(value)))] if len(known) else math.inf
            if abs(near - float(value)) > SAME:
                raise _not_sold(place, value, known)
            found.append(float(near))
        return tuple(found)
    inside = known[(known >= parameter.low - SAME) & (known <= parameter.high + SAME)]
    if not len(inside):
        raise _not_sold(place, [parameter.low, parameter.high], known)
    if not in_grid or not parameter.count:
        return tuple(inside.tolist())
    return tuple(dict.fromkeys(_nearest(inside, value) for value in parameter.grid().tolist()))


def _nearest(sizes: np.ndarray[Any, Any], value: float) -> float:
    return float(sizes[np.argmin(np.abs(np.log(sizes / value)))])


def _not_sold(place: str, value: Any, sizes: Any) -> Refusal:
    """The refusal of a size that cannot be bought, with those that can."""
    middle = float(np.mean(value))
    near = sorted(sizes, key=lambda each: abs(math.log(each / middle)))[:2]
    words = " and ".join(f"{each:g}" for each in sorted(near))
    nearest = f"the nearest sizes are {words} mm" if near else "the catalogue has no such part"
    return Refusal(
        "is not a size that can be bought" if not isinstance(value, list) else "has no size that can be bought",
        kind=Kind.CONFLICT,
        field=place,
        value=value,
        unit="mm",
        remedy=f'{nearest}; write stock = "off" for parts made to order',
    )


# -- tubes ----------------------------------------------------------------------------------------------
def _tube_axis(
    place: str, varied: Sequence[Parameter], base: ArrayDesign, stock: Catalogue, in_grid: bool
) -> tuple[Parameter, ...]:
    """Parameters of one tube that each have a list or a range: all its parts that can be bought, one after another."""
    tube: Tube = value_of(base, place)
    fields = {parameter.name.rpartition(".")[2]: parameter for parameter in varied}
    if tube.bore == "smooth":
        return _smooth_axis(place, fields, tube, stock, in_grid)
    tubes = stock.tubes
    wanted = {
        name: _wished(parameter, tubes.sizes(name), "vary", in_grid)
        for name, parameter in fields.items()
        if name in SPRING_FIELDS
    }
    parts: list[TubePart] = []
    if wanted:
        known: set[tuple[float, ...]] = set()
        for spring in tubes.nearest_springs(tube.inner_diameter, tube.wire_diameter, list(wanted)):
            own = dict(zip(SPRING_FIELDS, (spring.bore, spring.outer_diameter, spring.wire_diameter), strict=True))
            if not all(any(abs(own[name] - each) <= SAME for each in sizes) for name, sizes in wanted.items()):
                continue
            key = tuple(round(own[name], 6) for name in wanted)
            if key not in known:
                known.add(key)
                parts += tubes.around(spring, tube.sheath_wall)[: None if set(fields) & set(_OF_SHEATHS) else 1]
        if not parts:
            names = " and ".join(f"{place}.{name}" for name in wanted)
            raise Refusal(
                f"leave no spring that can be bought with {names}",
                kind=Kind.CONFLICT,
                field="vary",
                remedy='widen a range, or write stock = "off" for parts made to order',
            )
    else:
        parts = tubes.over(tube)
    rows = [row for part in parts for row in _rows(part, fields)]
    rows = _in_order(rows, list(fields))
    if not rows:
        (sheath,) = (parameter for name, parameter in fields.items() if name in _OF_SHEATHS)
        outsides = [part.outer_diameter for part in parts]
        sizes = outsides if sheath.name.endswith("outer_diameter") else [part.values["sheath_wall"] for part in parts]
        wish = list(sheath.values) if sheath.values else [sheath.low, sheath.high]
        raise _not_sold(f"vary.{sheath.name}", wish, sizes)
    return _columns(place, rows, list(fields), tube)


def _rows(part: TubePart, fields: Mapping[str, Parameter]) -> list[dict[str, float]]:
    """Values of a tube's fields for some parts, once for each wish of the sheath that they meet."""
    own = part.values
    wishes = {name: parameter for name, parameter in fields.items() if name in _OF_SHEATHS}
    rows = [own]
    for name, parameter in wishes.items():
        if parameter.values:
            slack = part.sheath.tolerance * (2 if name == "outer_diameter" else 1)
            met = [float(value) for value in parameter.values if abs(float(value) - own[name]) <= slack]
        else:
            met = [own[name]] if parameter.low - SAME <= own[name] <= parameter.high + SAME else []
        rows = [{**row, name: value} for row in rows for value in met]
    return rows


def _in_order(rows: Sequence[dict[str, float]], names: Sequence[str]) -> list[dict[str, float]]:
    """Rows in ascending order of what is varied, each combination once."""
    unique: dict[tuple[float, ...], dict[str, float]] = {}
    for row in rows:
        unique.setdefault(tuple(round(row[name], 6) for name in names), row)
    return [unique[key] for key in sorted(unique)]


def _columns(
    place: str, rows: Sequence[Mapping[str, float]], names: Sequence[str], tube: Tube
) -> tuple[Parameter, ...]:
    """Parameters that go together: those that are varied, then what follows from them and is not as in the base."""
    followers = [] if {"inner_diameter", "spring_outer_diameter"} & set(names) else ["inner_diameter"]
    followers += [] if "wire_diameter" in names else ["wire_diameter"]
    followers += [] if set(_OF_SHEATHS) & set(names) else ["outer_diameter"]
    moved = [name for name in followers if any(abs(row[name] - getattr(tube, name)) > 1e-9 for row in rows)]
    return tuple(Parameter(f"{place}.{name}", values=tuple(row[name] for row in rows)) for name in (*names, *moved))


def _smooth_axis(
    place: str, fields: Mapping[str, Parameter], tube: Tube, stock: Catalogue, in_grid: bool
) -> tuple[Parameter, ...]:
    """Parameters of a tube of smooth bore, which is a tubing."""
    wanted = {
        name: _wished(parameter, _tubing_sizes(stock, name), "vary", in_grid)
        for name, parameter in fields.items()
        if name in ("inner_diameter", "outer_diameter")
    }
    rows = []
    for part in stock.tubes.smooth(tube):
        row: dict[str, float] = dict(part.values)
        if all(any(abs(row[name] - each) <= SAME for each in sizes) for name, sizes in wanted.items()):
            rows.append(row)
    others = tuple(parameter for name, parameter in fields.items() if name not in wanted)
    if others or not rows:
        field = f"vary.{others[0].name}" if others else "vary"
        raise Refusal(
            "is not a size of a tubing, which is all that a smooth bore is" if others else "leave no tubing to buy",
            kind=Kind.CONFLICT,
            field=field,
            remedy='vary inner_diameter or outer_diameter, or write stock = "off"',
        )
    return _columns(place, _in_order(rows, list(fields)), list(fields), tube)


def _tubing_sizes(stock: Catalogue, name: str) -> set[float]:
    return {getattr(each, name) for each in stock.tubes.tubings}


# -- groups that a file states --------------------------------------------------------------------------
class _Together:
    """A group whose parameters go together, of which some are sizes of bought parts."""

    def __init__(self, base: ArrayDesign, stock: Catalogue, table: str) -> None:
        self.base, self.stock, self.table = base, stock, table

    def axis(self, axis: tuple[Parameter, ...], in_grid: bool) -> tuple[Parameter, ...]:
        """The group with its sizes, and what follows from them at the end.

        Raises:
            Refusal: a listed value cannot be bought.
        """
        bought = [each for each in axis if _bought(each, self.stock)]
        others = [each for each in axis if each not in bought]
        by_place = not in_grid and not all(each.values for each in axis)
        if by_place:
            places = (np.arange(_PLACES) + 0.5) / _PLACES
            given = {each.name: each.at(places).tolist() for each in bought}
        else:
            given = {each.name: [float(value) for value in each.grid().tolist()] for each in bought}
        count = len(next(iter(given.values())))
        stated = {each.name for each in bought if each.values}
        rows = [self._row({name: values[k] for name, values in given.items()}, stated) for k in range(count)]
        names = [name for name in rows[0] if name in given or any(row[name] != self._now(name) for row in rows)]
        values = [[row[name] for name in names] for row in rows]
        ends: tuple[float, ...] = ()
        if by_place:
            turns = [k + 1 for k in range(count) if k + 1 == count or values[k] != values[k + 1]]
            values, ends = [values[k - 1] for k in turns], tuple(k / count for k in turns)
        ready = {
            name: Parameter(name, values=tuple(row[k] for row in values), ends=ends) for k, name in enumerate(names)
        }
        kept = [each if each in others else ready.pop(each.name) for each in axis]
        return (*kept, *ready.values())

    def _now(self, name: str) -> Any:
        return value_of(self.base, name)

    def _row(self, values: Mapping[str, float], stated: set[str]) -> dict[str, float]:
        """Sizes nearest to some values, and what follows from them."""
        row: dict[str, float] = {}
        tubes: dict[str, dict[str, float]] = {}
        for name, value in values.items():
            place = _tube_table(name)
            if place is not None:
                tubes.setdefault(place, {})[name.rpartition(".")[2]] = value
                continue
            sizes = np.array([float(each) for each in self.stock.sizes(name)])
            row[name] = self._checked(name, value, _nearest(sizes, value), stated, sizes.tolist())
        for place, fields in tubes.items():
            row |= self._tube_row(place, fields, stated)
        return row

    def _tube_row(self, place: str, fields: Mapping[str, float], stated: set[str]) -> dict[str, float]:
        tube: Tube = value_of(self.base, place)
        values = self.stock.tubes.bought(tube, fields)
        if values is None:
            raise _not_sold(f"{self.table}.{place}.{next(iter(fields))}", next(iter(fields.values())), [])
        if any(f"{place}.{name}" in stated and abs(values[name] - value) > SAME for name, value in fields.items()):
            part = self.stock.tubes.wished_part(tube, fields)
            parts = " in ".join(each.name for each in (part and part.spring, part and part.sheath) if each)
            sole = next(iter(fields)) if len(fields) == 1 else ""
            raise Refusal(
                "is not a tube that can be bought",
                kind=Kind.CONFLICT,
                field=".".join(filter(None, (self.table, place, sole))),
                value=fields[sole] if sole else list(fields.values()),
                unit="mm",
                remedy=f'the nearest is {parts}; write stock = "off" for parts made to order',
            )
        return {f"{place}.{name}": value for name, value in values.items()}

    def _checked(self, name: str, value: float, size: float, stated: set[str], sizes: Sequence[Any]) -> float:
        """The size for a value; a listed value must be one."""
        if name in stated and abs(size - value) > SAME:
            raise _not_sold(f"{self.table}.{name}", value, [float(each) for each in sizes])
        return size


def nearest_values(axes: Iterable[tuple[Parameter, ...]], values: Mapping[str, Any]) -> dict[str, Any]:
    """Values by dotted name as the nearest ones of lists, with what follows from them.

    Args:
        axes: groups of parameters that go together; a list of bought sizes has its followers at the end.
        values: free values of parameters that are numbers above 0; those whose parameter has no list stay.
    """
    found: dict[str, Any] = {}
    for axis in axes:
        free = {each.name: values[each.name] for each in axis if each.name in values}
        if not axis[0].values:
            found |= free
            continue
        rows = np.log(np.array([each.values for each in axis if each.name in free], dtype=np.float64))
        wished = np.log(np.array([list(free.values())], dtype=np.float64)).T
        index = int(np.argmin(np.abs(rows - wished).sum(axis=0)))
        found |= {each.name: each.values[index] for each in axis}
    return found
