"""Maps of what is written on an array: where the pen was as far as the array knows, drawn as a picture.

The first map is the line, the fainter the less it is known where it was, in a box of its own size: how large a letter
is and where it is written says nothing. The second, ours, is the time at which the line was there, from -1 to 1:
letters that look alike are drawn in another order.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from geometry.ground.typed import Array
from localize.contacts import ContactRecorder
from localize.contacts.contact import surface_of
from localize.decoders.bayes import BayesDecoder
from localize.decoders.frame_covariance import INTEGRATION_STEP
from localize.learned.features import COLUMNS, FREQUENCIES
from localize.live.front_end import HighPass
from localize.live.options import HIGH_PASS
from localize.recognition.letter_classifier import LETTERS, Hand, written
from localize.recognition.pen_path import PAD, PenTracker
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import FRAME
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.random_streams import PURPOSES, Purpose
from localize.signals.stimulus import BAND
from localize.signals.threads import one_thread
from localize.tracking.footprints import pitch_of

WRITTEN = "letters"
"""Subject of a recognizer of letters."""
CORNER = 15.0
"""Corner of the high-pass, Hz: below it a membrane is heard long after it was left, above it while it is rubbed."""
QUIET = 4.0
"""Multiple of the microphones' noise below which a frame is silent at all of them."""
ENDS = -35.0
"""Level over the loudest from which a line is there, dB: it goes from the first hop that is as loud to the last."""
LOUDEST = 0.9
"""Share of the hops that are not louder than what counts as loudest."""
LEAST = 5e-3
"""Probability below which a place is left out."""
HOP = 32
"""Samples from frame to frame where a pad covers several points."""
LOUD = 0.05
"""Share of the loudest frames' level from which such a frame counts whole."""
LEAST_COUNT = 0.1
"""What it must count to be drawn."""
VARIANTS = 6
"""Pictures of each letter to train on, each a little turned, moved and stretched."""
_WIDTH = 0.08
"""Standard deviation of the pen that draws a picture, in its heights."""


class LineReader:
    """Reader of lines that are drawn on an array.

    Where a pad is narrower than the pitch :class:`localize.recognition.pen_path.PenTracker` goes on between the points.
    Where it always covers several points it is at their mean, each as probable as it is heard.

    Args:
        response: the array, with the places of its points.
        noise: of the microphones.

    Raises:
        Refusal: an array without places.
    """

    @one_thread()
    def __init__(self, response: ArrayResponse, noise: NoiseChoice) -> None:
        self._place, _ = surface_of(response)
        self._pen = PenTracker(response) if pitch_of(response) > PAD else None
        self._decoder = BayesDecoder(response, noise)
        level = response.noise(noise)
        self._noise = level.rms if isinstance(level, NoiseSpectrum) else level
        heard = np.arange(CORNER, BAND[1] + 0.5, INTEGRATION_STEP)
        self._usual = np.sqrt((np.abs(response.at(heard)) ** 2).mean((1, 2)))

    @one_thread()
    def line(self, signals: Array) -> Array:
        """Where the line was, hop by hop, as far as the array knows.

        Args:
            signals: (n_microphone, n_sample) float64, Pa at 1 kHz, at least a frame.

        Returns:
            (n, 4) float64: time, as a share of the recording; a place, mm; and how probable it is that the line was
            there then. Times have several places, whose probabilities make up one together with that of a lifted pen;
            where a pad covers several points, one, and how much the frame counts by how sure and how loud it is.
        """
        if self._pen is None:
            return self._mean(signals)
        frames, first = _frames(HighPass(len(signals), CORNER).begin(signals), self._pen.hop)
        if not (frames.std(2).max(1) > QUIET * self._noise).any():
            return np.zeros((0, 4))
        point = self._probability(frames).argmax(1)
        level = 20 * np.log10(np.sqrt((frames**2).mean((1, 2))) / self._usual[point])
        loudest = np.quantile(level, LOUDEST)
        there = np.flatnonzero(level > loudest + ENDS)
        kept = slice(max(int(there[0]) - 1, 0), int(there[-1]) + 2)
        floor = 20 * np.log10(self._noise / self._usual.mean()) - loudest
        probability = self._pen.probability(point[kept], level[kept] - loudest, float(floor))
        hop, cell = np.nonzero(probability > LEAST)
        time = (first[kept] + FRAME / 2)[hop] / signals.shape[1]
        return np.column_stack([time, self._pen.place[cell], probability[hop, cell]])

    def _mean(self, signals: Array) -> Array:
        """The line as the mean of the points in each frame that is not silent."""
        frames, first = _frames(HighPass(len(signals), HIGH_PASS).begin(signals), HOP)
        level = frames.std(2).max(1)
        heard = level > QUIET * self._noise
        if not heard.any():
            return np.zeros((0, 4))
        probability = self._probability(frames[heard])
        loud = np.minimum(1.0, level[heard] / (LOUD * np.quantile(level[heard], LOUDEST)))
        counts = loud * probability.max(1)
        drawn = counts >= min(LEAST_COUNT, float(counts.max()))
        return np.column_stack([first[heard] / signals.shape[1], probability @ self._place, counts])[drawn]

    def _probability(self, frames: Array) -> Array:
        """Probability per point of frames, (n, n_point)."""
        parts = np.array_split(frames, -(-len(frames) // 128))
        return np.concatenate([self._decoder.locate(np.ascontiguousarray(part)) for part in parts])

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
    begin = np.flatnonzero(np.diff(line[:, 0], prepend=-1.0))
    down = np.add.reduceat(line[:, 3], begin)
    middle = np.add.reduceat(line[:, 1:3] * line[:, 3:], begin) / down[:, None]
    middle = middle[down >= min(0.5, float(down.max()))]
    places = line[:, 1:3] - (middle.max(0) + middle.min(0)) / 2
    places = places / max(float(np.ptp(middle, axis=0).max()), 1e-3)
    if random is not None:
        places = places @ (np.eye(2) + 0.06 * random.standard_normal((2, 2))) + 0.02 * random.standard_normal(2)
    # the line fills most of the picture: its rows are twice as close as its columns
    rows, columns = np.linspace(0.65, -0.65, FREQUENCIES), np.linspace(-0.65, 0.65, COLUMNS)
    upright = np.exp((-0.5 * ((rows - places[:, 1:]) / _WIDTH) ** 2).astype(np.float32)) * line[:, 3:].astype(
        np.float32
    )
    across = np.exp((-0.5 * ((columns - places[:, :1]) / _WIDTH) ** 2).astype(np.float32))
    ends = [*begin[1:], len(line)]
    near = np.stack([upright[a:b].T @ across[a:b] for a, b in zip(begin, ends, strict=True)])
    time = line[begin, 0] - line[0, 0]
    time = 2 * time / max(float(time.max()), 1e-9) - 1
    ink = near.max(0)
    clear = np.square(np.square(near))
    when = np.tensordot(time.astype(np.float32), clear, 1) / (clear.sum(0) + 1e-6)
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


def _frames(signals: Array, hop: int) -> tuple[Array, NDArray[np.int64]]:
    """Frames of signals, (n, n_microphone, 250), and their first samples."""
    first = np.arange(0, signals.shape[1] - FRAME + 1, hop)
    return np.lib.stride_tricks.sliding_window_view(signals, FRAME, axis=1)[:, first].transpose(1, 0, 2), first
