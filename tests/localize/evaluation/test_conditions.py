"""Each condition of an evaluation changes one thing, and that reaches the signals."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import scipy.signal
from rc_line import rc_line
from small_run import small_design

import acoustic_fem
import localize
from localize.evaluation.accuracy import Reliability
from localize.evaluation.conditions import AMBIENT_LEVELS, NOISES, conditions, evaluate_conditions, evaluate_sensors
from localize.evaluation.held_out import MULTI_SINES, TAPS_AND_PRESSES, TouchedSensors, TouchKinds, decide
from localize.signals.array_response import response_of
from localize.signals.stimulus_kinds import STIMULI


def test_each_condition_changes_one_thing_and_reaches_the_signals():
    array = rc_line(5)
    assert {condition.group for condition in conditions(array)} == {"microphone noise", "stimulus", "length"}
    decoder = localize.BayesDecoder(array, 1e-2)
    outcomes = {
        (each.group, each.name): each for each in evaluate_conditions(decoder, array, 6, 1e-2, kinds=MULTI_SINES)
    }
    noise = [outcomes["microphone noise", f"{rms:g} Pa"].top1 for rms in NOISES]
    assert noise[0] > 0.9
    assert noise[-1] < noise[0]
    assert {name for group, name in outcomes if group == "stimulus"} == set(STIMULI)
    assert outcomes["length", "1000 ms"].top1 >= outcomes["length", "250 ms"].top1
    for name in ("taps", "tap-strokes"):
        touches = TouchedSensors(array, 1e-2).touches(TouchKinds(name, (STIMULI[name],), 3.0), 6)
        alone = decide(decoder, touches).evaluation()
        assert (outcomes["stimulus", name].top1, outcomes["stimulus", name].signals) == (alone.top1, name)
    assert {each.signals for (group, _), each in outcomes.items() if group != "stimulus"} == {"multi-sine touches"}


def test_the_worst_of_several_sensors_is_told_beside_their_mean():
    array = rc_line(5)
    decoder = localize.BayesDecoder(array, 1e-2)
    other = array.transfer_function[::-1]  # every touch is taken for one of the mirrored point
    both = [("two", 1.0, np.stack([array.transfer_function, other]))]
    (found,) = evaluate_sensors(decoder, array, both, 20, 1e-2, kinds=MULTI_SINES)
    assert found.worst < 0.4 < 0.95 < 2 * found.top1 - found.worst
    assert (found.touches, found.sensors, found.signals) == (200, 2, "multi-sine touches")
    (found,) = evaluate_sensors(decoder, array, both, 20, 1e-2)
    assert (found.touches, found.sensors, found.signals) == (200, 2, "taps and presses")


def test_no_two_sensors_have_the_same_touches_and_every_localizer_has_the_same():
    array = rc_line(5)
    same = np.stack([array.transfer_function, array.transfer_function])
    touches = TouchedSensors(array, 0.0, 3, sensors=same).touches(TAPS_AND_PRESSES, 4)
    assert len({signal.tobytes() for signal in touches.signals}) == len(touches.signals) == 2 * 2 * 4 * 5
    decided = decide(localize.BayesDecoder(array, 1e-2), touches, shard=7)
    pooled = decided.evaluation()
    by_kind = [decided.by_sensor(kind) for kind in range(2)]
    assert [[each.touches for each in results] for results in by_kind] == [[20, 20], [20, 20]]
    right = sum(each.top1 * each.touches for results in by_kind for each in results)
    assert pooled.top1 * pooled.touches == pytest.approx(right)
    # The first sensor has the touches of localize.evaluate, behind a high-pass.
    unfiltered = TouchedSensors(array, 0.0, 3).touches(replace(TAPS_AND_PRESSES, high_pass=None), 4)
    found = decide(localize.BayesDecoder(array, 1e-2), unfiltered).by_sensor(0)
    alone = localize.evaluate(localize.BayesDecoder(array, 1e-2), array, 4, 0.0, seed=3, stimuli=STIMULI["tap-strokes"])
    assert found[0].confusion.tolist() == alone.confusion.tolist()
    whole = TouchedSensors(array, 0.0, 3).touches(replace(TAPS_AND_PRESSES, high_pass=None), 4, 1000).signals
    passed = scipy.signal.sosfilt(scipy.signal.butter(2, 3.0, "highpass", fs=1000, output="sos"), whole)
    ours = TouchedSensors(array, 0.0, 3).touches(TAPS_AND_PRESSES, 4).signals
    assert np.abs(ours - passed[..., -250:]).max() < 1e-5 * np.abs(ours).max()


def test_reliabilities_are_pooled_by_their_touches():
    array = rc_line(5)
    decoder = localize.BayesDecoder(array, 3e-2)
    sensors = TouchedSensors(array, 3e-2, sensors=np.stack(3 * [array.transfer_function]))
    touches = sensors.touches(TAPS_AND_PRESSES, 20)
    decided = decide(decoder, touches)
    whole = decided.evaluation().reliability
    pooled = Reliability.pooled([each.reliability for each in decided.by_sensor()])
    assert 0 < whole.expected_error == pytest.approx(pooled.expected_error)
    assert [each.touches for each in whole.bins] == [each.touches for each in pooled.bins]


@pytest.fixture(scope="module")
def library():
    return acoustic_fem.solve(small_design(), np.arange(1.0, 201.0), "lumped")


def test_ambient_sound_is_a_condition_where_there_is_a_design(library):
    response = response_of(library)
    levels = [condition for condition in conditions(response) if condition.group == "ambient sound"]
    assert [condition.value for condition in levels] == list(AMBIENT_LEVELS)
    decoder = localize.BayesDecoder(library)
    quiet, loud = (localize.evaluate(decoder, library, 20, 1e-3, ambient=level).top1 for level in (20.0, 90.0))
    assert loud < 0.9 < quiet
