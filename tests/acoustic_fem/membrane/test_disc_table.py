"""Interpolated membranes agree with solved ones, in statics, around the first mode, and in a whole array."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
import pytest
from coarse_discs import coarse_discs

from acoustic_fem import Medium
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.cell.lumped import lumped_admittance
from acoustic_fem.membrane.design_discs import design_disc, design_shape
from acoustic_fem.membrane.disc_table import DiscTable, DiscTables, disc_count, disc_tables
from acoustic_fem.membrane.elasticity import ElasticDisc, solve_dimensionless
from acoustic_fem.membrane.half_section import DiscShape
from acoustic_fem.membrane.rubber import Rubber
from acoustic_fem.network.array_network import solve_network
from geometry import prototype
from geometry.air.cells import cell_catalogue
from geometry.layout.arrangement import lay_out

Shapes = list[DiscShape]


def shapes(count: int, poisson_ratio: float = 0.49) -> Shapes:
    generator = np.random.default_rng(2)
    ratios = zip(generator.uniform(0.1, 0.3, count), generator.uniform(0.4, 0.8, count), strict=True)
    return [DiscShape(float(h), poisson_ratio, float(rim), float(rim), 0.0, 0.25) for h, rim in ratios]


@pytest.fixture(scope="module", autouse=True)
def coarse() -> Iterator[None]:
    """Interpolated and solved discs alike: it is how far apart they are that counts."""
    with coarse_discs():
        yield


@pytest.fixture(scope="module")
def solved() -> list[DiscShape]:
    return []


@pytest.fixture(scope="module")
def table(solved: list[DiscShape], coarse: None) -> DiscTable:
    def solve(several: Sequence[DiscShape]) -> list[ElasticDisc]:
        solved.extend(several)
        return [solve_dimensionless(shape) for shape in several]

    (made,) = disc_tables(shapes(300), solve)
    return made


def response(disc: ElasticDisc, fraction: float) -> np.ndarray:
    """Answers to pressure and to force at a fraction of the first mode's frequency, without loss."""
    square = disc.eigenvalues[0] * fraction**2
    loads = np.stack([disc.swept, disc.patch])
    return np.einsum("ak,bk,k->ab", loads, loads, 1 / (disc.eigenvalues - square))


@pytest.mark.slow
def test_interpolated_discs_agree_with_solved_ones(table: DiscTable) -> None:
    """To within what the solutions themselves are converged to, 3e-4 to 6e-4."""
    for shape in shapes(300)[:6]:
        guess, true = table.at(shape), solve_dimensionless(shape)
        for fraction, accuracy in ((0.0, 2e-4), (0.3, 2e-4), (0.6, 6e-4)):
            np.testing.assert_allclose(response(guess, fraction), response(true, fraction), rtol=accuracy)
        assert guess.eigenvalues[0] == pytest.approx(true.eigenvalues[0], rel=1e-4)
        assert guess.compliance == pytest.approx(true.compliance, rel=1e-4)


@pytest.mark.slow
def test_a_table_takes_far_fewer_solutions_than_it_replaces(table: DiscTable, solved: Shapes) -> None:
    assert len(solved) == disc_count(shapes(300)) < 60
    assert table.error < 3e-4


@pytest.mark.slow
def test_a_disc_outside_the_table_is_solved(table: DiscTable) -> None:
    inside = shapes(300)[0]
    assert table.covers(inside)
    for other in (
        replace(inside, thickness=0.5),
        replace(inside, rim=0.1, glue=0.1),
        replace(inside, glue=0.2),
        replace(inside, rim=0.0, glue=0.0),
        replace(inside, poisson_ratio=0.45),
        replace(inside, prestress=0.1),
        replace(inside, contact=0.5),
    ):
        assert not table.covers(other)


def test_few_discs_are_not_interpolated() -> None:
    assert disc_tables(shapes(49)) == ()
    assert disc_count(shapes(49)) == 49


@pytest.mark.slow
def test_an_array_with_an_interpolated_membrane_responds_as_with_a_solved_one(table: DiscTable) -> None:
    design = prototype("array-2x6").with_values({"membrane.thickness": 0.531})
    assert table.covers(design_shape(design))
    frequency, air, layout, tables = np.linspace(1, 100, 8), Medium.at(), lay_out(design), DiscTables((table,))
    catalogue = cell_catalogue(design, layout)
    cells = {cell: lumped_admittance(cell, frequency, air) for cell in catalogue.distinct}
    guess, true = (solve_network(design, layout, catalogue, cells, frequency, air, known) for known in (tables, None))
    guessed, solved = design_disc(design, known=tables), design_disc(design)
    assert guessed.model is not solved.model
    guessed_transfer, transfer = (each.source_response / each.point_impedance[:, None] for each in (guess, true))
    assert not np.array_equal(guessed_transfer, transfer)
    np.testing.assert_allclose(guessed_transfer, transfer, rtol=2e-4)
    forces = [disc.response(frequency, Rubber(0.1)).volume_per_force for disc in (guessed, solved)]
    np.testing.assert_allclose(*forces, rtol=4e-4)


@pytest.mark.slow
def test_a_table_is_asked_by_who_is_given_it_alone(table: DiscTable) -> None:
    design = prototype("array-2x6").with_values({"membrane.thickness": 0.531})
    before = ArrayParameters.from_design(design)
    given = ArrayParameters.from_design(design, known=DiscTables((table,)))
    after = ArrayParameters.from_design(design)
    assert np.array_equal(before.membrane_compliance, after.membrane_compliance)
    assert not np.array_equal(before.membrane_compliance, given.membrane_compliance)
    boss = {"membrane.shape": "boss", "membrane.boss_diameter": 2.0, "membrane.boss_height": 0.6}
    raised = design_shape(design.with_values(boss))
    assert raised.raised is not None
    assert disc_count([raised] * 3) == 1  # no table holds it, so it is solved


def test_the_shape_of_a_design_is_that_which_is_solved(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[DiscShape] = []
    monkeypatch.setattr(
        "acoustic_fem.membrane.disc.solved_disc", lambda shape: asked.append(shape) or solve_dimensionless(shape)
    )
    for values in ({}, {"membrane.mounting": "clamped"}, {"resonator.cavity_diameter": 7.3}):
        design = prototype("array-2x6").with_values(values)
        design_disc(design)
        assert asked[-1] == design_shape(design)
    stretched = design_shape(prototype("array-2x6").with_values({"membrane.stretch": 1.1}))
    assert stretched.prestress > 0
    assert disc_count([stretched]) == 1
