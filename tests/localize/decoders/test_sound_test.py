"""Sound of a room is told from touches, in batches and in a stream; what no point explains is told too."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import torch
from rc_line import rc_line
from refusals import refused

import acoustic_fem
import geometry
import localize
from geometry import Kind, Refusal
from localize import Decision, SoundTest, TouchStream
from localize.live import AS_IT_COMES
from localize.signals.array_response import response_of
from localize.signals.stimulus import multi_sines

NOISE = 1e-3


@pytest.fixture(scope="module")
def array():
    return response_of(acoustic_fem.solve(geometry.prototype("array-2x6"), np.arange(1.0, 201.0), "lumped"))


@pytest.fixture(scope="module")
def sound_test(array):
    return SoundTest(array, NOISE)


@pytest.fixture(scope="module")
def decoder(array):
    return localize.BayesDecoder(array, NOISE)


def nothing(*sample):
    made = multi_sines(*sample)
    return replace(made, spectrum=torch.zeros_like(made.spectrum))


class Unaware(localize.Locator):
    """A locator that knows no noise."""

    def __init__(self, decoder):
        self.array, self.locate = replace(decoder.array, noise_rms=0.0), decoder.locate


def heard(array, level, count=240, seed=0, **other):
    """Signals of a second and the points touched; with ``stimuli=nothing`` none is."""
    ambient = None if level is None else (level, level)
    made = localize.TouchGenerator(array, seed, "evaluation", NOISE, ambient=ambient, **other).samples(0, count)
    return made.signals.double().numpy(), made.point.numpy() - 1


@pytest.mark.parametrize("level", [None, 40.0, 60.0, 80.0, 95.0])
@pytest.mark.parametrize("samples", [250, 1000])
def test_sound_leaves_no_more_than_noise_whatever_its_level(array, sound_test, level, samples):
    alone, _ = heard(array, level, 1200, stimuli=nothing)
    p_value = sound_test.p_value(alone[..., :samples])
    assert p_value.mean() == pytest.approx(0.5, abs=0.04)
    assert (p_value < 0.05).mean() == pytest.approx(0.05, abs=0.025)
    assert sound_test.is_sound(alone[..., :samples]).all()


@pytest.mark.parametrize(("level", "kept"), [(None, 0.995), (60.0, 0.99), (80.0, 0.95)])
def test_touches_are_no_sound(array, sound_test, level, kept):
    signals, _ = heard(array, level)
    assert (~sound_test.is_sound(signals[..., -250:])).mean() >= kept


def test_microphones_a_little_apart_leave_sound_what_it_is(array, sound_test):
    apart = replace(array, ambient_response=array.ambient_response * np.array([[1.025], [0.975]]))
    signals, _ = heard(apart, 80.0, 120, stimuli=nothing)
    assert (sound_test.p_value(signals) < 1e-9).all()
    assert sound_test.is_sound(signals).all()


def test_a_stream_tells_sound_from_a_touch_in_it(array, sound_test, decoder):
    noise, _ = heard(array, 60.0, 12, stimuli=nothing)
    touched, points = heard(array, 60.0, 12)
    turn = int(np.argmax(touched.std(-1).max(-1)))
    # The sound of a sample repeats after its second.
    samples = np.concatenate([*[noise[turn]] * 3, touched[turn], *[noise[turn]] * 3], axis=1)
    as_it_comes = TouchStream(decoder, options=AS_IT_COMES)
    assert {event.state for event in as_it_comes.push(samples)} == {"touch"}  # sound taken for touches
    events = TouchStream(localize.BayesDecoder(array, NOISE, 60.0), sound_test=sound_test).push(samples)
    within = [e for e in events if isinstance(e, Decision) and 3.3 < e.time < 4.0]
    outside = [e for e in events if isinstance(e, Decision) and (e.time < 3.0 or e.time > 4.3)]
    assert {event.state for event in outside if event.time < 3.0} == {"sound"}
    assert {event.state for event in outside} <= {"sound", "fading"}
    assert all(event.point is None and "point" not in event.json_line() for event in outside)
    assert np.mean([event.point == points[turn] + 1 for event in within]) > 0.9
    assert [touch.point for touch in localize.touches_of(events, decoder)] == [points[turn] + 1]


def test_a_touch_is_none_the_less_one_where_the_locator_knows_no_noise(array, sound_test, decoder):
    signals, points = heard(array, None, 20)
    unaware = Unaware(decoder)
    turn = int(np.argmax(signals.std(-1).max(-1)))
    events = TouchStream(unaware, sound_test=sound_test).push(signals[turn])
    named = [event.point for event in events if event.state == "touch"]
    assert len(named) > 30
    assert np.mean(np.array(named) == points[turn] + 1) > 0.9


@pytest.mark.slow
def test_a_stream_names_no_point_for_two_touches_at_once(array, decoder):
    signals, _ = heard(array, None, 240)
    both = signals[:120] + np.roll(signals[:120], 5, 0)
    residuals = localize.ResidualTest(array, NOISE)
    options = replace(AS_IT_COMES, rejected_fraction=1e-4)
    rejected, named = (
        [
            event.state
            for each in some
            for event in TouchStream(decoder, residual_test=residuals, options=options).push(each)
            if isinstance(event, Decision)
        ]
        for some in (both[:20], signals[:20])
    )
    assert rejected.count("other") > 0.95 * len(rejected)
    assert named.count("touch") > 0.98 * len(named)


def test_sound_passes_the_residual_test_where_it_is_expected(array, decoder):
    signals, point = heard(array, 60.0)
    frames = signals[..., -250:]
    assert (localize.ResidualTest(array, NOISE).p_value(frames, point + 1) < 1e-6).mean() > 0.9
    assert (localize.ResidualTest(array, NOISE, ambient=70.0).p_value(frames, point + 1) < 0.01).mean() < 0.03


def test_bad_arguments_are_refused(array, sound_test, decoder):
    with refused(Kind.OUT_OF_RANGE, "loudest_sound_db", 200.0):
        SoundTest(array, NOISE, 200.0)
    with refused(Kind.UNSUITABLE, "loudest_sound_db"):
        SoundTest(rc_line(4), NOISE)
    with refused(Kind.CONFLICT, "loudest_sound_db", 140.0):
        SoundTest(array, 1e-9, 140.0)
    with refused(Kind.MISMATCH, "sound_test"):
        TouchStream(localize.BayesDecoder(rc_line(4), NOISE), sound_test=sound_test)
    with refused(Kind.OUT_OF_RANGE, "rejected_fraction", 1.5):
        localize.StreamOptions(rejected_fraction=1.5)
    with pytest.raises(Refusal, match="3 channels"):
        sound_test.is_sound(np.ones((1, 3, 250)))
