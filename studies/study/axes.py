"""Parameters of a study from its fields, on their own or in groups, and its number of cases."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, Literal

from pydantic import BaseModel

from geometry import ArrayDesign, DesignError
from geometry.design.changes import as_lists, check_name
from geometry.design.design_file import value_of
from geometry.design.frozen_rules import check_variable
from geometry.ground.refusal import Kind, Refusal
from geometry.schema.declared_fields import field_named
from geometry.schema.field_errors import check_value, model_of
from geometry.stock import Catalogue, catalogue
from studies.study.fields import LARGEST, RangeFields, StudyFields
from studies.study.parameter import Parameter, StudyError
from studies.study.stock_axes import stocked


def axes_of(file: StudyFields, base: ArrayDesign) -> tuple[tuple[Parameter, ...], ...]:
    """Parameters that vary on their own: one parameter, or several that go together.

    Unless the study says ``stock = "off"``, sizes of bought parts are those of the catalogue.

    Raises:
        Refusal: nothing varies, a name that the design does not have, or values that are not allowed.
    """
    stock = catalogue() if file.stock == "on" else None
    groups = [("vary", {name: value}) for name, value in _flat(file.vary).items()]
    groups += [(f"together.{number}", _flat(each)) for number, each in enumerate(file.together)]
    if not any(group for _, group in groups):
        allowed = 'a table of at least one field that varies, such as "tube.length" = [10, 20]'
        raise Refusal(kind=Kind.MISSING, field="vary", allowed=allowed)
    axes: list[tuple[Parameter, ...]] = []
    for table, group in groups:
        axis = tuple(
            _parameter(name, given, f"{table}.{name}", file.sampling == "grid", base, table == "vary" and stock)
            for name, given in group.items()
        )
        sizes = {parameter.name: parameter.size for parameter in axis}
        if len(set(sizes.values())) > 1:
            counts = ", ".join(f"{name} has {size}" for name, size in sizes.items())
            raise Refusal(f"must have equally many values of each field; {counts}", kind=Kind.CONFLICT, field=table)
        for name in group:
            if any(name == parameter.name for other in axes for parameter in other):
                remedy = "give it under [vary] or in one group of [[together]]"
                raise Refusal("is given twice", kind=Kind.CONFLICT, field=f"{table}.{name}", remedy=remedy)
        axes.append(axis)
    tables = [table for table, _ in groups]
    if stock is not None:
        ready = stocked(list(zip(tables, axes, strict=True)), base, stock, file.sampling == "grid")
        tables, axes = [table for table, _ in ready], [axis for _, axis in ready]
    _check_size(file, axes)
    for table, axis in zip(tables, axes, strict=True):
        if file.sampling == "grid" or all(parameter.values and not parameter.ends for parameter in axis):
            _check_distinct(table, axis)
    return tuple(axis for axis in axes if axis)


def _check_size(file: StudyFields, axes: Sequence[tuple[Parameter, ...]]) -> None:
    """Reject a grid of too many cases."""
    count = math.prod(len(axis[0].grid()) for axis in axes if axis) if file.sampling == "grid" else 0
    if count > LARGEST:
        problem = f"has {count} cases; it must have at most {LARGEST}"
        raise Refusal(problem, kind=Kind.OUT_OF_RANGE, field="sampling", value=file.sampling)


def _check_distinct(table: str, axis: tuple[Parameter, ...]) -> None:
    """Reject values, or rows of a group, that are there twice: they would give equal cases."""
    seen: set[tuple[Any, ...]] = set()
    for row in zip(*(parameter.grid().tolist() for parameter in axis), strict=True):
        if row in seen:
            alone = axis[0] if len(axis) == 1 else None
            raise Refusal(
                "appears twice, which gives equal cases",
                kind=Kind.CONFLICT,
                field=table if alone is None else f"{table}.{alone.name}",
                value=list(row) if alone is None else row[0],
                remedy="leave out one" if alone is None or alone.values else "give a smaller count",
            )
        seen.add(row)


def _flat(table: Mapping[str, Any], prefix: str = "") -> dict[str, Any]:
    """Dotted names, whether they are in quotes or not: without quotes TOML makes tables of them."""
    flat: dict[str, Any] = {}
    for key, value in table.items():
        if isinstance(value, dict) and not {"from", "to"} & set(value) and value:
            flat |= _flat(value, f"{prefix}{key}.")
        else:
            flat[prefix + key] = value
    return flat


def _parameter(
    name: str, given: Any, place: str, in_grid: bool, base: ArrayDesign, stock: Catalogue | Literal[False] | None
) -> Parameter:
    """The parameter of a field of the design, by what the study file gives for it at a dotted place.

    A range in a grid needs a number of values, unless all sizes of a catalogue that lie in it are meant.
    """
    try:
        check_name(as_lists(base.model_dump()), name, base.name)
        now = value_of(base, name)
    except DesignError as error:
        problem = error.problem if error.field == name else f"names {error.field}, which {error.problem}"
        raise Refusal.of(error, file=None, field=place, problem=problem) from None
    try:
        check_variable(base, name)
    except Refusal as error:
        raise Refusal.of(error, field=place) from None
    field = field_named(ArrayDesign, name)
    kind = "a number" if field is None else field.kind
    if kind in ("a table", "a list") or isinstance(now, (BaseModel, tuple, dict)):
        remedy = f"give the fields in it, such as {name}.length"
        raise Refusal(f"is {kind}", kind=Kind.WRONG_TYPE, field=place, remedy=remedy)
    if isinstance(given, list) and given:
        for value in given:
            _check_value(name, value, place)
        return Parameter(name, values=tuple(given), whole=kind == "a whole number")
    if not isinstance(given, dict) or not {"from", "to"} <= set(given):
        allowed = "a list of values, or a range {from = ..., to = ..., count = ...}"
        raise Refusal(kind=Kind.WRONG_TYPE, field=place, value=given, allowed=allowed)
    limits = model_of(RangeFields, given, "", "study", StudyError, table=place)
    whole = kind == "a whole number"
    if kind == "a text":
        raise Refusal("is a text", kind=Kind.WRONG_TYPE, field=place, remedy="give a list of values, not a range")

    def refusal(end: str, value: object, allowed: str, kind: Kind = Kind.CONFLICT) -> Refusal:
        return Refusal(kind=kind, field=f"{place}.{end}", value=value, allowed=allowed)

    for end, value in (("from", limits.first), ("to", limits.last)):
        if whole and value != round(value):
            raise refusal(end, value, "a whole number", Kind.WRONG_TYPE)
        _check_value(name, round(value) if whole else value, f"{place}.{end}")
    if limits.first >= limits.last:
        raise refusal("from", limits.first, f"below to = {limits.last:g}")
    if limits.scale == "log" and limits.first <= 0:
        raise refusal("from", limits.first, "above 0 for scale = 'log'")
    if whole and limits.scale == "log":
        raise refusal("scale", limits.scale, "'linear' for whole numbers")
    step = limits.step or 0.0
    if step and whole:
        raise refusal("step", step, "left out for whole numbers")
    if step > limits.last - limits.first:
        raise refusal("step", step, f"at most {limits.last - limits.first:g}, its range")
    steps = (limits.last - limits.first) / (1.0 if whole else step or math.inf)
    count = limits.count or (math.floor(steps + 1e-9) + 1 if whole or step else 0)
    if in_grid and not count and not (stock and stock.has_sizes(name)):
        raise refusal("count", Refusal.NOT_GIVEN, "the number of values in a grid", Kind.MISSING)
    if whole:
        count = min(count, round(limits.last - limits.first) + 1)
    return Parameter(name, (), limits.first, limits.last, count if in_grid else 0, limits.scale, whole, step)


def _check_value(name: str, value: Any, place: str) -> None:
    """Refuse a value that its field never allows. Rules between fields are left: other parameters may satisfy them."""
    try:
        check_value(ArrayDesign, name, value, "")
    except DesignError as error:
        raise Refusal.of(error, file=None, field=place) from None


def case_count(file: StudyFields) -> int:
    """Number of samples; 0 for a grid.

    Raises:
        Refusal: a number that does not suit the sampling.
    """
    if file.sampling == "grid":
        if file.cases is not None:
            allowed = "left out for sampling = 'grid', which has every combination"
            raise Refusal(kind=Kind.CONFLICT, field="cases", value=file.cases, allowed=allowed)
        return 0
    if file.cases is None:
        allowed = f"the number of samples for sampling = {file.sampling!r}"
        raise Refusal(kind=Kind.MISSING, field="cases", allowed=allowed)
    return file.cases
