"""Touches while they happen: samples in, in chunks of any size; a decision every 16 ms out.

Every 16 samples the last 250 are classified, behind the high-pass of :mod:`localize.live.front_end` and without mains
hum. If no microphone is louder than its noise, the frame is silent and no point is given. The same holds for a frame
that holds only the decay of a touch, and, if the stream has the tests for it, for one that sound explains or no point
explains. Faults are reported, and the stream goes on: lost or repeated samples, values that are not finite, clipping, a
channel that is dead or hisses. Decisions depend on the samples alone, not on how they were cut into chunks.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem.network.microphone_output import Equaliser
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.decoders.judgement import ResidualTest
from localize.decoders.motion_test import MotionTest
from localize.decoders.reconstruct import Reconstructor
from localize.decoders.sound_test import SoundTest
from localize.live.clipped_samples import ClippedSamples
from localize.live.events import HOP, Decision, Fault, FaultKind
from localize.live.frame_classifier import Fallback, FrameClassifier
from localize.live.front_end import HighPass, Hum, NoiseFloor
from localize.live.stream_options import StreamOptions
from localize.signals.frames import FRAME
from localize.signals.locator import Locator
from localize.signals.stimulus import SAMPLE_RATE

LARGEST_PRESSURE = 1e6
"""Largest value that is a pressure, Pa: ten atmospheres."""
LARGEST_NUMBER = 2**53
"""Largest number of a sample; its time is exact below."""
_MARGIN = 64 * HOP
"""Samples of the ring buffer beyond those that are needed, so that it is moved seldom."""
BEGINNING, QUIET = 80, 0.1
"""Samples at the beginning of a frame, and level in them, by that of the frame, up to which a touch in it is whole."""
NEWEST = 96
"""Number of samples of :attr:`Decision.newest`."""


class TouchStream:
    """Stream of decisions from microphones, 250 samples at a time.

    Args:
        locator: classifies frames; if it follows its sensor, the stream keeps its state.
        silence: Pa rms about the mean over a frame; a frame in which no microphone is louder is silent. By default
            twice the noise of a microphone that the locator was made for, at least 1e-6 Pa.
        limit: Pa; a sample that reaches it is clipped. By default no sample is.
        reconstructor: gives the waveform at the decided point; the filters of a point are made when it is first needed,
            which takes some tens of milliseconds.
        sound_test: detects frames that hold only room sound. By default sound is taken for a touch.
        residual_test: rejects frames that no point explains. By default the likeliest point is always given. On a
            sensor that differs from its library by a percent it rejects most touches.
        options: preparation of the samples, and thresholds.
        equaliser: makes pressures of samples that are outputs of microphones, see
            :mod:`acoustic_fem.network.microphone_output`; by default samples are pressures.
        motion_test: detects frames that hold only motion of the sensor. By default motion is taken for a touch.

    Raises:
        Refusal: a threshold that is not finite and positive, or a reconstructor or a test for other microphones.
    """

    def __init__(
        self,
        locator: Locator,
        silence: float | None = None,
        limit: float | None = None,
        reconstructor: Reconstructor | None = None,
        sound_test: SoundTest | None = None,
        residual_test: ResidualTest | None = None,
        options: StreamOptions = StreamOptions(),
        equaliser: Equaliser | None = None,
        motion_test: MotionTest | None = None,
    ) -> None:
        for name, part in (
            ("reconstructor", reconstructor), ("sound_test", sound_test), ("residual_test", residual_test),
            ("motion_test", motion_test),
        ):  # fmt: skip
            if part is not None and part.microphones != tuple(locator.microphones):
                problem = (
                    f"is for microphones {', '.join(part.microphones)}, the locator for "
                    f"{', '.join(locator.microphones)}"
                )
                raise Refusal(problem, kind=Kind.MISMATCH, field=name)
        self.locator, self.options, self.reconstructor = locator, options, reconstructor
        self._equaliser = equaliser
        usual = options.silence_of(locator.noise_rms)
        self.silence, self.limit = usual if silence is None else silence, limit
        for name, value in (("silence", self.silence), ("limit", limit)):
            if value is not None:
                check_range(name, value, 0, unit="Pa", excluded="both")
        self._microphones = tuple(locator.microphones)
        self._classifier_of = Fallback(
            FrameClassifier(locator, sound_test, residual_test, motion_test), options.fallback
        )
        self._state = locator.start
        channels = len(self._microphones)
        self._high_pass = HighPass(channels, options.high_pass)
        self._hum, self._floor = Hum(channels, options), NoiseFloor(channels, options)
        self._clipped = None
        if equaliser is not None and limit is not None:
            self._clipped = ClippedSamples(channels, limit, equaliser, options.high_pass)
        # An estimate needs a window, the 16 of a hop some samples more.
        self._history = max(FRAME, 0 if reconstructor is None else reconstructor.window + HOP - 1)
        # Pressures, pressures behind the front end, and samples as they come.
        self._buffer = np.empty((3, channels, self._history + _MARGIN))
        self._next: int | None = None  # number of the sample that is due
        self._repeated_to: int | None = None  # where repeated samples so far end
        self._bad: dict[tuple[FaultKind, int], int] = {}  # number of the sample up to which a reported fault was seen
        self._restart()

    @property
    def delay(self) -> float:
        """Group delay of the high-pass at 20 Hz, s."""
        return self._high_pass.delay

    @property
    def noise(self) -> Array:
        """Noise of the microphones as it is measured; (n_microphone,) float64, Pa rms, 0 before it was."""
        return self._floor.rms

    @property
    def state(self) -> Any:
        """State of a locator that follows its sensor, as of :meth:`localize.Locator.follow`."""
        return self._state

    def push(self, chunk: ArrayLike, first: int | None = None) -> list[Decision | Fault]:
        """Decisions on the next samples, and faults in them.

        Args:
            chunk: (n_microphone, n), Pa, at 1 kHz, any n.
            first: number of the chunk's first sample in the stream. By default it follows the chunk before; a larger
                number means that samples are lost, a smaller one that they are repeated, and those are left out; one
                that is smaller by more than a second, that the device counts anew.

        Returns:
            Decisions and faults in the order in which they came about.

        Raises:
            Refusal: a chunk of another shape or of complex numbers, or a ``first`` that is not a whole number from 0 to
                2^53; the stream has then taken no sample.
        """
        if first is not None and (
            isinstance(first, bool) or not isinstance(first, (int, np.integer)) or not 0 <= first <= LARGEST_NUMBER
        ):
            raise Refusal(kind=Kind.WRONG_TYPE, field="first", value=first, allowed="a whole number from 0 to 2^53")
        if np.iscomplexobj(chunk):
            problem = "holds complex numbers, must hold pressures in Pa"
            raise Refusal(problem, kind=Kind.WRONG_TYPE, field="chunk")
        samples = np.asarray(chunk, np.float64)
        if samples.ndim != 2 or len(samples) != len(self._microphones):
            problem = (
                f"has shape {samples.shape}, must be (n_microphone, n) = ({len(self._microphones)}, n): "
                f"{', '.join(self._microphones)}"
            )
            raise Refusal(problem, kind=Kind.WRONG_TYPE, field="chunk")
        events: list[Decision | Fault] = []
        first = None if first is None else int(first)
        due = self._next if self._next is not None else first or 0
        lost = 0 if first is None else first - due
        if first is not None and lost < -self.options.restart:
            events.append(Fault(first / SAMPLE_RATE, "restarted"))
            due = first
            self._bad = {}
            self._restart()
        elif lost > 0:
            events.append(Fault(due / SAMPLE_RATE, "samples lost", samples=lost))
            due += lost
            self._restart()
        elif first is not None and lost < 0:
            repeated = min(-lost, samples.shape[1])
            if repeated and first != self._repeated_to:
                events.append(Fault(first / SAMPLE_RATE, "samples repeated", samples=repeated))
            self._repeated_to = first + repeated
            samples = samples[:, repeated:]
        self._next = due
        for good, run in _runs(np.abs(samples) < LARGEST_PRESSURE, samples):
            if good.all():
                self._listen(run, events)
            else:
                self._skip(run, good, events)
        return events

    def _restart(self, tell: bool = False) -> None:
        """Forget the samples so far: a frame never spans a gap.

        Decisions begin with the first whole frame, or at once if the missing frames are to be reported as unreadable.
        """
        self._end = 0
        self._due = FRAME % HOP if tell else FRAME
        self._loudest, self._least = 0.0, np.inf  # levels: what may be left of a touch, and the least of it so far
        # Behind a gap there may be the rest of a touch, which has no beginning to be located by.
        self._behind_gap = self._next is not None
        self._hum.reset()
        self._floor.reset()
        if self._clipped is not None:
            self._clipped.reset()
        self._hum_coming = self._hum.coming(self._due)  # up to the next decision

    def _skip(self, run: Array, good: NDArray[np.bool_], events: list[Decision | Fault]) -> None:
        """A run of samples in which the same channels hold no pressure."""
        for channel in range(len(good)):
            if not good[channel]:
                self._tell("not finite", channel, self._number + run.shape[1], events)
        self._restart(tell=True)
        self._next = self._number + run.shape[1]

    def _listen(self, run: Array, events: list[Decision | Fault]) -> None:
        taken = 0
        while taken < run.shape[1]:
            count = min(self._due, run.shape[1] - taken)
            if self._end + count > self._buffer.shape[2]:
                kept = min(self._end, self._history)
                self._buffer[..., :kept] = self._buffer[..., self._end - kept : self._end]
                self._end = kept
            came = run[:, taken : taken + count]
            part = self._equalised(came)
            if self._clipped is not None:
                self._clipped.take(came)
            self._buffer[[0, 2], :, self._end : self._end + count] = part, came
            if self._end >= FRAME:
                self._buffer[1, :, self._end : self._end + count] = self._conditioned(part)
            taken += count
            self._end += count
            self._due -= count
            self._next = self._number + count
            if self._due == 0:
                self._due = HOP
                if self._end < FRAME:
                    level = float(self._buffer[0, :, : self._end].std(1).max())
                    events.append(Decision(self._time, "unreadable", level))
                else:
                    if self._end == FRAME:
                        self._buffer[1, :, :FRAME] = self._high_pass.begin(self._buffer[0, :, :FRAME])
                    raw, frame, came = self._buffer[..., self._end - FRAME : self._end]
                    self._classify(raw, frame, came, events)
                self._hum_coming = self._hum.coming(HOP)

    def _equalised(self, samples: Array) -> Array:
        """Samples as pressures; the filter begins anew behind a gap."""
        if self._equaliser is None:
            return samples
        return self._equaliser(samples) if self._end else self._equaliser.begin(samples)

    def _conditioned(self, samples: Array) -> Array:
        """Samples that follow those before, behind the front end."""
        passed = self._high_pass(samples)
        first = self._hum_coming.shape[1] - self._due
        return passed - self._hum_coming[:, first : first + samples.shape[1]]

    def _classify(self, raw: Array, frame: Array, came: Array, events: list[Decision | Fault]) -> None:
        """Classify a frame: its pressures, those behind the front end, and the samples as they came."""
        dead, clipped = self._bad_channels(came, events)
        good = ~(dead | clipped)
        if self._clipped is not None and self._clipped.channels.any():
            good &= ~self._clipped.channels
            if self._classifier_of(good) is None and not dead.any():
                if self._clipped.in_frame:
                    self._classify_clipped(self._clipped, frame, events)
                    return
                frame = self._begun_anew(came)
                raw, good = self._buffer[0, :, :FRAME], np.ones(len(good), bool)
        if self.options.follow and self._classifier_of(good) is not None:
            self._floor.take(frame)
            good &= ~self._channels_of_other_noise(frame, events)
        classifier = self._classifier_of(good)
        if classifier is None:
            events.append(Decision(self._time, "unreadable", float(frame.std(1).max())))
            return
        self._classify_by(classifier, good, raw, frame, events)

    def _classify_by(
        self,
        classifier: FrameClassifier,
        good: NDArray[np.bool_],
        raw: Array,
        whole: Array,
        events: list[Decision | Fault],
    ) -> None:
        """Classify a frame by those of its channels that are good."""
        options = self.options
        frame, noise = whole[good], self._floor.rms[good]
        kept = whole.copy() if options.frames and good.all() else None
        mean = float(raw[good, -HOP:].mean())
        level = float(frame.std(1).max())
        newest = float(frame[:, -NEWEST:].std(1).max())
        self._loudest *= 10 ** (-options.fade_rate / 20 * HOP / SAMPLE_RATE)
        loud = self._loudness(frame, noise)
        if self._behind_gap:
            self._behind_gap = loud > 1.0 and self._begins_loud(frame, noise)
        if loud <= 1.0:
            if options.follow:
                self._hum.learn(whole[:, -HOP:])
            events.append(Decision(self._time, "no touch", level, newest=newest, mean_pressure=mean))
            return
        if self._behind_gap:
            events.append(Decision(self._time, "unreadable", level))
            return
        if options.fade and level < min(options.faded * self._loudest, options.risen * self._least):
            self._least = min(self._least, level)
            events.append(Decision(self._time, "fading", level, newest=newest, mean_pressure=mean, frame=kept))
            return
        beside = _beside_sound(classifier, frame, noise)
        if beside is not None and beside[0] > beside[1] and options.follow and loud <= options.weak:
            beside = _beside_sound(classifier, self._hum.beside(frame), noise)
        if beside is not None and beside[0] <= beside[1]:
            events.append(Decision(self._time, "sound", level, newest=newest, mean_pressure=mean))
            return
        if classifier.motion_test is not None and _is_motion(classifier.motion_test, frame, noise):
            events.append(Decision(self._time, "motion", level, newest=newest, mean_pressure=mean))
            return
        if level < options.faded * self._loudest:  # a new one
            self._loudest = 0.0
        if level > self._loudest:
            self._loudest = self._least = level
        self._least = min(self._least, level)
        found, self._state = classifier.locator.follow(frame, self._state)
        point, test = int(found.argmax()) + 1, classifier.residual_test
        if test is not None and test.p_value(frame[None], [point])[0] < options.rejected_fraction:
            events.append(Decision(self._time, "other", level, newest=newest, mean_pressure=mean, frame=kept))
            return
        weight = None if beside is None else math.sqrt(beside[0])
        shape = self._waveform(point) if good.all() else None
        sure = float(found[point - 1])
        events.append(Decision(self._time, "touch", level, point, sure, found, weight, newest, mean, kept, shape))

    def _classify_clipped(self, clipped: ClippedSamples, frame: Array, events: list[Decision | Fault]) -> None:
        """Classify a frame with clipped samples by all that they leave known."""
        level = float(frame.std(1).max())
        if self._behind_gap:
            self._behind_gap = self._begins_loud(frame, self._floor.rms)
        found = None
        if not self._behind_gap:
            found, self._state = clipped.decided(self.locator, frame, self._state, self.options)
        if found is None:
            events.append(Decision(self._time, "unreadable", level))
            return
        point, newest = int(found.argmax()) + 1, float(frame[:, -NEWEST:].std(1).max())
        events.append(Decision(self._time, "touch", level, point, float(found[point - 1]), found, newest=newest))

    def _begun_anew(self, came: Array) -> Array:
        """The newest frame, with filters that begin with it: what they remembered was clipped, and is a gap now."""
        assert self._equaliser is not None
        assert self._clipped is not None
        self._buffer[2, :, :FRAME] = came.copy()
        self._buffer[0, :, :FRAME] = self._equaliser.begin(self._buffer[2, :, :FRAME])
        self._buffer[1, :, :FRAME] = self._high_pass.begin(self._buffer[0, :, :FRAME])
        self._clipped.begin()
        self._end, self._behind_gap = FRAME, True
        self._loudest, self._least = 0.0, np.inf
        return np.asarray(self._buffer[1, :, :FRAME])

    def _bad_channels(self, raw: Array, events: list[Decision | Fault]) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Channels of a frame that are dead, and that are clipped, (n_microphone,); a fault is reported for each."""
        highest, lowest = raw.max(1), raw.min(1)
        dead = (highest == lowest) | (raw.std(1) < self.options.dead_fraction * self.locator.noise_rms)
        clipped = np.maximum(highest, -lowest) >= (np.inf if self.limit is None else self.limit)
        for channel in np.flatnonzero(dead | clipped).tolist():
            if dead[channel]:
                self._tell("dead channel", channel, self._number, events)
            if clipped[channel]:
                self._tell("clipped", channel, self._number, events)
        return dead, clipped

    def _channels_of_other_noise(self, frame: Array, events: list[Decision | Fault]) -> NDArray[np.bool_]:
        """Channels whose noise is missing or far above that of the decoder, (n_microphone,); a fault is reported."""
        expected = self.silence / self.options.silence
        hisses = self._floor.hisses(expected) & (self._floor.rms > self.options.rough_fraction * frame.std(1))
        # A microphone that is only quieter than it should be hears a touch far above its own noise.
        hears = frame.std(1) > self.options.hears * self._floor.rms
        dead = self._floor.dead(expected) & ~hears
        for channel in np.flatnonzero(hisses | dead).tolist():
            self._tell("hissing channel" if hisses[channel] else "dead channel", channel, self._number, events)
        return np.asarray(hisses | dead)

    def _loudness(self, frame: Array, noise: Array) -> float:
        """Level of the loudest microphone over that up to which it is silent; what may be hum is left out."""
        least = np.maximum(self.silence, self.options.silence * noise)
        loud = float((frame.std(1) / least).max())
        if self.options.follow and 1.0 < loud <= self.options.weak:
            return float((self._hum.beside(frame).std(1) / least).max())
        return loud

    def _begins_loud(self, frame: Array, noise: Array) -> bool:
        """True if a frame is loud from its beginning on, so that a touch in it may have begun before it."""
        least = np.maximum(self.silence, self.options.silence * noise)
        cleaned = self._hum.beside(frame) if self.options.follow else frame
        quiet = np.maximum(least, QUIET * cleaned.std(1).max())
        return bool((cleaned[:, :BEGINNING].std(1) > quiet).any())

    def _waveform(self, point: int) -> tuple[float, ...] | None:
        """The newest 16 estimates that the samples so far allow."""
        if self.reconstructor is None or self._end < self.reconstructor.window + HOP - 1:
            return None
        taps = self.reconstructor.filters(point)
        newest = self._buffer[0, :, self._end - self.reconstructor.window - HOP + 1 : self._end]
        # Tap k takes the sample k before the newest: a window times the taps backwards.
        windows = np.lib.stride_tricks.sliding_window_view(newest, self.reconstructor.window, axis=1)
        return tuple(np.einsum("mhk,mk->h", windows, taps[:, ::-1]).tolist())

    def _tell(self, kind: FaultKind, channel: int, until: int, events: list[Decision | Fault]) -> None:
        """Report a fault when it begins, not while it lasts or soon returns."""
        seen = self._bad.get((kind, channel))
        if seen is None or self._number - seen > self.options.fault_memory:
            events.append(Fault(self._time, kind, self._microphones[channel]))
        self._bad[kind, channel] = until

    @property
    def _number(self) -> int:
        return self._next or 0

    @property
    def _time(self) -> float:
        return self._number / SAMPLE_RATE


def _beside_sound(classifier: FrameClassifier, frame: Array, noise: Array) -> tuple[float, float] | None:
    """Energy that sound does not explain, and the most that it leaves; None where it is not expected."""
    test = classifier.sound_test
    if test is None:
        return None
    found, most = test.beside(frame[None], max(1.0, float(noise.max()) / test.noise_rms))
    return float(found[0]), float(most[0])


def _is_motion(test: MotionTest, frame: Array, noise: Array) -> bool:
    """True if motion of the sensor explains a frame."""
    return bool(test.is_motion(frame[None], max(1.0, float(noise.max()) / test.noise_rms))[0])


def _runs(good: NDArray[np.bool_], samples: Array) -> list[tuple[NDArray[np.bool_], Array]]:
    """Runs of samples over which the same channels are good: (n_microphone,) and (n_microphone, n) of each."""
    if not samples.shape[1]:
        return []
    if good.all():
        return [(good[:, 0], samples)]
    cuts = np.flatnonzero((good[:, 1:] != good[:, :-1]).any(0)) + 1
    return [(part[:, 0], run) for part, run in zip(np.split(good, cuts, 1), np.split(samples, cuts, 1), strict=True)]
