"""Contacts that move over the virtual rig's sensor as recordings, with what is true of them beside."""

from __future__ import annotations

import csv
import io
import os
from pathlib import Path

import numpy as np
import scipy.signal
from numpy.typing import NDArray

from acoustic_fem.library.solving import solve
from acoustic_fem.numerics.frequency_splines import interpolated
from acoustic_fem.sound.sound_file import write_wav
from geometry.ground.whole_files import write_text
from localize.contacts import Contact, LargePresses, covered_force
from localize.signals.array_response import response_of
from studies.output.folders import check_new_file
from studies.test_rig.rig_touches import LEAK
from studies.test_rig.virtual_rig import EXCITATION_BAND, HEARD, LENGTHS, Recorder, Rig

#: Columns of the file of what is true.
COLUMNS = ("time_s", "x_mm", "y_mm", "force_N", "point")
#: Seconds between two rows of it: the hop of a stream.
STEP = 0.016
_PURPOSE = 4
"""Stream of the random numbers, beside those of the rig's other recordings."""


def record_contact(
    rig: Rig, contact: Contact, path: str | os.PathLike[str], recorder: Recorder | None = None, *, sample: int = 0
) -> Path:
    """Write what the microphones of a made sensor record of a contact, and beside it what is true of it.

    The pressure in a cavity for a force is as designed; its path to the microphones is the as-built sensor's.

    Args:
        rig: the made sensor.
        contact: what presses; the recording begins with it, ends with it, and lasts 4 s at least.
        path: of the recording, ``.wav``; the truth has its name with ``.csv``. Earlier ones are replaced.
        recorder: how; the length is that of the contact.
        sample: index of the recording: each has noise and roughness of its own.

    Returns:
        Path of the truth: a row every 16 ms with the middle of the contact, its force and the number of the point
        whose membrane takes most of it, 0 where none is pressed.

    Raises:
        Refusal: a file that cannot be written.
    """
    wav = Path(path)
    truth = wav.with_suffix(".csv")
    check_new_file(wav, ".wav")
    check_new_file(truth, ".csv")
    recorder = recorder or Recorder()
    count = round(max(contact.seconds, LENGTHS[0]) * recorder.rate) + 1
    time = contact.time[0] + np.arange(count) / recorder.rate
    heard = contact.at(time).roughened(rig.seed, "evaluation", sample)
    nominal = response_of(solve(rig.design, np.geomspace(*HEARD, 150), "lumped"))
    pressed = covered_force(heard, nominal)
    total = count + 2 * recorder.rate  # silence keeps the end from running into the beginning
    grid = np.fft.rfftfreq(total, 1 / recorder.rate).astype(np.float64)
    displacing = LargePresses(nominal, recorder.rate).light_forces(pressed)
    inside = (grid >= EXCITATION_BAND[0]) & (grid <= EXCITATION_BAND[1])
    assert nominal.cavity_response is not None
    cavity = interpolated(nominal.cavity_response, nominal.frequency, grid[inside])
    leak = scipy.signal.butter(2, LEAK, "highpass", fs=recorder.rate, output="sos")
    drives = {}
    for point in np.flatnonzero(pressed.any(axis=0)):
        drive = np.zeros(len(grid), np.complex128)
        drive[inside] = np.fft.rfft(scipy.signal.sosfilt(leak, displacing[:, point]), total)[inside] * cavity[point]
        drives[int(point) + 1] = drive
    random = np.random.default_rng(np.random.SeedSequence(rig.seed, spawn_key=(_PURPOSE, sample)))
    signals = rig.recorded(drives or {1: np.zeros(len(grid), np.complex128)}, total, 0, count, recorder, random)[1:]
    write_wav(wav, signals / recorder.full_scale, recorder.rate, recorder.bits)
    _write_truth(truth, heard, pressed, round(STEP * recorder.rate))
    return truth


def _write_truth(path: Path, heard: Contact, pressed: NDArray[np.float64], step: int) -> None:
    """The table of what is true."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    loudest = np.where(pressed.any(axis=1), pressed.argmax(axis=1) + 1, 0)
    for k in range(0, len(heard.time), step):
        x, y = heard.path[k]
        since = heard.time[k] - heard.time[0]
        writer.writerow((f"{since:.3f}", f"{x:.2f}", f"{y:.2f}", f"{heard.force[k]:.3g}", int(loudest[k])))
    write_text(path, text.getvalue())
