"""A stream reports both of two touches at once, and single touches and slides as they were."""

import json
from dataclasses import dataclass, field

import numpy as np
import pytest

from localize.live.events import Decision, SeveralTouches
from localize.live.touches import Touch
from localize.model.located_touches import with_several
from localize.two_touches import FoundTouch, TouchesAtOnce, TwoTouchWatch

FRAME = np.ones((2, 250))


@dataclass
class Decoder:
    """Decoder that answers what it was given, and remembers the frames."""

    answer: TouchesAtOnce
    frames: list = field(default_factory=list)

    def locate(self, frame):
        self.frames.append(frame)
        return self.answer


def answer(*points, misfit=0.5, probability=0.9):
    found = tuple(FoundTouch(point, probability, 0.05 + 0.02 * k, 1.0, 0.1) for k, point in enumerate(points))
    return TouchesAtOnce(found, 100.0, misfit)


def decisions(states, start=1.0):
    every = np.full(12, 1 / 12)
    return [
        Decision(start + 0.016 * k, state, 1.0, 1, 0.9, every, frame=None if state == "no touch" else FRAME)
        for k, state in enumerate(states)
    ]


def told(watch, states):
    events = [each for event in decisions(states) for each in watch.take(event)]
    return events + watch.finish()


@pytest.mark.parametrize("beside", [False, True])
def test_a_contact_of_two_touches_is_reported_once_with_both_times(beside):
    decoder = Decoder(answer(3, 8))
    (event,) = told(TwoTouchWatch(decoder, beside), ["no touch"] * 3 + ["touch"] * 14 + ["no touch"] * 6)
    assert [each.point for each in event.touches] == [3, 8]
    assert event.contact == pytest.approx(1.048)
    decided = 1.048 + 11 * 0.016
    assert event.touches[0].time == pytest.approx(decided - 0.25 + 0.05)
    assert event.touches[1].time - event.touches[0].time == pytest.approx(0.02)
    assert event.time >= decided
    assert len(decoder.frames) == 1


def test_a_short_contact_is_decoded_when_it_ends():
    decoder = Decoder(answer(3, 8))
    (event,) = told(TwoTouchWatch(decoder), ["touch"] * 6 + ["no touch"] * 6)
    assert event.touches[0].time == pytest.approx(1.0 + 5 * 0.016 - 0.25 + 0.05)


def test_single_touches_and_what_is_no_stroke_are_not_reported():
    assert told(TwoTouchWatch(Decoder(answer(3))), ["touch"] * 14) == []
    assert told(TwoTouchWatch(Decoder(answer(3, 8, misfit=9.0))), ["touch"] * 14) == []


def test_a_point_that_is_not_known_is_null_in_json_and_no_touch():
    decoder = Decoder(answer(3, 8, probability=0.3))
    (event,) = told(TwoTouchWatch(decoder), ["touch"] * 14)
    line = json.loads(event.json_line())
    assert line["event"] == "several"
    assert [each["point"] for each in line["touches"]] == [None, None]
    single = Touch(1.0, 1.2, 5, 0.9, 1.0)
    assert with_several([single], [event]) == []


def test_the_touches_of_a_contact_replace_the_single_ones_that_it_seemed_to_be():
    (event,) = told(TwoTouchWatch(Decoder(answer(3, 8))), ["touch"] * 14)
    assert isinstance(event, SeveralTouches)
    before, phantom, later = Touch(0.2, 0.4, 1, 0.9, 1.0), Touch(1.0, 1.3, 6, 0.7, 2.0), Touch(2.0, 2.2, 2, 0.9, 1.0)
    found = with_several([before, phantom, later], [event])
    assert [touch.point for touch in found] == [1, 3, 8, 2]
    assert [touch.start for touch in found[1:3]] == pytest.approx([1.0, 1.02])
    assert all(touch.end == phantom.end for touch in found[1:3])
