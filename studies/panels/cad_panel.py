"""The array in 3-D, its checks, and uploaded designs: work for a process of its own, because of the CAD kernel."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import Any

from geometry import pictures, solids
from geometry.assembly.model import array_model
from geometry.body.reading import Body, read_body
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import read_design
from geometry.ground.refusal import Refusal
from geometry.ground.whole_files import temporary_folder
from geometry.layout.overlaps import schematic_notes
from geometry.layout.size import array_size
from studies.output.display import Display
from studies.panels.form import stated_values
from studies.run.check import check_design


def read_upload(text: str, name: str) -> dict[str, Any]:
    """Fields of a design file that somebody uploaded, by the reader of design files.

    Args:
        text: TOML.
        name: of the file, for messages.

    Returns:
        As :func:`studies.panels.stated_values`.

    Raises:
        DesignError: not TOML, or not a valid design.
    """
    return stated_values(read_design(text, name))


def model_of_array(design: ArrayDesign, folder: Path | None = None) -> dict[str, Any]:
    """The array in three dimensions, with the body that it was fitted to.

    Args:
        design: the array.
        folder: of the design file, where the file of the body is sought; None draws no body.

    Returns:
        ``glb``: binary glTF of :func:`geometry.pictures.viewer.write_gltf`, bytes; ``parts``: for each placed part its
        ``label`` (that of its node, with ``_`` for blanks), ``part`` (the name under which the print report knows its
        shape), ``kind`` and ``group`` (such as "point 3"); ``size``: extent along x, y and z, mm; ``notes``: on what is
        drawn for the eye only.

    Raises:
        Refusal: a part cannot be built.
    """
    model = array_model(design)
    body, notes = _body_of(design, folder)
    with temporary_folder() as scratch:
        content = pictures.write_gltf(model, scratch / "array.glb", body).read_bytes()
    return {
        "glb": content,
        "parts": [
            *({"label": name, "part": name, "kind": "body", "group": "body"} for name in body),
            *(
                {"label": part.label.replace(" ", "_"), "part": part.part, "kind": part.kind, "group": part.group}
                for part in model.placed
            ),
        ],
        "size": list(array_size(design, model.layout)),
        "notes": [*notes, *schematic_notes(design, model.layout)],
    }


def _body_of(design: ArrayDesign, folder: Path | None) -> tuple[dict[str, solids.Tessellation], list[str]]:
    """The body that an array was fitted to, and sentences on why none is drawn."""
    stated, frozen = design.surface, design.layout.frozen
    if folder is None or stated is None or frozen is None:
        return {}, []
    try:
        path = folder / stated.body
        written = path.stat().st_mtime_ns if path.is_file() else 0
        body = _kept_body(path, written, stated.unit, stated.skin)
    except Refusal as error:
        return {}, [f"The body is not drawn: {error}."]
    if frozen.body and body.sha256 != frozen.body:
        return {}, [f"The body is not drawn: {stated.body} has changed since the array was fitted to it."]
    return {"body": solids.Tessellation(body.vertices, body.triangles, body.faces, math.nan)}, []


@lru_cache(maxsize=2)
def _kept_body(path: Path, written: int, unit: str, skin: int | None) -> Body:
    """A body, kept for the next change of a design that lies on it, until its file is written anew."""
    del written  # only tells one content of the file from the next
    return read_body(path, unit, skin)


def check_figures(design: ArrayDesign, notify: Callable[[str], None] = lambda line: None) -> dict[str, Any]:
    """Findings of ``acoustic-fem check``: print findings, overlaps, assumptions of the models against their limits.

    Args:
        design: the array.
        notify: called with what is being done.

    Returns:
        As :meth:`studies.run.check.DesignCheck.to_dict` without the quality; ``verdict`` is its ``buildability``.

    Raises:
        Refusal: as :func:`studies.check_design`.
    """
    found = check_design(design, quality=False, display=CallbackDisplay(notify))  # the points' panel has it
    return {**found.to_dict(), "verdict": found.buildability}


class CallbackDisplay(Display):
    """Display that hands every line to a function.

    Args:
        notify: called with each line.
    """

    def __init__(self, notify: Callable[[str], None]) -> None:
        super().__init__()
        self._notify = notify

    def note(self, text: str) -> None:
        """Hand on a line."""
        self._notify(text)
