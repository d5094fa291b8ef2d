"""Comparison of designs, runs, libraries and cases of sweeps: one call, and its files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from acoustic_fem import Library
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.typed import PathLike
from studies.comparison.compared import Comparison
from studies.comparison.compared_rows import compared_figures, differing_fields
from studies.comparison.comparison_page import write_comparison
from studies.comparison.level_curves import level_curves, response_differences
from studies.comparison.own_figures import OwnFigure, solved, subject_figures
from studies.comparison.subjects import SubjectLike, read_subjects
from studies.output.display import Display
from studies.output.folders import check_new_file, write_json

#: Suffixes of the files that a comparison is written to.
FORMATS = (".html", ".json")


def compare(
    *subjects: SubjectLike,
    out: PathLike | None = None,
    printing: bool = True,
    display: Display | None = None,
) -> Comparison:
    """Comparison of designs, runs, libraries and cases of sweeps: fields, figures and curves side by side.

    Every subject is compared by the same figures. A run and a library are compared by their own transfer functions, a
    design by those that the atlas of cells gives in milliseconds.

    Args:
        subjects: two to eight. Each is a design, the path of its file, or the name of a prototype; the folder of a run
            or its result; a library or its file; or a case of a sweep or a search as ``results.zarr#12``. Kinds may be
            mixed.
        out: a page (``.html``) or a file of all figures (``.json``) to write; an earlier one is replaced.
        printing: whether to draw the parts of designs and compare them with the print rules, which takes seconds. The
            verdict of a run is read from its results.
        display: shows progress.

    Raises:
        Refusal: fewer than two subjects or more than eight, a subject that cannot be read or solved, or a file that
            cannot be written.
    """
    path = _new_file(out, subjects)
    read = read_subjects(subjects)
    show = display or Display()
    figures: list[dict[str, OwnFigure]] = []
    libraries: list[Library] = []
    for each in read:
        with show.stage(each.name, of=len(read)):
            library, fidelity = solved(each)
            drawn = printing and each.kind in ("design", "case")
            figures.append(subject_figures(each, library, fidelity, printing=drawn, display=Display()))
            libraries.append(library)
    found = Comparison(
        subjects=read,
        fields=differing_fields([each.design for each in read]),
        figures=compared_figures(figures),
        curves=tuple(level_curves(each.name, library) for each, library in zip(read, libraries, strict=True)),
        differences=response_differences(read, libraries),
    )
    if path is not None:
        if path.suffix.lower() == ".json":
            write_json(path, found.to_dict())
        else:
            write_comparison(found, path)
    return found


def _new_file(out: PathLike | None, subjects: Sequence[SubjectLike]) -> Path | None:
    """Path of the file to write, checked before any work; None for none."""
    if out is None:
        return None
    path = Path(out)
    if path.suffix.lower() not in FORMATS and not path.is_dir():
        allowed = f"a page or its figures, {' or '.join(FORMATS)}"
        raise Refusal(kind=Kind.OUT_OF_RANGE, file=path, field=Field("out"), allowed=allowed)
    reads = [each for each in subjects if isinstance(each, (str, os.PathLike))]
    check_new_file(path, path.suffix.lower(), reads=reads)
    return path
