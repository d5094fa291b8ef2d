"""The cases of a study: every combination or samples, the same ones every time."""

from __future__ import annotations

import numpy as np
import pytest
from refusals import refused

from geometry.ground.refusal import Kind
from studies.study.cases import Cases, cases_of
from studies.study.parameter import StudyError
from studies.study.study import read_study

HEAD = 'base = "array-2x6"\nmetrics = ["distance_smallest"]\nfidelity = "lumped"\nstock = "off"\n'


def cases(head: str, parameters: str) -> Cases:
    return cases_of(read_study(f"{HEAD}{head}\n[vary]\n{parameters}"))


def test_a_grid_has_every_combination_and_its_last_parameter_changes_fastest() -> None:
    found = cases("", '"tube.length" = [12, 14]\n"tube.inner_diameter" = {from = 0.3, to = 0.5, count = 3}\n')
    np.testing.assert_allclose(
        found.values, [[12, 0.3], [12, 0.4], [12, 0.5], [14, 0.3], [14, 0.4], [14, 0.5]], rtol=1e-15
    )


def test_a_logarithmic_range_has_equal_ratios_and_its_ends_exactly() -> None:
    (column,) = cases("", '"tube.length" = {from = 10, to = 80, count = 4, scale = "log"}\n').columns
    assert (column[0], column[-1]) == (10, 80)
    np.testing.assert_allclose(column[1:] / column[:-1], 2, rtol=1e-14)


def test_parameters_that_go_together_share_one_axis() -> None:
    found = cases(
        "",
        '"tube.length" = [12, 14]\n[[together]]\n"resonator.cavity_height" = [2.5, 3]\n'
        '"resonator.cavity_diameter" = [6, 7]\n',
    )
    assert [tuple(row) for row in found.values] == [(12, 2.5, 6), (12, 3, 7), (14, 2.5, 6), (14, 3, 7)]


def test_whole_numbers_and_texts_stay_what_they_are() -> None:
    found = cases(
        'sampling = "random"\ncases = 60',
        '"lines.0.points" = {from = 4, to = 7}\n"membrane.material" = ["silicone-shore-a-30", "silicone-shore-a-10"]\n',
    )
    points, material = found.columns
    assert points.dtype == np.int64
    assert set(points.tolist()) == {4, 5, 6, 7}
    assert set(material.tolist()) == {"silicone-shore-a-30", "silicone-shore-a-10"}
    assert found.design(3).point_count == points[3]
    assert found.design(3).membrane.material == material[3]


@pytest.mark.parametrize("sampling", ["latin-hypercube", "sobol", "random"])
def test_samples_lie_in_their_ranges_and_come_again_from_the_seed_alone(sampling: str) -> None:
    def drawn(seed: int) -> Cases:
        return cases(
            f'sampling = "{sampling}"\ncases = 32\nseed = {seed}',
            '"tube.length" = {from = 10, to = 40, scale = "log"}\n"tube.inner_diameter" = {from = 0.3, to = 0.5}\n',
        )

    one, same, other = drawn(1), drawn(1), drawn(2)
    np.testing.assert_array_equal(one.values, same.values)
    assert not np.array_equal(one.values, other.values)
    length, bore = one.columns
    assert length.min() >= 10
    assert length.max() <= 40
    assert bore.min() >= 0.3
    assert bore.max() <= 0.5


@pytest.mark.parametrize("sampling", ["latin-hypercube", "sobol"])
def test_each_of_equal_slices_of_a_range_holds_one_sample(sampling: str) -> None:
    (column,) = cases(f'sampling = "{sampling}"\ncases = 32', '"tube.length" = {from = 10, to = 42}\n').columns
    assert np.abs(np.sort(column) - 10.5 - np.arange(32)).max() <= 0.5 + 0.005  # values have two decimals here


def test_cases_that_break_a_constraint_are_left_out_and_counted() -> None:
    lines = '"tube.length" = [12.5, 14, 16]\n"tube.inner_diameter" = [0.4, 0.5]\n'
    found = cases('constraints = ["tube.length >= 30 * tube.inner_diameter"]', lines)
    assert [tuple(row) for row in found.values] == [(12.5, 0.4), (14, 0.4), (16, 0.4), (16, 0.5)]
    assert found.left_out == 2


def test_constraints_know_derived_values_of_the_design() -> None:
    found = cases(
        'constraints = ["resonator.cavity_volume < 80 and not (point_count < 5)", "max(tube.length, 3) / 2 <= 7"]',
        '"resonator.cavity_height" = [2.5, 3.5]\n"lines.0.points" = [4, 12]\n"tube.length" = [12.5, 16]\n',
    )
    assert [tuple(row) for row in found.values] == [(2.5, 12, 12.5)]


def test_a_constraint_may_leave_out_designs_that_are_not_valid() -> None:
    """A tube narrower outside than inside is no design; the constraint takes it out before it fails."""
    lines = '"tube.inner_diameter" = [0.4, 1.2]\n'
    assert len(cases("", lines)) == 2
    assert len(cases('constraints = ["tube.inner_diameter < tube.outer_diameter"]', lines)) == 1


def test_constraints_that_leave_nothing_or_cannot_be_computed_are_refused() -> None:
    for constraint, kind in (
        ("tube.length > 100", Kind.CONFLICT),
        ("1 / (tube.length - tube.length) > 1", Kind.NO_RESULT),
        ("layout.pitch > 1", Kind.NO_RESULT),
    ):
        with refused(kind, "constraints"):
            cases(f'constraints = ["{constraint}"]', '"tube.length" = [12, 14]\n')


def test_too_large_a_grid_is_refused() -> None:
    with refused(Kind.OUT_OF_RANGE, "sampling", error=StudyError):
        cases(
            "",
            '"tube.length" = {from = 9, to = 40, count = 100000}\n'
            '"tube.inner_diameter" = {from = 0.3, to = 0.5, count = 1000}\n',
        )
