"""Results of recordings: what all have in common, and the touches that were located in one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from localize.evaluation.connection_faults import ConnectionFault
from localize.live.events import HOP, Decision, Fault, SeveralTouches, State, TouchEvent
from localize.live.touches import Touch
from localize.signals.array_facts import ArrayFacts
from localize.signals.stimulus import SAMPLE_RATE


@dataclass(frozen=True, eq=False, kw_only=True)
class RecordingResult:
    """Result of a recording of an array's microphones."""

    array: ArrayFacts
    """Array whose points are named: that of the model, whatever was recorded."""
    seconds: float
    """Length of the recording, s."""
    assumptions: str
    """Assumptions of the model about the sensor or touches, in words."""

    @property
    def design(self) -> str:
        """Name of the design whose points are named."""
        return self.array.design


@dataclass(frozen=True, eq=False, kw_only=True)
class LocatedTouches(RecordingResult):
    """Touches in a recording."""

    touches: tuple[Touch, ...]
    """Touches in the order of time."""
    events: tuple[Decision | Fault | TouchEvent | SeveralTouches, ...]
    """Decisions, 16 ms apart, faults, and touches as they would have been reported while they happened."""
    warning: str | None = None
    """Reason to distrust the touches, in words: the sensor does not fit the library. None if it fits, or if there is no
    test: for a trained localizer, or fewer than eight touches."""
    fault: ConnectionFault | None = None
    """Fault in how the microphones are connected, which explains the misfit; None if none was found."""
    corrected: bool = False
    """True if the fault was corrected before touches were located."""
    trust: float = 1.0
    """Weight of the decoder's probabilities against those of chance, 0 to 1, by which the probabilities of decisions
    and touches were lowered; 1 if the sensor fits the library, or if there is no test."""
    options: Mapping[str, Any] = field(default_factory=dict, repr=False)
    """Options of the decoder, the tests, the stream and the touches, by name."""

    @property
    def seconds_by_state(self) -> dict[State, float]:
        """Time of the decisions in each state that occurred, s."""
        states = Counter(event.state for event in self.events if isinstance(event, Decision))
        return {state: count * HOP / SAMPLE_RATE for state, count in states.items()}

    @property
    def several(self) -> tuple[SeveralTouches, ...]:
        """Contacts of several touches at once, in the order of time; empty if these are not looked for."""
        return tuple(event for event in self.events if isinstance(event, SeveralTouches))

    @property
    def first_faults(self) -> tuple[Fault, ...]:
        """Faults of the recording: the first of each kind at each microphone."""
        first: dict[tuple[str, str | None], Fault] = {}
        for event in self.events:
            if isinstance(event, Fault):
                first.setdefault((event.kind, event.channel), event)
        return tuple(first.values())


def distrusted_touch(touch: Touch, trust: float, array: ArrayFacts) -> Touch:
    """Touch whose probability is mixed with that of chance.

    Args:
        touch: as the decoder has it.
        trust: weight of its probability, 0 to 1.
        array: array whose points are equally likely by chance.
    """
    chance = (1.0 - trust) / len(array.line)
    return touch if trust == 1.0 else replace(touch, probability=trust * touch.probability + chance)


def with_several(touches: Sequence[Touch], several: Sequence[SeveralTouches]) -> list[Touch]:
    """Touches in which those of a contact of several are replaced by its own, as far as their points are known.

    Args:
        touches: one at a time, as the decisions of a stream join.
        several: contacts of several touches.
    """
    found = list(touches)
    for each in several:
        of_contact = [touch for touch in found if each.contact <= touch.start <= each.time]
        if not of_contact:
            continue
        longest = max(of_contact, key=lambda touch: touch.end)
        level = max(touch.level for touch in of_contact)
        found = [touch for touch in found if touch not in of_contact]
        for down in each.touches:
            if down.point is not None:
                start = each.contact + down.time - each.touches[0].time
                found.append(Touch(start, max(longest.end, start), down.point, down.probability, level))
    return sorted(found, key=lambda touch: touch.start)


def distrusted_event(
    event: Decision | Fault | TouchEvent | SeveralTouches, trust: float, array: ArrayFacts
) -> Decision | Fault | TouchEvent | SeveralTouches:
    """Event whose probabilities are mixed with those of chance; one without a probability stays as it is.

    Args:
        event: of a stream or a tracker.
        trust: weight of its probabilities, 0 to 1.
        array: array whose points are equally likely by chance.
    """
    if trust == 1.0 or isinstance(event, Fault):
        return event
    if isinstance(event, SeveralTouches):
        each = 1.0 / len(array.line)
        lowered = (replace(one, probability=trust * one.probability + (1 - trust) * each) for one in event.touches)
        return replace(event, touches=tuple(lowered))
    if event.probability is None:
        return event
    chance = (1.0 - trust) / len(array.line)
    probability = trust * event.probability + chance
    if isinstance(event, TouchEvent) or event.distribution is None:
        return replace(event, probability=probability)
    return replace(event, probability=probability, distribution=trust * event.distribution + chance)
