"""How good a design is said to be: what the metrics of a study and of as-built sensors say of it."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from matplotlib.image import imread
from small_run import small_design

import studies
from acoustic_fem.quantities.checks import frequency_grid
from geometry import prototype
from studies.run import quality
from studies.run.quality import design_quality, draw_quality
from studies.scatter.effects import scattered_accuracy


def test_the_figures_are_those_of_the_metrics(tmp_path):
    design = small_design()
    found = design_quality(design)
    grid = frequency_grid(studies.output.FREQUENCIES)
    library = studies.solve_library(design, tmp_path / "library.nc", fidelity="atlas", frequency="1:100:64")
    metrics = studies.study.METRICS
    assert found.nominal == pytest.approx(metrics["predicted_top1"].of_library(library))
    assert found.cost == pytest.approx(metrics["cost"].of_library(library))
    assert found.per_point.mean() == pytest.approx(found.nominal)
    assert (found.fidelity.words, found.as_built_fidelity.words) == ("atlas", "atlas")
    made = scattered_accuracy(design, grid, sensors=found.sensors, fidelity="atlas")
    assert (found.as_built, found.worst) == (pytest.approx(made.mean()), pytest.approx(made.min()))
    assert found.sensors == 64
    assert json.loads(json.dumps(found.to_dict()))["hardest"] == list(found.hardest)


@pytest.mark.slow
def test_a_design_at_the_edge_of_the_atlas_is_solved_in_3d_as_built_and_says_so(monkeypatch):
    monkeypatch.setattr(quality, "SENSORS_UP_TO", 0.1)
    small = small_design()
    tall = 2.29 * small.resonator.cavity_diameter / 2  # heights by radius end at 2.3
    edge = small.with_values({"resonator.cavity_height": round(tall, 3)})
    beyond = small.with_values({"resonator.cavity_height": round(1.1 * tall, 3)})
    found, other = design_quality(edge), design_quality(beyond)
    assert found.fidelity.words == "atlas"
    assert found.as_built_fidelity.words.startswith("navier-stokes: tube 1 of line 1 at point 1: ")
    assert other.fidelity.words.startswith("navier-stokes: ")
    rows = {what: value for what, value, _ in found.lines}
    assert (rows["fidelity, nominal sensor"], rows["fidelity, as-built sensors"]) == ("atlas", "navier-stokes")


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
