"""Survey of a sweep's cases before any is computed: each design that this takes is built once."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from acoustic_fem.membrane.disc import design_shape
from acoustic_fem.membrane.elasticity import DiscShape
from acoustic_fem.quantities.fidelity import CLOSED_FORMS
from geometry import DesignError
from geometry.ground.refusal import Refusal
from geometry.layout.overlaps import refuse_overlaps
from studies.study.cases import Cases, allowed_cases, check_base, drawn_cases, kept_cases
from studies.study.study import Study
from studies.sweep.block import CellKey, cells_of

#: Parameters that may change a membrane.
_OF_MEMBRANES = ("membrane.", "materials.", "resonator.cavity_diameter", "point_kinds.")


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

    def cells_of(self, numbers: Iterable[int]) -> tuple[CellKey, ...]:
        """3-D cells of some cases, each once."""
        return tuple(dict.fromkeys(key for number in numbers for key in self.cells[number])) if self.cells else ()


def surveyed(study: Study, every: bool = False) -> Survey:
    """Cases of a study with what their designs need.

    Args:
        study: the study.
        every: look at all designs, also where neither membranes nor 3-D cells ask for it.

    Raises:
        Refusal: the base cannot be built, the constraints leave no case, or one cannot be computed.
    """
    check_base(study)
    membranes = any(parameter.name.startswith(_OF_MEMBRANES) for parameter in study.parameters)
    solid = study.fidelity not in CLOSED_FORMS
    known: dict[CellKey, CellKey] = {}
    discs: dict[DiscShape, None] = {}
    cells: list[tuple[CellKey, ...]] = []
    refused: dict[int, str] = {}
    drawn, kept = drawn_cases(study), []
    for number, case in allowed_cases(study, drawn):
        kept.append(number)
        if not (every or membranes or solid):
            continue
        own: tuple[CellKey, ...] = ()
        try:
            design = case.design
            if isinstance(design, DesignError):
                raise design
            if every or solid:
                refuse_overlaps(design)
            if solid:
                own = tuple(known.setdefault(key, key) for key in cells_of(design))
            if membranes:
                discs.update((design_shape(design.of_kind(kind)), None) for kind in design.kinds)
        except Refusal as error:
            refused[len(kept) - 1] = str(error)  # the case fails by name when it is computed
        cells.append(own)
    cases = kept_cases(study, drawn, kept)
    return Survey(cases, refused, tuple(discs), tuple(cells) if solid else ())
