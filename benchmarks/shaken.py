"""A sensor that is waved or stands on a table that is knocked on: ``python -m benchmarks.shaken`` prints two tables.

Sensors are virtual rigs: their parts, rubber, microphones and air deviate from the design, and their recordings hold
noise, hum and drift. The decoder is that of the library of the design. The first table counts the touches that a stream
reports although nobody touches. The second has taps and presses while the hand is waved, one every 1.5 s, at points in
turn: those that are found, and those at the right point.
"""

from __future__ import annotations

import argparse
import warnings
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

import acoustic_fem
import geometry
import localize
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry.ground.typed import Array
from localize.contacts import Contact, ContactRecorder
from localize.contacts.contact import surface_of
from localize.live.events import Decision
from localize.live.touches import touches_of
from localize.signals.array_response import UncoveredWarning
from localize.signals.motion import KNOCKED, WAVED
from studies.test_rig.rig_contacts import made_response
from studies.test_rig.rig_motion import motion_of_rig, table_knocks, waved_hand
from studies.test_rig.virtual_rig import Recorder, Rig

DESIGNS = ("array-2x6", "line-2", "fingertip-3x4")
FIRST, SENSORS, SECONDS = 9700, 4, 60.0
FORCES = (0.3e-3, 1e-3, 3e-3, 10e-3)
"""Peaks of the forces of touches, N."""
APART, TOLERANCE = 1.5, 0.15
"""Time from a touch to the next, and within which a reported touch is of it, s."""
FREQUENCY = np.concatenate([[0.5], np.arange(1.0, 501.0)])
RECORDER = Recorder(output="pressure")


@dataclass(frozen=True, eq=False)
class Shaken:
    """Touches that a stream reports of a recording."""

    touches: tuple[localize.Touch, ...]
    """Touches."""
    moved: float
    """Fraction of the decisions whose state is ``motion``."""


def decoded(library: acoustic_fem.Library, signals: Array, motion: float | None) -> Shaken:
    """Touches in signals, (n_microphone, n_sample) Pa, decoded with the library of the design.

    Args:
        library: of the design.
        signals: of the microphones.
        motion: as of :func:`localize.open_model`, m/s^2.
    """
    model = localize.open_model(library, motion=motion)
    events = model.stream().push(signals)
    states = [each.state for each in events if isinstance(each, Decision)]
    return Shaken(tuple(touches_of(events, model.locator)), states.count("motion") / len(states))


def motions(rig: Rig, seconds: float) -> Iterator[tuple[str, float, Array]]:
    """Names, largest accelerations (m/s^2) and accelerations, (3, n_sample) m/s^2, of a rig."""
    for name, largest, made in (("waved", WAVED, waved_hand), ("knocked", KNOCKED, table_knocks)):
        yield name, largest, made(seconds, np.random.default_rng([rig.seed, 21]), largest)


def recorded(rig: Rig, pressures: Array, number: int = 0) -> Array:
    """Signals of pressures at the microphones of a rig, with noise, hum and drift, (n_microphone, n_sample) Pa."""
    padded = np.pad(pressures, ((0, 0), (0, 2000)))
    random = np.random.default_rng([rig.seed, 22, number])
    return rig.recorded({}, padded.shape[1], 0, pressures.shape[1], RECORDER, random, padded)[1:]


def pressed(rig: Rig, force: float, seconds: float, kind: str) -> tuple[Array, Array, Array]:
    """Pressures of touches at points in turn, (n_microphone, n_sample) Pa, their times (s) and points from 1."""
    response = made_response(rig)
    place, radius = surface_of(response)
    random = np.random.default_rng([rig.seed, 23, kind == "press"])
    time = np.arange(round(seconds * 1000)) / 1000
    begin = np.arange(1.0, seconds - APART, APART)
    points = np.resize(random.permutation(len(place)), len(begin))
    total = np.zeros(len(time))
    where = np.zeros((len(time), 2))
    for at, point in zip(begin, points, strict=True):
        length = random.uniform(0.02, 0.06) if kind == "tap" else random.uniform(0.3, 0.6)
        rise = length / 2 if kind == "tap" else random.uniform(0.05, 0.1)
        ramp = np.clip(np.minimum((time - at) / rise, (at + length - time) / rise), 0.0, 1.0)
        total += force * np.sin(np.pi / 2 * ramp) ** 2
        where[(time >= at - 0.2) & (time < at + APART - 0.2)] = place[point]
    contact = Contact(time, where, total, float(radius.min()) / 4)
    made = ContactRecorder(response, microphone_noise=0.0, linear=True).take(contact).signals
    return made[:, : len(time)], begin, points + 1


def found(touches: tuple[localize.Touch, ...], begin: Array, points: Array) -> tuple[int, int, int]:
    """Number of touches that are found, that are found at their point, and that are none."""
    near = [[each for each in touches if -0.05 <= each.start - at <= TOLERANCE] for at in begin]
    there = sum(bool(each) for each in near)
    right = sum(any(one.point == point for one in each) for each, point in zip(near, points, strict=True))
    return there, right, len(touches) - sum(len(each) for each in near)


def main() -> None:
    """Print both tables."""
    for told_elsewhere in (ModelLimitWarning, UncoveredWarning):
        warnings.simplefilter("ignore", told_elsewhere)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("designs", nargs="*", default=DESIGNS)
    parser.add_argument("--sensors", type=int, default=SENSORS)
    parser.add_argument("--seconds", type=float, default=SECONDS)
    given = parser.parse_args()
    libraries = {name: acoustic_fem.solve(geometry.prototype(name), FREQUENCY, "lumped") for name in given.designs}
    print(
        "| design | motion | still (Pa) | false touches a minute, not configured | configured | frames of motion (%) |"
    )
    print("|---" * 6 + "|")
    for name, library in libraries.items():
        rigs = [Rig(name, FIRST + k, fidelity="lumped") for k in range(given.sensors)]
        for number, kind in enumerate(("waved", "knocked")):
            each = []
            for rig in rigs:
                _, largest, moved = list(motions(rig, given.seconds))[number]
                signals = recorded(rig, motion_of_rig(rig, moved))
                without, with_it = (decoded(library, signals, motion) for motion in (None, largest))
                each.append((signals.std(), len(without.touches), len(with_it.touches), 100 * with_it.moved))
            row = np.mean(each, axis=0)
            minute = 60 / given.seconds
            print(
                f"| `{name}` | {kind} | {row[0]:.2f} | {minute * row[1]:.1f} | {minute * row[2]:.1f} | {row[3]:.0f} |"
            )
    print("\n| design | touch | force (mN) | still, found / right (%) | waved, not configured | waved, configured |")
    print("|---" * 6 + "|")
    for name, library in libraries.items():
        rigs = [Rig(name, FIRST + k, fidelity="lumped") for k in range(given.sensors)]
        for kind in ("tap", "press"):
            for force in FORCES:
                cells = []
                for waved, motion in ((False, None), (True, None), (True, WAVED)):
                    counts = np.zeros(4)
                    for rig in rigs:
                        pressures, begin, points = pressed(rig, force, given.seconds, kind)
                        if waved:
                            moved = waved_hand(given.seconds, np.random.default_rng([rig.seed, 21]))
                            pressures = pressures + motion_of_rig(rig, moved)
                        result = decoded(library, recorded(rig, pressures, 1), motion)
                        counts += (*found(result.touches, begin, points), len(begin))
                    there, right, false, count = counts
                    cells.append(f"{100 * there / count:.0f} / {100 * right / count:.0f}; {false:.0f} false")
                print(f"| `{name}` | {kind} | {1e3 * force:g} | {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
