"""Windows of recorded touches: detected waveforms at the touched point, cut for the recognizer."""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor

from acoustic_fem.sound.sound_file import SCALED
from geometry.ground.refusal import Kind
from geometry.ground.typed import Array
from localize.decoders.reconstruct import Reconstructor
from localize.learned.features import COLUMNS
from localize.learned.recorded_frames import touched_frames
from localize.learned.wavelets import FREQUENCIES
from localize.live.stream_options import StreamOptions
from localize.recognition.handwriting import LineReader, letter_maps
from localize.recognition.power_maps import MAPS, WINDOW, maps_of
from localize.recognition.recognition_options import CutOptions
from localize.recognition.recognition_plan import RecognitionPlan
from localize.recognition.takes import at_usual_speed, prepared
from localize.recognition.textures import SPEED
from localize.recordings.recording import read_recording
from localize.recordings.touch_manifest import (
    TouchManifestError,
    read_labelled_manifest,
    refuse_same_take,
    split,
)
from localize.signals.array_response import ArrayResponse
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE


def detected_frames(signals: Array, microphones: tuple[str, ...], noise_rms: float) -> NDArray[np.int64]:
    """First samples of the frames with a touch, hum and slow drift being left out.

    Args:
        signals: (n_microphone, n_sample) float64, Pa at 1 kHz.
        microphones: their names.
        noise_rms: Pa rms of a microphone, where it cannot be measured.

    Returns:
        (n,) int64, ascending.
    """
    return touched_frames(signals, microphones, noise_rms, StreamOptions())


@dataclass(frozen=True)
class Stretch:
    """Stretch of a recording in which a signal is detected without a longer pause."""

    begin: int
    """First sample."""
    end: int
    """Sample behind the last one."""

    def stretched(self, factor: float) -> Stretch:
        """The stretch where time runs by this factor more slowly."""
        return Stretch(round(self.begin * factor), round(self.end * factor))


def stretches(frames: NDArray[np.int64], apart: float = CutOptions.apart) -> list[Stretch]:
    """Stretches in which a signal is detected.

    Args:
        frames: (n,) int64, ascending, first samples of the frames with a touch.
        apart: shortest silence between two stretches, s.
    """
    found: list[Stretch] = []
    for first in frames.tolist():
        # A frame detects a touch from the first sample that it shares with it on.
        if found and first - found[-1].end < apart * SAMPLE_RATE - FRAME:
            found[-1] = Stretch(found[-1].begin, first + 1)
        else:
            found.append(Stretch(first + FRAME - 1, first + 1))
    return [Stretch(min(each.begin, each.end), max(each.begin, each.end)) for each in found]


def cut(
    waveform: Array, stretch: Stretch, before: tuple[float, ...] | None = None, options: CutOptions = CutOptions()
) -> Array:
    """Windows of the part of a touch that holds all but two percent of its energy.

    Args:
        waveform: (n_sample,) float64 of the whole recording, NaN outside the waveform.
        stretch: of the touch.
        before: where windows of a short touch begin, s before it; by default as touches are classified.
        options: how touches are cut.

    Returns:
        (n, 1024) float64; a short touch has one for each value of ``before``, a long one as many as fit.
    """
    before = options.before[1:2] if before is None else before
    known = np.flatnonzero(np.isfinite(waveform))
    if len(known) < WINDOW:
        return np.zeros((0, WINDOW))
    least, most = int(known[0]), int(known[-1]) + 1 - WINDOW
    begin, end = max(stretch.begin - options.around, least), min(stretch.end + options.around, most + WINDOW)
    if end <= begin:
        return np.zeros((0, WINDOW))
    energy = np.cumsum(waveform[begin:end] ** 2)
    first, last = begin + np.searchsorted(energy, np.array(options.within) * energy[-1])
    starts = [first - round(time * SAMPLE_RATE) for time in before]
    if last - first > WINDOW - before[0] * SAMPLE_RATE:
        begins = first - round(options.before[1] * SAMPLE_RATE)
        starts = list(range(begins, max(begins, last - WINDOW) + 1, options.hop))
    places = np.unique(np.clip(starts, least, most))
    return waveform[places[:, None] + np.arange(WINDOW)]


def windows_of(
    reconstructor: Reconstructor,
    signals: Array,
    frames: NDArray[np.int64],
    point: int,
    speed: float | None,
    before: tuple[float, ...] | None = None,
    options: CutOptions = CutOptions(),
) -> Array:
    """Windows of all touches of a recording, in the order of time.

    Args:
        reconstructor: of the library.
        signals: (n_microphone, n_sample) float64, Pa at 1 kHz.
        frames: (n,) int64, first samples of the frames with a touch.
        point: that is touched, from 1.
        speed: of the slide, mm/s; time is stretched as if it were 12 mm/s.
        before: as of :func:`cut`.
        options: how touches are cut.

    Returns:
        (n, 1024) float64, Pa.
    """
    waveform, stretched = stretched_waveform(reconstructor, signals, point, speed)
    found = [each.stretched(stretched) for each in stretches(frames, options.apart)]
    return np.concatenate([np.zeros((0, WINDOW)), *(cut(waveform, each, before, options) for each in found)])


def written_maps(
    reader: LineReader,
    signals: Array,
    frames: NDArray[np.int64],
    variants: int = 0,
    options: CutOptions = CutOptions(),
) -> tuple[Tensor, list[Stretch]]:
    """Maps of all letters of a recording, in the order of time.

    Args:
        reader: of the array.
        signals: (n_microphone, n_sample) float64, Pa at 1 kHz.
        frames: (n,) int64, first samples of the frames with a touch.
        variants: pictures of each letter, each a little different; 0 for one as it is.
        options: how letters are cut.

    Returns:
        (n, 2, 64, 32) float32, and where each letter lies.
    """
    maps, found = [], []
    for each in stretches(frames, options.letters_apart):
        begin = max(0, min(each.begin, signals.shape[1] - FRAME))
        line = reader.line(signals[:, begin : max(each.end, begin + FRAME)])
        if len(line):
            random = np.random.default_rng(begin)
            width = reader.options.pen_width
            drawn: list[np.random.Generator | None] = [random] * variants or [None]
            maps += [letter_maps(line, each_random, width) for each_random in drawn]
            found.append(each)
    return torch.stack(maps) if maps else torch.zeros(0, MAPS, FREQUENCIES, COLUMNS), found


def stretched_waveform(
    reconstructor: Reconstructor, signals: Array, point: int, speed: float | None
) -> tuple[Array, float]:
    """Waveform of a whole recording, and the factor by which its time is stretched.

    Args:
        reconstructor: of the library.
        signals: (n_microphone, n_sample) float64, Pa at 1 kHz.
        point: that is touched, from 1.
        speed: of the slide, mm/s; time is stretched as if it were 12 mm/s.

    Returns:
        (m,) float64, Pa, NaN outside the waveform; and m over the number of samples.
    """
    waveform = reconstructor.waveform(prepared(signals), point).pressure[0]
    if speed is None:
        return waveform, 1.0
    known, stretched = np.isfinite(waveform), speed / SPEED
    ends = [np.full(round(stretched * count), np.nan) for count in (known.argmax(), known[::-1].argmax())]
    return np.concatenate([ends[0], at_usual_speed(waveform[known], speed), ends[1]]), stretched


@dataclass(frozen=True, eq=False)
class RecordedTakes:
    """Windows of the recordings of a manifest, split by recording."""

    labels: tuple[str, ...]
    """Kinds, sorted by name."""
    maps: Tensor
    """Maps of the windows to train on; (n, 2, 64, 32) float32."""
    kind: Tensor
    """Their kinds, from 0; (n,) int64."""
    held_out_maps: Tensor
    """Maps of the windows of held-out recordings; (m, 2, 64, 32) float32."""
    held_out_kind: Tensor
    """Their kinds, from 0; (m,) int64."""
    at_usual_speed: bool
    """True if all recordings give a speed, and were brought to 12 mm/s."""
    files: dict[str, str]
    """Facts of each recording in a checkpoint: checksum, point, label and side, by file."""


def recorded_takes(
    path: str | os.PathLike[str],
    response: ArrayResponse,
    through: Reconstructor | LineReader,
    noise_rms: float,
    plan: RecognitionPlan,
    options: CutOptions = CutOptions(),
) -> RecordedTakes:
    """Windows of recorded kinds of touch; a fifth of the recordings of each kind is held out.

    Args:
        path: a manifest with labels, see :mod:`localize.recordings.touch_manifest`.
        response: the array.
        through: filters of its library; or the reader, of letters.
        noise_rms: Pa rms of a microphone, from which the threshold of silence follows.
        plan: of the training, whose seed the split depends on.
        options: how touches are cut.

    Raises:
        TouchManifestError: as :func:`localize.recordings.touch_manifest.read_labelled_manifest`; some recordings with a
            speed and some without; a recording in which no signal is detected; or two that hold one take.
        RecordingError: a recording that cannot be used.
    """
    found = read_labelled_manifest(path, response.point_count)
    labels = tuple(sorted({each.label for each in found.recordings}))
    moving = {each.speed is not None for each in found.recordings}
    if len(moving) > 1:
        raise TouchManifestError(
            "some recordings give a speed and some do not; all must, or none", kind=Kind.CONFLICT, file=found.path
        )
    if isinstance(through, LineReader) and moving == {True}:
        raise TouchManifestError(
            "recordings of letters must not give a speed, because nothing is done with it",
            kind=Kind.CONFLICT,
            file=found.path,
        )
    held = split([(0, each.label, each.file) for each in found.recordings], plan.seed, labels)
    signals, touched, parts = [], [], []
    for each, judged in zip(found.recordings, held, strict=True):  # held-out takes are cut as touches are at run time
        full_scale = found.full_scale if each.path.suffix.lower() in SCALED else None
        heard = read_recording(each.path, response.microphones, full_scale).signals
        heard = found.pressures(heard, response.array)
        frames = detected_frames(heard, response.microphones, noise_rms)
        if isinstance(through, LineReader):
            own = written_maps(through, heard, frames, 0 if judged else plan.letter_variants, options)[0]
        else:
            before = options.before[1:2] if judged else options.before
            own = maps_of(windows_of(through, heard, frames, each.point, each.speed, before, options))
        if not len(own):
            sought = "letter" if isinstance(through, LineReader) else f"window of {WINDOW} samples"
            raise TouchManifestError(f"has no {sought} with a touch in it", kind=Kind.UNSUITABLE, file=each.path)
        signals.append(heard.astype(np.float32))
        touched.append(frames)
        parts.append((own, torch.full((len(own),), labels.index(each.label))))
    refuse_same_take(found, signals, touched)
    trained, kept = ([part for part, h in zip(parts, held, strict=True) if h is side] for side in (False, True))
    return RecordedTakes(
        labels=labels,
        maps=torch.cat([maps for maps, _ in trained]),
        kind=torch.cat([kind for _, kind in trained]),
        held_out_maps=torch.cat([maps for maps, _ in kept]),
        held_out_kind=torch.cat([kind for _, kind in kept]),
        at_usual_speed=moving == {True},
        files={
            each.file: f"{each.sha256[:16]}, point {each.point}, {each.label}, {'held out' if h else 'training'}"
            for each, h in zip(found.recordings, held, strict=True)
        },
    )
