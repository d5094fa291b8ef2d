"""The decoder that needs no training: maximum likelihood over points, from the library alone.

If point i is touched, the microphones' samples of a frame, stacked into one vector x, are a zero-mean Gaussian with
covariance g C_i + N: C_i from :mod:`localize.decoders.frame_covariance`, g the unknown power of the touch, N the
covariance of the noise. The likelihood of each point, maximised over g, ranks the points (Gaussian-process
classification; Rasmussen and Williams 2006, chapter 2, for the likelihood). In coordinates where N is the identity, the
eigenvectors of C_i make the likelihood a sum over a few dozen terms.

Sound from outside presses on all membranes alike: at each frequency it adds a covariance of rank one to N, whose
shape the library knows and whose level is assumed, or found among several as the likeliest.

A touch with few spectral lines fills far fewer of those terms than a flat spectrum, so that the likelihood weighs the
noise of the empty ones too high against the shape of the signal: the decoder assumes a share of the noise that it is
told, and divides its log-likelihoods by a temperature, so that its probabilities are as sure as they are right.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import reduce
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geometry.ground.refusal import Refusal
from localize.decoders.frame_covariance import SAMPLES, check_level, check_noise, joint_whitening, touch_covariances
from localize.decoders.likelihood import (
    CHUNK,
    FAR,
    POWERS as POWERS,  # names that were of this module and still are
    SURE,
    TEMPERATURE as TEMPERATURE,
    TOO_MANY,
    WEAKEST as WEAKEST,
    Bounds,
    Screen,
    share_of as share_of,
    tables_of,
)
from localize.signals.array_response import ArrayResponse, response_of, warn_of_uncovered
from localize.signals.frames import checked_signals, cut_frames
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from localize.signals.threads import one_thread

if TYPE_CHECKING:
    from torch import Tensor

    from acoustic_fem import Library

LEADING = 3
"""Number of points whose scores are found in any case, however far the others are behind the best."""


def sound_levels(loudest: float | None) -> tuple[float | None, ...]:
    """Levels that cover sound up to the loudest, dB SPL, quiet (None) among them; of None quiet alone.

    15 dB apart from 40 on: 10 apart was tried on line-2, better at some levels and worse at others by up to 1.7 %.
    """
    if loudest is None:
        return (None,)
    return (None, *(float(level) for level in np.arange(40.0, loudest + 7.5, 15.0)))


ROOM = sound_levels(90.0)
"""Levels among which the sound of a room is looked for, dB SPL; None is quiet."""

#: Sound around: none, a level in dB SPL, or several, of which each frame takes the likeliest.
Ambient = float | None | Sequence[float | None]


class BayesDecoder:
    """Gaussian-process maximum likelihood over the points of one array.

    Args:
        library: transfer functions that cover 1 to 100 Hz, of at least two points and two microphones; touches are
            taken to be silent above their last frequency, with a warning where that is below 500 Hz.
        microphone_noise: the noise floor to assume: white, Pa rms over 0 to 500 Hz, 1e-9 to 10; or "design" for
            that of the library's design, see :mod:`localize.signals.noise_model`. It also stands for what the
            library does not know; a higher one is kinder to a sensor that differs from its design.
        ambient: pink sound around, the same pressure on all membranes: its level in dB SPL, 0 to 140; None for
            quiet; or several levels, such as :data:`ROOM`, of which each frame takes the likeliest. Tables, and where
            there is sound also time, grow with their number. Needs a library with a design.

    Raises:
        Refusal: the library does not cover 1 to 100 Hz, the noise or the sound is outside its range, or sound is
            assumed without a design.
    """

    bounds_scores: ClassVar[bool] = True
    """Whether points that cannot be near the best one get a bound of their score in its place, where that is enough."""

    @one_thread()
    def __init__(
        self,
        library: Library | ArrayResponse,
        microphone_noise: NoiseChoice = 1e-3,
        ambient: Ambient = None,
    ) -> None:
        check_noise(microphone_noise)
        response = self._heard(library)
        warn_of_uncovered(response)
        self.ambient = checked_levels(response, ambient)
        self.design = response.name
        self.microphones = response.microphones
        self.line = response.line
        self.place = response.place
        self.microphone_noise = microphone_noise
        self.provenance = response.provenance
        noise = response.noise(microphone_noise)
        self.noise_rms = noise.rms if isinstance(noise, NoiseSpectrum) else noise
        touched = self._touched(library, response)
        whitening = [self._white(response, share_of(noise), level) for level in self.ambient]
        self.tables = tuple(tables_of(touched, *each) for each in zip(whitening, self.ambient, strict=True))
        self._prepare(whitening)

    @property
    def point_count(self) -> int:
        """Number of sensing points."""
        return len(self.line)

    @property
    def assumes(self) -> str:
        """What is taken for granted of the sensor, in words."""
        return assumed_of(self.provenance)

    def _heard(self, library: Library | ArrayResponse) -> ArrayResponse:
        """The array that is decoded."""
        return response_of(library)

    def _touched(self, library: Library | ArrayResponse, response: ArrayResponse) -> NDArray[np.float64]:
        """Covariances of what may have been touched, (n_table, n, n) float64, Pa^2: of the points."""
        return touch_covariances(response, np.eye(SAMPLES))

    def _white(self, response: ArrayResponse, noise: float | NoiseSpectrum, level: float | None) -> NDArray[np.float64]:
        """Matrix that makes all that is heard beside touches white, (n, n) float64, 1/Pa."""
        return joint_whitening(response, noise, level)

    def _prepare(self, whitening: Sequence[NDArray[np.float64]]) -> None:
        """What scores the tables of each level of sound, whose noise and sound the matrices make white."""
        self._screens = tuple(Screen(tables, len(self.tables) > 1) for tables in self.tables)
        few = all(screen.is_exact for screen in self._screens)
        self._bounds = () if few or not self.bounds_scores else tuple(Bounds(tables) for tables in self.tables)

    @one_thread()
    def locate(self, signals: ArrayLike | Tensor) -> NDArray[np.float64]:
        """Where the array was touched, all points equally likely beforehand.

        A recording longer than 250 samples is cut into frames, the last one ending with it, which are taken as
        independent observations of one touch.

        Args:
            signals: (n_microphone, n_sample) or (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n_point,) or (n, n_point) float64: probability per point.

        Raises:
            Refusal: wrong number of channels, too few samples, a value that is not finite, a silent channel.
        """
        batch, batched = checked_signals(signals, self.microphones)
        probability = np.exp(_normalised(self._leading(batch)))
        return probability if batched else probability[0]

    @one_thread()
    def log_probability(self, signals: ArrayLike | Tensor) -> NDArray[np.float64]:
        """Logarithm of what :meth:`locate` gives, which does not end at the smallest number there is.

        Args:
            signals: (n, n_microphone, n_sample), Pa, at 1 kHz, at least 250 samples.

        Returns:
            (n, n_point) float64, nats.

        Raises:
            Refusal: as :meth:`locate`.
        """
        batch, _ = checked_signals(signals, self.microphones)
        return _normalised(self.joint_log_likelihood(batch))

    def _leading(self, batch: NDArray[np.float64]) -> NDArray[np.float64]:
        """:meth:`joint_log_likelihood`, but of points that are far behind the best what it is at most."""
        if not self._bounds:
            return self.joint_log_likelihood(batch)
        frames = cut_frames(batch)
        several = max(1, CHUNK // frames.shape[1])
        parts = [batch[k : k + several] for k in range(0, len(batch), several)]
        return np.concatenate([self._leading_of(part) for part in parts])

    def _leading_of(self, batch: NDArray[np.float64]) -> NDArray[np.float64]:
        """The same of few signals."""
        frames = cut_frames(batch)
        count, each = frames.shape[:2]
        white = [frames.reshape(count * each, -1) @ tables.reduce for tables in self.tables]
        alone = [screen.alone(x)[1] for screen, x in zip(self._screens, white, strict=True)]

        def joint(by_level: Iterable[NDArray[np.float64]]) -> NDArray[np.float64]:
            best = reduce(np.maximum, (score + own for score, own in zip(by_level, alone, strict=True)))
            return np.asarray(best.reshape(count, each, -1).sum(1))

        def exact(chosen: NDArray[np.bool_]) -> NDArray[np.float64]:
            of_frames = np.repeat(chosen, each, 0)
            return joint(screen.exact(x, of_frames) for screen, x in zip(self._screens, white, strict=True))

        score = joint(bound(x) for bound, x in zip(self._bounds, white, strict=True))
        # Of a frame that says little all points may be near the best: then a bound each is no help.
        many = (score > score.max(1, keepdims=True) - FAR).mean(1) > TOO_MANY
        if many.all():
            return joint(screen.all_exact(x) for screen, x in zip(self._screens, white, strict=True))
        leading = min(LEADING, self.point_count)
        known = np.zeros(score.shape, bool)
        np.put_along_axis(known, np.argpartition(-score, leading - 1, axis=1)[:, :leading], True, axis=1)
        score[known] = exact(known)[known]
        found = np.sort(np.where(known, score, -np.inf), axis=1)
        least = np.minimum(found[:, -1] - FAR, found[:, -leading])
        wanted = ~known & (score > least[:, None])
        many |= wanted.mean(1) > TOO_MANY
        wanted[many] = False
        if wanted.any():
            score[wanted] = exact(wanted)[wanted]
        if many.any():
            score[many] = joint(screen.all_exact(x) for screen, x in zip(self._screens, white, strict=True))[many]
        return score

    def joint_log_likelihood(self, batch: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihood of every point, all frames of each signal together.

        Args:
            batch: (n, n_microphone, n_sample) float64, Pa, as :func:`localize.signals.checked_signals` gives it.

        Returns:
            (n, n_point) float64, nats, up to a constant per signal.
        """
        frames = cut_frames(batch)
        flat = frames.reshape(-1, *frames.shape[2:])
        score = np.concatenate([self.log_likelihood(flat[k : k + CHUNK]) for k in range(0, len(flat), CHUNK)])
        return np.asarray(score.reshape(*frames.shape[:2], -1).sum(1))

    def misfit(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """What the best point leaves of each frame, by what the noise that was told leaves in the directions that a
        point does not reach; its determinants count, and so does what a frame's edges cut off.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n,) float64, 1 for a sensor that is known exactly, in the noise that was told.
        """
        flat = frames.reshape(len(frames), -1)
        power, fit, whole = [], [], []
        for screen in self._screens:
            white = flat @ screen.tables.reduce
            power.append((white**2).sum(1))
            fit.append(screen.all_exact(white).max(1))
            whole.append(fit[-1] + screen.alone(white)[1][:, 0])
        level = np.argmax(whole, axis=0)[None]
        empty = self.tables[0].reduce.shape[1] * (1 - 1 / len(self.microphones))
        left = np.array(power) / TEMPERATURE - 2 * np.array(fit)
        return np.asarray(np.take_along_axis(left, level, 0)[0] / empty)

    def log_likelihood(self, frames: NDArray[np.float64]) -> NDArray[np.float64]:
        """Log-likelihood of every point, maximised over the power of the touch and divided by the temperature.

        Args:
            frames: (n, n_microphone, 250) float64, Pa.

        Returns:
            (n, n_point) float64, nats, up to a constant per frame.
        """
        flat = frames.reshape(len(frames), -1)
        levels = [screen(flat) for screen in self._screens]
        # Points are left to single precision only where none of any level may come near the best of all.
        least = np.max([level.best for level in levels], axis=0) - SURE
        for screen, level in zip(self._screens, levels, strict=True):
            screen.score_again(level, least)
        return np.max([level.score for level in levels], axis=0) if len(levels) > 1 else levels[0].score


def assumed_of(provenance: Mapping[str, Any]) -> str:
    """What the decoder of an array takes for granted of its sensor, in words.

    Args:
        provenance: of the array, :attr:`localize.ArrayResponse.provenance`.
    """
    from acoustic_fem.library.transfer_functions import MEASURED

    air = air_of(provenance)
    if provenance.get("fidelity", MEASURED) == MEASURED:
        return f"that the sensor is as its library has it{air}"
    return f"that the sensor is exactly as it was designed{air}: tolerances of manufacturing are not reckoned with"


def air_of(provenance: Mapping[str, Any]) -> str:
    """The air that the library of an array is in, in words that follow others; empty where it is not known.

    Args:
        provenance: of the array, :attr:`localize.ArrayResponse.provenance`.
    """
    medium = provenance.get("medium")
    return f", in air of {medium['pressure'] / 1e3:.1f} kPa" if medium else ""


def checked_levels(response: ArrayResponse, ambient: Ambient) -> tuple[float | None, ...]:
    """Levels of an ``ambient``, from quiet to loud.

    Raises:
        Refusal: no level, or as :func:`localize.decoders.frame_covariance.check_level`.
    """
    levels = tuple(ambient) if isinstance(ambient, Sequence) else (ambient,)
    if not levels:
        raise Refusal("ambient is empty: it must hold at least one level, or None for quiet")
    for level in levels:
        check_level(response, level)
    return tuple(sorted(set(levels), key=lambda level: -1.0 if level is None else level))


def _normalised(total: NDArray[np.float64]) -> NDArray[np.float64]:
    """Logarithms of probabilities from log-likelihoods, both (n, n_point) nats."""
    total = total - total.max(1, keepdims=True)
    return np.asarray(total - np.log(np.exp(total).sum(1, keepdims=True)))
