"""A full evaluation has a headline, every condition and as-built sensors; its page shows all of it."""

from __future__ import annotations

import json
import re
from dataclasses import replace

import numpy as np
import pytest
from small_run import small_design

import acoustic_fem
import localize
from localize.signals.array_response import response_of
from studies.evaluation.evaluated_sensors import SENSORS, rig_sensors, scattered_sensors, sensor_sets
from studies.evaluation.evaluation_report import write_evaluation
from studies.evaluation.full_evaluation import evaluate_fully
from studies.output.report_texts import percent, with_worst
from studies.test_rig.virtual_rig import Rig

#: Touches and sensors of the table of accuracies.
ROWS = (
    "taps and presses on 20 as-built sensors",
    "taps on 20 as-built sensors",
    "presses on 20 as-built sensors",
    "taps and presses on 8 virtual rigs",
    "taps and presses on the nominal sensor",
    "multi-sine touches on 20 as-built sensors",
    "multi-sine touches on the nominal sensor",
)
#: Fractions of the tolerances.
FRACTIONS = (0.25, 0.5, 1.0)


@pytest.mark.slow
def test_conditions_have_touches_enough_for_four_points_either_way_but_no_more_than_were_asked_for(library):
    decoder = localize.BayesDecoder(library, 1e-2)
    for touches, expected in ((250, 600), (4, 12)):
        found = evaluate_fully({"decoder": decoder}, library, response_of(library), touches, 1e-1, 0, lambda *_: None)
        counted = [each for each in found.results[0].outcomes if each.worst is None]
        assert {each.touches for each in counted} == {expected}
        assert all(each.low <= each.top1 <= each.high for each in found.results[0].outcomes)
        if expected == 600:
            assert max(each.high - each.low for each in counted) <= 0.08


@pytest.fixture(scope="module")
def library():
    return acoustic_fem.solve(small_design(), np.arange(1.0, 201.0), "lumped")


def test_as_built_sensors_scatter_around_the_library_whatever_its_fidelity(library):
    response = response_of(library)
    sets = sensor_sets(library, response, seed=0, count=6, shares=FRACTIONS)
    spread = [np.abs(np.log(made / response.transfer_function)).std() for _, _, made in sets]
    assert spread[0] < spread[1] < spread[2]
    assert spread[2] == pytest.approx(4 * spread[0], rel=0.2)
    turned = replace(response, transfer_function=1.5j * response.transfer_function)
    again = sensor_sets(library, turned, seed=0, count=6, shares=FRACTIONS)
    assert again[1][2] == pytest.approx(1.5j * sets[1][2])


@pytest.mark.slow
def test_a_design_whose_scatter_is_not_known_is_judged_without_it_and_told_why():
    box = small_design().with_values({"resonator.shape": "box"})
    library = acoustic_fem.solve(box, np.arange(1.0, 101.0), "lumped")
    sets, reason = scattered_sensors(library, response_of(library), 0, 2, (1.0,))
    assert sets == []
    assert "resonator.shape = 'box' must be 'cylinder'" in reason


def test_virtual_rigs_are_judged_as_they_are_made(library):
    response = response_of(library)
    ((name, share, made),) = rig_sensors(library, response, seed=5, count=2)
    assert (name, share, len(made)) == ("uncalibrated", None, 2)
    inside = response.frequency <= 160.0
    for number, own in enumerate(made):
        rig = Rig(library.design, 5 + number, fidelity="lumped")
        assert np.allclose(own[..., inside], rig.transfer_function(response.frequency[inside]), rtol=1e-9)


@pytest.mark.slow
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
    assert page.count("<script") == 1  # of all reports
    first = numbers["first"]
    assert f"The first assigns {percent(first['top1'])} of held-out taps and presses on 20 as-built sensors" in page
    assert f"{100 * first['top1']:.1f} ({100 * first['intervals']['top1'][0]:.1f} to" in page
    assert (len(first["sensors"]), min(first["sensors"])) == (SENSORS, first["worst"])
    assert {each["group"] for each in first["conditions"]} == {
        "microphone noise", "ambient sound", "stimulus", "length", "as-built sensors", "virtual rigs"
    }  # fmt: skip
    for each in first["conditions"]:
        assert f">{each['name']}<" in page
        assert f"{100 * each['top1']:.1f} ({100 * each['low']:.1f} to {100 * each['high']:.1f})" in page
    assert [each["value"] for each in first["conditions"] if each["group"] == "as-built sensors"] == [*FRACTIONS]
    for name in locators:
        hardest = min(numbers[name]["conditions"], key=lambda each: each["top1"])
        assert f"{percent(hardest['top1'])} ({hardest['group']}: {hardest['name']})</td>" in page
    rows = re.findall(r'<tr><td class="label">(.*?)</td><td class="figure">(.*?)</td>', page)
    assert [row[0] for row in rows] == [*ROWS, "the hardest of all conditions below"]
    for (_, cell), each in zip(rows[1:], first["beside"], strict=False):
        assert cell == with_worst(each["top1"], each["worst"])
    assert 'name = "row-3"' in numbers["provenance"]["design"]
