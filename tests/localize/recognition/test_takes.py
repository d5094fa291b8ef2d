"""Simulated takes: what is heard is the convolution, takes repeat themselves, speed is taken out."""

from __future__ import annotations

import numpy as np
import pytest
from rc_line import rc_line
from refusals import refused
from shared import solved

from geometry import Kind
from localize.contacts import Contact
from localize.contacts.contact import covered_force
from localize.decoders.reconstruct import Reconstructor
from localize.recognition.event_kinds import EVENTS, PEAK, event_pressure
from localize.recognition.power_maps import WINDOW
from localize.recognition.takes import LEAD, SUBJECTS, TakeMaker, at_usual_speed, simulated_signals
from localize.recognition.textures import PROFILES, SPEED, Profile, felt_height, passing_pressure, texture_pressure
from localize.signals import response_of

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
    signals = simulated_signals(ARRAY, 2, tone, 0.0, random)
    h = ARRAY.at(np.array([20.0]))[1, :, 0]
    basis = np.exp(-2j * np.pi * 20 * np.arange(800, 1600) / 1000)
    np.testing.assert_allclose(np.abs(signals[:, 800:1600] @ basis) / 400, np.abs(h), rtol=0.03)


def test_a_take_is_the_same_whatever_was_made_before_and_of_no_other_purpose() -> None:
    maker = TakeMaker("events", FILTERS, (ARRAY,), 4, 1e-3)
    wave, kind = maker.waveform("training", 17)
    assert (wave.shape, kind) == ((WINDOW,), 17 % 12)
    np.testing.assert_array_equal(wave, TakeMaker("events", FILTERS, (ARRAY,), 4, 1e-3).waveform("training", 17)[0])
    assert not np.allclose(wave, maker.waveform("evaluation", 17)[0])
    maps, kinds = maker.maps("training", 3)
    assert (maps.shape, kinds.tolist()) == ((3, 2, 64, 32), [0, 1, 2])


def test_a_waveform_at_another_speed_comes_back_to_the_usual_one() -> None:
    profile = Profile(2.0, 0.5, 0.1)
    place = np.arange(3000) / 1000
    fast = felt_height(profile, 1.5 * SPEED * place, 0.3)
    back = at_usual_speed(fast, 1.5 * SPEED)[:2000]
    np.testing.assert_allclose(back, felt_height(profile, SPEED * place, 0.3)[:2000], atol=2e-3)
    with refused(Kind.OUT_OF_RANGE, "speed", 0.5):
        at_usual_speed(fast, 0.5)


def test_a_point_contact_feels_the_ridges_and_a_blunt_one_nothing_of_fine_ones() -> None:
    profile, place = Profile(1.0, 0.5, 0.2), np.linspace(0, 1, 200, endpoint=False)
    assert np.ptp(felt_height(profile, place, 1e-3)) == pytest.approx(0.2, rel=0.3)  # Gibbs's ears included
    assert np.ptp(felt_height(profile, place, 3.0)) < 0.01
    with refused(Kind.OUT_OF_RANGE, "speed", 200.0):
        texture_pressure(profile, 1000, 200.0, np.random.default_rng(0))


def test_a_pad_that_passes_presses_as_its_contact_does_with_the_ridges_on_top(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("localize.recognition.textures.PADS", (6.0, 6.0))
    monkeypatch.setattr("localize.recognition.textures.BESIDE", (1.5, 1.5))
    array = response_of(solved("array-2x6", np.arange(1.0, 101.0, 3.0)))
    assert array.position is not None
    assert array.membrane_radius is not None
    speed, middle = 12.0, 1300.0
    pressure = passing_pressure(PROFILES[0], 2600, speed, np.random.default_rng(3), array.membrane_radius[4], middle)
    along = np.array([1.0, 0.0])
    path = array.position[4] + [0.0, 1.5] + (np.arange(2600)[:, None] - middle) / 1000 * speed * along
    covered = covered_force(Contact(np.arange(2600) / 1000, path, np.ones(2600), 6.0), array)[:, 4]
    smooth = np.convolve(pressure, np.ones(125) / 125, "same")  # three ridges at that speed
    inside = covered > 0.05 * covered.max()
    ratio = smooth[inside] / covered[inside]
    assert np.abs(ratio / np.median(ratio) - 1).max() < 0.25
    assert pressure[covered == 0].max(initial=0.0) == 0.0
    top = np.abs(np.fft.rfft(np.diff(pressure) * np.hanning(2599)))
    assert top.argmax() * 1000 / 2599 == pytest.approx(speed / PROFILES[0].period, rel=0.05)


def test_takes_that_stay_are_the_same_whatever_share_passes() -> None:
    array = response_of(solved("array-2x6", np.arange(1.0, 501.0, 2.0)))
    filters = Reconstructor(array, 1e-3)
    still, mixed = (TakeMaker("textures", filters, (array,), 4, 1e-3, passing=share) for share in (0.0, 0.5))
    alike = [np.array_equal(still.signals("training", k)[0], mixed.signals("training", k)[0]) for k in range(24)]
    assert 4 < sum(alike) < 20
    with refused(Kind.CONFLICT, "passing", 0.5):
        TakeMaker("textures", FILTERS, (ARRAY,), 4, 1e-3, passing=0.5)
    assert all(still.signals("training", k)[1:] == mixed.signals("training", k)[1:] for k in range(24))


def test_every_texture_has_a_name_of_its_own() -> None:
    assert len({profile.name for profile in PROFILES}) == len(SUBJECTS["textures"].labels) == 8
