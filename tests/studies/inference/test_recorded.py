"""The picture of a recording shows its touches, its faults and its loudest samples."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from localize import ArrayFacts, Decision, Fault, Touch
from studies.inference.recorded import LocatedTouches, draw_touches

ROW = ArrayFacts("row", ("left", "right"), np.zeros(6, int), np.arange(6))


def located(seconds: float) -> LocatedTouches:
    frames = [Decision(1.0 + 0.016 * k, "touch", 0.5, 4, 0.9) for k in range(10)]
    events = (*frames, Decision(2.0, "no touch", 0.0), Fault(0.5, "dead channel", "left"))
    touches = (Touch(1.0, 1.144, 4, 0.99, 0.5),)
    return LocatedTouches(array=ROW, seconds=seconds, assumptions="nothing", touches=touches, events=events)


@pytest.mark.parametrize("seconds", [3.0, 90.0])
def test_touches_faults_and_single_loud_samples_are_seen(
    seconds: float, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept: list[Figure] = []

    def keep(figure: Figure, path: Path) -> Path:
        kept.append(figure)
        figure.savefig(path)
        return path

    monkeypatch.setattr("studies.inference.recorded.save_figure", keep)
    signals = np.zeros((2, int(1000 * seconds)))
    signals[0, 1234], signals[1, 2345] = 7.0, -3.0
    written = draw_touches(located(seconds), signals, tmp_path / "touches.png")
    assert written.read_bytes().startswith(b"\x89PNG")
    left, right, named, _ = kept[0].axes
    low, high = left.get_ylim()
    assert low <= 0.0
    assert high >= 7.0
    assert right.get_ylim()[0] <= -3.0
    assert left.get_ylabel() == "left  (Pa)"
    assert [text.get_text() for text in named.texts] == ["4"]
    (dots,) = named.collections
    np.testing.assert_allclose(np.asarray(dots.get_offsets())[:, 1], 4.0)
    assert len(dots.get_offsets()) == 10
    (fault,) = named.lines
    assert fault.get_xdata() == [0.5, 0.5]
    assert named.get_xlim() == (0.0, seconds)


def test_a_recording_without_touches_is_drawn(tmp_path: Path) -> None:
    nothing = LocatedTouches(array=ROW, seconds=1.0, assumptions="nothing", touches=(), events=())
    written = draw_touches(nothing, np.zeros((2, 1000)), tmp_path / "quiet.png")
    assert written.stat().st_size > 5000
