"""Frames of recorded touches: to train on beside simulated ones, and to judge a localizer by."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from acoustic_fem.sound.sound_file import SCALED
from geometry.ground.refusal import Kind
from geometry.ground.typed import Array
from localize.learned.training_plan import TrainingPlan
from localize.live.events import Decision
from localize.live.stream import TouchStream
from localize.live.stream_options import AS_IT_COMES, StreamOptions
from localize.recordings.recording import read_recording
from localize.recordings.touch_manifest import (
    PARTS,
    Part,
    TouchManifestError,
    TouchRecording,
    read_touch_manifest,
    refuse_same_take,
    split,
)
from localize.signals.array_facts import ArrayFacts
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import FRAME
from localize.signals.locator import Locator
from localize.signals.random_streams import choice, random_words, uniform
from localize.signals.stimulus import SAMPLE_RATE, Device


@dataclass(frozen=True)
class PartAccuracy:
    """Accuracy on the held-out recordings of one part."""

    top1: float
    """Top-1 accuracy: fraction of the frames that are assigned to the correct point."""
    frames: int
    """Number of frames."""
    recordings: int
    """Number of recordings."""


class _NoLocator(Locator):
    """Hears where a stream hears something, and names nothing."""

    def __init__(self, microphones: tuple[str, ...], noise_rms: float) -> None:
        nowhere = np.zeros(1, np.int64)
        self.array = ArrayFacts("", microphones, nowhere, nowhere, noise_rms=noise_rms)

    def _probability(self, batch: Array) -> Array:
        return np.ones((len(batch), 1))


class RecordedFrames:
    """Frames of all recordings of a manifest, every 16 samples, without those that a stream calls silent.

    Args:
        manifest: a TOML file, see :mod:`localize.recordings.touch_manifest`.
        response: the array.
        noise_rms: Pa rms of a microphone, by which a stream tells silence.
        seed: of the split and of the order in which frames are drawn.
        device: where frames shall be.
        judged_frames: largest number of frames of a held-out recording that are judged, evenly spread.

    Raises:
        TouchManifestError: as :func:`localize.recordings.touch_manifest.read_touch_manifest`; a recording without a
            touch; two that hold one take, of any points, see :mod:`localize.recordings.same_take`; or no point has two
            recordings of one part, so that nothing can be held out.
        RecordingError: a recording that cannot be used.
    """

    def __init__(
        self,
        manifest: str | os.PathLike[str],
        response: ArrayResponse,
        noise_rms: float,
        seed: int,
        device: Device = "cpu",
        judged_frames: int = TrainingPlan.judged_frames,
    ) -> None:
        found = read_touch_manifest(manifest, response.point_count)
        self.recordings = found.recordings
        self.held_out = split([(each.point, each.part, each.file) for each in self.recordings], seed)
        if not any(self.held_out):
            raise TouchManifestError(
                "no point has two recordings of one part, so that none can be held out",
                kind=Kind.UNSUITABLE,
                file=found.path,
            )
        self.seed = seed
        self.point_count = response.point_count
        signals, touched = [], []
        for each in self.recordings:
            full_scale = found.full_scale if each.path.suffix.lower() in SCALED else None
            heard = read_recording(each.path, response.microphones, full_scale).signals
            heard = found.pressures(heard, response.array)
            first = touched_frames(heard, response.microphones, noise_rms)
            if not len(first):
                raise TouchManifestError(
                    "has no frame that is louder than the noise of the microphones",
                    kind=Kind.UNSUITABLE,
                    file=each.path,
                )
            signals.append(heard.astype(np.float32))
            touched.append(first)
        refuse_same_take(found, signals, touched)
        self._signals = torch.from_numpy(np.concatenate(signals, axis=1)).to(device)
        begins = np.cumsum([0, *(each.shape[1] for each in signals[:-1])])
        self._frames = [torch.from_numpy(first + begin) for first, begin in zip(touched, begins, strict=True)]
        frames = self._frames
        self._tabulate(device)
        judged = [_spread(frames[k], judged_frames) for k, held in enumerate(self.held_out) if held]
        self._judged = torch.cat(judged).to(device)
        own = [each for each, held in zip(self.recordings, self.held_out, strict=True) if held]
        counts = torch.tensor([len(first) for first in judged])
        self._judged_point = torch.tensor([each.point - 1 for each in own]).repeat_interleave(counts).to(device)
        self._judged_part = torch.tensor([PARTS.index(each.part) for each in own]).repeat_interleave(counts).to(device)

    def _tabulate(self, device: Device) -> None:
        """Training frames by point and part, one part of a point behind the other."""
        points, parts = self.point_count, len(PARTS)
        drawn: list[Tensor] = []
        first, count = torch.zeros(points, parts, dtype=torch.int64), torch.zeros(points, parts, dtype=torch.int64)
        kinds, at = torch.zeros(points, dtype=torch.int64), 0
        for point in range(points):
            for part in PARTS:
                own = [
                    frames
                    for each, held, frames in zip(self.recordings, self.held_out, self._frames, strict=True)
                    if not held and (each.point - 1, each.part) == (point, part)
                ]
                if own:
                    drawn += own
                    first[point, kinds[point]], count[point, kinds[point]] = at, sum(map(len, own))
                    at += int(count[point, kinds[point]])
                    kinds[point] += 1
        self._drawn = torch.cat(drawn).to(device)
        self._first, self._count, self._kinds = (table.to(device) for table in (first, count, kinds))

    def samples(self, start: int, count: int) -> tuple[Tensor, Tensor]:
        """Training samples ``start`` to ``start + count - 1``, the same whatever was asked for before.

        Each round of as many samples as there are points takes every point once, in an order of its own, and the parts
        that were recorded of a point equally often.

        Returns:
            (count, n_microphone, 250) float32, Pa, and (count,) int64, points from 0.
        """
        words = random_words(self.seed, "training", "recorded frame", start, count, 1)
        number = uniform(words, self._signals.device)[:, 0]
        point = self._order(start, count).to(self._signals.device)
        kind = choice(number[:, 0], self._kinds[point])
        frame = self._first[point, kind] + choice(number[:, 1], self._count[point, kind])
        return self._cut(self._drawn[frame]), point

    def _order(self, start: int, count: int) -> Tensor:
        """(count,) int64, points from 0 of samples ``start`` to ``start + count - 1``."""
        first, last = start // self.point_count, (start + count - 1) // self.point_count
        words = random_words(self.seed, "training", "recorded order", first, last - first + 1, self.point_count)
        order = words.argsort(1, kind="stable").reshape(-1)
        return torch.from_numpy(order[start - first * self.point_count :][:count])

    def _cut(self, first: Tensor) -> Tensor:
        index = first[:, None] + torch.arange(FRAME, device=first.device)
        return self._signals[:, index].transpose(0, 1)

    def judged(self, named: Tensor) -> dict[Part, PartAccuracy]:
        """Accuracy by part of points that were named.

        Args:
            named: (n,) int64, points from 0 that were named for :attr:`judged_frames`.
        """
        found: dict[Part, PartAccuracy] = {}
        for k, part in enumerate(PARTS):
            own = self._judged_part == k
            if own.any():
                right = (named[own] == self._judged_point[own]).double().mean()
                recordings = sum(
                    held and each.part == part for each, held in zip(self.recordings, self.held_out, strict=True)
                )
                found[part] = PartAccuracy(float(right), int(own.sum()), recordings)
        return found

    @property
    def judged_frames(self) -> Tensor:
        """Frames of held-out recordings; (n, n_microphone, 250) float32, Pa, at 1 kHz."""
        return self._cut(self._judged)

    def judge(self, locator: Locator) -> dict[Part, PartAccuracy]:
        """Accuracy by part of a localizer, or the model-based decoder, on the held-out recordings."""
        frames = self.judged_frames.cpu().numpy()
        named = [locator.locate(part).argmax(1) for part in np.array_split(frames, -(-len(frames) // 512))]
        return self.judged(torch.from_numpy(np.concatenate(named)).to(self._signals.device))

    def identity(self) -> dict[str, str]:
        """Facts that must agree for a training to go on: content, point, part and side of every recording, by name."""
        return {
            f"recording {each.file}": f"{each.sha256[:16]}, point {each.point}, {each.part}, "
            f"{'held out' if held else 'training'}"
            for each, held in zip(self.recordings, self.held_out, strict=True)
        }

    def to_dict(self) -> dict[str, Any]:
        """Split of the recordings, as JSON can hold it."""
        return {
            "seed": self.seed,
            "training": [self._entry(k) for k, held in enumerate(self.held_out) if not held],
            "held_out": [self._entry(k) for k, held in enumerate(self.held_out) if held],
        }

    def _entry(self, index: int) -> dict[str, Any]:
        each: TouchRecording = self.recordings[index]
        return {
            "file": each.file,
            "point": each.point,
            "part": each.part,
            "sha256": each.sha256,
            "frames": len(self._frames[index]),
        }


def touched_frames(
    signals: NDArray[np.float64],
    microphones: Sequence[str],
    noise_rms: float,
    options: StreamOptions = AS_IT_COMES,
) -> NDArray[np.int64]:
    """First samples of the frames in which a stream detects a touch.

    Args:
        signals: (n_microphone, n_sample) float64, Pa at 1 kHz.
        microphones: their names.
        noise_rms: Pa rms of a microphone, from which the threshold of silence follows.
        options: what is done with the samples first.

    Returns:
        (n,) int64, ascending.
    """
    events = TouchStream(_NoLocator(tuple(microphones), noise_rms), options=options).push(signals)
    ends = [round(e.time * SAMPLE_RATE) for e in events if isinstance(e, Decision) and e.state == "touch"]
    return np.array(ends, np.int64) - FRAME


def _spread(frames: Tensor, most: int) -> Tensor:
    """At most so many of them, evenly spread."""
    count = min(most, len(frames))
    return frames[torch.linspace(0, len(frames) - 1, count).round().long()]
