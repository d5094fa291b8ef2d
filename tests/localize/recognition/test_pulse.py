"""Pulses: waves are found where they are, the rate with its deviation, and short recordings are refused."""

from __future__ import annotations

from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import get_args

import numpy as np
import pytest
from rc_line import rc_line
from refusals import refused

import localize
from geometry import Kind
from localize.contacts import PulseShape, Rhythm, pulse_times, pulse_wave
from localize.contacts.pulses import WAVES
from localize.recognition.pulse import PulseDecoder, likeness_of, waves_of
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


@pytest.mark.parametrize("rhythm", get_args(Rhythm))
@pytest.mark.parametrize("shape", WAVES)
def test_hearts_of_every_shape_and_rhythm_are_a_pulse_with_their_beats(shape: PulseShape, rhythm: Rhythm) -> None:
    right, told = [], []
    for sample in range(4):
        force = pulse_wave((0.0, 0.0), 55 + 12 * sample, 10.0, shape=shape, rhythm=rhythm, seed=8, sample=sample).force
        truth = pulse_times(55 + 12 * sample, 10.0, shape=shape, rhythm=rhythm, seed=8, sample=sample)
        waves = waves_of(force)
        assert likeness_of(force, waves["percussion"])[0] > 0.88
        beats = truth["percussion"]
        beats = beats[(beats > 1) & (beats < 9)]
        right += [abs(waves["percussion"] - at).min() < 0.04 for at in beats]
        told.append(np.isfinite(waves["tidal"]).mean())
        assert np.isnan(truth["tidal"]).all() == ("tidal" not in WAVES[shape])
    assert np.mean(right) > 0.9
    assert np.median(told) < 0.1 or "tidal" in WAVES[shape]


@pytest.mark.parametrize("what", ["noise", "sway", "tremor"])
def test_what_has_no_beats_is_no_pulse(what: str) -> None:
    random = np.random.default_rng(3)
    for _ in range(3):
        white = random.standard_normal(9000)
        source = {
            "noise": white * 1e-4,
            "sway": np.cumsum(white) / np.abs(np.cumsum(white)).max() * 0.05,
            "tremor": np.convolve(white, np.exp(-0.5 * (np.arange(-60, 61) / 20) ** 2), "same") * 2e-3,
        }[what]
        reading = localize.PulseReader(ARRAY, 1e-3).read(simulated_signals(ARRAY, 2, source, 1e-3, random))
        assert not reading.found
        assert reading.missing
        assert reading.likeness < 0.8
        assert np.isnan(reading.rate)
        assert all(len(times) == 0 for times in reading.waves.values())


@pytest.mark.skipif(
    find_spec("heartpy") is None, reason="heartpy, whose recordings of real pulses these are, is missing"
)
@pytest.mark.parametrize("piece", [0, 1])
def test_a_real_pulse_is_found_at_its_rate_and_shows_no_tidal_wave(piece: int) -> None:
    place = find_spec("heartpy")
    assert place is not None
    assert place.origin is not None
    recorded = np.loadtxt(Path(place.origin).parent / "data" / "data.csv", skiprows=1)[1000 * piece :][:1000]  # 100 Hz
    volume = np.interp(np.arange(10_000) / 1000, np.arange(1000) / 100, recorded - recorded.mean())
    signals = simulated_signals(ARRAY, 2, 0.2 * volume / np.abs(volume).max(), 1e-3, np.random.default_rng(piece))
    reading = localize.PulseReader(ARRAY, 1e-3).read(signals)
    assert reading.found
    line = np.abs(np.fft.rfft(volume * np.hanning(len(volume)), 2**18))
    beats = slice(round(40 / 60 * 2**18 / 1000), round(120 / 60 * 2**18 / 1000))
    strongest = 60 * (beats.start + line[beats].argmax()) * 1000 / 2**18
    assert reading.rate == pytest.approx(strongest, abs=3.0)
    assert np.isnan(reading.waves["tidal"]).mean() > 0.8
