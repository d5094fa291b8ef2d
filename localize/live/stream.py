"""Touches while they happen: samples in, in chunks of any size; a decision every 16 ms out.

Every 16 samples the last 250 are judged, behind the high-pass of :mod:`localize.live.front_end` and without the hum of
mains. Where no microphone hears more than its noise there is no touch, and nothing is guessed; nor where a touch has
ended and only what is left of it is heard, where sound explains what they hear, or where no point does, if the stream
is given the tests of that. What goes wrong with a stream is reported and survived: lost or repeated samples, values
that are not finite, clipping, a channel that is dead or hisses. Decisions depend on the samples alone, not on how they
were cut up.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from geometry.ground.refusal import Refusal
from localize.live.events import HOP, Decision, Fault, FaultKind
from localize.live.front_end import WEAK, HighPass, Hum, Listening, NoiseFloor
from localize.live.spare import Judges, JudgesOfTheRest, Spare, StreamLocator
from localize.signals.frames import FRAME
from localize.signals.stimulus import SAMPLE_RATE

if TYPE_CHECKING:
    from localize.decoders.judgement import ResidualTest
    from localize.decoders.reconstruct import Reconstructor
    from localize.decoders.sound_test import SoundTest

SILENCE = 2.0
"""Multiple of its noise above which a microphone hears something."""
LEAST_SILENCE = 1e-6
"""Threshold of silence where no noise is assumed, Pa rms."""
LARGEST_PRESSURE = 1e6
"""Largest value that is a pressure, Pa: ten atmospheres."""
DEAD = 0.02
"""Share of a microphone's noise below whose level a channel is dead: its converter may still toggle."""
RESTART = 1000
"""Largest step back in the numbers of samples that repeats some, samples; a larger one is a device that was started
anew."""
REFUSED = 1e-6
"""Share of the frames of true touches that are refused: at 62 a second one in four hours."""
HISSES = 0.01
"""Share of a frame's level below which a channel's noise is none: a finger that slides for long is as rough as that."""
AGAIN = 500
"""Time within which a fault that returns still lasts, samples."""
LARGEST_NUMBER = 2**53
"""Largest number of a sample; its time is exact below."""
_SPARE = 64 * HOP
"""Samples of the ring buffer beyond those that are needed, so that it is moved seldom."""
NEWEST = 96
"""Number of samples of :attr:`Decision.newest`."""
FADED = 0.3
"""Share of the loudest frame of a touch below which a frame holds only what is left of it."""
FADES = 20.0
"""Rate at which what may be left of a touch falls, dB/s."""
RISEN = 2.0
"""Factor by which the level must rise while a touch fades for another one."""


class TouchStream:
    """Stream of decisions from microphones, 250 samples at a time.

    Args:
        locator: names the point of a frame.
        silence: Pa rms about the mean over a frame; where no microphone is louder there is no touch. By default twice
            the noise of a microphone that the locator was made for, at least 1e-6 Pa.
        limit: Pa; a sample that reaches it is clipped. By default nothing is.
        reconstructor: gives the waveform of the named point; the filters of a point are made when it is first named,
            which takes some tens of milliseconds.
        sound_test: tells the sound of a room from touches. By default sound is taken for a touch.
        residual_test: tells what no point explains from touches. By default the likeliest point is named whatever it
            is. On a sensor that differs from its library by a percent it refuses most touches.
        refused: share of the frames of true touches that the residual test may refuse, above 0, below 1.
        listening: what is done with samples first, see :mod:`localize.live.front_end`.
        spare: makes what goes on without microphones that are dead, clipped or hiss where two or more are left, which
            takes up to seconds, once for each set of them; by default their frames are unreadable.

    Raises:
        Refusal: a threshold that is not finite and positive; a reconstructor or a test for other microphones; a
            share out of range.
    """

    def __init__(
        self,
        locator: StreamLocator,
        silence: float | None = None,
        limit: float | None = None,
        reconstructor: Reconstructor | None = None,
        sound_test: SoundTest | None = None,
        residual_test: ResidualTest | None = None,
        refused: float = REFUSED,
        listening: Listening | None = None,
        spare: Spare | None = None,
    ) -> None:
        for name, part in (
            ("reconstructor", reconstructor), ("sound_test", sound_test), ("residual_test", residual_test)
        ):  # fmt: skip
            if part is not None and part.microphones != tuple(locator.microphones):
                raise Refusal(
                    f"{name} is for microphones {', '.join(part.microphones)}, the locator for "
                    f"{', '.join(locator.microphones)}"
                )
        if not 0 < refused < 1:
            raise Refusal(f"refused = {refused} must be between 0 and 1, both excluded")
        self.sound_test, self.residual_test, self.refused = sound_test, residual_test, refused
        self.locator = locator
        self.reconstructor = reconstructor
        self.silence = max(SILENCE * locator.noise_rms, LEAST_SILENCE) if silence is None else silence
        self.limit = limit
        for name, value in (("silence", self.silence), ("limit", limit)):
            if value is not None and not 0 < value < np.inf:
                raise Refusal(f"{name} = {value} Pa must be finite and above 0")
        self._microphones = tuple(locator.microphones)
        self._judges = Judges(locator, sound_test, residual_test)
        self._judges_of = JudgesOfTheRest(self._microphones, spare)
        self.listening = listening or Listening()
        channels = len(self._microphones)
        self._high_pass = HighPass(channels, self.listening.high_pass)
        self._hum, self._floor = Hum(channels), NoiseFloor(channels)
        # An estimate needs a window, the 16 of a hop some samples more.
        self._history = max(FRAME, 0 if reconstructor is None else reconstructor.window + HOP - 1)
        # Samples as they come, and as they are judged.
        self._buffer = np.empty((2, channels, self._history + _SPARE))
        self._next: int | None = None  # number of the sample that is due
        self._repeated_to: int | None = None  # where repeated samples so far end
        self._bad: dict[tuple[FaultKind, int], int] = {}  # number of the sample up to which a reported fault was seen
        self._restart()

    @property
    def delay(self) -> float:
        """Group delay of the high-pass at 20 Hz, s."""
        return self._high_pass.delay

    @property
    def noise(self) -> NDArray[np.float64]:
        """Noise of the microphones as it is measured; (n_microphone,) float64, Pa rms, 0 before it was."""
        return self._floor.rms

    def push(self, chunk: ArrayLike, first: int | None = None) -> list[Decision | Fault]:
        """Take the next samples and say what they show.

        Args:
            chunk: (n_microphone, n), Pa, at 1 kHz, any n.
            first: number of the chunk's first sample in the stream. By default it follows the chunk before; a larger
                number means that samples are lost, a smaller one that they are repeated, and those are left out; one
                that is smaller by more than a second, that the device counts anew.

        Returns:
            Decisions and faults in the order in which they came about.

        Raises:
            Refusal: a chunk of another shape or of complex numbers, or ``first`` is no whole number from 0 to 2^53;
                nothing has been taken then.
        """
        if first is not None and (
            isinstance(first, bool) or not isinstance(first, (int, np.integer)) or not 0 <= first <= LARGEST_NUMBER
        ):
            raise Refusal(f"first = {first!r} must be a whole number from 0 to 2^53")
        if np.iscomplexobj(chunk):
            raise Refusal("chunk holds complex numbers, must hold pressures in Pa")
        samples = np.asarray(chunk, np.float64)
        if samples.ndim != 2 or len(samples) != len(self._microphones):
            raise Refusal(
                f"chunk has shape {samples.shape}, must be (n_microphone, n) = ({len(self._microphones)}, n): "
                f"{', '.join(self._microphones)}"
            )
        events: list[Decision | Fault] = []
        first = None if first is None else int(first)
        due = self._next if self._next is not None else first or 0
        lost = 0 if first is None else first - due
        if first is not None and lost < -RESTART:
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

        Decisions begin with the first whole frame, or, to tell that there is none, at once.
        """
        self._end = 0
        self._due = FRAME % HOP if tell else FRAME
        self._loudest, self._least = 0.0, np.inf  # levels: what may be left of a touch, and the least of it so far
        self._hum.reset()
        self._floor.reset()
        self._hum_coming = self._hum.coming(self._due)  # up to the next decision

    def _skip(self, run: NDArray[np.float64], good: NDArray[np.bool_], events: list[Decision | Fault]) -> None:
        """A run of samples in which the same channels hold no pressure."""
        for channel in range(len(good)):
            if not good[channel]:
                self._tell("not finite", channel, self._number + run.shape[1], events)
        self._restart(tell=True)
        self._next = self._number + run.shape[1]

    def _listen(self, run: NDArray[np.float64], events: list[Decision | Fault]) -> None:
        taken = 0
        while taken < run.shape[1]:
            count = min(self._due, run.shape[1] - taken)
            if self._end + count > self._buffer.shape[2]:
                kept = min(self._end, self._history)
                self._buffer[..., :kept] = self._buffer[..., self._end - kept : self._end]
                self._end = kept
            part = run[:, taken : taken + count]
            self._buffer[0, :, self._end : self._end + count] = part
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
                    raw, frame = self._buffer[..., self._end - FRAME : self._end]
                    self._judge(raw, frame, events)
                self._hum_coming = self._hum.coming(HOP)

    def _conditioned(self, samples: NDArray[np.float64]) -> NDArray[np.float64]:
        """Samples that follow those before, as they are judged."""
        passed = self._high_pass(samples)
        first = self._hum_coming.shape[1] - self._due
        return passed - self._hum_coming[:, first : first + samples.shape[1]]

    def _judge(self, raw: NDArray[np.float64], frame: NDArray[np.float64], events: list[Decision | Fault]) -> None:
        """Judge a frame, as it came and as it is judged."""
        good = ~self._bad_channels(raw, events)
        if self.listening.follow and (good.all() or self._judges_of(good) is not None):
            self._floor.take(frame)
            good &= ~self._channels_of_other_noise(frame, events)
        judges = self._judges if good.all() else self._judges_of(good)
        if judges is None:
            events.append(Decision(self._time, "unreadable", float(frame.std(1).max())))
            return
        self._judge_by(judges, good, frame, events)

    def _judge_by(
        self, judges: Judges, good: NDArray[np.bool_], whole: NDArray[np.float64], events: list[Decision | Fault]
    ) -> None:
        """Judge a frame by those of its channels that are good."""
        frame, noise = whole[good], self._floor.rms[good]
        kept = whole.copy() if self.listening.frames and good.all() else None
        level = float(frame.std(1).max())
        newest = float(frame[:, -NEWEST:].std(1).max())
        self._loudest *= 10 ** (-FADES / 20 * HOP / SAMPLE_RATE)
        loud = self._loudness(frame, noise)
        if loud <= 1.0:
            if self.listening.follow:
                self._hum.learn(whole[:, -HOP:])
            events.append(Decision(self._time, "no touch", level, newest=newest))
            return
        if self.listening.fade and level < min(FADED * self._loudest, RISEN * self._least):
            self._least = min(self._least, level)
            events.append(Decision(self._time, "fading", level, newest=newest, frame=kept))
            return
        beside = _beside_sound(judges, frame, noise)
        if beside is not None and beside[0] > beside[1] and self.listening.follow and loud <= WEAK:
            beside = _beside_sound(judges, self._hum.beside(frame), noise)
        if beside is not None and beside[0] <= beside[1]:
            events.append(Decision(self._time, "sound", level, newest=newest))
            return
        if level < FADED * self._loudest:  # a new one
            self._loudest = 0.0
        if level > self._loudest:
            self._loudest = self._least = level
        self._least = min(self._least, level)
        found = judges.locator.locate(frame)
        best = int(found.argmax())
        if judges.residual_test is not None and judges.residual_test.p_value(frame[None], [best])[0] < self.refused:
            events.append(Decision(self._time, "other", level, newest=newest, frame=kept))
            return
        weight = None if beside is None else math.sqrt(beside[0])
        shape = self._waveform(best) if good.all() else None
        point, sure = best + 1, float(found[best])
        events.append(Decision(self._time, "touch", level, point, sure, found, weight, newest, kept, shape))

    def _bad_channels(self, raw: NDArray[np.float64], events: list[Decision | Fault]) -> NDArray[np.bool_]:
        """Channels of a frame that are dead or clipped, (n_microphone,), which is told."""
        highest, lowest = raw.max(1), raw.min(1)
        dead = (highest == lowest) | (raw.std(1) < DEAD * self.locator.noise_rms)
        clipped = np.maximum(highest, -lowest) >= (np.inf if self.limit is None else self.limit)
        for channel in np.flatnonzero(dead | clipped).tolist():
            if dead[channel]:
                self._tell("dead channel", channel, self._number, events)
            if clipped[channel]:
                self._tell("clipped", channel, self._number, events)
        return np.asarray(dead | clipped)

    def _channels_of_other_noise(self, frame: NDArray[np.float64], events: list[Decision | Fault]) -> NDArray[np.bool_]:
        """Channels whose noise is far above that of the decoder, or missing, (n_microphone,), which is told."""
        expected = self.silence / SILENCE
        hisses = self._floor.hisses(expected) & (self._floor.rms > HISSES * frame.std(1))
        dead = self._floor.dead(expected)
        for channel in np.flatnonzero(hisses | dead).tolist():
            self._tell("hissing channel" if hisses[channel] else "dead channel", channel, self._number, events)
        return np.asarray(hisses | dead)

    def _loudness(self, frame: NDArray[np.float64], noise: NDArray[np.float64]) -> float:
        """Level of the loudest microphone over that up to which it is silent; what may be hum is left out."""
        least = np.maximum(self.silence, SILENCE * noise)
        loud = float((frame.std(1) / least).max())
        if self.listening.follow and 1.0 < loud <= WEAK:
            return float((self._hum.beside(frame).std(1) / least).max())
        return loud

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
        if seen is None or self._number - seen > AGAIN:
            events.append(Fault(self._time, kind, self._microphones[channel]))
        self._bad[kind, channel] = until

    @property
    def _number(self) -> int:
        return self._next or 0

    @property
    def _time(self) -> float:
        return self._number / SAMPLE_RATE


def _beside_sound(judges: Judges, frame: NDArray[np.float64], noise: NDArray[np.float64]) -> tuple[float, float] | None:
    """Energy that sound does not explain, and the most that it leaves; None where it is not expected."""
    if judges.sound_test is None:
        return None
    found, most = judges.sound_test.beside(frame[None], max(1.0, float(noise.max()) / judges.sound_test.noise_rms))
    return float(found[0]), float(most[0])


def _runs(good: NDArray[np.bool_], samples: NDArray[np.float64]) -> list[tuple[NDArray[np.bool_], NDArray[np.float64]]]:
    """Runs of samples over which the same channels are good: (n_microphone,) and (n_microphone, n) of each."""
    if not samples.shape[1]:
        return []
    if good.all():
        return [(good[:, 0], samples)]
    cuts = np.flatnonzero((good[:, 1:] != good[:, :-1]).any(0)) + 1
    return [(part[:, 0], run) for part, run in zip(np.split(good, cuts, 1), np.split(samples, cuts, 1), strict=True)]
