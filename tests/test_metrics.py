"""Distances of points: exact for ratios that are known, a metric, blind to the touch."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from hypothesis import given
from hypothesis import strategies as st

import acoustic_fem
import geometry
from studies.metrics import (
    DECIBEL,
    attenuation,
    disagreement,
    microphone_ratios,
    sensitivity,
    separability,
    worst_heard,
)


def array(values: np.ndarray, frequency: np.ndarray | None = None) -> xr.DataArray:
    """Transfer functions from (point, microphone, frequency) values."""
    points, microphones, count = values.shape
    grid = np.linspace(1.0, 100.0, count) if frequency is None else frequency
    return xr.DataArray(
        values.astype(complex),
        dims=("point", "microphone", "frequency"),
        coords={"point": np.arange(1, points + 1), "microphone": list("ABCDEF"[:microphones]), "frequency": grid},
    )


def two_points(ratio: np.ndarray, frequency: np.ndarray | None = None) -> xr.DataArray:
    """Two points, two microphones; the ratio of the first point is 1, that of the second as given."""
    one = np.ones_like(ratio)
    return array(np.array([[one, one], [ratio, one]]), frequency)


random_arrays = st.integers(0, 10**6).map(
    lambda seed: array(
        np.exp(np.random.default_rng(seed).normal(size=(4, 3, 9)) * (1 + 2j * np.random.default_rng(seed).random()))
    )
)


def test_a_constant_ratio_gives_its_level_and_phase() -> None:
    found = separability(two_points(np.full(50, 0.5 * np.exp(-0.3j))))
    assert found.level[0, 1] == pytest.approx(20 * np.log10(2), rel=1e-12)
    assert found.phase[0, 1] == pytest.approx(np.degrees(0.3), rel=1e-12)
    assert found.combined[0, 1] == pytest.approx(abs(np.log(0.5 * np.exp(-0.3j))), rel=1e-12)
    assert found.between(1, 2) == found.between(2, 1)


def test_phase_is_the_short_way_round() -> None:
    found = separability(two_points(np.full(50, np.exp(1j * np.radians(350.0)))))
    assert found.phase[0, 1] == pytest.approx(10.0, rel=1e-9)
    assert found.level[0, 1] == pytest.approx(0.0, abs=1e-12)


def test_the_mean_is_over_frequency_not_over_the_places_of_the_grid() -> None:
    # level in nepers rises as f: rms of f over 1 to 100 is sqrt((100^3 - 1) / (3 * 99))
    grid = np.concatenate([np.linspace(1, 20, 2000), np.linspace(20, 100, 900)[1:]])
    found = separability(two_points(np.exp(1e-3 * grid), grid))
    assert found.level[0, 1] == pytest.approx(DECIBEL * 1e-3 * np.sqrt((1e6 - 1) / (3 * 99)), rel=1e-5)


def test_frequencies_outside_the_band_do_not_count() -> None:
    grid = np.arange(1.0, 501.0)
    ratio = np.where(grid <= 100, 0.9, 1e-4)
    assert separability(two_points(ratio, grid)).level[0, 1] == pytest.approx(-20 * np.log10(0.9), rel=1e-9)


def test_distances_of_several_microphone_pairs_are_joined_by_rms() -> None:
    one = np.ones(20)
    h = array(np.array([[one, one, one], [2 * one, one, one]]))
    # ratios AB, AC, BC of the second point: 2, 2, 1
    assert separability(h).level[0, 1] == pytest.approx(20 * np.log10(2) * np.sqrt(2 / 3), rel=1e-12)


@given(random_arrays)
def test_distances_are_a_metric(h: xr.DataArray) -> None:
    found = separability(h)
    for d in (found.level, found.phase, found.combined):
        assert np.array_equal(d, d.T)
        assert np.all(np.diag(d) == 0)
        assert np.all(d[:, None, :] <= d[:, :, None] + d[None, :, :] + 1e-9)


@given(random_arrays, st.integers(0, 10**6))
def test_distances_do_not_depend_on_the_touch(h: xr.DataArray, seed: int) -> None:
    touch = np.exp(np.random.default_rng(seed).normal(size=(4, 1, 9)) * (1 + 1j))
    assert np.allclose(separability(h * touch).combined, separability(h).combined, rtol=1e-9, atol=1e-9)


def test_the_hardest_pair_comes_first_and_its_equals_are_named() -> None:
    place = np.array([0.0, 1.0, 2.5, 3.5])[:, None] * np.ones(10)
    found = separability(array(np.stack([np.exp(place), np.ones_like(place)], axis=1)))
    assert found.hardest_pairs[0] == (1, 2)
    assert found.equally_hard == ((1, 2), (3, 4))
    assert found.nearest(3) == 4
    assert found.between(2, 3)[2] == pytest.approx(1.5)


@pytest.mark.parametrize(
    ("shape", "name"),
    [((1, 2, 5), "1 points"), ((3, 1, 5), "1 microphones"), ((3, 2, 1), "1 frequencies between 1 and 100 Hz")],
)
def test_too_little_to_compare_is_refused(shape: tuple[int, int, int], name: str) -> None:
    with pytest.raises(ValueError, match=name):
        separability(array(np.ones(shape)))


def test_disagreement_names_where_it_is_largest() -> None:
    reference = array(np.ones((3, 2, 5)))
    changed = reference.copy(deep=True)
    changed[2, 1, 3] *= 1.02
    changed[0, 0, 1] *= np.exp(-1j * np.radians(3))
    found = disagreement(changed, reference)
    assert (found.magnitude, found.phase) == (pytest.approx(0.02), pytest.approx(3.0))
    assert found.magnitude_at == (3, "B", 75.25)
    assert found.phase_at == (1, "A", 25.75)
    with pytest.raises(ValueError, match="different frequency coordinates"):
        disagreement(changed, reference[..., 1:])


def test_levels_are_those_of_the_transfer_function_and_joined_by_straight_lines() -> None:
    h = array(np.array([[[1.0, 0.1], [0.5, 0.5]], [[1.0, 0.2], [0.1, 0.01]]]), np.array([1.0, 100.0]))
    assert attenuation(h, 100.0) == pytest.approx(np.array([[-20.0, -6.0206], [-13.9794, -40.0]]), abs=1e-4)
    assert attenuation(h, 50.5)[0, 0] == pytest.approx(20 * np.log10(0.55))
    assert worst_heard(h, 100.0) == (pytest.approx(-40.0), 2)
    with pytest.raises(ValueError, match="frequency = 101 Hz must be between 1 and 100 Hz"):
        attenuation(h, 101.0)


def test_a_symmetric_line_has_mirror_images_as_equally_hard_pairs() -> None:
    library = acoustic_fem.solve(geometry.prototype("array-2x6"), np.linspace(1, 100, 64), fidelity="lumped")
    found = separability(library.transfer_function)
    (first, second), mirror = found.equally_hard
    assert mirror == (13 - second, 13 - first)
    assert np.allclose(found.combined, found.combined[::-1, ::-1], rtol=1e-9)
    assert microphone_ratios(library.transfer_function).shape == (12, 1, 64)


def test_sensitivity_at_low_frequency_is_that_of_the_sealed_volume() -> None:
    """The volume a touch sweeps compresses all air and lifts all other membranes: p = q / sum of compliances."""
    from acoustic_fem.membrane import design_compliance

    design = geometry.prototype("array-2x6").with_values({"materials.soft": SOFT, "membrane.material": "soft"})
    library = acoustic_fem.solve(design, [0.01, 0.02], fidelity="lumped")
    tube, microphone = design.tube, design.microphone
    bore = np.pi / 4 * tube.inner_diameter**2
    hole = np.pi / 4 * microphone.sound_hole_diameter**2 * microphone.sound_hole_length
    air = 12 * design.resonator.cavity_volume + 13 * tube.length * bore
    air += 2 * (microphone.chamber_volume + hole + microphone.back_volume)
    total = air * 1e-9 / library.medium.pressure + 12 * design_compliance(design, 0.01).real
    assert sensitivity(library, 0.01) == pytest.approx(np.full(12, 1e-9 / total), rel=2e-3)


#: Without loss, so that compliances are real and add up.
SOFT = {"youngs_modulus": 1.0, "poisson_ratio": 0.49, "density": 1070.0, "loss_factor": 0.0, "source": "a test"}
