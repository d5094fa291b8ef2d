"""Maps of waveforms: a tone is where it should be, loudness says nothing, signs are told."""

from __future__ import annotations

import numpy as np

from localize.learned.wavelets import wavelet_frequencies
from localize.recognition.power_maps import MAPS, RANGE, WINDOW, maps_of

TIME = np.arange(WINDOW) / 1000


def test_a_tone_has_its_power_in_its_own_row() -> None:
    for tone in (8.0, 30.0, 75.0):
        power = maps_of(np.sin(2 * np.pi * tone * TIME)[None])[0, 0].numpy()
        loudest = wavelet_frequencies()[power[:, 8:24].mean(1).argmax()]
        assert abs(loudest - tone) < 1.6  # a row is 1.57 Hz
        assert power.max() == 0.0
        assert power.min() >= -RANGE


def test_a_late_tone_has_its_power_late() -> None:
    power = maps_of((np.sin(2 * np.pi * 40 * TIME) * (TIME > 0.7))[None])[0, 0].numpy()
    assert power[:, 24:].max() == 0.0
    assert power[20:, :18].max() < -30


def test_loudness_and_offset_say_nothing_and_the_sign_does() -> None:
    wave = np.cumsum(np.random.default_rng(0).standard_normal(WINDOW))[None]
    maps, louder, negative = (maps_of(each).numpy() for each in (wave, 1e-3 * wave + 7.0, -wave))
    assert maps.shape == (1, MAPS, 64, 32)
    np.testing.assert_allclose(maps, louder, atol=0.02)
    np.testing.assert_allclose(maps[:, 0], negative[:, 0], atol=1e-4)
    np.testing.assert_allclose(maps[:, 1], -negative[:, 1], atol=1e-5)


def test_no_waveform_has_no_maps() -> None:
    assert maps_of(np.zeros((0, WINDOW))).shape == (0, MAPS, 64, 32)
