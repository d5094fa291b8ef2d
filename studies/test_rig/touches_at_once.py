"""Frames of several touches at once on the sensor of a virtual rig, to evaluate decoders of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from acoustic_fem.library.solving import solve
from geometry.ground.argument_checks import check_choice
from geometry.ground.typed import Array
from localize.live.front_end import HighPass
from localize.live.stream_options import HIGH_PASS
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.frames import FRAME
from localize.signals.stimulus import SCALED_AT
from studies.test_rig.virtual_rig import HEARD, Recorder, Rig

StrokeKind = Literal["tap", "press"]
"""Kind of the touches of a frame."""
SHAPES = ("sin^2", "skewed", "Gaussian")
"""Shapes of taps, one of which is drawn for each."""
_BEFORE, _SECONDS, _SILENCE = 0.3, 2.0, 5.0
_TAP, _PRESS_RISE, _PRESS_HOLD = (0.015, 0.1), (0.05, 0.2), (0.3, 0.8)
_FIRST_ONSET, _LOUDEST, _WEAKEST = (0.02, 0.05), (0.3, 3.0), 0.3
_FADE = (125.0, 150.0)
#: Recorder without hum: a stream takes that out before it decides.
_RECORDER = Recorder(hum=0.0, output="pressure", seconds=_SECONDS + _SILENCE)


@dataclass(frozen=True, eq=False)
class TouchFrame:
    """Frame of touches at once."""

    frame: Array
    """Samples behind the high-pass of a stream, (n_microphone, 250) float64, Pa."""
    points: tuple[int, ...]
    """Touched points, from 1."""
    onsets: tuple[float, ...]
    """Beginnings of the touches, s after the beginning of the frame; of a Gaussian, two and a half deviations before
    its peak."""


class FrameRig:
    """Generator of such frames on the sensor of a rig.

    A membrane moves as a stroke, the pressure in its cavity is that of the design for such a movement, and the path to
    the microphones is that of the rig's sensor. Below the frequencies of the rig, the sensor deviates from the design
    as it does at the lowest of them.

    Args:
        rig: the made sensor.
    """

    def __init__(self, rig: Rig) -> None:
        self._rig = rig
        self._nominal = response_of(solve(rig.design, np.geomspace(*HEARD, 150), "lumped"))
        self._count = round((_SECONDS + _SILENCE) * _RECORDER.rate)
        grid = np.fft.rfftfreq(self._count, 1 / _RECORDER.rate).astype(np.float64)
        self._inside = (grid > 0) & (grid <= _FADE[1])
        frequency = grid[self._inside]
        known = frequency.clip(HEARD[0])
        heard, cavity = self._nominal.between(frequency)
        _, scale = self._nominal.between(np.array([SCALED_AT]))
        assert cavity is not None
        assert scale is not None
        deviation = rig.transfer_function(known) / self._nominal.between(known)[0]
        fade = ((_FADE[1] - frequency) / (_FADE[1] - _FADE[0])).clip(0, 1)
        self._paths = heard * deviation * (fade * cavity / np.abs(scale))[:, None]

    def measured_response(self, error: float, seed: int) -> ArrayResponse:
        """Transfer functions of the rig's sensor, measured with an error.

        Args:
            error: standard deviation of the smooth error of each transfer function, as a fraction.
            seed: of the errors.
        """
        frequency = np.arange(0.5, 126.0, 0.5)
        random = np.random.default_rng([seed, 77])
        exact = self._rig.transfer_function(frequency)
        shape = (2, 4, *exact.shape[:2], 1)
        waves = np.cos(np.pi * np.arange(4)[:, None, None, None] * np.log10(2 * frequency) / 2.4)
        level, phase = (random.standard_normal(shape) * waves).sum(1) / 2
        return replace(
            self._nominal,
            transfer_function=exact * np.exp(error * (level + 1j * phase)),
            frequency=frequency,
            cavity_response=self._nominal.between(frequency)[1],
            closed_form=None,
            vent_ratio=None,
            ambient_response=None,
        )

    def frame(self, points: Sequence[int], apart: float, kind: StrokeKind, random: np.random.Generator) -> TouchFrame:
        """Frame of touches, with the noise and the wandering zero of a recorder.

        The heights are 0.3 to 3 Pa, those of the others 0.3 to 1 of the highest. Taps last 15 to 100 ms, presses rise
        in 50 to 200 ms and are held for 0.3 to 0.8 s.

        Args:
            points: numbers of one or more points, from 1, in the order of time.
            apart: time from each touch to the next, s.
            kind: of all touches.
            random: draws shapes, heights and noise.

        Raises:
            Refusal: an unknown kind.
        """
        check_choice("kind", kind, ("tap", "press"))
        time = np.arange(self._count) / _RECORDER.rate
        first = random.uniform(*_FIRST_ONSET)
        onsets = tuple(first + apart * number for number in range(len(points)))
        highest = np.exp(random.uniform(*np.log(_LOUDEST)))
        heights = highest * np.array([1.0, *random.uniform(_WEAKEST, 1.0, len(points) - 1)])
        total = np.zeros((len(self._nominal.microphones), len(time) // 2 + 1), np.complex128)
        for point, onset, height in zip(points, onsets, random.permutation(heights), strict=True):
            shape = _press(time - _BEFORE - onset, random) if kind == "press" else _tap(time - _BEFORE - onset, random)
            total[:, self._inside] += height * self._paths[point - 1] * np.fft.rfft(shape)[self._inside]
        silence = {1: np.zeros(total.shape[1], np.complex128)}
        noise = self._rig.recorded(silence, self._count, 0, self._count, _RECORDER, random)[1:]
        heard = HighPass(len(total), HIGH_PASS).begin(np.fft.irfft(total, self._count) + noise)
        begin = round(_BEFORE * _RECORDER.rate)
        return TouchFrame(heard[:, begin : begin + FRAME], tuple(map(int, points)), onsets)


def _tap(since: Array, random: np.random.Generator) -> Array:
    width = np.exp(random.uniform(*np.log(_TAP)))
    shape = SHAPES[random.integers(len(SHAPES))]
    if shape == "Gaussian":
        return np.asarray(np.exp(-0.5 * ((since - width / 2) / (width / 5)) ** 2))
    rise = width * (random.uniform(0.25, 0.75) if shape == "skewed" else 0.5)
    return _edges(since / rise, (width - since) / (width - rise))


def _press(since: Array, random: np.random.Generator) -> Array:
    shortest, longest = np.log(_PRESS_RISE)
    rise, fall = np.exp(random.uniform(shortest, longest, 2))
    end = rise + random.uniform(*_PRESS_HOLD) + fall
    return _edges(since / rise, (end - since) / fall)


def _edges(up: Array, down: Array) -> Array:
    return np.asarray(np.sin(np.pi / 2 * np.minimum(up, down).clip(0, 1)) ** 2)
