"""Contacts that move over the virtual rig's sensor as recordings, with what is true of them beside."""

from __future__ import annotations

import csv
import io
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from acoustic_fem.library.solving import solve
from acoustic_fem.sound.sound_file import write_wav
from geometry.ground.whole_files import write_text
from localize.contacts import Contact, ContactRecorder, covered_force
from localize.signals.array_response import ArrayResponse, response_of
from studies.output.folders import check_new_file
from studies.test_rig.virtual_rig import HEARD, LENGTHS, Recorder, Rig

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
    response = made_response(rig)
    pressed = covered_force(heard, response)
    pressures = ContactRecorder(response, recorder.rate, microphone_noise=0.0).take(heard).signals
    random = np.random.default_rng(np.random.SeedSequence(rig.seed, spawn_key=(_PURPOSE, sample)))
    # silence keeps the end from running into the beginning
    padded = np.pad(pressures, ((0, 0), (0, 2 * recorder.rate)))
    signals = rig.recorded({}, padded.shape[1], 0, count, recorder, random, padded)[1:]
    write_wav(wav, signals / recorder.full_scale, recorder.rate, recorder.bits)
    _write_truth(truth, heard, pressed, round(STEP * recorder.rate))
    return truth


def made_response(rig: Rig) -> ArrayResponse:
    """Response of the sensor as it was made to contacts: its own transfer functions, the cavities as designed.

    Args:
        rig: the made sensor.
    """
    grid = np.geomspace(*HEARD, 150)
    nominal = response_of(solve(rig.design, grid, "lumped"))
    return replace(nominal, transfer_function=rig.transfer_function(grid), ambient_response=None)


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
