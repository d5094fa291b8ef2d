"""Recordings as files: sound, tables and arrays to named channels at the rate of the file; bad ones are refused."""

from __future__ import annotations

import io
import os
import re
import warnings
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import scipy.io.wavfile
from numpy.typing import NDArray

from acoustic_fem.sound.recorded_table import read_table
from acoustic_fem.sound.wav_layout import wav_layout
from geometry.ground.argument_checks import check_choice, check_range
from geometry.ground.array_files import read_mat, read_npz
from geometry.ground.extras import check_extras
from geometry.ground.file_checks import LARGEST_DATA, MOST_NUMBERS, library_reads, ordinary_file
from geometry.ground.foreign_files import read_apart
from geometry.ground.refusal import Kind, Refusal, counted
from geometry.ground.typed import Array
from geometry.ground.whole_files import whole_file

FORMATS = (".wav", ".csv", ".tsv", ".txt", ".npz", ".mat", ".flac", ".aiff", ".aif")
#: Of these, tables, and files of sound cards, whose samples are fractions of full scale.
_TABLES, _CODED = (".csv", ".tsv", ".txt"), (".flac", ".aiff", ".aif")
SCALED = (".wav", *_CODED)
#: Bits of a sample of FLAC and AIFF files, by the names of libsndfile.
_BITS = {"PCM_S8": 8, "PCM_16": 16, "PCM_24": 24, "PCM_32": 32}
#: Memory that the process may take in which they are tried, bytes, and samples that it decodes at a time.
_MEMORY, _BLOCK = 1_500_000_000, 65_536
#: Names in a file that are no channels.
TIME, RATE = "time", "sample_rate"
#: Other names of the rate: it would be ignored, and 1 kHz taken.
_OTHER_RATES = ("fs", "sr", "rate", "samplerate", "samplingrate", "samplefrequency", "samplingfrequency")
#: Name of a matrix of all channels, (channel, sample).
MATRIX = "signals"


class SoundFileWarning(UserWarning):
    """Note on a recording that was read, although its file is not as it should be."""


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
      Headers of recorders that died or write to a pipe are understood, see :mod:`acoustic_fem.sound.wav_layout`.
    - FLAC, AIFF: as WAV, by the package soundfile.
    - CSV, TSV, TXT: a head line of channel names; ``time`` in s among them gives the rate. Separators and decimals are
      those of :mod:`acoustic_fem.sound.recorded_table`.
    - NPZ, MAT: ``sample_rate`` in Hz, and an array of numbers per channel, all equally long, or one matrix
      ``signals`` (channel, sample), whose channels are numbered from 1; what else there is beside it is not read.

    Args:
        path: of the file; its suffix says what it is.
        default_rate: Hz, of files without ``time`` or ``sample_rate``, with a warning; by default these are refused.

    Raises:
        MissingExtra: the package for FLAC and AIFF files is not installed.
        SoundFileError: no such file, another suffix, cut short, a content that is not of this kind, above 512 MiB, or
            above 2^26 samples in a channel, or in all where the file holds more than integers.
    """
    path = Path(path)
    suffix = _format_of(path)
    if suffix == ".wav":
        sound = read_wav(path)
    elif suffix in _CODED:
        sound = _read_coded(path)
    elif suffix in _TABLES:
        sound = _read_csv(path, default_rate)
    elif suffix == ".npz":
        sound = _of_arrays(path, read_npz(path, "an NPZ file of numbers", SoundFileError), default_rate)
    else:
        sound = _of_arrays(path, read_mat(path, "a MAT file", SoundFileError), default_rate)
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
    check_choice("bits", bits, (16, 24, 32))
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
    layout = wav_layout(path, SoundFileError)
    with library_reads(path, "a WAV file", SoundFileError), warnings.catch_warnings():
        # recorders add chunks of their own; what they hold is no sound
        warnings.filterwarnings("ignore", category=scipy.io.wavfile.WavFileWarning)
        if layout.is_regular:
            rate, samples = scipy.io.wavfile.read(path)
        else:
            with path.open("rb") as file:
                content = layout.rewritten(file)
            rate, samples = scipy.io.wavfile.read(io.BytesIO(content))
    for note in layout.notes:
        warnings.warn(f"{path}: {note}", SoundFileWarning, stacklevel=2)
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


def _read_coded(path: Path) -> Sound:
    """Read a FLAC or AIFF file."""
    path = ordinary_file(path, "a sound file", SoundFileError, LARGEST_DATA)
    check_extras(f"reading {path.suffix.lower()} files", "audio")
    import soundfile

    what = "a FLAC or AIFF file"
    read_apart(_decoded, path, what, SoundFileError, _MEMORY)
    with library_reads(path, what, SoundFileError), soundfile.SoundFile(path) as file:
        count, rate, bits = file.frames, float(file.samplerate), _BITS.get(file.subtype)
        if count * file.channels > MOST_NUMBERS:
            raise _fault(
                path,
                f"has {count} samples of {counted(file.channels, 'channel')}; at most {MOST_NUMBERS} in all are read",
                kind=Kind.OUT_OF_RANGE,
            )
        samples = file.read(dtype="float64", always_2d=True)
    if len(samples) < count:
        raise _fault(path, f"is cut short: it has {len(samples)} of {count} samples")
    channels = {str(number): np.ascontiguousarray(column) for number, column in enumerate(samples.T, 1)}
    return Sound(channels, rate, None if bits is None else 1.0 - 2.0 ** (1 - bits), numbered=True)


def _decoded(path: str) -> bytes:
    """In a process of its own: nothing, once every sample was decoded."""
    import soundfile

    with soundfile.SoundFile(path) as file:
        while len(file.read(_BLOCK)):
            pass
    return b""


def _read_csv(path: Path, default_rate: float | None) -> Sound:
    table = read_table(path, SoundFileError)
    names, columns = table.names, table.columns
    channels = [name for name in names if name != TIME]
    if len(set(names)) < len(names) or not channels or (default_rate is None and TIME not in names):
        rule = f"{TIME} and one per channel" if default_rate is None else f"one per channel and, if any, {TIME}"
        raise _fault(
            path,
            f"has the columns {', '.join(names)}; they must be {rule}, each once",
            kind=Kind.MISSING if default_rate is None and TIME not in names else Kind.UNREADABLE,
        )
    if len(columns) < 2:
        raise _fault(path, f"has {counted(len(columns), 'sample')}; it must have at least 2", kind=Kind.UNSUITABLE)
    if TIME in names:
        rate = _rate_of(path, columns[:, names.index(TIME)], table.lines[1])
    else:
        assert default_rate is not None
        rate = _assumed(path, default_rate, f"a column {TIME}, in s,")
    return Sound({name: columns[:, names.index(name)] for name in channels}, rate)


def _assumed(path: Path, rate: float, where: str) -> float:
    """The rate of a file that states none, Hz, with a warning."""
    warnings.warn(
        f"{path}: states no sample rate, so {rate:g} Hz is assumed, and every point will be wrong if it is another; "
        f"{where} states it",
        SoundFileWarning,
        stacklevel=2,
    )
    return rate


def _rate_of(path: Path, time: Array, second: int) -> float:
    """Hz, of times in s; ``second`` is the line of the second of them."""
    step = float(time[-1] - time[0]) / (len(time) - 1)
    uneven = np.flatnonzero(~(np.abs(np.diff(time) - step) <= 0.1 * abs(step)))
    if len(uneven) or not step > 0:
        line = int(uneven[0]) + second if len(uneven) else second
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
        rates = np.array(_assumed(path, default_rate, f"a number {RATE}, in Hz,"))
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
