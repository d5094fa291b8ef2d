"""Count how often a stream reports each touch: taps, presses, slides, pairs of taps, pulses.

``python benchmarks/touch_counts.py --write`` writes the table of docs/evidence/streams.md, in some six minutes of one
core.

A record has five touches of random points, 2.8 s apart (pairs of taps: two taps of one point a second apart; pulses:
two of 3 s; in turn: taps and presses 1.2 to 2.2 s apart; strong: taps and presses of 10 to 100 Pa). Half of the records
are pressures in the cavity, the others strokes of the membrane: the air in the array pushes back, and the pressure
undershoots. Sensors are those of ``streams.py``. No constant was chosen on these seeds (they were chosen on 101 to
103).
"""

from __future__ import annotations

import argparse
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import scipy.signal
from streams import FREQUENCY, PERIOD, RATE, Array, Made, Sensor, Told, told

import acoustic_fem
import geometry
from acoustic_fem.batch.network import batch_response
from acoustic_fem.library.touch_pressure import touch_flow
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.quantities.local_air import design_air
from geometry.ground.whole_files import replace_section
from localize.signals.array_response import ArrayResponse

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "streams.md"
BEGIN, END = "<!-- touch counts: made by benchmarks/touch_counts.py -->", "<!-- end touch counts -->"
DESIGN, FIRST, SENSORS = "array-2x6", 6400, 6
KINDS = ("tap", "press", "slide", "two taps", "pulse", "in turn", "strong")
STEP = 2800
"""Time from one touch to the next, samples."""


class StrokedSensor(Sensor):
    """Sensor whose membranes are moved by a finger as well."""

    @cached_property
    def _strokes(self) -> np.ndarray:
        """Pressure at the microphones per stroke of the membrane, at the lines of a period, 1 at 20 Hz on average."""
        frequency = np.arange(1, PERIOD // 2 + 1) * RATE / PERIOD
        found = batch_response(
            self._scattered.parameters(self._draws), self._scattered.topology, frequency, design_air(self.design)
        )
        at = np.asarray(self.library.frequency)
        flow = np.asarray(touch_flow(self.design, self.library.point_impedance, "displacement"))
        # The volume per displacement hardly depends on frequency, the flow is proportional to it.
        volume = np.array([np.interp(frequency, at, each) for each in flow / (1j * at)])
        moved = self.gain * found.source_response[0] * (1j * frequency * volume)[:, None]
        middle = np.abs(frequency - 20.0).argmin()
        return moved * np.abs(self._lines[0][..., middle]).mean() / np.abs(moved[..., middle]).mean()

    def stroked(self, made: list[tuple[Made, Array]]) -> Array:
        """(n_microphone, PERIOD) Pa of strokes."""
        spectrum = np.zeros((len(self._nominal.microphones), PERIOD // 2 + 1), np.complex128)
        for touch, stroke in made:
            whole = np.zeros(PERIOD)
            whole[touch.begin : touch.begin + len(stroke)] = stroke
            spectrum[:, 1:] += np.fft.rfft(whole)[1:] * self._strokes[touch.point - 1]
        return np.fft.irfft(spectrum, PERIOD)


def log_uniform(low: float, high: float, random: np.random.Generator) -> float:
    return float(np.exp(random.uniform(np.log(low), np.log(high))))


def noise_between(low: float, high: float, count: int, random: np.random.Generator) -> Array:
    """(count,) of mean square 1 between two frequencies, Hz."""
    frequency = np.fft.rfftfreq(count + 1000, 1 / RATE)
    lines = np.fft.rfft(random.standard_normal(count + 1000)) * ((frequency >= low) & (frequency <= high))
    wave = np.fft.irfft(lines, count + 1000)[:count]
    return np.asarray(wave / np.sqrt((wave**2).mean()))


def drawn(kind: str, random: np.random.Generator) -> Array:
    """Waveform of one touch, Pa in the cavity: 0.3 to 10 Pa, of a pulse 0.02 to 0.5 Pa."""
    peak = log_uniform(0.3, 10.0, random)
    if kind in ("tap", "two taps"):
        length = int(log_uniform(10.0, 100.0, random))
        return peak * np.sin(np.pi * np.arange(length) / length) ** 2
    if kind == "press":
        rise, fall, hold = (log_uniform(*ends, random) for ends in ((20.0, 200.0), (20.0, 200.0), (100.0, 1500.0)))
        times = np.arange(int(rise + hold + fall))
        pressed = np.clip(np.minimum(times / rise, (rise + hold + fall - times) / fall), 0.0, 1.0)
        tremor = random.uniform(0.005, 0.05) * noise_between(6.0, 12.0, len(times), random)
        return peak * np.sin(0.5 * np.pi * pressed) ** 2 * (1 + tremor)
    if kind == "slide":
        speed = log_uniform(14.0, 200.0, random)
        length = int(1000 * random.uniform(4.0, 14.0) / speed)
        rough = random.uniform(0.05, 0.3) * noise_between(speed / 4.0, min(speed / 0.25, 400.0), length, random)
        return peak * np.sin(np.pi * np.arange(length) / length) ** 2 * (1 + rough)
    # Two Gaussians a beat, as of Tang et al. (2020); whole beats, from foot to foot.
    peak, period = log_uniform(0.02, 0.5, random), 60_000 / random.uniform(45.0, 105.0)
    height, later, width = random.uniform(0.2, 0.6), random.uniform(0.25, 0.4), random.uniform(0.06, 0.09)
    beats = int(3000 / period)
    since: Array = np.arange(int((beats + 1) * period)) / period
    wave: Array = np.zeros(len(since))
    for beat in range(-1, beats + 2):
        for high, at, wide in ((1.0, 0.35, width), (height, 0.35 + later, 0.12)):
            wave = wave + high * np.exp(-0.5 * ((since - beat - at) / wide) ** 2)
    foot = int(wave[: int(period)].argmin())
    wave = wave[foot : foot + int(beats * period)] - wave[foot]
    return np.asarray(peak * wave / wave.max())


def session(kind: str, points: int, random: np.random.Generator) -> list[tuple[Made, Array]]:
    """Touches of one record."""
    made: list[tuple[Made, Array]] = []
    if kind in ("in turn", "strong"):
        at = 2500
        while at < PERIOD - 3500:
            wave = drawn("press" if len(made) % 2 else "tap", random)
            if kind == "strong":
                wave *= log_uniform(10.0, 100.0, random) / wave.max()
            made.append((Made(at, at + len(wave), int(random.integers(points)) + 1), wave))
            at += STEP if kind == "strong" else max(int(random.uniform(1200.0, 2200.0)), len(wave) + 500)
        return made
    for at in (2500, 8300) if kind == "pulse" else range(2500, 2500 + 5 * STEP, STEP):
        point = int(random.integers(points)) + 1
        for begin in (at, at + 1000) if kind == "two taps" else (at,):
            wave = drawn(kind, random)
            made.append((Made(begin, begin + len(wave), point), wave))
    return made


def record(sensor: StrokedSensor, kind: str, number: int) -> tuple[list[Made], Array]:
    """Touches of a record, and its signals, (n_microphone, PERIOD) Pa."""
    random = np.random.default_rng([sensor.seed, 39, KINDS.index(kind), number])
    made = session(kind, sensor.design.point_count, random)
    heard = sensor.stroked(made) if number % 2 else sensor.heard(made)
    return [touch for touch, _ in made], heard + sensor.own_noise(PERIOD, random)


@dataclass
class Counts:
    """Counts over touches."""

    touches: int = 0
    once: int = 0
    """Touches with one report `down`."""
    once_afterwards: int = 0
    """Touches that `locate` prints once."""
    right_only: int = 0
    """Touches without a report of a wrong point."""
    missed: int = 0
    first_right: int = 0
    frames: int = 0
    wrong_frames: int = 0

    def __post_init__(self) -> None:
        self.late: list[float] = []

    def take(self, made: list[Made], found: Told) -> None:
        """Count the touches of a record."""
        edges = [touch.begin for touch in made] + [PERIOD]
        for index, touch in enumerate(made):
            low, high = edges[index] / RATE, edges[index + 1] / RATE
            named = [event for event in found.events if event.kind in ("down", "moved") and low <= event.time < high]
            down = [event for event in named if event.kind == "down"]
            after = [each for each in found.touches if low <= each.start < high]
            frames = [each for each in found.decisions if each.state == "touch" and low <= each.time < high]
            right = all(event.point == touch.point for event in named)
            self.touches += 1
            self.once += len(down) == 1
            self.once_afterwards += len(after) == 1
            self.right_only += right and bool(named)
            self.missed += not down
            self.first_right += bool(down) and down[0].point == touch.point
            self.frames += len(frames)
            self.wrong_frames += sum(each.point != touch.point for each in frames)
            self.late += [1000 * (event.time - low) for event in down[:1]]

    def cells(self) -> list[str]:
        """Cells of a row."""
        share = [
            f"{100 * each / self.touches:.0f}"
            for each in (self.once, self.once_afterwards, self.right_only, self.missed, self.first_right)
        ]
        return [
            str(self.touches), *share, f"{100 * self.wrong_frames / max(self.frames, 1):.1f}",
            "/".join(f"{each:.0f}" for each in np.percentile(self.late, (50, 90))) if self.late else "-",
        ]  # fmt: skip


def sensors_of(title: str, first: int, count: int, library: Library) -> Iterator[tuple[StrokedSensor, object]]:
    """Sensors of a row, and what is known of each."""
    for number in range(1 if title == "nominal" else count):
        sensor = StrokedSensor(library, number, first, title == "nominal")
        known: Library | ArrayResponse = sensor.calibrated if title == "as built, own library" else library
        yield sensor, known


def behind(corner: float | None, signals: Array) -> Array:
    """Signals behind a high-pass of first order that the microphones may have, of a corner in Hz."""
    if corner is None:
        return signals
    return np.asarray(scipy.signal.sosfilt(scipy.signal.butter(1, corner, "highpass", fs=RATE, output="sos"), signals))


def rows(
    design: str, first: int, sensors: int, kinds: tuple[str, ...], records: int, corner: float | None
) -> Iterator[str]:
    library = acoustic_fem.solve(geometry.prototype(design), FREQUENCY, "lumped")
    for title in ("nominal", "as built, not calibrated", "as built, own library"):
        for kind in kinds:
            counts = Counts()
            for sensor, known in sensors_of(title, first, sensors, library):
                numbers = range(records * (sensors if title == "nominal" else 1))
                for number in (each + sensor.seed - first for each in numbers):  # both kinds of waves in turn
                    made, signals = record(sensor, kind, number)
                    counts.take(made, told(known, behind(corner, signals)))
            yield f"| {title}, {kind} | {' | '.join(counts.cells())} |"


def main() -> None:
    # Closed forms warn of tubes' entrances: touches and libraries here are of the same forms.
    warnings.filterwarnings("ignore", "entrance loss", UserWarning)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--design", default=DESIGN)
    parser.add_argument("--first", type=int, default=FIRST, help="seed of the first sensor")
    parser.add_argument("--sensors", type=int, default=SENSORS)
    parser.add_argument("--records", type=int, default=1, help="records of each kind for each sensor")
    parser.add_argument("--kind", choices=KINDS, action="append")
    parser.add_argument("--write", action="store_true", help="into docs/evidence/streams.md")
    parser.add_argument(
        "--corner", type=float, help="corner of a high-pass that the microphones have, Hz; by default they have none"
    )
    chosen = parser.parse_args()
    titles = [
        "sensor, touch", "touches", "exactly one `down` (%)", "one touch in `locate` (%)", "only the correct point (%)",
        "missed (%)", "first `down` correct (%)", "wrong frames (%)", "`down` p50/p90 (ms)",
    ]  # fmt: skip
    lines = [f"| {' | '.join(titles)} |", "|---" * len(titles) + "|"]
    kinds = tuple(chosen.kind or KINDS)
    for row in rows(chosen.design, chosen.first, chosen.sensors, kinds, chosen.records, chosen.corner):
        print(row, flush=True)
        lines.append(row)
    if chosen.write:
        replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
