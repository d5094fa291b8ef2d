"""Files of a run of the verification: convergence studies, checks and tables, as plain values."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np


@dataclass(frozen=True)
class Level:
    """One mesh of a study.

    Attributes:
        label: the refinement, in the words of what is refined.
        size: of the elements, in the unit of the study.
        unknowns: of the system solved.
        error: relative.
    """

    label: str
    size: float
    unknowns: int
    error: float


@dataclass(frozen=True)
class Study:
    """Error against element size.

    Attributes:
        key: short name; also how a quick run finds the same study in the page.
        title: what converges.
        against: what the error is taken against.
        unit: of the sizes.
        levels: coarse to fine.
        expected: order the theory gives, None where no order is claimed.
        spread: how far the fitted order may be from it: unstructured meshes, few levels.
        note: what must be known to read it.
        resolved: largest size that counts in the fit: coarser meshes do not resolve the layer along the walls.
    """

    key: str
    title: str
    against: str
    unit: str
    levels: tuple[Level, ...]
    expected: float | None
    spread: float = 0.5
    note: str = ""
    resolved: float | None = None

    @property
    def fitted(self) -> tuple[Level, ...]:
        """The levels that count in the fit."""
        return tuple(level for level in self.levels if self.resolved is None or level.size <= self.resolved)

    @property
    def order(self) -> float:
        """Slope of log(error) over log(size), least squares over the fitted levels."""
        return fitted_order([level.size for level in self.fitted], [level.error for level in self.fitted])

    @property
    def as_expected(self) -> bool:
        """True if the fitted order lies within the spread of the expected one."""
        return self.expected is None or abs(self.order - self.expected) <= self.spread


@dataclass(frozen=True)
class Check:
    """One number against its target.

    Attributes:
        key: short name.
        what: the quantity.
        against: what the error is taken against.
        measured: relative error, or in the unit.
        target: largest that is accepted.
        unit: empty for relative errors.
        note: where, or under which conditions.
    """

    key: str
    what: str
    against: str
    measured: float
    target: float
    unit: str = ""
    note: str = ""

    @property
    def met(self) -> bool:
        """True if the target is met; a number that is not finite meets none."""
        return bool(self.measured <= self.target)


@dataclass(frozen=True)
class Table:
    """Values to be read, cells already formatted; details stand in the JSON alone."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    detail: bool = False


@dataclass(frozen=True)
class Subject:
    """A section of the page.

    Attributes:
        key: short name, also of its figure.
        title: of the section.
        text: what is verified and how, in Markdown.
        studies: drawn in one figure.
        checks: against targets.
        tables: values.
        seconds: processor time it took.
    """

    key: str
    title: str
    text: str
    studies: tuple[Study, ...] = ()
    checks: tuple[Check, ...] = ()
    tables: tuple[Table, ...] = ()
    seconds: float = 0.0


@dataclass(frozen=True)
class Report:
    """All subjects and what made them.

    Attributes:
        command: that makes the page again.
        versions: name -> version of all that computes.
        solver: backend of the sparse solver.
        seconds: processor time of the whole run.
        subjects: in the order of the page.
    """

    command: str
    versions: dict[str, str]
    solver: str
    seconds: float
    subjects: tuple[Subject, ...] = field(default=())

    @property
    def studies(self) -> dict[str, Study]:
        """By key."""
        return {study.key: study for subject in self.subjects for study in subject.studies}

    @property
    def checks(self) -> dict[str, Check]:
        """By key."""
        return {check.key: check for subject in self.subjects for check in subject.checks}


def fitted_order(sizes: Sequence[float], errors: Sequence[float]) -> float:
    """Slope of log(error) over log(size) by least squares.

    Raises:
        ValueError: fewer than two meshes.
    """
    if len(sizes) < 2:
        raise ValueError(f"an order needs at least two meshes, got {len(sizes)}")
    slope, _ = np.polyfit(np.log(sizes), np.log(errors), 1)
    return float(slope)


def to_json(report: Report) -> dict[str, Any]:
    """The report as JSON values, numbers to four digits, with the fitted orders beside the levels."""
    values: dict[str, Any] = asdict(report)
    for subject, plain in zip(report.subjects, values["subjects"], strict=True):
        plain["seconds"] = rounded(plain["seconds"])
        for study, entry in zip(subject.studies, plain["studies"], strict=True):
            entry["order"] = None if study.expected is None else round(study.order, 2)
            if study.resolved is not None:
                entry["resolved"] = rounded(study.resolved)
            for level in entry["levels"]:
                level["size"], level["error"] = rounded(level["size"]), rounded(level["error"])
                level["unknowns"] = int(level["unknowns"])
        for entry in plain["checks"]:
            entry["measured"] = rounded(entry["measured"])
    values["seconds"] = rounded(report.seconds)
    return values


def from_json(values: dict[str, Any]) -> Report:
    """The report of :func:`to_json`; the orders are fitted anew."""
    subjects = []
    for plain in values["subjects"]:
        studies = []
        for entry in plain["studies"]:
            given = {name: value for name, value in entry.items() if name not in ("order", "levels")}
            studies.append(Study(**given, levels=tuple(Level(**level) for level in entry["levels"])))
        tables = [
            Table(entry["title"], tuple(entry["header"]), tuple(tuple(row) for row in entry["rows"]), entry["detail"])
            for entry in plain["tables"]
        ]
        subjects.append(
            Subject(
                **{name: plain[name] for name in ("key", "title", "text", "seconds")},
                studies=tuple(studies),
                checks=tuple(Check(**entry) for entry in plain["checks"]),
                tables=tuple(tables),
            )
        )
    return Report(**{**values, "subjects": tuple(subjects)})


def rounded(value: float) -> float:
    """Four significant digits."""
    return float(f"{value:.3e}")
