"""Evaluations count what they say, also under changed conditions, and the page shows it all."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import numpy as np
import pytest
import scipy.stats
from rc_line import rc_line
from small_run import small_design

import acoustic_fem
import localize
from localize.evaluation.accuracy import wilson_interval
from localize.evaluation.conditions import AMBIENT_LEVELS, NOISES, conditions, evaluate_conditions, evaluate_sensors
from localize.signals.array_response import response_of
from localize.signals.finger_stimuli import STIMULI
from studies.judging.full import evaluate_fully, mis_made
from studies.judging.report import write_evaluation


class Guesser:
    """Names the touched point with a stated probability, and is right as often as it is told."""

    def __init__(self, array, right, stated):
        self.microphones, self.point_count = array.microphones, array.point_count
        self.right, self.stated = right, stated
        self.generator = np.random.default_rng(0)
        self.next = 0

    def locate(self, signals):
        point = (self.next + np.arange(len(signals))) % self.point_count
        self.next += len(signals)
        wrong = self.generator.random(len(signals)) >= self.right
        named = (point + wrong) % self.point_count
        probability = np.full((len(signals), self.point_count), (1 - self.stated) / (self.point_count - 1))
        probability[np.arange(len(signals)), named] = self.stated
        return probability


@pytest.mark.parametrize(("right", "stated"), [(0.8, 0.8), (0.5, 0.97), (0.95, 0.62), (1.0, 1.0)])
def test_the_calibration_error_is_the_distance_of_stated_and_true_shares(right, stated):
    array = rc_line(5)
    found = localize.evaluate(Guesser(array, right, stated), array, 400)
    assert found.top1 == pytest.approx(right, abs=0.03)
    assert found.reliability.expected_error == pytest.approx(abs(found.top1 - stated))
    filled = [each for each in found.reliability.bins if each.touches]
    assert len(filled) == 1
    assert (filled[0].touches, filled[0].stated, filled[0].right) == (2000, pytest.approx(stated), found.top1)
    assert filled[0].low <= stated <= filled[0].high
    assert json.loads(json.dumps(found.to_dict()))["expected_calibration_error"] == found.reliability.expected_error


@pytest.mark.parametrize(("right", "touches"), [(0, 10), (1, 1), (15, 20), (300, 600), (2400, 2400)])
def test_intervals_are_those_of_wilson(right, touches):
    expected = scipy.stats.binomtest(right, touches).proportion_ci(method="wilson")
    found = wilson_interval(right / touches, touches)
    assert found == pytest.approx((expected.low, expected.high), abs=1e-12)
    assert found[0] <= right / touches <= found[1]


def test_conditions_have_touches_enough_for_four_points_either_way_but_no_more_than_were_asked_for(library):
    decoder = localize.BayesDecoder(library, 1e-2)
    for touches, expected in ((250, 600), (4, 12)):
        found = evaluate_fully({"decoder": decoder}, library, response_of(library), touches, 1e-1, 0, lambda *_: None)
        counted = [each for each in found.judged[0].outcomes if each.worst is None]
        assert {each.touches for each in counted} == {expected}
        assert all(each.low <= each.top1 <= each.high for each in found.judged[0].outcomes)
        if expected == 600:
            assert max(each.high - each.low for each in counted) <= 0.08


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


def test_mis_made_sensors_scatter_around_the_library_whatever_its_fidelity(library):
    response = response_of(library)
    sets = mis_made(library, response, seed=0, count=6)
    spread = [np.abs(np.log(made / response.transfer_function)).std() for _, _, made in sets]
    assert spread[0] < spread[1] < spread[2]
    assert spread[2] == pytest.approx(4 * spread[0], rel=0.2)
    turned = replace(response, transfer_function=1.5j * response.transfer_function)
    again = mis_made(library, turned, seed=0, count=6)
    assert again[1][2] == pytest.approx(1.5j * sets[1][2])


def test_the_page_is_one_file_with_all_figures_and_the_json_has_their_numbers(library, tmp_path):
    response = response_of(library)
    locators = {"first": localize.BayesDecoder(library, 1e-2), "second": localize.BayesDecoder(library, 1e-3)}
    told = []
    found = evaluate_fully(locators, library, response, 10, 1e-2, 0, lambda what, share: told.append((what, share)))
    assert [share for _, share in told] == sorted(share for _, share in told)
    write_evaluation(found, tmp_path / "judged")
    assert sorted(path.name for path in (tmp_path / "judged").iterdir()) == ["evaluation.html", "evaluation.json"]
    numbers = json.loads((tmp_path / "judged" / "evaluation.json").read_text(encoding="utf-8"))
    page = (tmp_path / "judged" / "evaluation.html").read_text(encoding="utf-8")
    assert page.count("data:image/png;base64,") == 4
    assert not re.search(r'(src|href)="(?!data:|#)', page)
    assert "<script" not in page
    first = numbers["first"]
    assert f"{100 * first['top1']:.1f}" in page
    assert {each["group"] for each in first["conditions"]} == {
        "microphone noise", "ambient sound", "stimulus", "length", "mis-made sensors"
    }  # fmt: skip
    for each in first["conditions"]:
        assert f">{each['name']}<" in page
        assert f"{100 * each['top1']:.1f} ({100 * each['low']:.1f} to {100 * each['high']:.1f})" in page
    for name in ("first", "second"):
        hardest = min(numbers[name]["conditions"], key=lambda each: each["top1"])
        assert f"for the {name} {hardest['group']}, {hardest['name']} ({100 * hardest['top1']:.1f} %)" in page
    assert 'name = "row-3"' in numbers["provenance"]["design"]
