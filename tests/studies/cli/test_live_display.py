"""The picture of the verb live lights the point and tells what went wrong."""

from __future__ import annotations

import io

import numpy as np
import pytest
from rc_line import rc_line
from rich.console import Console

from localize import Decision, Fault
from localize.live.listener import Heard, Latencies, Notice
from studies.cli.live_display import LivePicture, sparkline


@pytest.fixture(scope="module")
def array():
    return rc_line(6)


def drawn(picture: LivePicture, encoding: str = "utf-8") -> str:
    console = Console(width=80, record=True, file=io.TextIOWrapper(io.BytesIO(), encoding=encoding))
    console.print(picture)
    return console.export_text()


def test_the_picture_lights_the_point_and_tells_what_went_wrong(array) -> None:
    latencies = Latencies()
    latencies.add(0.0042)
    recent = np.sin(np.linspace(0, 20, 1000)) * np.array([[1.0], [0.5]])
    picture = LivePicture("USB array", array, lambda: recent, latencies)
    assert "nothing detected yet" in drawn(picture)
    probability = np.array([0.0, 0.0, 0.15, 0.8, 0.05, 0.0])
    picture.hear(Heard(Decision(1.25, "touch", 0.5, 4, 0.8, probability)))
    picture.hear(Heard(Fault(0.5, "dead channel", "left")))
    picture.hear(Heard(Fault(0.7, "samples lost", samples=12)))
    picture.hear(Heard(Notice(0.9, "source lost", "USB array: the device has stopped")))
    text = drawn(picture)
    assert "line 1  ○─○─◍─●─○─○" in text
    assert "1.25 s  touch  point 4, 80 %   level 0.5 Pa" in text
    assert "latency p50 4.2 ms, p99 4.2 ms   faults: dead channel 1, samples lost 1" in text
    assert "0.70 s  samples lost: 12" in text
    assert "source lost: USB array: the device has stopped" in text
    assert "left    " in text
    assert "█" in text
    assert "line 1  o-o-x-#-o-o" in drawn(picture, "ascii")
    # a state that is not known here is shown as it is called
    picture.hear(Heard(Decision(2.0, "other", 0.1)))
    assert "2.00 s  other   level 0.1 Pa" in drawn(picture)
    assert "●" not in drawn(picture)


def test_a_sparkline_runs_from_minus_to_plus_its_peak() -> None:
    assert sparkline(np.array([-2.0, -1.0, 0.0, 1.0, 2.0]), 5, "01234") == ("01234", 2.0)
    assert sparkline(np.array([0.1, -3.0, 0.2, 1.0]), 2, "01234") == ("03", 3.0)
    assert sparkline(np.zeros(10), 3, "01234") == ("222", 0.0)
    assert len(sparkline(np.arange(500.0), 40)[0]) == 40
