"""The model brought to a made sensor: from few measured points to all, and what cannot be known is named."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
import torch
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.calibration.fitted_model import Priors, UpdatedModel
from acoustic_fem.calibration.model_updating import Update, update
from acoustic_fem.duct.leak import leak_conductance
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.sound.estimate import TransferEstimate
from geometry.ground.refusal import Kind
from studies.test_rig.priors import fit_priors, model_deviation
from studies.test_rig.rig_parameters import rig_tolerances, within_95
from studies.test_rig.virtual_rig import HiddenScatter, Rig

GRID = np.linspace(1.0, 100.0, 24)
DESIGN = geometry.prototype("array-2x6")


@pytest.fixture(scope="module")
def library() -> Library:
    return acoustic_fem.solve(DESIGN, GRID, "lumped")


@pytest.fixture(scope="module")
def model(library: Library) -> UpdatedModel:
    return UpdatedModel(library)


def measured(h: np.ndarray, points: Sequence[int], seed: int = 0) -> dict[int, TransferEstimate]:
    """Transfer functions of some points with circular noise of 0.3 %."""
    random = np.random.default_rng(seed)
    deviation = 0.003 * np.abs(h) + 1e-4
    values = h + deviation * (random.standard_normal(h.shape) + 1j * random.standard_normal(h.shape))
    one = np.ones(h.shape[1:])
    return {n: TransferEstimate(values[n - 1], deviation[n - 1], one, 60) for n in points}


def decibels(found: np.ndarray, truth: np.ndarray) -> float:
    return float(np.sqrt(np.mean((20 * np.log10(np.abs(found / truth))) ** 2)))


def test_nominal_parameters_give_the_library(model: UpdatedModel, library: Library) -> None:
    h = model.transfer_function(np.zeros((1, model.count)))[0]
    assert np.allclose(h, library.transfer_function.values, rtol=1e-12)
    assert len(model.names) == model.count == 13 + 12 + 2 + 6


def test_the_jacobian_is_that_of_the_differentiable_network(model: UpdatedModel) -> None:
    random = np.random.default_rng(3)
    u = random.standard_normal(model.count)
    weight = random.standard_normal((12, 2, 24)) + 1j * random.standard_normal((12, 2, 24))
    leaf = torch.tensor(u[None], requires_grad=True)
    (model.transfer_function(leaf)[0] * torch.from_numpy(weight.conj())).real.sum().backward()
    assert leaf.grad is not None
    from_jacobian = (model.jacobian(u) * weight.conj()).real.sum((1, 2, 3))
    assert np.allclose(from_jacobian, leaf.grad[0].numpy(), rtol=1e-5, atol=1e-5 * np.abs(from_jacobian).max())


@pytest.mark.parametrize("modulus", [1.0, 0.85])
def test_three_points_bring_all_points_of_a_foreign_sensor_near(model: UpdatedModel, modulus: float) -> None:
    """The rig's sensors have lengths, cavities, losses and air that the family lacks."""
    before, after = [], []
    for seed in range(4):
        truth = Rig(DESIGN, seed, HiddenScatter(batch=0.0, modulus=modulus), fidelity="lumped").transfer_function(GRID)
        found = update(model, measured(truth, (2, 6, 11), seed))
        assert found.objection is None
        before.append(decibels(model.library.transfer_function.values, truth))
        after.append(decibels(found.transfer_function, truth))
        inside = np.abs(found.transfer_function - truth) < np.sqrt(-2 * np.log(0.05)) * found.deviation
        assert inside.mean() > 0.85
    assert max(after) < 0.4
    assert np.mean(after) < np.mean(before) / 3


def test_a_sensor_that_leaks_is_one_of_the_family_only_where_leaks_are_fitted(
    model: UpdatedModel, library: Library
) -> None:
    leaks = UpdatedModel(library, Priors(leak=2.0))
    assert leaks.count == model.count + 12
    hair = leak_conductance(25e-6, 1e-3, library.medium)
    made = replace(model.nominal_parameters, leak_conductance=np.full((1, 12), hair))
    truth = batch_transfer_function(made, model.topology, GRID, library.medium)[0]
    estimates = measured(truth, (2, 5, 6, 11))
    tight, found = update(model, estimates), update(leaks, estimates)
    assert "chi-squared" in assert_refused(tight)
    assert found.objection is None
    assert decibels(found.transfer_function, truth) < 0.75 * decibels(tight.transfer_function, truth)


@pytest.mark.slow
@pytest.mark.parametrize("points", [(1, 4, 8, 12), tuple(range(1, 13))], ids=["four points", "all points"])
def test_parameters_of_the_family_are_recovered_within_the_posterior(
    points: tuple[int, ...], model: UpdatedModel
) -> None:
    away = []
    for seed in range(6):
        u = np.random.default_rng(seed).standard_normal(model.count)
        found = update(model, measured(model.transfer_function(u[None])[0], points, seed))
        assert found.objection is None
        away.append((found.parameters - u) / np.sqrt(np.diag(found.covariance)))
    assert np.mean(np.abs(away) < 1.96) > 0.92


@pytest.mark.slow
def test_parts_of_foreign_sensors_lie_within_the_posterior(library: Library) -> None:
    """Exact measurements: all that stands between truth and fit is what the family lacks."""
    model = UpdatedModel(library, fit_priors(DESIGN, rig_tolerances(HiddenScatter())))
    inside: dict[str, list[bool]] = defaultdict(list)
    for seed in range(10):
        rig = Rig(DESIGN, seed, HiddenScatter(), fidelity="lumped")
        found = update(model, measured(rig.transfer_function(GRID), (2, 6, 11), seed))
        assert found.objection is None
        for part, is_inside in within_95(rig, found):
            inside[part].append(is_inside)
    assert set(inside) == {"bore", "compliance", "gain", "high-pass", "chamber"}
    assert {name: np.mean(each) > 0.85 for name, each in inside.items()} == dict.fromkeys(inside, True)


def test_what_one_point_cannot_tell_is_named(model: UpdatedModel) -> None:
    truth = Rig(DESIGN, 1, fidelity="lumped").transfer_function(GRID)
    one, all_points = (update(model, measured(truth, points)) for points in ((6,), range(1, 13)))
    assert len(one.undetermined) > len(all_points.undetermined)
    assert len(one.undetermined) == model.count - (one.eigenvalues >= 1).sum()
    direction = one.directions[:, 0]  # the data do not change along it
    moved = model.transfer_function(np.stack([one.parameters, one.parameters + 0.5 * direction]))[:, 5]
    assert np.abs(moved[1] / moved[0] - 1).max() < 0.03
    assert all(any(name in text for name in model.names) for text in one.undetermined)
    assert np.sqrt(np.diag(one.covariance)).max() <= 1 + 1e-9


@pytest.mark.slow
def test_a_sensor_of_another_kind_is_refused_by_chi_squared(model: UpdatedModel) -> None:
    other = DESIGN.with_values({"tube.length": 60.0})
    truth = acoustic_fem.solve(other, GRID, "lumped").transfer_function.values
    assert_refused(update(model, measured(truth, (3, 6, 9))))
    ripple = 1 + 0.1 * np.sin(GRID)
    truth = model.library.transfer_function.values * ripple
    assert "chi-squared" in assert_refused(update(model, measured(truth, (3, 6, 9))))


def assert_refused(found: Update) -> str:
    assert found.objection is not None
    assert found.summary()["objection"] == found.objection
    return found.objection


def test_a_fit_that_cannot_be_made_is_refused(model: UpdatedModel) -> None:
    truth = model.library.transfer_function.values
    estimates = measured(truth, (1,))
    for given, field, kind in (
        ({}, "estimates", Kind.MISSING),
        ({13: estimates[1]}, "point", Kind.OUT_OF_RANGE),
        ({1: measured(truth[..., :5], (1,))[1]}, "estimates.1", Kind.MISMATCH),
    ):
        with refused(kind, field):
            update(model, given)
    with refused(Kind.OUT_OF_RANGE, "priors.bore", 0.0):
        Priors(bore=0.0)


@pytest.mark.slow
def test_priors_and_spread_follow_the_tolerances() -> None:
    priors = fit_priors(DESIGN)
    assert priors.bore == pytest.approx(0.015 / 0.44, rel=0.15)
    assert priors.modulus == 0.15
    assert 0.1 < priors.compliance < 0.5
    none = fit_priors(DESIGN, ())
    assert (none.bore, none.compliance, none.modulus) == (1e-3, 1e-3, 1e-3)
    spread = model_deviation(DESIGN, GRID)
    assert spread.shape == (12, 2, 24)
    assert (spread > 0).all()
    assert spread.max() < 0.5


@pytest.mark.parametrize("delay", [5e-4, -2e-3])
def test_a_delay_of_the_reference_is_found_and_spoils_nothing(model: UpdatedModel, delay: float) -> None:
    truth = Rig(DESIGN, 201, fidelity="lumped").transfer_function(GRID)
    late = truth * np.exp(-2j * np.pi * GRID * delay)
    found = update(model, measured(late, (2, 6, 11)))
    assert found.objection is None
    assert found.delay == pytest.approx(delay, abs=3e-4)
    assert decibels(found.transfer_function, truth) < 0.4
    assert np.abs(np.angle(found.transfer_function / truth)).max() < 0.12


@pytest.mark.parametrize("share", [0.0, 1e-12, 1e-7])
def test_measurements_without_noise_are_believed_to_a_limit(model: UpdatedModel, share: float) -> None:
    u = np.random.default_rng(1).standard_normal(model.count)
    h = model.transfer_function(u[None])[0]
    one = np.ones(h.shape[1:])
    found = update(model, {n: TransferEstimate(h[n - 1], share * np.abs(h[n - 1]), one, 60) for n in (2, 6, 11)})
    assert found.objection is None
    assert decibels(found.transfer_function[[1, 5, 10]], h[[1, 5, 10]]) < 0.03


def test_the_point_that_disagrees_is_named(model: UpdatedModel) -> None:
    truth = Rig(DESIGN, 202, fidelity="lumped").transfer_function(GRID)
    truth[5, 0] = truth[5, 1]  # one recording given for two channels
    found = update(model, measured(truth, (2, 6, 9, 11)))
    assert "point 6 is farthest from the fit" in assert_refused(found)
    assert found.worst_point == 6
