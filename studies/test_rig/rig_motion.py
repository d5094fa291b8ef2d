"""The virtual rig's sensor while it is moved: a waved hand and knocks on the table, and what it records of them."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np

import acoustic_fem
from acoustic_fem.batch.network import batch_response
from acoustic_fem.batch.parameters import ArrayParameters
from acoustic_fem.batch.topology import Topology
from acoustic_fem.library.acceleration import areal_mass
from acoustic_fem.library.touch_pressure import membranes_in_vacuo
from acoustic_fem.sound.sound_file import TIME, write_wav
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray
from geometry.ground.whole_files import write_text
from geometry.layout.arrangement import lay_out
from localize.recordings.accelerometer import COLUMNS
from localize.signals.motion import KNOCKED, WAVED, pressures_of_motion
from studies.output.folders import check_new_file
from studies.test_rig.virtual_rig import HEARD, Recorder, Rig

#: Range of accelerations, m/s^2.
ACCELERATIONS = (0.0, 200.0)
#: Shortest and longest stroke of a waved hand, and pause behind it, s. Assumed.
_STROKE, _PAUSE = (0.25, 0.7), (0.0, 0.4)
#: Tremor of a hand that is held out: fraction of the largest acceleration, and its band, Hz. Assumed.
_TREMOR, _TREMOR_BAND = 0.02, (8.0, 12.0)
#: Length of the blow of a knuckle, s; frequency (Hz) and decay (s) with which the table rings. Assumed.
_BLOW, _TABLE, _DECAY = 5e-3, 60.0, 0.05
_PURPOSE = 6
"""Stream of the random numbers, beside those of the rig's other recordings."""


def waved_hand(
    seconds: float,
    random: np.random.Generator,
    largest: float = WAVED,
    direction: Sequence[float] = (0.0, 0.0, 1.0),
    rate: float = 1000.0,
) -> Array:
    """Acceleration of a hand that goes to and fro, with pauses and tremor.

    Each stroke has the least jerk that takes the hand from rest to rest: with t from 0 to 1 over the stroke, the
    acceleration is proportional to 60 t - 180 t^2 + 120 t^3 (T. Flash and N. Hogan, J. Neurosci. 5 (1985) 1688). The
    lengths of strokes and pauses, and the tremor, are assumed.

    Args:
        seconds: length, s.
        random: draws strokes and tremor.
        largest: largest acceleration of the quickest stroke, 0 to 200 m/s^2.
        direction: in which the hand goes, of any length, (3,).
        rate: sample rate, Hz.

    Returns:
        (3, n_sample) float64, m/s^2, gravity left out.

    Raises:
        Refusal: an acceleration out of range, or a direction of length 0.
    """
    check_range("largest", largest, *ACCELERATIONS, "m/s2")
    count = round(seconds * rate)
    time, moved = np.arange(count) / rate, np.zeros(count)
    at, sign = random.uniform(*_PAUSE), 1.0
    while at < seconds:
        length = random.uniform(*_STROKE)
        inside = (time >= at) & (time < at + length)
        t = (time[inside] - at) / length
        # of one amplitude, the acceleration goes with 1 / length^2; 10 / sqrt(3) is the peak of the polynomial
        peak = largest * (_STROKE[0] / length) ** 2
        moved[inside] += sign * peak * (60 * t - 180 * t**2 + 120 * t**3) * np.sqrt(3) / 10
        at, sign = at + length + random.uniform(*_PAUSE), -sign
    spectrum = np.fft.rfft(random.standard_normal(count))
    grid = np.fft.rfftfreq(count, 1 / rate)
    spectrum[(grid < _TREMOR_BAND[0]) | (grid > _TREMOR_BAND[1])] = 0
    tremor = np.fft.irfft(spectrum, count)
    moved += _TREMOR * largest * tremor / max(float(np.abs(tremor).max()), 1e-300)
    return _along(direction)[:, None] * moved


def table_knocks(
    seconds: float,
    random: np.random.Generator,
    largest: float = KNOCKED,
    direction: Sequence[float] = (0.0, 0.0, 1.0),
    rate: float = 1000.0,
) -> Array:
    """Acceleration of a table on which somebody knocks about once a second: a blow, and the table that rings.

    All figures are assumed.

    Args:
        seconds: length, s.
        random: draws times and strengths of the knocks.
        largest: largest acceleration of the strongest knock, 0 to 200 m/s^2.
        direction: in which the table goes, of any length, (3,).
        rate: sample rate, Hz.

    Returns:
        (3, n_sample) float64, m/s^2, gravity left out.

    Raises:
        Refusal: an acceleration out of range, or a direction of length 0.
    """
    check_range("largest", largest, *ACCELERATIONS, "m/s2")
    count = round(seconds * rate)
    time, moved = np.arange(count) / rate, np.zeros(count)
    at = random.uniform(0.2, 0.6)
    while at < seconds:
        since = time - at
        blow = np.where((since >= 0) & (since < _BLOW), np.sin(np.pi * np.clip(since / _BLOW, 0, 1)), 0.0)
        behind = np.maximum(since, 0.0)
        ring = np.where(since >= 0, np.sin(2 * np.pi * _TABLE * behind) * np.exp(-behind / _DECAY), 0.0)
        moved -= largest * random.uniform(0.3, 1.0) * (blow + 0.3 * ring) / 1.3
        at += random.uniform(0.8, 1.4)
    return _along(direction)[:, None] * moved


def made_acceleration_response(rig: Rig) -> tuple[ComplexArray, Array]:
    """Pressure at the microphones of a made sensor per acceleration of it along x, y and z of the layout.

    The inertia of each membrane is a pressure on it, as of
    :func:`acoustic_fem.library.acceleration.acceleration_response`; the mass is as designed, compliances, tubes,
    gains and high-passes are those of the made sensor.

    Args:
        rig: the made sensor, with flat membranes.

    Returns:
        (n_microphone, 3, n_freq) complex128, Pa s2/m, and frequencies, (n_freq,) float64, Hz.

    Raises:
        Refusal: a membrane that is not flat.
    """
    design, grid = rig.design, np.geomspace(*HEARD, 150)
    mass = areal_mass(design)
    found = batch_response(rig.hidden, rig.topology, grid, rig.medium)
    # what a fit of transfer functions sees of microphones and fidelity counts here too
    seen = rig.transfer_function(grid) / np.asarray(found.transfer_function)[0]
    rubber = acoustic_fem.membrane.design_rubber(design)
    vacuum = membranes_in_vacuo(
        design, lambda alike: acoustic_fem.membrane.design_disc(alike).response(grid, rubber)
    ).volume_per_pressure
    nominal = ArrayParameters.from_design(design).individual(Topology.of(design))
    softer = rig.hidden.membrane_compliance[0] / nominal.membrane_compliance[0]
    flow = 2j * np.pi * grid * vacuum * softer[:, None]
    layout = lay_out(design)
    normals = np.array([layout.frame(point).axes[2] for point in layout.points], dtype=np.float64)
    pressed = np.asarray(found.source_response)[0] * seen * flow[:, None]
    return np.einsum("pmf,pa->maf", pressed, mass[:, None] * normals), grid


def motion_of_rig(rig: Rig, acceleration: Array, rate: float = 1000.0) -> Array:
    """Pressures in front of the microphones of a made sensor that is moved and not touched.

    Args:
        rig: the made sensor, with flat membranes.
        acceleration: along x, y and z of the layout, gravity left out, (3, n_sample) float64, m/s^2.
        rate: sample rate, Hz.

    Returns:
        (n_microphone, n_sample) float64, Pa, with the gains and high-passes of :meth:`Rig.transfer_function`.

    Raises:
        Refusal: a membrane that is not flat, or an acceleration of another shape.
    """
    return pressures_of_motion(*made_acceleration_response(rig), acceleration, rate)


def record_motion(
    rig: Rig, acceleration: Array, path: str | os.PathLike[str], recorder: Recorder | None = None, *, sample: int = 0
) -> Path:
    """Write what the microphones of a made sensor record while it is moved, and the acceleration beside it.

    Args:
        rig: the made sensor, with flat membranes.
        acceleration: along x, y and z of the layout, gravity left out, (3, n_sample) float64, m/s^2, at the rate of
            the recorder.
        path: of the recording, ``.wav``; the acceleration has its name with ``.csv``. Earlier ones are replaced.
        recorder: how; the length is that of the acceleration.
        sample: index of the recording: each has noise of its own.

    Returns:
        Path of the acceleration: a row for each sample, as an accelerometer on the housing gives it.

    Raises:
        Refusal: a file that cannot be written; as :func:`motion_of_rig`.
    """
    wav = Path(path)
    beside = wav.with_suffix(".csv")
    check_new_file(wav, ".wav")
    check_new_file(beside, ".csv")
    recorder = recorder or Recorder()
    pressures = motion_of_rig(rig, acceleration, recorder.rate)
    random = np.random.default_rng(np.random.SeedSequence(rig.seed, spawn_key=(_PURPOSE, sample)))
    padded = np.pad(pressures, ((0, 0), (0, 2 * recorder.rate)))
    count = pressures.shape[1]
    signals = rig.recorded({}, padded.shape[1], 0, count, recorder, random, padded)[1:]
    write_wav(wav, signals / recorder.full_scale, recorder.rate, recorder.bits)
    write_acceleration(beside, acceleration, recorder.rate)
    return beside


def write_acceleration(path: Path, acceleration: Array, rate: float) -> None:
    """Write the file that an accelerometer on the housing gives, as ``locate --acceleration`` reads it.

    Args:
        path: of the file, ``.csv``.
        acceleration: along x, y and z of the layout, gravity left out, (3, n_sample) float64, m/s^2.
        rate: sample rate, Hz.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow((TIME, *COLUMNS))
    for k, row in enumerate(np.asarray(acceleration).T.tolist()):
        writer.writerow((f"{k / rate:.9g}", *(f"{value:.5g}" for value in row)))
    write_text(path, text.getvalue())


def _along(direction: Sequence[float]) -> Array:
    """(3,) float64 of length 1."""
    given = np.asarray(direction, np.float64)
    length = float(np.linalg.norm(given)) if given.shape == (3,) else 0.0
    if not (np.isfinite(length) and length > 0):
        raise Refusal(
            kind=Kind.OUT_OF_RANGE, field="direction", value=given.tolist(), allowed="three numbers, not all 0"
        )
    return np.asarray(given / length)
