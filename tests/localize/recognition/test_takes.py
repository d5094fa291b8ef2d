"""Simulated takes: what is heard is the convolution, takes repeat themselves, speed is taken out."""

from __future__ import annotations

import numpy as np
import pytest
from rc_line import rc_line

from geometry.refusal import Refusal
from localize.decoders.reconstruct import Reconstructor
from localize.recognition.events import EVENTS, PEAK, event_pressure
from localize.recognition.power_maps import WINDOW
from localize.recognition.takes import LEAD, SUBJECTS, TakeMaker, at_usual_speed, heard
from localize.recognition.textures import PROFILES, SPEED, Profile, felt_height, texture_pressure

ARRAY = rc_line(3, np.arange(1.0, 501.0, 2.0))
FILTERS = Reconstructor(ARRAY, 1e-3)


@pytest.mark.parametrize("name", EVENTS)
def test_an_event_is_finite_peaks_in_its_range_and_is_drawn_anew(name: str) -> None:
    one, again, other = (event_pressure(name, WINDOW + LEAD, np.random.default_rng(k)) for k in (0, 0, 1))
    assert np.isfinite(one).all()
    assert PEAK[0] * 0.9 < np.abs(one).max() < PEAK[1] * 1.1
    np.testing.assert_array_equal(one, again)
    assert not np.allclose(one, other)


def test_a_press_begins_low_and_a_release_ends_low() -> None:
    for seed in range(20):
        press, release = (event_pressure(name, WINDOW, np.random.default_rng(seed)) for name in ("press", "release"))
        assert abs(press[:40].mean()) < 0.06 * press.max()
        assert press[WINDOW // 2 :].max() > 0.6 * press.max()
        assert abs(release[-40:].mean()) < 0.06 * release.max()
        assert release[:40].mean() > 0.5 * release.max()


def test_what_is_heard_is_the_cavity_through_the_transfer_function() -> None:
    random = np.random.default_rng(0)
    tone = np.sin(2 * np.pi * 20 * np.arange(2000) / 1000)
    signals = heard(ARRAY, 1, tone, 0.0, random)
    h = ARRAY.at(np.array([20.0]))[1, :, 0]
    basis = np.exp(-2j * np.pi * 20 * np.arange(800, 1600) / 1000)
    np.testing.assert_allclose(np.abs(signals[:, 800:1600] @ basis) / 400, np.abs(h), rtol=0.03)


def test_a_take_is_the_same_whatever_was_made_before_and_of_no_other_purpose() -> None:
    maker = TakeMaker("events", FILTERS, (ARRAY,), 4)
    wave, kind = maker.waveform("training", 17)
    assert (wave.shape, kind) == ((WINDOW,), 17 % 12)
    np.testing.assert_array_equal(wave, TakeMaker("events", FILTERS, (ARRAY,), 4).waveform("training", 17)[0])
    assert not np.allclose(wave, maker.waveform("evaluation", 17)[0])
    maps, kinds = maker.maps("training", 3)
    assert (maps.shape, kinds.tolist()) == ((3, 2, 64, 32), [0, 1, 2])


def test_a_waveform_at_another_speed_comes_back_to_the_usual_one() -> None:
    profile = Profile(2.0, 0.5, 0.1)
    place = np.arange(3000) / 1000
    fast = felt_height(profile, 1.5 * SPEED * place, 0.3)
    back = at_usual_speed(fast, 1.5 * SPEED)[:2000]
    np.testing.assert_allclose(back, felt_height(profile, SPEED * place, 0.3)[:2000], atol=2e-3)
    with pytest.raises(Refusal, match=r"speed = 0\.5 mm/s must be between 1 and 100 mm/s"):
        at_usual_speed(fast, 0.5)


def test_a_point_contact_feels_the_ridges_and_a_blunt_one_nothing_of_fine_ones() -> None:
    profile, place = Profile(1.0, 0.5, 0.2), np.linspace(0, 1, 200, endpoint=False)
    assert np.ptp(felt_height(profile, place, 1e-3)) == pytest.approx(0.2, rel=0.3)  # Gibbs's ears included
    assert np.ptp(felt_height(profile, place, 3.0)) < 0.01
    with pytest.raises(Refusal, match="speed = 200 mm/s must be between"):
        texture_pressure(profile, 1000, 200.0, np.random.default_rng(0))


def test_every_texture_has_a_name_of_its_own() -> None:
    assert len({profile.name for profile in PROFILES}) == len(SUBJECTS["textures"].labels) == 8
