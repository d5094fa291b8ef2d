"""Bodies that arrays are laid on: their shape for the page, a fit as ``acoustic-fem fit`` does it, and its files."""

from __future__ import annotations

import shutil
import struct
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from geometry.body.reading import read_body
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import load_design
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.whole_files import temporary_folder, write_text
from geometry.surface.fit_file import save_fitted, text_with_places, unfitted
from studies.panels.cad_panel import CallbackDisplay, by_their_names
from studies.panels.form import stated_values
from studies.run.body_fit import fit_design

#: Head of the shape of a body: numbers of its corners and of its facets.
_HEAD = struct.Struct("<2I")


def body_shape(path: str, unit: str, skin: int | None) -> dict[str, Any]:
    """A body as the page shows it.

    Args:
        path: of its file.
        unit: of lengths in a mesh file.
        skin: which of several closed skins; None if there is one.

    Returns:
        ``name`` of the file; ``faces``: how many it has, 1 for a mesh; ``size`` along x, y and z, mm; ``findings`` of
        the reader; ``sha256`` of the file; ``shape``, little-endian: numbers of corners and facets (2 uint32), places
        of the corners (float32, mm), corners of each facet and the number of its face (uint32).

    Raises:
        Refusal: as :func:`geometry.body.read_body`, with the name of the file.
    """
    with by_their_names():
        body = read_body(path, unit, skin)
    parts = (body.vertices.astype("<f4"), body.triangles.astype("<u4"), body.faces.astype("<u4"))
    return {
        "name": Path(path).name,
        "faces": len(np.unique(body.faces)),
        "size": [float(side) for side in body.extent],
        "findings": list(body.findings),
        "sha256": body.sha256,
        "shape": _HEAD.pack(len(body.vertices), len(body.triangles)) + b"".join(part.tobytes() for part in parts),
    }


def fit_to_body(
    design: ArrayDesign,
    surface: Mapping[str, Any],
    points: Sequence[int] | None,
    body: str,
    notify: Callable[[str], None] = lambda line: None,
) -> ArrayDesign:
    """Lay the parts of a design on a body, as ``acoustic-fem fit`` does with the file of such a design.

    Args:
        design: its parts and lines; its layout does not count.
        surface: the table ``[surface]`` without the body.
        points: of each line; None leaves their number to the pitch.
        body: path of the body's file.
        notify: called with what is being done.

    Returns:
        The array with its frozen places, as it is read from the files that the fit wrote.

    Raises:
        Refusal: the design, the body or the region does not do, or parts overlap in every try.
    """
    stated = stated_values(design)
    lines: list[dict[str, Any]] = stated["lines"]
    if points is not None and len(points) != len(lines):
        allowed = f"a number for each of the {len(lines)} lines"
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="points", value=list(points), allowed=allowed)
    for number, line in enumerate(lines):
        del line["lengths"], line["points"]
        if points is not None:
            line["points"] = points[number]
    data = {**stated, "surface": {**surface, "body": Path(body).name}}
    with temporary_folder() as folder:
        path = folder / f"{design.name}.toml"
        with by_their_names():
            asked = unfitted(data, design.name)
            write_text(path, text_with_places(asked, f"{design.name}.places.json"))
            shutil.copyfile(body, folder / Path(body).name)
            fit_design(path, display=CallbackDisplay(notify))
            return load_design(path)


def save_beside(design: ArrayDesign, body: str | None, folder: Path) -> Path:
    """Write a fitted array as the files that belong beside each other: design, places and body.

    Returns:
        Path of the design file.
    """
    if body is not None:
        shutil.copyfile(body, folder / Path(body).name)
    return save_fitted(design, folder)


def write_fitted(design: ArrayDesign, body: str | None, path: str) -> None:
    """Write the files of :func:`save_beside` into one ZIP file.

    Raises:
        Refusal: the design has no frozen places.
    """
    with temporary_folder() as folder:
        save_beside(design, body, folder)
        shutil.make_archive(str(Path(path).with_suffix("")), "zip", str(folder))
