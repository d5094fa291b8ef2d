"""A session with a virtual made sensor on disk: what reads it, that it comes again, and what is refused."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from refusals import refused
from small_run import small_design

import acoustic_fem
import studies
from geometry import Kind
from geometry.design.design_file import read_design
from localize.recordings.touch_manifest import read_touch_manifest
from studies.test_rig.rig_session import record_rig

RECORDER = studies.Recorder(seconds=20.0)
TOUCHES = studies.TouchSession(1, 4.0, ("random-1-100", "taps"))


@pytest.fixture(name="made", scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> studies.RigSession:
    folder = tmp_path_factory.mktemp("rig") / "bench"
    return record_rig(small_design(), folder, seed=3, recorder=RECORDER, session=TOUCHES, fidelity="lumped")


@pytest.mark.slow
def test_a_calibration_from_it_finds_the_made_sensor_and_its_touches(made: studies.RigSession, tmp_path: Path) -> None:
    assert made.calibration.parent.parent == made.touches.parent.parent == made.folder
    found = studies.calibrate_sensor(made.calibration.parent, tmp_path / "made.nc", fidelity="lumped")
    truth = acoustic_fem.load(made.library).transfer_function.values[..., :125]
    nominal = acoustic_fem.solve(small_design(), np.arange(1.0, 126.0), "lumped").transfer_function.values
    assert not found.calibration.missing
    error = [np.abs(h / truth - 1).mean() for h in (found.library.transfer_function.values, nominal)]
    assert error[0] < 0.03 < 0.06 < error[1]
    manifest = read_touch_manifest(made.touches, 3)
    assert manifest.full_scale == made.full_scale
    # The middle point of three is heard alike on both sides, as a sound is.
    for recording in manifest.recordings:
        heard = studies.locate_recording(tmp_path / "made.nc", recording.path, full_scale=made.full_scale)
        points = [touch.point for touch in heard.touches]
        assert recording.point == 2 or (points and set(points) == {recording.point})
        assert heard.assumptions.startswith("that the sensor is as its library describes it, in air of ")


def test_what_was_hidden_stands_beside(made: studies.RigSession) -> None:
    known = json.loads(made.truth.read_text(encoding="utf-8"))
    again = studies.Rig(small_design(), known["seed"], studies.HiddenScatter(**known["scatter"]), fidelity="lumped")
    assert known["parts"]["tube_radius"] == again.hidden.tube_radius[0].tolist()
    assert known["microphone_gain"] == {"A": pytest.approx(again.gain[0]), "B": pytest.approx(again.gain[1])}
    assert known["air"]["pressure"] == again.medium.pressure != 101325.0
    assert read_design(known["design"]) == small_design().completed()
    assert {"code_version", "created", "libraries"} <= known.keys()
    library = acoustic_fem.load(made.library)
    assert np.array_equal(library.transfer_function.values, again.transfer_function(library.frequency))
    assert library.provenance["seed"] == 3


def test_the_same_seed_gives_the_same_files_and_another_other_ones(made: studies.RigSession, tmp_path: Path) -> None:
    def bytes_of(folder: Path) -> dict[str, bytes]:
        return {path.name: path.read_bytes() for path in sorted(folder.rglob("*.wav"))}

    again = record_rig(small_design(), tmp_path, seed=3, recorder=RECORDER, session=TOUCHES, fidelity="lumped")
    assert bytes_of(again.folder) == bytes_of(made.folder)
    (again.touches.parent / "point-09-taps-1.wav").write_bytes(b"of an earlier one")
    other = record_rig(small_design(), tmp_path, seed=4, recorder=RECORDER, session=TOUCHES, fidelity="lumped")
    assert bytes_of(other.folder).keys() == bytes_of(made.folder).keys()
    assert not any(bytes_of(other.folder)[name] == content for name, content in bytes_of(made.folder).items())


def test_what_cannot_be_made_is_refused_before_anything_is_written(tmp_path: Path) -> None:
    (tmp_path / "others").mkdir()
    (tmp_path / "others" / "thesis.tex").write_text("mine")
    with refused(Kind.EXISTS, "out", file="others"):
        record_rig(small_design(), tmp_path / "others", fidelity="lumped")
    with refused(Kind.OUT_OF_RANGE, "seed", -1):
        record_rig(small_design(), tmp_path / "new", seed=-1, fidelity="lumped")
    box = small_design().with_values({"resonator.shape": "box"})
    with refused(Kind.OUT_OF_RANGE, "resonator.shape", "box"):
        record_rig(box, tmp_path / "new", fidelity="lumped")
    for settings, field, value in (
        (studies.HiddenScatter, "slope", 0.5),
        (studies.Recorder, "seconds", 3.0),
        (studies.TouchSession, "hysteresis", 2.0),
    ):
        with refused(Kind.OUT_OF_RANGE, field, value):
            settings(**{field: value})
    assert not (tmp_path / "new").exists()
