"""STEP files of others, read in a process of their own."""

from __future__ import annotations

import io
import os
import re
from typing import TYPE_CHECKING

from geometry.ground.file_checks import LARGEST_DATA, ordinary_file, read_bytes
from geometry.ground.foreign_files import read_apart
from geometry.ground.refusal import Kind, Refusal

if TYPE_CHECKING:
    import cadquery

#: Memory that the CAD kernel may take to read a file, bytes.
_MEMORY = 1_500_000_000
_LENGTH = 8  # bytes ahead of each shape
#: Numbers that are none, or too large to be a length, at which the CAD kernel loops for ever; texts are stepped over.
_NUMBERS = re.compile(
    rb"'[^']*+'|[(,]\s*(?P<no_length>[-+]?(?:nan|inf|infinity|\d++(?:\.\d*+)?e\+?\d{3,}))\s*(?=[,)])", re.IGNORECASE
)


def read_step(path: str | os.PathLike[str]) -> list[cadquery.Shape]:
    """The shapes in a STEP file, mm, whoever wrote it.

    Args:
        path: the file.

    Raises:
        Refusal: no such file, no STEP file, one with a number that cannot be a length, or one that takes more than
            20 s or 1.5 GB to read.
    """
    import cadquery as cq

    checked = ordinary_file(path, "a STEP file", Refusal, LARGEST_DATA)
    for found in _NUMBERS.finditer(read_bytes(checked, "a STEP file", Refusal, LARGEST_DATA)):
        if number := found["no_length"]:
            problem = f"holds the number {number.decode()}, which cannot be a length"
            raise Refusal(problem, kind=Kind.UNREADABLE, file=checked)
    content = io.BytesIO(read_apart(_shapes_in, checked, "a STEP file", Refusal, _MEMORY))
    shapes = []
    while length := content.read(_LENGTH):
        shapes.append(cq.Shape.importBin(io.BytesIO(content.read(int.from_bytes(length, "little")))))
    if not shapes:
        raise Refusal("holds no shape", kind=Kind.UNREADABLE, file=checked)
    return shapes


def _shapes_in(path: str) -> bytes:
    """In the process: the shapes in the binary form of the CAD kernel, which keeps every digit."""
    import cadquery as cq

    pieces = []
    for shape in cq.importers.importStep(path).vals():
        if not isinstance(shape, cq.Shape):
            raise Refusal(f"it holds {type(shape).__name__}, not a shape", kind=Kind.UNREADABLE)
        held = io.BytesIO()
        shape.exportBin(held)
        pieces += [len(held.getvalue()).to_bytes(_LENGTH, "little"), held.getvalue()]
    return b"".join(pieces)
