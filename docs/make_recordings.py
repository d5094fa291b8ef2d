"""Make the example recordings of docs/examples/recordings, and the pictures of them: some ten seconds.

python docs/make_recordings.py

A virtual made sensor of array-2x6, seed 17, is calibrated at six of its points, tapped at all of them and stroked
along both rows. The seed was the first one tried, and no constant was chosen on it.
"""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np

import geometry
import studies
from localize.contacts import Tool, joined, press, stroke, tap
from localize.signals import response_of
from studies.test_rig import record_contact

DOCS = Path(__file__).parent
SEED = 17
#: Points that are recorded with a calibration microphone, for SECONDS each: a fit gives the others.
CALIBRATED, SECONDS = (1, 3, 5, 8, 10, 12), 20.0
#: All recordings are pressures, as if an equaliser had been applied, so that they can be read without options.
EQUALISED = studies.Recorder(seconds=SECONDS, output="pressure", reference_corner=0.0)
#: A light finger: mm, N, and how much its force fluctuates.
LIGHT = Tool("finger", (4.0, 6.0), (1e-3, 4e-3), (0.1, 0.3), 0.15)
#: Of the recordings of touches, Pa; and how fast the finger slides, mm/s.
FULL_SCALE, SPEED = 20.0, 45.0


def make(folder: Path) -> studies.TrackedRecording:
    """Write the set into a folder, anew, and give the path that is heard in it.

    Args:
        folder: for calibration, library, and recordings with their truth.
    """
    rig = studies.Rig(geometry.prototype("array-2x6"), SEED, fidelity="lumped")
    for old in (folder / "calibration", folder / "library.nc"):
        shutil.rmtree(old) if old.is_dir() else old.unlink(missing_ok=True)
    manifest = rig.record(folder / "calibration", CALIBRATED, EQUALISED)
    library = studies.calibrate_sensor(manifest, folder / "library.nc", fidelity="lumped").library
    (folder / "library.png").unlink()
    place = response_of(library).position
    touched = []
    for number, point in enumerate(np.random.default_rng(SEED).permutation(len(place)).tolist()):
        each = {"tool": LIGHT, "seed": SEED, "sample": point}
        at = tuple(place[point])
        touched.append(press(at, 0.15, **each) if number % 3 == 2 else tap(at, **each))
    recorder = replace(EQUALISED, full_scale=FULL_SCALE)
    record_contact(rig, joined(touched, "taps"), folder / "touches.wav", recorder)
    along = stroke(place[[0, 5, 6, 11]], SPEED, LIGHT, seed=SEED)
    record_contact(rig, along, folder / "slide.wav", recorder, sample=1)
    library, images = folder / "library.nc", DOCS / "images"
    touches = images / "example-touches.png"
    studies.locate_recording(library, folder / "touches.wav", picture=touches, full_scale=FULL_SCALE)
    path = images / "example-path.png"
    return studies.track_recording(library, folder / "slide.wav", picture=path, full_scale=FULL_SCALE)


if __name__ == "__main__":
    found = make(DOCS / "examples" / "recordings")
    print([gesture.kind for gesture in found.gestures])
