"""Subjects of a comparison, read: a design, the folder of a run, a library, or a case of a sweep or a search."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Literal, TypeAlias

import acoustic_fem
from acoustic_fem import Library
from acoustic_fem.library.exchange import FORMATS as LIBRARY_FORMATS
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import prototype_names, resolve_design
from geometry.ground.argument_checks import check_type, whole_number
from geometry.ground.file_checks import check_local, read_bytes
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.text_files import LARGEST_TEXT, parse_json
from studies.findings.page import design_of
from studies.findings.result_table import ResultTable, table_of_search, table_of_sweep
from studies.findings.search_files import read_search
from studies.optimization.journal import journal_exists
from studies.output.folders import MANIFEST, MARK, REPORT, RESULTS
from studies.run.file_list import verify_run
from studies.run.run_result import RunResult
from studies.sweep.results import Sweep, is_sweep, open_sweep

SubjectLike: TypeAlias = "ArrayDesign | Library | RunResult | str | os.PathLike[str]"
"""A design, a library, the result of a run, or a text: path or prototype, or ``results.zarr#12`` for a case."""

#: Most subjects of one comparison: more columns and curves cannot be told apart.
MOST_SUBJECTS = 8
_RESULTS_OF_RUN = REPORT[1]
_LIBRARY_OF_RUN = RESULTS[0]
_ALLOWED = "a design file, a prototype, the folder of a run, a library, or a case such as results.zarr#12"


@dataclass(frozen=True, eq=False)
class Subject:
    """Subject of a comparison."""

    name: str
    """Name in tables and figures; no other subject of the comparison has it."""
    kind: Literal["design", "run", "library", "case"]
    """Kind of what was given."""
    source: str
    """Path or text that was given; empty for an object."""
    design: ArrayDesign
    """Design of the sensor."""
    library: Library | None = None
    """Library that is stored with it; None where the design is all there is."""
    results: Mapping[str, Any] = field(default_factory=dict)
    """Content of ``results.json`` of a run; empty for others."""
    metrics: Mapping[str, float] = field(default_factory=dict)
    """Metrics that the sweep or search stored for the case; empty for others."""
    facts: Mapping[str, str] = field(default_factory=dict)
    """Origin of the subject, by name."""


def read_subjects(given: Sequence[SubjectLike]) -> tuple[Subject, ...]:
    """Subjects of a comparison, each under a name of its own.

    Args:
        given: 2 to :data:`MOST_SUBJECTS` subjects, in the order of their columns.

    Raises:
        Refusal: too few or too many, or one that is of another kind or cannot be read; the message names it.
    """
    if not 2 <= len(given) <= MOST_SUBJECTS:
        allowed = f"2 to {MOST_SUBJECTS} designs, runs, libraries or cases"
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="subjects", value=len(given), allowed=allowed)
    found = [read_subject(each) for each in given]
    return tuple(replace(each, name=name) for each, name in zip(found, _names(found), strict=True))


def read_subject(given: SubjectLike) -> Subject:
    """One subject, named after its design or its case.

    Raises:
        Refusal: it is of another kind, or it cannot be read.
    """
    if isinstance(given, ArrayDesign):
        return Subject(given.name, "design", "", given)
    if isinstance(given, Library):
        return _of_library(given, "")
    if isinstance(given, RunResult):
        return _of_run(given.folder)
    check_type("subjects", given, (str, os.PathLike), f"{_ALLOWED}, or such an object")
    text = os.fspath(given)
    path, _, number = text.rpartition("#")
    if path and not os.path.exists(text) and os.path.isdir(path):
        return _of_case(Path(path), number, text)
    if text in prototype_names() or text.endswith(".toml"):
        return _of_design_file(text)
    check_local(text, field="subjects")
    if os.path.isdir(text):
        return _of_folder(Path(text))
    if not os.path.exists(text):
        raise Refusal(
            "there is no such file, folder or prototype", kind=Kind.UNKNOWN, file=text, remedy=f"give {_ALLOWED}"
        )
    return _of_file(Path(text))


def _of_file(path: Path) -> Subject:
    try:
        return _of_library(acoustic_fem.load(path), str(path))
    except Refusal:
        if path.suffix.lower() in LIBRARY_FORMATS:
            raise
        problem = "is neither a design nor a library"
        raise Refusal(problem, kind=Kind.UNREADABLE, file=path, remedy=f"give {_ALLOWED}") from None


def _of_design_file(text: str) -> Subject:
    design = resolve_design(text, "subjects")
    return Subject(design.name, "design", text, design)


def _of_folder(folder: Path) -> Subject:
    if is_sweep(folder) or journal_exists(folder):
        table = table_of_sweep(open_sweep(folder)) if is_sweep(folder) else table_of_search(*read_search(folder))
        problem = f"holds {counted(len(table.number), 'case')}; a comparison needs single cases"
        remedy = f"name a case, such as {folder}#{table.label(0)}"
        raise Refusal(problem, kind=Kind.WRONG_TYPE, file=folder, remedy=remedy)
    if not (folder / MARK).is_file() and not (folder / _RESULTS_OF_RUN).is_file():
        raise Refusal("is not the folder of a run", kind=Kind.WRONG_TYPE, file=folder, remedy=f"give {_ALLOWED}")
    return _of_run(folder)


def _of_run(folder: Path) -> Subject:
    path = folder / _RESULTS_OF_RUN
    if not path.is_file():
        remedy = "the run did not end: run it again, or compare its design.toml"
        raise Refusal(kind=Kind.MISSING, file=path, remedy=remedy)
    content = parse_json(read_bytes(path, "the results of a run", Refusal, LARGEST_TEXT), str(path), Refusal)
    if not isinstance(content, dict) or content.get("program") != "acoustic-fem run":
        raise Refusal("does not hold the results of a run", kind=Kind.UNREADABLE, file=path)
    library = acoustic_fem.load(folder / _LIBRARY_OF_RUN)
    facts = {**_facts_of(library), "created": str(content.get("created", "")), "files": _state_of_files(folder)}
    return Subject(library.design.name, "run", str(folder), library.design, library, content, facts=facts)


def _state_of_files(folder: Path) -> str:
    """Comparison of the files of a run with its manifest, in words."""
    if not (folder / MANIFEST).is_file():
        return f"no {MANIFEST}"
    found = verify_run(folder)
    if found.complete:
        return f"{counted(len(found.unchanged), 'file')}, all as the run wrote them"
    counts = {"changed": found.changed, "missing": found.missing, "extra": found.extra}
    return ", ".join(f"{len(names)} {word}" for word, names in counts.items() if names)


def _of_library(library: Library, source: str) -> Subject:
    created = str(library.provenance.get("created", ""))
    facts = {**_facts_of(library), "created": created}
    return Subject(library.design.name, "library", source, library.design, library, facts=facts)


def _facts_of(library: Library) -> dict[str, str]:
    return {"program version": str(library.provenance.get("code_version", ""))}


def _of_case(folder: Path, number: str, text: str) -> Subject:
    sweep = open_sweep(folder) if is_sweep(folder) else None
    if sweep is None and not journal_exists(folder):
        raise Refusal("is neither the results of a sweep nor the folder of a search", kind=Kind.WRONG_TYPE, file=folder)
    table = table_of_search(*read_search(folder)) if sweep is None else table_of_sweep(sweep)
    row = _row(table, number, folder)
    design = design_of(table, row)
    return Subject(
        design.name,
        "case",
        text,
        design,
        _library_of(sweep, int(number)),
        metrics={column.name: float(column.values[row]) for column in table.metrics},
        facts={table.source: table.title, f"fidelity of the {table.source}": table.fidelity},
    )


def _row(table: ResultTable, number: str, folder: Path) -> int:
    """Row of a case in the table of the cases that were computed."""
    rows = {table.label(row): row for row in range(len(table.number))}
    if number not in rows:
        first, last = table.number.min(), table.number.max()
        allowed = f"the number of a case that was computed, such as {first}; they run from {first} to {last}"
        value: object = whole_number(number) if number.isdecimal() else number
        raise Refusal(kind=Kind.UNKNOWN, file=folder, field="case", value=value, allowed=allowed)
    return rows[number]


def _library_of(sweep: Sweep | None, number: int) -> Library | None:
    """Library of a case, if the sweep keeps libraries."""
    return sweep.library(number) if sweep is not None and sweep.keep == "libraries" else None


def _names(subjects: Sequence[Subject]) -> list[str]:
    """Name of each subject: that of its design. Several subjects of one design also get their kind, file or place."""
    names = [each.name for each in subjects]
    found = list(names)
    for name in {each for each in names if names.count(each) > 1}:
        alike = [place for place, each in enumerate(names) if each == name]
        for place, more in zip(alike, _told_apart([subjects[place] for place in alike]), strict=True):
            found[place] = f"{name} ({more})"
    return found


def _told_apart(alike: Sequence[Subject]) -> list[str]:
    """Words that tell subjects of one name apart, the shortest that do."""
    kinds: list[str] = [each.kind for each in alike]
    files = [os.path.basename(each.source) or each.kind for each in alike]
    paths = [each.source or each.kind for each in alike]
    numbers = [str(place) for place in range(1, len(alike) + 1)]
    return next(words for words in (kinds, files, paths, numbers) if len(set(words)) == len(words))
