"""Interpolated membranes agree with solved ones, in statics, around the first mode, and in a whole array."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

import acoustic_fem
from acoustic_fem.membrane.disc import design_disc
from acoustic_fem.membrane.disc_table import DiscTable, design_shape, disc_count, disc_tables, interpolated_discs
from acoustic_fem.membrane.elasticity import DiscShape, ElasticDisc, solve_dimensionless
from geometry import prototype

Shapes = list[DiscShape]


def shapes(count: int, poisson_ratio: float = 0.49) -> Shapes:
    generator = np.random.default_rng(2)
    ratios = zip(generator.uniform(0.1, 0.3, count), generator.uniform(0.4, 0.8, count), strict=True)
    return [DiscShape(float(h), poisson_ratio, float(rim), float(rim), 0.0, 0.25) for h, rim in ratios]


@pytest.fixture(scope="module")
def solved() -> list[DiscShape]:
    return []


@pytest.fixture(scope="module")
def table(solved: list[DiscShape]) -> DiscTable:
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


def test_interpolated_discs_agree_with_solved_ones(table: DiscTable) -> None:
    """To within what the solutions themselves are converged to, 3e-4 to 6e-4."""
    for shape in shapes(300)[:6]:
        guess, true = table.at(shape), solve_dimensionless(shape)
        for fraction, accuracy in ((0.0, 2e-4), (0.3, 2e-4), (0.6, 6e-4)):
            np.testing.assert_allclose(response(guess, fraction), response(true, fraction), rtol=accuracy)
        assert guess.eigenvalues[0] == pytest.approx(true.eigenvalues[0], rel=1e-4)
        assert guess.compliance == pytest.approx(true.compliance, rel=1e-4)


def test_a_table_takes_far_fewer_solutions_than_it_replaces(table: DiscTable, solved: Shapes) -> None:
    assert len(solved) == disc_count(shapes(300)) < 60
    assert table.error < 3e-4


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


def test_an_array_with_an_interpolated_membrane_responds_as_with_a_solved_one(table: DiscTable) -> None:
    design = prototype("array-2x6").with_values({"membrane.thickness": 0.531})
    assert table.covers(design_shape(design) or shapes(1)[0])
    frequency = np.linspace(1, 100, 8)
    with interpolated_discs([table]):
        guess = acoustic_fem.solve(design, frequency, "lumped")
        guessed_force = guess.force_response.values
        disc = design_disc(design)
    true = acoustic_fem.solve(design, frequency, "lumped")
    assert disc.model is not design_disc(design).model
    np.testing.assert_allclose(guess.transfer_function, true.transfer_function, rtol=2e-4)
    np.testing.assert_allclose(guessed_force, true.force_response.values, rtol=4e-4)


def test_the_shape_of_a_design_is_that_which_is_solved(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[DiscShape] = []
    monkeypatch.setattr(
        "acoustic_fem.membrane.disc._cached_disc", lambda shape: asked.append(shape) or solve_dimensionless(shape)
    )
    for values in ({}, {"membrane.mounting": "clamped"}, {"resonator.cavity_diameter": 7.3}):
        design = prototype("array-2x6").with_values(values)
        design_disc(design)
        assert asked[-1] == design_shape(design)
    assert design_shape(prototype("array-2x6").with_values({"membrane.stretch": 1.1})) is None
