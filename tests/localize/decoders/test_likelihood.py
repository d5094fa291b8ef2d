"""What decoders spare themselves leaves no trace: bounds hold, and probabilities are those of the formulas alone."""

from __future__ import annotations

import numpy as np
import pytest

import acoustic_fem
import geometry
import localize
from benchmarks.plain_decoding import PlainBayes, PlainTolerant
from localize.decoders.decoder_options import DecoderOptions
from localize.decoders.likelihood import Bounds, Screen
from localize.signals.array_response import response_of
from localize.signals.finger_stimuli import taps

pytestmark = pytest.mark.filterwarnings("ignore:.*its library ends at 200 Hz")
NOISE = 1e-3


@pytest.fixture(scope="module")
def library() -> acoustic_fem.Library:
    return acoustic_fem.solve(geometry.prototype("array-2x6"), np.arange(1.0, 201.0), "lumped")


def heard(library: acoustic_fem.Library) -> np.ndarray:
    """Frames, loud, ordinary and quiet ones: sums of sines, taps, and noise alone."""
    made = [
        localize.TouchGenerator(response_of(library), 0, "evaluation", NOISE, **kind).samples(0, 24).signals.numpy()
        for kind in ({}, {"stimuli": taps})
    ]
    touches = np.concatenate([each[..., 250:500] for each in made]).astype(np.float64)
    noise = NOISE * np.random.default_rng(0).standard_normal((4, *touches.shape[1:]))
    return np.concatenate([touches, 100 * touches[:24], noise])


@pytest.fixture(scope="module")
def frames(library: acoustic_fem.Library) -> np.ndarray:
    return heard(library)


@pytest.fixture
def bounded(library: acoustic_fem.Library) -> localize.BayesDecoder:
    """A decoder that scores no more points than it must, as those of large arrays."""
    return localize.BayesDecoder(library, NOISE, options=DecoderOptions(exact_numbers=0.0))


def test_no_score_is_above_its_bound(bounded: localize.BayesDecoder, frames: np.ndarray) -> None:
    (tables,) = bounded.tables
    x = frames.reshape(len(frames), -1) @ tables.reduce
    exact = tables.scores(x)
    bound = Bounds(tables)(x)
    assert (bound >= exact).all()
    loud = slice(48, 72)  # of these it tells something
    assert (bound[loud] < exact[loud].max(1, keepdims=True) - DecoderOptions.far_lead).mean() > 0.5


def test_points_that_are_not_scored_leave_no_trace(
    bounded: localize.BayesDecoder, frames: np.ndarray, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain = PlainBayes(bounded)
    expected = np.stack([plain.locate(frame) for frame in frames])
    scored: list[int] = []
    exact = Screen.exact
    monkeypatch.setattr(Screen, "exact", lambda own, x, chosen: (scored.append(chosen.sum()), exact(own, x, chosen))[1])
    alone = np.stack([bounded.locate(frame) for frame in frames])
    assert 0 < sum(scored) < 0.5 * expected.size
    for found in (alone, bounded.locate(frames)):
        assert found == pytest.approx(expected, abs=1e-9)
        # The first three are in their order however far behind they are.
        best = np.argsort(-expected, axis=1)[:, : DecoderOptions.leading_points]
        assert (np.diff(np.take_along_axis(found, best, 1)) <= 0).all()


def test_a_point_far_behind_in_one_frame_is_no_better_in_the_next(
    bounded: localize.BayesDecoder, frames: np.ndarray
) -> None:
    # Of frames that speak for different points: what is far behind in one counts in full with the other.
    both = np.concatenate([frames[:12], frames[12:24]], axis=2)
    joint = bounded.log_probability(both)
    assert bounded.locate(both) == pytest.approx(np.exp(joint), abs=1e-9)


@pytest.mark.slow
def test_the_tolerant_decoder_gives_what_its_formulas_give() -> None:
    design = geometry.prototype("array-2x6").with_values({"lines.0.points": 4})
    library = acoustic_fem.solve(design, np.arange(1.0, 201.0), "lumped")
    decoder, frames = localize.TolerantDecoder(library, microphone_noise=NOISE), heard(library)
    plain = PlainTolerant(decoder, response_of(library))
    expected = np.stack([plain.locate(frame) for frame in frames])
    difference = np.abs(np.stack([decoder.locate(frame) for frame in frames]) - expected).max(1)
    assert difference[np.r_[:24, 48:72]].max() < 1e-6
    assert difference.max() < 1e-4  # quiet ones, in single precision
    assert np.abs(decoder.locate(frames) - expected).max() < 1e-4
