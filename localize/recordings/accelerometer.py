"""Acceleration of a sensor as an accelerometer on its housing records it, beside the recording of its microphones."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from acoustic_fem import Library
from acoustic_fem.library.acceleration import AXES
from acoustic_fem.quantities.microphone_signals import Output
from acoustic_fem.sound.clipping import first_clipped
from acoustic_fem.sound.sound_file import SCALED, Sound, read_sound
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.typed import Array
from localize.signals.motion import without_motion
from localize.signals.resampling import at_one_kilohertz
from localize.signals.stimulus import SAMPLE_RATE

COLUMNS = tuple(f"{axis}_m_per_s2" for axis in AXES)
"""Names of the channels of an acceleration along x, y and z of the layout; the names state the unit."""
FULL_SCALES = (0.1, 1e5)
"""Least and most acceleration at full scale of a WAV file, m/s^2."""
SAME_RATE = 1e-3
"""Largest difference of two sample rates that count as equal, as a fraction."""
UNFELT = 1e-3
"""Response to an axis, as a fraction of that to all, up to which its acceleration need not be recorded."""


@dataclass(frozen=True)
class AccelerationFile:
    """File that an accelerometer on the housing was recorded to."""

    path: str | os.PathLike[str]
    """A recording as of :func:`acoustic_fem.sound.read_sound`; it may be that of the microphones itself. Named channels
    of the acceleration are those of :data:`COLUMNS`. Gravity is left out."""
    full_scale: float | None = None
    """Acceleration at full scale of WAV, FLAC and AIFF files, m/s^2."""
    channels: Mapping[str, int] | None = None
    """Axis (x, y or z) -> channel, from 1, of a file without names of channels; by default three channels are x, y
    and z."""

    def __post_init__(self) -> None:
        if self.full_scale is not None:
            check_range("acceleration_full_scale", self.full_scale, *FULL_SCALES, "m/s2")
        axes = self.channels or {}
        if not set(axes) <= set(AXES) or len(set(axes.values())) < len(axes):
            stated = ",".join(f"{axis}={number}" for axis, number in axes.items())
            allowed = "a different number for one or more of x, y and z"
            raise Refusal(kind=Kind.OUT_OF_RANGE, field="acceleration_channels", value=stated, allowed=allowed)


@dataclass(frozen=True, eq=False)
class Acceleration:
    """Acceleration of the housing, gravity left out."""

    samples: Array
    """Along x, y and z of the layout; (3, n_sample) float64, m/s^2."""
    rate: float
    """Sample rate, Hz."""
    path: Path
    """File that it was read from."""
    axes: tuple[str, ...] = AXES
    """Axes that were recorded; the others are 0."""

    def taken_out(
        self, library: Library, signals: Array, rate: float, output: Output = "pressure", limit: float | None = None
    ) -> Array:
        """Signals of the microphones at the rate of their file, less what the motion adds to them.

        See :func:`localize.signals.without_motion`.

        Args:
            library: of the array.
            signals: (n_microphone, n_sample) float64, Pa.
            rate: of the signals, Hz.
            output: content of the signals, as of :func:`localize.signals.without_motion`.
            limit: Pa; samples that reach it are clipped, and stay as they are.

        Returns:
            (n_microphone, n_sample) float64, Pa.

        Raises:
            Refusal: another rate, another number of samples; an axis that moves the membranes and was not recorded; or
                as of :func:`localize.signals.motion_signals`.
        """
        self._check_rate(rate)
        return self._taken_out(library, signals, self.samples, rate, output, limit)

    def taken_out_at_one_kilohertz(
        self, library: Library, signals: Array, rate: float, output: Output = "pressure", limit: float | None = None
    ) -> Array:
        """Signals as of :meth:`taken_out`, where these were brought to 1 kHz.

        Args:
            library: of the array.
            signals: (n_microphone, n_sample) float64, Pa, at 1 kHz.
            rate: of the file that they come from, Hz.
            output: as of :meth:`taken_out`.
            limit: as of :meth:`taken_out`, Pa.

        Returns:
            (n_microphone, n_sample) float64, Pa.

        Raises:
            Refusal: as of :meth:`taken_out`.
        """
        self._check_rate(rate)
        moved = at_one_kilohertz(self.samples, rate)
        return self._taken_out(library, signals, moved, SAMPLE_RATE, output, limit)

    def _taken_out(
        self, library: Library, signals: Array, moved: Array, rate: float, output: Output, limit: float | None
    ) -> Array:
        if moved.shape[1] != signals.shape[1]:
            problem = (
                f"lasts {moved.shape[1] / rate:.4g} s, but the microphones' recording lasts "
                f"{signals.shape[1] / rate:.4g} s; both must begin and end together"
            )
            raise Refusal(problem, kind=Kind.MISMATCH, file=self.path)
        self._check_axes(library)
        less = without_motion(library, signals, moved, rate, output)
        return less if limit is None else np.where(np.abs(signals) >= limit, signals, less)

    def _check_rate(self, rate: float) -> None:
        if not abs(self.rate / rate - 1) <= SAME_RATE:
            problem = f"has a sample rate of {self.rate:.6g} Hz, but the microphones' recording has {rate:.6g} Hz"
            remedy = "bring both to one rate, sampled together"
            raise Refusal(problem, kind=Kind.MISMATCH, file=self.path, remedy=remedy)

    def _check_axes(self, library: Library) -> None:
        """Refuse if an axis was not recorded along which motion moves the membranes."""
        strength = np.abs(library.acceleration_response.values).max((0, 2))
        for name, column, felt in zip(AXES, COLUMNS, strength, strict=True):
            if name not in self.axes and felt > UNFELT * strength.max():
                problem = f"is missing, and motion along {name} moves the membranes of {library.design.name}"
                raise Refusal(problem, kind=Kind.MISSING, file=self.path, field=column)


def read_acceleration(given: AccelerationFile) -> Acceleration:
    """Acceleration of a sensor from a file; axes that it does not have are 0.

    Raises:
        SoundFileError: the file cannot be read.
        Refusal: a file without a channel of an acceleration, or whose unit is not known; a channel that is not there,
            not finite or clipped.
    """
    path = Path(given.path)
    sound = read_sound(path)
    chosen, scale = _chosen(path, sound, given), 1.0
    if path.suffix.lower() in SCALED:
        if given.full_scale is None:
            remedy = ("give the acceleration at full scale, m/s2, by ", Field("acceleration_full_scale"))
            raise Refusal("does not state its unit", kind=Kind.MISSING, file=path, remedy=remedy)
        scale = given.full_scale
    elif given.full_scale is not None:
        problem = "is for WAV, FLAC and AIFF files; the values of other files are m/s2"
        raise Refusal(problem, kind=Kind.CONFLICT, field="acceleration_full_scale", value=given.full_scale)
    samples = np.zeros((3, sound.length))
    for axis, name in chosen.items():
        values = sound.channels[name] * scale
        if not np.isfinite(values).all():
            time = np.flatnonzero(~np.isfinite(values))[0] / sound.rate
            raise Refusal(f"is not finite at {time:.3f} s", kind=Kind.UNSUITABLE, file=path, field=f"channel {name}")
        limit = None if sound.full_scale is None else sound.full_scale * scale
        clipped = None if limit is None else first_clipped(values, limit)
        if clipped is not None:
            problem = f"is clipped at {abs(values[clipped]):.4g} m/s2, first at {clipped / sound.rate:.3f} s"
            raise Refusal(problem, kind=Kind.UNSUITABLE, file=path, field=f"channel {name}")
        samples[AXES.index(axis)] = values
    return Acceleration(samples, sound.rate, path, tuple(chosen))


def _chosen(path: Path, sound: Sound, given: AccelerationFile) -> dict[str, str]:
    """Names of the channels by their axes."""
    names = list(sound.channels)
    if not sound.numbered:
        if given.channels is not None:
            problem = f"is for files without names of channels; this one has {', '.join(names)}"
            raise Refusal(problem, kind=Kind.CONFLICT, file=path, field="acceleration_channels")
        found = {axis: name for axis, name in zip(AXES, COLUMNS, strict=True) if name in sound.channels}
        if not found:
            problem = f"has the channels {', '.join(names)}; an acceleration is called {', '.join(COLUMNS)}, in m/s2"
            raise Refusal(problem, kind=Kind.MISSING, file=path)
        return found
    if given.channels is None and len(names) != len(AXES):
        problem = f"has {len(names)} channels, not those along x, y and z"
        remedy = ("give their numbers by ", Field("acceleration_channels"))
        raise Refusal(problem, kind=Kind.MISMATCH, file=path, remedy=remedy)
    numbers = given.channels or dict(zip(AXES, (1, 2, 3), strict=True))
    for axis, number in numbers.items():
        if str(number) not in sound.channels:
            problem = f"is not there: the file has {len(names)} channels"
            value = f"{axis}={number}"
            raise Refusal(problem, kind=Kind.MISSING, file=path, field="acceleration_channels", value=value)
    return {axis: str(number) for axis, number in numbers.items()}
