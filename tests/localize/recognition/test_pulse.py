"""Pulses: waves are found where they are, the rate with its deviation, and short recordings are refused."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from rc_line import rc_line
from refusals import refused

import localize
from geometry import Kind
from localize.contacts import pulse_times, pulse_wave
from localize.recognition.pulse import PulseDecoder, waves_of
from localize.recognition.takes import prepared, simulated_signals
from localize.signals.noise_model import NoiseSpectrum

ARRAY = rc_line(3, np.concatenate([np.arange(0.25, 10.0, 0.25), np.arange(10.0, 501.0, 2.0)]))


@pytest.mark.parametrize("rate", [50.0, 75.0, 100.0])
def test_the_waves_of_a_force_are_found_where_they_are(rate: float) -> None:
    contact, truth = pulse_wave((0.0, 0.0), rate, 8.0, seed=2), pulse_times(rate, 8.0, seed=2)
    found = waves_of(contact.force)
    inside = (truth["percussion"] > 0.5) & (truth["dicrotic"] < 7.5)
    for name, times in truth.items():
        nearest = np.array([np.nanmin(np.abs(found[name] - time)) for time in times[inside]])
        assert nearest.max() < 0.03, name
    beats = truth["percussion"][inside]
    own = [found["percussion"][np.abs(found["percussion"] - time).argmin()] for time in beats]
    assert np.diff(own).mean() == pytest.approx(np.diff(beats).mean(), abs=2e-3)


def test_a_pulse_without_a_dicrotic_wave_has_none() -> None:
    time = np.arange(6000) / 1000
    wave = sum(np.exp(-0.5 * ((time - beat) / 0.045) ** 2) for beat in np.arange(0.3, 6.0, 0.8))
    found = waves_of(wave)
    assert len(found["percussion"]) >= 6
    assert np.isnan(found["tidal"]).all()
    assert np.isnan(found["dicrotic"]).all()


def test_a_contact_that_comes_and_goes_is_no_beat() -> None:
    time = np.arange(8000) / 1000
    true = np.arange(0.9, 7.0, 0.8)
    edges = [np.exp(-0.5 * ((time - at) / 0.045) ** 2) for at in (true[0] - 0.55, *true, true[-1] + 1.1)]
    found = waves_of(sum(edges))
    np.testing.assert_allclose(found["percussion"], true, atol=2e-3)
    assert all(len(own) == len(true) for own in found.values())


def test_a_reader_names_point_and_rate() -> None:
    contact, truth = pulse_wave((0.0, 0.0), 70.0, 6.0, seed=5), pulse_times(70.0, 6.0, seed=5)["percussion"]
    random = np.random.default_rng(0)
    signals = simulated_signals(ARRAY, 2, 0.2 * contact.force / contact.force.max(), 1e-3, random)
    reading = localize.PulseReader(ARRAY, 1e-3).read(signals)
    assert reading.point == 2
    rate = 60 / np.diff(truth[(truth > 0.5) & (truth < 5.5)]).mean()
    assert abs(reading.rate - rate) < 3 * reading.rate_deviation + 1.0
    assert reading.waveform.shape == (6001,)
    with refused(Kind.UNSUITABLE, "signals"):
        localize.PulseReader(ARRAY, 1e-3).read(signals[:, :2000])


def test_a_second_of_a_pulse_names_its_point_better_than_frames_of_touches() -> None:
    contact, random = pulse_wave((0.0, 0.0), 60.0, 6.0, seed=5), np.random.default_rng(1)
    force = contact.force / contact.force.max()
    pulses, touches, named = PulseDecoder(ARRAY, 1e-3), localize.BayesDecoder(ARRAY, 1e-3), []
    for point in range(3):
        signals = prepared(simulated_signals(ARRAY, point + 1, 0.1 * force, 1e-3, random))
        for begin in (1000, 2000, 3000, 4000):
            second = signals[:, begin : begin + 1000]
            found = (pulses.named(second), touches.locate(second))
            named.append([each.argmax() == point for each in found])
    right = np.mean(named, axis=0)
    assert right[0] > max(0.6, right[1] + 0.1)
    # White noise is one by its number and by its spectrum.
    told = replace(ARRAY, own_noise=NoiseSpectrum(np.full(500, 1e-6 / 500), "white"))
    np.testing.assert_allclose(PulseDecoder(told, "design").named(signals), pulses.named(signals), atol=0.01)
