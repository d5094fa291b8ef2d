"""The fields of a design in words: their units and ranges, and one line for every value that breaks them."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Annotated, Any, TypeVar

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails, PydanticUndefined

from geometry.ground.refusal import Refusal, counted, in_one_line
from geometry.schema.declared_fields import DesignField, declared_field, section_of

_Stated = TypeVar("_Stated", bound=BaseModel)

#: What a file may give in place of a field of a tube, and how the field follows from it.
DERIVED_FROM = {
    "inner_diameter": ("spring_outer_diameter", "spring_outer_diameter - 2 x wire_diameter"),
    "outer_diameter": ("sheath_wall", "inner_diameter + 2 x wire_diameter + 2 x sheath_wall"),
}


class DesignError(Refusal):
    """A design that is not valid. The message is one line: file, field, value and what is allowed.

    ``problems`` has every problem found, one line each; the message is the first of them and how many more there are.
    """

    def __init__(self, *problems: str, also: str = "") -> None:
        """Keep the problems, at least one, and what else there is to say, such as what would mend them."""
        self.problems = problems
        more = len(problems) - 1
        super().__init__(
            problems[0] + (f" (and {counted(more, 'more problem')})" if more else "") + (f"; {also}" if also else "")
        )


class UnknownField(DesignError):
    """A name that is no field of the design at hand, or one of a table that it does not give."""


#: Numbers as a file states them: no text that looks like one, no true or false.
Number = Annotated[float, Field(strict=True)]
Count = Annotated[int, Field(strict=True)]
Flag = Annotated[bool, Field(strict=True)]
Millimetre = Annotated[Number, Field(gt=0, json_schema_extra={"unit": "mm"})]


class Section(BaseModel):
    """Base of every section of a design: immutable; unknown keys and non-finite numbers are refused."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    def __init__(self, /, **data: Any) -> None:
        """Check the values.

        Raises:
            DesignError: a value is not allowed.
        """
        try:
            super().__init__(**data)
        except ValidationError as error:
            raise error_from_validation(error, type(self), data) from None

    # Sections inside a file are then built by pydantic itself, which keeps the full name of a bad field.
    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]


def names_of(model: type[BaseModel]) -> list[str]:
    """Keys a table of a design file may have, with those that stand in for others."""
    names = list(model.model_fields)
    if set(DERIVED_FROM) <= set(names):
        names += [given for given, _ in DERIVED_FROM.values()]
    return names


def nearest(word: str, known: Sequence[str]) -> str:
    """``; did you mean ...?`` where a known word is near, else the known words, those most like it first."""
    close = difflib.get_close_matches(word.lower(), [name.lower() for name in known], n=1, cutoff=0.6)
    for name in known:
        if close and name.lower() == close[0]:
            return f"; did you mean {name!r}?"
    likeness = {name: difflib.SequenceMatcher(None, word.lower(), name.lower()).ratio() for name in known}
    return f"; known: {', '.join(sorted(known, key=lambda name: -likeness[name]))}" if known else ""


def error_from_validation(
    error: ValidationError, model: type[BaseModel], given: object, source: str = "", what: str = "design"
) -> DesignError:
    """The error of this package for one of pydantic's.

    Args:
        error: what the validation of ``given`` as ``model`` raised.
        model: the model.
        given: the data as they were given, to quote from.
        source: file the data come from, put before each line.
        what: what the file describes.
    """
    # What follows from another field cannot follow where that is wrong, which is said.
    found = [each for each in error.errors(include_url=False) if each["type"] != "default_factory_not_called"]
    details = sorted(found, key=lambda e: (e["type"] == "missing", e["type"] == "value_error"))
    misspelt = [e["loc"] for e in details if e["type"] == "extra_forbidden"]
    lines = []
    for detail in details:
        loc = detail["loc"]
        if detail["type"] == "missing" and any(
            other[:-1] == loc[:-1] and difflib.get_close_matches(str(other[-1]), [str(loc[-1])], cutoff=0.6)
            for other in misspelt
        ):
            continue  # the misspelt key is this one
        if detail["type"] == "too_short" and any(
            len(e["loc"]) > len(loc) and e["loc"][: len(loc)] == loc for e in details
        ):
            continue  # pydantic counts the good entries only; the bad one has its own line
        lines.append((f"{source}: " if source else "") + in_one_line(_sentence(detail, model, given, what)))
    return DesignError(*lines)


def model_of(
    model: type[_Stated],
    given: object,
    source: str,
    what: str = "design",
    refusal: Callable[[str], Exception] = DesignError,
) -> _Stated:
    """What plain values state, as a model.

    Args:
        model: the model.
        given: tables as dictionaries, as TOML gives them.
        source: file the values come from, put before the message.
        what: what the file describes.
        refusal: makes the error of a message.

    Raises:
        Exception: by ``refusal``, in one line: a field is missing, unknown, or has a value that is not allowed.
    """
    try:
        return model.model_validate(given)
    except ValidationError as error:
        raise refusal(str(error_from_validation(error, model, given, source, what))) from None


def check_value(model: type[BaseModel], name: str, value: object, source: str) -> None:
    """Check a value against the kind and range of its field alone, whatever the other fields are.

    Args:
        model: the model.
        name: dotted name of a field; one that stands in for another is not checked.
        value: the value.
        source: file the value comes from.

    Raises:
        DesignError: the value is not allowed.
    """
    loc = tuple(int(step) if step.isdecimal() else step for step in name.split("."))
    info, _ = _find(model, loc)
    if info is None:
        return
    try:
        _adapter(model, loc).validate_python(value)
    except ValidationError as error:
        detail: Any = {**error.errors(include_url=False)[0], "loc": loc}
        raise DesignError(f"{source}: {in_one_line(_sentence(detail, model, {}, 'design'))}") from None


@lru_cache(maxsize=256)
def _adapter(model: type[BaseModel], loc: tuple[int | str, ...]) -> TypeAdapter[Any]:
    info, _ = _find(model, loc)
    if info is None:
        raise KeyError(loc)
    limited: Any = Annotated[info.annotation, info]
    return TypeAdapter(limited, config=ConfigDict(allow_inf_nan=False))


def _sentence(detail: ErrorDetails, model: type[BaseModel], given: object, what: str) -> str:
    loc, kind = detail["loc"], detail["type"]
    name = ".".join(str(step) for step in loc)
    value = detail["input"]
    if kind == "value_error":
        return (f"{name}." if name else "") + str(detail["ctx"]["error"])
    if kind == "extra_forbidden":
        section = _find(model, loc[:-1])[1]
        known = names_of(section) if section is not None else []
        return f"{name} = {_quote(value)} is not a field of a {what}{nearest(str(loc[-1]), known)}"
    info, section = _find(model, loc)
    field = declared_field(name, info) if info is not None else None
    must = _must(field, section, detail)
    if kind == "missing":
        if isinstance(loc[-1], int):
            return f"{'.'.join(map(str, loc[:-1]))} = {_quote(value)} must have an entry number {loc[-1]}"
        about = f" ({field.description})" if field is not None and field.description else ""
        return f"{name} is missing: {must}{about}"
    unit = f" {field.unit}" if field is not None and field.unit and _is_number(value) else ""
    note = ""
    if loc and loc[-1] in DERIVED_FROM:
        source_key, formula = DERIVED_FROM[str(loc[-1])]
        table = _lookup(given, loc[:-1])
        if isinstance(table, Mapping) and source_key in table:
            note = f" (it is {formula})"
    return f"{name or what} = {_quote(value)}{unit} {must}{note}"


def _must(field: DesignField | None, section: type[BaseModel] | None, detail: ErrorDetails) -> str:
    """``must be ...`` for one field."""
    kind = detail["type"]
    if field is None:
        if section is not None:
            return f"must be a table of {', '.join(names_of(section))}"
        return f"is refused: {detail['msg'][0].lower()}{detail['msg'][1:]}"
    if kind == "finite_number":
        return "must be a finite number" + (f" {field.allowed}" if field.allowed else "")
    if section is not None and field.kind == "a table":
        return f"must be a table of {', '.join(names_of(section))}"
    if kind == "literal_error":
        return f"must be one of {field.allowed}{_meant(detail['input'], field.allowed)}"
    if not field.allowed:
        return f"must be {field.kind}"
    if field.kind == "a number" and kind not in ("float_type", "missing"):
        return f"must be {field.allowed}"
    return f"must be {field.kind}{', one of' if field.allowed.startswith(chr(39)) else ''} {field.allowed}"


def _meant(value: object, allowed: str) -> str:
    close = difflib.get_close_matches(str(value), [word.strip("'") for word in allowed.split(", ")], n=1)
    return f"; did you mean {close[0]!r}?" if close else ""


def _find(model: type[BaseModel], loc: Sequence[int | str]) -> tuple[FieldInfo | None, type[BaseModel] | None]:
    """Field at a place of the file, and the section it holds."""
    section: type[BaseModel] | None = model
    info: FieldInfo | None = None
    stepped_in = True
    for step in loc:
        if stepped_in and section is not None and isinstance(step, str) and step in section.model_fields:
            info = section.model_fields[step]
            section, way = section_of(info.annotation)
            stepped_in = way == ""
        elif not stepped_in:  # an index of a list or a name of a table
            info, stepped_in = None, True
        else:
            return None, None
    return info, section


def _lookup(data: Any, loc: Sequence[int | str]) -> object:
    for step in loc:
        try:
            data = data[step]
        except (KeyError, IndexError, TypeError):
            return None
    return data


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _quote(value: object) -> str:
    """A value as a file would show it, cut where it is long."""
    if value is None or value is PydanticUndefined:
        return "nothing"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return f"{value:.12g}"
    if isinstance(value, BaseModel):
        value = value.model_dump()
    text = repr(value)
    return text if len(text) <= 80 else text[:77] + "..."
