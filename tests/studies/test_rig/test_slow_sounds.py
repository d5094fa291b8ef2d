"""Doors and wind: how strong they are, and how slow."""

from __future__ import annotations

import numpy as np
import pytest
from refusals import refused

from geometry import Kind
from studies.test_rig import closing_doors, gusts


def fraction_below(pressure: np.ndarray, corner: float) -> float:
    power = np.abs(np.fft.rfft(pressure - pressure.mean())) ** 2
    return float(power[np.fft.rfftfreq(len(pressure), 1e-3) <= corner].sum() / power.sum())


def test_a_door_compresses_the_room_slowly_and_the_room_leaks() -> None:
    pressure = closing_doors(60.0, np.random.default_rng(0), 10.0)
    assert 8 < np.abs(pressure).max() < 12  # two doors may overlap a little
    assert fraction_below(pressure, 20.0) > 0.999
    assert np.median(np.abs(pressure)) < 0.1
    assert np.abs(np.diff(pressure)).max() < 10 * np.pi / 2 / 80 * 1.1  # the steepest sin^2 takes 80 ms
    assert pressure == pytest.approx(10 * closing_doors(60.0, np.random.default_rng(0), 1.0))


def test_wind_is_pink_below_20_hz() -> None:
    pressure = gusts(60.0, np.random.default_rng(0), 2.0)
    assert pressure.std() == pytest.approx(2.0)
    assert fraction_below(pressure, 20.0) == pytest.approx(1.0)
    # pink: as much in each octave, so that the middle of the logarithmic band parts the power
    assert fraction_below(pressure, np.sqrt(0.1 * 20.0)) == pytest.approx(0.5, abs=0.15)


def test_what_is_out_of_range_is_refused() -> None:
    random = np.random.default_rng(0)
    with refused(Kind.OUT_OF_RANGE, "largest", -1.0):
        closing_doors(10.0, random, -1.0)
    with refused(Kind.OUT_OF_RANGE, "rms", 2000.0):
        gusts(10.0, random, 2000.0)
    with refused(Kind.OUT_OF_RANGE, "seconds", 5.0):
        gusts(5.0, random)
