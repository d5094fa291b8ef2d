"""Each condition of an evaluation changes one thing, and that reaches the signals."""

from __future__ import annotations

import numpy as np
import pytest
from rc_line import rc_line
from small_run import small_design

import acoustic_fem
import localize
from localize.evaluation.conditions import AMBIENT_LEVELS, NOISES, conditions, evaluate_conditions, evaluate_sensors
from localize.signals.array_response import response_of
from localize.signals.stimulus_kinds import STIMULI


def test_each_condition_changes_one_thing_and_reaches_the_signals():
    array = rc_line(5)
    assert {condition.group for condition in conditions(array)} == {"microphone noise", "stimulus", "length"}
    decoder = localize.BayesDecoder(array, 1e-2)
    outcomes = {(each.group, each.name): each for each in evaluate_conditions(decoder, array, 6, 1e-2)}
    noise = [outcomes["microphone noise", f"{rms:g} Pa"].top1 for rms in NOISES]
    assert noise[0] > 0.9
    assert noise[-1] < noise[0]
    assert {name for group, name in outcomes if group == "stimulus"} == set(STIMULI)
    assert outcomes["length", "1000 ms"].top1 >= outcomes["length", "250 ms"].top1
    alone = localize.evaluate(decoder, array, 6, 1e-2, stimuli=STIMULI["taps"])
    assert outcomes["stimulus", "taps"].top1 == alone.top1


def test_the_worst_of_several_sensors_is_told_beside_their_mean():
    array = rc_line(5)
    decoder = localize.BayesDecoder(array, 1e-2)
    other = array.transfer_function[::-1]  # every touch is taken for one of the mirrored point
    (found,) = evaluate_sensors(decoder, array, [("two", 1.0, np.stack([array.transfer_function, other]))], 20, 1e-2)
    assert found.worst < 0.4 < 0.95 < 2 * found.top1 - found.worst
    assert found.touches == 200


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
