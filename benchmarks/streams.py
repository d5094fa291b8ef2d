"""Touches that a stream reports with the defaults of ``locate`` and ``live``.

``python benchmarks/streams.py`` prints the reports while nobody touches, and writes the table of
docs/evidence/streams.md, in a quarter of an hour of one core. ``python benchmarks/streams.py touches`` makes only the
table.

Signals are long records from the transfer functions of an as-built sensor (the workshop's tolerances, gains of its
microphones off by 5 %). They are computed at every line of a period of 16.7 s, 0.06 Hz apart, and of 60 s for sound.
The shapes of taps, presses and pulses are defined in this file and are not those of the decoder's generator. Noise, hum
and sound are not configured. "Calibrated" is a library of the sensor's own transfer functions. "Not calibrated" is that
of its design, with the tolerance-aware decoder. No constant was chosen on these seeds (they were chosen on 101 to 109).
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import geometry
import localize
from acoustic_fem.batch.network import batch_response
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.tolerances import ScatteredDesign, Tolerance
from geometry.ground.whole_files import replace_section
from localize.signals.array_response import ArrayResponse, response_of

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "streams.md"
BEGIN, END = "<!-- streams: made by benchmarks/streams.py -->", "<!-- end streams -->"
FREQUENCY = np.concatenate([np.arange(0.25, 20.0, 0.25), np.arange(20.0, 501.0)])
RATE, PERIOD, MINUTE = 1000, 16_667, 60_000
DESIGNS, SENSORS, SEED, GAIN = ("array-2x6", "line-2"), 3, 2026, 0.05
WINDOW = 0.35
"""Time after the beginning of a touch within which it must be told, s."""
Array = NDArray[np.float64]


@dataclass(frozen=True)
class Made:
    """Touch that was made."""

    begin: int
    """First sample."""
    end: int
    """Last sample."""
    point: int
    """Point, from 1."""


class Sensor:
    """A sensor as it may come out, and what may be known of it."""

    def __init__(self, library: Library, number: int, seed: int = SEED, as_designed: bool = False) -> None:
        self.design, self.seed = library.design, seed + number
        self.library, self._nominal = library, response_of(library)
        nominal = self._nominal
        nothing = (Tolerance("bore", 0.0, "relative", "as designed"),)
        self._scattered = ScatteredDesign(self.design, nothing) if as_designed else ScatteredDesign(self.design)
        self._draws = self._scattered.draws(number, 1, seed)
        self.gain = 1 + GAIN * np.random.default_rng([seed, number]).standard_normal((len(nominal.microphones), 1))
        if as_designed:
            self.gain = np.ones_like(self.gain)

    def _responses(self, frequency: Array) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        """(n_point, n_microphone, n) and, of sound, (n_microphone, n)."""
        parameters = self._scattered.parameters(self._draws)
        found = batch_response(parameters, self._scattered.topology, frequency, design_air(self.design))
        # Sound moves each membrane by its own compliance.
        push = (found.source_response * parameters.membrane_compliance[:, :, None, None]).sum(1)[0] * 1j * frequency
        return self.gain * found.transfer_function[0], self.gain * push

    @cached_property
    def _lines(self) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        return self._responses(np.arange(1, PERIOD // 2 + 1) * RATE / PERIOD)

    @cached_property
    def _sound_lines(self) -> NDArray[np.complex128]:
        frequency = np.arange(1, MINUTE // 2) * RATE / MINUTE
        known = np.geomspace(0.5, 500.0, 600)
        h = self._responses(known)[1]
        still = ScatteredDesign(self.design).nominal
        unit = batch_response(still, self._scattered.topology, np.array([20.0]), design_air(self.design))
        scale = (
            20.0 * np.abs((unit.source_response * still.membrane_compliance[:, :, None, None]).sum(1)[0, :, 0]).mean()
        )
        assert self._nominal.ambient_response is not None
        at = np.abs(self._nominal.frequency - 20.0).argmin()
        h = h * np.abs(self._nominal.ambient_response[:, at]).mean() / scale
        level, phase = np.log(np.abs(h)), np.unwrap(np.angle(h))
        return np.stack([
            np.exp(np.interp(np.log(frequency), np.log(known), level[k]))
            * np.exp(1j * np.interp(np.log(frequency), np.log(known), phase[k]))
            for k in range(len(h))
        ])  # fmt: skip

    @cached_property
    def calibrated(self) -> ArrayResponse:
        """Result of a calibration: its transfer functions, with the sound responses of the design."""
        return replace(self._nominal, transfer_function=self._responses(self._nominal.frequency)[0])

    def heard(self, made: Iterable[tuple[Made, Array]]) -> Array:
        """(n_microphone, PERIOD) Pa of pressures in cavities."""
        spectrum = np.zeros((len(self._nominal.microphones), PERIOD // 2 + 1), np.complex128)
        for touch, pressure in made:
            whole = np.zeros(PERIOD)
            whole[touch.begin : touch.begin + len(pressure)] = pressure
            spectrum[:, 1:] += np.fft.rfft(whole)[1:] * self._lines[0][touch.point - 1]
        return np.fft.irfft(spectrum, PERIOD)

    def own_noise(self, count: int, random: np.random.Generator) -> Array:
        """(n_microphone, count) Pa, of the design's microphones."""
        noise = self._nominal.own_noise
        assert noise is not None
        frequency = np.fft.rfftfreq(count, 1 / RATE)
        power = noise.power[np.minimum(np.rint(frequency).astype(int), len(noise.power) - 1)]
        white = np.fft.rfft(random.standard_normal((len(self._nominal.microphones), count)))
        return np.asarray(np.fft.irfft(white * np.sqrt(power * RATE / 2), count))

    def sound(self, level: float, random: np.random.Generator, moving: bool = False) -> Array:
        """(n_microphone, MINUTE) Pa of a minute of pink sound from 20 Hz on."""
        frequency = np.arange(MINUTE // 2 + 1) * RATE / MINUTE
        lines = np.fft.rfft(random.standard_normal(MINUTE)) / np.sqrt(np.maximum(frequency, 1.0))
        lines[frequency < 20.0] = 0
        pressure = np.fft.irfft(lines, MINUTE)
        if moving:  # as speech does
            slow = np.fft.rfft(random.standard_normal(MINUTE))
            slow[frequency > 4.0] = 0
            swell = np.fft.irfft(slow, MINUTE)
            pressure *= np.exp(swell / swell.std())
        return self.surrounded(pressure * 20e-6 * 10 ** (level / 20) / pressure.std())

    def surrounded(self, pressure: Array) -> Array:
        """(n_microphone, MINUTE) Pa in sound outside of a pressure, (MINUTE,) Pa."""
        spectrum = np.fft.rfft(pressure)
        heard = np.zeros((len(self._nominal.microphones), MINUTE // 2 + 1), np.complex128)
        heard[:, 1:-1] = spectrum[1:-1] * self._sound_lines
        return np.asarray(np.fft.irfft(heard, MINUTE))


def pulse(peak: float, flank: int, length: int) -> Array:
    """A pulse sin^2 of flanks in ms; where it is longer than both, held."""
    since = np.arange(length)
    share = np.clip(np.minimum(since, length - since) / min(flank, length / 2), 0.0, 1.0)
    return np.asarray(peak * np.sin(0.5 * np.pi * share) ** 2)


def drawn(kind: str, random: np.random.Generator) -> Array:
    """Pressure of one touch of a kind, of 1 to 10 Pa; of a beat, of 0.8 to 1.2 Pa."""
    peak = float(np.exp(random.uniform(np.log(1.0), np.log(10.0))))
    if kind == "tap":
        length = int(np.exp(random.uniform(np.log(20.0), np.log(80.0))))
        return pulse(peak, length, length)
    if kind == "press":
        return pulse(peak, int(random.uniform(20.0, 60.0)), int(random.uniform(700.0, 1300.0)))
    peak = random.uniform(0.8, 1.2)
    # A beat: a steep rise, a slower fall and a second, lower wave.
    time = np.arange(600) / RATE
    rise, second = random.uniform(0.05, 0.07), random.uniform(0.25, 0.5)
    wave = np.exp(-(((time - 0.18) / rise) ** 2) / 2) + second * np.exp(-(((time - 0.38) / 0.08) ** 2) / 2)
    return np.asarray(peak * wave * np.sin(np.pi * time / 0.6) ** 0.25)


def session(kind: str, points: int, random: np.random.Generator) -> list[tuple[Made, Array]]:
    """Touches of one record: the first after 2.5 s, the others with a pause of half a second (taps, presses) or at 50
    to 100 beats a minute.
    """
    at = 2500
    made: list[tuple[Made, Array]] = []
    point, period = int(random.integers(points)) + 1, int(60_000 / random.uniform(50.0, 100.0))
    while True:
        pressure = drawn(kind, random)
        if at + len(pressure) > PERIOD - 1500:
            return made
        made.append((Made(at, at + len(pressure), point), pressure))
        if kind == "pulse":
            at += period
        else:
            at += len(pressure) + 500
            point = int(random.integers(points)) + 1


@dataclass(frozen=True)
class Told:
    """Decisions and touches that a recording led to."""

    decisions: list[localize.Decision]
    touches: list[localize.Touch]
    """Touches, as they are known afterwards."""
    events: list[localize.TouchEvent]
    """The same as they were told while they happened."""


def told(known: Library | ArrayResponse, signals: Array) -> Told:
    """Decisions of a stream about a recording, by the library of a design or the transfer functions of its sensor."""
    response = response_of(known)
    decoder = decoder_of(known)
    stream = localize.TouchStream(decoder, sound_test=localize.SoundTest(response, "design"))
    events = stream.push(signals)
    tracker = localize.TouchTracker(decoder, stream.delay)
    return Told(
        [event for event in events if isinstance(event, localize.Decision)],
        localize.touches_of(events, decoder),
        [each for event in events for each in tracker.take(event)] + tracker.finish(),
    )


@lru_cache(4)
def decoder_of(known: Library | ArrayResponse) -> localize.BayesDecoder:
    """Decoder of a library or of transfer functions, with the defaults."""
    if isinstance(known, Library):
        return localize.TolerantDecoder(known, microphone_noise="design")
    return localize.BayesDecoder(known, "design")


def false_touches(sensor: Sensor) -> dict[str, tuple[float, float]]:
    """Touches reported in a minute while nobody touches, and the percentage of time with a reported point."""
    result: dict[str, tuple[float, float]] = {}
    for title, kind, size in (
        *((f"sound of {level} dB", "sound", level) for level in (40, 60, 70, 80)),
        ("moving sound of 65 dB", "moving", 65), ("white noise of 3 mPa", "noise", 3e-3),
        ("mains hum of 2.8 mPa", "hum", 2.8e-3), ("its own noise", "none", 0.0),
    ):  # fmt: skip
        random = np.random.default_rng([sensor.seed, len(result)])
        signals = sensor.own_noise(MINUTE, random)
        if kind in ("sound", "moving"):
            signals += sensor.sound(size, random, kind == "moving")
        elif kind == "noise":
            signals += size * random.standard_normal(signals.shape)
        elif kind == "hum":
            time, mains = np.arange(MINUTE) / RATE, 50.0 + random.uniform(-0.05, 0.05)
            turn = random.uniform(0, 2 * np.pi, (2, len(signals), 1))
            wave = np.sin(2 * np.pi * mains * time + turn[0]) + np.sin(6 * np.pi * mains * time + turn[1]) / 3
            signals += size * wave
        found = told(sensor.library, signals)
        # One touch may last the whole minute: what counts then is how long.
        lit = sum(decision.state == "touch" for decision in found.decisions) / len(found.decisions)
        result[title] = len(found.touches), 100 * lit
    return result


def of_touches(sensor: Sensor, kind: str, known: Library | ArrayResponse) -> tuple[Array, list[float]]:
    """Numbers of touches, in all, reported within 0.35 s, at the correct point, reported once; numbers of wrong frames
    and of wrong touches; and the times from the beginning of a touch to its report, ms.
    """
    sums, late = np.zeros(6), list[float]()
    for record in range(3):
        random = np.random.default_rng([sensor.seed, 77, record, len(kind)])
        made = session(kind, sensor.design.point_count, random)
        found = told(known, sensor.heard(made) + sensor.own_noise(PERIOD, random))
        # Each beat of a pulse is counted, whether it is a touch or a beat within one.
        begins = [(at, touch.point) for touch in found.touches for at in touch.beats or (touch.start,)]
        edges = [touch.begin for touch, _ in made] + [PERIOD]
        for index, (touch, _) in enumerate(made):
            here = [each for each in begins if edges[index] <= 1000 * each[0] < edges[index + 1]]
            soon = [each for each in here if 1000 * each[0] < touch.begin + 1000 * WINDOW]
            frames = [
                d for d in found.decisions
                if d.state == "touch" and edges[index] <= 1000 * d.time < edges[index + 1] and d.point != touch.point
            ]  # fmt: skip
            right = [point for _, point in here if point == touch.point]
            down = [
                1000 * event.time - touch.begin for event in found.events
                if event.kind in ("down", "beat") and edges[index] <= 1000 * event.time < edges[index + 1]
            ]  # fmt: skip
            late += down[:1]
            sums += (
                1, bool(soon), any(point == touch.point for _, point in soon), len(right) == 1,
                len(frames), len(here) - len(right),
            )  # fmt: skip
    return sums, late


def sensors(name: str) -> list[Sensor]:
    """Made sensors of a prototype."""
    library = acoustic_fem.solve(geometry.prototype(name), FREQUENCY, "lumped")
    return [Sensor(library, number) for number in range(SENSORS)]


def print_nobody(made: list[Sensor]) -> None:
    """Print the touches in a minute and the percentage of time with a reported point, while nobody touches."""
    found = [false_touches(sensor) for sensor in made]
    for title in found[0]:
        count, share = np.mean([each[title] for each in found], axis=0)
        print(f"{made[0].design.name}: {title}: {count:.1f} / {share:.1f}", flush=True)


def rows_of(made: list[Sensor]) -> list[str]:
    """Rows of the table of touches."""
    rows = []
    name = made[0].design.name
    for kind in ("tap", "press", "pulse"):
        sides = []
        for known in ("calibrated", "library"):
            found = [of_touches(sensor, kind, getattr(sensor, known)) for sensor in made]
            sums = np.sum([counts for counts, _ in found], axis=0)
            count = sums[0]
            share = 100 * sums / count
            usual, most = np.percentile(np.concatenate([late for _, late in found]), (50, 95))
            shares = (*(f"{value:.1f}" for value in share[1:4]), f"{sums[4] / count:.1f}", f"{sums[5] / count:.2f}")
            sides.append((*shares, f"{usual:.0f}", f"{most:.0f}"))
        cells = ("/".join(both) for both in zip(*sides, strict=True))
        rows.append(f"| {name}, {kind} | {' | '.join(cells)} |")
        print(rows[-1], flush=True)
    return rows


def main() -> None:
    titles = ("touches", "reported within 0.35 s (%)", "with the right point (%)", "exactly once (%)")
    titles += ("wrong frames", "wrong touches", "median (ms)", "95 % (ms)")
    lines = [f"| {' | '.join(titles)} |", "|---" * len(titles) + "|"]
    for name in DESIGNS:
        made = sensors(name)
        if sys.argv[1:] != ["touches"]:
            print_nobody(made)
        lines += rows_of(made)
    replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
