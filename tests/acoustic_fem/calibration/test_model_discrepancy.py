"""Trust in a model: residuals in its units are independent, by the dense covariance."""

from __future__ import annotations

import numpy as np
import pytest

from acoustic_fem.calibration.model_discrepancy import (
    COMMON,
    LEAST_NOISE,
    OF_MICROPHONE,
    OWN,
    SMOOTH,
    TOTAL,
    Discrepancy,
    draw,
)

FREQUENCY = np.array([1.0, 3.0, 10.0, 30.0, 60.0, 100.0])
SHAPE = (3, 2, 6)


@pytest.fixture
def about() -> np.ndarray:
    random = np.random.default_rng(0)
    return random.standard_normal(SHAPE) + 1j * random.standard_normal(SHAPE) + 2


def covariance(about: np.ndarray, noise: np.ndarray) -> np.ndarray:
    """Covariance of the real and of the imaginary part of relative residuals: entry by entry, as it is described."""
    smooth = np.exp(-(np.subtract.outer(np.log(FREQUENCY), np.log(FREQUENCY)) ** 2) / (2 * SMOOTH**2))
    points, microphones, _ = SHAPE
    same_point = np.kron(np.eye(points), np.ones((microphones, microphones)))
    same_microphone = np.kron(np.ones((points, points)), np.eye(microphones))
    shared = COMMON**2 + OF_MICROPHONE**2 * same_microphone + OWN**2 * same_point * same_microphone
    return np.kron(shared, smooth) / 2 + np.diag((noise / np.abs(about)).ravel() ** 2 + LEAST_NOISE**2)


def test_residuals_weigh_as_the_dense_covariance_does(about: np.ndarray) -> None:
    random = np.random.default_rng(1)
    noise = 0.003 * np.abs(about) * random.uniform(0.5, 2, SHAPE)
    difference = 0.01 * (random.standard_normal((2, *SHAPE)) + 1j * random.standard_normal((2, *SHAPE)))
    found = Discrepancy(FREQUENCY, about, noise).residuals(difference)
    inverse = np.linalg.inv(covariance(about, noise))
    relative = (difference / about).reshape(2, -1)
    wanted = relative.real @ inverse @ relative.real.T + relative.imag @ inverse @ relative.imag.T
    assert found.shape == (2, 72)
    assert np.allclose(found @ found.T, wanted, rtol=2e-3)


def test_what_is_drawn_has_that_covariance_and_total() -> None:
    drawn = draw(np.random.default_rng(2), FREQUENCY, (4000, *SHAPE[:2])).reshape(4000, -1)
    wanted = covariance(np.ones(SHAPE), np.zeros(SHAPE)) - LEAST_NOISE**2 * np.eye(36)
    assert np.allclose(drawn.real.T @ drawn.real / 4000, wanted, atol=0.1 * TOTAL**2)
    assert np.sqrt(np.mean(np.abs(drawn) ** 2)) == pytest.approx(TOTAL, rel=0.03)


def test_a_point_that_does_not_agree_stands_out(about: np.ndarray) -> None:
    noise = 0.003 * np.abs(about)
    random = np.random.default_rng(3)
    trusted = Discrepancy(FREQUENCY, about, noise)
    difference = about * draw(random, FREQUENCY, (1, *SHAPE[:2]))[0]
    difference += noise * (random.standard_normal(SHAPE) + 1j * random.standard_normal(SHAPE))
    assert trusted.by_point(difference).max() < 2
    difference[1] += 0.1 * about[1] * np.sin(FREQUENCY)
    assert trusted.by_point(difference).argmax() == 1
    assert trusted.by_point(difference)[1] > 10
