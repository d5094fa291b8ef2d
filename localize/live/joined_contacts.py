"""Contacts that belong to one touch: the release of a press, the tremor while it is held, the beats of a pulse.

A finger that presses raises the pressure, and a finger that lets go lowers it again. The high-pass of the stream leaves
two short contacts of that, with next to nothing between them. :mod:`localize.live.pressure_course` tells them apart:
the first stroke of a touch goes up, a release goes down. A contact that begins with a fall, soon after a touch that
began with a rise, is therefore the release of that touch. A small change while the pressure is still there is the
tremor of the finger. A slow and round wave at the same point, before the pressure has rested for long, is a beat.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from geometry.ground.typed import Array
from localize.live.contacts import ContactCutter
from localize.live.events import HOP, Decision
from localize.live.pressure_course import PressureCourse, Wave, first_stroke, is_round_wave
from localize.live.stream_options import TouchOptions
from localize.signals.stimulus import SAMPLE_RATE

LEAST_PROBABILITY = 1e-12
"""Least probability of a point that a frame is taken to give."""


@dataclass
class Step:
    """Next part of a touch."""

    kind: Literal["begins", "goes on", "beat", "rests", "ends"]
    """``begins``: the first frames of a touch. ``goes on``: more of it. ``beat``: the first frames of its next beat.
    ``rests``: a contact of it is over, the touch may not be. ``ends``: it is over."""
    frames: list[Decision] = field(default_factory=list)
    """Frames of the touch that no step before has had."""
    is_new_contact: bool = False
    """True if the frames are the first ones of a contact."""
    last: float = 0.0
    """Time at which the touch was there last, s; of an end."""


class _OpenTouch:
    """Last touch of a stream, to which contacts may belong.

    Args:
        begin: time of its first frame, s.
        wave: its pressure so far.
    """

    def __init__(self, begin: float, wave: Wave) -> None:
        self.begin = self.beat = self.last = begin
        self.wave = wave
        self.level = 0.0
        self.is_first_contact, self.has_ended = True, False
        self.was_quiet = False
        """True if all microphones were quiet since."""
        self.goes_up = False
        """True if it began with a rise of the pressure; if not, or if that is not known, no contact belongs to it."""
        self.is_round: bool | None = None
        """True if it began as a beat does; None before that is known."""
        self._score: Array = np.zeros(1)

    def take(self, frames: list[Decision]) -> None:
        """Take frames of the touch."""
        for each in frames:
            self.level = max(self.level, each.level)
            self._score = self._score + each.level * log_probability_of(each)
        self.last = frames[-1].time
        self.was_quiet = False

    def is_at(self, frames: list[Decision], ratio: float) -> bool:
        """True if no point is likelier than that of the touch by a ratio, by the mean of frames."""
        found = np.mean([log_probability_of(each) for each in frames], axis=0)
        return bool(found.max() - found[int(self._score.argmax())] < math.log(ratio))


class TouchJoiner:
    """Joiner of contacts into touches.

    Args:
        options: how contacts join.
    """

    def __init__(self, options: TouchOptions = TouchOptions()) -> None:
        self._options = options
        self._cutter, self._course = ContactCutter(options), PressureCourse(options.remembered)
        self._touch: _OpenTouch | None = None  # the last one, which may have ended
        self._pending: list[Decision] = []  # frames of a contact of which it is not known yet what it is
        self._in_contact = False
        self._hops = 0  # since the contact began
        self._time = -math.inf

    def take(self, event: Decision) -> list[Step]:
        """Steps that follow from the next decision."""
        steps: list[Step] = []
        if not 0 < event.time - self._time <= self._options.longest_hold:  # a device that counts anew
            steps += [*self._settle(at_end=True), *self._end()]
            self._touch = None
        self._time = event.time
        self._course.take(event)
        found = self._cutter.take(event)
        self._hops = 1 if found == "begins" else self._hops + 1
        if found != "goes on":
            steps += self._contact_over()
        if event.state == "no touch" and self._touch is not None:
            self._touch.was_quiet = True
        if event.state == "touch":
            if found == "begins":
                self._in_contact = True
                self._pending = [event]
                steps += self._settle()
            elif self._pending:
                self._pending.append(event)
                steps += self._settle()
            else:
                steps += self._more("goes on", [event])
        self._look_at_pressure()
        if not self._in_contact and not self._stays():
            steps += self._end()
        return steps

    def finish(self) -> list[Step]:
        """Steps that are left when the stream ends."""
        return [*self._settle(at_end=True), *self._end()]

    def _look_at_pressure(self) -> None:
        """Take the newest pressure into the touch."""
        options, touch = self._options, self._touch
        if touch is None or self._pending:
            return
        touch.wave.take(self._course.newest, self._in_contact)
        if touch.is_first_contact and self._hops <= options.before:
            touch.goes_up = self._stroke(touch.level) > 0
        if touch.goes_up and not touch.is_round:
            touch.is_round = self._is_round()

    def _contact_over(self) -> list[Step]:
        steps = self._settle(at_end=True)
        if self._touch is not None:
            self._touch.is_first_contact = False
            steps += [Step("rests")] if self._in_contact and not self._touch.has_ended else []
        self._in_contact = False
        return steps

    def _stays(self) -> bool:
        """True if the touch goes on without a contact: the pressure is still there, or the next beat may come."""
        touch = self._touch
        longest = self._options.longest_hold * SAMPLE_RATE
        if touch is None or not touch.goes_up or _samples(touch.begin, self._time) > longest:
            return False
        if not touch.wave.fallen:
            touch.last = self._time
            return True
        return self._may_beat(touch, self._time)

    def _may_beat(self, touch: _OpenTouch, time: float) -> bool:
        """True if the next beat of a pulse may begin at a time."""
        since, options = _samples(touch.beat, time), self._options
        is_soon = since <= options.longest_beat * SAMPLE_RATE
        return touch.is_round is not False and is_soon and touch.wave.rests * HOP <= options.rest * since

    def _settle(self, at_end: bool = False) -> list[Step]:
        """Steps once it is known what the contact that has begun is."""
        frames = self._pending
        kind = self._kind_of(frames, at_end) if frames else None
        if kind is None:
            return []
        self._pending = []
        steps: list[Step] = []
        if kind == "begins":
            steps += self._end()
            self._touch = _OpenTouch(frames[0].time, self._wave())
        elif kind == "beat" and self._touch is not None:
            self._touch.beat = frames[0].time
            self._touch.wave = self._wave()
        return [*steps, *self._more(kind, frames, is_new_contact=True)]

    def _kind_of(self, frames: list[Decision], at_end: bool) -> Literal["begins", "goes on", "beat"] | None:
        """Kind of the contact that has begun; None where it is not known yet."""
        options, touch, first = self._options, self._touch, frames[0].time
        longest = options.longest_hold * SAMPLE_RATE
        if touch is None or not touch.goes_up or _samples(touch.begin, first) > longest:
            return "begins"
        if len(frames) < options.agree and not at_end:
            return None
        level = max(each.level for each in frames)
        stroke = self._stroke(level)
        # The level of a frame shows a release only when the pressure has fallen.
        if stroke < 0 and (touch.wave.fallen <= options.before or touch.is_at(frames, options.other_point)):
            return "goes on"  # a release
        if not stroke and not touch.was_quiet and len(self._seen()) and level < options.tail * touch.level:
            return "goes on"  # what is left of it: nothing has moved
        if touch.has_ended or stroke <= 0:
            return "begins"
        if not touch.wave.fallen and stroke < options.tremor * touch.wave.peak:
            return "goes on"
        if not touch.is_round or not self._may_beat(touch, first) or not touch.is_at(frames, options.other_point):
            return "begins"
        is_round = self._is_round()
        if is_round is None and not at_end and len(frames) < options.longest_wait:
            return None
        if is_round is False or not options.beat_level < level / touch.level < 1 / options.beat_level:
            return "begins"
        is_apart = _samples(touch.beat, first) >= options.shortest_beat * SAMPLE_RATE
        return "beat" if is_apart else "goes on"

    def _seen(self) -> Array:
        """Pressure from before the contact until now, Pa; empty where it is not known."""
        return self._course.last(self._hops + self._options.before)

    def _wave(self) -> Wave:
        return Wave(self._seen(), self._options.before, self._options.held_fraction)

    def _stroke(self, level: float) -> float:
        """Change of the pressure with which the contact of a level begins, Pa; 0 where it is not known."""
        course = self._seen()
        stroke = first_stroke(course) if len(course) else 0.0
        return stroke if abs(stroke) >= self._options.surely * level else 0.0

    def _is_round(self) -> bool | None:
        course, options = self._seen(), self._options
        return is_round_wave(course, options.before, options.slow, options.roundness) if len(course) else False

    def _more(
        self, kind: Literal["begins", "goes on", "beat"], frames: list[Decision], is_new_contact: bool = False
    ) -> list[Step]:
        if self._touch is None or self._touch.has_ended:
            return []  # the release of a touch that was over for who listens
        self._touch.take(frames)
        return [Step(kind, frames, is_new_contact)]

    def _end(self) -> list[Step]:
        if self._touch is None or self._touch.has_ended:
            return []
        self._touch.has_ended = True
        return [Step("ends", last=self._touch.last)]


def log_probability_of(event: Decision) -> Array:
    """Log-probability of every point of a frame with a touch, (n_point,) nats."""
    assert event.distribution is not None
    return np.asarray(np.log(event.distribution.clip(LEAST_PROBABILITY)))


def _samples(begin: float, end: float) -> int:
    """Samples between two times, s: whole ones, so that no decision depends on how times are rounded."""
    return round((end - begin) * SAMPLE_RATE)
