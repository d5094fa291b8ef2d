"""Recordings as files: WAV, CSV, NPZ and MAT to named channels at the rate of the file; what is broken is refused."""

from __future__ import annotations

import csv
import os
import struct
import warnings
import zipfile
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from geometry.refusal import Refusal

Array = NDArray[np.float64]

FORMATS = (".wav", ".csv", ".npz", ".mat")
#: What a file may hold beside its channels.
TIME, RATE = "time", "sample_rate"
#: Name of a matrix of all channels, (channel, sample).
MATRIX = "signals"


class SoundFileError(Refusal):
    """A recording that cannot be read: one line that names the file and the reason."""


@dataclass(frozen=True, eq=False)
class Sound:
    """Channels that were recorded together."""

    channels: Mapping[str, Array]
    """Samples of every channel by name, (n_sample,) float64 each."""
    rate: float
    """Sample rate, Hz."""
    full_scale: float | None = None
    """Largest value that the format can hold; None where there is none, as in texts and floating-point numbers."""
    numbered: bool = False
    """Whether the file names no channels: they are then called ``1``, ``2``, ..., as in a WAV file."""


def read_sound(path: str | os.PathLike[str], default_rate: float | None = None) -> Sound:
    """Read a recording as it is: nothing is scaled, filtered or resampled.

    - WAV: 8 to 32 bit integers as fractions of full scale, or floating-point numbers; channels are numbered from 1.
    - CSV: a head line of channel names; ``time`` in s among them gives the rate.
    - NPZ, MAT: ``sample_rate`` in Hz, and an array of numbers per channel, all equally long, or one matrix
      ``signals`` (channel, sample), whose channels are numbered from 1; what else there is beside it is not read.

    Args:
        path: of the file; its suffix says what it is.
        default_rate: Hz, of files without ``time`` or ``sample_rate``; by default these are refused.

    Raises:
        SoundFileError: no such file, another suffix, cut short, or a content that is not of this kind.
    """
    path = Path(path)
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise SoundFileError(f"{path}: its name must end with {', '.join(FORMATS[:-1])} or {FORMATS[-1]}")
    if not path.is_file():
        raise SoundFileError(f"{path}: {'is a folder' if path.is_dir() else 'no such file'}")
    try:
        if suffix == ".wav":
            sound = read_wav(path)
        elif suffix == ".csv":
            sound = _read_csv(path, default_rate)
        else:
            sound = _of_arrays(path, _read_npz(path) if suffix == ".npz" else _read_mat(path), default_rate)
    except OSError as error:
        raise SoundFileError(f"{path}: cannot be read: {error.strerror or error}") from None
    if not (np.isfinite(sound.rate) and sound.rate > 0):
        raise SoundFileError(f"{path}: sample rate = {sound.rate:g} Hz must be finite and above 0")
    return sound


def write_wav(path: str | os.PathLike[str], samples: Array, rate: int, bits: int = 16) -> None:
    """Write channels as fractions of full scale; what lies beyond is clipped, as a recorder does.

    Args:
        path: of the file, whole or not at all.
        samples: (n_channel, n_sample) float64.
        rate: Hz.
        bits: 16, 24 (in the upper bits of 32) or 32.

    Raises:
        Refusal: another number of bits.
    """
    import scipy.io.wavfile

    from geometry.files.writing import whole_file

    if bits not in (16, 24, 32):
        raise Refusal(f"bits = {bits} must be 16, 24 or 32")
    steps = 2.0 ** (bits - 1)
    levels = np.clip(np.rint(samples * steps), -steps, steps - 1)
    if bits == 24:
        levels = levels * 256
    with whole_file(path) as beside:
        scipy.io.wavfile.write(beside, rate, levels.T.astype(np.int16 if bits == 16 else np.int32))


def read_wav(path: Path) -> Sound:
    """Read a WAV file as :func:`read_sound` does, whatever its suffix."""
    import scipy.io.wavfile

    with path.open("rb") as file:
        head = file.read(8)
    if len(head) < 8 or head[:4] not in (b"RIFF", b"RIFX", b"RF64"):
        raise SoundFileError(f"{path}: cut short or not a WAV file")
    stated = struct.unpack(">I" if head[:4] == b"RIFX" else "<I", head[4:])[0]
    if head[:4] != b"RF64" and path.stat().st_size < stated + 8:
        raise SoundFileError(f"{path}: cut short: it has {path.stat().st_size} of {stated + 8} bytes")
    try:
        with warnings.catch_warnings():
            # recorders add chunks of their own; what they hold is no sound
            warnings.filterwarnings("ignore", category=scipy.io.wavfile.WavFileWarning)
            rate, samples = scipy.io.wavfile.read(path)
    except (ValueError, struct.error, EOFError) as error:
        raise SoundFileError(f"{path}: cut short or not a WAV file: {error}") from None
    columns = samples.reshape(len(samples), -1).T
    full_scale = None
    if samples.dtype == np.uint8:
        columns, full_scale = (columns.astype(np.float64) - 128) / 128, 127 / 128
    elif samples.dtype.kind == "i":
        # SciPy holds 24 bits in the upper ones of 32
        step = 256 if samples.dtype == np.int32 and not (samples & 0xFF).any() else 1
        scale = float(np.iinfo(samples.dtype).max) + 1
        columns, full_scale = columns / scale, (scale - step) / scale
    channels = {str(number): column.astype(np.float64) for number, column in enumerate(columns, 1)}
    return Sound(channels, float(rate), full_scale, numbered=True)


def _read_csv(path: Path, default_rate: float | None) -> Sound:
    with path.open(encoding="utf-8-sig", newline="") as file:
        try:
            head, *rows = [row for row in csv.reader(file) if row]
        except (ValueError, csv.Error):
            raise SoundFileError(f"{path}: is empty or not a CSV file") from None
    if len(head) == 1 and ";" in head[0]:
        raise SoundFileError(f"{path}: is separated by semicolons; it must be by commas, with points for decimals")
    names = [name.strip() for name in head]
    channels = [name for name in names if name != TIME]
    if len(set(names)) < len(names) or not channels or (default_rate is None and TIME not in names):
        rule = f"{TIME} and one per channel" if default_rate is None else f"one per channel and, if any, {TIME}"
        raise SoundFileError(f"{path}: its columns are {', '.join(names)}; they must be {rule}, each once")
    for number, row in enumerate(rows, 2):
        if len(row) != len(names):
            raise SoundFileError(f"{path}: line {number} has {len(row)} values, must have {len(names)}; cut short?")
    try:
        table = np.array(rows, dtype=np.float64).reshape(len(rows), len(names))
    except ValueError as error:
        raise SoundFileError(f"{path}: {error}") from None
    if len(table) < 2:
        raise SoundFileError(f"{path}: has {len(table)} samples, must have at least 2")
    if default_rate is not None and TIME not in names:
        rate = default_rate
    else:
        rate = _rate_of(path, table[:, names.index(TIME)])
    return Sound({name: table[:, names.index(name)] for name in channels}, rate)


def _rate_of(path: Path, time: Array) -> float:
    """Hz, of times in s."""
    step = float(time[-1] - time[0]) / (len(time) - 1)
    uneven = np.flatnonzero(~(np.abs(np.diff(time) - step) <= 0.1 * abs(step)))
    if len(uneven) or not step > 0:
        line = int(uneven[0]) + 3 if len(uneven) else 3
        raise SoundFileError(f"{path}: {TIME} must rise in even steps; it does not at line {line}")
    return 1 / step


def _read_npz(path: Path) -> dict[str, NDArray[Any]]:
    try:
        with np.load(path, allow_pickle=False) as content:
            return {name: content[name] for name in content.files}
    except (zipfile.BadZipFile, zlib.error, EOFError, TypeError, ValueError) as error:
        raise SoundFileError(f"{path}: cut short or not an NPZ file of numbers: {error}") from None


def _read_mat(path: Path) -> dict[str, NDArray[Any]]:
    import scipy.io
    from scipy.io.matlab import MatReadError

    try:
        content = scipy.io.loadmat(path)
    except (MatReadError, NotImplementedError, ValueError, TypeError, zlib.error, EOFError, struct.error) as error:
        raise SoundFileError(f"{path}: cut short or not a MAT file up to version 7: {error}") from None
    return {name: values for name, values in content.items() if not name.startswith("__")}


def _of_arrays(path: Path, arrays: Mapping[str, NDArray[Any]], default_rate: float | None) -> Sound:
    # A column alone is one channel: MAT files know no vectors.
    numbered = MATRIX in arrays and arrays[MATRIX].ndim == 2 and arrays[MATRIX].shape[1] > 1
    if numbered:
        arrays = {name: values for name, values in arrays.items() if name in (MATRIX, RATE)}
    bad = [name for name, values in arrays.items() if values.dtype.kind not in "biuf"]
    if bad:
        raise SoundFileError(f"{path}: {bad[0]} holds {arrays[bad[0]].dtype}, not real numbers")
    if RATE in arrays:
        rates = arrays[RATE]
    elif default_rate is not None:
        rates = np.array(default_rate)
    else:
        raise SoundFileError(f"{path}: has no {RATE}, but {', '.join(arrays) or 'nothing'}")
    if rates.size != 1:
        raise SoundFileError(f"{path}: {RATE} has {rates.size} values, must be one number, Hz")
    rate = float(rates.ravel()[0])
    if numbered:
        rows = {str(number): row.astype(np.float64) for number, row in enumerate(arrays[MATRIX], 1)}
        return Sound(rows, rate, numbered=True)
    channels = {name: np.squeeze(v).astype(np.float64) for name, v in arrays.items() if name != RATE}
    wide = [name for name, values in channels.items() if values.ndim != 1]
    if wide or not channels:
        what = f"{wide[0]} has shape {arrays[wide[0]].shape}" if wide else "has no channel"
        raise SoundFileError(
            f"{path}: {what}; it must hold one row of samples per channel, or all of them as {MATRIX} (channel, sample)"
        )
    check_equal_lengths(path, channels)
    return Sound(channels, rate)


def check_equal_lengths(path: Path | str, channels: Mapping[str, Sequence[float] | Array]) -> None:
    """Refuse channels, (n_sample,) each by name, of different lengths.

    Raises:
        SoundFileError: with the lengths.
    """
    if len({len(values) for values in channels.values()}) > 1:
        lengths = ", ".join(f"{name} {len(values)}" for name, values in channels.items())
        raise SoundFileError(f"{path}: its channels have different numbers of samples: {lengths}")
