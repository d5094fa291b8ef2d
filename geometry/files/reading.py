"""Text files that a user gives, read with one line for whatever is wrong with them."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

_LARGEST_FILE = 1_000_000  # bytes; a design of a hundred lines has ten thousand


def read_text(path: str | os.PathLike[str], what: str, refusal: Callable[[str], Exception]) -> str:
    """The text of a file in UTF-8, with or without a byte order mark.

    Args:
        path: the file.
        what: such as ``a design file``, for messages.
        refusal: makes the error of a message.

    Raises:
        Exception: by ``refusal``: no such file, a folder, too large, not in UTF-8, or not readable.
    """
    path = Path(path)
    try:
        if path.is_file() and path.stat().st_size > _LARGEST_FILE:
            raise refusal(f"{path}: {path.stat().st_size} bytes must be at most {_LARGEST_FILE} for {what}")
        return path.read_bytes().decode("utf-8-sig")
    except FileNotFoundError:
        raise refusal(f"{path}: no such file") from None
    except IsADirectoryError:
        raise refusal(f"{path}: is a folder, not {what}") from None
    except UnicodeDecodeError as error:
        raise refusal(f"{path}: byte {error.start} is not UTF-8; {what} is a text in UTF-8") from None
    except OSError as error:
        raise refusal(f"{path}: cannot be read: {error.strerror}") from None
