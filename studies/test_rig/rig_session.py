"""A whole session with a virtual made sensor, on disk: calibration, touches with their points, and what was hidden."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np

import acoustic_fem
from acoustic_fem.library.exchange import write_library
from acoustic_fem.library.provenance import versions
from acoustic_fem.library.transfer_functions import described, measured_library
from acoustic_fem.quantities.checks import frequency_grid
from acoustic_fem.quantities.fidelity import ONE_DESIGN
from geometry.design.design_file import DesignLike, write_design
from geometry.ground.shown import Shown
from geometry.ground.typed import PathLike
from studies.output.call_defaults import MANIFEST, SEED, TAKE_SECONDS, TAKES
from studies.output.display import Display
from studies.output.folders import check_folder, claimed_folder, make_folder, replaced_folder, write_json
from studies.test_rig.rig_motion import record_motion, waved_hand
from studies.test_rig.rig_touches import TouchSession, record_touches
from studies.test_rig.virtual_rig import RIG_MARK, HiddenScatter, Recorder, Rig

#: What lies in the folder of a session.
CALIBRATION, TOUCHES, MOTION, TRUTH, TRUE_LIBRARY = "calibration", "touches", "motion", "truth.json", "truth.nc"
#: Seconds of each recording for the calibration.
SECONDS = 30.0
#: Name of the recording of the waved sensor, and its length, s.
_WAVED, WAVED_SECONDS = "waved.wav", 30.0
#: Stream of the random numbers of its motion, beside those of the rig's other recordings.
_WAVES = 7
#: Frequencies of the true library: FIRST:LAST:COUNT in Hz.
TRUE_FREQUENCIES = "1:150:150"


@dataclass(frozen=True, eq=False, repr=False)
class RigSession(Shown):
    """Files of a session with a virtual rig."""

    folder: Path
    """Folder of all that was written."""
    rig: Rig
    """The made sensor, whose parameters are hidden from whoever has the recordings alone."""
    calibration: Path
    """Manifest of the calibration, for :func:`studies.calibrate_sensor`."""
    touches: Path
    """Manifest of the touches with their points and parts, for :func:`studies.train_localizer`; each file of it is one
    for :func:`studies.locate_recording` and :func:`studies.recalibrate`."""
    truth: Path
    """Hidden truth: parameters, seed, versions and design, JSON."""
    library: Path
    """Library of the sensor as it is, which a perfect calibration would find."""
    full_scale: float
    """Pressure at full scale of the touches' files, Pa."""
    waved: Path | None = None
    """Recording of the waved sensor that nobody touches, with its acceleration beside it as CSV; None if it lies
    still."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        return f"Session of a virtual rig of {self.rig.design.name}", {
            "calibration": self.calibration,
            "touches": self.touches,
            "full scale of the touches": f"{self.full_scale:.4g} Pa",
            "waved without a touch": "" if self.waved is None else self.waved,
            "hidden truth": self.truth,
            "library": self.library,
        }


def record_rig(
    design: DesignLike,
    out: PathLike,
    *,
    seed: int = SEED,
    fidelity: str = ONE_DESIGN,
    scatter: HiddenScatter | None = None,
    recorder: Recorder | None = None,
    session: TouchSession | None = None,
    display: Display | None = None,
) -> RigSession:
    """Recordings of a virtual rig: a calibration of all points, touches of each point, and the hidden parameters.

    The sensor deviates from the design in ways that no fit and no decoder is given (:class:`studies.HiddenScatter`).
    The same holds for the recordings (:class:`studies.Recorder`) and the touches (:class:`studies.TouchSession`). The
    same seed gives the same files.

    Args:
        design: the nominal array: a design, the path of its file, or the name of a prototype.
        out: a new or empty folder, or one of an earlier session.
        seed: seed of the hidden parameters and of all recordings.
        fidelity: fidelity of the transfer functions of the nominal design, see :func:`acoustic_fem.solve`.
        scatter: standard deviations of the hidden parameters.
        recorder: settings of the recordings; by default 30 s for each point of the calibration.
        session: settings of the touches; by default two takes of 6 s of each part.
        display: shows progress.

    Raises:
        Refusal: a negative seed, a design for which scatter cannot be computed, or a folder that holds anything else or
            cannot be written.
    """
    folder, show = Path(out), display or Display()
    check_folder(folder, "rig", RIG_MARK)
    rig = Rig(design, seed, scatter, fidelity)
    design = rig.design
    recorder = recorder or Recorder(seconds=SECONDS)
    session = session or TouchSession(TAKES, TAKE_SECONDS)
    stages = 3 + bool(session.motion)
    with claimed_folder(folder, "rig", RIG_MARK):
        make_folder(folder, "rig", RIG_MARK)
        points = range(1, design.point_count + 1)
        with show.stage("Calibration", of=stages), replaced_folder(folder / CALIBRATION) as fresh:
            calibration = rig.record(fresh, points, recorder).name
        with show.stage("Touches", of=stages), replaced_folder(folder / TOUCHES) as fresh:
            touches = record_touches(rig, fresh, points, session, recorder).name
        if session.motion:
            with show.stage("Motion", of=stages), replaced_folder(folder / MOTION) as fresh:
                random = np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(_WAVES,)))
                moved = waved_hand(WAVED_SECONDS, random, session.motion, rate=recorder.rate)
                record_motion(rig, moved, fresh / _WAVED, recorder)
        with show.stage("Truth", of=stages):
            library = _write_truth(rig, folder, recorder, session)
        manifests = folder / CALIBRATION / calibration, folder / TOUCHES / touches
    waved = folder / MOTION / _WAVED if session.motion else None
    return RigSession(folder, rig, *manifests, folder / TRUTH, library, recorder.full_scale, waved)


def hidden_values(rig: Rig) -> dict[str, Any]:
    """Hidden truth of an as-built sensor, as JSON can hold it: parts, microphones, and the air of the place.

    Args:
        rig: the made sensor.

    Returns:
        Numbers of every part by the fields of :class:`acoustic_fem.batch.ArrayParameters`, SI; gains and high-passes by
        the names of the microphones, against nominal; the air by the fields of :class:`acoustic_fem.Medium`, and its
        static pressure above that outside, Pa.
    """
    parts = {field.name: getattr(rig.hidden, field.name)[0].tolist() for field in fields(rig.hidden)}
    names = rig.design.microphones
    return {
        "parts": parts,
        "microphone_gain": dict(zip(names, rig.gain.tolist(), strict=True)),
        "microphone_corner": dict(zip(names, rig.corner.tolist(), strict=True)),
        "air": asdict(rig.medium),
        "overpressure": rig.overpressure,
    }


def _write_truth(rig: Rig, folder: Path, recorder: Recorder, session: TouchSession) -> Path:
    """The library of the sensor as it is, and the file of all that is hidden."""
    settings = {"scatter": asdict(rig.scatter), "recorder": asdict(recorder), "session": asdict(session)}
    made = {**versions(rig.seed, ("numpy", "scipy")), "fidelity": rig.fidelity}
    grid = frequency_grid(TRUE_FREQUENCIES)
    nominal = acoustic_fem.solve(rig.design, grid, rig.fidelity)
    h = rig.transfer_function(grid)
    about = {"seed": rig.seed, "rig": settings, "model": described(nominal)}
    library = measured_library(rig.design, nominal, h, np.zeros(h.shape), ("numpy", "scipy"), about)
    write_library(library, folder / TRUE_LIBRARY)
    calibrated = {"manifest": f"{CALIBRATION}/{MANIFEST}", "touches": TOUCHES, "library": TRUE_LIBRARY}
    design = write_design(rig.design.completed())
    write_json(folder / TRUTH, {**made, **settings, **hidden_values(rig), "files": calibrated, "design": design})
    return folder / TRUE_LIBRARY
