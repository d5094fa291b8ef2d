"""Text files that a user gives, read with one line for whatever is wrong with them."""

from __future__ import annotations

import json
import os
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from geometry.ground.file_checks import read_bytes

LARGEST_TEXT = 1_000_000
"""Most bytes of a text; a design of a hundred lines has ten thousand."""
_DEEPEST = 32  # levels of lists and tables in a file; designs and studies have five


def read_text(path: str | os.PathLike[str], what: str, refusal: Callable[[str], Exception]) -> str:
    """The text of a file in UTF-8, with or without a byte order mark.

    Args:
        path: the file.
        what: such as ``a design file``, for messages.
        refusal: makes the error of a message.

    Raises:
        Exception: by ``refusal``: no ordinary file that can be read, too large, or not in UTF-8.
    """
    try:
        return read_bytes(path, what, refusal, LARGEST_TEXT).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise refusal(f"{path}: byte {error.start} is not UTF-8; {what} is a text in UTF-8") from None


def read_toml(path: str | os.PathLike[str], what: str, refusal: Callable[[str], Exception]) -> dict[str, Any]:
    """The table that a TOML file holds; arguments as for :func:`read_text`.

    Raises:
        Exception: by ``refusal``: the file cannot be read, or is not TOML.
    """
    return parse_toml(read_text(path, what, refusal), str(Path(path)), refusal)


def parse_toml(text: str, source: str, refusal: Callable[[str], Exception]) -> dict[str, Any]:
    """The table that a TOML text holds.

    Args:
        text: the text.
        source: name of the file it comes from, put before the message.
        refusal: makes the error of a message.

    Raises:
        Exception: by ``refusal``: it is not TOML.
    """
    try:
        table = tomllib.loads(text)
    except RecursionError:
        raise refusal(f"{source}: is not TOML that can be read: lists or tables lie too deep in it") from None
    except ValueError as error:  # TOMLDecodeError, and numbers with more digits than Python reads
        raise refusal(f"{source}: is not TOML: {error}") from None
    _check_plain(table, source, refusal)
    return table


def parse_json(text: str | bytes, source: str, refusal: Callable[[str], Exception]) -> Any:
    """What a JSON text states; arguments as for :func:`parse_toml`.

    Raises:
        Exception: by ``refusal``: it is not JSON.
    """
    try:
        value = json.loads(text)
    except RecursionError:
        raise refusal(f"{source}: is not JSON that can be read: lists or tables lie too deep in it") from None
    except ValueError as error:  # JSONDecodeError, numbers with too many digits, and bytes that are no UTF-8
        raise refusal(f"{source}: is not JSON: {error}") from None
    _check_plain(value, source, refusal)
    return value


def _check_plain(value: Any, source: str, refusal: Callable[[str], Exception]) -> None:
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
                raise refusal(f"{source}: an integer in it has more than 64 bits")
    raise refusal(f"{source}: lists or tables lie deeper in it than {_DEEPEST} levels")
