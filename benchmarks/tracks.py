"""Errors of the path of a writing finger: large-area-64, by speed, on the nominal sensor and on as-built ones.

``python benchmarks/tracks.py`` writes the tables of docs/evidence/moving-touches.md and the picture of docs/tracks.md,
in about a quarter of an hour. ``paths``, ``places`` or ``between`` makes only one of them. No constant was chosen on
these seeds. Constants were chosen on 100 to 104, and on 9100 to 9103 for places.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import scipy.stats
from made_sensors import calibrated, made_sensors
from numpy.typing import NDArray

import acoustic_fem
import geometry
import localize
from geometry.ground.whole_files import replace_section
from localize.contacts import Contact, ContactRecorder, Tool, covered_force, stroke, tap
from localize.signals import response_of
from localize.signals.array_response import ArrayResponse
from studies.inference.tracked import draw_paths

Array = NDArray[np.float64]

DOCS = Path(__file__).parents[1] / "docs"
BEGIN, END = "<!-- tracks: made by benchmarks/tracks.py -->", "<!-- end tracks -->"
PLACES_BEGIN, PLACES_END = "<!-- places: made by benchmarks/tracks.py -->", "<!-- end places -->"
BETWEEN_BEGIN, BETWEEN_END = "<!-- between: made by benchmarks/tracks.py -->", "<!-- end between -->"
DESIGN = "large-area-64"
SEED, STROKES, SECONDS, SENSORS = 7500, 9, 5.0, range(7500, 7503)
NOISE, ROOM = 1e-3, 70.0
SPEEDS = ((25.0, 60.0), (60.0, 120.0), (150.0, 200.0))
#: mm; a finger that writes presses with more of its pad than one that taps.
FINGER = Tool("finger", (5.0, 8.0), (2e-3, 2e-2), (0.05, 0.3), 0.15)
#: Root mean square of the curvature of a path, 1/mm, and the time over which it changes, s.
CURVATURE, BEND_TIME = 0.025, 0.3
TAPS = 40
#: Places along the line from a point to the next that are told apart, in two rounds.
ALONG = np.linspace(0, 1, 41)


def written(random: np.random.Generator, speed: tuple[float, float], box: tuple[Array, Array], number: int) -> Contact:
    """A finger that writes within a box: its curvature and its speed wander."""
    low, high = box
    place, heading, bend = random.uniform(low, high), random.uniform(0, 2 * np.pi), 0.0
    wanted = now = random.uniform(*speed)
    places, speeds = [place], []
    for k in range(round(SECONDS / 0.02)):
        if k % 10 == 0:
            wanted = random.uniform(*speed)
        now += (wanted - now) * 0.2
        bend += -bend * 0.02 / BEND_TIME + CURVATURE * np.sqrt(2 * 0.02 / BEND_TIME) * random.standard_normal()
        heading += bend * now * 0.02
        place = place + now * 0.02 * np.array([np.cos(heading), np.sin(heading)])
        for axis in (0, 1):
            if not low[axis] <= place[axis] <= high[axis]:
                place[axis] = np.clip(place[axis], low[axis], high[axis])
                heading = np.pi - heading if axis == 0 else -heading
        places.append(place)
        speeds.append(max(float(np.linalg.norm(places[-1] - places[-2])) / 0.02, 1.0))
    return stroke(np.array(places), np.array(speeds), FINGER, seed=SEED, sample=number)


def errors(
    library: ArrayResponse, sensor: ArrayResponse, contact: Contact, number: int, ambient: float | None
) -> tuple[Array, NDArray[np.bool_], Array]:
    """Errors of the frames of a stroke in pitches, whether a membrane is touched, and errors over what is said."""
    take = ContactRecorder(sensor, microphone_noise=NOISE, ambient=ambient, seed=SEED).take(contact, number)
    off, touched, said = [], [], []
    for path in localize.track(library, take.signals, microphone_noise=NOISE, ambient=ambient):
        true = np.column_stack([np.interp(path.time, take.time, along) for along in take.path.T])
        error = np.linalg.norm(path.place - true, axis=1)
        off.append(error / path.pitch)
        touched.append(covered_force(contact.at(path.time + contact.time[0]), sensor).sum(1) > 0)
        said.append(error / path.deviation)
    if not off:
        return np.full(1, np.inf), np.ones(1, bool), np.full(1, np.inf)
    return np.concatenate(off), np.concatenate(touched), np.concatenate(said)


def cell(strokes: Sequence[tuple[Array, NDArray[np.bool_], Array]]) -> str:
    """Frames within a pitch: of all and of those that touch a membrane, with 95 % intervals of their mean over strokes
    (Student's); median error.
    """
    parts = []
    for touching in (False, True):
        each = np.array([100 * (off[touched | (not touching)] < 1).mean() for off, touched, _ in strokes])
        wide = scipy.stats.t.ppf(0.975, len(each) - 1) * each.std(ddof=1) / np.sqrt(len(each))
        parts.append(f"{each.mean():.1f} ± {wide:.1f}")
    off = np.concatenate([each for each, _, _ in strokes])
    said = np.concatenate([each for _, _, each in strokes])
    return f"{' / '.join(parts)} / {np.median(off):.2f} / {100 * (said < 2.45).mean():.0f}"


def paths() -> list[str]:
    """Rows of the table of paths."""
    library = response_of(acoustic_fem.solve(geometry.prototype(DESIGN), np.arange(0.5, 250.1, 0.5), "lumped"))
    assert library.position is not None
    box = (library.position.min(0), library.position.max(0))
    made = made_sensors(library, DESIGN, SENSORS)
    conditions = {
        "nominal": (None, (library,), (library,)),
        "nominal, sound of 70 dB SPL, `ambient` given": (ROOM, (library,), (library,)),
        "as-built, nominal library": (None, (library,), made),
        "as-built, their own transfer functions": (None, made, made),
        "as-built, calibrated from recordings": (None, calibrated(DESIGN, SENSORS), made),
    }
    lines = [
        "| sensor | " + " | ".join(f"{low:.0f} to {high:.0f} mm/s" for low, high in SPEEDS) + " |",
        "|---|" + "---|" * len(SPEEDS),
    ]
    for name, (ambient, libraries, sensors) in conditions.items():
        cells = []
        for fast, speed in enumerate(SPEEDS):
            found = []
            for number in range(STROKES):
                contact = written(np.random.default_rng(SEED + 100 * fast + number), speed, box, 10 * fast + number)
                known, sensor = (each[number % len(each)] for each in (libraries, sensors))
                found.append(errors(known, sensor, contact, number, ambient))
            cells.append(cell(found))
            print(name, speed, cells[-1], flush=True)
        lines.append(f"| {name} | {' | '.join(cells)} |")
    contact = written(np.random.default_rng(SEED + 1), SPEEDS[1], box, 1)
    take = ContactRecorder(library, microphone_noise=NOISE, seed=SEED).take(contact, 1)
    draw_paths(
        tuple(localize.track(library, take.signals, microphone_noise=NOISE)), library, DOCS / "images" / "path.png"
    )
    return lines


def places() -> list[str]:
    """Rows of the table of taps that stand still."""
    design = geometry.prototype("fingertip-4x6")
    library = response_of(acoustic_fem.solve(design, np.arange(0.5, 300.1, 0.5), "lumped"))
    assert library.position is not None
    position, pitch = library.position, localize.tracking.pitch_of(library)
    lines = [
        "| radius of the finger | points alone: nearest found | places: nearest found | median | rms | covered |",
        "|---|---|---|---|---|---|",
    ]
    points = localize.BayesDecoder(library, microphone_noise=NOISE)
    recorder = ContactRecorder(library, microphone_noise=NOISE, seed=SEED)
    for radius in (2.0, 4.0):
        decoder = localize.PositionDecoder(library, radius, NOISE)
        tool = replace(FINGER, contact_radius_mm=(radius, radius))
        random = np.random.default_rng(SEED)
        true = random.uniform(position.min(0), position.max(0), (TAPS, 2))
        frames = []
        for number, place in enumerate(true):
            take = recorder.take(tap(tuple(place), tool=tool, seed=SEED, sample=number), number)
            first = int(np.flatnonzero(take.force)[0])
            frames.append(np.pad(take.signals, ((0, 0), (0, 250)), "edge")[:, first : first + 250])
        nearest = np.linalg.norm(true[:, None] - position, axis=-1).argmin(1)
        found = decoder.position(np.stack(frames))
        error = np.linalg.norm(found.place - true, axis=1)
        alone = 100 * (points.locate(np.stack(frames)).argmax(1) == nearest).mean()
        row = f"| {radius:g} mm | {alone:.0f} % | {100 * (found.point == nearest + 1).mean():.0f} % | "
        row += f"{np.median(error) / pitch:.2f} pitch | {np.sqrt((error**2).mean()) / pitch:.2f} pitch | "
        lines.append(row + f"{100 * (error < 2.45 * found.deviation).mean():.0f} % |")
        print(lines[-1], flush=True)
    return lines


def between() -> list[str]:
    """Rows of the table of taps between two neighbours."""
    design = geometry.prototype("fingertip-4x6")
    library = response_of(acoustic_fem.solve(design, np.arange(0.5, 300.1, 0.5), "lumped"))
    assert library.position is not None
    position, pitch = library.position, localize.tracking.pitch_of(library)
    made = made_sensors(library, "fingertip-4x6", SENSORS)
    conditions = {
        "nominal": ((library,), (library,)),
        "as-built, nominal library": ((library,), made),
        "as-built, their own transfer functions": (made, made),
        "as-built, calibrated from recordings": (calibrated("fingertip-4x6", SENSORS), made),
    }
    apart = np.linalg.norm(position[:, None] - position, axis=-1)
    pairs = np.argwhere(np.triu(apart < 1.1 * pitch, 1))
    random = np.random.default_rng(SEED)
    pair, share = pairs[random.integers(len(pairs), size=TAPS)], random.uniform(0, 1, (TAPS, 1))
    true = position[pair[:, 0]] * (1 - share) + position[pair[:, 1]] * share
    along = (position[pair[:, 1]] - position[pair[:, 0]]) / apart[pair[:, 0], pair[:, 1]][:, None]
    lines = [
        "| sensor | points alone: rms along the pair | on the line of a known pair: median / rms "
        "| places: within a pitch | rms along the pair of these | of all "
        "| median error and stated deviation | covered |",
        "|---|---|---|---|---|---|---|---|",
    ]
    tool = replace(FINGER, contact_radius_mm=(pitch, pitch))
    for name, (libraries, sensors) in conditions.items():
        points = [localize.BayesDecoder(each, microphone_noise=NOISE) for each in libraries]
        decoders = [localize.PositionDecoder(each, pitch, NOISE) for each in libraries]
        recorders = [ContactRecorder(each, microphone_noise=NOISE, seed=SEED) for each in sensors]
        off, named, on_line, said = np.empty((TAPS, 2)), np.empty((TAPS, 2)), np.empty(TAPS), np.empty(TAPS)
        for number, place in enumerate(true):
            take = recorders[number % len(sensors)].take(tap(tuple(place), tool=tool, seed=SEED, sample=number), number)
            first = int(np.flatnonzero(take.force)[0])
            frame = np.pad(take.signals, ((0, 0), (0, 250)), "edge")[None, :, first : first + 250]
            decoder = decoders[number % len(libraries)]
            found = decoder.position(frame)
            off[number], said[number] = found.place[0] - place, found.deviation[0]
            on_line[number] = abs(place_along(decoder, frame, position[pair[number]]) - share[number, 0])
            named[number] = position[points[number % len(libraries)].locate(frame)[0].argmax()] - place
        error = np.linalg.norm(off, axis=1)
        near = error < pitch
        of_points, of_all = (float(np.sqrt(((each * along).sum(1) ** 2).mean())) / pitch for each in (named, off))
        of_near = float(np.sqrt(((off * along).sum(1)[near] ** 2).mean())) / pitch
        known = f"{np.median(on_line):.3f} / {np.sqrt((on_line**2).mean()):.2f} pitch"
        lines.append(
            f"| {name} | {of_points:.2f} pitch | {known} | {100 * near.mean():.0f} % | {of_near:.2f} pitch "
            f"| {of_all:.2f} pitch | {np.median(error):.2f} and {np.median(said):.2f} mm "
            f"| {100 * (error < 2.45 * said).mean():.0f} % |"
        )
        print(lines[-1], np.sort(on_line)[-4:].round(2), flush=True)
    return lines


def place_along(decoder: localize.PositionDecoder, frame: Array, ends: Array) -> float:
    """Most likely place on the line from one point to the next, as a fraction of its length."""
    best = 0.5
    for wide in (1.0, 0.05):  # the second round between two places of the first
        share = np.clip(best + wide * (ALONG - 0.5), 0, 1)
        place = ends[0] + share[:, None] * (ends[1] - ends[0])
        best = float(share[decoder.log_likelihood_of(frame, place)[0].argmax()])
    return best


def main() -> None:
    parts = {
        "paths": (paths, BEGIN, END),
        "places": (places, PLACES_BEGIN, PLACES_END),
        "between": (between, BETWEEN_BEGIN, BETWEEN_END),
    }
    for name in sys.argv[1:] or parts:
        make, begin, end = parts[name]
        replace_section(DOCS / "evidence" / "moving-touches.md", begin, end, make())


if __name__ == "__main__":
    main()
