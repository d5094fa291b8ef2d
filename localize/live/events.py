"""Events of a stream: a decision for every frame, faults, the beginnings, moves and ends of touches, and gestures."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

HOP = 16
"""Number of samples from one decision to the next."""

State = Literal["touch", "no touch", "fading", "sound", "motion", "other", "unreadable"]
"""State of a frame. Fading: only the decay of a touch that has ended. Sound: sound of a room, the same on all
membranes, without a touch. Motion: the sensor itself is moved, without a touch. Other: a signal that no touch of a
single point explains. Unreadable: a channel is clipped or dead or hisses and the others cannot replace it, or a value
was not finite within the last 250 samples."""

FaultKind = Literal[
    "samples lost", "samples repeated", "restarted", "not finite", "clipped", "dead channel", "hissing channel"
]


@dataclass(frozen=True)
class Decision:
    """Decision that is made from one frame."""

    time: float
    """Time of the end of the frame, s; the stream's sample 0 is at 0."""
    state: State
    """State that the frame shows."""
    level: float
    """Level of the loudest microphone about its mean, Pa rms."""
    point: int | None = None
    """Most probable point, from 1; None unless there is a touch."""
    probability: float | None = None
    """Probability of that point, 0 to 1; None unless there is a touch."""
    distribution: NDArray[np.float64] | None = field(default=None, repr=False, compare=False)
    """Probability of every point; (n_point,) float64, None unless there is a touch."""
    weight: float | None = field(default=None, repr=False, compare=False)
    """Amplitude that stands out of sound where sound is expected, by that of the noise, a ratio; None where
    it is not."""
    newest: float | None = field(default=None, repr=False, compare=False)
    """Level of the loudest microphone over the newest 96 samples, Pa rms."""
    mean_pressure: float | None = field(default=None, repr=False, compare=False)
    """Mean of the microphones over the newest 16 samples as they came, before the high-pass, Pa; None for a frame that
    is unreadable."""
    frame: NDArray[np.float64] | None = field(default=None, repr=False, compare=False)
    """Samples that were classified, (n_microphone, 250) float64, Pa; None unless they are asked for, in silence, and
    for a frame in which not all channels are good."""
    waveform: tuple[float, ...] | None = None
    """Pressure in the cavity of the point, Pa, over the newest 16 samples less the latency of the reconstructor; None
    without one, without a touch, and before its window is full."""

    def json_line(self) -> str:
        """Decision as one line of JSON, without the distribution."""
        line: dict[str, object] = {"time": round(self.time, 6), "state": self.state, "level": self.level}
        if self.state == "touch":
            line |= {"point": self.point, "probability": self.probability}
        if self.waveform is not None:
            line["waveform"] = [float(f"{value:.6g}") for value in self.waveform]
        return json.dumps(line)


@dataclass(frozen=True)
class Fault:
    """Fault of a stream, reported once when it begins."""

    time: float
    """Time of the sample where it begins, s; of clipping and dead channels, the end of the frame that showed it."""
    kind: FaultKind
    """Kind of the fault."""
    channel: str | None = None
    """Name of the microphone; None where it is all of them."""
    samples: int | None = None
    """Number of samples that were lost, or repeated in this chunk; None for other faults."""

    def json_line(self) -> str:
        """Fault as one line of JSON."""
        line: dict[str, object] = {"time": round(self.time, 6), "fault": self.kind}
        line |= {} if self.channel is None else {"channel": self.channel}
        line |= {} if self.samples is None else {"samples": self.samples}
        return json.dumps(line)


@dataclass(frozen=True)
class TouchEvent:
    """Beginning, move, beat or end of a touch, reported while it happens."""

    time: float
    """Time at which it is reported: the end of the frame that decided it, s."""
    kind: Literal["down", "moved", "beat", "up"]
    """Kind of what happened."""
    touch: int
    """Number of the touch, from 1, as touches come down."""
    point: int
    """Point that is touched from now on, or was until now, from 1."""
    probability: float
    """Probability of that point by all frames so far."""
    level: float
    """Level of the loudest microphone in the newest frame of the touch, Pa rms."""
    latency: float
    """Longest time from the event to its report, s: the frames that were waited for, and the delay of the high-pass.
    Delays of the source and the computer come on top."""

    def json_line(self) -> str:
        """Event as one line of JSON."""
        line = {"time": round(self.time, 6), "event": self.kind, "touch": self.touch, "point": self.point}
        line |= {"probability": round(self.probability, 4), "level": float(f"{self.level:.4g}")}
        line |= {"latency": round(self.latency, 5)}
        return json.dumps(line)


@dataclass(frozen=True)
class DownTouch:
    """One of several touches at once."""

    time: float
    """Time at which its stroke had risen by half, s."""
    point: int | None
    """Point, from 1; None if it is not known."""
    probability: float
    """Probability of the most probable point, 0 to 1."""


@dataclass(frozen=True)
class SeveralTouches:
    """Two or three touches within one contact, reported once the contact is long enough to be known."""

    time: float
    """Time at which it is reported, s."""
    contact: float
    """Time of the first decision of the contact, s."""
    touches: tuple[DownTouch, ...]
    """Touches, in the order of time."""
    latency: float
    """Longest time from the beginning of the contact to the report, s."""

    def json_line(self) -> str:
        """Touches as one line of JSON; a point that is not known is null."""
        touches = [
            {"down": round(each.time, 4), "point": each.point, "probability": round(each.probability, 4)}
            for each in self.touches
        ]
        line = {"time": round(self.time, 6), "event": "several", "touches": touches}
        return json.dumps(line | {"latency": round(self.latency, 5)})


@dataclass(frozen=True)
class TrackedPlace:
    """Place of a contact while it moves, reported as soon as it is known."""

    time: float
    """Time at which the contact was there, s."""
    place: tuple[float, float]
    """Middle of the contact, mm."""
    deviation: float
    """Standard deviation in each direction, mm."""
    latency: float
    """Time from then to the end of the frame that gave it, s."""

    def json_line(self) -> str:
        """Place as one line of JSON."""
        x, y = (round(value, 3) for value in self.place)
        line = {"time": round(self.time, 6), "x": x, "y": y, "deviation": round(self.deviation, 3)}
        return json.dumps(line | {"latency": round(self.latency, 5)})


@dataclass(frozen=True)
class TrackedGesture:
    """Gesture of a contact, reported when its path has ended."""

    time: float
    """Time at which it is reported, s: a second after the contact was last detected."""
    start: float
    """Time at which it began, s."""
    end: float
    """Time at which it ended, s."""
    kind: str
    """Kind, as of :class:`localize.tracking.Gesture`."""
    direction: str
    """Direction of a swipe or a circle; empty for other gestures."""
    length: float
    """Length of the path, mm; 0 of a contact that stays."""

    def json_line(self) -> str:
        """Gesture as one line of JSON."""
        line: dict[str, object] = {"time": round(self.time, 6), "gesture": self.kind}
        line |= {"direction": self.direction} if self.direction else {}
        line |= {"start": round(self.start, 4), "end": round(self.end, 4), "length": round(self.length, 2)}
        return json.dumps(line)
