"""The verb recalibrate."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from studies.cli.options import LibraryFile, Noise, display_on_stderr, named


def recalibrate(
    library: LibraryFile,
    recordings: Annotated[
        list[Path],
        typer.Argument(
            metavar="RECORDINGS",
            help="Touches that fill 1 to 100 Hz, one at a time, spread over all points: WAV with a channel per "
            "microphone; CSV with their names on top; NPZ with 'signals'.",
            show_default=False,
        ),
    ],
    out: Annotated[Path, typer.Option(help="The library to write, netCDF, a new file.", show_default=False)],
    full_scale: Annotated[
        float | None,
        typer.Option(
            help="Pa: of WAV files the pressure at full scale, of others that at which they clip.",
            show_default="1 Pa; flat tops",
        ),
    ] = None,
    noise: Noise = None,
    seed: Annotated[int, typer.Option(help="Of the choice of the touches that judge.", min=0)] = 0,
) -> None:
    """From touches of which nobody knows the points to the library of the sensor as it is now.

    LIBRARY is that of the design or the last calibration. Needed are touches that fill 1 to 100 Hz (multi-sines or
    noise; no taps and no friction), one at a time, in a quiet room, spread over all points: at least 100 frames of
    250 ms, better 200, and several per point. A quarter of them is held out and judges; where they do not speak for the
    sensor found, that is said with the reason, nothing is written, and LIBRARY stays what is best known.

    Example: [bold]acoustic-fem recalibrate made.nc monday.wav tuesday.wav --out now.nc[/bold]
    """
    from studies.output.folders import check_new_file, check_new_library

    check_new_library(out, (".nc",))
    check_new_file(out, kept="a calibrated library")
    import numpy as np
    import torch

    import acoustic_fem
    from localize import SelfCalibrationError, read_recording, self_calibrate
    from localize.recalibration.objections import numbers
    from localize.recalibration.self_calibration import touched
    from localize.recordings.same_take import find_same_take
    from localize.signals.array_response import response_of
    from localize.signals.frames import FRAME, cut_frames
    from localize.signals.noise import NoiseSpectrum

    present = acoustic_fem.load(library)
    response = response_of(present)
    with named(full_scale="--full-scale"):
        heard = [read_recording(path, response.microphones, full_scale).signals for path in recordings]
    frames = [cut_frames(torch.from_numpy(signals)[None])[0].numpy() for signals in heard]
    of_microphones = response.noise("design" if noise is None else noise)
    level = of_microphones.rms if isinstance(of_microphones, NoiseSpectrum) else of_microphones
    # a copy of what the search saw would judge it; the last frame ends with its recording
    first = [
        signals.shape[1] % FRAME + FRAME * np.flatnonzero(touched(own, level))
        for signals, own in zip(heard, frames, strict=True)
    ]
    loud = [number for number, own in enumerate(first) if len(own)]
    same = find_same_take([heard[number].astype(np.float32) for number in loud], [first[number] for number in loud])
    if same is not None:
        raise SelfCalibrationError(
            f"{recordings[loud[same.second]]} is the same take as {recordings[loud[same.first]]}: the correlation of a "
            f"stretch of them is {same.correlation:.4f}; give each take once"
        )
    with display_on_stderr() as display, display.stage("Touches") as report, named(microphone_noise="--noise"):
        found = self_calibrate(present, np.concatenate(frames), level, seed=seed, progress=report)
    if not found.accepted:
        raise SelfCalibrationError(f"refused, {out} is not written and {library} stays: {found.objection}")
    acoustic_fem.save(found.library(), out)
    print(
        f"{out}: from {found.frames} frames with touches; {found.gain:.2f} +- {found.gain_error:.2f} nats per held-out "
        f"frame likelier than with {library}, {100 * found.explained:.0f} % of them explained"
    )
    if len(found.untouched):
        print(f"no touch was named point {numbers(found.untouched)}: least known; touch it next time")
