"""Accuracy of as-built sensors, predicted in bins, against what must hold of any decoder and against full decoding."""

from __future__ import annotations

import numpy as np
import pytest

import acoustic_fem
import localize
from geometry import prototype
from geometry.ground.refusal import Kind, Refusal
from localize.evaluation.held_out import MULTI_SINES, TAPS, TouchedSensors, decide
from localize.signals.array_response import response_of
from studies.evaluation.evaluated_sensors import scattered_sensors
from studies.metrics import as_built_accuracies, as_built_accuracy
from studies.metrics.predicted_accuracy import DECODERS
from studies.metrics.touch_bins import NODES, TOUCHES, touch_frames

ARRAY = prototype("array-2x6")
#: Bores and length with which as-built sensors of the array are often confused.
CONFUSED = ARRAY.with_values({"lines.0.points": 24, "tube.length": 20.0, "microphone_tube.length": 20.0})


def test_the_sensor_as_designed_is_decoded_better_than_as_built_ones() -> None:
    found = as_built_accuracy(CONFUSED, force=None)
    for touch in TOUCHES:
        built, designed = getattr(found, touch), getattr(found.nominal, touch)
        assert designed.mean > built.mean + 0.02
        assert built.worst <= built.mean
        assert built.low <= built.mean <= built.high
        assert built.per_point.mean() == pytest.approx(built.mean)


def test_a_calibrated_sensor_is_decoded_better() -> None:
    alone = as_built_accuracy(CONFUSED, force=None)
    calibrated = as_built_accuracy(CONFUSED, force=None, calibrated=True)
    assert calibrated.taps.mean > alone.taps.mean + 0.05
    assert (alone.decoder, calibrated.decoder) == (DECODERS[False], DECODERS[True])


def test_a_light_touch_is_decoded_worse_than_a_firm_one() -> None:
    light, firm = (as_built_accuracy(ARRAY, force=force) for force in (1e-6, 1e-2))
    assert light.taps.mean < firm.taps.mean - 0.05
    assert light.multi_sines.mean == pytest.approx(firm.multi_sines.mean, abs=0.02)


@pytest.mark.slow
def test_the_prediction_is_that_of_full_decoding() -> None:
    library = acoustic_fem.solve(CONFUSED, np.arange(1.0, 501.0), "lumped")
    response = response_of(library)
    sensors = scattered_sensors(library, response, 7, 8, (1.0,))[0][0][-1]
    touched = TouchedSensors(response, "design", 3, sensors=sensors)
    decoder = localize.TolerantDecoder(library)
    predicted = as_built_accuracy(CONFUSED, force=None)
    for kinds, touch in ((TAPS, "taps"), (MULTI_SINES, "multi_sines")):
        full = decide(decoder, touched.touches(kinds, 3)).evaluation().top1
        assert getattr(predicted, touch).mean == pytest.approx(full, abs=0.14)


def test_points_that_no_microphone_detects_are_confused() -> None:
    mute = CONFUSED.with_values({"tube.length": 1000.0, "microphone_tube.length": 1000.0})
    found = as_built_accuracy(mute, force=None, sensors=8)
    assert found.taps.mean < 0.4
    assert np.isfinite(found.taps.per_point).all()


def test_the_same_seed_gives_the_same_figures_and_several_designs_are_those_alone() -> None:
    alone = as_built_accuracy(ARRAY, sensors=8)
    again, other = as_built_accuracies([ARRAY, CONFUSED], sensors=8)
    assert alone.to_dict() == again.to_dict() != other.to_dict()


def test_bins_of_a_multi_sine_are_those_of_its_samples() -> None:
    from localize.signals.stimulus import multi_sines, time_signal
    from studies.metrics.touch_bins import _SEED, BINS, COUNT, _window

    spectrum = multi_sines(_SEED, "evaluation", 0, COUNT, (0.25, 500.0)).spectrum
    samples = time_signal(spectrum).numpy()[:, -250:]
    waves = np.exp(-2j * np.pi * np.arange(250)[:, None] / 1000 * BINS)
    expected = (samples * _window()) @ waves
    near, leaked = touch_frames("multi_sines", np.ones(len(NODES)), None)
    assert np.abs(near - expected).max() < 1.02 * leaked.max() < 0.5 * np.abs(expected).max()
    assert (np.abs(near - expected) < 1.02 * leaked + 0.02 * np.abs(expected).max()).all()


@pytest.mark.parametrize(("field", "value"), [("force", 0.0), ("sensors", 2)])
def test_numbers_out_of_range_are_refused(field: str, value: float) -> None:
    with pytest.raises(Refusal) as refused:
        as_built_accuracy(ARRAY, **{field: value})
    assert (refused.value.kind, refused.value.field, refused.value.value) == (Kind.OUT_OF_RANGE, field, value)


def test_a_design_of_one_point_is_refused() -> None:
    with pytest.raises(Refusal) as refused:
        as_built_accuracy(ARRAY.with_values({"lines.0.points": 1, "layout.columns": 1}))
    assert (refused.value.kind, refused.value.field) == (Kind.UNSUITABLE, "lines.points")
