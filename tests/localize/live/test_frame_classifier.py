"""A microphone that is dead or clipped is told, and where two others are left they go on."""

from __future__ import annotations

import numpy as np
import pytest
from rings import triangle

import acoustic_fem
import localize
from localize import Decision, Fault, SoundTest, StreamOptions, TouchStream
from localize.signals import finger_stimuli
from localize.signals.array_response import response_of

NOISE = 1e-3


@pytest.fixture(scope="module")
def array():
    return response_of(acoustic_fem.solve(triangle(), np.arange(1.0, 201.0), "lumped"))


@pytest.fixture(scope="module")
def touches(array):
    """Ten taps, a second of silence before each, and their points."""
    made = localize.TouchGenerator(array, 5, "evaluation", 0.0, stimuli=finger_stimuli.taps).samples(0, 10)
    still = np.zeros((10, 3, 1000))
    samples = np.concatenate([still, made.signals.numpy()], axis=2).transpose(1, 0, 2).reshape(3, -1)
    return samples + NOISE * np.random.default_rng(1).standard_normal(samples.shape), made.point.numpy()


def listen(array, samples, fallback=True, limit=None):
    decoder = localize.BayesDecoder(array, NOISE)
    options = StreamOptions(fallback=fallback)
    events = TouchStream(decoder, limit=limit, sound_test=SoundTest(array, NOISE), options=options).push(samples)
    faults = {(event.kind, event.channel) for event in events if isinstance(event, Fault)}
    states = {event.state for event in events if isinstance(event, Decision)}
    return localize.touches_of(events, decoder), states, faults


def found(touches, points):
    """Whether a touch of each point was told in its second."""
    return [
        any(touch.point == point and 1.0 <= touch.start - 2 * turn < 2.0 for touch in touches)
        for turn, point in enumerate(points)
    ]


@pytest.mark.parametrize("channel", [0, 1, 2])
def test_a_dead_microphone_of_three_is_told_and_the_others_go_on(array, touches, channel):
    samples, points = touches
    samples = samples.copy()
    samples[channel] = 0.01
    told, states, faults = listen(array, samples)
    assert faults == {("dead channel", array.microphones[channel])}
    assert "unreadable" not in states
    assert np.mean(found(told, points)) >= 0.9


def test_no_stream_goes_on_without_a_fallback_or_with_one_microphone(array, touches):
    samples = touches[0][:, :2000].copy()
    samples[1] = 0.01
    assert listen(array, samples, fallback=False)[1] == {"unreadable"}
    samples[2] = 0.01
    assert listen(array, samples)[1] == {"unreadable"}


def test_a_clipped_microphone_is_left_out_while_it_is_clipped(array, touches):
    samples, points = touches
    samples = samples.copy()
    samples[2, 2050:2070] = 50.0
    told, states, faults = listen(array, samples, limit=50.0)
    assert faults == {("clipped", array.microphones[2])}
    assert "unreadable" not in states
    assert np.mean(found(told, points)) >= 0.9


@pytest.mark.parametrize("channel", [0, 2])
def test_a_hissing_microphone_of_three_is_told_and_left_out(array, touches, channel):
    samples, points = touches
    hiss = np.zeros_like(samples)
    hiss[channel] = 0.02 * np.random.default_rng(2).standard_normal(samples.shape[1])
    told, states, faults = listen(array, samples + hiss)
    assert faults == {("hissing channel", array.microphones[channel])}
    assert "unreadable" not in states
    assert np.mean(found(told, points)) >= 0.9
    # Where nobody goes on without it, nothing is named that the decoder would be sure of.
    told, states, _ = listen(array, samples + hiss, fallback=False)
    assert told == []
    assert "unreadable" in states
