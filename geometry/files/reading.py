"""Text files that a user gives, read with one line for whatever is wrong with them."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from geometry.files.ordinary import read_bytes

LARGEST_TEXT = 1_000_000
"""Most bytes of a text; a design of a hundred lines has ten thousand."""


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
        return tomllib.loads(text)
    except RecursionError:
        raise refusal(f"{source}: is not TOML that can be read: lists or tables lie too deep in it") from None
    except ValueError as error:  # TOMLDecodeError, and numbers with more digits than Python reads
        raise refusal(f"{source}: is not TOML: {error}") from None
