"""The cases of a study: which values each of them has. The same study gives the same cases, everywhere."""

from __future__ import annotations

import math
import warnings
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from geometry import ArrayDesign, DesignError
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.layout.overlaps import refuse_overlaps
from geometry.layout.remedies import refuse_unbuildable
from studies.study.constraints import Constraint, read_value
from studies.study.study import Study

#: How the reason begins of a case that failed by a mistake of the program, not by its design.
PROGRAM_ERROR = "program error: "


@dataclass(frozen=True, eq=False)
class Cases:
    """Cases of a study: designs as values of the parameters over a base design."""

    base: ArrayDesign
    """Design that is varied."""
    names: tuple[str, ...]
    """Dotted names of the parameters."""
    columns: tuple[NDArray[Any], ...]
    """Values of each parameter, in its unit; (n_case,) float64, int64, or objects (texts)."""
    left_out: int = 0
    """Number of combinations or samples that broke a constraint."""

    def __len__(self) -> int:
        return len(self.columns[0])

    @property
    def values(self) -> NDArray[Any]:
        """Values of all parameters; (n_case, n_parameter) float64, or objects where a parameter is a text."""
        texts = any(column.dtype == object for column in self.columns)
        return np.stack([column.astype(object if texts else np.float64) for column in self.columns], axis=1)

    def case(self, number: int) -> dict[str, Any]:
        """Values of one case by dotted name."""
        return {name: column[number].item() if hasattr(column[number], "item") else column[number]
                for name, column in zip(self.names, self.columns, strict=True)}  # fmt: skip

    def design(self, number: int) -> ArrayDesign:
        """Design of one case.

        Raises:
            DesignError: its values do not go together.
        """
        return self.base.with_values(self.case(number))

    def buildable(self, number: int) -> ArrayDesign:
        """Design of one case, laid out and found to be buildable.

        Raises:
            DesignError: its values do not go together, or its parts are in each other's way.
        """
        design = self.design(number)
        refuse_overlaps(design)
        return design

    def part(self, first: int, stop: int) -> Cases:
        """Cases from ``first`` to before ``stop``."""
        return Cases(self.base, self.names, tuple(column[first:stop] for column in self.columns))


def check_base(study: Study) -> None:
    """Refuse a study whose base cannot be built: all other designs of a sweep or a search are compared with it.

    Raises:
        OverlapError: parts of the base are in each other's way; the message says what would fix it.
    """
    refuse_unbuildable(study.base)


def cases_of(study: Study) -> Cases:
    """Cases of a study, all of them, in a fixed order: in a grid the last parameter changes fastest.

    Raises:
        Refusal: the constraints leave no case, or one cannot be computed.
    """
    drawn = drawn_cases(study)
    return kept_cases(study, drawn, [number for number, _ in allowed_cases(study, drawn)])


def drawn_count(study: Study) -> int:
    """Number of cases of a study before its constraints leave any out."""
    return study.cases if study.sampling != "grid" else math.prod(len(axis[0].grid()) for axis in study.axes)


def drawn_cases(study: Study, numbers: NDArray[np.int64] | None = None) -> Cases:
    """Cases of a study before its constraints leave any out, in the order of :func:`cases_of`.

    Args:
        study: the study.
        numbers: those to draw, (n,) int64; by default all.
    """
    chosen = np.arange(drawn_count(study)) if numbers is None else numbers
    if study.sampling == "grid":
        grids = [[parameter.grid() for parameter in axis] for axis in study.axes]
        indices = np.unravel_index(chosen, [len(axis[0]) for axis in grids])
        columns = [grid[index] for axis, index in zip(grids, indices, strict=True) for grid in axis]
    else:
        places = _sampled(study)[chosen]
        columns = [parameter.at(place) for axis, place in zip(study.axes, places.T, strict=True) for parameter in axis]
    return Cases(study.base, tuple(parameter.name for parameter in study.parameters), tuple(columns))


def allowed_cases(study: Study, drawn: Cases) -> Iterator[tuple[int, DrawnCase]]:
    """Each drawn case that meets the constraints of a study, with its number among those that were drawn."""
    for number in range(len(drawn)):
        case = DrawnCase(drawn, number)
        if case.meets(study.constraints):
            yield number, case


def kept_cases(study: Study, drawn: Cases, numbers: Sequence[int], total: int | None = None) -> Cases:
    """Those of the drawn cases that are part of a study, by their numbers.

    Args:
        study: the study.
        drawn: its cases before any was left out, or a sample of them.
        numbers: of those that are kept.
        total: number of all cases, where ``drawn`` is a sample.

    Raises:
        Refusal: there are none.
    """
    if not numbers:
        sample = "" if total in (None, len(drawn)) else f" drawn at random from {total}"
        left = f"of {study.name} leave none of {counted(len(drawn), 'case')}{sample}"
        raise Refusal(left, kind=Kind.CONFLICT, field="constraints")
    columns = tuple(column[list(numbers)] for column in drawn.columns)
    return Cases(drawn.base, drawn.names, columns, len(drawn) - len(numbers))


def _sampled(study: Study) -> NDArray[np.float64]:
    """(cases, n_axis) places from 0 to below 1."""
    size = len(study.axes)
    generator = np.random.default_rng(np.random.SeedSequence(study.seed))
    if study.sampling == "random":
        return generator.random((study.cases, size))
    from scipy.stats import qmc

    if study.sampling == "latin-hypercube":
        return np.asarray(qmc.LatinHypercube(size, rng=generator).random(study.cases))
    with warnings.catch_warnings():
        # Any number of cases may be asked for: a dry run says what is balanced, see `sobol_note`.
        warnings.filterwarnings("ignore", "The balance properties of Sobol", UserWarning)
        return np.asarray(qmc.Sobol(size, scramble=True, rng=generator).random(study.cases))


def sobol_note(study: Study) -> str:
    """Note on a Sobol sample whose number of cases is not a power of two; empty where there is nothing to tell."""
    lower = 1 << (study.cases.bit_length() - 1) if study.cases else 0
    if study.sampling != "sobol" or study.cases == lower:
        return ""
    return f"a Sobol sample of {study.cases} cases is not balanced; one of {lower} or {2 * lower} is"


def repeated_note(cases: Cases) -> str:
    """Note on cases that have the values of earlier ones, as samples of lists and stock sizes do; empty without any."""
    places = np.stack([np.unique(column, return_inverse=True)[1] for column in cases.columns], axis=1)
    repeated = len(cases) - len(np.unique(places, axis=0))
    if not repeated:
        return ""
    verb = "repeats" if repeated == 1 else "repeat"
    return f"{repeated} of {counted(len(cases), 'case')} {verb} the values of an earlier one"


class DrawnCase:
    """One case whose design is built when it is first asked for, and once."""

    def __init__(self, cases: Cases, number: int) -> None:
        self._cases, self._number = cases, number
        self._design: ArrayDesign | DesignError | None = None

    @property
    def design(self) -> ArrayDesign | DesignError:
        """Its design, or why its values do not go together."""
        if self._design is None:
            try:
                self._design = self._cases.design(self._number)
            except DesignError as error:
                self._design = error
        return self._design

    def meets(self, constraints: Sequence[Constraint]) -> bool:
        """True if the case meets all constraints; derived values are those of its design where it is valid."""
        values: Mapping[str, Any] = self._cases.case(self._number)

        def read(name: str) -> Any:
            if name in values:
                return values[name]
            # the case fails by name later, unless its own values break a constraint
            return _read(self._cases.base if isinstance(self.design, DesignError) else self.design, name)

        return all(constraint.holds({name: read(name) for name in constraint.names}) for constraint in constraints)


def _read(design: ArrayDesign, name: str) -> Any:
    """As :func:`geometry.design.design_file.value_of`, without its checks: the names were checked with the study."""
    place: Any = design
    try:
        for step in name.split("."):
            if isinstance(place, tuple):
                place = place[int(step)]
            else:
                place = place[step] if isinstance(place, dict) else getattr(place, step)
    except (AttributeError, LookupError):
        return read_value(design, name)
    return place


def by_kind(reasons: Iterable[tuple[int, str]]) -> dict[str, list[int]]:
    """Numbers of the designs by kind of reason, the most frequent first.

    Args:
        reasons: number of each design that failed, and why.

    Returns:
        Numbers of all designs of a kind, by the reason of the first of them.
    """
    first: dict[str, str] = {}
    found: dict[str, list[int]] = {}
    for number, reason in reasons:
        found.setdefault(first.setdefault(_kind(reason), reason), []).append(number)
    return dict(sorted(found.items(), key=lambda entry: (-len(entry[1]), entry[1][0])))


def _kind(reason: str) -> str:
    """A reason without its numbers; of a mistake of the program all, for its line is what it is."""
    if reason.startswith(PROGRAM_ERROR):
        return reason
    words = reason.replace("(", " ").replace(")", " ").split()
    return " ".join(word for word in words if not any(letter.isdigit() for letter in word))
