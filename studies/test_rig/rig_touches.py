"""Touches of the virtual rig's sensor as recordings, of the paper's four parts, with their manifest.

A finger is not a loudspeaker: its spectrum is not flat and differs from touch to touch, its force follows its movement
with hysteresis, and it presses slowly while it rubs. No decoder knows any of that.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import scipy.signal
import tomlkit

from acoustic_fem.sound.sound_file import write_wav
from geometry.ground.argument_checks import check_range
from geometry.ground.typed import Array
from geometry.ground.whole_files import write_text
from localize.live.stream_options import HIGH_PASS
from localize.recordings.touch_manifest import PARTS, Part
from studies.output.folders import check_folder, make_folder
from studies.test_rig.rig_motion import ACCELERATIONS, motion_of_rig, waved_hand, write_acceleration
from studies.test_rig.virtual_rig import LENGTHS, RIG_MARK, Recorder, Rig

MANIFEST = "touches.toml"
LEAK = 2.0
"""Frequency below which taps are not held, Hz."""
LOUDEST = 0.7
"""Peak in the cavity, as a share of full scale; no microphone hears more."""
SLOW = (0.8, 3.0)
"""Band in which a finger presses slowly, Hz; below it the rig's sensor hears nothing."""
_PURPOSE = 2
"""Stream of the random numbers, beside those of the rig's own recordings."""
_LEVEL = 0.3
"""Pressure in the cavity under random touches and friction, Pa rms."""


@dataclass(frozen=True)
class TouchSession:
    """Settings of touches that are recorded at a point. Random signals and friction are on for two seconds and off for
    one.
    """

    takes: int = 5
    """Number of recordings of each part."""
    seconds: float = 12.0
    """Length of each recording, s."""
    parts: tuple[Part, ...] = PARTS
    """Parts that are recorded."""
    tilt: float = 3.0
    """Deviation of the slope of the spectrum of random touches and friction about a flat one, one draw a take, dB per
    octave."""
    press: float = 0.1
    """Slow pressure of the finger under them, below 3 Hz, Pa rms."""
    hysteresis: float = 0.2
    """Play of every contact, a share of its rms: the pressure follows only what moves it by more than that."""
    motion: float = 0.0
    """Largest acceleration of the hand that wears the sensor and is waved along z while it is touched, m/s^2; 0: the
    sensor lies still. Each recording then has its acceleration beside it, as CSV."""

    def __post_init__(self) -> None:
        for name, high, unit in (
            ("tilt", 12.0, "dB"),
            ("press", 10.0, "Pa"),
            ("hysteresis", 1.0, ""),
            ("motion", ACCELERATIONS[1], "m/s2"),
        ):
            check_range(name, getattr(self, name), 0.0, high, unit)
        check_range("takes", self.takes, 1, 1000)
        check_range("seconds", self.seconds, *LENGTHS, "s")


def record_touches(
    rig: Rig, folder: Path, points: Sequence[int], session: TouchSession, recorder: Recorder | None = None
) -> Path:
    """Write a WAV file of the array's microphones for each take, and the manifest.

    Args:
        rig: the made sensor.
        folder: a new or empty folder, or one to which a rig recorded before.
        points: numbers of the points, from 1.
        session: what is recorded.
        recorder: how; the lengths and levels of the touches are those of the session.

    Returns:
        Path of the manifest.

    Raises:
        Refusal: a point that the design does not have, or a folder that holds recordings of others.
    """
    recorder = replace(recorder or Recorder(), seconds=session.seconds)
    for point in points:
        check_range("points", point, 1, rig.design.point_count)
    check_folder(folder, "rig", RIG_MARK)
    make_folder(folder, "rig", RIG_MARK)
    manifest = tomlkit.document()
    manifest["full_scale"] = recorder.full_scale
    manifest["output"] = recorder.output
    if recorder.output == "voltage":
        manifest["lowest"] = HIGH_PASS  # frames of a stream hold nothing below
    entries = tomlkit.aot()
    for point in points:
        for part in session.parts:
            for take in range(1, session.takes + 1):
                name = f"point-{point:02d}-{part}-{take}.wav"
                signals, moved = _take(rig, point, part, take, session, recorder)
                write_wav(folder / name, signals / recorder.full_scale, recorder.rate, recorder.bits)
                if moved is not None:
                    write_acceleration((folder / name).with_suffix(".csv"), moved, recorder.rate)
                entry = tomlkit.table()
                entry.update({"file": name, "point": point, "part": part})
                entries.append(entry)
    manifest["recordings"] = entries
    path = folder / MANIFEST
    write_text(path, tomlkit.dumps(manifest))
    return path


def _take(
    rig: Rig, point: int, part: Part, take: int, session: TouchSession, recorder: Recorder
) -> tuple[Array, Array | None]:
    """Signals, (n_microphone, n_sample) Pa, and acceleration, (3, n_sample) m/s^2, of a sensor that is waved."""
    key = (_PURPOSE, point, PARTS.index(part), take)
    random, of_contact = (
        np.random.default_rng(np.random.SeedSequence(rig.seed, spawn_key=each)) for each in (key, (*key, 1))
    )
    count = round(recorder.seconds * recorder.rate)
    total = count + 2 * recorder.rate  # what lies behind is silent, and keeps the end from running into the beginning
    pressure = np.zeros(total)
    pressure[:count] = _with_play(_pressure(part, count, session, recorder.rate, random, of_contact), session)
    # Whoever records sets the level so that nothing clips.
    pressure *= min(1.0, LOUDEST * recorder.full_scale / np.abs(pressure).max())
    waved = moved = None
    if session.motion:
        of_hand = np.random.default_rng(np.random.SeedSequence(rig.seed, spawn_key=(*key, 2)))
        moved = waved_hand(total / recorder.rate, of_hand, session.motion, rate=recorder.rate)
        waved = motion_of_rig(rig, moved, recorder.rate)
    signals = rig.recorded({point: np.fft.rfft(pressure)}, total, 0, count, recorder, random, waved)[1:]
    return signals, None if moved is None else moved[:, :count]


def _with_play(movement: Array, session: TouchSession) -> Array:
    """Pressure of a contact that follows its movement with hysteresis: the play operator (Krasnosel'skii 1989)."""
    reach = session.hysteresis * float(movement.std())
    if reach == 0:
        return movement
    held, followed = 0.0, []
    for low, high in zip((movement - reach).tolist(), (movement + reach).tolist(), strict=True):
        if held < low:
            held = low
        elif held > high:
            held = high
        followed.append(held)
    return np.array(followed)


def _pressure(
    part: Part,
    count: int,
    session: TouchSession,
    rate: int,
    random: np.random.Generator,
    of_contact: np.random.Generator,
) -> Array:
    """(count,) Pa in the touched cavity, as the contact moves."""
    time = np.arange(count) / rate
    if part == "taps":
        pressure = np.zeros(count)
        at = 0.5 + random.uniform(0.0, 0.3)
        while at < time[-1] - 0.5:
            width = np.exp(random.uniform(np.log(5e-3), np.log(0.1)))
            height = np.exp(random.uniform(np.log(0.1), np.log(3.0)))
            inside = (time >= at) & (time < at + width)
            pressure[inside] += height * np.sin(np.pi * (time[inside] - at) / width) ** 2
            at += random.uniform(0.5, 1.2)
        # The array does not hold a steady pressure; what lies below the rig's band would be cut off there at once, and
        # ring for seconds.
        leak = scipy.signal.butter(2, LEAK, "highpass", fs=rate, output="sos")
        return np.asarray(scipy.signal.sosfilt(leak, pressure))
    level: Array = np.full(count, _LEVEL)
    if part == "random-1-100":
        band = (1.0, 100.0)
    elif part == "random-1-10":
        band = (1.0, 10.0)
    else:
        band = (random.uniform(3.0, 30.0), random.uniform(60.0, 120.0))
        level = level * np.exp(0.5 * _noise(count, rate, (0.0, 4.0), random))
    on = scipy.signal.square(2 * np.pi * (time / 3 - random.uniform(0.0, 0.2)), duty=2 / 3) > 0
    ramp = np.hanning(rate // 20 + 2)[1:-1]
    tilt = session.tilt * float(np.clip(of_contact.standard_normal(), -3, 3))
    heard = level * _noise(count, rate, band, random, tilt) + session.press * _noise(count, rate, SLOW, of_contact)
    return np.asarray(heard * np.convolve(on, ramp / ramp.sum(), "same"))


def _noise(count: int, rate: int, band: tuple[float, float], random: np.random.Generator, tilt: float = 0.0) -> Array:
    """(count,) Gaussian noise of one rms within a band, Hz, whose spectrum slopes by ``tilt`` dB per octave."""
    spectrum = np.fft.rfft(random.standard_normal(count))
    grid = np.fft.rfftfreq(count, 1 / rate)
    spectrum[(grid < band[0]) | (grid > band[1])] = 0
    spectrum[1:] *= grid[1:] ** (tilt / (20 * np.log10(2)))
    signal = np.fft.irfft(spectrum, count)
    return np.asarray(signal / signal.std())
