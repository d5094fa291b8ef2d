"""Signals of taps on a library's own sensor, by Fourier series of finely sampled strokes."""

import numpy as np

from localize.signals.array_response import response_of
from localize.signals.stimulus import SCALED_AT


def heard_of_taps(library, taps, seconds=4, noise=1e-4):
    """Pressures at the microphones, (n_microphone, n) Pa at 1 kHz, with noise.

    Args:
        library: of a design.
        taps: of each the point, from 1, its beginning and its width, s, and its height, Pa in the cavity at 30 Hz.
        seconds: length; the end should be silent.
        noise: white, Pa rms.
    """
    response = response_of(library)
    rate, count = 4000, 4000 * seconds
    frequency = np.fft.rfftfreq(count, 1 / rate)
    inside = (frequency > 0) & (frequency <= 160)
    paths, cavity = response.between(frequency[inside])
    scale = np.abs(response.between(np.array([SCALED_AT]))[1])
    spectra = np.zeros((len(response.microphones), len(frequency)), complex)
    time = np.arange(count) / rate
    for point, begin, width, height in taps:
        pressed = (time > begin) & (time < begin + width)
        samples = np.where(pressed, np.sin(np.pi * (time - begin) / width) ** 2, 0.0)
        driven = height * np.fft.rfft(samples)[inside] * cavity[point - 1] / scale[point - 1]
        spectra[:, inside] += paths[point - 1] * driven
    heard = np.fft.irfft(spectra, count)[:, ::4]
    return heard + noise * np.random.default_rng(0).standard_normal(heard.shape)
