"""Survey of a sweep's cases before any is computed: each design that this takes is built once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from itertools import compress
from time import perf_counter

import numpy as np

from acoustic_fem import Medium
from acoustic_fem.atlas import OutsideAtlas, outside_atlas
from acoustic_fem.atlas.cell_in_atlas import check_gas
from acoustic_fem.batch.openings import OpeningSizes, designs_outside
from acoustic_fem.batch.topology import Topology
from acoustic_fem.membrane.design_discs import design_shape
from acoustic_fem.membrane.half_section import DiscShape
from acoustic_fem.quantities.fidelity import CLOSED_FORMS
from acoustic_fem.quantities.local_air import design_air
from geometry import ArrayDesign, DesignError
from geometry.ground.refusal import Refusal
from geometry.layout.overlaps import refuse_overlaps
from studies.study.cases import Cases, allowed_cases, check_base, drawn_cases, drawn_count, kept_cases
from studies.study.study import Study
from studies.sweep.block import CellKey, cells_of
from studies.sweep.progress import Progress, progress_of

#: Parameters that may change a membrane.
_OF_MEMBRANES = ("membrane.", "materials.", "resonator.cavity_diameter", "point_kinds.")

#: Designs that are looked at together.
_TOGETHER = 256

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
    total = drawn_count(study)
    chosen = None
    if most is not None and total > most:
        chosen = np.sort(np.random.default_rng(0).choice(total, most, replace=False))
    drawn, kept = drawn_cases(study, chosen), []
    count = _Count(len(drawn), progress)
    needs = _Needs(study, membranes=membranes, solid=solid, bounded=bounded)
    for number, case in allowed_cases(study, drawn):
        count.take(number)
        kept.append(number)
        if not (every or membranes or solid or bounded):
            continue
        needs.add(len(kept) - 1, case.design, laid_out=every or solid or bounded)
    needs.look()
    cases = kept_cases(study, drawn, kept, total)
    cells = tuple(needs.cells.get(number, ()) for number in range(len(kept))) if needs.cells else ()
    return Survey(cases, needs.refused, tuple(needs.discs), cells, needs.outside, len(drawn) / total)


class _Needs:
    """Needs of designs, which are looked at many at a time: whether the atlas covers them is asked of all at once."""

    def __init__(self, study: Study, *, membranes: bool, solid: bool, bounded: bool) -> None:
        self._study, self._membranes, self._solid, self._bounded = study, membranes, solid, bounded
        self._waiting: dict[int, ArrayDesign] = {}
        self._known: dict[CellKey, CellKey] = {}
        self.refused: dict[int, str] = {}
        self.outside: dict[int, str] = {}
        self.discs: dict[DiscShape, None] = {}
        self.cells: dict[int, tuple[CellKey, ...]] = {}

    def add(self, number: int, design: ArrayDesign | DesignError, *, laid_out: bool) -> None:
        """Take a design; where it is laid out, its parts must not overlap."""
        try:
            if isinstance(design, DesignError):
                raise design
            if laid_out:
                refuse_overlaps(design)
        except Refusal as error:
            self.refused[number] = str(error)  # the case fails by name when it is computed
            return
        self._waiting[number] = design
        if len(self._waiting) == _TOGETHER:
            self.look()

    def look(self) -> None:
        """Look at the designs that were taken."""
        if self._bounded:
            self.outside |= _outside(self._study, self._waiting)
        for number, design in self._waiting.items():
            try:
                if self._solid or (number in self.outside and self._study.outside != "fail"):
                    found = tuple(self._known.setdefault(key, key) for key in cells_of(design))
                    if found:
                        self.cells[number] = found
                if self._membranes:
                    self.discs.update((design_shape(design.of_kind(kind)), None) for kind in design.kinds)
            except Refusal as error:
                self.refused[number] = str(error)
        self._waiting.clear()


def _outside(study: Study, designs: Mapping[int, ArrayDesign]) -> dict[int, str]:
    """Why designs lie outside the atlas, by their numbers; those inside are left out."""
    groups: dict[tuple[Topology, Medium], list[int]] = {}
    suspects: list[int] = []
    for number, design in designs.items():
        if all(design.of_kind(kind).resonator.shape == "cylinder" for kind in design.kinds):
            groups.setdefault((Topology.of(design), design_air(design)), []).append(number)
        else:
            suspects.append(number)
    for (topology, medium), numbers in groups.items():
        sizes = OpeningSizes.from_designs([designs[number] for number in numbers])
        try:
            check_gas(medium)
        except OutsideAtlas:
            suspects += numbers
        else:
            suspects += compress(numbers, designs_outside(sizes, topology, study.frequency, medium))
    found = ((number, outside_atlas(designs[number], study.frequency)) for number in sorted(suspects))
    return {number: why for number, why in found if why}


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
