"""Every figure of the page's panels is that of the Python call for the same design."""

from __future__ import annotations

import json
from collections.abc import Callable

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
from acoustic_fem.library.noise_floor import detection_limits
from geometry import ArrayDesign, prototype
from geometry.ground.refusal import Kind
from studies.comparison import FIGURES, figure_words
from studies.comparison.own_figures import MOST_POINTS
from studies.metrics import as_built_accuracy
from studies.metrics.confusion import predict_confusion
from studies.metrics.covered_area import coverage, point_coverage
from studies.metrics.separation import separability
from studies.panels.points import as_built_figures, point_figures
from studies.study.metric_registry import METRICS


@pytest.mark.parametrize("name", ["array-2x6", "glove"])
def test_the_figures_are_those_of_python(name: str) -> None:
    design = prototype(name)
    library = acoustic_fem.solve(design, np.linspace(1, 100, 64), fidelity="atlas")
    found = json.loads(json.dumps(point_figures(design)))

    assert tuple(found["figures"]) == FIGURES == tuple(figure_words())
    for metric, value in found["figures"].items():
        assert value == pytest.approx(METRICS[metric].of_library(library), rel=1e-12), metric
        assert figure_words()[metric]["unit"] == METRICS[metric].unit
    assert found["figures"]["coverage"] == coverage(design)
    assert found["finger"] == design.target.contact_radius

    apart = separability(library.transfer_function)
    limits = detection_limits(library, (1.0, 100.0))["force"]
    for point in found["points"]:
        number = point["number"]
        assert point["nearest"] == apart.nearest(number)
        between = apart.between(number, point["nearest"])
        assert (point["level"], point["phase"], point["distance"]) == pytest.approx(between, rel=1e-12)
        assert point["force"] == pytest.approx(float(limits.sel(point=number)), rel=1e-12)
        loudest = np.abs(library.transfer_function.sel(point=number, frequency=100)).max()
        assert point["loudest"] == pytest.approx(20 * np.log10(float(loudest)), rel=1e-9)
    assert [point["coverage"] for point in found["points"]] == point_coverage(design).tolist()
    assert found["hardest"] == [list(pair) for pair in apart.equally_hard]

    from localize.signals.noise_model import microphone_noise

    noise = microphone_noise(design.microphone, library.medium)
    predicted = predict_confusion(library.transfer_function.values[None], library.frequency, noise)
    np.testing.assert_allclose(np.array(found["confusion"]) / found["touches"], predicted.confusion[0], rtol=1e-12)
    named = [point["named"] for point in found["points"]]
    np.testing.assert_allclose(named, np.diagonal(predicted.confusion[0]), rtol=1e-12)
    assert found["overlaps"] == []
    assert found["fidelity"] == "atlas"


def test_what_cannot_be_built_is_said_with_its_mend() -> None:
    found = point_figures(prototype("array-2x6").with_values({"layout.pitch": 10.5}))
    assert found["overlaps"]
    assert found["mend"].startswith("set ")


def test_as_built_sensors_are_those_of_python() -> None:
    design = prototype("array-2x6")
    expected = as_built_accuracy(design, force=None)
    found = as_built_figures(design)
    assert (found["sensors"], found["multi_sines"]) == (64, expected.multi_sines.mean)
    assert found["mean"] == pytest.approx((expected.taps.mean + expected.presses.mean) / 2)
    assert found["worst"] == pytest.approx((expected.taps.worst + expected.presses.worst) / 2)
    assert found["interval"] == pytest.approx(
        [(getattr(expected.taps, end) + getattr(expected.presses, end)) / 2 for end in ("low", "high")]
    )


@pytest.mark.parametrize("figures", [point_figures, as_built_figures])
def test_arrays_that_no_memory_holds_are_refused(figures: Callable[[ArrayDesign], object]) -> None:
    large = prototype("array-2x6").with_values({"lines.0.points": MOST_POINTS + 1})
    with refused(Kind.UNSUITABLE):
        figures(large)
