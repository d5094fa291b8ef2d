"""The fields of a design in words: their units and ranges, and one line for every value that breaks them."""

from __future__ import annotations

import difflib
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Annotated, Any, Self, TypeVar

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails, PydanticUndefined

from geometry.ground.refusal import Kind, Refusal, Text, counted
from geometry.schema.declared_fields import DesignField, declared_field, section_of

_Stated = TypeVar("_Stated", bound=BaseModel)

#: Keys that a file may give in place of a field of a tube, and how the field follows from them.
DERIVED_FROM = {
    "inner_diameter": ("spring_outer_diameter", "spring_outer_diameter - 2 x wire_diameter"),
    "outer_diameter": ("sheath_wall", "inner_diameter + 2 x wire_diameter + 2 x sheath_wall"),
}


class DesignError(Refusal):
    """A design that is not valid: its facts are those of the first problem that was found."""

    def __init__(self, problem: Text = "", *, others: Sequence[Refusal] = (), **facts: Any) -> None:
        """Keep a problem and the others; for the facts of the first see :class:`geometry.Refusal`."""
        super().__init__(problem, **facts)
        self.others = tuple(others)
        """Further problems, each with its own facts."""

    @property
    def problems(self) -> tuple[Refusal, ...]:
        """Every problem that was found, this one first."""
        return (Refusal.of(self), *self.others)

    @classmethod
    def of_several(cls, problems: Sequence[Refusal], **changes: Any) -> Self:
        """One error of some problems, at least one; ``changes`` are facts of the first that become others."""
        return cls.of(problems[0], others=problems[1:], **changes)

    @classmethod
    def of_notes(cls, design: str, notes: Sequence[str], verdict: str = "cannot be built", remedy: Text = "") -> Self:
        """The error of a design that cannot be made, with the name of the design and each reason in words."""
        problems = [Refusal(note, kind=Kind.CONFLICT, file=design) for note in notes]
        return cls.of_several(problems, problem=f"{verdict}: {notes[0]}", remedy=remedy)

    def _more(self) -> str:
        return f" (and {counted(len(self.others), 'more problem')})" if self.others else ""


class UnknownField(DesignError):
    """A name that is not a field of the design at hand, or one of a table that it does not give."""

    @classmethod
    def of_name(cls, name: str, design: str, remedy: str) -> Self:
        """The error of a dotted name that a design does not have."""
        return cls("is not a field of this design", kind=Kind.UNKNOWN, file=design, field=name, remedy=remedy)


#: Numbers as a file states them: no text that looks like one, no true or false.
Number = Annotated[float, Field(strict=True)]
Count = Annotated[int, Field(strict=True)]
Flag = Annotated[bool, Field(strict=True)]
Millimetre = Annotated[Number, Field(gt=0, json_schema_extra={"unit": "mm"})]
CubicMillimetre = Annotated[Number, Field(gt=0, json_schema_extra={"unit": "mm^3"})]
Degree = Annotated[Number, Field(json_schema_extra={"unit": "degrees"})]
Hertz = Annotated[Number, Field(json_schema_extra={"unit": "Hz"})]


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

    def __setattr__(self, name: str, value: Any) -> None:
        """Reject a change of a field in place.

        Raises:
            DesignError: the name is that of a field.
        """
        if name not in type(self).model_fields:
            super().__setattr__(name, value)
            return
        section = type(self).__name__.lower()
        # A line and others stand in lists, by numbers that they do not know themselves.
        place = "" if "microphones" in type(self).model_fields else f"{'lines.0' if section == 'line' else section}."
        raise DesignError(
            "cannot be changed in place",
            kind=Kind.UNSUITABLE,
            field=f"{place}{name}",
            value=value,
            remedy=f'make a changed copy, such as design.with_values({{"{place}{name}": {value!r}}})',
        )

    def __dir__(self) -> list[str]:
        """Fields, and what this package adds to them; the machinery of pydantic is left out."""
        own = {
            name
            for each in type(self).__mro__
            if each.__module__.partition(".")[0] == "geometry"
            for name in vars(each)
            if not name.startswith(("_", "model_"))
        }
        return sorted(own | set(type(self).model_fields))

    # Sections inside a file are then built by pydantic itself, which keeps the full name of a bad field.
    __init__.__pydantic_base_init__ = True  # type: ignore[attr-defined]


def conflict(
    field: str,
    value: object = Refusal.NOT_GIVEN,
    allowed: str = "",
    unit: str = "mm",
    *,
    problem: str = "",
    remedy: str = "",
) -> Refusal:
    """The refusal of a value that other fields of the design exclude; arguments as for :class:`geometry.Refusal`."""
    facts: dict[str, Any] = {"field": field, "value": value, "allowed": allowed, "unit": unit, "remedy": remedy}
    return Refusal(problem, kind=Kind.CONFLICT, **facts)


def names_of(model: type[BaseModel]) -> list[str]:
    """Keys a table of a design file may have, with those that stand in for others."""
    names = list(model.model_fields)
    if set(DERIVED_FROM) <= set(names):
        names += [given for given, _ in DERIVED_FROM.values()]
    return names


def nearest(word: str, known: Sequence[str]) -> str:
    """``did you mean ...?`` where a known word is near, else the known words, those most like it first."""
    close = difflib.get_close_matches(word.lower(), [name.lower() for name in known], n=1, cutoff=0.6)
    for name in known:
        if close and name.lower() == close[0]:
            return f"did you mean {name!r}?"
    likeness = {name: difflib.SequenceMatcher(None, word.lower(), name.lower()).ratio() for name in known}
    return f"known: {', '.join(sorted(known, key=lambda name: -likeness[name]))}" if known else ""


def error_from_validation(
    error: ValidationError,
    model: type[BaseModel],
    given: object,
    source: str | None = None,
    what: str = "design",
    table: str = "",
) -> DesignError:
    """The error of this package for one of pydantic's.

    Args:
        error: what the validation of ``given`` as ``model`` raised.
        model: the model.
        given: the data as they were given, to quote from.
        source: file the data come from.
        what: what the file describes.
        table: dotted name of the table of the file that the data are.
    """
    # A default that follows from another field fails with that field, whose own problem is listed.
    found = [each for each in error.errors(include_url=False) if each["type"] != "default_factory_not_called"]
    details = sorted(found, key=lambda e: (e["type"] == "missing", e["type"] == "value_error"))
    misspelt = [e["loc"] for e in details if e["type"] == "extra_forbidden"]
    problems = []
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
        problem = _problem(detail, model, given, what)
        problems.append(Refusal.of(problem, file=source, field=".".join(filter(None, (table, problem.field)))))
    return DesignError.of_several(problems)


def model_of(
    model: type[_Stated],
    given: object,
    source: str,
    what: str = "design",
    refusal: type[Refusal] = DesignError,
    table: str = "",
) -> _Stated:
    """A model made from plain values.

    Args:
        model: the model.
        given: tables as dictionaries, as TOML gives them.
        source: file the values come from.
        what: what the file describes.
        refusal: class of the errors.
        table: dotted name of the table of the file that the values are.

    Raises:
        Refusal: of that class: a field is missing, unknown, or has a value that is not allowed.
    """
    try:
        return model.model_validate(given)
    except ValidationError as error:
        found = error_from_validation(error, model, given, source, what, table)
        raise (found if issubclass(DesignError, refusal) else refusal.of(found)) from None


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
        raise DesignError.of(_problem(detail, model, {}, "design"), file=source) from None


#: Limits of numbers: the name of each in an error of pydantic, and its words.
_LIMITS = {
    "greater_than": ("gt", "above"),
    "greater_than_equal": ("ge", "at least"),
    "less_than": ("lt", "below"),
    "less_than_equal": ("le", "at most"),
}


@lru_cache(maxsize=256)
def _adapter(model: type[BaseModel], loc: tuple[int | str, ...]) -> TypeAdapter[Any]:
    info, _ = _find(model, loc)
    if info is None:
        raise KeyError(loc)
    limited: Any = Annotated[info.annotation, info]
    return TypeAdapter(limited, config=ConfigDict(allow_inf_nan=False))


def _problem(detail: ErrorDetails, model: type[BaseModel], given: object, what: str) -> Refusal:
    loc, kind = detail["loc"], detail["type"]
    name = ".".join(str(step) for step in loc)
    value = _plain(detail["input"])
    if kind == "value_error":
        said = detail["ctx"]["error"]
        found = said if isinstance(said, Refusal) else Refusal(str(said), kind=Kind.UNSUITABLE)
        return Refusal.of(found, field=".".join(filter(None, (name, found.field))))
    if kind == "extra_forbidden":
        section = _find(model, loc[:-1])[1]
        return Refusal(
            f"is not a field of a {what}",
            kind=Kind.UNKNOWN,
            field=name,
            value=value,
            remedy=nearest(str(loc[-1]), names_of(section) if section is not None else []),
        )
    if kind == "missing" and isinstance(loc[-1], int):  # an entry of a list
        loc, kind = loc[:-1], "too_short"
        name = ".".join(str(step) for step in loc)
    info, section = _find(model, loc)
    field = declared_field(name, info) if info is not None else None
    if field is None and section is None:
        if kind in _LIMITS:
            key, words = _LIMITS[kind]
            limit = f"{words} {detail['ctx'][key]:.12g}"
            return Refusal(kind=Kind.OUT_OF_RANGE, field=name, value=value, allowed=limit)
        said = f"{detail['msg'][0].lower()}{detail['msg'][1:]}"
        return Refusal(f"is not allowed: {said}", kind=Kind.OUT_OF_RANGE, field=name, value=value)
    allowed, remedy = _allowed(field, section, detail)
    if kind == "missing":
        about = f" ({field.description})" if field is not None and field.description else ""
        said = allowed if isinstance(allowed, str) else f"one of: {', '.join(allowed)}"
        return Refusal(kind=Kind.MISSING, field=name, allowed=f"{said}{about}")
    if loc and loc[-1] in DERIVED_FROM:
        source_key, formula = DERIVED_FROM[str(loc[-1])]
        table = _lookup(given, loc[:-1])
        if isinstance(table, Mapping) and source_key in table:
            allowed = f"{allowed} (it is {formula})"
    return Refusal(
        kind=Kind.WRONG_TYPE if kind.endswith(("_type", "_parsing")) else Kind.OUT_OF_RANGE,
        field=name or what,
        value=value,
        unit=field.unit if field is not None else "",
        allowed=allowed,
        remedy=remedy,
    )


def _allowed(
    field: DesignField | None, section: type[BaseModel] | None, detail: ErrorDetails
) -> tuple[str | tuple[str, ...], str]:
    """Words that follow "must be", or the choices; and what may have been meant."""
    kind = detail["type"]
    if section is not None and (field is None or field.kind == "a table"):
        return f"a table of {', '.join(names_of(section))}", ""
    assert field is not None
    if kind == "finite_number":
        return " ".join(filter(None, ("a finite number", field.allowed))), ""
    if field.choices:
        close = difflib.get_close_matches(str(detail["input"]), field.choices, n=1)
        return field.choices, f"did you mean {close[0]!r}?" if close else ""
    if field.allowed and field.kind == "a number" and kind not in ("float_type", "missing"):
        return field.allowed, ""
    return " ".join(filter(None, (field.kind, field.allowed))), ""


def _find(model: type[BaseModel], loc: Sequence[int | str]) -> tuple[FieldInfo | None, type[BaseModel] | None]:
    """Field at a place of the file, and the section it holds."""
    section: type[BaseModel] | None = model
    info: FieldInfo | None = None
    stepped_in = True
    for step in loc:
        if stepped_in and section is not None and isinstance(step, str) and step in section.model_fields:
            info = section.model_fields[step]
            section, inner = section_of(info.annotation)
            stepped_in = inner == ""
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


def _plain(value: object) -> object:
    """A value as a file would show it."""
    if value is PydanticUndefined:
        return None
    return value.model_dump() if isinstance(value, BaseModel) else value
