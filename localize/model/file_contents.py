"""Kind of a file or folder that is given as a model, recognised by its content, whatever its name is."""

from __future__ import annotations

from enum import Enum
from pathlib import Path

from geometry.ground.file_checks import ordinary_file
from geometry.ground.refusal import Kind, Refusal

TRAINED = "localizer.json"
"""Description in the folder of a trained localizer."""


class FileContent(Enum):
    """Content of a file or folder that is given as a model."""

    NETWORK = "a trained localizer"
    GRAPH = "an ONNX graph"
    LIBRARY = "a library"


def file_content(path: Path) -> FileContent:
    """Content of a file or folder that is given as a model.

    A folder is a trained localizer. A file that begins as ONNX files do, with the number of their version, is a graph;
    all others are libraries, of which :func:`acoustic_fem.load` knows the formats.

    Raises:
        Refusal: nothing is there, it cannot be read, or a folder holds no trained localizer.
    """
    if path.is_dir():
        if (path / TRAINED).exists():
            return FileContent.NETWORK
        raise Refusal(
            f"is a folder without {TRAINED}, so it is not a trained localizer", kind=Kind.UNREADABLE, file=path
        )
    with ordinary_file(path, "a model", Refusal).open("rb") as file:
        head = file.read(3)
    # Protocol buffers: field 1 is a small number, behind it comes the name of what wrote the file, or the graph.
    is_graph = len(head) == 3 and head[0] == 0x08 and head[1] < 0x80 and head[2] & 0x07 == 2
    return FileContent.GRAPH if is_graph else FileContent.LIBRARY
