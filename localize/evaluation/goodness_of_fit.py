"""Fit of a decoder to its sensor: the residual of its best point in the loudest touches.

A library of another array, a sensor that is further from its design than tolerances go, and a microphone that is far
off its level all leave more of a loud touch than a sensor as expected does, at every point. A level that is off shows
itself: divided by it, what is left falls to what is expected.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geometry.ground.refusal import Kind, Refusal
from localize.live.events import Decision
from localize.signals.frames import FRAME, checked_signals
from localize.signals.locator import Locator
from localize.signals.stimulus import SAMPLE_RATE
from localize.signals.threads import one_thread


@dataclass(frozen=True)
class FitOptions:
    """Numbers that tune the test of how well a library fits its sensor."""

    fewest: int = 8
    """Least number of loud frames that are fitted together."""
    most: int = 32
    """Largest number of loud frames that are fitted together."""
    loudest: int = 16
    """Number of the loudest frames that a level is looked for with."""
    noise_multiple: float = 200.0
    """Multiple of the noise to which louder frames are brought: their residual shows more of the difference of the
    sensor from its library."""
    least_suspect: float = 4.0
    """Residual over that of the noise that sensors of two microphones leave at most without a calibration. Medians on
    virtual rigs of seeds 9110 to 9112: of two microphones 1.5 to 2.5 (2.8 at 2000 m with the air of the design), by
    libraries of other arrays 4.8 and more; of three 0.8 to 4.1 (22 at 2000 m) and 1600 or more, of four 5 to 32 (52 at
    2000 m). Calibrated 1.0 to 1.5 (1.9 and more after a change of stiffness of 20 %), by libraries of other arrays 2.7
    or more."""
    levels: tuple[float, ...] = (-24.0, -18.0, -12.0, -6.0, 0.0, 6.0, 12.0, 18.0, 24.0)
    """Levels of a microphone that are tried first, dB; further away it is all but dead."""
    steps: tuple[float, ...] = (3.0, 1.5, 0.75)
    """Steps in which the level is looked for then, dB, each around the best so far."""
    off: float = 5.0
    """Level from which on a microphone is far off, dB: its own tolerance is 1 dB."""
    falls: float = 2.0
    """Factor by which the residual must fall at least, and to the expected one, with the level of one microphone; by
    libraries of other arrays it falls to 6.6 at best (seeds 9100 to 9112)."""


@dataclass(frozen=True)
class SensorFit:
    """How well the points of a decoder explain the loudest touches of a sensor."""

    misfit: float
    """Residual of the best point in a frame over that of the noise, a ratio; the median over the frames."""
    expected: float
    """Largest such ratio of a sensor as the decoder expects it."""
    microphones: tuple[str, ...]
    """Names of the microphones."""
    off_level: tuple[str, float] | None = None
    """Microphone whose level differs most from the library, and the difference, dB; None if the level of no single
    microphone explains the touches. With two microphones only their difference is known, so it is the one whose
    correction leaves the smaller residual."""

    @property
    def warning(self) -> str | None:
        """Reason to distrust the decisions, in words; None if the sensor fits the library."""
        if self.off_level is not None:
            name, level = self.off_level
            louder, quieter = ("louder", "quieter") if level > 0 else ("quieter", "louder")
            others = [each for each in self.microphones if each != name]
            either = f", or {others[0]} {quieter}" if len(others) == 1 else ""
            return f"microphone {name} is {abs(level):.0f} dB {louder}{either} than the library has it"
        if self.misfit <= self.expected:
            return None
        return (
            f"no point explains the touches: their residual is {self.misfit:.3g} times that of noise, and at most "
            f"{self.expected:g} is expected; the library may be one of another array or air, the sensor may have "
            "changed, or the room is louder than the given ambient level"
        )


class LoudFrames:
    """Loudest frames of a stream whose samples are others, gathered while it goes on."""

    def __init__(self, options: FitOptions = FitOptions()) -> None:
        self._options = options
        self._kept: list[Decision] = []

    def take(self, events: Iterable[object]) -> None:
        """Take what a stream says next, whose decisions carry their samples."""
        for event in events:
            if isinstance(event, Decision) and event.state == "touch" and event.frame is not None:
                self._take(event)

    def _take(self, event: Decision) -> None:
        near = [each for each in self._kept if abs(each.time - event.time) < FRAME / SAMPLE_RATE]
        if any(each.level >= event.level for each in near):
            return
        self._kept = [each for each in self._kept if each not in near] + [event]
        if len(self._kept) > self._options.most:
            self._kept.remove(min(self._kept, key=lambda each: each.level))

    @property
    def frames(self) -> list[NDArray[np.float64]]:
        """(n_microphone, 250) float64 each, Pa."""
        return [each.frame for each in self._kept if each.frame is not None]


@one_thread()
def sensor_fit(
    decoder: Locator,
    frames: ArrayLike,
    microphone_noise: ArrayLike | None = None,
    options: FitOptions = FitOptions(),
) -> SensorFit | None:
    """Fit of a decoder to the loudest touches, and the microphone that is far off its level if there is one.

    Args:
        decoder: of a library.
        frames: (n, n_microphone, 250), Pa, at 1 kHz: of touches, at several points if possible.
        microphone_noise: of the microphones as it was measured, (n_microphone,) Pa rms; by default that of the decoder.
        options: numbers that tune the test.

    Returns:
        None for fewer than 8 frames, and where it is not known what sensors leave: of a computed library whose
        tolerances are not known.

    Raises:
        Refusal: as :meth:`localize.BayesDecoder.locate`, or noise of another number of microphones.
    """
    expected, given = decoder.largest_misfit, np.asarray(frames)
    if expected is None or len(given) < options.fewest:
        return None
    heard = checked_signals(given, decoder.microphones)[0][: options.most].copy()
    if microphone_noise is not None:
        # Before loud frames are brought to their level: what the sensor leaves is then still seen above the noise.
        heard /= _louder(decoder, np.asarray(microphone_noise, np.float64))
    level = heard.std(2).max(1) / (options.noise_multiple * decoder.noise_rms)
    heard /= np.maximum(level, 1.0)[:, None, None]
    misfit = _left(decoder, heard)
    # Of more microphones one that is off may leave less than sensors of some designs do.
    if misfit <= min(expected, options.least_suspect):
        return SensorFit(misfit, expected, decoder.microphones)
    loudest = heard[np.argsort(-level, kind="stable")[: options.loudest]]
    unchanged = _left(decoder, loudest)
    found = [_level(decoder, loudest, k, unchanged, options) for k in range(len(decoder.microphones))]
    best = min(range(len(found)), key=lambda k: found[k][1])
    level, left = found[best]
    off = options.off <= abs(level) <= options.levels[-1] and left <= min(expected, unchanged / options.falls)
    return SensorFit(misfit, expected, decoder.microphones, (decoder.microphones[best], level) if off else None)


def _louder(decoder: Locator, noise: NDArray[np.float64]) -> float:
    """Ratio of the noise to that given to the decoder, rms, at least 1."""
    if noise.shape != (len(decoder.microphones),):
        raise Refusal(
            f"has shape {noise.shape}, must be ({len(decoder.microphones)},), one value for each microphone",
            kind=Kind.WRONG_TYPE,
            field="microphone_noise",
        )
    return max(1.0, float(np.sqrt(np.mean(noise**2))) / decoder.noise_rms)


def _left(decoder: Locator, frames: NDArray[np.float64]) -> float:
    return float(np.median(decoder.misfit(frames)))


def _level(
    decoder: Locator, frames: NDArray[np.float64], microphone: int, unchanged: float, options: FitOptions
) -> tuple[float, float]:
    """Level of a microphone, dB, at which touches are explained best, and what is left then; unchanged at 0 dB."""

    def left(level: float) -> float:
        as_told = frames.copy()
        as_told[:, microphone] /= 10 ** (level / 20)
        return _left(decoder, as_told)

    tried = {level: left(level) if level else unchanged for level in options.levels}
    for step in options.steps:
        best = min(tried, key=lambda each: tried[each])
        if best == 0:
            break
        tried |= {level: left(level) for level in (best - step, best + step)}
    best = min(tried, key=lambda each: tried[each])
    return best, tried[best]
