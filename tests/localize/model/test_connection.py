"""Recordings of microphones that are connected wrongly: the fault is found, and touches are right once corrected."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from refusals import refused

import localize
from acoustic_fem.sound.sound_file import write_wav
from geometry import Kind
from localize import Recording, RecordingError
from localize.evaluation import fit_watch
from localize.evaluation.connection_faults import ConnectionFault
from localize.evaluation.fit_watch import FitWatch
from localize.live.events import Decision
from localize.live.listener import Notice
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


@pytest.mark.parametrize("late", [-250, -120, -10, 10, 120, 250])
@pytest.mark.parametrize("name", ["A", "B"])
def test_a_late_or_early_channel_is_named_with_its_delay(
    model: localize.Model, recording: Recording, name: str, late: int
) -> None:
    names = model.locator.microphones
    spoilt = ConnectionFault("late", (name,), -1e-3 * late).corrected(recording.signals, names)
    found = model.locate_recording(Recording(spoilt, recording.rate))
    assert found.fault is not None
    # Of two microphones one is as late as the other is early.
    sign = 1 if found.fault.microphones == (name,) else -1
    assert (found.fault.kind, sign * found.fault.amount) == ("late", pytest.approx(1e-3 * late, abs=5e-4))
    other = next(each for each in names if each != name)
    behind, ahead = (name, other) if late > 0 else (other, name)
    words = found.fault.described(names)
    assert words.startswith(f"microphone {behind} is ")
    assert words.endswith(f" ms late against microphone {ahead}")


def notices(model: localize.Model, signals: np.ndarray) -> list[Notice]:
    """Notices of a watch of a stream."""
    stream = model.stream(frames=True)
    watch = FitWatch(stream)
    return [notice for event in stream.push(signals) for notice in watch.take(event)]


@pytest.mark.slow
def test_a_watch_reports_a_wrong_connection_once_while_touches_come_in(
    model: localize.Model, recording: Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(fit_watch._Check, "start", fit_watch._Check.run)  # at once: a thread may take any time
    a, b = np.tile(recording.signals, (1, 4))
    (notice,) = notices(model, np.stack([-a, b]))
    assert notice.kind == "sensor does not fit"
    assert "microphone A or B is reversed" in notice.text
    assert notice.time < 2.5 * recording.seconds
    assert json.loads(notice.json_line())["notice"] == "sensor does not fit"
    assert notices(model, np.stack([a, b])) == []


def test_a_check_that_fails_is_not_passed_over(
    model: localize.Model, recording: Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(*given: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(fit_watch._Check, "start", fit_watch._Check.run)
    monkeypatch.setattr(fit_watch, "sensor_fit", fails)
    with pytest.raises(ZeroDivisionError):
        notices(model, recording.signals)


def test_a_listener_watches_its_stream(model: localize.Model, tmp_path: Path, recording: Recording) -> None:
    write_wav(tmp_path / "replay.wav", recording.signals / FULL_SCALE, 1000)
    listener = model.listen(ReplaySource(tmp_path / "replay.wav", model.locator.microphones, FULL_SCALE))
    assert any(isinstance(each, FitWatch) for each in listener.trackers)


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
