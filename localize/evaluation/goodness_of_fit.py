"""Fit of a decoder to its sensor: the residual of its best point in the loudest touches.

A library of another array, a sensor that is further from its design than tolerances go, and a microphone that is
connected wrongly all leave more of a loud touch than a sensor as expected does, at every point. If the connection is
at fault, the correction of one fault brings the residual down to what is expected, so each fault is tried: the level,
the sign and the time of every microphone, and the exchange of every two.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import ArrayLike, NDArray

from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.evaluation.connection_faults import ConnectionFault, FaultOfConnection
from localize.live.events import Decision
from localize.signals.frames import FRAME, checked_signals
from localize.signals.locator import Locator
from localize.signals.stimulus import SAMPLE_RATE
from localize.signals.threads import one_thread

MARGIN = 262
"""Number of samples on either side of a loud frame that are kept: a channel may be late or early by so much, ms."""
FAULTY_TRUST = 0.2
"""Largest weight of decisions while a fault of the connection is known and not corrected: on virtual rigs of seeds 7100
to 7103 a sixth of the loud frames is then assigned to the correct point."""


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
    steps: tuple[float, ...] = (3.0, 1.5, 0.75, 0.375, 0.1875)
    """Steps in which the level is looked for then, dB, each around the best so far."""
    off: float = 5.0
    """Level from which on a microphone is far off, dB: its own tolerance is 1 dB."""
    latest: int = 252
    """Largest lateness of a channel that is tried first, ms; finer steps go on to :data:`MARGIN`."""
    late_step: int = 2
    """Step of the latenesses that are tried first, ms: half a period of the highest frequency of touches is 5 ms."""
    late_frames: int = 8
    """Number of loud frames that the lateness is looked for with."""
    late_screened: int = 2
    """Number of the loudest of these frames that all latenesses are tried on; the likeliest are tried on the others."""
    late_kept: int = 32
    """Number of latenesses that are tried on all of these frames."""
    late_steps: tuple[float, ...] = (1.0, 0.5, 0.25, 0.125, 0.0625)
    """Steps in which the lateness is looked for then, ms, each around the best so far."""
    refined: int = 3
    """Number of the best levels, or latenesses, that are tried first, around each of which finer ones are tried."""
    late: float = 1.5
    """Lateness from which on a channel is late, ms."""
    late_alone: float = 4.0
    """The same where only faults are looked for, ms: a softer sensor can look like one with a microphone 2 ms late."""
    falls: float = 1.7
    """Factor by which the residual must fall at least, and to the expected one, when a level or a time is corrected; by
    libraries of other arrays it falls to 6.6 at best (seeds 9100 to 9112)."""
    falls_by_order: float = 1.4
    """The same factor when a sign or the order of two microphones is corrected, which cannot be tuned. On symmetric
    designs the wrong order fits as well as the right one, within 1.1."""
    falls_alone: float = 5.0
    """The same factor where only faults are looked for: it is then enough by itself. How often that is right for
    strokes is in docs/evidence/streams.md."""
    better: float = 0.75
    """Fraction of the loud frames whose residual must be smaller when a fault is corrected."""


@dataclass(frozen=True)
class SensorFit:
    """Result of a check of how well a decoder explains the loudest touches of a sensor."""

    misfit: float
    """Residual of the best point in a frame over that of the noise, a ratio; the median over the frames."""
    expected: float
    """Largest such ratio of a sensor as the decoder expects it."""
    microphones: tuple[str, ...]
    """Names of the microphones."""
    fault: ConnectionFault | None = None
    """Fault of the connection that explains the residual; None if no single fault does. With two microphones only the
    difference between them is known, so the fault is given for the one whose correction leaves the smaller residual."""
    corrected_misfit: float | None = None
    """Residual after the fault was corrected; None without a fault."""
    only_faults: bool = False
    """True if the residual says nothing without a fault that explains it, because contacts may move, or the sensor may
    have changed."""

    @property
    def fits(self) -> bool:
        """True if nothing speaks against the sensor and its connection."""
        return self.fault is None and (self.only_faults or self.misfit <= self.expected)

    @property
    def warning(self) -> str | None:
        """Reason to distrust the decisions, in words; None if the sensor fits the library."""
        if self.fault is not None:
            return (
                f"{self.fault.described(self.microphones)}; the residual of the touches is {self.misfit:.3g} times "
                f"that of noise, and {self.corrected_misfit:.3g} times when this is corrected"
            )
        if self.fits:
            return None
        return (
            f"no point explains the touches: their residual is {self.misfit:.3g} times that of noise, and at most "
            f"{self.expected:g} is expected, so {self._consequence}; the library may be one of another array or air, "
            "the sensor may have changed, several microphones may be connected wrongly, or the room is louder than "
            "the given ambient level"
        )

    @property
    def _consequence(self) -> str:
        """Consequence of the misfit for the points, by its size."""
        if self.trust > 0.5:
            return "some points may be wrong"
        return "many points are wrong" if self.trust > 0.1 else "the points mean nothing"

    @property
    def trust(self) -> float:
        """Weight of the decisions against a uniform distribution over all points, 0 to 1; 1 if the sensor fits."""
        return self.trust_of(None)

    def trust_of(self, corrected: ConnectionFault | None) -> float:
        """Weight of the decisions, as of :attr:`trust`, after a fault was corrected; None for no correction."""
        if corrected is None and self.fits:
            return 1.0
        misfit = self.misfit if corrected is None or self.corrected_misfit is None else self.corrected_misfit
        trust = min(1.0, self.expected / misfit)
        return min(FAULTY_TRUST, trust) if corrected is None and self.fault is not None else trust


class LoudFrames:
    """Loudest frames of a stream whose samples are others, gathered while it goes on."""

    def __init__(self, options: FitOptions = FitOptions()) -> None:
        self._options = options
        self._kept: list[tuple[Decision, Array]] = []
        self._waiting: deque[Decision] = deque()
        self.count = 0
        """Number of loud frames so far that do not overlap, with those that were dropped for louder ones."""
        self._newest: Array = np.zeros((0, 0))  # samples up to the time, of the last decision or what passed since
        self._time = 0.0

    def take(self, events: Iterable[object]) -> None:
        """Take what a stream says next, whose decisions carry their samples."""
        for event in events:
            if isinstance(event, Decision):
                self._take(event)

    def _take(self, event: Decision) -> None:
        if not self._newest.size:
            if event.frame is None:
                return
            # A frame waits for its margin behind it, and time passes in steps of a frame or a margin at most.
            self._newest = np.zeros((len(event.frame), FRAME + 2 * MARGIN + max(FRAME, MARGIN)))
            self._time = event.time
        passed = round((event.time - self._time) * SAMPLE_RATE)
        if not 0 <= passed <= FRAME:  # samples were lost, or the device counts anew
            if self._waiting:
                self._keep_waiting()
            self._newest[:] = 0.0
            passed = 0
        self._pass(passed)
        self._time = event.time
        if event.frame is not None:
            self._newest[:, -FRAME:] = event.frame
            if event.state == "touch":
                self._waiting.append(event)
        self._keep_due()

    def _pass(self, samples: int) -> None:
        """Let time pass: samples that no decision carries are silence."""
        if samples:
            self._newest = np.roll(self._newest, -samples, axis=1)
            self._newest[:, -samples:] = 0.0
            self._time += samples / SAMPLE_RATE

    def _keep_due(self) -> None:
        """Keep the waiting frames whose margin behind them is there."""
        while self._waiting:
            behind = round((self._time - self._waiting[0].time) * SAMPLE_RATE) - MARGIN
            if behind < 0:
                return
            end = self._newest.shape[1] - behind
            self._keep(self._waiting.popleft(), self._newest[:, end - FRAME - 2 * MARGIN : end].copy())

    def _keep_waiting(self) -> None:
        self._pass(MARGIN)
        self._keep_due()

    def _keep(self, event: Decision, samples: Array) -> None:
        near = [each for each in self._kept if abs(each[0].time - event.time) < FRAME / SAMPLE_RATE]
        if any(each[0].level >= event.level for each in near):
            return
        self.count += not near
        self._kept = [each for each in self._kept if all(each is not other for other in near)] + [(event, samples)]
        if len(self._kept) > self._options.most:
            least = min(range(len(self._kept)), key=lambda k: self._kept[k][0].level)
            del self._kept[least]

    def frames(self, *, ended: bool = True) -> list[Array]:
        """Frames so far with their margins, where the stream was silent if no decision carries the samples.

        Args:
            ended: whether the stream has ended, so that what is still to come is taken to be silent.

        Returns:
            (n_microphone, 774) float64 each, Pa: 262 samples, the 250 of the frame, and 262 samples.
        """
        if ended and self._waiting:
            self._keep_waiting()
        return [samples for _, samples in self._kept]


def loudest_frames(signals: Array, least: float, options: FitOptions = FitOptions()) -> list[Array]:
    """Loudest frames of a recording with the samples around them, for :func:`sensor_fit`.

    Args:
        signals: (n_microphone, n_sample) float64, Pa, at 1 kHz, behind a high-pass.
        least: level that a frame has at least at its loudest microphone, Pa rms.
        options: numbers that tune the test.

    Returns:
        (n_microphone, 774) float64 each, Pa, the loudest first, at most 32; zeros stand before and after the recording.
    """
    padded = np.pad(signals, ((0, 0), (MARGIN, MARGIN)))
    frames = sliding_window_view(padded, FRAME + 2 * MARGIN, axis=1)[:, ::FRAME].transpose(1, 0, 2)
    level = frames[..., MARGIN : MARGIN + FRAME].std(2).max(1)
    loudest = np.argsort(-level, kind="stable")[: options.most]
    return [frames[k].copy() for k in loudest if level[k] >= least]


@one_thread()
def sensor_fit(
    decoder: Locator,
    frames: ArrayLike,
    microphone_noise: ArrayLike | None = None,
    options: FitOptions = FitOptions(),
    *,
    only_faults: bool = False,
) -> SensorFit | None:
    """Fit of a decoder to the loudest touches, and the fault of the microphones' connection if one explains the misfit.

    Args:
        decoder: of a library.
        frames: of touches, at several points if possible; (n, n_microphone, 250) or, with the samples before and after,
            (n, n_microphone, 774), as of :class:`LoudFrames`; Pa, at 1 kHz. Late channels are looked for if the samples
            before and after are there.
        microphone_noise: of the microphones as it was measured, (n_microphone,) Pa rms; by default that of the decoder.
        options: numbers that tune the test.
        only_faults: whether only a fault of the connection is looked for, because contacts may move over the surface,
            or the sensor may have changed: both leave a larger residual. A fault is then reported if its correction
            lowers the residual to a fifth.

    Returns:
        None for fewer than 8 frames, and where it is not known what sensors leave: of a computed library whose
        tolerances are not known or not modelled, unless only faults are looked for, and of a network.

    Raises:
        Refusal: as :meth:`localize.BayesDecoder.locate`, or noise of another number of microphones.
    """
    expected, given = decoder.largest_misfit, np.asarray(frames)
    if (
        only_faults
        and expected is None
        and not np.isnan(decoder.misfit(np.zeros((1, len(decoder.microphones), FRAME)))[0])
    ):
        expected = 0.0
    if expected is None or len(given) < options.fewest:
        return None
    heard = checked_signals(given, decoder.microphones)[0][: options.most].copy()
    if microphone_noise is not None:
        # Before loud frames are brought to their level: what the sensor leaves is then still seen above the noise.
        heard /= _louder(decoder, np.asarray(microphone_noise, np.float64))
    level = _inner(heard).std(2).max(1) / (options.noise_multiple * decoder.noise_rms)
    heard /= np.maximum(level, 1.0)[:, None, None]
    misfit = _left(decoder, heard)
    loudest = heard[np.argsort(-level, kind="stable")[: options.loudest]]
    search = _FaultSearch(decoder, loudest, expected, options, only_faults)
    # Of more microphones one that is off may leave less than sensors of some designs do.
    found = search.found(misfit > min(expected, options.least_suspect))
    fault, left = found or (None, None)
    return SensorFit(misfit, expected, decoder.microphones, fault, left, only_faults)


class _FaultSearch:
    """Search for the fault of a connection that explains loud touches best.

    Args:
        decoder: of a library.
        frames: (n, n_microphone, 250) or with margins, Pa, the loudest first.
        expected: largest residual of a sensor as the decoder expects it, over that of the noise.
        options: numbers that tune the test.
        only_faults: as of :func:`sensor_fit`.
    """

    def __init__(
        self, decoder: Locator, frames: Array, expected: float, options: FitOptions, only_faults: bool
    ) -> None:
        self._decoder, self._frames, self._expected, self._options = decoder, frames, expected, options
        self._only_faults = only_faults
        self._few = frames[:: max(1, len(frames) // options.late_frames)]
        self._unchanged = decoder.misfit(_inner(frames))

    def found(self, suspect: bool) -> tuple[ConnectionFault, float] | None:
        """Fault that explains the touches, with the residual after its correction; None if none does.

        Args:
            suspect: whether the touches leave so much that faults of level and time are looked for too.
        """
        best = self._best(self._of_order(), self._options.falls_by_order)
        if suspect and (best is None or best[1] > self._options.least_suspect):
            tuned = self._best([*self._levels(), *self._times()], self._options.falls)
            best = min((each for each in (best, tuned) if each is not None), key=lambda each: each[1], default=None)
        return best

    def _best(self, faults: Iterable[ConnectionFault], falls: float) -> tuple[ConnectionFault, float] | None:
        """Best of some faults, if it explains the touches so much better that it is believed."""
        tried = [(each, self._misfit(each, self._frames)) for each in faults]
        if not tried:
            return None
        fault, each = min(tried, key=lambda one: _typical(one[1]))
        left, better = float(np.median(each)), float((each < self._unchanged).mean())
        fall = _typical(self._unchanged) / _typical(each)
        explained = left <= self._expected or (self._only_faults and fall >= self._options.falls_alone)
        return (fault, left) if fall >= falls and explained and better >= self._options.better else None

    def _misfit(self, fault: ConnectionFault, frames: Array) -> Array:
        return self._decoder.misfit(_inner(fault.corrected(frames, self._decoder.microphones)))

    def _of_order(self) -> list[ConnectionFault]:
        names = self._decoder.microphones
        exchanged = [ConnectionFault("exchanged", pair) for pair in combinations(names, 2)]
        return [*exchanged, *(ConnectionFault("reversed", (name,)) for name in _changed(names))]

    def _levels(self) -> list[ConnectionFault]:
        """Level of each microphone at which touches are explained best, if it is far off."""
        options = self._options
        found = [
            self._refined(name, "level", options.levels, options.steps, self._frames)
            for name in self._decoder.microphones
        ]
        return [each for each in found if options.off <= abs(each.amount) <= options.levels[-1]]

    def _times(self) -> list[ConnectionFault]:
        """Lateness of each microphone at which touches are explained best, if it is late."""
        options = self._options
        if self._frames.shape[2] == FRAME:
            return []
        steps = [1e-3 * step for step in options.late_steps]
        found = [
            self._refined(name, "late", self._likely_times(name), steps, self._few)
            for name in _changed(self._decoder.microphones)
        ]
        least = options.late_alone if self._only_faults else options.late
        return [each for each in found if abs(each.amount) >= 1e-3 * least]

    def _likely_times(self, name: str) -> list[float]:
        """Latenesses of a microphone at which the loudest frames are explained best, s, and 0."""
        options = self._options
        latest = options.latest - options.latest % options.late_step
        loudest = self._few[: options.late_screened]

        def left(late: int) -> float:
            return _typical(self._misfit(ConnectionFault("late", (name,), 1e-3 * late), loudest))

        tried = sorted(range(-latest, latest + 1, options.late_step), key=left)
        return [1e-3 * late for late in dict.fromkeys([0, *tried[: options.late_kept]])]

    def _refined(
        self, name: str, kind: FaultOfConnection, amounts: Sequence[float], steps: Sequence[float], frames: Array
    ) -> ConnectionFault:
        """Fault of a microphone of the amount at which frames are explained best; 0 if nothing is better.

        Args:
            name: of the microphone.
            kind: of the fault.
            amounts: that are tried first, as of :class:`ConnectionFault`; 0 is among them.
            steps: ever smaller ones, in which the amount is looked for then around the best so far.
            frames: as of the class.
        """

        def left(amount: float) -> float:
            return _typical(self._misfit(ConnectionFault(kind, (name,), amount), frames))

        tried = {amount: left(amount) for amount in amounts}
        for begin in sorted(tried, key=lambda each: tried[each])[: self._options.refined]:
            best = begin
            for step in steps if begin else ():
                near = {amount: left(amount) for amount in (best - step, best + step)} | {best: tried[best]}
                tried |= near
                best = min(near, key=lambda each: near[each])
        return ConnectionFault(kind, (name,), min(tried, key=lambda each: tried[each]))


def _typical(misfit: Array) -> float:
    """Geometric mean of the residuals of frames, (n,): no loud frame outweighs the others, and none is ignored."""
    return float(np.exp(np.log(np.maximum(misfit, 1e-3)).mean()))


def _changed(names: tuple[str, ...]) -> tuple[str, ...]:
    """Microphones whose sign or time is tried: of two, one is enough, because only the difference counts."""
    return names[:1] if len(names) == 2 else names


def _louder(decoder: Locator, noise: NDArray[np.float64]) -> float:
    """Ratio of the noise to that given to the decoder, rms, at least 1."""
    if noise.shape != (len(decoder.microphones),):
        raise Refusal(
            f"has shape {noise.shape}, must be ({len(decoder.microphones)},), one value for each microphone",
            kind=Kind.WRONG_TYPE,
            field="microphone_noise",
        )
    return max(1.0, float(np.sqrt(np.mean(noise**2))) / decoder.noise_rms)


def _inner(frames: Array) -> Array:
    """Frames without their margins; (n, n_microphone, 250)."""
    margin = (frames.shape[2] - FRAME) // 2
    return frames[..., margin : margin + FRAME]


def _left(decoder: Locator, frames: NDArray[np.float64]) -> float:
    return float(np.median(decoder.misfit(_inner(frames))))
