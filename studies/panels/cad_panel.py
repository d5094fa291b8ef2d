"""The array in 3-D, its checks, and uploaded designs: work for a process of its own, because of the CAD kernel."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import Any

from geometry import pictures, solids
from geometry.assembly.model import array_model
from geometry.body.reading import Body, read_body
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import read_design
from geometry.design.places_file import names_places
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import parse_toml
from geometry.ground.whole_files import temporary_folder, write_text
from geometry.layout.overlaps import schematic_notes
from geometry.layout.size import array_size
from geometry.schema.field_errors import DesignError
from geometry.surface.fit_file import unfitted
from studies.output.display import Display
from studies.panels.form import stated_values
from studies.run.check import check_design


def read_upload(text: str, name: str, places: tuple[str, str] | None = None) -> dict[str, Any]:
    """Fields of a design file that somebody uploaded, by the reader of design files.

    Args:
        text: TOML.
        name: of the file, for messages.
        places: name and text of the file of places that was handed in with it; None for none.

    Returns:
        ``stated``: as :func:`studies.panels.stated_values`; ``note``: a sentence if the array is not fitted yet, else
        empty.

    Raises:
        DesignError: not TOML, not a valid design, or not one of those places.
    """
    data = parse_toml(text, name, DesignError)
    if not names_places(data):
        return {"stated": stated_values(read_design(text, name)), "note": ""}
    named = data["layout"]["places"]
    if places is not None:
        with temporary_folder() as folder:
            if Path(places[0]).name != named:
                allowed = f"the file that {name} names, {named!r}"
                raise DesignError(kind=Kind.MISMATCH, field="places", value=places[0], allowed=allowed)
            write_text(folder / Path(named).name, places[1])
            with by_their_names():
                return {"stated": stated_values(read_design(text, name, folder)), "note": ""}
    if not isinstance(data.get("surface"), dict):
        return {"stated": stated_values(read_design(text, name)), "note": ""}  # which says what is missing
    note = (
        f"The array is not fitted yet. If you have {named}, open both files together. Else press Fit in the panel Body."
    )
    return {"stated": stated_values(unfitted(data, name)), "note": note}


def model_of_array(design: ArrayDesign, body: str | None = None) -> dict[str, Any]:
    """The array in three dimensions, with the body that it was fitted to.

    Args:
        design: the array.
        body: path of the file of the body; None draws no body.

    Returns:
        ``glb``: binary glTF of :func:`geometry.pictures.viewer.write_gltf`, bytes; ``parts``: for each placed part its
        ``label`` (that of its node, with ``_`` for blanks), ``part`` (the name under which the print report knows its
        shape), ``kind`` and ``group`` (such as "point 3"); ``size``: extent along x, y and z, mm; ``notes``: on what is
        drawn for the eye only.

    Raises:
        Refusal: a part cannot be built.
    """
    model = array_model(design)
    facets, notes = _facets_of(design, body)
    with temporary_folder() as scratch:
        content = pictures.write_gltf(model, scratch / "array.glb", facets).read_bytes()
    return {
        "glb": content,
        "parts": [
            *({"label": name, "part": name, "kind": "body", "group": "body"} for name in facets),
            *(
                {"label": part.label.replace(" ", "_"), "part": part.part, "kind": part.kind, "group": part.group}
                for part in model.placed
            ),
        ],
        "size": list(array_size(design, model.layout)),
        "notes": [*notes, *schematic_notes(design, model.layout)],
    }


def _facets_of(design: ArrayDesign, file: str | None) -> tuple[dict[str, solids.Tessellation], list[str]]:
    """The body that an array was fitted to, and sentences on why none is drawn."""
    stated, frozen = design.surface, design.layout.frozen
    if file is None or stated is None or frozen is None:
        return {}, []
    try:
        path = Path(file)
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


@contextmanager
def by_their_names() -> Iterator[None]:
    """Refusals name files without the folder, which is one of the studio's own."""
    try:
        yield
    except Refusal as error:
        error.file = None if error.file is None else Path(error.file).name
        raise


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
