"""Recordings of microphones that are connected wrongly: the fault is found, and touches are right once corrected."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from refusals import refused

import localize
from acoustic_fem.sound.sound_file import write_wav
from geometry import Kind
from localize import Recording, RecordingError
from localize.evaluation.connection_faults import ConnectionFault
from localize.live.events import Decision
from localize.live.sources import ReplaySource, SourceError

EXAMPLES = Path(__file__).parents[3] / "docs" / "examples" / "recordings"
FULL_SCALE = 20.0


@pytest.fixture(scope="module")
def model() -> localize.Model:
    return localize.open_model(EXAMPLES / "library.nc")


@pytest.fixture(scope="module")
def recording(model: localize.Model) -> Recording:
    return model.read(EXAMPLES / "touches.wav", FULL_SCALE)


@pytest.fixture(scope="module")
def points(model: localize.Model, recording: Recording) -> list[int]:
    """Points of the recording as it is."""
    found = model.locate_recording(recording)
    assert (found.warning, found.fault, found.corrected, found.trust) == (None, None, False, 1.0)
    return [touch.point for touch in found.touches]


@pytest.mark.parametrize("fault", [
    ConnectionFault("reversed", ("A",)), ConnectionFault("exchanged", ("A", "B")), ConnectionFault("late", ("A",), 0.02)
], ids=lambda fault: fault.kind)  # fmt: skip
def test_a_wrong_connection_is_named_not_believed_and_corrected_on_request(
    model: localize.Model, recording: Recording, points: list[int], fault: ConnectionFault
) -> None:
    names = model.locator.microphones
    spoilt = Recording(replace(fault, amount=-fault.amount).corrected(recording.signals, names), recording.rate)
    found = model.locate_recording(spoilt)
    assert found.fault is not None
    assert (found.fault.kind, found.fault.amount) == (fault.kind, pytest.approx(fault.amount, abs=5e-4))
    assert [touch.point for touch in found.touches] != points
    assert not found.corrected
    assert max(touch.probability for touch in found.touches) < 0.35
    of_frames = [each.distribution for each in found.events if isinstance(each, Decision) and each.state == "touch"]
    assert np.max(of_frames) < 0.35
    assert np.sum(of_frames, 1) == pytest.approx(1.0)
    corrected = model.locate_recording(spoilt, correct=True)
    assert [touch.point for touch in corrected.touches] == points
    assert (corrected.corrected, corrected.trust) == (True, 1.0)


def test_channels_are_chosen_by_number_in_any_file(model: localize.Model, recording: Recording, tmp_path: Path) -> None:
    three = np.stack([recording.signals[1], 0.1 * recording.signals[0] + 0.2, recording.signals[0]])
    np.savez(tmp_path / "three.npz", signals=three, sample_rate=1000.0)
    with refused(Kind.MISMATCH, file="three.npz", error=RecordingError) as found:
        model.read(tmp_path / "three.npz")
    assert "channels" in str(found.value)
    chosen = model.read(tmp_path / "three.npz", channels={"A": 3, "B": 1})
    np.testing.assert_allclose(chosen.signals, recording.signals)
    text = "time,x,y\n" + "".join(f"{k / 1000},{b!r},{a!r}\n" for k, (a, b) in enumerate(recording.signals.T.tolist()))
    (tmp_path / "named.csv").write_text(text)
    chosen = model.read(tmp_path / "named.csv", channels={"A": 2, "B": 1})
    np.testing.assert_allclose(chosen.signals, recording.signals)
    for channels, kind in (({"A": 1}, Kind.OUT_OF_RANGE), ({"A": 1, "B": 4}, Kind.MISSING)):
        with refused(kind, "channels", error=RecordingError):
            model.read(tmp_path / "three.npz", channels=channels)


def test_a_file_of_three_channels_is_not_played_for_two_microphones_unsaid(tmp_path: Path) -> None:
    samples = 0.1 * np.random.default_rng(0).standard_normal((3, 1000))
    path = tmp_path / "three.wav"
    write_wav(path, samples, 1000)
    with refused(Kind.MISMATCH, file="three.wav", error=SourceError):
        ReplaySource(path, ("A", "B"))
    assert ReplaySource(path, ("A", "B"), channels={"A": 3, "B": 1}).rate == 1000
