"""What a recognizer of what slides is given where nobody states a speed."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from refusals import refused
from shared import solved

import localize
from geometry import Kind
from localize.contacts import Contact, record
from localize.recognition import PROFILES, SPEED, texture_force
from localize.recognition.filter_bank import FilterBank
from localize.signals import response_of

NOISE = 1e-3
PROFILE = PROFILES[5]


def windows_of_a_slide(begin: int, end: int, speed: float) -> tuple[np.ndarray, int]:
    """Windows that a recognizer is asked about, (n, 1024), of a slide over a ridged profile, and the point told."""
    array = response_of(solved("array-2x6", np.arange(1.0, 501.0, 2.0)))
    asked: list[np.ndarray] = []

    def recognize(windows: np.ndarray) -> np.ndarray:
        asked.append(windows)
        return np.ones((len(windows), 1))

    own: Any = SimpleNamespace(
        subject="textures", at_usual_speed=True, microphones=array.microphones, plan={"microphone_noise": NOISE},
        recognize=recognize,
    )  # fmt: skip
    assert array.position is not None
    ends = array.position[[begin, end]]
    time = np.arange(round(1e3 * np.linalg.norm(ends[1] - ends[0]) / speed)) / 1e3
    force = 5e-3 * texture_force(PROFILE, len(time), speed, np.random.default_rng(0))
    path = ends[0] + (ends[1] - ends[0]) * (time / time[-1])[:, None]
    heard = record(Contact(time, path, force, 6.0), array, microphone_noise=NOISE).signals
    quiet = NOISE * np.random.default_rng(1).standard_normal((2, 1500))
    signals = np.concatenate([quiet, heard, quiet], axis=1)
    (told,) = FilterBank(array, own).touches(signals, None, None, localize.BayesDecoder(array, NOISE))
    return asked[0], told.point


@pytest.mark.parametrize("speed", [10.0, 18.0])
def test_windows_of_a_slide_are_at_the_usual_speed_about_its_points(speed: float) -> None:
    windows, point = windows_of_a_slide(0, 3, speed)
    assert point in (2, 3)
    assert len(windows) >= 4
    power = (np.abs(np.fft.rfft(windows * np.hanning(1024), axis=1)) ** 2).mean(0)[5:]
    assert (5 + power.argmax()) * 1000 / 1024 == pytest.approx(SPEED / PROFILE.period, abs=0.8)


def test_what_is_no_slide_needs_a_speed() -> None:
    with refused(Kind.MISSING, "speed"):
        windows_of_a_slide(0, 1, 12.0)
