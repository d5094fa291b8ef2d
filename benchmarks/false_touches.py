"""Touches that a stream reports while nobody touches the sensor, in noise, hum and recorded sound.

``python benchmarks/false_touches.py FOLDER`` plays every WAV file of a folder, and seven sounds that need none, for a
minute each to the sensor as designed and to an as-built one of ``streams.py``, and prints the reports. Some five
minutes of one core. The page's recordings are those of the packages pygame 2.6.1 (``examples/data``) and simpleaudio
1.0.4 (``test_audio``): doors, blows, music, notes and speech.

A recording is repeated with a pause of half a second. The sound pressure level is that of its part below 500 Hz, which
is all that a stream receives, and above 20 Hz. The decoder is the tolerance-aware one with the library of the design.
Noise, hum and sound are not configured. Sensors begin at seed ``FIRST``, on which nothing was chosen.

``--slow`` takes sound below 20 Hz instead, closing doors and wind, and prints a table of the reports in a minute: as
the sensor lies, and with ``--motion 5``, which recognises what reaches all microphones alike.
"""

from __future__ import annotations

import argparse
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import scipy.signal
import soundfile
from scipy.interpolate import make_interp_spline
from streams import FREQUENCY, MINUTE, RATE, Array, Sensor, told

import acoustic_fem
import geometry
import localize
from studies.test_rig import closing_doors, gusts

DESIGN, FIRST, LEVEL = "array-2x6", 6500, 70.0
PAUSE = RATE // 2
#: Pressures of sound below 20 Hz, Pa.
SLOW = (0.1, 1.0, 10.0)
#: Lowest frequency of a sound, Hz: what a recording has below it is an offset of its zero, or no sound to the decoder.
LOWEST = 20.0
Sound = tuple[str, Array]


def recorded(path: Path, level: float = LEVEL) -> Array:
    """(MINUTE,) Pa of a recording that is repeated, at a level in dB SPL."""
    signal, rate = soundfile.read(path, always_2d=True)
    common = int(np.gcd(rate, RATE))
    once = scipy.signal.resample_poly(signal.mean(1), RATE // common, rate // common)
    once = np.concatenate([once - once.mean(), np.zeros(PAUSE)])
    once = scipy.signal.sosfilt(scipy.signal.butter(4, LOWEST, "highpass", fs=RATE, output="sos"), once)
    return loud(np.resize(once, MINUTE), level)


def loud(pressure: Array, level: float) -> Array:
    """A pressure at a level, dB SPL."""
    return np.asarray(pressure * 20e-6 * 10 ** (level / 20) / pressure.std())


def sounds(sensor: Sensor, folder: Path) -> Iterator[Sound]:
    """Names, and what is added to the noise of the microphones, (n_microphone, MINUTE) Pa."""
    random = np.random.default_rng([sensor.seed, 11])
    count, time = len(sensor.design.microphones), np.arange(MINUTE) / RATE
    yield "noise of the microphones", np.zeros((count, MINUTE))
    yield "white noise of 3 mPa", 3e-3 * random.standard_normal((count, MINUTE))
    mains, phase = 50.0 + random.uniform(-0.05, 0.05), random.uniform(0, 2 * np.pi, (2, count, 1))
    turn = 2 * np.pi * mains * time
    yield "hum of 2.8 mPa", 2.8e-3 * (np.sin(turn + phase[0]) + np.sin(3 * turn + phase[1]) / 3)
    # The zero of a recorder wanders from second to second, as that of a virtual rig.
    walk = np.cumsum(random.standard_normal((count, MINUTE // RATE + 1)), axis=1)
    wander = make_interp_spline(np.arange(MINUTE // RATE + 1), walk / walk.std(1, keepdims=True), axis=1)(time)
    yield "wander of 10 mPa", 10e-3 * wander
    yield "pink sound of 60 dB", sensor.sound(60.0, random)
    yield "pink sound of 80 dB", sensor.sound(80.0, random)
    yield "moving sound of 70 dB", sensor.sound(70.0, random, moving=True)
    for path in sorted(folder.glob("*.wav")):
        yield f"{path.stem}, 70 dB", sensor.surrounded(recorded(path))


def print_slow(library: acoustic_fem.Library) -> None:
    """Print the touches that are reported in a minute of sound below 20 Hz, on the sensor as designed/as built."""
    sensors = [Sensor(library, number, FIRST, as_designed) for number, as_designed in enumerate((True, False))]
    sources: dict[str, tuple[Callable[[float, np.random.Generator, float, float], Array], float]]
    sources = {f"closing doors of up to {peak:g} Pa": (closing_doors, peak) for peak in SLOW}
    sources |= {f"wind of {SLOW[0]:g} Pa rms": (gusts, SLOW[0])}
    print("| sound | touches | touches with `--motion 5` |\n|---|---|---|")
    for number, (name, (made, level)) in enumerate(sources.items()):
        cells = []
        for motion in (None, 5.0):
            model = localize.open_model(library, motion=motion)
            found = []
            for sensor in sensors:
                random = np.random.default_rng([sensor.seed, 13, number])
                heard = sensor.surrounded(made(MINUTE / RATE, random, level, RATE)) + sensor.own_noise(MINUTE, random)
                found.append(len(localize.touches_of(model.stream().push(heard), model.locator)))
            cells.append("/".join(map(str, found)))
        print(f"| {name} | {' | '.join(cells)} |", flush=True)


def main() -> None:
    # Closed forms warn of tubes' entrances: sensors and libraries here are of the same forms.
    warnings.filterwarnings("ignore", "entrance loss", UserWarning)
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?", help="WAV files; none for --slow")
    parser.add_argument("--slow", action="store_true", help="sound below 20 Hz")
    parser.add_argument("--design", default=DESIGN)
    chosen = parser.parse_args()
    library = acoustic_fem.solve(geometry.prototype(chosen.design), FREQUENCY, "lumped")
    if chosen.slow:
        print_slow(library)
        return
    if chosen.folder is None:
        parser.error("give a folder of WAV files, or --slow")
    minutes, reports = 0, 0
    for number, as_designed in enumerate((True, False)):
        sensor = Sensor(library, number, FIRST, as_designed)
        for name, added in sounds(sensor, chosen.folder):
            noise = sensor.own_noise(MINUTE, np.random.default_rng([sensor.seed, 12, minutes]))
            found = told(library, noise + added)
            down = sum(event.kind == "down" for event in found.events)
            lit = sum(each.state == "touch" for each in found.decisions)
            minutes, reports = minutes + 1, reports + down
            print(f"{'as designed' if as_designed else 'as built'}, {name}: {down} touches, {lit} frames", flush=True)
    print(f"{reports} touches in {minutes} minutes", flush=True)


if __name__ == "__main__":
    main()
