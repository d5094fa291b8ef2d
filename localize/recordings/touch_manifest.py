"""Manifest of recorded touches: the point and kind of each recording, and the recordings held out for the evaluation.

::

    full_scale = 2.0                  # Pa at 1 kHz of the largest value of WAV files; by default 1
    output = "voltage"                # the microphones as they are; by default "pressure": already equalised
    lowest = 3.0                      # Hz, down to which voltages are equalised to pressures; by default 1
    [[recordings]]
    file = "point-01-taps-1.wav"      # beside the manifest; WAV, CSV or NPZ, see localize.recordings.recording
    point = 1
    part = "taps"                     # random-1-100, random-1-10, friction or taps
    label = "double tap"              # instead of the part, to learn kinds of touch: a name of one's own
    speed = 12.0                      # beside a label, mm/s, where something slides at a known speed

Whole recordings are held out, never single frames of one: neighbouring frames are nearly alike, so a network that was
trained on one knows the other.
"""

from __future__ import annotations

import hashlib
import os
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Generic, Literal, TypeVar

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field

from acoustic_fem.quantities.microphone_signals import LOWEST, LOWEST_RANGE, Output
from geometry.ground.argument_checks import check_range
from geometry.ground.file_checks import LARGEST_DATA, read_bytes
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import read_toml
from geometry.schema.field_errors import model_of
from localize.recordings.same_take import find_same_take
from localize.signals.array_facts import ArrayFacts
from localize.signals.resampling import FULL_SCALES

#: Part of the published set of touches that a recording belongs to.
Part = Literal["random-1-100", "random-1-10", "friction", "taps"]
PARTS: tuple[Part, ...] = ("random-1-100", "random-1-10", "friction", "taps")
"""Kinds of touches that a recording may hold; the paper records 13, 2, 2 and 2 minutes of them at every point."""
HELD_OUT = 0.2
"""Share of the recordings of a point and part that are kept for judging: 4 to 1, as in the paper."""


class TouchManifestError(Refusal):
    """Refusal of recorded touches that cannot be used: one line that names the file, the field and the reason."""


class _Recording(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    file: Annotated[str, Field(min_length=1)]
    point: Annotated[int, Field(ge=1)]
    part: Part | None = None
    label: Annotated[str, Field(min_length=1, max_length=100, pattern=r"\S")] | None = None
    speed: Annotated[float, Field(ge=1.0, le=100.0)] | None = None


class _File(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    recordings: Annotated[tuple[_Recording, ...], Field(min_length=1, strict=False)]
    full_scale: Annotated[float, Field(ge=FULL_SCALES[0], le=FULL_SCALES[1], allow_inf_nan=False)] = 1.0
    output: Output = "pressure"
    lowest: Annotated[float, Field(ge=LOWEST_RANGE[0], le=LOWEST_RANGE[1], allow_inf_nan=False)] = LOWEST


@dataclass(frozen=True)
class TouchRecording:
    """Recording of touches of one point, as a manifest states it."""

    file: str
    """Name of the file, as the manifest gives it."""
    path: Path
    """Path of the file."""
    point: int
    """Point that is touched, from 1."""
    part: Part
    """Kind of the touches."""
    sha256: str
    """SHA-256 of the file's content, hexadecimal."""


@dataclass(frozen=True)
class LabelledRecording:
    """Recording of one kind of touch, as a manifest states it."""

    file: str
    """Name of the file, as the manifest gives it."""
    path: Path
    """Path of the file."""
    point: int
    """Point that is touched, from 1."""
    label: str
    """Kind of the touches, a name of the user's."""
    speed: float | None
    """Speed of what slides, mm/s; None where none is known."""
    sha256: str
    """SHA-256 of the file's content, hexadecimal."""


_Recorded = TypeVar("_Recorded", TouchRecording, LabelledRecording)


@dataclass(frozen=True)
class TouchManifest(Generic[_Recorded]):
    """Manifest of recorded touches, read and checked."""

    path: Path
    """Path of the manifest itself."""
    recordings: tuple[_Recorded, ...]
    """All recordings, in the order of the manifest."""
    full_scale: float
    """Pressure at full scale of WAV files, Pa."""
    output: Output = "pressure"
    """Content of the recordings: outputs of the microphones, or pressures in front of them."""
    lowest: float = LOWEST
    """Frequency down to which outputs are equalised to pressures, Hz."""

    def pressures(self, heard: NDArray[np.float64], array: ArrayFacts) -> NDArray[np.float64]:
        """Pressures in front of the microphones, from a recording of the manifest.

        Args:
            heard: (n_microphone, n_sample) float64, Pa at 1 kHz, as it was read.
            array: facts of the array.

        Raises:
            Refusal: outputs of an array whose design is not known.
        """
        return array.equaliser(self.lowest).begin(heard) if self.output == "voltage" else heard


def read_touch_manifest(path: str | os.PathLike[str], points: int) -> TouchManifest[TouchRecording]:
    """Read a manifest and the checksums of its files; whether they are good recordings is seen when they are read.

    Args:
        path: of the TOML file.
        points: of the array.

    Raises:
        TouchManifestError: it cannot be read, is not TOML, holds an unknown or impossible field, a file that is not
            there or a recording that is there twice, or no recording of one of the points.
    """
    path = Path(path)
    file, digests = _read(path, points)
    found = []
    for number, (each, digest) in enumerate(zip(file.recordings, digests, strict=True)):
        if each.part is None:
            raise TouchManifestError(
                kind=Kind.MISSING, file=path, field=f"recordings.{number}.part", allowed=f"one of {', '.join(PARTS)}"
            )
        found.append(TouchRecording(each.file, path.parent / each.file, each.point, each.part, digest))
    without = sorted(set(range(1, points + 1)) - {each.point for each in found})
    if without:
        raise TouchManifestError(
            f"has no recording of point {', '.join(map(str, without))}; every point must have one to train on",
            kind=Kind.MISSING,
            file=path,
        )
    return TouchManifest(path, tuple(found), file.full_scale, file.output, file.lowest)


def read_labelled_manifest(path: str | os.PathLike[str], points: int) -> TouchManifest[LabelledRecording]:
    """Read a manifest whose recordings have labels, and the checksums of its files.

    Args:
        path: of the TOML file.
        points: of the array.

    Raises:
        TouchManifestError: as :func:`read_touch_manifest`, but that every recording must have a label, and every label
            two recordings, of which one is kept for judging; and there must be two labels.
    """
    path = Path(path)
    file, digests = _read(path, points)
    found = []
    for number, (each, digest) in enumerate(zip(file.recordings, digests, strict=True)):
        if each.label is None:
            raise TouchManifestError(
                kind=Kind.MISSING, file=path, field=f"recordings.{number}.label", allowed="a name for the kind of touch"
            )
        found.append(LabelledRecording(each.file, path.parent / each.file, each.point, each.label, each.speed, digest))
    counts = Counter(each.label for each in found)
    for label, count in counts.items():
        if count < 2:
            raise TouchManifestError(
                f"label {label!r} has one recording, must have at least 2, because one is held out",
                kind=Kind.UNSUITABLE,
                file=path,
            )
    if len(counts) < 2:
        raise TouchManifestError(
            "all recordings have the same label; there must be at least 2 labels to tell apart",
            kind=Kind.UNSUITABLE,
            file=path,
        )
    return TouchManifest(path, tuple(found), file.full_scale, file.output, file.lowest)


def _read(path: Path, points: int) -> tuple[_File, list[str]]:
    """Content of a manifest, and the checksums of its files."""
    file = model_of(_File, read_toml(path, "a manifest", TouchManifestError), str(path), "manifest", TouchManifestError)
    seen: dict[str, str] = {}
    for number, each in enumerate(file.recordings):
        field, of_array = f"recordings.{number}.point", "the points of the array"
        check_range(field, each.point, 1, points, why=of_array, error=TouchManifestError, file=path)
        digest = hashlib.sha256(
            read_bytes(path.parent / each.file, "a recording", TouchManifestError, LARGEST_DATA)
        ).hexdigest()
        if digest in seen:
            raise TouchManifestError(
                f"{each.file} is the same recording as {seen[digest]}", kind=Kind.CONFLICT, file=path
            )
        seen[digest] = each.file
    return file, list(seen)


def refuse_same_take(
    manifest: TouchManifest[_Recorded],
    signals: Sequence[NDArray[np.float32]],
    touched: Sequence[NDArray[np.int64]],
) -> None:
    """Refuse recordings of which two hold one take, by the names of both.

    Args:
        manifest: that names them.
        signals: as of :func:`localize.recordings.same_take.find_same_take`.
        touched: as of the same.

    Raises:
        TouchManifestError: two recordings hold one take.
    """
    same = find_same_take(signals, touched)
    if same is not None:
        one, other = (manifest.recordings[number].file for number in (same.first, same.second))
        raise TouchManifestError(
            f"{other} is the same take as {one}: the correlation of a stretch of them is {same.correlation:.4f}",
            kind=Kind.CONFLICT,
            file=manifest.path,
        )


def split(recordings: Sequence[tuple[int, str, str]], seed: int, parts: Sequence[str] = PARTS) -> tuple[bool, ...]:
    """Mask of the held-out recordings: a fifth of those of each point and part, at least one where there are two.

    One that is alone of its point and part is trained on. The split of a point and part depends on the seed and on the
    names of its own recordings, not on their order or on other recordings.

    Args:
        recordings: point, part and a name, no two alike.
        seed: any non-negative integer.
        parts: all parts that there may be, in their order.
    """
    groups: defaultdict[tuple[int, str], list[int]] = defaultdict(list)
    for index, (point, part, _) in enumerate(recordings):
        groups[point, part].append(index)
    held = [False] * len(recordings)
    for (point, part), own in groups.items():
        if len(own) < 2:
            continue
        own = sorted(own, key=lambda index: recordings[index][2])
        random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(point, parts.index(part))))
        for place in random.permutation(len(own))[: max(1, round(HELD_OUT * len(own)))]:
            held[own[int(place)]] = True
    return tuple(held)
