"""The network of hypotheses: its features are the likelihoods that they are called after, and it locates fingers."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from rc_line import rc_line
from refusals import refused

import geometry
import localize
from acoustic_fem import solve
from geometry import Kind
from localize.learned.hypothesis_features import SHARES, UNEXPLAINED
from localize.learned.hypothesis_network import HypothesisClassifier, HypothesisShape
from localize.learned.training_plan import TrainingPlan
from localize.signals.array_response import response_of
from localize.signals.stimulus_kinds import STIMULI

SHORT = TrainingPlan(seconds_per_point=50, epochs=2, as_built=60)


@pytest.fixture(scope="module")
def library():
    return solve(geometry.prototype("array-2x6"), "1:500:500", fidelity="lumped")


@pytest.fixture(scope="module")
def decoder(library):
    return localize.TolerantDecoder(library)


@pytest.fixture(scope="module")
def classifier(decoder):
    made = HypothesisClassifier(HypothesisShape.of(decoder, 3))
    made.take(decoder)
    return made.eval()


def test_features_are_the_likelihoods_of_a_gaussian_with_deviations(decoder, classifier):
    """Against dense matrices in double precision: r^T (s^2 + G G^T)^-1 r and the determinant, table by table."""
    touches = localize.TouchGenerator(decoder.response, 5, "evaluation", stimuli=STIMULI["tap-strokes"]).samples(0, 4)
    frames = touches.signals[..., -250:]
    found = classifier.features._features(frames).flatten(1, 2).numpy()
    tables, deviating = decoder.tables[0], decoder.deviating[0]
    size, rank = tables.vectors.shape[1:]
    white = frames.double().flatten(1).numpy() @ tables.reduce
    energy = (white**2).mean(1)
    unit = white / np.sqrt(energy)[:, None]
    heard = -tables.options.temperature * tables.weight[:, :, np.argmin(abs(tables.options.tried_powers - 1))]
    power = heard / (1 - heard)
    expected = np.zeros((4, len(tables.vectors), 2, len(SHARES)))
    for table, vectors in enumerate(tables.vectors):
        beside = deviating.beside[table]
        source = (unit @ vectors) / (UNEXPLAINED / size * power[table].sum() + power[table])
        shapes = deviating.changes[table].reshape(-1, size, rank)[:3, rank:]
        change = np.einsum("kir,nr->nik", shapes, source)
        rest = unit @ beside
        for frame in range(4):
            for k, share in enumerate(SHARES):
                noise = share + 1 / energy[frame]
                covariance = noise * np.eye(size - rank) + change[frame] @ change[frame].T
                expected[frame, table, 0, k] = np.log1p(rest[frame] @ np.linalg.solve(covariance, rest[frame]))
                expected[frame, table, 1, k] = np.linalg.slogdet(covariance / noise)[1]
    expected -= expected.min(1, keepdims=True)
    assert np.abs(found[..., :7] - expected[:, :, 0]).max() < 0.03
    assert np.abs(found[..., 7:14] - expected[:, :, 1]).max() < 0.03


def test_before_any_training_it_names_most_touches_on_the_design(decoder):
    touches = localize.TouchGenerator(decoder.response, 6, "evaluation", stimuli=STIMULI["slide-strokes"])
    made = touches.samples(0, 240)
    frames = made.signals[..., -250:]
    untrained = HypothesisClassifier(HypothesisShape.of(decoder, 3))
    untrained.take(decoder)
    untrained.fit_normalisation(frames)
    with torch.no_grad():
        named = untrained(frames).argmax(1) + 1
    assert (named == made.point).double().mean() > 0.8  # of a touch in twelve by chance


def test_a_common_gain_changes_nothing_while_the_noise_is_small(classifier):
    frames = torch.randn(3, 2, 250, generator=torch.Generator().manual_seed(1))
    one, louder = (classifier.features(gain * frames)[..., :-2] for gain in (10.0, 20.0))
    assert torch.allclose(one, louder, atol=0.02)


def test_a_frame_of_zeros_says_nothing_of_any_point(classifier):
    features = classifier.features(torch.zeros(2, 2, 250))
    assert torch.isfinite(features).all()


def test_frames_taken_together_are_those_taken_one_by_one(classifier):
    frames = torch.randn(9, 2, 250, generator=torch.Generator().manual_seed(2))
    one_by_one = torch.cat([classifier.features(frame[None]) for frame in frames])
    assert torch.allclose(classifier.features(frames), one_by_one, atol=1e-3)


def test_a_bare_array_has_one_hypothesis_of_each_point_and_is_learnt():
    trained = localize.train(rc_line(4), replace(SHORT, microphone_noise=1e-3))
    assert (trained.shape.hypotheses, trained.shape.shapes) == (1, 0)
    assert trained.training["sensors"] == 1
    assert trained.training["held_out_accuracy"][-1] > 0.8


@pytest.mark.slow
def test_a_library_of_a_design_is_trained_on_as_built_sensors_and_saved(library, tmp_path):
    trained = localize.train(library, SHORT)
    assert trained.training["sensors"] == 48  # a fifth is held out
    assert trained.training["held_out_accuracy"][-1] > 0.85
    assert 0.25 <= float(trained.classifier.temperature) <= 4.0
    trained.save(tmp_path)
    signals = localize.TouchGenerator(response_of(library), 8, "evaluation").samples(0, 12).signals
    assert (localize.load_localizer(tmp_path).locate(signals) == trained.locate(signals)).all()
    alone = localize.train(library, replace(SHORT, as_built=0, epochs=1))
    assert alone.training["sensors"] == 1


@pytest.mark.slow
def test_maps_that_are_kept_train_the_same_network_as_maps_made_again(library, monkeypatch):
    """Kept ones are in half precision: the accuracy is the same, not the weights."""
    from localize.learned import training

    kept = localize.train(library, SHORT)
    monkeypatch.setattr(training, "KEPT_BYTES", 0)
    again = localize.train(library, SHORT)
    assert again.training["held_out_accuracy"][-1] == pytest.approx(kept.training["held_out_accuracy"][-1], abs=0.03)


@pytest.mark.parametrize(
    ("field", "value"), [("points", 1), ("hypotheses", 0), ("microphones", 1), ("size", 10), ("shapes", -1)]
)
def test_sizes_that_do_not_go_together_are_refused(field, value):
    sizes = {"points": 4, "hypotheses": 2, "microphones": 2, "size": 100, "rank": 20, "shapes": 3, "width": 8}
    with refused(Kind.OUT_OF_RANGE, f"network.{field}", value):
        HypothesisShape(**{**sizes, field: value})
