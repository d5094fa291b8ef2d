"""What a contact is recorded as: the touches there are already, the network itself, and the same again."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import scipy.fft
import torch
from rc_line import rc_line
from refusals import refused
from whole_network import every_node_at_once

import acoustic_fem
import geometry
from acoustic_fem.library.touch_pressure import touch_flow
from geometry import Kind
from localize.contacts import Contact, ContactRecorder, covered_force, record
from localize.signals import TouchGenerator, response_of, stimulus
from localize.signals.finger_stimuli import top_faded
from localize.signals.stimulus import Stimuli

TIME = np.arange(1000) / 1000


@cache
def library(spacing=1.0):
    return acoustic_fem.solve(geometry.prototype("array-2x6"), np.arange(spacing, 100.01, spacing), fidelity="lumped")


def still(place, force, radius=2.0, **kwargs):
    return Contact(TIME, np.tile(place, (len(TIME), 1)), force, radius, **kwargs)


def hump(begin, lasts):
    phase = (TIME - begin) / lasts
    return np.where((phase > 0) & (phase < 1), np.sin(np.pi * np.clip(phase, 0, 1)) ** 2, 0.0)


@pytest.mark.parametrize("point", [0, 4])
def test_one_still_contact_on_one_membrane_is_the_touch_there_was(point):
    response = response_of(library())
    force = 1e-3 * hump(0.3, 0.05)
    band = (1.0, 100.0)

    def same_force(seed, purpose, start, count, _, device):
        lines = np.minimum(stimulus.line_frequencies(), 100.0)
        spectrum = np.fft.rfft(force, n=stimulus.PERIOD, norm="forward")[: stimulus.LINE_COUNT]
        pressure = torch.from_numpy(spectrum * response.between(lines)[1][point])
        one = (pressure * top_faded(band)).to(torch.complex64)[None].expand(count, -1)
        none = torch.zeros(count, dtype=torch.int64)
        return Stimuli(one, none - 1, none)

    touch = TouchGenerator(response, 0, "evaluation", 0.0, stimuli=same_force).samples(point, 1).signals[0].numpy()
    take = record(still(response.position[point], force), library(), microphone_noise=0.0)
    # A touch comes again every four seconds, and the rubber still creeps from the one before.
    assert np.abs(take.signals - touch).max() < 1e-3 * np.abs(touch).max()
    assert set(take.point) == {0, point + 1}


def test_force_response_and_places_are_those_of_the_library_and_its_layout():
    response = response_of(library())
    np.testing.assert_allclose(response.force_response, library().force_response.values, rtol=1e-10)
    assert response.position[0] == pytest.approx((0, 0))
    assert response.position[-1] == pytest.approx((0, 18.5))
    assert response.membrane_radius == pytest.approx([3.0] * 12)


def test_a_contact_on_two_membranes_is_the_network_with_two_injected_volumes():
    # The network on lines so near each other that the rubber creeps little from one period to the next.
    made, near = library(0.25), (0, 1)
    response = response_of(made)
    between = response.position[list(near)].mean(axis=0) + np.array([1.5, 0.0])
    contact = still(between, 2e-3 * hump(0.2, 0.3), radius=8.0)
    force = covered_force(contact, made)
    assert set(np.flatnonzero(force.any(axis=0))) == {0, 1}
    assert force[:, 1].max() > 1.5 * force[:, 0].max() > 0

    lines = np.arange(1, 6001) / 60
    made_there = acoustic_fem.solve(made.design, lines, fidelity="lumped")
    impedance = every_node_at_once(made.design, lines)
    flow = np.zeros((len(lines), impedance.shape[1], 1), complex)
    spectrum = scipy.fft.rfft(force, n=60000, axis=0)[1 : len(lines) + 1]
    for point in near:
        flow[:, point, 0] = spectrum[:, point] * touch_flow(made.design, made_there.point_impedance, "force")[point]
    pressure = (impedance @ flow)[:, -2:, 0] * np.interp(
        lines, stimulus.line_frequencies(), top_faded((0.25, 100.0)).numpy()
    )[:, None]
    direct = scipy.fft.irfft(np.concatenate([np.zeros((1, 2)), pressure]), n=60000, axis=0)[:1000].T
    # The network has no impedance at 0 Hz: the recorder's constant is left out of both.
    difference = record(contact, made, microphone_noise=0.0).signals - direct
    difference -= difference.mean(axis=1, keepdims=True)
    assert np.abs(difference).max() < 1e-4 * np.abs(direct).max()


def test_a_take_does_not_depend_on_others_and_is_the_same_when_made_again():
    response = response_of(library())
    slid = Contact([0, 0.5], response.position[:2], [1e-3, 1e-3], 5.0, 0.3, "slide")
    recorder = ContactRecorder(response, microphone_noise="design", ambient=60.0, seed=3)
    takes = [recorder.take(slid, sample) for sample in (0, 1, 0)]
    assert np.array_equal(takes[0].signals, takes[2].signals)
    assert not np.allclose(takes[0].signals, takes[1].signals)
    assert not np.allclose(takes[0].force, takes[1].force)
    alone = record(slid, library(), microphone_noise="design", ambient=60.0, seed=3, sample=1)
    assert np.array_equal(alone.signals, takes[1].signals)
    assert takes[0].signals.shape == (2, 501)
    assert takes[0].path.shape == (501, 2)
    assert takes[0].label == "slide"
    assert takes[0].point[0] == 1
    assert takes[0].point[-1] == 2


def test_noise_and_sound_of_a_long_take_have_the_level_asked_for_all_along():
    quiet = Contact([0.0, 8.0], [[500.0, 500.0]] * 2, [0.0, 0.0], 1.0)
    take = record(quiet, library(), microphone_noise=1e-3)
    assert take.signals.reshape(2, -1)[:, :8000].reshape(2, 8, 1000).std(axis=2) == pytest.approx(1e-3, rel=0.15)
    assert take.signals.std() == pytest.approx(1e-3, rel=0.02)
    assert (take.point == 0).all()
    loud = record(quiet, library(), microphone_noise=0.0, ambient=80.0).signals
    assert np.corrcoef(loud)[0, 1] > 0.9
    assert loud.std() > 10 * take.signals.std()


def test_a_contact_that_is_finer_than_the_samples_keeps_its_momentum():
    place = response_of(library()).position[3]
    fine = np.arange(10000) / 1e4
    short = np.where((fine > 0.3) & (fine < 0.3008), 0.05, 0.0)
    long = hump(0.296, 0.0088)
    fast = record(Contact(fine, np.tile(place, (10000, 1)), short, 1.0), library(), microphone_noise=0.0).signals
    slow = record(still(place, long * short.sum() / 10 / long.sum()), library(), microphone_noise=0.0).signals
    # Of 8 ms or 0.8 ms, to a band below 100 Hz both are impulses of the same momentum.
    assert np.abs(fast).max() == pytest.approx(np.abs(slow).max(), rel=0.2)


def test_other_rates_are_the_same_take():
    force = 1e-3 * hump(0.3, 0.1)
    contact = still(response_of(library()).position[2], force)
    one, four = (record(contact, library(), rate, microphone_noise=0.0).signals for rate in (1000.0, 4000.0))
    assert np.abs(four[:, ::4][:, :1000] - one).max() < 2e-3 * np.abs(one).max()


def test_what_cannot_be_recorded_is_refused():
    contact = still((0, 0), hump(0.1, 0.1))
    with refused(Kind.MISMATCH):
        record(contact, rc_line(3), microphone_noise=0.0)
    with refused(Kind.OUT_OF_RANGE, "sample_rate", 1000.1):
        record(contact, library(), 1000.1)
    with refused(Kind.CONFLICT, "sample_rate", 2000):
        record(contact, library(), 2000, microphone_noise=1e-3)
    with refused(Kind.OUT_OF_RANGE, "contact: its length", pytest.approx(2000)):
        record(replace(contact, time=2000 * TIME / TIME[-1]), library(), microphone_noise=0.0)
