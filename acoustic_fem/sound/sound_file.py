"""Recordings as files: WAV, CSV, NPZ and MAT to named channels at the rate of the file; what is broken is refused."""

from __future__ import annotations

import os
import re
import warnings
from array import array
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
import scipy.io.wavfile
from numpy.typing import NDArray

from geometry.ground.argument_checks import check_range
from geometry.ground.array_files import read_mat, read_npz
from geometry.ground.csv_files import read_csv
from geometry.ground.file_checks import LARGEST_DATA, MOST_NUMBERS, library_reads, ordinary_file
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array
from geometry.ground.whole_files import whole_file

FORMATS = (".wav", ".csv", ".npz", ".mat")
#: Names in a file that are no channels.
TIME, RATE = "time", "sample_rate"
_MOST_CHUNKS = 1000
#: Other names of the rate: it would be ignored, and 1 kHz taken.
_OTHER_RATES = ("fs", "sr", "rate", "samplerate", "samplingrate", "samplefrequency", "samplingfrequency")
#: Name of a matrix of all channels, (channel, sample).
MATRIX = "signals"


class SoundFileError(Refusal):
    """A recording that cannot be read: one line that names the file and the reason."""


def _fault(path: Path | str, problem: str, kind: Kind = Kind.UNREADABLE, **facts: Any) -> SoundFileError:
    return SoundFileError(problem, kind=kind, file=path, **facts)


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
    """True if the file names no channels: they are then called ``1``, ``2``, ..., as in a WAV file."""

    @property
    def length(self) -> int:
        """Number of samples of every channel."""
        return len(next(iter(self.channels.values())))


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
        SoundFileError: no such file, another suffix, cut short, a content that is not of this kind, above 512 MiB, or
            above 2^26 samples in a channel, or in all where the file holds more than integers.
    """
    path = Path(path)
    suffix = _format_of(path)
    if suffix == ".wav":
        sound = read_wav(path)
    elif suffix == ".csv":
        sound = _read_csv(path, default_rate)
    elif suffix == ".npz":
        sound = _of_arrays(path, read_npz(path, "an NPZ file of numbers", SoundFileError), default_rate)
    else:
        sound = _of_arrays(path, read_mat(path, "a MAT file up to version 7", SoundFileError), default_rate)
    allowed, rate = "finite and above 0", float(sound.rate)
    check_range("sample rate", rate, 0, unit="Hz", excluded="both", allowed=allowed, error=SoundFileError, file=path)
    return sound


def check_sound_there(path: str | os.PathLike[str]) -> None:
    """Refuse a recording that :func:`read_sound` cannot open, before anything else is made.

    Args:
        path: of the file.

    Raises:
        SoundFileError: no such file, no file, one that may not be read, or another suffix.
    """
    _format_of(Path(path))
    ordinary_file(path, "a recording", SoundFileError)


def _format_of(path: Path) -> str:
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise _fault(path, f"must have a name that ends with {', '.join(FORMATS[:-1])} or {FORMATS[-1]}")
    return suffix


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
    if bits not in (16, 24, 32):
        raise Refusal(kind=Kind.OUT_OF_RANGE, field="bits", value=bits, allowed="16, 24 or 32")
    steps = 2.0 ** (bits - 1)
    levels = np.clip(np.rint(samples * steps), -steps, steps - 1)
    if bits == 24:
        levels = levels * 256
    with whole_file(path) as beside:
        scipy.io.wavfile.write(beside, rate, levels.T.astype(np.int16 if bits == 16 else np.int32))


class _WavChannels(Mapping[str, Array]):
    """Channels of a WAV file as its integers, each made to fractions of full scale when it is asked for.

    Args:
        samples: (n_sample, n_channel), as the file holds them.
    """

    def __init__(self, samples: NDArray[Any]) -> None:
        self._samples = samples

    def __getitem__(self, name: str) -> Array:
        if name not in list(self):
            raise KeyError(name)
        column = self._samples[:, int(name) - 1]
        if column.dtype == np.uint8:
            return (column.astype(np.float64) - 128) / 128
        if column.dtype.kind == "i":
            return np.asarray(column / (float(np.iinfo(column.dtype).max) + 1))
        return column.astype(np.float64)

    def __iter__(self) -> Iterator[str]:
        return map(str, range(1, len(self) + 1))

    def __len__(self) -> int:
        return self._samples.shape[1]


def read_wav(path: Path) -> Sound:
    """Read a WAV file as :func:`read_sound` does, whatever its suffix."""
    path = ordinary_file(path, "a WAV file", SoundFileError, LARGEST_DATA)
    _check_chunks(path)
    with library_reads(path, "a WAV file", SoundFileError), warnings.catch_warnings():
        # recorders add chunks of their own; what they hold is no sound
        warnings.filterwarnings("ignore", category=scipy.io.wavfile.WavFileWarning)
        rate, samples = scipy.io.wavfile.read(path)
    if len(samples) > MOST_NUMBERS:
        raise _fault(
            path, f"has {len(samples)} samples per channel; it must have at most {MOST_NUMBERS}", kind=Kind.OUT_OF_RANGE
        )
    if samples.ndim == 1:
        samples = samples[:, None]
    full_scale = None
    if samples.dtype == np.uint8:
        full_scale = 127 / 128
    elif samples.dtype.kind == "i":
        # SciPy holds 24 bits in the upper ones of 32
        step = 256 if samples.dtype == np.int32 and not (samples & 0xFF).any() else 1
        scale = float(np.iinfo(samples.dtype).max) + 1
        full_scale = (scale - step) / scale
    return Sound(_WavChannels(samples), float(rate), full_scale, numbered=True)


def _check_chunks(path: Path) -> None:
    """Refuse a WAV file whose chunks, as it states them, are not all there, or hold no samples."""
    size = path.stat().st_size
    with path.open("rb") as file:
        head = file.read(36)
        if len(head) < 12 or head[:4] not in (b"RIFF", b"RIFX", b"RF64"):
            raise _fault(path, "is cut short or not a WAV file")
        order: Literal["big", "little"] = "big" if head[:4] == b"RIFX" else "little"
        large = head[:4] == b"RF64"  # it states its length, and that of its samples, in 64 bits of another place
        end = int.from_bytes(head[20:28] if large else head[4:8], order) + 8
        if end > size:
            raise _fault(path, f"is cut short: it has {size} of {end} bytes")
        kinds: list[bytes] = []
        place = 12
        while place + 8 <= end and len(kinds) < _MOST_CHUNKS:
            file.seek(place)
            kinds.append(file.read(4))
            length = head[28:36] if large and kinds[-1] == b"data" else file.read(4)
            place += 8 + int.from_bytes(length, order)
            if place > size:
                raise _fault(path, f"is cut short: it has {size} of {place} bytes")
            place += place % 2
    if len(kinds) == _MOST_CHUNKS or b"fmt " not in kinds or b"data" not in kinds:
        raise _fault(path, "is cut short or not a WAV file: it has no samples")


def _read_csv(path: Path, default_rate: float | None) -> Sound:
    table = read_csv(path, "a CSV file", SoundFileError)
    if table.remarks or not table.head:
        raise _fault(path, "is empty or not a CSV file")
    if len(table.head) == 1 and ";" in table.head[0]:
        raise _fault(path, "is separated by semicolons; it must be by commas, with points for decimals")
    names = [name.strip() for name in table.head]
    channels = [name for name in names if name != TIME]
    if len(set(names)) < len(names) or not channels or (default_rate is None and TIME not in names):
        rule = f"{TIME} and one per channel" if default_rate is None else f"one per channel and, if any, {TIME}"
        raise _fault(
            path,
            f"has the columns {', '.join(names)}; they must be {rule}, each once",
            kind=Kind.MISSING if default_rate is None and TIME not in names else Kind.UNREADABLE,
        )
    values = array("d")
    for number, row in enumerate(table.rows, 2):
        if len(row) != len(names):
            raise _fault(path, f"has {counted(len(row), 'value')}; it must have {len(names)}", field=f"line {number}")
        try:
            values.extend(map(float, row))
        except ValueError as error:
            problem = f"does not hold numbers only: {error}"
            raise _fault(path, problem, kind=Kind.WRONG_TYPE, field=f"line {number}") from None
        if len(values) > MOST_NUMBERS:
            raise _fault(
                path, f"holds more than {MOST_NUMBERS} numbers, the most that are read", kind=Kind.OUT_OF_RANGE
            )
    columns = np.frombuffer(values).reshape(-1, len(names))
    if len(columns) < 2:
        raise _fault(path, f"has {counted(len(columns), 'sample')}; it must have at least 2", kind=Kind.UNSUITABLE)
    if default_rate is not None and TIME not in names:
        rate = default_rate
    else:
        rate = _rate_of(path, columns[:, names.index(TIME)])
    return Sound({name: columns[:, names.index(name)] for name in channels}, rate)


def _rate_of(path: Path, time: Array) -> float:
    """Hz, of times in s."""
    step = float(time[-1] - time[0]) / (len(time) - 1)
    uneven = np.flatnonzero(~(np.abs(np.diff(time) - step) <= 0.1 * abs(step)))
    if len(uneven) or not step > 0:
        line = int(uneven[0]) + 3 if len(uneven) else 3
        raise _fault(path, f"must rise in even steps; it does not at line {line}", kind=Kind.UNSUITABLE, field=TIME)
    return 1 / step


def _of_arrays(path: Path, arrays: Mapping[str, NDArray[Any]], default_rate: float | None) -> Sound:
    for name, values in arrays.items() if RATE not in arrays else ():
        if values.size == 1 and re.sub(r"[^a-z]", "", name.lower()) in _OTHER_RATES:
            raise _fault(path, f"must be called {RATE}, if it is the sample rate in Hz", kind=Kind.UNKNOWN, field=name)
    # A column alone is one channel: MAT files know no vectors.
    numbered = MATRIX in arrays and arrays[MATRIX].ndim == 2 and arrays[MATRIX].shape[1] > 1
    if numbered:
        arrays = {name: values for name, values in arrays.items() if name in (MATRIX, RATE)}
    bad = [name for name, values in arrays.items() if values.dtype.kind not in "biuf"]
    if bad:
        raise _fault(path, f"holds {arrays[bad[0]].dtype}, not real numbers", kind=Kind.WRONG_TYPE, field=bad[0])
    if RATE in arrays:
        rates = arrays[RATE]
    elif default_rate is not None:
        rates = np.array(default_rate)
    else:
        raise _fault(path, f"is missing; the file has {', '.join(arrays) or 'nothing'}", kind=Kind.MISSING, field=RATE)
    if rates.size != 1:
        raise _fault(path, f"has {rates.size} values; it must be one number, Hz", kind=Kind.WRONG_TYPE, field=RATE)
    rate = float(rates.ravel()[0])
    if numbered:
        rows = {str(number): row.astype(np.float64) for number, row in enumerate(arrays[MATRIX], 1)}
        return Sound(rows, rate, numbered=True)
    channels = {name: np.squeeze(v).astype(np.float64) for name, v in arrays.items() if name != RATE}
    wide = [name for name, values in channels.items() if values.ndim != 1]
    if wide or not channels:
        held = f"has shape {arrays[wide[0]].shape}" if wide else "has no channel"
        raise _fault(
            path,
            f"{held}; the file must hold one row of samples per channel, or all of them as {MATRIX} (channel, sample)",
            kind=Kind.WRONG_TYPE if wide else Kind.MISSING,
            field=wide[0] if wide else "",
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
        raise _fault(path, f"has channels of different numbers of samples: {lengths}", kind=Kind.MISMATCH)
