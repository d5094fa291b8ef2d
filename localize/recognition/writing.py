"""Maps of what is written on an array: where the decoder hears the touch, frame by frame, drawn as a picture.

The first map is the line as the points have heard it, in a box of its own size: how large a letter is and where it is
written says nothing. The second, ours, is the time at which the line was there, from -1 to 1: letters that look alike
are drawn in another order.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from localize.contacts import ContactRecorder
from localize.decoders.bayes import BayesDecoder
from localize.learned.features import COLUMNS, FREQUENCIES
from localize.live.front_end import HIGH_PASS, HighPass
from localize.recognition.letters import LETTERS, Hand, written
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import FRAME
from localize.signals.noise import NoiseChoice, NoiseSpectrum
from localize.signals.random_streams import PURPOSES, Purpose
from localize.signals.threads import one_thread

Array = NDArray[np.float64]

WRITTEN = "letters"
"""Subject of a recognizer of letters."""
HOP = 32
"""Samples from frame to frame."""
QUIET = 4.0
"""Multiple of the microphones' noise below which a frame is silent at all of them."""
LOUD = 0.05
"""Share of the loudest frames' level from which a frame counts whole."""
LEAST_COUNT = 0.1
"""What a frame must count to be drawn."""
VARIANTS = 6
"""Pictures of each letter to train on, each a little turned, moved and stretched."""
_WIDTH = 0.08
"""Standard deviation of the pen that draws a picture, in its heights."""


class LineReader:
    """LineReader of lines that are drawn on an array.

    Args:
        response: the array, with the places of its points.
        noise: of the microphones.

    Raises:
        Refusal: an array without places.
    """

    def __init__(self, response: ArrayResponse, noise: NoiseChoice) -> None:
        from localize.contacts.contact import surface_of

        self._place, _ = surface_of(response)
        self._decoder = BayesDecoder(response, noise)
        level = response.noise(noise)
        self._quiet = QUIET * (level.rms if isinstance(level, NoiseSpectrum) else level)

    @one_thread()
    def line(self, signals: Array) -> Array:
        """Places that are heard, frame by frame.

        Args:
            signals: (n_microphone, n_sample) float64, Pa at 1 kHz, at least a frame.

        Returns:
            (n, 4) float64: time, as a share of the recording; place, mm, the mean of the points, each as probable as it
            is heard; and how much that counts, 0 to 1, by how sure and how loud the frame is. Silent frames are left
            out.
        """
        signals = HighPass(len(signals), HIGH_PASS).begin(signals)
        first = np.arange(0, signals.shape[1] - FRAME + 1, HOP)
        frames = np.lib.stride_tricks.sliding_window_view(signals, FRAME, axis=1)[:, first].transpose(1, 0, 2)
        level = frames.std(2).max(1)
        heard = level > self._quiet
        if not heard.any():
            return np.zeros((0, 4))
        probability = np.concatenate(
            [self._decoder.locate(np.ascontiguousarray(part)) for part in _parts(frames[heard])]
        )
        loud = np.minimum(1.0, level[heard] / (LOUD * np.quantile(level[heard], 0.9)))
        counts = loud * probability.max(1)
        return np.column_stack([first[heard] / signals.shape[1], probability @ self._place, counts])

    def begins(self, signals: Array, first: int) -> int:
        """Point, from 0, that is heard first from a sample on.

        Args:
            signals: (n_microphone, n_sample) float64, Pa at 1 kHz.
            first: the sample.
        """
        begin = max(0, min(first, signals.shape[1] - FRAME))
        return int(self._decoder.locate(signals[:, begin : begin + FRAME]).argmax())


def letter_maps(line: Array, random: np.random.Generator | None = None) -> Tensor:
    """Maps of one line.

    Args:
        line: (n, 4) float64, as of :meth:`LineReader.line`.
        random: turns, moves and stretches it a little; None for as it is.

    Returns:
        (2, 64, 32) float32: the line, 0 to 1, top row first; and its time, -1 to 1, where there is a line.
    """
    if not len(line):
        return torch.zeros(2, FREQUENCIES, COLUMNS)
    line = line[line[:, 3] >= min(LEAST_COUNT, float(line[:, 3].max()))]
    places = line[:, 1:3]
    places = places - (places.max(0) + places.min(0)) / 2
    places = places / max(float(np.ptp(places, axis=0).max()), 1e-3)
    if random is not None:
        places = places @ (np.eye(2) + 0.06 * random.standard_normal((2, 2))) + 0.02 * random.standard_normal(2)
    # the line fills most of the picture: its rows are twice as close as its columns
    rows, columns = np.linspace(0.65, -0.65, FREQUENCIES), np.linspace(-0.65, 0.65, COLUMNS)
    near = np.exp(-0.5 * ((rows[None, :] - places[:, 1:]) / _WIDTH) ** 2)[:, :, None]
    near = near * np.exp(-0.5 * ((columns[None, :] - places[:, :1]) / _WIDTH) ** 2)[:, None, :] * line[:, 3, None, None]
    time = line[:, 0] - line[:, 0].min()
    time = 2 * time / max(float(time.max()), 1e-9) - 1
    ink = near.max(0)
    when = (near**4 * time[:, None, None]).sum(0) / ((near**4).sum(0) + 1e-6)
    return torch.from_numpy(np.stack([ink, ink * when]).astype(np.float32))


@dataclass(frozen=True, eq=False)
class LetterMaker:
    """Maker of simulated letters: take i is letter i modulo 26, the same whatever was made before."""

    readers: tuple[LineReader, ...]
    """Readers of the libraries that lines are read with, one for all sensors or one for each."""
    sensors: tuple[ArrayResponse, ...]
    """Sensors that are written on, one after the other."""
    seed: int = 0
    """Of the letters."""
    noise: NoiseChoice = "design"
    """Noise of the microphones."""
    hand: Hand = field(default_factory=Hand)
    """How letters are written."""

    def lines(self, purpose: Purpose, count: int, report: Callable[[float], None] | None = None) -> list[Array]:
        """Lines of letters 0 to ``count - 1``, (n, 4) float64 each, as of :meth:`LineReader.line`."""
        recorders = [
            ContactRecorder(each, microphone_noise=self.noise, seed=self.seed, purpose=purpose) for each in self.sensors
        ]
        found = []
        for number in range(count):
            sensor = number // len(LETTERS) % len(self.sensors)
            letter = LETTERS[number % len(LETTERS)]
            contact = written(letter, self.sensors[sensor], self.hand, self.seed, purpose, number)
            take = recorders[sensor].take(contact, number)
            found.append(self.readers[sensor % len(self.readers)].line(take.signals))
            if report:
                report((number + 1) / count)
        return found

    def maps(
        self, purpose: Purpose, count: int, report: Callable[[float], None] | None = None, variants: int = 0
    ) -> tuple[Tensor, Tensor]:
        """Maps of letters 0 to ``count - 1``, (count, 2, 64, 32) float32, and their kinds, (count,) int64; with
        ``variants`` so many of each instead, each a little different.
        """
        maps, kinds = [], []
        for number, line in enumerate(self.lines(purpose, count, report)):
            key = (PURPOSES.index(purpose), 2, number)
            random = np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=key))
            maps += [letter_maps(line, random) for _ in range(variants)] if variants else [letter_maps(line)]
            kinds += [number % len(LETTERS)] * max(1, variants)
        return torch.stack(maps), torch.tensor(kinds)


def _parts(frames: Array) -> list[Array]:
    return np.array_split(frames, -(-len(frames) // 128))
