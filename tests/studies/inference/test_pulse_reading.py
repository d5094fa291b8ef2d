"""A recording of a pulse tells its point, rate and waveform, as the verb does."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import acoustic_fem
import geometry
import studies
from acoustic_fem.network import output_response
from acoustic_fem.quantities.local_air import design_air
from geometry.ground.refusal import Refusal
from geometry.ground.typed import Array
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


def test_the_outputs_of_microphones_give_the_waveform_of_the_pressures(folder: Path, tmp_path: Path) -> None:
    library = acoustic_fem.load(folder / "library.nc")
    pressures = np.load(folder / "pulse.npz")["signals"]
    grid = np.fft.rfftfreq(2 * pressures.shape[1], 1e-3)
    known = output_response(library.design.microphone, np.maximum(grid, 1e-3), design_air(library.design))
    outputs = np.fft.irfft(np.fft.rfft(pressures, 2 * pressures.shape[1]) * known)[:, : pressures.shape[1]]
    np.savez(tmp_path / "outputs.npz", signals=outputs)

    def waveform(path: Path, **options: Any) -> Array:
        found = studies.read_pulse(library, path, point=2, decoding=studies.Decoding(**options)).reading
        return found.waveform[2500:5000]  # between the edges, where the high-pass has settled

    expected = waveform(folder / "pulse.npz")
    equalised = waveform(tmp_path / "outputs.npz", microphone_output="voltage")
    taken_for_pressures = waveform(tmp_path / "outputs.npz")
    assert np.corrcoef(equalised, expected)[0, 1] > 0.9
    assert equalised.std() == pytest.approx(expected.std(), rel=0.1)
    assert np.corrcoef(taken_for_pressures, expected)[0, 1] < 0.5
    assert taken_for_pressures.std() < 0.2 * expected.std()


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
