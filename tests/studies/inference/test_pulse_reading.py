"""A recording of a pulse tells its point, rate and waveform, as the verb does."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import acoustic_fem
import geometry
import studies
from geometry.ground.refusal import Refusal
from localize.contacts import pulse_wave, record
from localize.signals.array_response import response_of

RATE = 66.0


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder of a library and of six seconds of a pulse at point 2."""
    made = tmp_path_factory.mktemp("pulse")
    design = geometry.prototype("array-2x6").with_values({"lines.0.points": 3, "layout.columns": 3})
    library = acoustic_fem.solve(design, np.arange(0.5, 501.0, 2.0), "lumped")
    acoustic_fem.save(library, made / "library.nc")
    place = response_of(library).position
    assert place is not None
    take = record(pulse_wave(tuple(place[1]), rate=RATE, seconds=6.0), library, 1000.0, microphone_noise="design")
    np.savez(made / "pulse.npz", signals=take.signals)
    np.savez(made / "short.npz", signals=take.signals[:, :2500])
    return made


def test_a_pulse_is_read_from_a_recording(folder: Path, tmp_path: Path) -> None:
    table, picture = tmp_path / "pulse.csv", tmp_path / "pulse.png"
    found = studies.read_pulse(folder / "library.nc", folder / "pulse.npz", table, picture=picture)
    assert found.reading.point == 2
    assert found.reading.rate == pytest.approx(RATE, abs=3.0)
    assert found.seconds == pytest.approx(6.0, abs=0.01)
    assert found.force_is_known
    assert "as it was designed, in air of 101.3 kPa" in found.assumptions
    waveform = np.genfromtxt(table, delimiter=",", skip_header=1)
    assert waveform.shape == (len(found.reading.waveform), 2)
    np.testing.assert_allclose(waveform[:, 1], found.reading.waveform, rtol=1e-3)
    assert picture.stat().st_size > 10_000
    studies.read_pulse(folder / "library.nc", folder / "pulse.npz", table, point=3)  # its own table is replaced


@pytest.mark.parametrize(
    ("recording", "options", "message"),
    [
        ("pulse.npz", {"point": 4}, "point = 4 must be a whole number between 1 and 3"),
        ("short.npz", {}, "must last at least 3 s for a pulse"),
        ("nowhere.npz", {}, "nowhere.npz: no such file"),
    ],
)
def test_what_is_no_pulse_is_refused(folder: Path, recording: str, options: dict[str, int], message: str) -> None:
    with pytest.raises(Refusal, match=message):
        studies.read_pulse(folder / "library.nc", folder / recording, **options)


def test_a_table_of_another_kind_is_kept(folder: Path, tmp_path: Path) -> None:
    (tmp_path / "mine.csv").write_text("left,right\n1,2\n", encoding="utf-8")
    with pytest.raises(Refusal, match="a table that does not come from pulse is never overwritten"):
        studies.read_pulse(folder / "library.nc", folder / "pulse.npz", tmp_path / "mine.csv")
