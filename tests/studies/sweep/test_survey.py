"""How often the designs of a study are built before and while they are computed."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from geometry import ArrayDesign
from studies.study.cases import cases_of
from studies.study.study import read_study
from studies.sweep import block
from studies.sweep.plan import plan_sweep
from studies.sweep.run import run_sweep
from studies.sweep.survey import surveyed

HEAD = 'base = "array-2x6"\nmetrics = ["distance_smallest", "length", "width", "height"]\n'
LENGTHS = '[vary]\n"tube.length" = [12.5, 13, 14, 15, 16, 17]\n'
STATED = 'constraints = ["tube.length > 12.6"]\n'
DERIVED = 'constraints = ["resonator.cavity_volume * tube.length > 900"]\n'


@pytest.fixture
def built(monkeypatch: pytest.MonkeyPatch) -> Counter[float]:
    """How often a design of each tube length was built from values."""
    counts: Counter[float] = Counter()
    own = ArrayDesign.with_values

    def counted(self: ArrayDesign, values: dict[str, float]) -> ArrayDesign:
        counts[values.get("tube.length", 0.0)] += 1
        return own(self, values)

    monkeypatch.setattr(ArrayDesign, "with_values", counted)
    return counts


@pytest.mark.parametrize(
    ("head", "cases", "most"),
    [
        (f'{HEAD}fidelity = "lumped"\n{LENGTHS}', 6, 1),  # nobody asks for the designs but who computes them
        (f'{HEAD}fidelity = "lumped"\n{STATED}{LENGTHS}', 5, 1),
        (f'{HEAD}fidelity = "lumped"\n{DERIVED}{LENGTHS}', 5, 2),  # once by the parent, once by who computes it
        (f'{HEAD}fidelity = "lumped"\n{DERIVED}{LENGTHS}"membrane.thickness" = [0.5]\n', 5, 2),
    ],
)
def test_a_sweep_builds_a_design_once_for_itself_and_once_where_it_is_computed(
    head: str, cases: int, most: int, built: Counter[float], tmp_path: Path
) -> None:
    study = read_study(head)
    built.clear()
    summary = run_sweep(study, tmp_path / "r.zarr", workers=1).summary
    assert summary.computed == cases
    assert not summary.failures
    assert set(built.values()) <= {1, most}


def test_cells_membranes_and_constraints_are_read_from_one_design(
    built: Counter[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    study = read_study(f'{HEAD}fidelity = "navier-stokes"\n{DERIVED}{LENGTHS}"membrane.thickness" = [0.5, 0.6]\n')
    laid_out: list[ArrayDesign] = []
    own = block.place_housings
    monkeypatch.setattr(block, "place_housings", lambda design: (laid_out.append(design), own(design))[1])
    built.clear()
    found = surveyed(study, every=True)
    assert set(built.values()) == {2}  # two thicknesses of each length
    assert len(laid_out) == len(found.cases) == 10
    assert len(found.cells_of(range(10))) == len(set(found.cells_of(range(10)))) == 3
    assert len(found.discs) == 2
    assert found.refused == {}


def test_a_plan_builds_every_design_once_but_for_those_that_it_times(built: Counter[float]) -> None:
    study = read_study(f'{HEAD}fidelity = "lumped"\n[vary]\n"tube.length" = {[12.5 + k / 8 for k in range(40)]}\n')
    built.clear()
    assert plan_sweep(study).cases == 40
    assert sum(count == 1 for count in built.values()) >= 35


def test_a_design_that_is_refused_is_told_with_its_number() -> None:
    study = read_study(f'{HEAD}fidelity = "lumped"\n[vary]\n"resonator.wall_thickness" = [1.0, 2.0, 2.5]\n')
    found = surveyed(study, every=True)
    assert list(found.refused) == [0]
    assert len(found.cases) == len(cases_of(study)) == 3
