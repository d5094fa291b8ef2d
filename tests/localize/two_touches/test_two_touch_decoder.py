"""One, two and three strokes are found with their points, times and heights; noise is no certain touch."""

import numpy as np
import pytest
from rc_line import rc_line
from refusals import refused
from shared import solved
from stroke_signals import heard_of_taps

import localize
from acoustic_fem.scatter import UNCALIBRATED
from geometry import Kind
from localize.live.front_end import HighPass
from localize.signals.array_response import response_of
from localize.two_touches.stroke_fit import _Fit

FREQUENCY = np.arange(1.0, 501.0)


@pytest.fixture(scope="module")
def library():
    return solved("array-2x6", FREQUENCY)


@pytest.fixture(scope="module")
def decoder(library):
    return localize.TwoTouchDecoder(library)


def frame_of(library, touches):
    """Frame of strokes, each a point, its beginning and its width, s, and its height, Pa."""
    heard = heard_of_taps(library, [(point, 1 + begin, width, height) for point, begin, width, height in touches])
    return HighPass(len(heard), 3.0).begin(heard)[:, 1000:1250]


@pytest.mark.parametrize("point", [1, 6, 9])
def test_a_single_touch_is_one_with_its_time_and_height(library, decoder, point):
    found = decoder.locate(frame_of(library, [(point, 0.03, 0.04, 0.7)]))
    assert found.points == (point,)
    assert found.touches[0].time == pytest.approx(0.03 + 0.01, abs=2e-3)
    assert found.touches[0].height == pytest.approx(0.7, rel=0.1)
    assert found.gain <= 50
    assert found.misfit < 1


@pytest.mark.parametrize(
    ("one", "other", "apart"), [(2, 9, 0.0), pytest.param(4, 5, 0.03, marks=pytest.mark.slow), (1, 12, 0.05)]
)
def test_two_touches_are_found_in_the_order_of_time(library, decoder, one, other, apart):
    found = decoder.locate(frame_of(library, [(one, 0.03, 0.05, 1.0), (other, 0.03 + apart, 0.03, 0.5)]))
    assert set(found.points) == {one, other}
    if apart:
        assert found.points == (one, other)
        assert found.touches[1].time == pytest.approx(0.03 + apart + 0.0075, abs=3e-3)
    assert found.gain > 100


@pytest.mark.slow
def test_three_touches_are_found_where_three_are_looked_for(library):
    three = localize.TwoTouchDecoder(library, options=localize.TwoTouchOptions(most=3))
    frame = frame_of(library, [(2, 0.02, 0.04, 1.0), (6, 0.05, 0.03, 0.8), (11, 0.09, 0.04, 1.0)])
    assert three.locate(frame).points == (2, 6, 11)
    assert three.locate(frame_of(library, [(3, 0.03, 0.05, 1.0)])).points == (3,)


@pytest.mark.parametrize("is_coarse", [False, True])
def test_derivatives_of_a_frame_are_differences(decoder, is_coarse):
    model = decoder._model.coarse() if is_coarse else decoder._model
    points = np.array([[1, 8], [4, 5]])
    components = decoder._deviations.of_points(points, 3)
    strokes = np.array([[0.06, *np.log([0.03, 0.02, 0.05, 4e-3, 0.8])], [0.09, *np.log([0.02, 0.1, 0.02, 1e-3, 0.5])]])
    state = np.concatenate([np.tile(strokes.ravel(), (2, 1)), [[0.3, -0.5, 0.2], [-0.1, 0.4, 1.0]]], axis=1)
    size = len(decoder._model.white(np.zeros((2, 250))))
    fit = _Fit(model, np.zeros(size), points, components, np.full(size, 4.0))
    every = np.arange(2)
    slopes = fit.slopes(fit.reached(every, state))
    for number in range(state.shape[1]):
        # Times of strokes are in seconds, the other parameters are logarithms and standard deviations.
        step = 1e-2 if is_coarse and number not in (0, 6) else 1e-4
        moved = step * np.eye(state.shape[1])[number]
        above, below = (fit.residual(fit.reached(every, state + sign * moved)) for sign in (1, -1))
        difference = (below - above) / (2 * step)
        assert np.abs(difference - slopes[:, number]).max() < (2e-2 if is_coarse else 1e-3) * np.abs(difference).max()


def test_components_do_not_depend_on_the_order_of_points_nor_on_what_is_kept(decoder):
    both = decoder._deviations.of_points(np.array([[2, 7], [7, 2], [2, 7]]), 4)
    assert np.array_equal(both[0], both[2])
    assert np.array_equal(both[0], both[1][:, ::-1])


def test_what_no_strokes_make_has_a_misfit_and_no_certain_points(library, decoder):
    noise = np.random.default_rng(3).standard_normal((2, 250))
    found = decoder.locate(noise)
    assert found.misfit > 20
    assert all(touch.probability < 0.95 for touch in found.touches)


def test_a_point_that_is_not_probable_enough_is_unknown():
    touch = localize.FoundTouch(best=4, probability=0.4, time=0.0, height=1.0, held=0.1)
    assert touch.point is None
    assert localize.TouchesAtOnce((touch,), 0.0, 1.0).points == (None,)


def test_bad_arguments_are_refused(library, decoder):
    with refused(Kind.UNSUITABLE, "library"):
        localize.TwoTouchDecoder(rc_line(3), 1e-3)
    with refused(Kind.OUT_OF_RANGE, "microphone_noise", 0.0):
        localize.TwoTouchDecoder(library, 0.0)
    with refused(Kind.UNSUITABLE, "library"):
        localize.TwoTouchDecoder(library, options=localize.TwoTouchOptions(most_points=11))
    with refused(Kind.OUT_OF_RANGE, "most", 4):
        localize.TwoTouchOptions(most=4)
    with refused(Kind.WRONG_TYPE, "frame"):
        decoder.locate(np.zeros((3, 250)))
    with refused(Kind.WRONG_TYPE, "frame"):
        decoder.locate(np.full((2, 250), np.nan))
    with refused(Kind.UNSUITABLE, "library"):
        localize.TwoTouchDecoder(response_of(library), tolerances=UNCALIBRATED)
