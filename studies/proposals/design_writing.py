"""The file of a new design, which answers a designer's question."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import prototype, save_design
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.schema.field_errors import DesignError
from studies.output.folders import check_new_file
from studies.proposals.designer_question import PRINTER, SHOWN, TARGET, question

if TYPE_CHECKING:
    from studies.proposals.proposing import Proposals


def new_design(
    name: str,
    out: str | os.PathLike[str] | None = None,
    *,
    place: str | None = None,
    points: int | str | None = None,
    microphones: int | None = None,
    size: tuple[float, float] | str | None = None,
    rows: int | None = None,
    columns: int | None = None,
    pitch: float | None = None,
    around: float | None = None,
    tubes_below: float | str | None = None,
    printer: str = PRINTER,
    target: str = TARGET,
    budget: float | None = None,
    choose: int | None = None,
    progress: Callable[[str, float], None] | None = None,
) -> ArrayDesign:
    """Write a design that answers a question, made of parts that can be bought, in a layout that can be built.

    Args:
        name: name of the design.
        out: a new TOML file; by default NAME.toml.
        place: flat, fingertip, wrist or hand; by default wrist if ``around`` is given, else flat.
        points: number of points, or "most" for the most that work in ``size``; the default depends on the place, or is
            ``rows`` x ``columns``.
        microphones: number of microphones; the default depends on the place.
        size: length and width in which the array with its microphones must fit, mm; a text such as "30x30" will do.
        rows: number of rows.
        columns: number of points in a row.
        pitch: distance between neighbours along their tube, mm.
        around: circumference of what the array goes around, mm; without ``pitch`` and ``rows`` it is a ring.
        tubes_below: room below the shells for microphones and their tubes, mm.
        printer: printing process; no search changes it.
        target: what touches and the smallest force that must be located.
        budget: highest cost of the parts of one array, USD.
        choose: number of the proposal that is written, from 1, whatever its verdict; by default the first, if it works.
        progress: function that is called with the name of a step and the fraction done.

    Returns:
        The design, as it is in the file.

    Raises:
        Refusal: a value out of range; no design works, with the reason and changes of the question with which one does;
            or a file that exists or cannot be written.
    """
    path = new_path(name, out)
    check_choice(choose)
    asked = question(
        place=place, points=points, microphones=microphones, size=size, rows=rows, columns=columns, pitch=pitch,
        around=around, tubes_below=tubes_below, printer=printer, target=target, budget=budget,
    )  # fmt: skip
    from studies.proposals.proposing import propose  # takes seconds, in which a wrong question is refused already

    found = propose(asked, name, progress)
    return write_proposal(found, path, choose)


def check_choice(choose: int | None) -> None:
    """Refuse a number that no proposal can have, before any search.

    Raises:
        Refusal: below 1, or above the number of designs that are proposed.
    """
    if choose is not None:
        check_range("choose", choose, 1, SHOWN, whole=True)


def new_path(name: str, out: str | os.PathLike[str] | None) -> Path:
    """The file of a new design, which must not exist.

    Raises:
        Refusal: a name that no design can have, or a file that exists or cannot be written.
    """
    try:
        prototype("array-2x6").with_values({"name": name})
    except DesignError as error:
        remedy = ("give the path with ", Field("out")) if Path(name).name != name else error.remedy
        raise Refusal.of(error, file=None, remedy=remedy) from None  # no file has been named
    path = Path(f"{name}.toml" if out is None else out)
    if out is None and path.exists():
        problem = "exists, and a design is never overwritten"
        remedy = ("name another file with ", Field("out"), ", or remove this one")
        raise Refusal(problem, kind=Kind.EXISTS, file=path, remedy=remedy)
    check_new_file(path, ".toml", kept="a design")
    return path


def write_proposal(found: Proposals, path: Path, choose: int | None = None) -> ArrayDesign:
    """Write one of the proposed designs.

    Args:
        found: the proposals.
        path: a new file.
        choose: number of the proposal, from 1; by default the first, if it works.

    Raises:
        Refusal: no such proposal, or none is chosen and none works.
    """
    if choose is None and not found.works:
        raise found.refusal()
    number = 1 if choose is None else choose
    if not 1 <= number <= len(found.designs):
        if not found.designs:
            raise found.refusal()
        allowed = f"a proposal, from 1 to {len(found.designs)}"
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="choose", value=number, allowed=allowed)
    design = found.designs[number - 1].design
    save_design(design, path)
    return design
