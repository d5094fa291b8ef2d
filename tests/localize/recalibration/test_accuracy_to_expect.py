"""What to expect of a fit is said beforehand, and comes true."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
import localize
from acoustic_fem.calibration.fitted_model import Posterior, UpdatedModel
from acoustic_fem.calibration.model_updating import Update, update
from acoustic_fem.sound.estimate import TransferEstimate
from geometry import Kind
from localize.recalibration.accuracy_to_expect import expected_accuracy, is_enough, least_known
from localize.signals.array_response import response_of

NOISE = 1e-3
DESIGN = geometry.prototype("array-2x6").with_values({"lines.0.points": 24, "layout.columns": 12})


@pytest.fixture(scope="module")
def model() -> UpdatedModel:
    return UpdatedModel(acoustic_fem.solve(DESIGN, np.linspace(1.0, 100.0, 20), "lumped"))


def fitted(model: UpdatedModel, u: np.ndarray, points: tuple[int, ...]) -> Update:
    h = model.transfer_function(u[None])[0]
    deviation = 0.002 * np.abs(h) + 1e-5
    one = np.ones(h.shape[1:])
    return update(model, {n: TransferEstimate(h[n - 1], deviation[n - 1], one, 60) for n in points})


def test_the_accuracy_to_expect_is_that_of_sensors_of_the_family(model: UpdatedModel) -> None:
    nothing = Posterior.of(model, np.zeros(model.count), np.zeros((model.count, model.count)))
    blind = expected_accuracy(nothing, NOISE)
    response = response_of(model.library)
    decoder = localize.BayesDecoder(response, NOISE)
    made = model.transfer_function(np.random.default_rng(7).standard_normal((40, model.count)))
    came = [
        localize.evaluate(decoder, replace(response, transfer_function=h), 3, NOISE, seed=1).top1 for h in made
    ]  # fmt: skip
    error = np.hypot(blind.std() / np.sqrt(len(blind)), np.std(came) / np.sqrt(len(came)))
    assert error < 0.07
    assert blind.mean() == pytest.approx(np.mean(came), abs=3 * error)
    assert blind.mean() < 0.9
    assert (np.diff(blind) >= 0).all()
    assert len(np.unique(blind)) > 5


def test_more_points_promise_more_and_the_point_farthest_from_them_is_the_least_known(model: UpdatedModel) -> None:
    u = np.random.default_rng(3).standard_normal(model.count)
    one, three = fitted(model, u, (2,)), fitted(model, u, (2, 12, 22))
    low = [expected_accuracy(fit, NOISE)[0] for fit in (one, three)]
    assert low[0] < low[1]
    assert low[1] > 0.9
    assert least_known(one) > 8
    sure = np.ones(20)
    assert (is_enough(one, sure), is_enough(three, sure), is_enough(three, sure - 0.06)) == (False, True, False)


def test_frequencies_that_do_not_reach_100_hz_are_refused() -> None:
    model = UpdatedModel(acoustic_fem.solve(DESIGN, np.linspace(1.0, 60.0, 8), "lumped"))
    posterior = Posterior.of(model, np.zeros(model.count), np.zeros((model.count, model.count)))
    with refused(Kind.OUT_OF_RANGE, "frequency"):
        expected_accuracy(posterior, NOISE)
