"""Touches of fingers on as-built sensors, by the trained network and the decoders that need no training.

``python benchmarks/finger_touches.py [DESIGN ...]``. Contacts of :mod:`localize.contacts` press the membranes, not the
sources that the network is trained on. Each gives one frame behind the high-pass of a stream, at a random place among
those that hold at least half of the energy of the loudest. Sensors are drawn from the tolerances of one that nobody
calibrated, with seeds on which nothing was chosen. Membranes must be as large as the contact of a finger, or it presses
several at once. Each cell is the top-1 accuracy on the design, the mean over the
as-built sensors, and their fifth percentile, %.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Iterator
from dataclasses import replace
from time import process_time

import numpy as np
import scipy.signal
from rich.console import Console
from rich.table import Table
from scipy.interpolate import CubicSpline

import acoustic_fem
import localize
from acoustic_fem import Library
from acoustic_fem.scatter.as_built_sensors import scatter_factors
from acoustic_fem.scatter.tolerances import UNCALIBRATED, ScatteredDesign
from geometry.ground.typed import Array
from localize.contacts import Contact, ContactRecorder, press, slide, tap
from localize.contacts.contact_shapes import FINGER, Tool
from localize.live.front_end import high_pass_sections
from localize.live.stream_options import HIGH_PASS
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.finger_strokes import HEARD
from localize.signals.frames import FRAME
from localize.signals.locator import Locator
from localize.signals.stimulus import SAMPLE_RATE as RATE

SEED = 92000
SENSORS = 20
EACH = 3
KINDS = ("sines", "taps", "presses", "slides")
#: How far from the middle of a membrane a finger lands, and how far it slides to either side of it, mm.
OFF, WAY = 0.5, 5.0
SLIDE_SPEED = (20.0, 150.0)
Frames = dict[str, tuple[Array, np.ndarray]]


def as_built(library: Library, response: ArrayResponse, count: int) -> Iterator[ArrayResponse]:
    """Sensors that a design may come out as, in the air of the design."""
    nodes = np.geomspace(response.frequency[0], response.frequency[-1], 60)
    factors = scatter_factors(ScatteredDesign(library.design, UNCALIBRATED), library.medium, nodes, count, SEED)
    logarithm = np.log(np.abs(factors)) + 1j * np.unwrap(np.angle(factors))
    for each in CubicSpline(np.log(nodes), logarithm, axis=-1)(np.log(response.frequency)):
        yield replace(response, transfer_function=response.transfer_function * np.exp(each))


def frame_of(signals: Array, random: np.random.Generator) -> Array:
    """A frame that holds at least half of the energy of the loudest, behind the high-pass."""
    heard = scipy.signal.sosfilt(high_pass_sections(HIGH_PASS), signals, axis=-1)
    energy = np.convolve((heard**2).sum(0), np.ones(FRAME), "valid")
    start = int(random.choice(np.flatnonzero(energy > 0.5 * energy.max())))
    return np.asarray(heard[:, start : start + FRAME])


def frame_of_edge(signals: Array, contact: Contact, random: np.random.Generator) -> Array:
    """A frame that holds a tap, or the rise of a press, as the frames do on which a run is evaluated.

    The signals begin with at least one frame of silence. Where the edge is longer than the frame, its beginning is in
    the frame.
    """
    heard = scipy.signal.sosfilt(high_pass_sections(HIGH_PASS), signals, axis=-1)
    force = contact.force >= 0.95 * contact.force.max() if contact.label == "press" else contact.force > 0
    first, last = (int(RATE * (contact.time[k] - contact.time[0])) for k in np.flatnonzero(force)[[0, -1]])
    begin = int(RATE * (contact.time[contact.force > 0][0] - contact.time[0]))
    length = (first if contact.label == "press" else last) - begin
    start = begin - int(random.uniform(0, max(0, FRAME - 2 * HEARD - length)))
    return np.asarray(heard[:, start : start + FRAME])


def after_silence(contact: Contact) -> Contact:
    """The contact after a frame of silence."""
    time = np.concatenate([[contact.time[0] - FRAME / RATE], contact.time])
    force, path = np.concatenate([[0.0], contact.force]), np.concatenate([contact.path[:1], contact.path])
    return replace(contact, time=time, force=force, path=path)


def contacts(
    place: Array, seed: int, number: int, random: np.random.Generator, tool: Tool = FINGER
) -> dict[str, Contact]:
    """A tap, a press and a slide of a finger, or of another tool, on one membrane."""
    x, y = place + random.uniform(-OFF, OFF, 2)
    angle, speed = random.uniform(0, 2 * np.pi), float(np.exp(random.uniform(*np.log(SLIDE_SPEED))))
    along = WAY * np.array([np.cos(angle), np.sin(angle)])
    start, end = ((float(a), float(b)) for a, b in (place - along, place + along))
    return {
        "taps": tap((x, y), tool=tool, seed=seed, sample=number),
        "presses": press((x, y), tool=tool, seed=seed, sample=number),
        "slides": slide(start, end, speed, seed=seed, sample=number),
    }


def touched(
    response: ArrayResponse,
    seed: int,
    tool: Tool = FINGER,
    *,
    linear: bool = False,
    edges: bool = False,
    kinds: tuple[str, ...] = KINDS[1:],
) -> Frames:
    """Frames of multi-sines and of kinds of contacts, (n, n_microphone, 250), and their points, from 0.

    Frames hold edges, as of :func:`frame_of_edge`, or are at random places, as of :func:`frame_of`.
    """
    assert response.position is not None
    recorder, points = ContactRecorder(response, seed=seed, linear=linear), response.point_count
    sines = localize.TouchGenerator(response, seed, "evaluation").samples(0, EACH * points)
    heard = scipy.signal.sosfilt(high_pass_sections(HIGH_PASS), sines.signals.numpy().astype(np.float64), axis=-1)
    made: dict[str, list[Array]] = {kind: [] for kind in kinds}
    for number in range(EACH * points):
        random = np.random.default_rng((seed, number))
        touches = contacts(response.position[number % points], seed, number, random, tool)
        for k, kind in enumerate(kinds):
            if edges:
                contact = after_silence(touches[kind])
                made[kind].append(frame_of_edge(recorder.take(contact, 3 * number + k).signals, contact, random))
                continue
            take = recorder.take(touches[kind], 3 * number + k).signals
            silent = max(0, FRAME + 1 - take.shape[1])
            made[kind].append(frame_of(np.pad(take, ((0, 0), (silent, 0))), random))
    point = np.arange(EACH * points) % points
    return {"sines": (heard[..., -FRAME:], point)} | {kind: (np.stack(each), point) for kind, each in made.items()}


def row(locator: Locator, sensors: list[Frames]) -> list[str]:
    """Cells of a localizer, and the calibration error of all as-built touches."""
    cells, errors = [], []
    for kind in KINDS:
        right = []
        for number, frames in enumerate(sensors):
            signals, point = frames[kind]
            probability = locator.locate(signals)
            named = probability.argmax(1) == point
            right.append(100 * named.mean())
            if number:
                errors += list(zip(probability.max(1), named, strict=True))
        fifth = np.percentile(right[1:], 5)
        cells.append(f"{right[0]:.1f} / {np.mean(right[1:]):.1f} ({fifth:.0f})")
    stated, named = np.array(errors).T
    bins = np.minimum((10 * stated).astype(int), 9)
    gaps = [abs(named[bins == k].mean() - stated[bins == k].mean()) * (bins == k).mean() for k in np.unique(bins)]
    return [*cells, f"{sum(gaps):.3f}"]


def main(designs: list[str]) -> None:
    """Print a table of each design."""
    # Closed forms warn of tubes' entrances: what is compared are decoders, on the same transfer functions.
    warnings.filterwarnings("ignore", "entrance loss", UserWarning)
    for name in designs:
        library = acoustic_fem.solve(name, "1:500:500", fidelity="atlas")
        response = response_of(library)
        sensors = [response, *as_built(library, response, SENSORS)]
        frames = [touched(sensor, SEED + number) for number, sensor in enumerate(sensors)]
        table = Table(title=f"{name}: design / {SENSORS} as-built sensors (5th percentile), %")
        for column in ("localizer", *KINDS, "calibration error", "training, s of processor"):
            table.add_column(column)
        start = process_time()
        network = localize.train(library)
        spent = process_time() - start
        table.add_row("trained network", *row(network, frames), f"{spent:.0f}")
        table.add_row("tolerance-aware decoder", *row(localize.TolerantDecoder(library), frames), "")
        table.add_row("Bayes decoder", *row(localize.BayesDecoder(library), frames), "")
        Console().print(table)


if __name__ == "__main__":
    main(sys.argv[1:] or ["array-2x6", "glove", "line-2"])
