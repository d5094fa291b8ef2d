"""Maps of what is written on an array: where the pen was as far as the array knows, drawn as a picture.

The first map is the line, the fainter the less it is known where it was, in a box of its own size: how large a letter
is and where it is written says nothing. The second, ours, is the time at which the line was there, from -1 to 1:
letters that look alike are drawn in another order.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from geometry.ground.typed import Array
from localize.contacts import ContactRecorder
from localize.contacts.contact import surface_of
from localize.decoders.bayes import BayesDecoder
from localize.decoders.frame_covariance import INTEGRATION_STEP
from localize.learned.features import COLUMNS
from localize.learned.wavelets import FREQUENCIES
from localize.live.front_end import HighPass
from localize.live.stream_options import HIGH_PASS
from localize.recognition.letter_classifier import Hand, smooth_bend, written
from localize.recognition.letter_shapes import LETTERS
from localize.recognition.pen_path import PenTracker
from localize.recognition.recognition_options import VariantOptions, WritingOptions
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import FRAME
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.random_streams import PURPOSES, Purpose
from localize.signals.stimulus import BAND
from localize.signals.threads import one_thread
from localize.tracking.footprints import pitch_of

WRITTEN = "letters"
"""Subject of a recognizer of letters."""


class LineReader:
    """Reader of lines that are drawn on an array.

    If a pad is narrower than the pitch, :class:`localize.recognition.pen_path.PenTracker` continues the path between
    the points. If it always covers several points, its place is their mean, weighted by the loudness of each.

    Args:
        response: the array, with the places of its points.
        microphone_noise: of the microphones.
        options: numbers that tune the reading.

    Raises:
        Refusal: an array without places.
    """

    @one_thread()
    def __init__(
        self, response: ArrayResponse, microphone_noise: NoiseChoice, options: WritingOptions = WritingOptions()
    ) -> None:
        self.options = options
        self._place, _ = surface_of(response)
        self._pen = PenTracker(response, options.pen) if pitch_of(response) > options.pen.pad_radius_mm else None
        self._decoder = BayesDecoder(response, microphone_noise)
        level = response.noise(microphone_noise)
        self._noise = level.rms if isinstance(level, NoiseSpectrum) else level
        heard = np.arange(options.corner, BAND[1] + 0.5, INTEGRATION_STEP)
        self._usual = np.sqrt((np.abs(response.at(heard)) ** 2).mean((1, 2)))

    @one_thread()
    def line(self, signals: Array) -> Array:
        """Places of the line, hop by hop, as far as the array knows.

        Args:
            signals: (n_microphone, n_sample) float64, Pa at 1 kHz, at least a frame.

        Returns:
            (n, 4) float64: time, as a share of the recording; a place, mm; and how probable it is that the line was
            there then. Times have several places, whose probabilities make up one together with that of a lifted pen;
            where a pad covers several points, one, and how much the frame counts by how sure and how loud it is.
        """
        if self._pen is None:
            return self._mean(signals)
        frames, first = _frames(HighPass(len(signals), self.options.corner).begin(signals), self._pen.hop)
        if not (frames.std(2).max(1) > self.options.quiet * self._noise).any():
            return np.zeros((0, 4))
        point = self._probability(frames).argmax(1)
        level = 20 * np.log10(np.sqrt((frames**2).mean((1, 2))) / self._usual[point])
        loudest = np.quantile(level, self.options.loudest_quantile)
        there = np.flatnonzero(level > loudest + self.options.ends)
        kept = slice(max(int(there[0]) - 1, 0), int(there[-1]) + 2)
        floor = 20 * np.log10(self._noise / self._usual.mean()) - loudest
        probability = self._pen.probability(point[kept], level[kept] - loudest, float(floor))
        hop, cell = np.nonzero(probability > self.options.least_probability)
        time = (first[kept] + FRAME / 2)[hop] / signals.shape[1]
        return np.column_stack([time, self._pen.place[cell], probability[hop, cell]])

    def _mean(self, signals: Array) -> Array:
        """The line as the mean of the points in each frame that is not silent."""
        frames, first = _frames(HighPass(len(signals), HIGH_PASS).begin(signals), self.options.hop)
        level = frames.std(2).max(1)
        heard = level > self.options.quiet * self._noise
        if not heard.any():
            return np.zeros((0, 4))
        probability = self._probability(frames[heard])
        loudest = np.quantile(level[heard], self.options.loudest_quantile)
        loud = np.minimum(1.0, level[heard] / (self.options.loud * loudest))
        counts = loud * probability.max(1)
        drawn = counts >= min(self.options.least_count, float(counts.max()))
        return np.column_stack([first[heard] / signals.shape[1], probability @ self._place, counts])[drawn]

    def _probability(self, frames: Array) -> Array:
        """Probability per point of frames, (n, n_point)."""
        parts = np.array_split(frames, -(-len(frames) // 128))
        return np.concatenate([self._decoder.locate(np.ascontiguousarray(part)) for part in parts])

    def begins(self, signals: Array, first: int) -> int:
        """Point, from 1, that is detected first from a sample on.

        Args:
            signals: (n_microphone, n_sample) float64, Pa at 1 kHz.
            first: the sample.
        """
        begin = max(0, min(first, signals.shape[1] - FRAME))
        return int(self._decoder.locate(signals[:, begin : begin + FRAME]).argmax()) + 1


def letter_maps(
    line: Array,
    random: np.random.Generator | None = None,
    pen_width: float = WritingOptions.pen_width,
    variants: VariantOptions = VariantOptions(),
) -> Tensor:
    """Maps of one line.

    Args:
        line: (n, 4) float64, as of :meth:`LineReader.line`.
        random: draws a variant of the line (:func:`varied`); None for as it is.
        pen_width: standard deviation of the pen that draws the picture, in its heights.
        variants: how much variants differ.

    Returns:
        (2, 64, 32) float32: the line, 0 to 1, top row first; and its time, -1 to 1, where there is a line.
    """
    if not len(line):
        return torch.zeros(2, FREQUENCIES, COLUMNS)
    if random is not None:
        line = varied(line, random, variants)
    begin = np.flatnonzero(np.diff(line[:, 0], prepend=-1.0))
    down = np.add.reduceat(line[:, 3], begin)
    middle = np.add.reduceat(line[:, 1:3] * line[:, 3:], begin) / down[:, None]
    middle = middle[down >= min(0.5, float(down.max()))]
    places = line[:, 1:3] - (middle.max(0) + middle.min(0)) / 2
    places = places / max(float(np.ptp(middle, axis=0).max()), 1e-3)
    # the line fills most of the picture: its rows are twice as close as its columns
    rows, columns = np.linspace(0.65, -0.65, FREQUENCIES), np.linspace(-0.65, 0.65, COLUMNS)
    upright = np.exp((-0.5 * ((rows - places[:, 1:]) / pen_width) ** 2).astype(np.float32)) * line[:, 3:].astype(
        np.float32
    )
    across = np.exp((-0.5 * ((columns - places[:, :1]) / pen_width) ** 2).astype(np.float32))
    ends = [*begin[1:], len(line)]
    near = np.stack([upright[a:b].T @ across[a:b] for a, b in zip(begin, ends, strict=True)])
    time = line[begin, 0] - line[0, 0]
    time = 2 * time / max(float(time.max()), 1e-9) - 1
    ink = near.max(0)
    clear = np.square(np.square(near))
    when = np.tensordot(time.astype(np.float32), clear, 1) / (clear.sum(0) + 1e-6)
    if random is not None and random.random() < variants.without_time:
        when = np.zeros_like(when)
    return torch.from_numpy(np.stack([ink, ink * when]).astype(np.float32))


def varied(line: Array, random: np.random.Generator, options: VariantOptions = VariantOptions()) -> Array:
    """Line as another hand might have drawn it: slanted, turned, stretched, bent, in part not detected, or backwards.

    Args:
        line: (n, 4) float64, as of :meth:`LineReader.line`, n at least 1.
        random: draws the changes.
        options: how large they are.

    Returns:
        (m, 4) float64, m at most n.
    """
    low, high = line[:, 1:3].min(0), line[:, 1:3].max(0)
    size = max(float((high - low).max()), 1e-3)
    places = (line[:, 1:3] - (low + high) / 2) / size
    turn = np.radians(options.turn * random.standard_normal())
    turned = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    slant, width = options.slant * random.standard_normal(), options.width * random.standard_normal()
    bends = options.bend * random.standard_normal((2, 3, 3))
    places = places @ (turned @ np.array([[np.exp(width), slant], [0.0, 1.0]])).T + smooth_bend(places, bends)
    line = np.column_stack([line[:, 0], size * places, line[:, 3]])
    if random.random() < options.backwards:
        line = line[::-1] * [-1.0, 1.0, 1.0, 1.0] + [1.0, 0.0, 0.0, 0.0]
    if random.random() < options.with_gap:
        time = np.unique(line[:, 0])
        length = int(len(time) * random.uniform(*options.gap))
        begin = int(random.integers(max(1, len(time) - length)))
        seen = (line[:, 0] < time[begin]) | (line[:, 0] > time[min(len(time) - 1, begin + length)])
        line = line[seen] if seen.any() else line
    return line


@dataclass(frozen=True, eq=False)
class LetterMaker:
    """Maker of simulated letters: take i is letter i modulo 26, the same whatever was made before."""

    readers: tuple[LineReader, ...]
    """Readers of the libraries that lines are read with, one for all sensors or one for each."""
    sensors: tuple[ArrayResponse, ...]
    """Sensors that are written on, one after the other."""
    seed: int = 0
    """Seed of the letters."""
    microphone_noise: NoiseChoice = "design"
    """Noise of the microphones."""
    hands: tuple[Hand, ...] = (Hand(),)
    """Hands that write, one after the other."""

    def lines(self, purpose: Purpose, count: int, report: Callable[[float], None] | None = None) -> list[Array]:
        """Lines of letters 0 to ``count - 1``, (n, 4) float64 each, as of :meth:`LineReader.line`."""
        recorders = [
            ContactRecorder(each, microphone_noise=self.microphone_noise, seed=self.seed, purpose=purpose)
            for each in self.sensors
        ]
        found = []
        for number in range(count):
            sensor = number // len(LETTERS) % len(self.sensors)
            letter = LETTERS[number % len(LETTERS)]
            contact = written(letter, self.sensors[sensor], self._hand(number), self.seed, purpose, number)
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
            made = [letter_maps(line, random, variants=self._hand(number).variants) for _ in range(variants)]
            maps += made or [letter_maps(line)]
            kinds += [number % len(LETTERS)] * max(1, variants)
        return torch.stack(maps), torch.tensor(kinds)

    def _hand(self, number: int) -> Hand:
        """Hand that writes a letter: all letters on all sensors, then the next hand."""
        return self.hands[number // len(LETTERS) // len(self.sensors) % len(self.hands)]


def _frames(signals: Array, hop: int) -> tuple[Array, NDArray[np.int64]]:
    """Frames of signals, (n, n_microphone, 250), and their first samples."""
    first = np.arange(0, signals.shape[1] - FRAME + 1, hop)
    return np.lib.stride_tricks.sliding_window_view(signals, FRAME, axis=1)[:, first].transpose(1, 0, 2), first
