"""Strokes of fingers: in the frame that decides, alone as in a batch, and through membrane and cavity."""

import numpy as np
import pytest
import torch
from rc_line import rc_line

import geometry
import localize
from acoustic_fem import solve
from localize.signals import stimulus
from localize.signals.array_response import response_of
from localize.signals.finger_stimuli import taps
from localize.signals.finger_strokes import PEAK, press_strokes, slide_strokes, tap_strokes
from localize.signals.stimulus_kinds import Mixture

WIDE = (0.25, 499.75)
SOURCES = pytest.mark.parametrize("source", [tap_strokes, press_strokes, slide_strokes])


def stroke(source, count=400):
    """(count, 4000): four seconds of strokes."""
    return stimulus.time_signal(source(0, "training", 0, count, WIDE, "cpu").spectrum, stimulus.PERIOD)


@SOURCES
def test_a_stroke_moves_within_the_frame_that_decides(source):
    moved = stroke(source)
    step = moved[:, 749:1000].diff(dim=1).abs().sum(1)
    whole = moved[:, :2000].diff(dim=1).abs().sum(1)
    assert (step / whole).median() > 0.3
    assert (step / whole > 0.02).double().mean() > 0.95


@SOURCES
def test_strokes_are_from_barely_felt_to_firm_and_end(source):
    moved = stroke(source)
    peak = moved[:, :2000].amax(1)
    assert PEAK[0] / 2 < peak.min() < peak.max() < 3 * PEAK[1]
    assert (moved[:, 2000:].abs().amax(1) < 0.02 * peak).all()


@SOURCES
def test_a_stroke_made_alone_is_the_one_made_in_a_batch(source):
    batch = source(3, "training", 5, 20, WIDE, "cpu")
    alone = source(3, "training", 12, 1, WIDE, "cpu")
    assert torch.allclose(batch.spectrum[7], alone.spectrum[0], atol=1e-7)
    assert batch.is_stroke.all()


def test_a_mixture_keeps_strokes_and_pressures_apart():
    mixed = Mixture((tap_strokes, taps))(0, "training", 0, 64 * 40, WIDE, "cpu")
    of_run = mixed.is_stroke.view(40, 64)
    assert (of_run.all(1) | ~of_run.any(1)).all()
    assert 0.2 < of_run.double().mean() < 0.8


def test_a_stroke_goes_through_membrane_and_cavity_of_its_own_point():
    """The generator's signals are those of the library's responses, multiplied line by line."""
    library = solve(geometry.prototype("line-2"), "1:500:500", fidelity="lumped")
    response = response_of(library)
    generator = localize.TouchGenerator(response, 0, "evaluation", 0.0, stimuli=tap_strokes)
    made = generator.samples(0, 3).signals.double().numpy()
    source = tap_strokes(0, "evaluation", 0, 3, (1.0, 500.0), "cpu").spectrum.numpy()
    lines = stimulus.line_frequencies()
    for point in range(3):
        at_30 = np.abs(np.interp(30.0, response.frequency, response.cavity_response[point]))
        in_cavity = np.interp(lines, response.frequency, response.cavity_response[point]) / at_30
        there = lines >= 2.0  # below, the splines from 0 Hz differ from straight lines
        spectrum = np.zeros((2, stimulus.PERIOD // 2 + 1), complex)
        h = np.array([np.interp(lines, response.frequency, one) for one in response.transfer_function[point]])
        spectrum[:, :-1] = source[point] * in_cavity * h
        found = np.fft.rfft(np.fft.irfft(spectrum, norm="forward")[:, :1000], norm="forward")
        expected = np.fft.rfft(made[point], norm="forward")
        assert there.any()
        assert np.abs(found - expected)[:, 5:60].max() < 0.03 * np.abs(expected).max()


def test_an_array_without_membranes_takes_a_stroke_as_a_pressure():
    array = rc_line(4)
    generator = localize.TouchGenerator(array, 0, "evaluation", 0.0, stimuli=tap_strokes)
    signals = generator.samples(0, 4).signals
    assert torch.isfinite(signals).all()
    assert (signals.abs().amax((1, 2)) > 0).all()
