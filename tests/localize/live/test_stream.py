"""A stream decides what a batch does however it is cut up, and reports what goes wrong with it."""

from __future__ import annotations

import itertools
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from rc_line import rc_line
from refusals import refused

import acoustic_fem
import localize
from geometry import Kind
from localize import Decision, Fault, TouchStream
from localize.live import AS_IT_COMES
from localize.live.events import HOP
from localize.signals.stimulus import SAMPLE_RATE

NOISE = 1e-2


@pytest.fixture(scope="module")
def array():
    return rc_line(6)


@pytest.fixture(scope="module")
def decoder(array):
    return localize.BayesDecoder(array, NOISE)


@pytest.fixture(scope="module")
def signals(array):
    """Three touches of a second each, with a second and a half of noise around each of them."""
    made = localize.TouchGenerator(array, 0, "evaluation", 0.0).samples(0, 30)
    loud = [int(k) for k in np.argsort(-made.signals.std(-1).amax(1).numpy())[:3]]
    noise = NOISE * np.random.default_rng(0).standard_normal((2, 9000))
    for turn, sample in enumerate(loud):
        begin = 1500 + 2500 * turn
        noise[:, begin : begin + 1000] += made.signals[sample].numpy()
    return noise, [int(made.point[k]) for k in loud]


def chunks(total, cuts):
    edges = [0, *sorted(cuts), total]
    return list(itertools.pairwise(edges))


def streamed(stream, signals, cuts, numbered=False):
    return [
        event
        for a, b in chunks(signals.shape[1], cuts)
        for event in stream.push(signals[:, a:b], a if numbered else None)
    ]


def test_a_stream_gives_what_a_batch_of_its_frames_gives(array, decoder, signals):
    events = TouchStream(decoder, options=AS_IT_COMES).push(signals[0])
    frames = np.lib.stride_tricks.sliding_window_view(signals[0], 250, axis=1)[:, ::HOP].swapaxes(0, 1)
    batch = decoder.locate(frames)
    assert len(events) == len(frames)
    for event, frame, expected in zip(events, frames, batch, strict=True):
        heard = frame.std(1).max() > 2 * NOISE
        assert (event.state == "touch") == heard
        if heard:
            assert event.distribution == pytest.approx(expected, abs=1e-9)
            assert event.point == expected.argmax() + 1
    assert [round(event.time * 1000) for event in events] == list(range(250, 9000 + 1, HOP))


damage = st.sampled_from(["none", "not finite", "flat", "loud"])


@pytest.mark.slow
@settings(max_examples=30)
@given(
    cuts=st.lists(st.integers(0, 2000), max_size=40),
    damages=st.lists(st.tuples(damage, st.integers(0, 1), st.integers(0, 1999), st.integers(1, 400)), max_size=4),
)
def test_decisions_and_faults_do_not_depend_on_how_the_samples_are_cut_up(decoder, signals, cuts, damages):
    samples = signals[0][:, 1000:3000].copy()
    for kind, channel, begin, length in damages:
        if kind != "none":
            value = {"not finite": np.nan, "flat": 0.123, "loud": 5.0}[kind]
            samples[channel, begin : begin + length] = value
    whole = TouchStream(decoder, limit=4.0).push(samples)
    assert streamed(TouchStream(decoder, limit=4.0), samples, cuts) == whole
    assert streamed(TouchStream(decoder, limit=4.0), samples, cuts, numbered=True) == whole


def test_one_sample_at_a_time_is_a_chunk_size_too(decoder, signals):
    samples = signals[0][:, 1300:1900]
    assert streamed(TouchStream(decoder), samples, range(1, 600)) == TouchStream(decoder).push(samples)


@pytest.mark.slow
def test_silence_is_no_touch_and_noise_names_no_point(array, decoder):
    noise = NOISE * np.random.default_rng(1).standard_normal((2, 100_000))
    events = TouchStream(decoder).push(noise)
    assert len(events) > 6000
    assert {event.state for event in events} == {"no touch"}
    assert all(event.point is None and event.probability is None for event in events)
    assert localize.touches_of(events, decoder) == []


def test_touches_are_found_where_they_were_made(decoder, signals):
    samples, points = signals
    touches = localize.touches_of(TouchStream(decoder).push(samples), decoder)
    assert [touch.point for touch in touches] == points
    for turn, touch in enumerate(touches):
        begin = 1.5 + 2.5 * turn
        assert begin < touch.start < begin + 0.3
        assert begin + 0.9 < touch.end < begin + 1.3
        assert touch.probability > 0.99


def test_what_is_left_of_a_loud_touch_names_no_other_point(decoder):
    names = np.full((6, 6), 1e-9) + np.eye(6)
    loud, left = names[2] / names[2].sum(), names[5] / names[5].sum()
    events = [
        Decision(0.25 + 0.016 * k, "touch", 1.0 if k < 16 else 0.01, 3 if k < 16 else 6, 1.0, loud if k < 16 else left)
        for k in range(40)
    ]
    assert [touch.point for touch in localize.touches_of(events, decoder)] == [3]


def test_a_sliding_finger_touches_one_point_after_the_other(array, decoder):
    made = localize.TouchGenerator(array, 0, "evaluation", 0.0).samples(0, 60)
    loud = np.argsort(-made.signals.std(-1).amin(1).numpy())
    along = [next(made.signals[k].numpy() for k in loud if made.point[k] == point) for point in (2, 3, 4)]
    samples = np.concatenate([np.zeros((2, 500)), *along, np.zeros((2, 500))], axis=1)
    samples += NOISE * np.random.default_rng(0).standard_normal(samples.shape)
    touches = localize.touches_of(TouchStream(decoder).push(samples), decoder)
    assert [touch.point for touch in touches] == [2, 3, 4]
    assert [touch.start for touch in touches] == pytest.approx([0.55, 1.6, 2.6], abs=0.15)


def test_lost_samples_are_counted_and_no_frame_spans_them(decoder, signals):
    samples = signals[0]
    stream = TouchStream(decoder)
    events = stream.push(samples[:, :2000], 0) + stream.push(samples[:, 2100:], 2100)
    faults = [event for event in events if isinstance(event, Fault)]
    assert faults == [Fault(2.0, "samples lost", samples=100)]
    after = [event for event in events if isinstance(event, Decision) and event.time > 2.0]
    assert after[0].time == pytest.approx(2.35)
    alone = TouchStream(decoder).push(samples[:, 2100:], 2100)
    # What sounds from the first sample behind a gap may be the rest of a touch, and is not located.
    whole = next(k for k, event in enumerate(after) if event.state not in ("unreadable", "no touch"))
    assert {event.state for event in alone[:whole]} <= {"touch", "fading", "no touch"}
    assert after[whole:] == alone[whole:]


def test_repeated_samples_are_counted_and_left_out(decoder, signals):
    samples = signals[0]
    stream = TouchStream(decoder)
    pushed = [(0, 1600), (1600, 1700), (1600, 1700), (1650, 1800), (1800, 3000)]
    events = [event for a, b in pushed for event in stream.push(samples[:, a:b], a)]
    faults = [event for event in events if isinstance(event, Fault)]
    assert faults == [
        Fault(1.6, "samples repeated", samples=100),
        Fault(1.65, "samples repeated", samples=50),
    ]
    assert [event for event in events if isinstance(event, Decision)] == TouchStream(decoder).push(samples[:, :3000])


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e300])
def test_values_that_are_no_pressure_are_told_once_and_kept_out_of_every_frame(decoder, signals, value):
    samples = signals[0][:, :3000].copy()
    samples[1, 1000:1005] = value
    events = TouchStream(decoder).push(samples)
    assert [event for event in events if isinstance(event, Fault)] == [Fault(1.0, "not finite", "right")]
    decisions = [event for event in events if isinstance(event, Decision)]
    assert {event.state for event in decisions if 1.005 < event.time < 1.254} == {"unreadable"}
    times = [event.time for event in decisions if event.state != "unreadable"]
    assert not [time for time in times if 1.0 < time < 1.254]
    assert 1.255 in [round(time, 6) for time in times]


def test_clipping_and_a_dead_channel_are_told_by_name_and_never_decoded(decoder, signals):
    samples = signals[0][:, :4000].copy()
    samples[0, 1700:1710] = 4.0
    samples[1, 3000:] = 0.0
    events = TouchStream(decoder, limit=4.0).push(samples)
    faults = [event for event in events if isinstance(event, Fault)]
    assert [(fault.kind, fault.channel) for fault in faults] == [("clipped", "left"), ("dead channel", "right")]
    assert 1.7 < faults[0].time <= 1.7 + HOP / SAMPLE_RATE
    assert 3.25 <= faults[1].time < 3.25 + HOP / SAMPLE_RATE
    unreadable = [event.time for event in events if isinstance(event, Decision) and event.state == "unreadable"]
    assert unreadable
    assert all(1.7 < time < 1.96 or time > 3.249 for time in unreadable)


def test_a_fault_that_returns_is_told_again(decoder, signals):
    samples = signals[0][:, :2000].copy()
    samples[0, [300, 900]] = np.nan
    events = TouchStream(decoder).push(samples)
    assert [event.time for event in events if isinstance(event, Fault)] == [0.3, 0.9]


def test_a_value_that_is_lost_again_and_again_is_told_once_and_its_frames_are_unreadable(decoder, signals):
    samples = signals[0][:, :3000].copy()
    samples[0, 100::200] = np.nan
    events = TouchStream(decoder).push(samples)
    assert [event for event in events if isinstance(event, Fault)] == [Fault(0.1, "not finite", "left")]
    decisions = [event for event in events if isinstance(event, Decision)]
    assert {event.state for event in decisions} == {"unreadable"}
    assert len(decisions) > 150
    assert all(np.isfinite(json.loads(event.json_line())["level"]) for event in decisions)


def test_a_microphone_that_only_toggles_by_a_bit_is_dead(decoder, signals):
    samples = signals[0][:, :3000].copy()
    samples[1] = 1e-3 * NOISE * np.random.default_rng(0).integers(0, 2, 3000)
    events = TouchStream(decoder).push(samples)
    assert [event for event in events if isinstance(event, Fault)] == [Fault(0.25, "dead channel", "right")]
    assert {event.state for event in events if isinstance(event, Decision)} == {"unreadable"}


def test_a_microphone_that_is_15_db_too_quiet_is_not_dead_while_it_hears_a_touch(decoder, signals):
    samples = signals[0][:, :6000].copy()
    samples[1] *= 10 ** (-15 / 20)
    events = TouchStream(decoder).push(samples)
    whole = [event for event in TouchStream(decoder).push(signals[0][:, :6000]) if isinstance(event, Decision)]
    loud = [event.time for event in whole if event.state == "touch" and event.level > 30 * NOISE]
    unreadable = {event.time for event in events if isinstance(event, Decision) and event.state == "unreadable"}
    assert len(unreadable & set(loud)) < 0.05 * len(loud)


def test_a_microphone_whose_noise_is_missing_is_dead(decoder, signals):
    samples = signals[0][:, :6000].copy()
    bit = 0.1 * NOISE  # of a converter of 16 bits whose full scale is 3000 times the noise
    samples[1] = bit * np.random.default_rng(0).integers(-1, 2, 6000)
    events = TouchStream(decoder).push(samples)
    (fault,) = [event for event in events if isinstance(event, Fault)]
    assert (fault.kind, fault.channel) == ("dead channel", "right")
    assert fault.time < 1.0
    late = [event.state for event in events if isinstance(event, Decision) and event.time > fault.time]
    assert set(late) == {"unreadable"}


def test_microphones_that_are_all_quieter_than_expected_are_alive(decoder, signals):
    quiet = 0.05 * NOISE * np.random.default_rng(1).standard_normal((2, 6000))
    quiet[:, 3000:3300] += signals[0][:, 3000:3300]
    events = TouchStream(decoder).push(quiet)
    assert not [event for event in events if isinstance(event, Fault)]


def test_a_device_that_counts_anew_is_listened_to_from_there(decoder, signals):
    samples = signals[0]
    stream = TouchStream(decoder)
    before = stream.push(samples[:, :2000], 5000)
    after = [event for a in range(0, 3000, 100) for event in stream.push(samples[:, a : a + 100], a)]
    assert after[0] == Fault(0.0, "restarted")
    assert after[1:] == TouchStream(decoder).push(samples[:, :3000], 0)
    touches = localize.touches_of(before + after, decoder)
    assert all(touch.start <= touch.end for touch in touches)
    assert len(touches) == 2


def test_a_device_that_goes_back_a_little_is_told_once(decoder, signals):
    samples = signals[0]
    stream = TouchStream(decoder)
    events = [
        event
        for a in (*range(0, 1000, 100), *range(400, 2000, 100))
        for event in stream.push(samples[:, a : a + 100], a)
    ]
    assert [event for event in events if isinstance(event, Fault)] == [Fault(0.4, "samples repeated", samples=100)]
    assert [event for event in events if isinstance(event, Decision)] == TouchStream(decoder).push(samples[:, :2000])


@pytest.mark.parametrize("first", [1.5, "3", -1, 2**70, True])
def test_a_number_of_a_sample_that_is_none_is_refused_before_anything_is_taken(decoder, signals, first):
    stream = TouchStream(decoder)
    stream.push(signals[0][:, :300])
    with refused(Kind.WRONG_TYPE, "first", first):
        stream.push(signals[0][:, 300:400], first)
    with refused(Kind.WRONG_TYPE, "chunk"):
        stream.push(signals[0][:, 300:400] + 0j)
    assert stream.push(signals[0][:, 300:400], 300) == TouchStream(decoder).push(signals[0][:, :400])[4:]


def test_events_are_lines_of_json(decoder, signals):
    samples = signals[0][:, :2000].copy()
    samples[1, 700] = np.nan
    lines = [json.loads(event.json_line()) for event in TouchStream(decoder).push(samples)]
    assert {"time": 0.7, "fault": "not finite", "channel": "right"} in lines
    touch = next(line for line in lines if line.get("state") == "touch")
    assert set(touch) == {"time", "state", "level", "point", "probability"}
    assert json.loads(Fault(1.0, "samples lost", samples=3).json_line())["samples"] == 3


@pytest.mark.slow
def test_a_network_and_an_onnx_file_listen_to_a_stream_as_well(array, tmp_path, signals):
    plan = localize.TrainingPlan(seconds_per_point=5, epochs=1, microphone_noise=NOISE)
    network = localize.train(array, plan)
    localize.export_onnx(network, tmp_path / "network.onnx")
    read = localize.OnnxLocalizer(tmp_path / "network.onnx")
    samples = signals[0][:, 1000:3000]
    of_network, of_file = (TouchStream(each).push(samples) for each in (network, read))
    assert [event.state for event in of_network] == [event.state for event in of_file]
    for a, b in zip(of_network, of_file, strict=True):
        if a.state == "touch":
            assert np.abs(a.distribution - b.distribution).max() < 5e-5  # single precision, of a network hardly trained


@pytest.mark.parametrize(("window", "latency"), [(250, 16), (40, 0), (300, 60)])
def test_waveforms_of_a_stream_join_to_that_of_the_whole_recording(array, decoder, signals, window, latency):
    samples = signals[0][:, :3000]
    maker = localize.Reconstructor(array, NOISE, window, latency)
    events = streamed(TouchStream(decoder, reconstructor=maker), samples, [7, 400, 1234, 1235, 2000])
    touched = [event for event in events if event.state == "touch"]
    assert len(touched) > 50
    for event in touched:
        end = round(event.time * SAMPLE_RATE) - latency
        whole = maker.waveform(samples, event.point).pressure[0, end - HOP : end]
        assert event.waveform == pytest.approx(whole, abs=1e-9)
    assert len(json.loads(touched[0].json_line())["waveform"]) == HOP
    assert all(event.waveform is None for event in events if event.state != "touch")


def test_a_window_longer_than_the_stream_so_far_gives_no_waveform_yet(array, decoder, signals):
    maker = localize.Reconstructor(array, NOISE, 600)
    events = TouchStream(decoder, reconstructor=maker).push(signals[0][:, 1600:2600])
    without = [event.time for event in events if event.state == "touch" and event.waveform is None]
    assert without
    assert max(without) < 0.615 <= min(event.time for event in events if event.waveform is not None)


def test_chunks_of_another_shape_and_bad_thresholds_are_refused(decoder):
    stream = TouchStream(decoder)
    for shape in ((3, 100), (100,), (1, 2, 100)):
        with refused(Kind.WRONG_TYPE, "chunk"):
            stream.push(np.zeros(shape))
    assert stream.push(np.zeros((2, 0))) == []
    with refused(Kind.OUT_OF_RANGE, "silence", 0.0):
        TouchStream(decoder, silence=0.0)
    other = localize.Reconstructor(replace(rc_line(6), microphones=("other", "right")), NOISE)
    with refused(Kind.MISMATCH, "reconstructor"):
        TouchStream(decoder, reconstructor=other)
    with refused(Kind.OUT_OF_RANGE, "limit"):
        TouchStream(decoder, limit=float("nan"))


@pytest.mark.slow
@pytest.mark.parametrize("full_scale", [1.0, 4.0])
def test_no_touch_is_wrong_where_one_hop_in_fifty_is_lost(full_scale):
    """The rest of a touch behind a gap sounds as another point, if it is taken for a whole one."""
    examples = Path(__file__).parents[3] / "docs" / "examples" / "recordings"
    model = localize.open_model(localize.BayesDecoder(acoustic_fem.load(examples / "library.nc")))
    recording = localize.read_recording(examples / "touches.wav", model.locator.microphones, full_scale)

    def touches(share, seed):
        lost = np.random.default_rng(seed).random(recording.signals.shape[1] // HOP) < share
        stream, tracker = model.stream(30.0), localize.TouchTracker(model.locator)
        decided = [
            event
            for first in HOP * np.flatnonzero(~lost)
            for event in stream.push(recording.signals[:, first : first + HOP], first)
        ]
        events = [each for event in decided for each in tracker.take(event)] + tracker.finish()
        return [(event.time, event.point) for event in events if event.kind != "up"]

    whole = touches(0.0, 0)
    found = 0
    for seed in range(1000, 1020):
        for time, point in touches(0.02, seed):
            assert any(own == point and -0.1 < time - at < 0.75 for at, own in whole), (seed, time, point)
            found += 1
    assert found > 0.6 * 20 * len(whole)
