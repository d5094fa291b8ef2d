"""Deviations that a frame is fitted with, against the integral over them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import trapezoid
from scipy.special import logsumexp

import acoustic_fem
import geometry
import localize
from localize.decoders.decoder_options import TolerantOptions
from localize.decoders.deviations import DeviatingTables
from localize.decoders.frame_covariance import DEVIATING, SAMPLES, joint_whitening, touch_covariances
from localize.decoders.hypotheses import Hypotheses
from localize.decoders.likelihood import assumed_noise, vertex
from localize.signals.array_response import ArrayResponse, response_of

GRID = np.arange(1.0, 201.0)
NOISE = 1e-3
OPTIONS = TolerantOptions(relative_temperature=3.0)
AMPLITUDES = np.linspace(-5, 5, 201)
pytestmark = [pytest.mark.physics, pytest.mark.filterwarnings("ignore:.*its library ends at 200 Hz")]


@pytest.fixture(scope="module")
def response() -> ArrayResponse:
    design = geometry.prototype("array-2x6").with_values({"lines.0.points": 4})
    return response_of(acoustic_fem.solve(design, GRID, "lumped"))


def shape(frequency: np.ndarray) -> np.ndarray:
    """2 % and 1 degree at the second microphone, falling with frequency; (n_microphone, n_freq)."""
    return np.stack([np.zeros(len(frequency)), (0.02 + 0.017j) / (1 + frequency / 50)])


def deviating(response: ArrayResponse, amplitude: float) -> ArrayResponse:
    return replace(
        response,
        transfer_function=response.transfer_function * np.exp(amplitude * shape(GRID)),
        ambient_response=None,
        vent_ratio=None,
    )


def tables(response: ArrayResponse) -> tuple[DeviatingTables, np.ndarray]:
    whiten = joint_whitening(response, assumed_noise(NOISE, OPTIONS), None)
    shapes = np.broadcast_to(shape(DEVIATING), (1, 1, 4, 2, len(DEVIATING))).astype(np.complex64)
    hypotheses = Hypotheses((response,), shapes, np.zeros((4, 1)))
    decoder = localize.BayesDecoder(response, NOISE)
    return DeviatingTables(decoder.tables[0], hypotheses, whiten, OPTIONS), whiten


#: Point that the first touch of the generator is at, from 0.
POINT = 0


@pytest.fixture(scope="module")
def waves_of_deviations(response: ArrayResponse) -> list[tuple[np.ndarray, np.ndarray]]:
    """Eigenvalues and vectors of the whitened covariance of a touch at each of the amplitudes."""
    whiten = tables(response)[1]
    of_point = (touch_covariances(deviating(response, float(each)), np.eye(SAMPLES))[POINT] for each in AMPLITUDES)
    return [np.linalg.eigh(whiten @ touched @ whiten.T) for touched in of_point]


@pytest.mark.parametrize("true", [-1.5, 0.0, 1.0])
def test_the_gain_is_that_of_the_integral_over_the_deviation(
    response: ArrayResponse, waves_of_deviations: list[tuple[np.ndarray, np.ndarray]], true: float
) -> None:
    deviations, _ = tables(response)
    touch = localize.TouchGenerator(deviating(response, true), 0, "evaluation", NOISE).samples(0, 4)
    point = int(touch.point[0]) - 1
    x = touch.signals[0, :, -250:].numpy().reshape(1, -1) @ deviations.tables.reduce
    temperature = OPTIONS.relative_temperature * OPTIONS.temperature
    size = 2 * SAMPLES
    each = []
    assert point == POINT
    for amplitude, (values, vectors) in zip(AMPLITUDES, waves_of_deviations, strict=True):
        gain = np.clip(values, 0, None)[:, None] * OPTIONS.tried_powers
        fit = -0.5 * ((x @ vectors) ** 2 @ (1 / (1 + gain)) + np.log1p(gain).sum(0))
        each.append(vertex(fit)[0] / temperature - amplitude**2 / 2)
    log_integral = logsumexp(each) + np.log(trapezoid(np.ones(201), AMPLITUDES) / 200) - np.log(2 * np.pi) / 2
    # The tables leave out what is common to all points: the power of the frame.
    found = deviations.scores(x.reshape(1, 1, size), np.array([point]))[0, 0] - (x**2).sum() / 2 / temperature
    without = max(each[100], -np.inf)
    assert found == pytest.approx(log_integral, abs=0.1 + 0.02 * abs(log_integral - without))
    if true:
        assert log_integral - without > 5


def test_frames_of_one_recording_share_their_deviations(response: ArrayResponse) -> None:
    deviations, _ = tables(response)
    touch = localize.TouchGenerator(deviating(response, 1.0), 0, "evaluation", NOISE).samples(0, 1)
    frames = np.stack([touch.signals[0, :, k : k + 250].numpy().ravel() for k in (250, 500, 750)])
    x = (frames @ deviations.tables.reduce)[None]
    point = int(touch.point[0]) - 1
    together = deviations.scores(x, np.array([point]))[0, 0]
    apart = sum(deviations.scores(x[:, [k]], np.array([point]))[0, 0] for k in range(3))
    # Each frame of its own pays anew for the deviation that it needs.
    assert together > apart


def test_tables_that_are_made_when_they_are_needed_are_the_same(response: ArrayResponse) -> None:
    eager, whiten = tables(response)
    later = DeviatingTables(eager.tables, eager._hypotheses, whiten, OPTIONS, at_once=False)
    x = np.random.default_rng(0).standard_normal((2, 1, eager.size))
    for chosen in (np.array([2, 0]), np.array([1, 2, 3])):
        assert np.array_equal(later.scores(x, chosen), eager.scores(x, chosen))
