"""Spheres between solved ones: as good as solved themselves, with the slope of their own volume."""

from __future__ import annotations

import numpy as np
import pytest
from refusals import refused

from acoustic_fem.membrane import Sphere, SpherePresses, design_membrane, large_deflection, press, press_table
from geometry import Kind


@pytest.fixture(autouse=True)
def coarse(monkeypatch: pytest.MonkeyPatch) -> None:
    """Tables of larger elements, for what holds on any mesh."""
    solved = press_table.solved_press
    monkeypatch.setattr(large_deflection, "solved_press", lambda shape, setup: solved(shape, setup, 1))


@pytest.fixture(scope="module")
def presses():
    return SpherePresses(design_membrane("fingertip-4x6"))


def test_a_sphere_between_solved_ones_displaces_what_its_own_solution_says(presses):
    force = np.array([1e-4, 1e-3, 5e-3, 0.02, 0.05])
    radius = presses.membrane.radius * 1.25**8.5  # 5.3 mm, as far from solved ones as can be
    direct = press(presses.membrane, Sphere(radius), force)
    assert presses.volume(force, radius) == pytest.approx(direct.volume, rel=0.01)


def test_the_slope_is_the_derivative_of_the_volume(presses):
    force, radius = np.geomspace(1e-5, 0.05, 300), presses.membrane.radius * 1.25**8.3
    volume = presses.volume(force, radius)
    assert (np.diff(volume) > 0).all()
    middle = presses.volume_per_force((force[1:] + force[:-1]) / 2, radius)
    assert np.diff(volume) / np.diff(force) == pytest.approx(middle, rel=0.02)
    assert presses.volume(0.0, radius) == 0
    assert presses.volume_per_force(0.0, radius) == pytest.approx(presses.volume(1e-7, radius) / 1e-7, rel=1e-3)


def test_a_blunter_sphere_displaces_less(presses):
    volume = presses.volume([[0.01], [0.02]], presses.membrane.radius * np.array([1.25**8, 1.25**8.5, 1.25**9]))
    assert volume.shape == (2, 3)
    assert (np.diff(volume, axis=1) < 0).all()


def test_what_is_not_covered_is_refused(presses):
    with refused(Kind.OUT_OF_RANGE, "radius", 1.0):
        presses.volume(1e-3, 1.0)
    with refused(Kind.OUT_OF_RANGE, "force", 10.0):
        presses.volume(10.0, presses.membrane.radius * 1.25**8.5)
    with refused(Kind.MISMATCH, "radius"):
        presses.volume(np.ones(2), np.ones(3))
