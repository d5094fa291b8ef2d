"""What may be replaced: a file of the same kind, never one of another, whoever writes."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path


def check_own_kind(path: str | os.PathLike[str], suffix: str, refusal: Callable[[str], Exception]) -> None:
    """Refuse to write over a file whose name ends as that of another kind: a recording, a picture.

    Args:
        path: the file to write.
        suffix: end of the names of its kind, such as ``.nc``.
        refusal: makes the error of a message.

    Raises:
        Exception: by ``refusal``: a file is there, and its name ends otherwise.
    """
    path = Path(path)
    if path.exists() and not path.is_dir() and path.suffix.lower() != suffix:
        raise refusal(f"{path}: exists, and only a {suffix} file is replaced; name another file, or remove this one")
