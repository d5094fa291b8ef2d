"""Recordings of an array's microphones from files: WAV, CSV, NPZ, to pascals at 1 kHz; bad ones refused by name."""

from __future__ import annotations

import csv
import math
import os
import zipfile
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import numpy as np
import scipy.signal
from numpy.typing import NDArray

from acoustic_fem.sound_file import SoundFileError, read_wav
from localize.frames import FRAME
from localize.stimulus import SAMPLE_RATE

LOWEST_RATE, HIGHEST_RATE = 250.0, 1e6
"""Hz; below the lowest the band of 1 to 100 Hz is not in a recording."""
FLAT = 8
"""Consecutive equal samples at the extreme of a channel that show clipping."""
FINE = 2000
"""Flat tops count where the extreme is this many of the channel's smallest steps or more: smaller ones are coarse."""
FORMATS = (".wav", ".csv", ".npz")
TIME_COLUMN = "time"


class RecordingError(ValueError):
    """A recording that cannot be used: one line that names the file and the reason."""


@dataclass(frozen=True, eq=False)
class Recording:
    """Signals at 1 kHz."""

    signals: NDArray[np.float64]
    """(n_microphone, n_sample) Pa."""
    rate: float
    """Hz, of the file."""

    @property
    def seconds(self) -> float:
        """Length."""
        return self.signals.shape[1] / SAMPLE_RATE


def read_recording(
    path: str | os.PathLike[str], microphones: tuple[str, ...], full_scale: float | None = None
) -> Recording:
    """Read a recording and bring it to 1 kHz.

    - WAV: a channel per microphone, in the order of the design. Samples are fractions of full scale.
    - CSV: a head line that names the microphones, in any order, and optionally ``time`` in s; without it 1 kHz.
    - NPZ: ``signals`` (n_microphone, n_sample) and optionally ``sample_rate`` in Hz; without it 1 kHz.

    Other rates are brought to 1 kHz by a polyphase filter (scipy.signal.resample_poly).

    Args:
        path: of the file; its suffix says what it is.
        microphones: names of the array's microphones.
        full_scale: Pa: of WAV files the pressure at full scale, 1 Pa by default; of others the pressure at which they
            clip, which by default is recognised by flat tops.

    Raises:
        RecordingError: the file cannot be read or is cut short; a wrong number of channels; a channel that is silent,
            clipped or not finite; less than one frame; a sample rate outside 250 Hz to 1 MHz.
        ValueError: a full scale that is not finite and positive.
    """
    path = Path(path)
    if full_scale is not None and not 0 < full_scale < math.inf:
        raise ValueError(f"full_scale = {full_scale} Pa must be finite and above 0")
    readers = {".wav": _read_wav, ".csv": _read_csv, ".npz": _read_npz}
    reader = readers.get(path.suffix.lower())
    if reader is None:
        raise RecordingError(f"{path}: its name must end with {', '.join(FORMATS[:-1])} or {FORMATS[-1]}")
    try:
        samples, rate, limit = reader(path, microphones)
    except OSError as error:
        raise RecordingError(f"{path}: cannot be read: {error.strerror or error}") from None
    if path.suffix.lower() == ".wav":
        samples, limit = samples * (full_scale or 1.0), None if limit is None else limit * (full_scale or 1.0)
    else:
        limit = full_scale
    _check(path, samples, rate, microphones, limit)
    return Recording(at_one_kilohertz(samples, rate), rate)


def _check(
    path: Path, samples: NDArray[np.float64], rate: float, microphones: tuple[str, ...], limit: float | None
) -> None:
    if samples.ndim != 2 or len(samples) != len(microphones):
        count = len(samples) if samples.ndim == 2 else f"no ({samples.ndim} dimensions)"
        raise RecordingError(f"{path}: has {count} channels, must have {len(microphones)}: {', '.join(microphones)}")
    if not LOWEST_RATE <= rate <= HIGHEST_RATE:
        raise RecordingError(
            f"{path}: sample rate = {rate:g} Hz must be between {LOWEST_RATE:g} and {HIGHEST_RATE:g} Hz"
        )
    least = math.ceil(FRAME * rate / SAMPLE_RATE)
    if samples.shape[1] < least:
        raise RecordingError(
            f"{path}: has {samples.shape[1]} samples, must have at least {least} "
            f"({FRAME / SAMPLE_RATE:g} s at {rate:g} Hz)"
        )
    for name, channel in zip(microphones, samples, strict=True):
        bad = np.flatnonzero(~np.isfinite(channel))
        if len(bad):
            raise RecordingError(f"{path}: channel {name} is not finite at {bad[0] / rate:.3f} s")
        if channel.max() == channel.min():
            raise RecordingError(f"{path}: channel {name} is silent: its value never changes")
        clipped = _first_clipped(channel, limit)
        if clipped is not None:
            raise RecordingError(
                f"{path}: channel {name} is clipped at {abs(channel[clipped]):.4g} Pa, first at {clipped / rate:.3f} s"
            )


def _first_clipped(channel: NDArray[np.float64], limit: float | None) -> int | None:
    """Index of the first sample at the limit; where none is known, of the first flat top."""
    if limit is not None:
        reached = np.flatnonzero(np.abs(channel) >= limit)
        return int(reached[0]) if len(reached) else None
    if np.abs(channel).max() < FINE * np.diff(np.unique(channel)).min():
        return None
    for extreme in (channel.max(), channel.min()):
        at = np.convolve(channel == extreme, np.ones(FLAT, np.int64), "valid")
        if at.max() == FLAT:
            return int(at.argmax())
    return None


def at_one_kilohertz(samples: NDArray[np.float64], rate: float) -> NDArray[np.float64]:
    """(n_channel, n_sample) at a rate in Hz, resampled by a polyphase filter."""
    ratio = Fraction(SAMPLE_RATE / rate).limit_denominator(10_000)
    if ratio == 1:
        return samples
    # Continued by the end values: a step to zero there would ring into the first and last frame.
    return np.asarray(scipy.signal.resample_poly(samples, ratio.numerator, ratio.denominator, axis=1, padtype="edge"))


def _read_wav(path: Path, microphones: tuple[str, ...]) -> tuple[NDArray[np.float64], float, float | None]:
    """Channels as fractions of full scale, rate, and the highest value an integer format can hold."""
    try:
        sound = read_wav(path)
    except SoundFileError as error:
        raise RecordingError(str(error)) from None
    return np.stack(list(sound.channels.values())), sound.rate, sound.full_scale


def _read_csv(path: Path, microphones: tuple[str, ...]) -> tuple[NDArray[np.float64], float, float | None]:
    with path.open(encoding="utf-8", newline="") as file:
        try:
            head, *rows = [row for row in csv.reader(file) if row]
        except (ValueError, csv.Error):
            raise RecordingError(f"{path}: is empty or not a CSV file") from None
    names = [name.strip() for name in head]
    wanted = sorted(microphones)
    if sorted(name for name in names if name != TIME_COLUMN) != wanted:
        raise RecordingError(
            f"{path}: its columns are {', '.join(names)}; they must be {', '.join(microphones)}, and may be preceded "
            f"by {TIME_COLUMN}"
        )
    for number, row in enumerate(rows, 2):
        if len(row) != len(names):
            raise RecordingError(f"{path}: line {number} has {len(row)} values, must have {len(names)}; cut short?")
    try:
        table = np.array(rows, dtype=np.float64).reshape(len(rows), len(names))
    except ValueError as error:
        raise RecordingError(f"{path}: {error}") from None
    samples = table[:, [names.index(name) for name in microphones]].T
    if TIME_COLUMN not in names or len(table) < 2:
        return samples, SAMPLE_RATE, None
    time = table[:, names.index(TIME_COLUMN)]
    step = float(time[-1] - time[0]) / (len(time) - 1)
    uneven = np.flatnonzero(~(np.abs(np.diff(time) - step) <= 0.1 * abs(step)))
    if len(uneven) or not step > 0:
        line = int(uneven[0]) + 3 if len(uneven) else 3
        raise RecordingError(f"{path}: {TIME_COLUMN} must rise in even steps; it does not at line {line}")
    return samples, 1 / step, None


def _read_npz(path: Path, microphones: tuple[str, ...]) -> tuple[NDArray[np.float64], float, float | None]:
    try:
        with np.load(path, allow_pickle=False) as content:
            arrays = {name: np.asarray(content[name]) for name in content.files}
        samples, rates = arrays["signals"], arrays.get("sample_rate", np.float64(SAMPLE_RATE))
        if rates.size != 1:
            raise RecordingError(f"{path}: sample_rate has {rates.size} values, must be one number, Hz")
        for name, values in (("signals", samples), ("sample_rate", rates)):
            if np.iscomplexobj(values):
                raise RecordingError(f"{path}: {name} holds complex numbers, must hold real ones")
        rate, samples = float(rates.item()), samples.astype(np.float64)
    except KeyError:
        raise RecordingError(f"{path}: has no array 'signals', but {', '.join(arrays) or 'none'}") from None
    except RecordingError:
        raise
    except (zipfile.BadZipFile, EOFError, TypeError, ValueError) as error:
        raise RecordingError(f"{path}: cut short or not an NPZ file of numbers: {error}") from None
    return samples, rate, None
