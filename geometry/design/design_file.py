"""Design files: TOML in and out, the prototypes that come with the package, and changed copies.

A design that is read, written and read again is equal to the first: floats are written with every digit
they need. Every refusal is a :class:`DesignError` of one line.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from importlib import resources
from pathlib import Path
from typing import Any, TypeAlias

import tomlkit
from pydantic import BaseModel
from tomlkit.items import AbstractTable, Item

import geometry
from geometry.design.array_design import ArrayDesign, validated
from geometry.design.changes import as_lists, keys_of
from geometry.design.places_file import names_places, with_places
from geometry.ground.argument_checks import check_type
from geometry.ground.refusal import Kind
from geometry.ground.text_files import parse_toml, read_text
from geometry.ground.whole_files import check_own_kind, write_text
from geometry.schema.array_fields import StatedArray
from geometry.schema.declared_fields import fields_of
from geometry.schema.field_errors import DesignError, UnknownField, nearest
from geometry.schema.materials import MATERIALS

#: Tables and fields of a study file that no design has.
_OF_A_STUDY = ("vary", "metrics", "optimize")
DesignLike: TypeAlias = ArrayDesign | str | os.PathLike[str]
"""A design, the path of its file, or the name of a prototype."""


def load_design(path: str | os.PathLike[str]) -> ArrayDesign:
    """Read a design file.

    Raises:
        DesignError: no such file, not a text in UTF-8, not TOML, or not a valid design.
    """
    text = read_text(path, "a design file", DesignError)
    return read_design(text, str(Path(path)), Path(path).parent)


def read_design(text: str, source: str = "design.toml", folder: Path | None = None) -> ArrayDesign:
    """Read a design from the text of a file.

    Args:
        text: TOML.
        source: name of the file, for messages.
        folder: where the file lies, and beside it that of its places if it names one.

    Raises:
        DesignError: not TOML, a study file, or not a valid design.
    """
    data = parse_toml(text, source, DesignError)
    if "base" in data and not data.keys().isdisjoint(_OF_A_STUDY):
        base = f"its base, {data['base']}," if isinstance(data["base"], str) else "its base"
        remedy = f"give {base} or pass the study to sweep or optimize"
        raise DesignError("is a study file, not a design", kind=Kind.WRONG_TYPE, file=source, remedy=remedy)
    if names_places(data):
        data = with_places(data, source, folder)
    return validated(data, source)


def read_completed(text: str, source: str) -> ArrayDesign:
    """The design that a result holds; materials that are the built-in ones are left to their table again.

    Args:
        text: TOML, of :func:`write_design` of a completed design.
        source: name of the file and of its part, for messages.

    Raises:
        DesignError: not TOML, not a valid design, or of a version whose tubes had smooth bores.
    """
    data = parse_toml(text, source, DesignError)
    design = validated(data, source)
    if "bore" not in data["tube"]:
        remedy = "compute the result again"
        raise DesignError(
            "is missing: an older version wrote it", kind=Kind.MISSING, file=source, field="tube.bore", remedy=remedy
        )
    own = {key: value for key, value in design.materials.items() if MATERIALS.get(key) != value}
    return design.model_copy(update={"materials": own})


def write_design(design: ArrayDesign) -> str:
    """Text of a design file: every field with its value, its unit in a comment; what follows others is not stated."""
    return tomlkit.dumps(design_document(design))


def design_document(design: ArrayDesign) -> tomlkit.TOMLDocument:
    """Document of :func:`write_design`, for tables that are written otherwise."""
    document = tomlkit.document()
    document.add(tomlkit.comment("Lengths in mm; fields and their ranges: acoustic-fem check --fields"))
    notes = {field.name: field.unit for field in fields_of(ArrayDesign)}
    for key, item in _items(design, "", notes):
        if key not in design.followers:
            document.add(key, item)
    return document


def save_design(design: ArrayDesign, path: str | os.PathLike[str]) -> None:
    """Write a design file. It is written under another name and then renamed, so the file is never incomplete.

    Raises:
        DesignError: the file cannot be written, or exists and is not TOML.
    """
    check_own_kind(path, ".toml", DesignError)
    try:
        write_text(path, write_design(design))
    except OSError as error:
        raise DesignError(f"cannot be written: {error.strerror}", kind=Kind.UNREADABLE, file=path) from None


def value_of(design: ArrayDesign, name: str) -> Any:
    """Value of a dotted name: a field, a property of a section, or what a file may give in place of a field.

    Args:
        design: the design.
        name: for example ``tube.inner_diameter``, ``lines.0.points``, ``resonator.cavity_volume``.

    Raises:
        DesignError: no such name.
    """
    place: Any = design
    steps = name.split(".")
    for depth, step in enumerate(steps):
        if isinstance(place, BaseModel):
            derived = [key for key in dir(type(place)) if isinstance(getattr(type(place), key), property)]
            known = [*type(place).model_fields, *(key for key in derived if not key.startswith(("_", "model_")))]
        else:
            known = keys_of(as_lists(place))
        if step not in known:
            if place is None:
                problem = f"is in a table that the design does not give, {'.'.join(steps[:depth])}"
                raise UnknownField(problem, kind=Kind.MISSING, file=design.name, field=name)
            raise UnknownField.of_name(name, design.name, nearest(step, known))
        if isinstance(place, BaseModel):
            place = getattr(place, step)
        else:
            place = place[int(step)] if isinstance(place, tuple) else place[step]
    return place


def prototype_names() -> list[str]:
    """Names of the designs that come with the package."""
    folder = resources.files(geometry) / "prototypes"
    return sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml"))


def prototype_text(name: str) -> str:
    """The design file of a prototype, with its comments.

    Raises:
        DesignError: no prototype of that name.
    """
    names = prototype_names()
    if name not in names:
        raise DesignError(kind=Kind.UNKNOWN, field="prototype", value=name, remedy=nearest(name, names))
    return (resources.files(geometry) / "prototypes" / f"{name}.toml").read_text(encoding="utf-8")


def prototype(name: str) -> ArrayDesign:
    """A design that comes with the package.

    Raises:
        DesignError: no prototype of that name.
    """
    return read_design(prototype_text(name), f"{name}.toml")


def stated_prototype(name: str) -> StatedArray:
    """The fields of a prototype without the rules between them, which hold of all prototypes: for lists of them.

    Raises:
        DesignError: no prototype of that name.
    """
    return StatedArray.model_validate(parse_toml(prototype_text(name), f"{name}.toml", DesignError))


def resolve_design(argument: DesignLike, field: str = "design") -> ArrayDesign:
    """The design that a caller gives: itself, a prototype by its name, or a file by its path.

    Args:
        argument: the design, its name or its path.
        field: name of the argument.

    Raises:
        DesignError: none of these types; neither a prototype nor a file that can be read, or not a valid design.
    """
    if isinstance(argument, ArrayDesign):
        return argument
    allowed = "a design, the path of its file, or the name of a prototype"
    check_type(field, argument, (str, os.PathLike), allowed, DesignError)
    text = os.fspath(argument)
    names = prototype_names()
    if text in names:
        return prototype(text)
    if text.endswith(".toml") or os.path.exists(text):
        return load_design(text)
    problem = "neither a design file nor a prototype"
    raise DesignError(problem, kind=Kind.UNKNOWN, file=text, remedy=nearest(text, names))


# -- writing ----------------------------------------------------------------------------------------
def _items(section: BaseModel, prefix: str, notes: Mapping[str, str]) -> Iterator[tuple[str, Item]]:
    """Keys and TOML items of a section: plain values first, as TOML wants them before tables."""
    plain: list[tuple[str, Item]] = []
    tables: list[tuple[str, Item]] = []
    for key in type(section).model_fields:
        value = getattr(section, key)
        name = prefix + key
        if value is None or value == {}:
            continue
        if isinstance(value, BaseModel):
            table = _table(value, f"{name}.", notes)
            if table:
                tables.append((key, table))
        elif isinstance(value, dict):
            group = tomlkit.table(is_super_table=True)
            for own, entry in value.items():
                group.add(own, _table(entry, f"{name}.*.", notes))
            tables.append((key, group))
        elif isinstance(value, tuple) and value and isinstance(value[0], BaseModel):
            array = tomlkit.aot()
            for entry in value:
                array.append(_table(entry, f"{name}.*.", notes))
            tables.append((key, array))
        else:
            item = tomlkit.item(list(value) if isinstance(value, tuple) else value)
            if notes.get(name):
                item.comment(notes[name])
            plain.append((key, item))
    yield from plain
    yield from tables


def _table(section: BaseModel, prefix: str, notes: Mapping[str, str]) -> AbstractTable:
    table = tomlkit.table()
    for key, item in _items(section, prefix, notes):
        table.add(key, item)
    return table
