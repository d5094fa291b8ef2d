"""Results of recordings: what all have in common, and the touches that were located in one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from localize.evaluation.connection_faults import ConnectionFault
from localize.live.events import HOP, Decision, Fault, State, TouchEvent
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
    events: tuple[Decision | Fault | TouchEvent, ...]
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


def distrusted_event(
    event: Decision | Fault | TouchEvent, trust: float, array: ArrayFacts
) -> Decision | Fault | TouchEvent:
    """Event whose probabilities are mixed with those of chance; one without a probability stays as it is.

    Args:
        event: of a stream or a tracker.
        trust: weight of its probabilities, 0 to 1.
        array: array whose points are equally likely by chance.
    """
    if trust == 1.0 or isinstance(event, Fault) or event.probability is None:
        return event
    chance = (1.0 - trust) / len(array.line)
    probability = trust * event.probability + chance
    if isinstance(event, TouchEvent) or event.distribution is None:
        return replace(event, probability=probability)
    return replace(event, probability=probability, distribution=trust * event.distribution + chance)
