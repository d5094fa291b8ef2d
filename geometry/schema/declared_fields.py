"""Fields as their models declare them: kind, unit, range, choices and words."""

from __future__ import annotations

import math
import types
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo


@dataclass(frozen=True)
class DesignField:
    """One field of a design file."""

    name: str
    """Dotted name; ``*`` stands for an index or a name of the user's own."""
    kind: str
    """Kind of value: ``a number``, ``a whole number``, ``a text``, ``true or false``, ``a list`` or ``a table``."""
    unit: str
    """Unit of the value; empty if it is dimensionless."""
    allowed: str
    """Range or choice in words, with the unit; empty where anything of its kind goes."""
    required: bool
    """True where every file must state it."""
    default: Any
    """Value where a file states none."""
    description: str
    """Meaning of the field, in words."""
    range: tuple[float, float] = (-math.inf, math.inf)
    """Lowest and highest value of a number, in the unit; itself allowed but for the side that is ``open``."""
    open: tuple[bool, bool] = (False, False)
    """True where a number must be above the lowest, below the highest value."""
    choices: tuple[str, ...] = ()
    """All values that are allowed, where they are words to choose from."""
    optional: bool = False
    """True where the field may be left without a value."""


def fields_of(model: type[BaseModel], prefix: str = "") -> Iterator[DesignField]:
    """Every field of a model and of its sections, in the order of the file."""
    for name, info in model.model_fields.items():
        field = declared_field(prefix + name, info)
        yield field
        section, step = section_of(info.annotation)
        if section is not None:
            yield from fields_of(section, f"{prefix}{name}.{step}")


def field_named(model: type[BaseModel], name: str) -> DesignField | None:
    """The field of a dotted name, which has indices and names of the user's own where fields have ``*``."""
    steps = name.split(".")
    for field in fields_of(model):
        parts = field.name.split(".")
        if len(parts) == len(steps) and all(a in ("*", b) for a, b in zip(parts, steps, strict=True)):
            return field
    return None


def declared_field(name: str, info: FieldInfo) -> DesignField:
    """Declaration of one field of a model, under a name."""
    plain, metadata, unit = _unwrapped(info)
    kinds = {float: "a number", int: "a whole number", str: "a text", bool: "true or false"}
    kind = kinds.get(plain, "a table")
    if get_origin(plain) is tuple:
        kind = "a list"
    if get_origin(plain) is Literal:
        kind = "a text"
    required = info.is_required()
    is_number = kind in ("a number", "a whole number")
    low, high, openings = _limits(metadata) if is_number else (-math.inf, math.inf, (False, False))
    return DesignField(
        name=name,
        kind=kind,
        unit=unit,
        allowed=_allowed(plain, metadata, unit, kind),
        required=required,
        default=None if required else info.get_default(call_default_factory=True, validated_data={}),
        description=info.description or "",
        range=(low, high),
        open=openings,
        choices=tuple(get_args(plain)) if get_origin(plain) is Literal else (),
        optional=info.annotation is not None and type(None) in get_args(info.annotation),
    )


def _unwrapped(info: FieldInfo) -> tuple[Any, list[Any], str]:
    """Plain type, limits and unit of a field, also where they stand inside ``Annotated[...] | None``."""
    plain: Any = info.annotation
    metadata = list(info.metadata)
    extra = info.json_schema_extra
    if get_origin(plain) in (Union, types.UnionType):
        (plain,) = (part for part in get_args(plain) if part is not type(None))
    if get_origin(plain) is Annotated:
        plain, *inner = get_args(plain)
        for item in inner:
            if isinstance(item, FieldInfo):
                metadata += item.metadata
                extra = extra or item.json_schema_extra
    return plain, metadata, str(extra.get("unit", "")) if isinstance(extra, Mapping) else ""


def _allowed(plain: Any, metadata: Sequence[Any], unit: str, kind: str) -> str:
    if get_origin(plain) is Literal:
        return ", ".join(repr(choice) for choice in get_args(plain))
    if get_origin(plain) is tuple and Ellipsis not in get_args(plain):
        return f"of {len(get_args(plain))}"
    low, high, (low_open, high_open) = _limits(metadata)
    named = any(getattr(limit, "pattern", None) for limit in metadata)
    pattern = ", starting with a letter or digit, then letters, digits and . _ - only" if named else ""
    if kind in ("a list", "a text", "a table"):
        if not (math.isfinite(low) or math.isfinite(high)):
            return pattern.lstrip(", ")
        words = f"{low:g} to {high:g}" if math.isfinite(high) else f"at least {low:g}"
        return f"of {words} {'characters' if kind == 'a text' else 'entries'}{pattern}"
    return _range_in_words(low, low_open, high, high_open, unit)


def _limits(metadata: Sequence[Any]) -> tuple[float, float, tuple[bool, bool]]:
    """Lowest and highest value, or length, of all limits together, and which of the two is not allowed itself."""
    low, low_open, high, high_open = -math.inf, False, math.inf, False
    for limit in metadata:
        lower, upper = _bound(limit, "gt", "ge", "min_length"), _bound(limit, "lt", "le", "max_length")
        if lower is not None and (lower > low or (lower == low and hasattr(limit, "gt"))):
            low, low_open = lower, hasattr(limit, "gt")
        if upper is not None and (upper < high or (upper == high and hasattr(limit, "lt"))):
            high, high_open = upper, hasattr(limit, "lt")
    return low, high, (low_open, high_open)


def _bound(limit: object, *names: str) -> float | None:
    """The bound that one of pydantic's limits states under one of these names."""
    for name in names:
        if getattr(limit, name, None) is not None:
            return float(getattr(limit, name))
    return None


def _range_in_words(low: float, low_open: bool, high: float, high_open: bool, unit: str) -> str:
    unit = f" {unit}" if unit else ""
    if math.isfinite(low) and math.isfinite(high) and not low_open and not high_open:
        return f"between {low:.12g} and {high:.12g}{unit}"
    parts = []
    if math.isfinite(low):
        parts.append(f"{'above' if low_open else 'at least'} {low:.12g}")
    if math.isfinite(high):
        parts.append(f"{'below' if high_open else 'at most'} {high:.12g}")
    return " and ".join(parts) + unit if parts else ""


def section_of(annotation: Any) -> tuple[type[BaseModel] | None, str]:
    """Section a field holds, itself or in a list or table, and the step of the name that leads into it."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return annotation, ""
    if get_origin(annotation) is tuple or get_origin(annotation) is dict:
        for part in get_args(annotation):
            section, _ = section_of(part)
            if section is not None:
                return section, "*."
    elif get_args(annotation):
        for part in get_args(annotation):
            section, step = section_of(part)
            if section is not None:
                return section, step
    return None, ""
