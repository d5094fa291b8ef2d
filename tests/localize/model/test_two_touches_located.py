"""Recordings with two touches at once: both are located where they are looked for."""

import numpy as np
import pytest
from refusals import refused
from shared import solved
from stroke_signals import heard_of_taps

import localize
from geometry import Kind
from localize.live.events import SeveralTouches
from localize.recordings.recording import Recording


@pytest.fixture(scope="module")
def library():
    return solved("array-2x6", np.arange(1.0, 501.0))


def test_both_touches_are_located_and_a_single_one_stays_one(library):
    heard = heard_of_taps(library, [(2, 1.0, 0.05, 1.0), (9, 1.03, 0.04, 0.8), (5, 2.5, 0.05, 1.0)])
    recording = Recording(heard, 1000.0)
    model = localize.open_model(library, tolerances=False, two_touches=True)
    found = model.locate_recording(recording)
    assert [touch.point for touch in found.touches] == [2, 9, 5]
    (several,) = found.several
    assert [each.point for each in several.touches] == [2, 9]
    assert several.touches[0].time == pytest.approx(1.0125, abs=5e-3)
    assert several.touches[1].time == pytest.approx(1.04, abs=5e-3)
    assert any(isinstance(event, SeveralTouches) for event in found.events)
    assert not localize.open_model(library, tolerances=False).locate_recording(recording).several


def test_a_model_without_a_library_is_refused(library):
    decoder = localize.BayesDecoder(localize.signals.response_of(library), 1e-3)
    model = localize.open_model(decoder, two_touches=True)
    with refused(Kind.UNSUITABLE, "model"):
        model.two_touch_watch()
