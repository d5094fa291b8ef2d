"""The pulse under a finger: its point, waveform, waves and rate. ``python benchmarks/pulse.py`` prints the table of
docs/evidence/moving-touches.md and writes it there, in some minutes of one core.

Contacts come from :func:`localize.contacts.pulse_wave`: a finger on the middle of one point for 10 s, 50 to 100 beats a
minute. The fidelity is lumped, and the noise is that of the design's microphone. As-built sensors are virtual rigs,
which are decoded with the nominal library and with their own. No constant was chosen on these seeds. Constants were
chosen on seed 960 with sensors 960 to 965.
"""

from __future__ import annotations

from pathlib import Path

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
from localize.contacts.finger_gestures import WAVES
from localize.evaluation.accuracy import wilson_interval
from localize.recognition.pulse import PulseDecoder
from localize.recognition.takes import prepared
from localize.signals.array_response import ArrayResponse, response_of
from studies.output.figure_style import WIDTH, figure_in_style, save_figure

Array = NDArray[np.float64]

ROOT = Path(__file__).parents[1]
PAGE, PICTURE = ROOT / "docs" / "evidence" / "moving-touches.md", ROOT / "docs" / "images" / "pulse-waveform.png"
BEGIN, END = "<!-- pulse: made by benchmarks/pulse.py -->", "<!-- end pulse -->"
DESIGNS, SEED, PULSES, SECONDS, SENSORS = ("array-2x6", "glove"), 63, 240, 10.0, range(360, 372)
FREQUENCY = np.concatenate([np.arange(0.25, 20.0, 0.25), np.arange(20.0, 501.0)])
WANTED = 30.0
"""Signal over error that is aimed at, dB."""
FOUND = 0.04
"""Distance up to which a wave is found, s."""
LOWEST = 0.7
"""Frequency above which waveforms are compared, Hz."""
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
    found: dict[str, list[bool]] = {name: [] for name in WAVES}
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
        *(f"{name} wave found within {1000 * FOUND:.0f} ms (%)" for name in WAVES),
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


if __name__ == "__main__":
    main()
