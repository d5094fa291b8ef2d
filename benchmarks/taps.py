"""Taps in the stream: single frames by time since onset, and touches. ``python benchmarks/taps.py [DESIGN ...]``.

Twelve points of each array are touched, one at a time, with pulses sin^2 of 30 ms and a press of a second. The
microphone noise is 1 mPa, and the Bayes decoder decides while the signals arrive.
"""

from __future__ import annotations

import sys

import numpy as np
import torch

import acoustic_fem
import geometry
import localize
from localize.live import AS_IT_COMES
from localize.signals import finger_stimuli, propagation, stimulus
from localize.signals.array_response import response_of

FREQUENCY = np.concatenate([np.arange(0.25, 20.0, 0.25), np.arange(20.0, 501.0)])
NOISE, ONSET, LENGTH = 1e-3, 300, 2000
CASES = (("tap, 1 Pa", 1.0, 30), ("tap, 10 Pa", 10.0, 30), ("press, 1 Pa", 1.0, 1000))
BINS = ((0, 50), (50, 250), (250, 300), (300, 350), (350, 400))


def pressure(peak: float, length: int) -> np.ndarray:
    """A pulse sin^2; where it is longer than 60 ms, held, with flanks of 30 ms."""
    since = np.arange(LENGTH) - ONSET
    rise = min(length / 2, 30.0)
    flank = np.clip(np.minimum(since, length - since) / rise, 0.0, 1.0)
    return peak * np.sin(0.5 * np.pi * flank) ** 2


def main(names: list[str]) -> None:
    lines = np.minimum(stimulus.line_frequencies(), 500.0)
    for name in names:
        response = response_of(acoustic_fem.solve(geometry.prototype(name), FREQUENCY, fidelity="lumped"))
        decoder, h = localize.BayesDecoder(response, NOISE), torch.from_numpy(response.at(lines))
        points = np.linspace(0, response.point_count - 1, 12).astype(int).tolist()
        for title, peak, length in CASES:
            spectrum = torch.from_numpy(np.fft.rfft(pressure(peak, length), stimulus.PERIOD, norm="forward")[:-1])
            spectrum = spectrum * finger_stimuli.top_faded((0.25, 500.0))
            frames, touches = [], []
            for point in points:
                heard = propagation.microphone_signals(spectrum[None], h[point][None], LENGTH)[0].numpy()
                heard = heard + NOISE * np.random.default_rng(point).standard_normal(heard.shape)
                events = localize.TouchStream(decoder, options=AS_IT_COMES).push(heard)
                frames += [
                    (1000 * event.time - ONSET, event.point == point + 1)
                    for event in events
                    if isinstance(event, localize.Decision) and event.state == "touch"
                ]
                touches.append([touch.point == point + 1 for touch in localize.touches_of(events, decoder)])
            shares = []
            for low, high in BINS:
                right = [is_right for since, is_right in frames if low <= since < high]
                shares.append(f"{low}-{high} ms {100 * np.mean(right):.0f} %" if right else f"{low}-{high} ms none")
            single = sum(each == [True] for each in touches)
            correct = sum(bool(each) and all(each) for each in touches)
            print(
                f"{name}, {title}: {', '.join(shares)}; one touch and right {single}, all touches right {correct} of 12"
            )


if __name__ == "__main__":
    main(sys.argv[1:] or ["array-2x6", "line-2"])
