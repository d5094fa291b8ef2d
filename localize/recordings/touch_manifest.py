"""The manifest of recorded touches: which recording is of which point and kind, and which are kept for judging.

::

    full_scale = 2.0                  # Pa of the largest value of WAV files; by default 1
    [[recordings]]
    file = "point-01-taps-1.wav"      # beside the manifest; WAV, CSV or NPZ, see localize.recordings.recording
    point = 1
    part = "taps"                     # random-1-100, random-1-10, friction or taps

Recordings are split, never frames of one: neighbouring frames are nearly the same, and a network that has seen one
knows the other.
"""

from __future__ import annotations

import hashlib
import os
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from geometry.files.ordinary import LARGEST_DATA, read_bytes
from geometry.files.reading import read_toml
from geometry.refusal import Refusal
from geometry.stated.fields import model_of
from localize.signals.resampling import FULL_SCALES

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
    part: Part


class _File(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    recordings: Annotated[tuple[_Recording, ...], Field(min_length=1, strict=False)]
    full_scale: Annotated[float, Field(ge=FULL_SCALES[0], le=FULL_SCALES[1], allow_inf_nan=False)] = 1.0


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
class TouchManifest:
    """Manifest of recorded touches, read and checked."""

    path: Path
    """Path of the manifest itself."""
    recordings: tuple[TouchRecording, ...]
    """All recordings, in the order of the manifest."""
    full_scale: float
    """Pressure at full scale of WAV files, Pa."""


def read_touch_manifest(path: str | os.PathLike[str], points: int) -> TouchManifest:
    """Read a manifest and the checksums of its files; whether they are good recordings is seen when they are read.

    Args:
        path: of the TOML file.
        points: of the array.

    Raises:
        TouchManifestError: it cannot be read, is not TOML, holds an unknown or impossible field, a file that is not
            there or a recording that is there twice, or no recording of one of the points.
    """
    path = Path(path)
    file = model_of(_File, read_toml(path, "a manifest", TouchManifestError), str(path), "manifest", TouchManifestError)
    found: list[TouchRecording] = []
    seen: dict[str, str] = {}
    for number, each in enumerate(file.recordings):
        if each.point > points:
            raise TouchManifestError(
                f"{path}: recordings.{number}.point = {each.point} must be from 1 to {points}, the points of the array"
            )
        digest = hashlib.sha256(
            read_bytes(path.parent / each.file, "a recording", TouchManifestError, LARGEST_DATA)
        ).hexdigest()
        if digest in seen:
            raise TouchManifestError(f"{path}: {each.file} is the same recording as {seen[digest]}")
        seen[digest] = each.file
        found.append(TouchRecording(each.file, path.parent / each.file, each.point, each.part, digest))
    without = sorted(set(range(1, points + 1)) - {each.point for each in found})
    if without:
        raise TouchManifestError(
            f"{path}: no recording of point {', '.join(map(str, without))}; every point must have one to train on"
        )
    return TouchManifest(path, tuple(found), file.full_scale)


def split(recordings: Sequence[tuple[int, Part, str]], seed: int) -> tuple[bool, ...]:
    """Which recordings are held out: a fifth of those of each point and part, at least one where there are two.

    One that is alone of its point and part is trained on. The split of a point and part depends on the seed and on the
    names of its own recordings, not on their order or on other recordings.

    Args:
        recordings: point, part and a name, no two alike.
        seed: any non-negative integer.
    """
    groups: defaultdict[tuple[int, Part], list[int]] = defaultdict(list)
    for index, (point, part, _) in enumerate(recordings):
        groups[point, part].append(index)
    held = [False] * len(recordings)
    for (point, part), own in groups.items():
        if len(own) < 2:
            continue
        own = sorted(own, key=lambda index: recordings[index][2])
        random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(point, PARTS.index(part))))
        for place in random.permutation(len(own))[: max(1, round(HELD_OUT * len(own)))]:
            held[own[int(place)]] = True
    return tuple(held)
