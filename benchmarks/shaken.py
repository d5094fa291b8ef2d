"""A sensor that is waved or stands on a table that is knocked on: ``python -m benchmarks.shaken --write``.

Sensors are virtual rigs: their parts, rubber, microphones and air deviate from the design, and their recordings hold
noise, hum and drift. The decoder is that of the library of the design, and so is the part of the motion that is taken
out by an accelerometer; of a knock, only up to 160 Hz, as far as the rigs record it. The first table counts the touches
that a stream reports although nobody touches. The second has taps and presses while the hand is waved, one every 1.5 s,
at points in turn: those that are reported, those at the right point, and other reports. Six minutes of one core.
"""

from __future__ import annotations

import argparse
import warnings
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import geometry
import localize
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry.ground.typed import Array
from geometry.ground.whole_files import replace_section
from localize.contacts import Contact, ContactRecorder
from localize.contacts.contact import surface_of
from localize.live.touches import touches_of
from localize.signals.array_response import UncoveredWarning
from localize.signals.motion import KNOCKED, WAVED, without_motion
from studies.test_rig.rig_contacts import made_response
from studies.test_rig.rig_motion import motion_of_rig, table_knocks, waved_hand
from studies.test_rig.virtual_rig import HEARD, Recorder, Rig

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "streams.md"
BEGIN, END = "<!-- shaken: made by benchmarks/shaken.py -->", "<!-- end of shaken -->"
DESIGNS = ("array-2x6", "line-2")
FIRST, SENSORS, SECONDS = 9800, 2, 16.0
FORCES = (0.3e-3, 3e-3)
"""Peaks of the forces of touches, N."""
APART, TOLERANCE = 1.5, 0.15
"""Time from a touch to the next, and within which a reported touch is of it, s."""
FREQUENCY = np.concatenate([[0.5], np.arange(1.0, 501.0)])
RECORDER = Recorder(output="pressure")


def decoded(model: localize.Model, signals: Array) -> tuple[localize.Touch, ...]:
    """Touches that a stream reports of signals, (n_microphone, n_sample) Pa."""
    return tuple(touches_of(model.stream().push(signals), model.locator))


def motions(rig: Rig, seconds: float) -> Iterator[tuple[str, float, Array]]:
    """Names, largest accelerations (m/s^2) and accelerations, (3, n_sample) m/s^2, of a rig."""
    for name, largest, made in (("waved", WAVED, waved_hand), ("knocked", KNOCKED, table_knocks)):
        yield name, largest, made(seconds, np.random.default_rng([rig.seed, 21]), largest)


def recorded(rig: Rig, pressures: Array, number: int = 0) -> Array:
    """Signals of pressures at the microphones of a rig, with noise, hum and drift, (n_microphone, n_sample) Pa."""
    padded = np.pad(pressures, ((0, 0), (0, 2000)))
    random = np.random.default_rng([rig.seed, 22, number])
    return rig.recorded({}, padded.shape[1], 0, pressures.shape[1], RECORDER, random, padded)[1:]


def pressed(rig: Rig, force: float, seconds: float, kind: str) -> tuple[Array, Array, NDArray[np.int64]]:
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


def found(touches: tuple[localize.Touch, ...], begin: Array, points: NDArray[np.int64]) -> tuple[int, int, int]:
    """Number of touches that are found, that are found at their point, and that are none."""
    near = [[each for each in touches if -0.05 <= each.start - at <= TOLERANCE] for at in begin]
    there = sum(bool(each) for each in near)
    right = sum(any(one.point == point for one in each) for each, point in zip(near, points, strict=True))
    return there, right, len(touches) - sum(len(each) for each in near)


def false_touches(name: str, library: Library, rigs: list[Rig], seconds: float) -> Iterator[str]:
    """Rows of touches that are reported although nobody touches."""
    still = localize.open_model(library)
    felt = acoustic_fem.solve(library.design, FREQUENCY[HEARD[1] >= FREQUENCY], "lumped")
    for number, (kind, largest) in enumerate((("waved", WAVED), ("knocked", KNOCKED))):
        aware, counts, levels = localize.open_model(library, motion=largest), list[list[int]](), list[float]()
        for rig in rigs:
            _, _, moved = list(motions(rig, seconds))[number]
            signals = recorded(rig, motion_of_rig(rig, moved))
            left = without_motion(felt, signals, moved)
            pairs = ((still, signals), (aware, signals), (still, left))
            counts.append([len(decoded(model, each)) for model, each in pairs])
            levels += [float(signals.std()), float(left.std())]
        rate = 60 / seconds * np.mean(counts, axis=0)
        before, after = np.mean(np.reshape(levels, (-1, 2)), axis=0)
        yield (
            f"| `{name}` | {kind} | {1e3 * before:.0f} / {1e3 * after:.0f} | "
            f"{' | '.join(f'{each:.1f}' for each in rate)} |"
        )


def found_touches(name: str, library: Library, rigs: list[Rig], seconds: float) -> Iterator[str]:
    """Rows of touches of a sensor that lies still, and of one that is waved."""
    still, aware = localize.open_model(library), localize.open_model(library, motion=WAVED)
    for kind in ("tap", "press"):
        for force in FORCES:
            counts = np.zeros((4, 4))
            for rig in rigs:
                pressures, begin, points = pressed(rig, force, seconds, kind)
                moved = waved_hand(seconds, np.random.default_rng([rig.seed, 21]))
                quiet = recorded(rig, pressures, 1)
                waved = recorded(rig, pressures + motion_of_rig(rig, moved), 1)
                left = without_motion(library, waved, moved)
                for count, model, each in zip(
                    counts, (still, still, aware, still), (quiet, waved, waved, left), strict=True
                ):
                    count += (*found(decoded(model, each), begin, points), len(begin))
            cells = (f"{100 * a / n:.0f} / {100 * b / n:.0f}; {c:.0f}" for a, b, c, n in counts)
            yield f"| `{name}` | {kind} | {1e3 * force:g} | {' | '.join(cells)} |"


def tables(designs: Sequence[str], sensors: int, seconds: float) -> Iterator[str]:
    """Lines of both tables."""
    libraries = {name: acoustic_fem.solve(geometry.prototype(name), FREQUENCY, "lumped") for name in designs}
    rigs = {name: [Rig(name, FIRST + k, fidelity="lumped") for k in range(sensors)] for name in designs}
    signals = "signals, before / after `--acceleration` (mPa rms)"
    yield f"| design | motion | {signals} | not configured | `--motion` | `--acceleration` |"
    yield "|---" * 6 + "|"
    for name, library in libraries.items():
        yield from false_touches(name, library, rigs[name], seconds)
    yield ""
    yield "| design | touch | force (mN) | still | waved, not configured | `--motion` | `--acceleration` |"
    yield "|---" * 7 + "|"
    for name, library in libraries.items():
        yield from found_touches(name, library, rigs[name], seconds)


def main() -> None:
    """Print both tables, and write them to the page."""
    for repeated in (ModelLimitWarning, UncoveredWarning):  # by every rig
        warnings.simplefilter("once", repeated)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("designs", nargs="*", default=DESIGNS)
    parser.add_argument("--sensors", type=int, default=SENSORS)
    parser.add_argument("--seconds", type=float, default=SECONDS)
    parser.add_argument("--write", action="store_true", help="replace the tables of the page")
    given = parser.parse_args()
    lines = []
    for line in tables(given.designs, given.sensors, given.seconds):
        print(line, flush=True)
        lines.append(line)
    if given.write:
        replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
