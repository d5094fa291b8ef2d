"""Survey of a sweep's cases before any is computed: each design that this takes is built once."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from time import perf_counter

import numpy as np

from acoustic_fem.atlas import quick_fidelity
from acoustic_fem.membrane.disc import design_shape
from acoustic_fem.membrane.elasticity import DiscShape
from acoustic_fem.quantities.fidelity import CLOSED_FORMS
from geometry import ArrayDesign, DesignError
from geometry.ground.refusal import Refusal
from geometry.layout.overlaps import refuse_overlaps
from studies.study.cases import Cases, allowed_cases, check_base, drawn_cases, drawn_count, kept_cases
from studies.study.study import Study
from studies.sweep.block import CellKey, cells_of
from studies.sweep.progress import Progress, progress_of

#: Parameters that may change a membrane.
_OF_MEMBRANES = ("membrane.", "materials.", "resonator.cavity_diameter", "point_kinds.")

#: Time between two reports, s.
_OFTEN = 1.0


@dataclass(frozen=True, eq=False)
class Survey:
    """Cases of a study and what their designs need."""

    cases: Cases
    """All cases."""
    refused: dict[int, str]
    """Why a case has no design or no cells, by its number; complete where all designs were looked at."""
    discs: tuple[DiscShape, ...]
    """Membranes of all cases, each once; none where no parameter changes them."""
    cells: tuple[tuple[CellKey, ...], ...]
    """3-D cells of each case; empty where cells are closed forms."""
    outside: dict[int, str] = field(default_factory=dict)
    """Why a case lies outside the atlas, by its number; complete where that was looked for."""
    fraction: float = 1.0
    """Size of the sample that was looked at, of one, where the cases are a sample."""

    def cells_of(self, numbers: Iterable[int]) -> tuple[CellKey, ...]:
        """3-D cells of some cases, each once."""
        return tuple(dict.fromkeys(key for number in numbers for key in self.cells[number])) if self.cells else ()


def surveyed(
    study: Study, every: bool = False, most: int | None = None, progress: Callable[[Progress], None] | None = None
) -> Survey:
    """Cases of a study with what their designs need.

    Args:
        study: the study.
        every: look at all designs, also where neither membranes nor 3-D cells ask for it.
        most: number of cases above which a random sample of so many stands for all; by default there is none.
        progress: called every second with the number of designs that were looked at.

    Raises:
        Refusal: the base cannot be built, the constraints leave no case, or one cannot be computed.
    """
    check_base(study)
    membranes = any(parameter.name.startswith(_OF_MEMBRANES) for parameter in study.parameters)
    solid = study.fidelity not in CLOSED_FORMS
    bounded = study.fidelity == "atlas" and (every or study.outside != "fail")
    outside: dict[int, str] = {}
    known: dict[CellKey, CellKey] = {}
    discs: dict[DiscShape, None] = {}
    cells: list[tuple[CellKey, ...]] = []
    refused: dict[int, str] = {}
    total = drawn_count(study)
    chosen = None
    if most is not None and total > most:
        chosen = np.sort(np.random.default_rng(0).choice(total, most, replace=False))
    drawn, kept = drawn_cases(study, chosen), []
    count = _Count(len(drawn), progress)
    for number, case in allowed_cases(study, drawn):
        count.take(number)
        kept.append(number)
        if not (every or membranes or solid or bounded):
            continue
        own: tuple[CellKey, ...] = ()
        why = ""
        try:
            design = case.design
            if isinstance(design, DesignError):
                raise design
            if every or solid or bounded:
                refuse_overlaps(design)
            if bounded and (why := _outside(study, design)):
                outside[len(kept) - 1] = why
            if solid or (why and study.outside != "fail"):
                own = tuple(known.setdefault(key, key) for key in cells_of(design))
            if membranes:
                discs.update((design_shape(design.of_kind(kind)), None) for kind in design.kinds)
        except Refusal as error:
            refused[len(kept) - 1] = str(error)  # the case fails by name when it is computed
        cells.append(own)
    cases = kept_cases(study, drawn, kept, total)
    return Survey(cases, refused, tuple(discs), tuple(cells) if any(cells) else (), outside, len(drawn) / total)


def _outside(study: Study, design: ArrayDesign) -> str:
    """Why a design lies outside the atlas; empty where it does not."""
    return quick_fidelity(design, study.frequency).outside


class _Count:
    """Number of designs that were looked at, passed on every second."""

    def __init__(self, total: int, progress: Callable[[Progress], None] | None) -> None:
        self._total, self._progress = total, progress
        self._begun = self._told = perf_counter()

    def take(self, number: int) -> None:
        """Look at the design of a number, from 0."""
        now = perf_counter()
        if self._progress is not None and now - self._told >= _OFTEN:
            self._told = now
            self._progress(progress_of("designs", number, self._total, 0, number, now - self._begun))
