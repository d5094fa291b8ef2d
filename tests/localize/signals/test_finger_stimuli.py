"""Taps, friction, the pulse wave and recordings: in Pa, within their second, each sample made again alone."""

import numpy as np
import pytest
import torch
from refusals import refused
from scipy import stats
from scipy.io import wavfile

from geometry import Kind
from localize.signals import finger_stimuli as fingers, stimulus
from localize.signals.finger_stimuli import RecordedStimulus
from localize.signals.stimulus_kinds import STIMULI, Mixture

WIDE = (0.25, 499.75)


def pressure(source, count=300, band=WIDE, seed=0):
    """(count, 4000) Pa: the second and the silence after it."""
    return stimulus.time_signal(source(seed, "training", 0, count, band, "cpu").spectrum, stimulus.PERIOD)


@pytest.fixture
def wav(tmp_path):
    """Two seconds of noise at 8 kHz, below 100 Hz, with a peak of half of full scale."""
    draw = np.random.default_rng(0)
    noise = np.convolve(draw.normal(size=16000), np.hanning(160), "same")
    path = tmp_path / "finger.wav"
    wavfile.write(path, 8000, (16384 * noise / np.abs(noise).max()).astype(np.int16))
    return path


@pytest.mark.parametrize("name", [*STIMULI, "mixture", "recording"])
def test_a_sample_made_alone_is_the_one_made_in_a_batch(name, wav):
    source = {
        **STIMULI,
        "mixture": Mixture((fingers.taps, stimulus.multi_sines, fingers.friction)),
        "recording": RecordedStimulus(wav, 1.0),
    }[name]
    whole = source(5, "training", 0, 200, WIDE, "cpu")
    for start, count in ((0, 1), (63, 2), (150, 50)):
        part = source(5, "training", start, count, WIDE, "cpu")
        assert torch.allclose(part.spectrum, whole.spectrum[start : start + count], atol=1e-7)
        assert torch.equal(part.interval, whole.interval[start : start + count])
    other = source(6, "training", 0, 200, WIDE, "cpu").spectrum
    assert not torch.allclose(other, whole.spectrum, atol=1e-4)


def test_taps_are_single_pulses_of_5_to_100_ms_in_the_last_quarter_of_a_second():
    taps = pressure(fingers.taps, 800).numpy()
    assert np.abs(taps[:, :740]).max(1) == pytest.approx(np.zeros(800), abs=0.02 * float(taps.max()))
    peak = taps.max(1)
    assert (peak.min() > 0.09, peak.max() < 10.1) == (True, True)
    # Long ones are not touched by the fading at the top of the band: sin^2 is above one half for half of its length.
    length = 2 * (taps > peak[:, None] / 2).sum(1)
    assert (length.min() >= 4, length.max() <= 102) == (True, True)
    assert stats.kstest(np.log(length[length > 20] / 20), stats.uniform(0, np.log(5)).cdf).pvalue > 1e-3
    assert (np.argmax(taps, 1) - length / 2 >= 745).all()
    assert (np.argmax(taps, 1) + length / 2 <= 955).all()


def test_friction_is_noise_of_a_moving_level_in_its_band_silent_outside_its_second():
    rubbed = pressure(fingers.friction, 400).numpy()
    rms = rubbed[:, :1000].std(1)
    assert (rms.min() > 0.015, rms.max() < 1.05) == (True, True)
    assert np.abs(rubbed[:, 1100:3900]).max() < 0.01 * np.abs(rubbed).max()
    power = np.abs(np.fft.rfft(rubbed[:, :1000] * np.hanning(1000))) ** 2
    share = power / power.sum(1, keepdims=True)
    assert share[:, 310:].sum(1).max() < 0.02
    assert share[:, :2].sum(1).max() < 0.2
    quarters = rubbed[:, :1000].reshape(400, 4, 250).std(-1)
    assert np.median(quarters.max(1) / quarters.min(1)) > 1.5


def test_a_pulse_wave_beats_45_to_105_times_a_minute_and_repeats_exactly():
    spectrum = fingers.pulse_wave(0, "training", 0, 400, WIDE, "cpu").spectrum
    first = (spectrum.abs() > 0).int().argmax(1)
    assert sorted(set(first.tolist())) == [3, 4, 5, 6, 7]
    wave = pressure(fingers.pulse_wave, 400)
    assert (wave.amax(1).min() > 0.019, wave.amax(1).max() < 0.51) == (True, True)
    four = first == 4
    assert torch.allclose(wave[four, :1000], wave[four, 1000:2000], atol=1e-6)
    # One systole a beat: the wave passes nine tenths of its peak upwards once.
    above = wave > 0.9 * wave.amax(1, keepdim=True)
    assert torch.equal((above & ~above.roll(1, 1)).sum(1), first)


@pytest.mark.parametrize("name", list(STIMULI))
def test_nothing_is_excited_beyond_the_band(name):
    spectrum = STIMULI[name](0, "training", 0, 50, (1.0, 100.0), "cpu").spectrum
    assert (spectrum[:, 401:] == 0).all()


def test_a_mixture_takes_its_sources_equally_often():
    mixed = Mixture((fingers.taps, stimulus.multi_sines))(0, "training", 0, 64 * 200, WIDE, "cpu")
    share = (mixed.interval == -1).double().mean().item()
    assert share == pytest.approx(0.5, abs=0.12)
    assert (mixed.interval.reshape(200, 64) == -1).any(1).eq((mixed.interval.reshape(200, 64) == -1).all(1)).all()


def test_a_recording_is_cut_resampled_and_scaled_to_pascals(wav):
    cuts = pressure(RecordedStimulus(wav, 4.0), 50).numpy()[:, 50:950]
    assert 1.0 < np.abs(cuts).max() <= 2.0 * 1.02
    _, values = wavfile.read(wav)
    source = 4.0 * values[::8] / 32768
    window = np.lib.stride_tricks.sliding_window_view(source, 900)
    for cut in cuts[:5]:
        assert np.abs(window - cut).max(1).min() < 0.02


def test_formats_of_wav_files_have_the_same_scale(tmp_path):
    wave = 0.5 * np.sin(2 * np.pi * 20 * np.arange(3000) / 1000)
    for name, values in {
        "16": (wave * 2**15).astype(np.int16),
        "32": (wave * 2**31).astype(np.int32),
        "8": (wave * 128 + 128).astype(np.uint8),
        "float": wave.astype(np.float32),
    }.items():
        wavfile.write(tmp_path / f"{name}.wav", 1000, values)
        read = RecordedStimulus(tmp_path / f"{name}.wav", 2.0).pressure.numpy()
        assert np.abs(read - 2 * wave).max() < 0.02


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("missing", Kind.MISSING),
        ("text", Kind.UNREADABLE),
        ("cut", Kind.UNREADABLE),
        ("stereo", Kind.MISMATCH),
        ("short", Kind.UNSUITABLE),
        ("silent", Kind.UNSUITABLE),
        ("nan", Kind.UNSUITABLE),
    ],
)
def test_recordings_that_cannot_be_used_are_refused_by_file_and_reason(tmp_path, wav, name, kind):
    path = tmp_path / f"{name}.wav"
    wave = np.sin(np.arange(3000) / 30).astype(np.float32)
    match name:
        case "text":
            path.write_text("no sound")
        case "cut":
            path.write_bytes(wav.read_bytes()[:30])
        case "stereo":
            wavfile.write(path, 1000, np.stack([wave, wave], 1))
        case "short":
            wavfile.write(path, 1000, wave[:500])
        case "silent":
            wavfile.write(path, 1000, 0 * wave)
        case "nan":
            wavfile.write(path, 1000, np.where(wave > 0.9, np.nan, wave))
    with refused(kind, file=path):
        RecordedStimulus(path, 1.0)


@pytest.mark.parametrize("scale", [0.0, -1.0, float("nan"), float("inf")])
def test_a_scale_of_a_recording_that_is_no_scale_is_refused(wav, scale):
    with refused(Kind.OUT_OF_RANGE, "full_scale"):
        RecordedStimulus(wav, scale)


def test_presses_rise_anywhere_in_the_second_are_held_and_end_before_the_next():
    pressed = pressure(fingers.presses, 400).numpy()
    peak = pressed.max(1)
    assert (peak.min() > 0.09, peak.max() < 12.0) == (True, True)  # trembling adds to a peak of at most 10 Pa
    high = pressed > peak[:, None] / 2
    length = high.sum(1)
    # From half of a rise to half of a fall: hold and half of both, 0.15 to 1.0 s.
    assert (length.min() > 130, length.max() < 1010) == (True, True)
    begin = np.argmax(high, 1)
    assert (begin.min() < 150, begin.max() > 800) == (True, True)
    assert np.abs(pressed[:, 2200:]).max() < 0.02 * peak.max()


def test_slides_come_and_go_within_the_second_and_are_rough():
    passed = pressure(fingers.slides, 400).numpy()
    peak = passed.max(1)
    assert (peak.min() > 0.09, peak.max() < 25.0) == (True, True)
    assert np.abs(passed[:, 1100:]).max() < 0.02 * peak.max()
    length = (passed > peak[:, None] / 2).sum(1)
    assert (length.min() < 40, length.max() > 300) == (True, True)
    # A finger that passes in at least 0.3 s rises slowly; what is above 20 Hz then is roughness.
    slow = length > 150
    spectrum = np.abs(np.fft.rfft(passed[slow], axis=1)) ** 2
    frequency = np.fft.rfftfreq(passed.shape[1], 1e-3)
    share = spectrum[:, frequency > 20].sum(1) / spectrum[:, frequency > 0].sum(1)
    assert np.median(share) > 1e-3


def test_a_mixture_draws_its_sources_by_their_shares():
    mixture = Mixture((fingers.taps, stimulus.multi_sines), (9.0, 1.0))
    drawn = np.array(mixture.which(0, "training", 0, 4000))
    assert (drawn == 1).mean() == pytest.approx(0.1, abs=0.02)
    assert mixture.which(0, "training", 100, 3) == drawn[100:103].tolist()
    even = Mixture((fingers.taps, stimulus.multi_sines))
    assert np.mean(even.which(0, "training", 0, 4000)) == pytest.approx(0.5, abs=0.03)


@pytest.mark.parametrize("shares", [(1.0,), (1.0, 0.0), (1.0, -1.0), (1.0, float("nan")), (1.0, float("inf"))])
def test_a_mixture_refuses_shares_that_are_none(shares):
    with refused(Kind.OUT_OF_RANGE, "shares", shares):
        Mixture((fingers.taps, stimulus.multi_sines), shares)
    with refused(Kind.UNSUITABLE, "sources"):
        Mixture(())
