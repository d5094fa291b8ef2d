"""Where a part of a sensor is broken, calibrations and locate name it instead of a misfit."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import acoustic_fem
import geometry
import studies
from acoustic_fem.sound.sound_file import write_wav
from geometry import Refusal
from localize.diagnosis import SensorFault
from studies.test_rig.faulty_rig import FaultyRig, diagnosis_session
from studies.test_rig.virtual_rig import Recorder

DESIGN = geometry.prototype("array-2x6")
BLOCKED = SensorFault("blocked tube", (6,), 0.35)
EXCHANGED = SensorFault("exchanged microphones", (1, 2))


@pytest.mark.slow
@pytest.mark.end_to_end
@pytest.mark.parametrize(
    ("fault", "points", "words"),
    [
        (BLOCKED, (2, 6, 11), "tube 6 (between points 5 and 6) is narrowed or blocked"),
        (EXCHANGED, (1, 2, 5, 11, 12), "microphones A and B are exchanged"),
    ],
)
def test_a_calibration_names_the_broken_part(
    fault: SensorFault, points: tuple[int, ...], words: str, tmp_path: Path
) -> None:
    """Before, point 2 was blamed for the tube, and a library of mirrored points was written of the microphones."""
    manifest = FaultyRig(DESIGN, 9100, fault, fidelity="lumped").record(
        tmp_path / "rig", points, Recorder(seconds=20.0)
    )
    with pytest.raises(Refusal) as refused:
        studies.calibrate_sensor(manifest, tmp_path / "made.nc", fidelity="lumped")
    assert words in str(refused.value)
    assert "Then record again." in str(refused.value)
    assert not (tmp_path / "made.nc").exists()


@pytest.mark.slow
@pytest.mark.end_to_end
def test_touches_of_a_broken_sensor_name_the_part(tmp_path: Path) -> None:
    """Before, recalibrate searched for minutes, and locate said that no point explains the touches."""
    acoustic_fem.save(acoustic_fem.solve(DESIGN, np.arange(1.0, 201.0), "lumped"), tmp_path / "library.nc")
    touches = diagnosis_session(FaultyRig(DESIGN, 9100, BLOCKED, fidelity="lumped"), 1)
    write_wav(tmp_path / "touches.wav", touches.signals / 4.0, 1000, 24)
    with pytest.raises(Refusal, match="the sensor has a fault: tube 6") as refused:
        studies.recalibrate(tmp_path / "library.nc", [tmp_path / "touches.wav"], tmp_path / "now.nc", full_scale=4.0)
    assert "touch point" in str(refused.value)
    assert not (tmp_path / "now.nc").exists()
    located = studies.locate_recording(tmp_path / "library.nc", tmp_path / "touches.wav", full_scale=4.0)
    assert located.warning is not None
    assert located.warning.startswith("tube 6 (between points 5 and 6) is narrowed or blocked")
