"""A library that ends below the frequencies of touches is told of, once, where a localizer is made of it."""

import warnings
from dataclasses import replace

import numpy as np
import pytest
from rc_line import rc_line

import localize
from localize.signals.array_response import UncoveredWarning, warn_of_uncovered

SHORT = np.arange(1.0, 101.0)


@pytest.mark.parametrize(
    "make",
    [
        lambda array: localize.BayesDecoder(array, 1e-2),
        lambda array: localize.train(array, localize.TrainingPlan(epochs=1, seconds_per_point=4, microphone_noise=0.0)),
    ],
    ids=["decoder", "training"],
)
def test_a_localizer_of_a_short_library_is_made_with_a_warning(make):
    with pytest.warns(UncoveredWarning, match="ends at 100 Hz.* every touch is taken to be silent.* 1:500:500") as told:
        make(rc_line(4, SHORT))
    assert len(told) == 1
    assert "\n" not in str(told[0].message)


def test_whole_libraries_and_measured_ones_are_not_warned_of():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warn_of_uncovered(rc_line(4, np.arange(1.0, 501.0)))
        warn_of_uncovered(replace(rc_line(4, SHORT), provenance={"fidelity": "measured"}))
