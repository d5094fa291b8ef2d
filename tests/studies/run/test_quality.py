"""How good a design is said to be: what the metrics of a study and of as-built sensors say of it."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from matplotlib.image import imread
from small_run import small_design

import studies
from geometry import prototype
from studies.metrics import as_built_accuracy
from studies.run import quality
from studies.run.quality import design_quality, draw_quality
from studies.verdict import force_in_words


def test_the_figures_are_those_of_the_metrics(tmp_path):
    design = small_design()
    found = design_quality(design)
    library = studies.solve_library(design, tmp_path / "library.nc", fidelity="atlas", frequency="1:100:64")
    assert found.cost == pytest.approx(studies.study.METRICS["cost"].of_library(library))
    assert found.fidelity.words == "atlas"
    predicted = as_built_accuracy(design, force=None)
    assert found.as_built == pytest.approx((predicted.taps.mean + predicted.presses.mean) / 2)
    assert found.worst == pytest.approx((predicted.taps.worst + predicted.presses.worst) / 2)
    assert found.interval[0] <= found.as_built <= found.interval[1]
    assert found.per_point.mean() == pytest.approx(found.as_built)
    assert found.sensors == 64
    assert json.loads(json.dumps(found.to_dict()))["hardest"] == list(found.hardest)


def test_touches_of_a_run_are_predicted_and_not_multi_sines_alone():
    found = design_quality(small_design())
    assert found.touches == "taps and presses"
    rows = {what: value for what, value, _ in found.lines}
    remarks = {what: remark for what, _, remark in found.lines}
    for what in ("as-built sensors", "5th percentile", "nominal sensor"):
        assert "taps and presses of a run, 0.03 to 30 Pa in the cavity" in remarks[f"top-1 accuracy, {what}"]
    assert rows["noise-equivalent force"] == force_in_words(found.force)
    assert rows["top-1 accuracy, multi-sines"] == f"{100 * found.predicted.multi_sines.mean:.1f} %"
    assert found.accuracy.startswith("taps and presses: ")


def test_a_design_whose_scatter_is_not_known_has_the_accuracy_of_the_nominal_sensor_alone():
    stretched = small_design().with_values({"membrane.stretch": 1.1})
    found = design_quality(stretched)
    assert (found.predicted, found.sensors, found.touches) == (None, 0, "multi-sine touches")
    assert found.per_point.mean() == pytest.approx(found.nominal)


def test_a_large_design_has_a_few_as_built_sensors_and_never_one_alone(monkeypatch):
    monkeypatch.setattr(quality, "SENSORS_UP_TO", 0.1)
    found = design_quality(small_design())
    assert found.sensors == 4
    assert found.worst <= found.as_built


def test_what_takes_too_long_is_said_not_to_be_known(monkeypatch):
    monkeypatch.setattr(quality, "_MOST_POINTS", 2)
    found = design_quality(small_design())
    assert (found.sensors, found.to_dict()["as_built"]) == (0, None)
    assert math.isnan(found.worst)
    assert found.lines[0][:2] == ("top-1 accuracy, as-built sensors", "not known")


def test_the_picture_rings_the_hardest_pair(tmp_path):
    design = small_design()
    picture = imread(draw_quality(design, design_quality(design), tmp_path / "array.png"))
    red = np.all(np.abs(picture[..., :3] - np.array([0xC0, 0x39, 0x2B]) / 255) < 0.05, axis=-1)
    assert red.sum() > 100
    assert picture.shape[1] > 1000


def test_a_design_that_has_nothing_to_tell_apart_has_no_figures():
    one = prototype("array-2x6").with_values({"lines.0.points": 1, "layout.columns": 1})
    assert design_quality(one) is None
