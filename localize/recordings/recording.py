"""Recordings of an array's microphones, from files to pascals at 1 kHz; bad ones are refused by name."""

from __future__ import annotations

import math
import os
import re
import warnings
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.sound.clipping import clipped_samples
from acoustic_fem.sound.sound_file import MATRIX, SCALED, TIME, Sound, SoundFileError, read_sound
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal, counted
from localize.recordings.channel_choice import check_count, chosen_channels
from localize.signals.frames import FRAME
from localize.signals.resampling import at_one_kilohertz, check_full_scale
from localize.signals.stimulus import SAMPLE_RATE

LOWEST_RATE, HIGHEST_RATE = 250.0, 1e6
"""Lowest and highest sample rate, Hz; below the lowest the band of 1 to 100 Hz is not in a recording."""


LATE, NOTED = 1.0, 0.5
"""Longest time by which a channel may begin later or end earlier than another, and time that is reported, s."""
LOUDEST = 1000.0
"""Pressure above which samples are hardly pascals, Pa: 154 dB SPL, above what microphones of this size take."""
SILENT, CONTINUOUS = 1e-6, 0.9
"""Range of a frame, as a fraction of its channel's range, below which it is silent; and fraction of frames with a
signal from which a channel counts as continuous."""


class RecordingError(Refusal):
    """Refusal of a recording that cannot be used: one line that names the file and the reason."""


class RecordingWarning(UserWarning):
    """Note on a recording that can be used, and may not be what it is taken for."""


@dataclass(frozen=True, eq=False)
class Recording:
    """Signals of an array's microphones at 1 kHz."""

    signals: NDArray[np.float64]
    """Pressures at the microphones, in their order; (n_microphone, n_sample) float64, Pa."""
    rate: float
    """Sample rate of the file, Hz."""
    limit: float | None = None
    """Pressure at which samples stand that were clipped, Pa: none other reaches it. None where none was."""

    @property
    def seconds(self) -> float:
        """Length of the recording, s."""
        return self.signals.shape[1] / SAMPLE_RATE


GAP, SUDDEN, COARSE = 0.015, 0.1, 0.3
"""Time for which all channels must be 0 to be a gap, s; least level beside it, as a fraction of the median level; and
fraction of zeros among the other samples above which the steps of the format are too coarse to tell a gap."""


def read_recording(
    path: str | os.PathLike[str],
    microphones: tuple[str, ...],
    full_scale: float | None = None,
    *,
    fallback: bool = False,
    clipped: bool = False,
    channels: Mapping[str, int] | None = None,
    others: Collection[str] = (),
) -> Recording:
    """Read a recording and bring it to 1 kHz.

    Files are those of :func:`acoustic_fem.sound.sound_file.read_sound`. Channels with names, of CSV, NPZ and MAT, are
    the microphones in any order; numbered ones, of WAV files and of ``signals`` in NPZ and MAT, are in the order of the
    design. Samples are pascals, of WAV files fractions of full scale. Files that give no rate are at 1 kHz; other rates
    are brought to it by a polyphase filter, see :mod:`localize.signals.resampling`.

    Args:
        path: of the file; its suffix says what it is.
        microphones: names of the array's microphones.
        full_scale: pressure at full scale of WAV files, Pa, by default 1 Pa. For other files, the pressure at which the
            recorder clipped. Flat tops below it are clipping too, see :mod:`acoustic_fem.sound.clipping`.
        fallback: whether one channel may be silent all the time or from some time on: for what goes on with the others.
        clipped: whether channels may be clipped: for what reports clipped samples, which reach the limit of the
            recording, and decides nothing by them.
        channels: microphone -> channel of the file, counted from 1 without a column of times; the file may then have
            more channels than there are microphones. By default by their names or their order, as above.
        others: names of channels of the file that are no microphones, and may be in it.

    Raises:
        RecordingError: the file cannot be read or is cut short; a wrong number of channels, or others; two that are
            one; a channel that is silent, clipped or not finite, or begins or ends a second apart from another; less
            than one frame; a sample rate outside 250 Hz to 1 MHz.
        Refusal: a full scale that is not finite and positive.
    """
    path = Path(path)
    check_full_scale(full_scale)
    try:
        sound = read_sound(path, default_rate=SAMPLE_RATE)
    except SoundFileError as error:
        raise RecordingError.of(error) from None
    rate = sound.rate
    if channels is None:
        names = _in_order(path, sound, microphones, others)
    else:
        chosen = chosen_channels(microphones, channels, len(sound.channels), str(path), RecordingError)
        names = [list(sound.channels)[k] for k in chosen]
    scale, limit = 1.0, full_scale
    if path.suffix.lower() in SCALED:
        scale = full_scale or 1.0
        limit = None if sound.full_scale is None else sound.full_scale * scale
    _check_rate(path, rate)
    signals, cut_at = [], []
    for number, (microphone, name) in enumerate(zip(microphones, names, strict=True)):
        # One after the other: at the rate of a sound card all of them are ten times as large as the file.
        channel = sound.channels[name] * scale
        _check(path, channel, rate, microphone)
        if channel.max() == channel.min():
            if not fallback:
                raise RecordingError(
                    f"channel {microphone} is silent: its value never changes", kind=Kind.UNSUITABLE, file=path
                )
            fallback = False  # that one
        cut = clipped_samples(channel, limit)
        if cut.any():
            first = int(cut.argmax())
            level, time = abs(channel[first]), first / rate
            clipping = RecordingError(
                f"channel {microphone} is clipped at {level:.4g} Pa, first at {time:.3f} s",
                kind=Kind.UNSUITABLE,
                file=path,
            )
            if not clipped:
                raise clipping
            warnings.warn(f"{clipping}; its clipped samples are left out", RecordingWarning, stacklevel=2)
            cut_at.append((number, np.flatnonzero(cut)))
        signals.append(at_one_kilohertz(channel[None], rate)[0])
    _check_apart(path, sound.channels, names, microphones)
    if gaps := _gaps(np.stack([sound.channels[name] for name in names]), rate):
        seconds = sum(end - begin for begin, end in gaps) / rate
        warnings.warn(
            f"{path}: all channels are exactly 0 in {counted(len(gaps), 'gap')}, {seconds:.3f} s in all, the first at "
            f"{gaps[0][0] / rate:.3f} s; recorders write zeros for samples that were lost, so touches beside a gap may "
            "be missing, split or wrong",
            RecordingWarning,
            stacklevel=2,
        )
    together = np.stack(signals)
    _check_together(path, together, microphones, fallback)
    loudest = float(np.abs(together).max())
    if loudest > LOUDEST:
        warnings.warn(
            f"{path}: reaches {loudest:.3g} Pa, more than the {LOUDEST:g} Pa that microphones take; samples must be "
            "pascals, or fractions of the full scale in a WAV file",
            RecordingWarning,
            stacklevel=2,
        )
    if not cut_at:
        return Recording(together, rate)
    limit = 1.001 * loudest  # above all other samples, which resampling moves
    for number, found in cut_at:
        own, samples = together[number], (found * (SAMPLE_RATE / rate)).astype(np.int64)
        own[samples] = np.where(own[samples] < 0, -limit, limit)
    return Recording(together, rate, limit)


def _gaps(channels: NDArray[np.float64], rate: float) -> list[tuple[int, int]]:
    """First samples of gaps, and those behind them: (n_channel, n) is 0 in every channel, and suddenly so.

    A signal without noise is 0 between touches too, but goes there and leaves without a jump. A quiet one in coarse
    steps is 0 often.
    """
    level = np.abs(channels).max(0)
    silent = np.concatenate([[False], level == 0, [False]])
    first, behind = np.flatnonzero(silent[1:] & ~silent[:-1]), np.flatnonzero(~silent[1:] & silent[:-1])
    long = (behind - first >= GAP * rate) & (first > 0) & (behind < len(level))
    elsewhere = np.ones(len(level), bool)
    for begin, end in zip(first[long].tolist(), behind[long].tolist(), strict=True):
        elsewhere[begin:end] = False
    if not long.any() or (level[elsewhere] == 0).mean() > COARSE:
        return []
    sudden = SUDDEN * np.median(level[level > 0])
    return [
        (begin, end)
        for begin, end in zip(first[long].tolist(), behind[long].tolist(), strict=True)
        if min(level[begin - 1], level[end]) > sudden
    ]


def _check_together(path: Path, signals: NDArray[np.float64], microphones: tuple[str, ...], fallback: bool) -> None:
    """Refuse channels that did not begin or end together: one is dead for a second while another is continuous.

    From half a second on there is a warning. A shorter silent gap cannot be distinguished from a channel without a
    signal.

    A channel that is quiet at other times too is not dead: steps of its format may be larger than its noise. One that
    falls silent may have a fallback, see :func:`read_recording`.
    """
    frames = signals[:, : signals.shape[1] // FRAME * FRAME].reshape(len(signals), -1, FRAME)
    alive = np.ptp(frames, axis=2) > SILENT * np.ptp(signals, axis=1, keepdims=True)
    for what, seen in (("begins {:g} s after", alive), ("ends {:g} s before", alive[:, ::-1])):
        for name, own in zip(microphones, seen, strict=True):
            dead = int(own.argmax())
            if dead < math.ceil(NOTED * SAMPLE_RATE / FRAME) or own[dead:].mean() < CONTINUOUS:
                continue
            heard = [other for other, each in zip(microphones, seen, strict=True) if each[:dead].mean() >= CONTINUOUS]
            if heard:
                how = what.format(dead * FRAME / SAMPLE_RATE)
                apart = RecordingError(
                    f"channel {name} {how} channel {heard[0]}; all channels must begin and end together",
                    kind=Kind.UNSUITABLE,
                    file=path,
                )
                if dead >= math.ceil(LATE * SAMPLE_RATE / FRAME) and not fallback:
                    raise apart
                warnings.warn(str(apart), RecordingWarning, stacklevel=3)


def _in_order(path: Path, sound: Sound, microphones: tuple[str, ...], others: Collection[str]) -> Sequence[str]:
    """Names of the channels in the order of the microphones, without those of others."""
    names = [name for name in sound.channels if sound.numbered or name in microphones or name not in others]
    wanted = ", ".join(microphones)
    if sound.numbered:
        check_count(len(names), microphones, path, RecordingError)
    if not sound.numbered and sorted(names) != sorted(microphones):
        rows = f", or be the rows of {MATRIX}" if path.suffix.lower() in (".npz", ".mat") else ""
        raise RecordingError(
            f"has {counted(len(names), 'channel')} ({', '.join(names)}); channels must be called {wanted} like the "
            f"microphones{rows}",
            kind=Kind.MISMATCH,
            file=path,
            remedy=_time_column(names),
        )
    return names if sound.numbered else microphones


def _time_column(names: Sequence[str]) -> str:
    """Remedy where a channel seems to hold the times; empty where none does."""
    times = [name for name in names if re.fullmatch(r"t|times?([ _(\[].*)?", name.lower())]
    return f"if {times[0]!r} holds the times in s, call it {TIME!r}" if times else ""


def _check_rate(path: Path, rate: float) -> None:
    check_range("sample rate", rate, LOWEST_RATE, HIGHEST_RATE, "Hz", error=RecordingError, file=path)


def _check_apart(
    path: Path, channels: Mapping[str, NDArray[np.float64]], names: Sequence[str], microphones: Sequence[str]
) -> None:
    """Refuse one channel that stands for two microphones: each has noise of its own."""
    for (first, one), (second, other) in combinations(zip(names, microphones, strict=True), 2):
        if np.array_equal(channels[first], channels[second]):
            raise RecordingError(
                f"channels {one} and {other} are the same signal, sample by sample", kind=Kind.UNSUITABLE, file=path
            )


def check_length(path: Path, samples: int, rate: float, refusal: type[Refusal]) -> None:
    """Refuse a file of less than one frame.

    Args:
        path: of the file.
        samples: number of samples of every channel.
        rate: of the samples, Hz.
        refusal: class of the error.

    Raises:
        Refusal: by ``refusal``.
    """
    least = math.ceil(FRAME * rate / SAMPLE_RATE)
    if samples < least:
        raise refusal(
            f"has {counted(samples, 'sample')}, must have at least {least} ({FRAME / SAMPLE_RATE:g} s at {rate:g} Hz)",
            kind=Kind.UNSUITABLE,
            file=path,
        )


def _check(path: Path, channel: NDArray[np.float64], rate: float, name: str) -> None:
    check_length(path, len(channel), rate, RecordingError)
    bad = np.flatnonzero(~np.isfinite(channel))
    if len(bad):
        raise RecordingError(f"channel {name} is not finite at {bad[0] / rate:.3f} s", kind=Kind.UNSUITABLE, file=path)
