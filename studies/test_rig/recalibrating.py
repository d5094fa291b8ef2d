"""From touches of which nobody knows the points to the library of a sensor as it is now."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import localize
from acoustic_fem import Library
from acoustic_fem.quantities.local_air import LocalAir, checked_air
from acoustic_fem.quantities.microphone_signals import Output
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Field, Kind
from geometry.ground.typed import PathLike
from localize import read_recording
from localize.decoders.bayes import BayesDecoder
from localize.diagnosis.bad_fits import fault_of_touches
from localize.evaluation.goodness_of_fit import FitOptions, loudest_frames, sensor_fit
from localize.live.front_end import HighPass
from localize.live.stream_options import HIGH_PASS
from localize.model.decoding import Decoding
from localize.recalibration.recalibration_options import RecalibrationOptions
from localize.recordings.same_take import find_same_take
from localize.signals.array_response import response_of
from localize.signals.frames import FRAME, cut_frames
from localize.signals.noise_model import NoiseChoice, NoiseSpectrum
from studies.output.call_defaults import RECALIBRATION_SECONDS, SEED
from studies.output.display import Display
from studies.output.folders import check_new_file, claimed_file

if TYPE_CHECKING:
    from localize import SelfCalibration


@dataclass(frozen=True, eq=False)
class Recalibration:
    """Result of a recalibration that was accepted."""

    out: Path
    """File that was written."""
    library: Library
    """Library that it holds, of the sensor as it is now."""
    found: SelfCalibration
    """Findings of the search on all touches and on those held out."""


def recalibrate(
    library: PathLike,
    recordings: Sequence[PathLike],
    out: PathLike,
    *,
    full_scale: float | None = None,
    microphone_noise: NoiseChoice = "design",
    seed: int = SEED,
    air: LocalAir | None = None,
    channels: Mapping[str, int] | None = None,
    microphone_output: Output = "pressure",
    lowest: float | None = None,
    seconds: float = RECALIBRATION_SECONDS,
    display: Display | None = None,
) -> Recalibration:
    """Recalibration of a sensor from touches whose points need not be known.

    A quarter of the frames is held out for validation. If they contradict the sensor found, nothing is written.

    Args:
        library: file of the design's library, or of the last calibration.
        recordings: files of touches of fingers or of a shaker, one at a time, spread over all points.
        out: the library to write, netCDF (``.nc``), a new file.
        full_scale: Pa, see :func:`localize.read_recording`.
        microphone_noise: white noise of the microphones, Pa rms over 0 to 500 Hz; by default the noise of the design's
            microphone.
        seed: seed of the choice of the held-out touches.
        air: air during the recordings, to which the library is converted first; values that you do not give are those
            of the library.
        channels: channel of each microphone in all recordings, counted from 1; by default found by the names of the
            channels or by their order.
        microphone_output: content of the recordings: ``pressure`` in front of the microphones, or ``voltage``, outputs
            of microphones that nobody has equalised.
        lowest: frequency down to which outputs are equalised to pressures, Hz; by default 1 Hz.
        seconds: processor time after which the search for the sensor ends, s. Nothing is written then, and the message
            says what was found.
        display: shows progress.

    Raises:
        Refusal: a file that exists or cannot be written, recordings that cannot be read or used, the same take twice,
            a microphone that is reversed, exchanged, late or at another level, a broken part, or held-out touches that
            contradict the sensor found.
    """
    checked_air(air)
    check_range("seconds", seconds, 1.0, unit="s")
    given = Decoding(microphone_output=microphone_output, lowest=lowest)
    path = Path(out)
    with claimed_file(path, partial(check_new_file, path, ".nc", kept="a calibrated library")):
        present = acoustic_fem.load(library)
        if air is not None:
            present = present.in_air(air)
        response = response_of(present)
        paths = [Path(recording) for recording in recordings]
        heard = [
            given.pressures(
                read_recording(recording, response.microphones, full_scale, channels=channels).signals, response.array
            )
            for recording in paths
        ]
        passed = [HighPass(len(signals), HIGH_PASS).begin(signals) for signals in heard]
        frames = [cut_frames(signals[None])[0] for signals in passed]
        of_microphones = response.noise(microphone_noise)
        level = of_microphones.rms if isinstance(of_microphones, NoiseSpectrum) else of_microphones
        _refuse_the_same_take(paths, heard, frames, level)
        _refuse_a_wrong_connection(passed, BayesDecoder(response, level))
        with (display or Display()).stage("Diagnosis"):
            _refuse_a_broken_sensor(present, heard, level)
        with (display or Display()).stage("Touches") as report:
            found = localize.self_calibrate(
                present, np.concatenate(frames), level, seed=seed, progress=report, high_pass=HIGH_PASS,
                options=RecalibrationOptions(seconds=seconds),
            )  # fmt: skip
        if not found.accepted:
            problem = f"give no calibration that holds: {found.objection}"
            remedy: str | tuple[str | Field, ...] = f"{path} is not written; {library} stays the best library known"
            if not found.finished:
                remedy = (f"{remedy}; give the search more time by ", Field("seconds"))
            raise localize.SelfCalibrationError(problem, kind=Kind.UNSUITABLE, field="recordings", remedy=remedy)
        calibrated = found.library()
        acoustic_fem.save(calibrated, path)
        return Recalibration(path, calibrated, found)


def _refuse_a_wrong_connection(signals: Sequence[NDArray[np.float64]], decoder: BayesDecoder) -> None:
    """Reject touches that a fault in how the microphones are connected explains: a search would fit it as a sensor.

    All recordings are checked together, with the loudest frames of each: at one point alone a sensor that has changed
    can look like one with a late microphone.
    """
    options = FitOptions()
    loud = [loudest_frames(own, RecalibrationOptions.quiet * decoder.noise_rms) for own in signals]
    spread = [own[rank] for rank in range(options.most) for own in loud if rank < len(own)][: options.most]
    fit = sensor_fit(decoder, spread, only_faults=True) if spread else None
    if fit is not None and fit.fault is not None:
        raise localize.SelfCalibrationError(
            f"give no calibration: {fit.warning}",
            kind=Kind.UNSUITABLE,
            field="recordings",
            remedy=("correct the wiring or the recordings, or give the right order by ", Field("channels")),
        )


def _refuse_a_broken_sensor(present: Library, signals: Sequence[NDArray[np.float64]], noise: float) -> None:
    """Reject touches that a broken part explains: a search within tolerances would not find such a sensor."""
    found = fault_of_touches(present, signals, noise)
    if found is not None:
        raise localize.SelfCalibrationError(
            f"give no calibration, because the sensor has a fault: {found.text}",
            kind=Kind.UNSUITABLE,
            field="recordings",
            remedy=found.to_do,
        )


def _refuse_the_same_take(
    paths: Sequence[Path],
    heard: Sequence[NDArray[np.float64]],
    frames: Sequence[NDArray[np.float64]],
    level: float,
) -> None:
    """Refuse copies of a take: one could be searched and the other validate the search."""
    # the last frame ends with its recording
    first = [
        signals.shape[1] % FRAME + FRAME * np.flatnonzero(localize.recalibration.touched(own, level))
        for signals, own in zip(heard, frames, strict=True)
    ]
    loud = [number for number, own in enumerate(first) if len(own)]
    same = find_same_take([heard[number].astype(np.float32) for number in loud], [first[number] for number in loud])
    if same is not None:
        first_of_two, second_of_two = paths[loud[same.first]], paths[loud[same.second]]
        problem = f"is the same take as {first_of_two}: the correlation of a section of them is {same.correlation:.4f}"
        raise localize.SelfCalibrationError(
            problem, kind=Kind.CONFLICT, file=second_of_two, remedy="give each take once"
        )
