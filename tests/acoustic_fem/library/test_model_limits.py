"""What the models neglect is said where it matters, and a gas that is no continuum is refused."""

from __future__ import annotations

import warnings
from dataclasses import replace

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
from acoustic_fem.library.model_limits import check_model_limits
from acoustic_fem.quantities.medium import Medium
from geometry.ground.refusal import Kind

FREQUENCY = np.array([1.0, 10.0, 100.0])
AIR = Medium.at()
DESIGN = geometry.prototype("array-2x6")


def thinned(medium: Medium, pressure: float) -> Medium:
    """The gas at another pressure and the same temperature."""
    return replace(medium, pressure=pressure, density=medium.density * pressure / medium.pressure)


def test_the_temperature_and_the_mean_free_path_of_air():
    assert Medium.at(20.0, 0.0).temperature == pytest.approx(293.15, abs=0.3)
    # 66 nm at 20 degC and 1013 hPa: Jennings, J. Aerosol Sci. 19 (1988) 159, gives 65.43 nm for dry air
    assert Medium.at(20.0, 0.0).mean_free_path == pytest.approx(65.43e-9, rel=0.03)
    assert thinned(AIR, 1.0).mean_free_path == pytest.approx(101325 * AIR.mean_free_path)


@pytest.mark.parametrize("fidelity", ["lumped", "atlas"])
def test_air_so_thin_that_its_molecules_miss_each_other_is_refused(fidelity):
    with refused(Kind.OUT_OF_RANGE, "air"):
        acoustic_fem.solve(DESIGN, FREQUENCY, fidelity, air=thinned(AIR, 1.0))


@pytest.mark.parametrize(
    ("design", "frequency", "medium", "word"),
    [
        (DESIGN.with_values({"tube.inner_diameter": 0.05}), FREQUENCY, AIR, "slip"),
        (DESIGN, FREQUENCY, Medium(998.0, 1e-3, 0.6, 4180.0, 1.007, 101325.0), "ideal gas"),
        (DESIGN, FREQUENCY, thinned(AIR, 1e7), "ideal gas"),
        (DESIGN, np.array([100.0, 6000.0]), AIR, "cavities"),
    ],
    ids=["narrow bore", "water", "100 bar", "short waves"],
)
def test_what_the_models_neglect_is_said(design, frequency, medium, word):
    with pytest.warns(UserWarning, match=word):
        check_model_limits(design, frequency, medium)


@pytest.mark.parametrize("name", geometry.prototype_names())
def test_no_prototype_is_outside_in_its_band(name):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_model_limits(geometry.prototype(name), FREQUENCY, AIR)
