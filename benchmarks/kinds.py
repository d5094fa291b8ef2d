"""Kinds of touch on the glove: events and textures, nominal and as-built. ``python benchmarks/kinds.py`` trains both
recognizers, prints the tables of docs/evidence/moving-touches.md and writes them there, in a quarter of an hour of one
core. With ``kinds`` or ``slides`` it makes only one of them.

The fidelity is lumped, with the noise of the design's microphone and the hum and drift of a recorder. As-built sensors
are virtual rigs, and their waveforms are reconstructed with the nominal library. No constant was chosen on these seeds.
The classification of slides was tuned on seed 7203 with sensors 400 to 405.
"""

from __future__ import annotations

import sys
from pathlib import Path
from time import perf_counter, process_time
from typing import Any

import numpy as np
from made_sensors import made_sensors
from numpy.typing import NDArray

import acoustic_fem
import geometry
import localize
from geometry.ground.refusal import Refusal
from geometry.ground.whole_files import replace_section
from localize.contacts import Contact, ContactRecorder, double_tap, press, tap
from localize.decoders.reconstruct import Reconstructor
from localize.evaluation.accuracy import wilson_interval
from localize.recognition import PROFILES, SPEED, SUBJECTS, TakeMaker, texture_force
from localize.recognition.filter_bank import FilterBank
from localize.recognition.power_maps import maps_of
from localize.signals.array_response import ArrayResponse, response_of
from localize.tracking import straight_slide
from studies.output.response_figures import draw_confusion

ROOT = Path(__file__).parents[1]
PAGE, IMAGES = ROOT / "docs" / "evidence" / "moving-touches.md", ROOT / "docs" / "images"
BEGIN, END = "<!-- kinds: made by benchmarks/kinds.py -->", "<!-- end kinds -->"
SLIDES_BEGIN, SLIDES_END = "<!-- slides: made by benchmarks/kinds.py -->", "<!-- end slides -->"
DESIGN, SEED, SENSORS, TAKES = "glove", 41, range(300, 312), 60
FREQUENCY = np.arange(0.5, 500.5, 0.5)
SLIDES, OF_SPEED = 64, 24
"""Number of slides in a cell, and of those whose speed is compared."""
SILENCE = 1500
"""Samples of silence before and behind a slide, or another touch."""
FINGERS = ((0, 1, 2), (5, 4, 3), (6, 7, 8), (11, 10, 9))
"""Points of each finger of the glove, from its root."""
GESTURES = (tap, double_tap, press)
SPEEDS = {"± 1 %": (0.99, 1.01), "± 15 %": (0.85, 1.15), "x 1.5": (1.4999, 1.5001)}


def nominal() -> ArrayResponse:
    return response_of(acoustic_fem.solve(geometry.prototype(DESIGN), FREQUENCY, "lumped"))


def cell(right: NDArray[np.bool_]) -> str:
    low, high = (100 * end for end in wilson_interval(float(right.mean()), len(right)))
    return f"{100 * right.mean():.1f} ({low:.1f} to {high:.1f})"


class Judge:
    """One recognizer, and takes of its subject."""

    def __init__(self, subject: str, response: ArrayResponse) -> None:
        begun = perf_counter()
        self.recognizer = localize.train_recognizer(response, subject)
        self.seconds = perf_counter() - begun
        self.subject, self.response = subject, response
        self.reconstructor = Reconstructor(response, "design")
        self.count = TAKES * len(SUBJECTS[subject].labels)

    def maker(self, sensors: tuple[ArrayResponse, ...], **how: Any) -> TakeMaker:
        return TakeMaker(self.subject, self.reconstructor, sensors, SEED, "design", **how)

    def told(self, sensors: tuple[ArrayResponse, ...], **how: Any) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        maps, kind = self.maker(sensors, **how).maps("evaluation", self.count)
        return self.recognizer.of_maps(maps).argmax(1), kind.numpy()

    def right(self, sensors: tuple[ArrayResponse, ...], **how: Any) -> NDArray[np.bool_]:
        named, kind = self.told(sensors, **how)
        return named == kind

    def with_points_named(self, sensors: tuple[ArrayResponse, ...], locator: Any) -> tuple[str, str]:
        """Cells of the points that are located correctly, and of the kinds recognized at the located points."""
        maker, points, kinds = self.maker(sensors), [], []
        for number in range(self.count):
            signals, kind, point, _ = maker.signals("evaluation", number)
            named = int(locator.locate(signals).argmax())
            window = self.reconstructor.waveform(signals, named + 1).pressure[0]
            window = window[np.isfinite(window)][-1024:]
            points.append(named == point)
            kinds.append(int(self.recognizer.recognize(window).argmax()) == kind)
        return cell(np.array(points)), cell(np.array(kinds))

    def fingers(self, sensors: tuple[ArrayResponse, ...]) -> NDArray[np.bool_]:
        """Taps, double taps and presses of fingers recognized at known points; no such event was in the training."""
        recorders = [ContactRecorder(each, microphone_noise="design", seed=SEED) for each in sensors]
        ear, nobody = FilterBank(self.response, self.recognizer), localize.BayesDecoder(self.response, 1e-3)
        right = []
        for number in range(len(GESTURES) * TAKES):
            random = np.random.default_rng((SEED, number))
            point = int(random.integers(self.response.point_count))
            assert self.response.position is not None
            x, y = self.response.position[point] + random.uniform(-1, 1, 2)
            touch = GESTURES[number % len(GESTURES)]((x, y), seed=SEED, sample=number)
            signals = recorders[number % len(recorders)].take(_among_silence(touch), number).signals
            told = ear.touches(signals, point, None, nobody)
            right.append([self.recognizer.labels[each.probability.argmax()] for each in told] == [touch.label])
        return np.array(right)

    def picture(self, sensors: tuple[ArrayResponse, ...]) -> None:
        named, kind = self.told(sensors)
        confusion = np.zeros((len(self.recognizer.labels),) * 2, np.int64)
        np.add.at(confusion, (kind, named), 1)
        draw_confusion(confusion, self.recognizer.labels, IMAGES / f"kinds-{self.subject}.png", "kind")


def _among_silence(touch: Contact) -> Contact:
    """A contact with silence before and behind it."""
    before, behind = SILENCE / 1000, touch.time[-1] + 2 * SILENCE / 1000
    return Contact(
        np.concatenate([[0.0], touch.time + before, [behind]]),
        touch.path[[0, *range(len(touch.path)), -1]],
        np.concatenate([[0.0], touch.force, [0.0]]),
        touch.contact_radius_mm,
        touch.roughness,
        touch.label,
    )


def milliseconds(judge: Judge) -> list[str]:
    """Median times of one decision in a stream: where, the waveform at the newest window, its maps, what."""
    signals, _, point, _ = judge.maker((judge.response,)).signals("evaluation", 0)
    decoder = localize.BayesDecoder(judge.response, 1e-3)
    window = judge.reconstructor.waveform(signals, point + 1).pressure[0]
    window = window[np.isfinite(window)][-1024:]
    maps = maps_of(window[None])
    steps = {
        "point: the Bayes decoder, 250 ms": lambda: decoder.locate(signals[:, -250:]),
        "the waveform of 1,274 samples": lambda: judge.reconstructor.waveform(signals, point + 1),
        "wavelet maps, 2 x 64 x 32": lambda: maps_of(window[None]),
        "kind: the network": lambda: judge.recognizer.of_maps(maps),
    }
    rows, total = [], 0.0
    for name, step in steps.items():
        times = []
        for _ in range(60):
            begun = process_time()
            step()
            times.append(process_time() - begun)
        took = 1e3 * float(np.median(times))
        total += took
        rows.append(f"| {name} | {took:.2f} |")
    return [
        "",
        "| a decision, processor time of one core, medians of 60 | ms |",
        "|---|---|",
        *rows,
        f"| sum (the publication: 1.5 + 2.7 + 1.2) | {total:.2f} |",
    ]


def slid(response: ArrayResponse, kind: int, speed: float, random: np.random.Generator, blunter: float) -> Contact:
    """A pad that slides along a finger of the glove, with the force of a contact that passes a profile."""
    assert response.position is not None
    row = response.position[list(FINGERS[random.integers(len(FINGERS))])][:: random.choice([-1, 1])]
    along = (row[-1] - row[0]) / np.linalg.norm(row[-1] - row[0])
    beside = random.uniform(-1.5, 1.5) * np.array([-along[1], along[0]])
    begin, end = row[0] - 6 * along + beside, row[-1] + 6 * along + beside
    count = int(1000 * np.linalg.norm(end - begin) / speed)
    time = np.arange(-SILENCE, count + SILENCE) / 1000
    since = np.clip(time * 1000 / count, 0, 1)
    pressed = random.uniform(2e-3, 2e-2) * np.clip(np.minimum(since, 1 - since) * count / 50, 0, 1)
    force = pressed * texture_force(PROFILES[kind], len(time), speed, random, blunter)
    return Contact(time, begin + (end - begin) * since[:, None], force, random.uniform(5, 8))


def told_slides(
    judge: Judge, sensors: tuple[ArrayResponse, ...], locator: Any, speeds: tuple[float, float], blunter: float
) -> tuple[list[bool], list[float]]:
    """Slides that are recognized from their recording alone, and errors of the reported speeds."""
    recorders = [ContactRecorder(each, microphone_noise="design", seed=SEED) for each in sensors]
    ear = FilterBank(judge.response, judge.recognizer)
    right, off = [], []
    for number in range(SLIDES):
        random, kind = np.random.default_rng((SEED, number)), number % len(PROFILES)
        speed = float(np.exp(random.uniform(*np.log(speeds))))
        contact = slid(judge.response, kind, speed, random, blunter)
        signals = recorders[number % len(recorders)].take(contact, number).signals
        if number < OF_SPEED:
            slide = straight_slide(judge.response, locator.locate, signals)
            off += [] if slide is None else [slide.speed / speed - 1]
        try:
            told = ear.touches(signals, None, None, locator)
        except Refusal:
            told = ()
        right.append(len(told) == 1 and int(told[0].probability.argmax()) == kind)
    return right, off


def slides() -> None:
    """The table of slides whose speed nobody states."""
    response = nominal()
    judge = Judge("textures", response)
    library = acoustic_fem.solve(geometry.prototype(DESIGN), np.arange(1.0, 501.0), "lumped")
    columns = (
        ((response,), localize.BayesDecoder(library, "design")),
        (made_sensors(response, DESIGN, SENSORS), localize.TolerantDecoder(library, microphone_noise="design")),
    )
    lines = ["| slides along a finger of the glove | nominal | as-built, nominal library |", "|---|---|---|"]
    for name, (low, high) in SPEEDS.items():
        for sharp in (1.0, 1.5) if name == "± 15 %" else (1.0,):
            cells = []
            for sensors, locator in columns:
                right, off = told_slides(judge, sensors, locator, (low * SPEED, high * SPEED), sharp)
                missed = f", {OF_SPEED - len(off)} of {OF_SPEED} not detected" if len(off) < OF_SPEED else ""
                cells.append(
                    f"{cell(np.array(right))}; speed off by {100 * np.sqrt(np.mean(np.square(off))):.1f} % rms{missed}"
                )
            blunt = "" if sharp == 1.0 else ", a finger 1.5 times as blunt"
            lines.append(f"| speed {name}{blunt} | {' | '.join(cells)} |")
            print(lines[-1], file=sys.stderr, flush=True)
    replace_section(PAGE, SLIDES_BEGIN, SLIDES_END, lines)


def kinds() -> None:
    """The table of single points."""
    response = nominal()
    sensors = {"nominal": (response,), "as-built": made_sensors(response, DESIGN, SENSORS)}
    events = Judge("events", response)
    lines = [f"| {DESIGN}, recognised correctly (%) | nominal | as-built, nominal library |", "|---|---|---|"]

    def row(title: str, judge: Judge, **how: Any) -> None:
        lines.append(f"| {title} | " + " | ".join(cell(judge.right(each, **how)) for each in sensors.values()) + " |")
        print(lines[-1], file=sys.stderr)

    row("events", events)
    row("events, a finger 1.5 times as blunt", events, blunter=1.5)
    fingers = " | ".join(cell(events.fingers(each)) for each in sensors.values())
    lines.append(f"| taps, double taps and presses of fingers | {fingers} |")
    locators = {"nominal": localize.BayesDecoder(response, 1e-3), "as-built": None}
    library = acoustic_fem.solve(geometry.prototype(DESIGN), np.arange(1.0, 501.0), "lumped")
    locators["as-built"] = localize.TolerantDecoder(library, microphone_noise=1e-3)
    named = [events.with_points_named(sensors[name], locators[name]) for name in sensors]
    lines.append(f"| points of the events, located by the decoder | {named[0][0]} | {named[1][0]} |")
    lines.append(f"| events, with the point located by the decoder | {named[0][1]} | {named[1][1]} |")
    textures = Judge("textures", response)
    for name, (low, high) in SPEEDS.items():
        speeds = (low * SPEED, high * SPEED)
        row(f"textures, speed {name}, known to 1 %", textures, speeds=speeds)
        row(f"textures, speed {name}, known to 5 %", textures, speeds=speeds, speed_error=0.05)
        row(f"textures, speed {name}, not known", textures, speeds=speeds, speed_known=False)
        row(f"textures, speed {name}, a finger 1.5 times as blunt", textures, speeds=speeds, blunter=1.5)
    lines.append("")
    lines.append(
        f"A cell has {events.count} takes of events or {textures.count} of textures. Training took "
        f"{events.seconds:.0f} s and {textures.seconds:.0f} s of one core, with "
        f"{events.recognizer.training['takes']} and {textures.recognizer.training['takes']} takes."
    )
    lines += milliseconds(events)
    print("\n".join(lines))
    replace_section(PAGE, BEGIN, END, lines)
    events.picture(sensors["as-built"])
    textures.picture(sensors["as-built"])


def main() -> None:
    parts = {"kinds": kinds, "slides": slides}
    for name in sys.argv[1:] or parts:
        parts[name]()


if __name__ == "__main__":
    main()
