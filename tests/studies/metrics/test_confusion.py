"""Predicted confusion: limits, exactness of what it simulates, agreement with the decoder of whole covariances."""

from __future__ import annotations

import numpy as np
import pytest
import torch
from rc_line import rc_line
from refusals import refused

import localize
from geometry import Kind
from localize.signals import stimulus
from localize.signals.propagation import microphone_signals
from studies.metrics import confusion, filtered_touches
from studies.metrics.confusion import POWERS, predict_confusion, predict_confusions
from studies.metrics.filtered_touches import noise_of_filters

GRID = np.linspace(1.0, 100.0, 40)


def line(points: int, spread: float = 1.0) -> np.ndarray:
    return rc_line(points, GRID, spread).transfer_function[None]


@pytest.mark.slow
@pytest.mark.parametrize("listener", ["network", "model"])
def test_quiet_and_far_apart_is_never_confused_and_drowned_in_noise_is_chance(listener: str) -> None:
    quiet = predict_confusion(line(4), GRID, 1e-4, listener=listener)
    assert quiet.top1[0] > 0.98
    drowned = predict_confusion(line(4), GRID, 300.0, listener=listener, touches=500)
    assert drowned.top1[0] == pytest.approx(0.25, abs=4 * np.sqrt(0.25 * 0.75 / 2000))
    assert drowned.pairwise[0][0, 1] == pytest.approx(0.5, abs=0.08)


def test_points_that_are_alike_are_confused_half_the_time() -> None:
    h = line(3)
    h[:, 1] = h[:, 0]
    found = predict_confusion(h, GRID, 1e-3)
    assert found.pairwise[0, 0, 1] == 0.5
    assert found.confusion[0, 1, 1] == 0.0  # of two equal likelihoods the first is named


def test_shares_add_up_and_the_pairs_are_symmetric() -> None:
    found = predict_confusion(line(6), GRID, 0.05)
    assert np.allclose(found.confusion.sum(axis=2), 1)
    assert np.array_equal(found.pairwise, found.pairwise.swapaxes(1, 2))
    assert found.top1[0] == pytest.approx(np.trace(found.confusion[0]) / 6)
    # neighbours are harder than the two ends
    assert found.pairwise[0, 0, 1] > found.pairwise[0, 0, 5]


def test_a_design_has_the_same_prediction_in_any_batch() -> None:
    batch = np.concatenate([line(5, spread) for spread in (0.5, 1.0, 2.0)])
    together = predict_confusion(batch, GRID, 0.02).confusion
    for k in range(3):
        assert np.array_equal(predict_confusion(batch[k : k + 1], GRID, 0.02).confusion[0], together[k])


def test_touches_in_parts_are_all_touches_once() -> None:
    h = line(5)
    whole = predict_confusion(h, GRID, 0.1, assumed=h)
    parts = predict_confusion(np.repeat(h, 4, 0), GRID, 0.1, assumed=h, parts=4)
    assert parts.touches == whole.touches // 4
    assert parts.confusion.mean(0) == pytest.approx(whole.confusion[0], abs=1e-12)
    assert not np.array_equal(parts.confusion[0], parts.confusion[1])


def test_noises_predicted_together_are_those_of_each_alone() -> None:
    batch = np.concatenate([line(5, spread) for spread in (0.5, 1.0, 2.0)])
    noises = 0.003, np.full((3, 500), 0.05**2 / 500), 0.2
    for noise, found in zip(noises, predict_confusions(batch, GRID, noises), strict=True):
        alone = predict_confusion(batch, GRID, noise)
        assert np.array_equal(found.confusion, alone.confusion)
        assert np.array_equal(found.pairwise, alone.pairwise)


def test_points_taken_one_by_one_are_predicted_as_all_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    batch = np.concatenate([line(5, spread) for spread in (0.5, 1.0, 2.0)])
    noises = 0.003, np.full((3, 500), 0.05**2 / 500) * np.array([[1.0], [2.0], [3.0]])
    whole = [predict_confusions(batch, GRID, noises, assumed=each) for each in (None, batch[:2])]
    monkeypatch.setattr(confusion, "_MEMORY", 1)
    for assumed, expected in zip((None, batch[:2]), whole, strict=True):
        for one, other in zip(predict_confusions(batch, GRID, noises, assumed=assumed), expected, strict=True):
            assert np.array_equal(one.confusion, other.confusion)
            assert np.array_equal(one.pairwise, other.pairwise)


def test_three_microphones_are_scored_by_their_likelihood() -> None:
    """Against determinants and inverses of each covariance, touch by touch."""
    late = line(4) ** 1.7
    h = np.concatenate([line(4), late[:, :, :1]], axis=2)
    noise, touches = 0.3, 8
    found = predict_confusion(h, GRID, noise, touches=touches)
    touches_filtered = filtered_touches.touch_filter(GRID.tobytes(), "network", touches, 0)
    scale = np.sqrt(noise_of_filters(noise, 1, "network")[0])
    parts = touches_filtered.frames(h)[0] / scale[:, None] + filtered_touches.standard_noise(
        4, 3, "network", touches, 0
    )
    x = np.moveaxis(parts[:, :, 0] + 1j * parts[:, :, 1], 1, -1)  # (point, filter, touch, microphone)
    own = np.moveaxis(touches_filtered.covariance(h)[0], -1, 1) / scale[:, None, None] ** 2
    score = np.full((4, touches, 4), -np.inf)
    for power in POWERS:
        s = np.eye(3) + power * own  # (hypothesis, filter, microphone, microphone)
        solved = np.einsum("pfta,hfab,pftb->pth", x.conj(), np.linalg.inv(s), x).real
        score = np.maximum(score, -solved - np.linalg.slogdet(s)[1].sum(axis=1))
    named = score.argmax(axis=-1)
    assert 0.3 < found.top1[0] < 1
    assert np.array_equal(found.confusion[0], (named[:, :, None] == np.arange(4)).mean(axis=1))


def test_more_noise_is_never_better() -> None:
    shares = [float(predict_confusion(line(8), GRID, noise).top1[0]) for noise in (0.003, 0.01, 0.03, 0.1, 0.3)]
    assert shares == sorted(shares, reverse=True)
    assert shares[0] - shares[-1] > 0.3


@pytest.mark.parametrize("listener", ["network", "model"])
def test_simulated_frames_are_the_filtered_signals_of_the_localizer(listener: str) -> None:
    response = rc_line(3, GRID)
    touches_filtered = filtered_touches.touch_filter(GRID.tobytes(), listener, 5, 7)
    parts = touches_filtered.frames(response.transfer_function[None])[0]
    frames = (parts[:, :, 0] + 1j * parts[:, :, 1]).swapaxes(-1, -2)
    lines = stimulus.lines_within((1.0, 100.0))
    spectrum = stimulus.multi_sines(7, "evaluation", 0, 5, (1.0, 100.0)).spectrum[:, : lines.stop]
    for point in range(3):
        h = np.zeros((2, lines.stop), np.complex64)
        h[:, lines] = response.at(stimulus.line_frequencies()[lines])[point]
        signal = microphone_signals(spectrum, torch.from_numpy(h)[None].expand(5, -1, -1), 250).double().numpy()
        expected = np.moveaxis(signal @ filtered_touches.filters_of(listener).T, 0, 1)
        assert np.abs(frames[point] - expected).max() < 1e-5 * np.abs(expected).max()


def test_white_noise_behind_a_filter_is_its_energy() -> None:
    power = noise_of_filters(0.2, 1, "model")[0]
    energy = (np.abs(filtered_touches.filters_of("model")) ** 2).sum(axis=1)
    assert power[2:] == pytest.approx(0.2**2 * energy[2:], rel=0.01, abs=0)


def test_the_covariance_is_that_of_many_flat_touches() -> None:
    """Against simulated sources of flat spectrum, seen through one microphone pair."""
    h = rc_line(2, GRID).transfer_function[None]
    covariance = np.moveaxis(filtered_touches.touch_filter(GRID.tobytes(), "model", 4, 0).covariance(h)[0, 0], -1, 0)
    random = np.random.default_rng(0)
    frequency = np.arange(1.0, 100.01, 0.25)
    at = rc_line(2, GRID).at(frequency)[0]
    count = 4000
    phase = np.exp(2j * np.pi * random.random((count, len(frequency))))
    amplitude = 0.25 * np.sqrt(1 / len(frequency) / 2)
    wave = np.exp(2j * np.pi * frequency[:, None] * np.arange(250) / 1000)
    signal = 2 * amplitude * np.einsum("nl,ml,lt->nmt", phase, at, wave, optimize=True).real
    x = signal @ filtered_touches.filters_of("model").T
    expected = np.einsum("nak,nbk->kab", x, x.conj()) / count
    middle = slice(3, 22)
    assert np.abs(covariance[middle] / expected[middle] - 1).max() < 0.12


@pytest.mark.parametrize("noise", [0.01, 0.05, 0.2])
def test_the_model_listener_follows_the_bayes_decoder(noise: float) -> None:
    response = rc_line(8, GRID)
    decoder = localize.evaluate(localize.BayesDecoder(response, noise), response, 100, noise).top1
    predicted = predict_confusion(line(8), GRID, noise, listener="model", touches=200).top1[0]
    assert predicted == pytest.approx(decoder, abs=0.12)
    assert predicted < decoder + 0.03  # it knows less
    network = predict_confusion(line(8), GRID, noise, touches=200).top1[0]
    assert network < predicted + 0.01


def test_who_goes_by_another_sensor_does_worse_and_who_knows_the_scatter_less_so() -> None:
    sensor = line(6, 1.5)
    own = predict_confusion(sensor, GRID, 3e-3).top1[0]
    wrong = predict_confusion(sensor, GRID, 3e-3, assumed=line(6)).top1[0]
    scatter = np.concatenate([line(6, spread) for spread in (0.7, 1.0, 1.45)])
    knowing = predict_confusion(sensor, GRID, 3e-3, assumed=scatter).top1[0]
    assert wrong < knowing - 0.05
    assert knowing <= own + 0.02
    assert predict_confusion(sensor, GRID, 3e-3, assumed=sensor).top1[0] == own


def test_noise_may_differ_from_design_to_design() -> None:
    both = np.concatenate([line(6), line(6)])
    power = np.stack([np.full(500, rms**2 / 500) for rms in (0.003, 0.3)])
    found = predict_confusion(both, GRID, power).top1
    alone = [predict_confusion(line(6), GRID, rms).top1[0] for rms in (0.003, 0.3)]
    assert found == pytest.approx(alone)


@pytest.mark.parametrize(
    ("name", "value", "kind"),
    [
        ("transfer_function", line(3)[0], Kind.WRONG_TYPE),
        ("transfer_function", line(3)[:, :1], Kind.UNSUITABLE),
        ("transfer_function", line(3)[:, :, :1], Kind.UNSUITABLE),
        ("transfer_function", line(3) * np.nan, Kind.UNSUITABLE),
        ("frequency", np.linspace(2, 100, 40), Kind.UNSUITABLE),
        ("microphone_noise", 0.0, Kind.OUT_OF_RANGE),
        ("microphone_noise", -1.0, Kind.OUT_OF_RANGE),
        ("microphone_noise", np.ones((2, 500)), Kind.WRONG_TYPE),
        ("listener", "ear", Kind.OUT_OF_RANGE),
        ("assumed", line(4), Kind.WRONG_TYPE),
        ("parts", 65, Kind.OUT_OF_RANGE),
        ("touches", 0, Kind.OUT_OF_RANGE),
    ],
)
def test_bad_input_is_refused_by_name(name: str, value: object, kind: Kind) -> None:
    given: dict = {"transfer_function": line(3), "frequency": GRID, "microphone_noise": 0.01, name: value}
    with refused(kind, name):
        predict_confusion(
            given.pop("transfer_function"), given.pop("frequency"), given.pop("microphone_noise"), **given
        )
