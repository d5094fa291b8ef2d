"""Gestures by rule, from the path of a contact: taps, double taps and holds of one that stays, swipes and circles of
one that moves.

A contact that is held quite still is not detected. A contact that stays is classified by its signals as it comes down,
while a hand holds it, and as it goes: each tap of two begins with a force that rises.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from geometry.ground.typed import Array
from localize.live.events import Decision, TrackedGesture, TrackedPlace
from localize.tracking.path import PathTracker, Track
from localize.tracking.smoothing import HOP_TIME
from localize.tracking.tracking_options import GestureOptions

Kind = Literal["tap", "double tap", "hold", "swipe", "circle", "stroke"]

DIRECTIONS = ("right", "up", "left", "down")
"""Directions of swipes, from that of x on anticlockwise; up is that of y."""


@dataclass(frozen=True)
class Gesture:
    """Gesture of a contact."""

    start: float
    """Time at which it began, s."""
    end: float
    """Time at which it ended, s."""
    kind: Kind
    """Kind of gesture; a stroke is a path that is neither straight nor a circle."""
    direction: str = ""
    """Direction of a swipe: right, up, left or down in plan; of a circle: clockwise or anticlockwise; else empty."""
    length: float = 0.0
    """Length of the path, mm; 0 of a contact that stays."""


def gesture_of(track: Track, options: GestureOptions = GestureOptions()) -> Gesture:
    """Gesture of a path, by the rules of the options."""
    start, end = float(track.time[0]), float(track.time[-1])
    heard = track.place[track.detected]
    if np.linalg.norm(heard - heard[0], axis=1).max() < options.still * track.pitch:
        return Gesture(start, end, _staying(track, options))
    steps = np.diff(track.place, axis=0)
    length = float(np.linalg.norm(steps, axis=1).sum())
    way = track.place[-1] - track.place[0]
    straight = float(np.linalg.norm(way))
    if straight > 0 and _aside(heard, track.place[0], way / straight) < options.aside * straight:
        quarter = round(float(np.degrees(np.arctan2(way[1], way[0]))) / 90) % 4
        return Gesture(start, end, "swipe", DIRECTIONS[quarter], length)
    turned = _turned(track.place)
    if abs(turned) >= options.turned and straight < options.closed * float(np.ptp(track.place, axis=0).max()):
        return Gesture(start, end, "circle", "anticlockwise" if turned > 0 else "clockwise", length)
    return Gesture(start, end, "stroke", "", length)


class GestureTracker:
    """Tracker of places that tells what a contact did, too, as soon as its path has ended.

    Args:
        places: tracker of the paths; new.
        options: numbers that tell gestures apart.
    """

    def __init__(self, places: PathTracker, options: GestureOptions = GestureOptions()) -> None:
        self._places, self.options = places, options
        self._reported = 0
        self._time = 0.0

    def take(self, event: object) -> list[TrackedPlace | TrackedGesture]:
        """Take the next event of a stream and say where the contact is, and what the one that has ended did."""
        if isinstance(event, Decision):
            self._time = event.time
        return [*self._places.take(event), *self._ended()]

    def finish(self) -> list[TrackedPlace | TrackedGesture]:
        """End the path that the stream ends in, and say what the contact did."""
        return [*self._places.finish(), *self._ended()]

    def _ended(self) -> list[TrackedGesture]:
        new = [gesture_of(track, self.options) for track in self._places.tracks[self._reported :]]
        self._reported += len(new)
        return [
            TrackedGesture(self._time, each.start, each.end, each.kind, each.direction, each.length) for each in new
        ]


def _aside(place: Array, start: Array, way: Array) -> float:
    """Largest distance of places from the piece of a line that begins at one and goes on along a unit vector, mm."""
    from_start = place - start
    along = np.clip(from_start @ way, 0.0, None)
    return float(np.linalg.norm(from_start - along[:, None] * way, axis=1).max())


def _staying(track: Track, options: GestureOptions) -> Literal["tap", "double tap", "hold"]:
    """Gesture of a contact that stays, by the force that is detected."""
    force = np.nan_to_num(track.force)
    loud = np.abs(force) > options.quiet * np.abs(force).max()
    edges = np.flatnonzero(np.diff(np.concatenate([[False], loud, [False]]).astype(int)))
    bursts = [slice(a, b) for a, b in zip(edges[::2], edges[1::2], strict=True)]
    if (bursts[-1].start - bursts[0].start) * HOP_TIME > options.apart[1]:
        return "hold"
    rises = [burst for burst in bursts if _begins_up(force[burst])]
    apart = np.diff([burst.start for burst in rises]) * HOP_TIME
    return "double tap" if (apart >= options.apart[0]).any() else "tap"


def _begins_up(force: Array) -> bool:
    """True if the first large value of a burst is that of a force that rises."""
    return bool(force[np.abs(force) > 0.5 * np.abs(force).max()][0] > 0)


def _turned(place: Array) -> float:
    """Angle by which a path turns about its middle, degrees, anticlockwise."""
    about = place - (place.max(0) + place.min(0)) / 2
    angle = np.unwrap(np.arctan2(about[:, 1], about[:, 0]))
    return float(np.degrees(angle[-1] - angle[0]))
