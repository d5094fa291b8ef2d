"""The waveform comes back from signals made exactly, with an error that the filter knows."""

import numpy as np
import pytest
from rc_line import rc_line
from refusals import refused

import localize
from geometry import Kind
from localize.decoders.frame_covariance import source_density
from localize.signals import stimulus
from localize.signals.stimulus import time_signal

NOISE = 1e-3


@pytest.fixture(scope="module")
def array():
    return rc_line(12)


@pytest.fixture(scope="module")
def touches(array):
    """Signals of ten touches per point, and the pressure in the touched cavity."""
    made = localize.TouchGenerator(array, 0, "evaluation", NOISE).samples(0, 120)
    stimuli = stimulus.multi_sines(0, "evaluation", 0, 120, (1.0, 500.0))
    return made.signals.double().numpy(), time_signal(stimuli.spectrum).double().numpy(), made.point.numpy() - 1


def decibels(pressure, estimate):
    known = np.isfinite(estimate)
    known[:, :128] = known[:, -128:] = False  # where a window of 256 sees the ends of the recording
    return 10 * np.log10((pressure[known] ** 2).sum() / ((pressure - estimate)[known] ** 2).sum())


def of_every_point(touches, estimate):
    signals, pressure, point = touches
    return [decibels(pressure[point == k], estimate(signals[point == k], k + 1)) for k in range(12)]


def test_every_point_of_a_line_of_twelve_is_heard_above_20_db_at_16_ms(array, touches):
    reconstructor = localize.Reconstructor(array, NOISE, latency=16)
    ratios = of_every_point(touches, lambda signals, k: reconstructor.waveform(signals, k).pressure)
    assert min(ratios) > 35
    at_once = localize.Reconstructor(array, NOISE, latency=0)
    assert min(of_every_point(touches, lambda signals, k: at_once.waveform(signals, k).pressure)) < min(ratios) - 5


def test_the_short_window_inverse_of_the_paper_is_limited_by_its_window(array, touches):
    short = of_every_point(touches, lambda signals, k: localize.short_window_waveform(array, signals, k))
    longer = of_every_point(touches, lambda signals, k: localize.short_window_waveform(array, signals, k, 256, 128))
    assert min(short) > 7.73
    assert min(longer) > min(short) + 2


def test_the_band_of_two_deviations_covers_95_percent_of_gaussian_sources(array):
    """Sources with the assumed spectrum, on lines of 0.25 Hz, through the array."""
    rng = np.random.default_rng(0)
    frequency = np.arange(1, 500.0, 0.25)
    deviation = np.sqrt(source_density(frequency) * 0.25 / 4)
    spectrum = np.zeros((40, 2000), complex)
    spectrum[:, 4:] = deviation * (rng.standard_normal((40, 1996)) + 1j * rng.standard_normal((40, 1996)))
    h = np.zeros((2, 2000), complex)
    point = 6
    h[:, 4:] = array.at(frequency)[point - 1]
    source = 4000 * np.fft.irfft(spectrum, 4000)
    signals = 4000 * np.fft.irfft(spectrum[:, None] * h, 4000) + NOISE * rng.standard_normal((40, 2, 4000))
    for latency in (0, 16):
        reconstructor = localize.Reconstructor(array, NOISE, latency=latency)
        found = reconstructor.waveform(signals, point)
        error = (found.pressure - source) / found.deviation
        known = error[np.isfinite(error)]
        assert np.sqrt((known**2).mean()) == pytest.approx(1, abs=0.05)
        assert (np.abs(known) < 2).mean() == pytest.approx(0.954, abs=0.01)


def test_a_filter_that_waits_longer_is_never_less_certain(array):
    deviations = [localize.Reconstructor(array, NOISE, latency=latency).deviation(6) for latency in (0, 4, 16, 60)]
    assert deviations == sorted(deviations, reverse=True)
    noisy = localize.Reconstructor(array, 10 * NOISE, latency=16).deviation(6)
    assert noisy > deviations[2]


def test_estimates_without_a_whole_window_are_left_open(array, touches):
    reconstructor = localize.Reconstructor(array, NOISE, window=100, latency=16)
    pressure = reconstructor.waveform(touches[0][0], 1).pressure[0]
    assert np.flatnonzero(np.isfinite(pressure)).tolist() == list(range(83, 984))
    by_hand = (reconstructor.filters(1) * touches[0][0][:, :100][:, ::-1]).sum()
    assert pressure[83] == pytest.approx(by_hand, rel=1e-9)


@pytest.mark.parametrize(
    ("field", "value"), [("window", 1), ("latency", 250), ("microphone_noise", 0.0), ("source_rms", 0.0)]
)
def test_bad_arguments_are_refused(array, field, value):
    with refused(Kind.OUT_OF_RANGE, field, value):
        localize.Reconstructor(array, **{"microphone_noise": NOISE, field: value})


def test_points_and_windows_out_of_range_are_refused(array, touches):
    reconstructor = localize.Reconstructor(array, NOISE)
    with refused(Kind.OUT_OF_RANGE, "point", 13):
        reconstructor.waveform(touches[0], 13)
    with refused(Kind.OUT_OF_RANGE, "hop", 20):
        localize.short_window_waveform(array, touches[0], 1, 32, 20)
    with refused(Kind.OUT_OF_RANGE, "point", 0):
        localize.short_window_waveform(array, touches[0], 0)
    with refused(Kind.UNSUITABLE, "signals"):
        localize.Reconstructor(array, NOISE, window=1000).waveform(touches[0][..., :500], 1)
