"""The pulse under a finger: its point, waveform, waves and rate. ``python benchmarks/pulse.py`` prints the table of
docs/evidence/moving-touches.md and writes it there, in some minutes of one core.

Contacts come from :func:`localize.contacts.pulse_wave`: a finger on the middle of one point for 10 s, 50 to 100 beats a
minute. The fidelity is lumped, and the noise is that of the design's microphone. As-built sensors are virtual rigs,
which are decoded with the nominal library and with their own. No constant was chosen on these seeds. Constants were
chosen on seed 960 with sensors 960 to 965; those that tell a pulse from none on seeds 7 and 11, and on the first two
recordings of heartpy and every fifth piece of the third.
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import get_args

import numpy as np
import scipy.signal
from made_sensors import made_sensors
from numpy.typing import NDArray

import acoustic_fem
import geometry
import localize
from acoustic_fem.numerics.frequency_splines import interpolated
from geometry.ground.whole_files import replace_section
from localize.contacts import Contact, ContactRecorder, covered_force, pulse_times, pulse_wave
from localize.contacts.pulses import WAVES, Rhythm
from localize.evaluation.accuracy import wilson_interval
from localize.recognition.pulse import PulseDecoder
from localize.recognition.takes import prepared
from localize.signals.array_response import ArrayResponse, response_of
from studies.output.figure_style import WIDTH, figure_in_style, save_figure

Array = NDArray[np.float64]

ROOT = Path(__file__).parents[1]
PAGE, PICTURE = ROOT / "docs" / "evidence" / "moving-touches.md", ROOT / "docs" / "images" / "pulse-waveform.png"
BEGIN, END = "<!-- pulse: made by benchmarks/pulse.py -->", "<!-- end pulse -->"
HEARTS, END_HEARTS = "<!-- hearts: made by benchmarks/pulse.py -->", "<!-- end hearts -->"
DESIGNS, SEED, PULSES, SECONDS, SENSORS = ("array-2x6", "glove"), 63, 240, 10.0, range(360, 372)
FREQUENCY = np.concatenate([np.arange(0.25, 20.0, 0.25), np.arange(20.0, 501.0)])
WANTED = 30.0
"""Signal over error that is aimed at, dB."""
FOUND = 0.04
"""Distance up to which a wave is found, s."""
EACH = 24
"""Recordings of each heart."""
REAL = {"data.csv": 100.0, "data2.csv": 117.0, "data3.csv": 100.42}
"""Sample rates of the recordings of heartpy, Hz, as its documentation computes them from their times."""
LOWEST = 0.7
"""Frequency above which waveforms are compared, Hz."""
NAMES = tuple(WAVES["three waves"])
INSIDE = slice(1000, -1000)
"""Samples that are compared: the filter rings at the ends."""


def cell(right: list[bool]) -> str:
    low, high = (100 * end for end in wilson_interval(float(np.mean(right)), len(right)))
    return f"{100 * np.mean(right):.1f} ({low:.1f} to {high:.1f})"


def compared(waveform: Array, force: Array) -> tuple[float, Array, Array]:
    """Signal over error, dB, above LOWEST and apart from a common factor; the waveform there, and the force times that
    factor.
    """
    high = scipy.signal.butter(2, LOWEST, "highpass", fs=1000, output="sos")
    known = np.isfinite(waveform)  # both are cut, so that ends ring alike
    made, true = (scipy.signal.sosfiltfilt(high, each[known])[INSIDE] for each in (waveform, force))
    true = true * (made @ true) / (true @ true)
    return float(10 * np.log10((true**2).mean() / ((made - true) ** 2).mean())), made, true


def left_by_noise(sensor: ArrayResponse, contact: Contact, point: int) -> float:
    """Ratio of signal to error, dB, of the best linear filter of a whole recording. It is given the sensor, the noise
    and the
    spectrum of this pulse to 1 Hz, but not that beats repeat (Wiener 1949).
    """
    high = scipy.signal.butter(2, LOWEST, "highpass", fs=1000, output="sos")
    on_membrane = covered_force(contact, sensor)[:, point]
    frequency, power = scipy.signal.periodogram(scipy.signal.sosfiltfilt(high, on_membrane)[INSIDE], 1000, "hann")
    power = np.convolve(power, np.full(width := round(1 / frequency[1]), 1 / width), "same")
    band = (frequency >= LOWEST) & (frequency <= 100)
    forced = sensor.force_response
    assert forced is not None
    assert sensor.own_noise is not None
    h = interpolated(forced[point], sensor.frequency, frequency[band])
    _, passed = scipy.signal.freqz_sos(high, frequency[band], fs=1000)
    noise = sensor.own_noise.power
    noise = np.interp(frequency[band], np.arange(len(noise)), noise) * np.abs(passed) ** 4
    heard = power[band] * (np.abs(h) ** 2).sum(0)
    return float(10 * np.log10(power[band].sum() / (power[band] * noise / (noise + heard)).sum()))


def column(libraries: tuple[ArrayResponse, ...], sensors: tuple[ArrayResponse, ...]) -> list[str]:
    """Figures of sensors that are read with libraries, one for each or one for all."""
    readers = [localize.PulseReader(each, "design") for each in libraries]
    decoders = [PulseDecoder(each, "design") for each in libraries]
    others = [localize.BayesDecoder(each, "design") for each in libraries]
    frames: dict[int, list[bool]] = {1000: [], 2000: [], 8000: []}
    of_touches: list[bool] = []
    found: dict[str, list[bool]] = {name: [] for name in NAMES}
    ratios, best, errors, within = [], [], [], []
    recorders = [ContactRecorder(each, microphone_noise="design", seed=SEED) for each in sensors]
    for number in range(PULSES):
        response, reader, decoder, other = (each[number % len(each)] for each in (libraries, readers, decoders, others))
        point, rate = number % response.point_count, 50 + 50 * number / (PULSES - 1)
        assert response.position is not None
        contact = pulse_wave(tuple(response.position[point]), rate, SECONDS, seed=SEED, sample=number)
        take = recorders[number % len(recorders)].take(contact, number)
        heard = prepared(take.signals)
        for length, right in frames.items():
            for begin in range(1000, 9000 - length + 1, length):
                right.append(bool(decoder.named(heard[:, begin : begin + length]).argmax() == point))
                if length == 1000:
                    of_touches.append(bool(other.locate(heard[:, begin : begin + length]).argmax() == point))
        reading = reader.read(take.signals, point + 1)
        ratios.append(compared(reading.waveform, take.force)[0])
        best.append(left_by_noise(sensors[number % len(sensors)], contact, point))
        truth = pulse_times(rate, SECONDS, seed=SEED, sample=number)
        inside = (truth["percussion"] > 1) & (truth["dicrotic"] < 9)
        for name, times in truth.items():
            found[name] += [bool(np.nanmin(np.append(abs(reading.waves[name] - t), 9)) < FOUND) for t in times[inside]]
        beats, seen = truth["percussion"], reading.waves["percussion"]
        beats = beats[(beats > seen[0] - FOUND) & (beats < seen[-1] + FOUND)]
        errors.append(reading.rate - 60 / np.diff(beats).mean())
        within.append(abs(reading.rate - rate) < 2 * reading.rate_deviation)
    return [
        cell(of_touches),
        *(cell(right) for right in frames.values()),
        *(f"{np.min(each):.1f} / {np.mean(each):.1f}" for each in (ratios, best)),
        cell([each >= WANTED for each in ratios]),
        *(cell(right) for right in found.values()),
        f"{np.sqrt(np.mean(np.square(errors))):.2f} / {np.abs(errors).max():.2f}",
        cell(within),
    ]


def hearts(response: ArrayResponse) -> list[str]:
    """Rows of hearts of all shapes and rhythms, each with pulses at several rates, then of signals without a heart, and
    of real pulses.
    """
    reader = localize.PulseReader(response, "design")
    recorder = ContactRecorder(response, microphone_noise="design", seed=SEED)
    random = np.random.default_rng(SEED)
    assert response.position is not None
    places = [tuple(each) for each in response.position]
    lines = [
        "| signal | recordings | a pulse is found (%) | beats found within 40 ms (%) | tidal waves told a beat | "
        "dicrotic waves told a beat |",
        "|---|---|---|---|---|---|",
    ]

    def row(name: str, contacts: list[tuple[int, Contact]], truths: list[Array | None]) -> None:
        readings = [
            reader.read(recorder.take(contact, sample).signals, point + 1)
            for sample, (point, contact) in enumerate(contacts)
        ]
        right: list[bool] = []
        for reading, truth in zip(readings, truths, strict=True):
            if truth is not None and reading.found:
                right += [bool(abs(reading.waves["percussion"] - at).min() < FOUND) for at in truth]
        heard = [each for each in readings if each.found]
        told = [
            f"{np.concatenate([np.isfinite(each.waves[wave]) for each in heard]).mean():.2f}" if heard else ""
            for wave in NAMES[1:]
        ]
        lines.append(
            f"| {name} | {len(readings)} | {100 * len(heard) / len(readings):.0f} | "
            f"{f'{100 * np.mean(right):.1f}' if right else ''} | {' | '.join(told)} |"
        )

    for shape in WAVES:
        for rhythm in get_args(Rhythm):
            contacts, truths = [], []
            for sample in range(EACH):
                point, rate = int(random.integers(len(places))), 50 + 50 * sample / (EACH - 1)
                contacts.append(
                    (
                        point,
                        pulse_wave(places[point], rate, SECONDS, shape=shape, rhythm=rhythm, seed=SEED, sample=sample),
                    )
                )
                beats = pulse_times(rate, SECONDS, shape=shape, rhythm=rhythm, seed=SEED, sample=sample)["percussion"]
                truths.append(beats[(beats > 1) & (beats < SECONDS - 1)])
            row(f"{shape}, {rhythm}", contacts, truths)
    for name, force in (("a finger that rests, without a pulse", resting), ("nothing", silence), ("taps", tapped)):
        for seconds in (3.0, 10.0):
            points = random.integers(len(places), size=EACH).tolist()
            row(
                f"{name}, {seconds:g} s",
                [(point, at(places[point], force(random, round(1000 * seconds)))) for point in points],
                [None] * EACH,
            )
    lines += [
        "",
        "| recording | pieces of 10 s | a pulse is found (%) | rate within 5 % of that at which the recording is most "
        "like itself (% of these) | tidal waves told a beat | dicrotic waves told a beat |",
        "|---|---|---|---|---|---|",
    ]
    real = real_pulses(random)
    for name in sorted({each for each, _, _ in real}):
        pieces = [(force, rate) for each, force, rate in real if each == name]
        readings, rates = [], []
        for sample, (force, rate) in enumerate(pieces):
            point = int(random.integers(len(places)))
            reading = reader.read(recorder.take(at(places[point], force), sample).signals, point + 1)
            if reading.found:
                readings.append(reading)
                rates.append(abs(reading.rate / rate - 1) < 0.05)
        told = [np.concatenate([np.isfinite(each.waves[wave]) for each in readings]).mean() for wave in NAMES[1:]]
        lines.append(
            f"| {name} | {len(pieces)} | {100 * len(readings) / len(pieces):.0f} | {100 * np.mean(rates):.0f} | "
            f"{' | '.join(f'{each:.2f}' for each in told)} |"
        )
    return lines


def at(place: tuple[float, ...], force: Array) -> Contact:
    """A force of a fingertip at a place, (n,) N."""
    time = np.arange(len(force)) / 1000
    return Contact(time, np.tile(np.array(place), (len(time), 1)), force, 4.0, 0.0, "force")


def resting(random: np.random.Generator, count: int) -> Array:
    """Force of a finger that sways as :func:`localize.contacts.pulse_wave` has it, but has no pulse, N."""
    band = scipy.signal.butter(1, (0.1, 0.5), "bandpass", fs=1000, output="sos")
    sway = scipy.signal.sosfilt(band, random.standard_normal(count))
    sway *= np.exp(random.uniform(np.log(2e-6), np.log(50e-6))) / sway.std()
    return np.asarray(sway - sway.min())


def silence(random: np.random.Generator, count: int) -> Array:
    """Hardly any force, N."""
    return np.full(count, 1e-9)


def tapped(random: np.random.Generator, count: int) -> Array:
    """Taps at random times, of 30 uN to 10 mN, N."""
    time, force = np.arange(count) / 1000, np.zeros(count)
    for moment in random.uniform(0.3, time[-1] - 0.3, random.integers(2, max(3, count // 800))):
        width, height = random.uniform(0.01, 0.04), np.exp(random.uniform(np.log(3e-5), np.log(1e-2)))
        force += height * np.exp(-0.5 * ((time - moment) / width) ** 2)
    return force


def real_pulses(random: np.random.Generator) -> list[tuple[str, Array, float]]:
    """Pieces of 10 s of the three recordings of the package heartpy: name, force of 20 to 200 uN, and the
    rate, beats a minute, of the lag at which the recording is most like itself.

    They are photoplethysmograms, so volumes in place of forces. Nothing above 12 Hz is kept. The package is not
    imported, because its version of today needs a module that setuptools has dropped.
    """
    place = find_spec("heartpy")
    if place is None or place.origin is None:
        print("heartpy is not installed, so the table of real pulses is empty")
        return []
    low = scipy.signal.butter(4, 12, fs=1000, output="sos")
    slow = scipy.signal.butter(2, (0.7, 5.0), "bandpass", fs=1000, output="sos")
    time = np.arange(round(1000 * SECONDS)) / 1000
    found = []
    for name, rate in REAL.items():
        signal = np.loadtxt(Path(place.origin).parent / "data" / name, delimiter=",", usecols=-1, skiprows=1)
        count = round(SECONDS * rate)
        for first in range(0, len(signal) - count + 1, count):
            piece = np.interp(time, np.arange(count) / rate, signal[first : first + count])
            like = scipy.signal.correlate(beating := scipy.signal.sosfiltfilt(slow, piece), beating)[len(piece) :]
            line = 60_000 / (375 + int(like[375:1500].argmax()))
            force = scipy.signal.sosfiltfilt(low, piece)
            height = np.exp(random.uniform(np.log(20e-6), np.log(200e-6)))
            found.append((f"heartpy, {name}", height * (force - force.min()) / np.ptp(force), line))
    return found


def picture(response: ArrayResponse) -> None:
    """A force and what is read of it."""
    assert response.position is not None
    take = ContactRecorder(response, microphone_noise="design").take(
        pulse_wave(tuple(response.position[5]), 66.0, 8.0, seed=SEED)
    )
    reading = localize.PulseReader(response, "design").read(take.signals, 6)
    _, read, true = compared(reading.waveform, take.force)
    time = take.time[np.isfinite(reading.waveform)][INSIDE]
    with figure_in_style((WIDTH, 3.0)) as figure:
        axes = figure.subplots()
        axes.plot(time, 1e6 * true, label="force above 0.7 Hz", linewidth=2.5, alpha=0.4)
        axes.plot(time, 1e6 * read, label="read")
        for name, times in reading.waves.items():
            own = times[(times > time[0]) & (times < time[-1])]
            axes.plot(own, np.interp(own, time, 1e6 * read), "o", label=name, markersize=4)
        axes.set(xlabel="time  (s)", ylabel="force  (uN)")
        axes.legend(ncols=5, fontsize="small", loc="lower center", bbox_to_anchor=(0.5, 1.0))
        save_figure(figure, PICTURE)


def main() -> None:
    titles = [
        "point by the decoder of touches, 1 s, top-1 (%)",
        "point by the decoder of pulses, 1 s, top-1 (%)",
        "point by the decoder of pulses, 2 s, top-1 (%)",
        "point by the decoder of pulses, 8 s, top-1 (%)",
        "ratio of signal to error, smallest / mean (dB)",
        "ratio of signal to error of the best linear filter, smallest / mean (dB)",
        f"pulses of {WANTED:g} dB and more (%)",
        *(f"{name} wave found within {1000 * FOUND:.0f} ms (%)" for name in NAMES),
        "error of the heart rate between the first and the last beat found, rms / largest (beats per minute)",
        "heart rate from 10 s of signal, within two stated deviations (%)",
    ]
    heads, columns = [], []
    for name in DESIGNS:
        response = response_of(acoustic_fem.solve(geometry.prototype(name), FREQUENCY, "lumped"))
        made = made_sensors(response, name, SENSORS)
        for kind, libraries, sensors in (
            ("", (response,), (response,)),
            (", as-built", (response,), made),
            (", as-built, its own library", made, made),
        ):
            heads.append(name + kind)
            columns.append(column(libraries, sensors))
        if name == DESIGNS[0]:
            picture(response)
    lines = [f"| | {' | '.join(heads)} |", "|---" * (len(heads) + 1) + "|"]
    lines += [f"| {title} | {' | '.join(cells)} |" for title, *cells in zip(titles, *columns, strict=True)]
    print("\n".join(lines))
    replace_section(PAGE, BEGIN, END, lines)
    hearts_of = response_of(acoustic_fem.solve(geometry.prototype("glove"), FREQUENCY, "lumped"))
    lines = hearts(hearts_of)
    print("\n".join(lines))
    replace_section(PAGE, HEARTS, END_HEARTS, lines)


if __name__ == "__main__":
    main()
