"""Files of frozen places: what a design file names under ``layout.places`` instead of stating every part."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from geometry.design.frozen_rules import sizes_of
from geometry.ground.refusal import Kind
from geometry.ground.text_files import parse_json, read_text
from geometry.ground.whole_files import check_own_kind, write_text
from geometry.schema.array_fields import StatedArray
from geometry.schema.field_errors import DesignError, model_of
from geometry.schema.frozen_fields import FrozenPlaces

_WHAT = "a file of places"


def names_places(data: Mapping[str, Any]) -> bool:
    """True where the plain values of a design file name a file of places."""
    layout = data.get("layout")
    return isinstance(layout, Mapping) and isinstance(layout.get("places"), str)


def with_places(data: Mapping[str, Any], source: str, folder: Path | None) -> dict[str, Any]:
    """Plain values of a design whose named places are read in.

    The file also gives the points and the lengths of lines that do not state them.

    Args:
        data: tables of a design file that :func:`names_places` holds of.
        source: name of the design file, for messages.
        folder: where the design file lies; None for a text that is in no folder.

    Raises:
        DesignError: the file cannot be read, is not one of places, or does not go with what the design states.
    """
    layout = dict(data["layout"])
    named = layout.pop("places")
    if folder is None:
        raise DesignError(
            "names a file that is not part of this text",
            kind=Kind.UNSUITABLE,
            file=source,
            field="layout.places",
            value=named,
            remedy="save the design beside the file, and give its path",
        )
    found = read_places(folder / named)
    _check_body(data.get("surface"), found.get("body", ""), source, folder)
    lines = data.get("lines")
    if isinstance(lines, list):
        lines = _lines(lines, found.pop("lines"), source)
    layout["frozen"] = found
    return {**data, "layout": layout, "lines": lines}


def _check_body(stated: Any, digest: str, source: str, folder: Path) -> None:
    """Refuse places that were fitted to another file of the body; where that is not at hand, its places stand alone."""
    named = stated.get("body") if isinstance(stated, Mapping) else None
    if not digest or not isinstance(named, str) or not (folder / named).is_file():
        return
    if hashlib.sha256((folder / named).read_bytes()).hexdigest() != digest:
        problem = "has changed since the places were fitted"
        raise DesignError(
            problem, kind=Kind.CONFLICT, file=source, field="surface.body", value=named, remedy="fit again"
        )


def _lines(stated: Sequence[Any], frozen: Sequence[Mapping[str, Any]], source: str) -> list[Any]:
    """Stated lines with the points and lengths of a file of places."""
    if len(stated) != len(frozen) or not all(isinstance(line, Mapping) for line in stated):
        problem = f"has {len(stated)}; layout.places has {len(frozen)}"
        raise DesignError(problem, kind=Kind.CONFLICT, file=source, field="lines", remedy="fit again")
    lines = []
    for number, (line, own) in enumerate(zip(stated, frozen, strict=True)):
        if line.get("points", own["points"]) != own["points"]:
            problem = f"is {line['points']}; layout.places has {own['points']}"
            raise DesignError(
                problem, kind=Kind.CONFLICT, file=source, field=f"lines.{number}.points", remedy="fit again"
            )
        lines.append({**own, **line})
    return lines


def read_places(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Plain values of a file of places: those of :class:`FrozenPlaces`, and ``lines`` with ``points`` and ``lengths``.

    Raises:
        DesignError: the file cannot be read or is not one of places.
    """
    found = parse_json(read_text(path, _WHAT, DesignError), str(path), DesignError)
    if not isinstance(found, dict) or not isinstance(found.get("lines"), list):
        problem = "must be a table with lines, points and microphones"
        raise DesignError(problem, kind=Kind.WRONG_TYPE, file=path)
    lines = found["lines"]
    for number, line in enumerate(lines):
        if not isinstance(line, dict) or set(line) != {"points", "lengths"}:
            problem = "must have points and lengths"
            raise DesignError(problem, kind=Kind.WRONG_TYPE, file=path, field=f"lines.{number}")
    model_of(FrozenPlaces, {key: value for key, value in found.items() if key != "lines"}, str(path), _WHAT[2:])
    return found


def save_places(design: StatedArray, path: str | os.PathLike[str]) -> None:
    """Write the frozen places of a design and the lengths of its lines; for the ``places`` of another design.

    Raises:
        DesignError: the design has no frozen places, the file cannot be written, or exists and is not JSON.
    """
    frozen = design.layout.frozen
    if frozen is None:
        problem = f"is {design.layout.kind!r}: only a layout of kind 'surface' has frozen places"
        raise DesignError(problem, kind=Kind.UNSUITABLE, file=design.name, field="layout.kind")
    check_own_kind(path, ".json", DesignError)
    lines = [{"points": line.points, "lengths": [t.length for t in design.tubes_of(line)]} for line in design.lines]
    sizes = {field: value for field, (_, value) in sizes_of(design).items()}
    data = {"lines": lines, **frozen.model_dump(mode="json", exclude_defaults=True), "sizes": sizes}
    try:
        write_text(path, _text(data))
    except OSError as error:
        raise DesignError(f"cannot be written: {error.strerror}", kind=Kind.UNREADABLE, file=path) from None


def _text(data: Mapping[str, Any]) -> str:
    """JSON with one part a line."""
    entries = []
    for key, value in data.items():
        if isinstance(value, list):
            rows = ",\n".join(f"    {json.dumps(each)}" for each in value)
            entries.append(f"  {json.dumps(key)}: [\n{rows}\n  ]")
        else:
            entries.append(f"  {json.dumps(key)}: {json.dumps(value)}")
    return "{\n" + ",\n".join(entries) + "\n}\n"
