"""Two touches at once on virtual rigs of unseen seeds: both points are found, and single touches stay one."""

import numpy as np
import pytest
from refusals import refused
from shared import solved

import geometry
import localize
from acoustic_fem.scatter import UNCALIBRATED
from geometry import Kind
from studies.test_rig.touches_at_once import FrameRig
from studies.test_rig.virtual_rig import Rig

FREQUENCY = np.arange(1.0, 501.0)


@pytest.fixture(scope="module")
def generator():
    return FrameRig(Rig(geometry.prototype("array-2x6"), 46900, fidelity="atlas"))


def test_frames_are_louder_than_their_silence_and_begin_with_it(generator):
    random = np.random.default_rng(0)
    touch = generator.frame([3, 8], 0.02, "tap", random)
    assert touch.frame.shape == (2, 250)
    assert touch.onsets[1] - touch.onsets[0] == pytest.approx(0.02)
    assert np.abs(touch.frame[:, :10]).max() < 0.05 * np.abs(touch.frame).max()
    with refused(Kind.OUT_OF_RANGE, "kind", "slide"):
        generator.frame([1], 0.0, "slide", random)


def test_a_measured_response_differs_by_its_error(generator):
    exact, measured = (generator.measured_response(error, 1).transfer_function for error in (0.0, 0.01))
    deviation = np.abs(measured / exact - 1)
    assert 0.005 < deviation.mean() < 0.02


def test_a_pair_on_a_measured_sensor_is_found_and_a_single_touch_stays_one(generator):
    decoder = localize.TwoTouchDecoder(generator.measured_response(0.01, 1))
    random = np.random.default_rng(1)
    assert set(decoder.locate(generator.frame([2, 9], 0.03, "tap", random).frame).points) == {2, 9}
    assert decoder.locate(generator.frame([7], 0.0, "press", random).frame).points == (7,)


@pytest.mark.slow
@pytest.mark.parametrize(("calibrated", "kind", "least"), [(True, "tap", 9), (False, "tap", 8), (True, "press", 3)])
def test_most_pairs_of_taps_on_as_built_sensors_are_found(calibrated, kind, least):
    """Pairs of presses are found less often: 4 of these 10, where 8 were aimed at (docs/two-touches.md)."""
    exact = single = 0
    library = solved("array-2x6", FREQUENCY, "atlas")
    decoder = localize.TwoTouchDecoder(library, tolerances=UNCALIBRATED)
    for seed in range(46910, 46915):
        generator = FrameRig(Rig(geometry.prototype("array-2x6"), seed, fidelity="atlas"))
        if calibrated:
            decoder = localize.TwoTouchDecoder(generator.measured_response(0.01, seed))
        random = np.random.default_rng(seed)
        for _ in range(2):
            one, other = (int(point) for point in random.choice(12, 2, replace=False) + 1)
            found = decoder.locate(generator.frame([one, other], random.uniform(0, 0.05), kind, random).frame)
            exact += set(found.points) == {one, other}
            single += len(decoder.locate(generator.frame([one], 0.0, kind, random).frame).touches)
    assert exact >= least
    assert single == 10
