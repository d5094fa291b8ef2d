"""Spectra of strokes are those of their samples, and their derivatives are right."""

import numpy as np
import pytest

from localize.two_touches.stroke_spectra import PARAMETERS, stroke_spectra

FREQUENCY = np.arange(0.5, 125.0, 0.5)


@pytest.mark.parametrize(("rise", "hold", "fall"), [(0.02, 1e-9, 0.02), (0.01, 0.05, 0.08), (0.1, 0.3, 0.2)])
def test_a_stroke_without_smoothing_is_the_transform_of_its_samples(rise, hold, fall):
    time = np.arange(0, 1, 1e-4)
    since = time - 0.05
    edge = np.minimum(since / rise, (rise + hold + fall - since) / fall).clip(0, 1)
    samples = np.sin(np.pi / 2 * edge) ** 2
    expected = np.exp(-2j * np.pi * FREQUENCY[:, None] * time) @ samples * 1e-4
    found = stroke_spectra(np.array([0.05 + rise / 2, *np.log([rise, hold, fall, 1e-12])]), FREQUENCY).spectrum
    assert np.abs(found - expected).max() < 1e-6 * np.abs(expected).max()


def test_a_smoothed_narrow_stroke_is_a_gaussian():
    width = 0.02
    found = stroke_spectra(np.array([0.1, *np.log([1e-4, 1e-9, 1e-4, width])]), FREQUENCY).spectrum
    expected = 1e-4 * np.exp(-0.5 * (2 * np.pi * FREQUENCY * width) ** 2)
    assert np.abs(found) == pytest.approx(expected, abs=1e-5 * 1e-4)


def test_single_precision_is_precise_near_the_singularity_of_an_edge():
    frequency = np.arange(1.0, 125.0)
    strokes = np.array([0.06, *np.log([0.02, 0.02, 0.02, 2e-3])]) + np.zeros((400, 1))
    strokes[:, 1] += np.linspace(-1e-2, 1e-2, 400)
    precise, single = (stroke_spectra(strokes.astype(kind), frequency.astype(kind)) for kind in ("f8", "f4"))
    assert single.up_slope.dtype == np.float32
    assert np.abs(single.up_slope - precise.up_slope).max() < 1e-3 * np.abs(precise.up_slope).max()


@pytest.mark.parametrize("number", range(len(PARAMETERS)))
def test_derivatives_are_differences(number):
    # The second rise makes the angle of a half sine pi at one of the frequencies.
    strokes = np.array([[0.06, *np.log([0.03, 0.02, 0.05, 4e-3])], [0.1, *np.log([1 / 100, 1e-3, 0.02, 1e-3])]])
    step = np.zeros(len(PARAMETERS))
    step[number] = 1e-6
    above, below = (stroke_spectra(strokes + sign * step, FREQUENCY).spectrum for sign in (1, -1))
    derivatives = stroke_spectra(strokes, FREQUENCY).derivatives(FREQUENCY)
    own = derivatives[:, number]
    assert np.abs((above - below) / 2e-6 - own).max() < 5e-7 * np.abs(own).max()
