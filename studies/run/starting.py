"""The file of a prototype as the start of a design of one's own."""

from __future__ import annotations

import os
from pathlib import Path

from geometry.design.design_file import prototype_text
from geometry.ground.whole_files import write_text
from studies.output.folders import check_new_file


def copy_prototype(name: str, out: str | os.PathLike[str]) -> Path:
    """Write the design file of a prototype, with its comments, as the start of a design of your own.

    Args:
        name: one of :func:`geometry.prototype_names`.
        out: a new file; an existing design file is never overwritten.

    Raises:
        Refusal: no prototype of that name, or a file that exists or cannot be written.
    """
    path = Path(out)
    check_new_file(path, ".toml", kept="a design")
    write_text(path, prototype_text(name))
    return path
