"""Touches of fingers as they come: taps, presses and slides in turn, behind the high-pass of the streams."""

from __future__ import annotations

import math

import numpy as np
import torch
from numpy.typing import NDArray

import localize
from localize.live.front_end import HighPass
from localize.live.stream_options import HIGH_PASS
from localize.signals import finger_stimuli
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import FRAME
from localize.signals.random_streams import Purpose, between, log_between, random_words, uniform
from localize.signals.stimulus import (
    LINE_COUNT,
    PERIOD,
    SAMPLE_LENGTH,
    SAMPLE_RATE,
    Device,
    Stimuli,
    StimulusSource,
    multi_sines,
)

NOISE = 1e-3
#: Pa rms: frames below at all microphones are passed over, as a stream does.
QUIET = 4 * NOISE


def presses(seed: int, purpose: Purpose, start: int, count: int, band: tuple[float, float], device: Device) -> Stimuli:
    """A pressure that rises within 10 to 60 ms, is held for 50 to 400 ms and is let go; it rises in the last 300 ms."""
    drawn = uniform(random_words(seed, purpose, "recording", start, count, 3), device)
    rise, fall = (SAMPLE_RATE * log_between(0.01, 0.06, drawn[:, k, 0]) for k in (0, 1))
    hold = SAMPLE_RATE * log_between(0.05, 0.4, drawn[:, 0, 1])
    begin = SAMPLE_RATE * between(0.7, 0.9, drawn[:, 2, 0])
    time = torch.arange(SAMPLE_LENGTH, device=device)
    up, down = ((time - at[:, None]) / length[:, None] for at, length in ((begin, rise), (begin + rise + hold, fall)))
    shape = torch.sin(0.5 * math.pi * up.clamp(0, 1)) ** 2 - torch.sin(0.5 * math.pi * down.clamp(0, 1)) ** 2
    peak = log_between(0.3, 10.0, drawn[:, 1, 1])
    spectrum = torch.fft.rfft(peak[:, None] * shape, n=PERIOD, norm="forward")[:, :LINE_COUNT]
    none = torch.zeros(count, dtype=torch.int64, device=device)
    return Stimuli(spectrum * finger_stimuli.top_faded(band, device), none - 1, none)


#: Name -> touches.
KINDS: dict[str, StimulusSource] = {
    "taps, presses and slides": finger_stimuli.Mixture((finger_stimuli.taps, presses, finger_stimuli.friction)),
    "multi-sines": multi_sines,
}
NATURAL, SINES = KINDS


def touched(
    truth: ArrayResponse, kind: str, count: int, seed: int, purpose: Purpose = "training"
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Frames of points drawn at random, (n, n_microphone, 250), and the points, (n,); n is count less quiet frames."""
    points = truth.point_count
    made = 64 * -(-points * -(-3 * count // points) // 64)
    heard = localize.TouchGenerator(truth, seed, purpose, NOISE, stimuli=KINDS[kind]).samples(0, made)
    drawn = np.random.default_rng(seed).permutation(made)[:count]
    signals = heard.signals[drawn].double().numpy()
    frames = np.stack([HighPass(signals.shape[1], HIGH_PASS).begin(one)[:, -FRAME:] for one in signals])
    loud = frames.std(2).max(1) > QUIET
    return frames[loud], heard.point[drawn].numpy() - 1[loud]
