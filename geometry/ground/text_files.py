"""Text files that a user gives, read with one line for whatever is wrong with them."""

from __future__ import annotations

import json
import os
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from geometry.ground.file_checks import read_bytes
from geometry.ground.refusal import Kind, Refusal

LARGEST_TEXT = 1_000_000
"""Most bytes of a text; a design of a hundred lines has ten thousand."""
_DEEPEST = 32  # levels of lists and tables in a file; designs and studies have five


def read_text(path: str | os.PathLike[str], what: str, refusal: type[Refusal]) -> str:
    """The text of a file in UTF-8, with or without a byte order mark.

    Args:
        path: the file.
        what: such as ``a design file``, for messages.
        refusal: class of the errors.

    Raises:
        Refusal: of that class: no ordinary file that can be read, too large, or not in UTF-8.
    """
    try:
        return read_bytes(path, what, refusal, LARGEST_TEXT).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        problem = f"byte {error.start} is not UTF-8; {what} is a text in UTF-8"
        raise refusal(problem, kind=Kind.UNREADABLE, file=path) from None


def read_toml(path: str | os.PathLike[str], what: str, refusal: type[Refusal]) -> dict[str, Any]:
    """The table that a TOML file holds; arguments as for :func:`read_text`.

    Raises:
        Refusal: of that class: the file cannot be read, or is not TOML.
    """
    return parse_toml(read_text(path, what, refusal), str(Path(path)), refusal)


def parse_toml(text: str, source: str, refusal: type[Refusal]) -> dict[str, Any]:
    """The table that a TOML text holds.

    Args:
        text: the text.
        source: name of the file it comes from, put before the message.
        refusal: class of the errors.

    Raises:
        Refusal: of that class: it is not TOML.
    """
    table: dict[str, Any] = _parsed(tomllib.loads, text, "TOML", source, refusal)
    return table


def parse_json(text: str | bytes, source: str, refusal: type[Refusal]) -> Any:
    """Value of a JSON text; arguments as for :func:`parse_toml`.

    Raises:
        Refusal: of that class: it is not JSON.
    """
    return _parsed(json.loads, text, "JSON", source, refusal)


def _parsed(parse: Callable[[Any], Any], text: object, what: str, source: str, refusal: type[Refusal]) -> Any:
    try:
        value = parse(text)
    except RecursionError:
        raise _too_deep(source, refusal) from None
    except ValueError as error:  # errors of the parser, numbers with too many digits, and bytes that are no UTF-8
        raise refusal(f"is not {what}: {error}", kind=Kind.UNREADABLE, file=source) from None
    _check_plain(value, source, refusal)
    return value


def _check_plain(value: Any, source: str, refusal: type[Refusal]) -> None:
    """Refuse what no file of ours can mean and no code of ours should meet: depth without end, integers without."""
    level = [value]
    for _ in range(_DEEPEST):
        if not level:
            return
        level = [
            inner
            for each in level
            if isinstance(each, dict | list)
            for inner in (each.values() if isinstance(each, dict) else each)
        ]
        for each in level:
            if isinstance(each, int) and not -(2**63) <= each < 2**63:
                raise refusal("has an integer of more than 64 bits", kind=Kind.UNREADABLE, file=source)
    raise _too_deep(source, refusal)


def _too_deep(source: str, refusal: type[Refusal]) -> Refusal:
    return refusal(f"has lists or tables more than {_DEEPEST} levels deep", kind=Kind.UNREADABLE, file=source)
