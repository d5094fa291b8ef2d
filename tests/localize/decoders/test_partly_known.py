"""Frames of which a part is not known are decoded by the rest, exactly as the formulas of a Gaussian ask for."""

from __future__ import annotations

import numpy as np
import pytest
from rc_line import rc_line

import localize
from localize.decoders.decoder_options import DecoderOptions
from localize.decoders.frame_covariance import SAMPLES, touch_covariances
from localize.decoders.likelihood import GaussianTables
from localize.decoders.partly_known import known_directions

NOISE = 1e-3
#: No temperature, three powers of the touch, and all that it does.
OPTIONS = DecoderOptions(noise_fraction=1.0, powers=(-4.0, 4.0, 4.0), weakest_direction=1e-7)


@pytest.fixture(scope="module")
def decoder() -> localize.BayesDecoder:
    return localize.BayesDecoder(rc_line(4), NOISE, options=OPTIONS)


@pytest.fixture(scope="module")
def made() -> tuple[np.ndarray, np.ndarray]:
    """Frames of touches, (n, 2, 250) Pa, and their points."""
    samples = localize.TouchGenerator(rc_line(4), 1, "evaluation", NOISE).samples(0, 12)
    return samples.signals.numpy().astype(np.float64)[..., 250:500], samples.point.numpy()


def clipped_signals(first: int, count: int, apart: int = 1) -> np.ndarray:
    """Pulses at some samples of both microphones, with tails, 3 Pa."""
    time = np.arange(250)
    lag = time - first - apart * np.arange(count)[:, None]
    pulse = 3 * np.where(lag >= 0, np.exp(-np.maximum(lag, 0) / 40) + (lag == 0), 0.0)
    signals = np.zeros((2, count, 2, 250))
    signals[0, :, 0], signals[1, :, 1] = pulse, pulse
    return signals.reshape(-1, 2, 250)


def test_scores_are_those_of_a_gaussian_whose_unknown_part_may_have_any_size(
    decoder: localize.BayesDecoder, made: tuple[np.ndarray, np.ndarray]
) -> None:
    # Independent: the covariance of noise, touch and unknown signals in the reduced samples, inverted as it stands.
    unknown = clipped_signals(60, 8, apart=15)
    rest = decoder.without(unknown)
    assert rest is not None
    (tables,), (whiten,) = decoder.tables, decoder.likelihood.whitening
    noise = np.linalg.inv(whiten.T @ whiten)
    reduced = np.linalg.solve(whiten, tables.reduce.T)  # samples to reduced ones, as they are
    wild = reduced @ unknown.reshape(len(unknown), -1).T
    touched = touch_covariances(rc_line(4), np.eye(SAMPLES))
    frames = made[0][:4].reshape(4, -1) @ reduced.T / 30

    def difference(size: float) -> np.ndarray:
        scores = np.empty((4, 4))
        for point, covariance in enumerate(touched):
            best = []
            for power in OPTIONS.tried_powers:
                whole = noise + power * covariance + size**2 * wild @ wild.T
                sign, determinant = np.linalg.slogdet(whole)
                assert sign > 0
                energy = np.einsum("nk,nk->n", frames, np.linalg.solve(whole, frames.T).T)
                best.append(-0.5 * (energy + determinant))
            scores[:, point] = np.max(best, axis=0)
        return scores - scores[:, :1]

    # At the powers themselves: the decoder joins them by a parabola, which a single one at the end does not.
    (few,) = rest.tables
    x = made[0][:4].reshape(4, -1) @ few.reduce / 30
    plain = (-0.5 * ((x @ few.vectors) ** 2 @ few.weight + few.log_determinant[:, None, :])).max(-1).T
    assert plain - plain[:, :1] == pytest.approx(difference(10.0), abs=0.02)
    assert np.abs(difference(0.0) - difference(10.0)).max() > 1  # the unknown part would tell something


def test_what_is_not_known_changes_nothing(decoder: localize.BayesDecoder, made: tuple[np.ndarray, np.ndarray]) -> None:
    unknown = clipped_signals(100, 30)
    rest = decoder.without(unknown)
    assert rest is not None
    frames, points = made
    wrong = frames + np.einsum("nk,kmt->nmt", np.random.default_rng(0).normal(0, 3, (12, len(unknown))), unknown)
    assert rest.locate(wrong) == pytest.approx(rest.locate(frames), abs=1e-6)
    assert (rest.locate(wrong).argmax(1) + 1 == points).mean() > (decoder.locate(wrong).argmax(1) + 1 == points).mean()


def test_without_unknown_signals_nothing_changes(
    decoder: localize.BayesDecoder, made: tuple[np.ndarray, np.ndarray]
) -> None:
    same = decoder.without(np.zeros((1, 2, 250)))
    assert same is not None
    assert same.locate(made[0]) == pytest.approx(decoder.locate(made[0]), abs=1e-4)
    assert same.misfit(made[0]) == pytest.approx(decoder.misfit(made[0]), rel=1e-4)


def test_a_frame_of_which_nothing_is_left_has_no_decoder(decoder: localize.BayesDecoder) -> None:
    assert decoder.without(clipped_signals(0, 250)) is None
    assert not decoder.needs_whole_frames


def test_the_directions_that_are_left_are_those_beside_the_unknown_ones() -> None:
    random = np.random.default_rng(0)
    unknown = random.standard_normal((20, 3)) @ np.diag([5.0, 2.0, 1e-3])
    kept, left_out = known_directions(unknown)
    assert kept @ kept.T == pytest.approx(np.eye(18), abs=1e-12)
    assert np.abs(kept @ unknown[:, :2]).max() < 0.02
    assert left_out == pytest.approx(np.log(np.linalg.svd(unknown)[1][:2]).sum())
    # a Gaussian's tables take any number of directions
    assert GaussianTables.of(kept @ kept.T[None], OPTIONS).vectors.shape[1] == 18
