"""A library brought to the air of another place."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from refusals import refused

import acoustic_fem
import geometry
import localize
import studies
from acoustic_fem.library.transfer_functions import VARIABLES, Library
from acoustic_fem.quantities.local_air import LocalAir, standard_pressure
from geometry.ground.refusal import Kind

FREQUENCY = np.linspace(1.0, 100.0, 12)


@pytest.fixture(scope="module")
def library() -> Library:
    return acoustic_fem.solve(geometry.prototype("array-2x6"), FREQUENCY, "lumped")


def _apart(one: Library, other: Library) -> float:
    return max(float(np.abs(getattr(one, name) / getattr(other, name) - 1).max()) for name in VARIABLES)


def test_closed_forms_brought_elsewhere_are_those_solved_there(library: Library) -> None:
    there = library.in_air(pressure=79500.0, temperature_c=5.0, humidity=0.2)
    air = there.design.air
    assert (air.pressure, air.temperature, air.humidity) == (79500.0, 5.0, 0.2)
    solved = acoustic_fem.solve(there.design, FREQUENCY, "lumped")
    assert _apart(there, solved) < 1e-12
    assert there.medium == solved.medium
    assert _apart(there, library) > 0.05


def test_there_and_back_is_where_it_was(library: Library) -> None:
    back = library.in_air(altitude=2000.0).in_air(altitude=0.0)
    assert _apart(back, library) < 1e-12
    assert library.in_air() is library
    assert library.in_air(pressure=library.design.air.pressure) is library


@pytest.mark.physics
@pytest.mark.slow
def test_3d_cells_brought_elsewhere_are_those_solved_there() -> None:
    frequency = np.linspace(1.0, 200.0, 40)
    library = acoustic_fem.solve(geometry.prototype("array-2x6"), frequency)
    there = library.in_air(altitude=2000.0)
    solved = acoustic_fem.solve(there.design, frequency)
    assert _apart(there, solved) < 2.5e-3
    assert _apart(library, solved) > 0.5


def test_the_file_says_in_which_air_it_is_and_from_which_it_came(library: Library, tmp_path: Path) -> None:
    there = library.in_air(pressure=90000.0)
    acoustic_fem.save(there, tmp_path / "there.nc")
    read = acoustic_fem.load(tmp_path / "there.nc")
    assert read.design.air.pressure == 90000.0
    assert read.medium == there.medium
    assert read.provenance["brought_from_air"]["pressure"] == 101325.0
    assert _apart(read, there) < 1e-15


def test_a_library_in_a_medium_of_its_own_is_not_brought_elsewhere() -> None:
    helium = acoustic_fem.Medium(0.166, 1.96e-5, 0.152, 5193.0, 1.66, 101325.0)
    library = acoustic_fem.solve(geometry.prototype("array-2x6"), FREQUENCY, "lumped", helium)
    assert library.in_air() is library
    with refused(Kind.CONFLICT, "medium"):
        library.in_air(pressure=9e4)


@pytest.mark.parametrize(
    ("stated", "field", "kind"),
    [
        ({"pressure": 4e4}, "pressure", Kind.OUT_OF_RANGE),
        ({"altitude": 9000.0}, "altitude", Kind.OUT_OF_RANGE),
        ({"temperature_c": 200.0}, "temperature_c", Kind.OUT_OF_RANGE),
        ({"humidity": 50.0}, "humidity", Kind.OUT_OF_RANGE),
        ({"pressure": 9e4, "altitude": 1000.0}, "pressure", Kind.CONFLICT),
    ],
)
def test_air_that_no_place_has_is_refused(library: Library, stated: dict[str, float], field: str, kind: Kind) -> None:
    with refused(kind, field):
        LocalAir(**stated)
    with refused(kind, field):
        library.in_air(**stated)


@pytest.mark.parametrize("air", ["sea", {"altitude": 1}, 1000.0])
def test_an_air_of_another_type_is_refused(library: Library, tmp_path: Path, air: Any) -> None:
    calls: list[Callable[[], object]] = [
        lambda: acoustic_fem.solve("line-4", "1:50:3", fidelity="lumped", air=air),
        lambda: library.in_air(air),
        lambda: localize.open_model(library, air=air),
        lambda: studies.solve_library("line-4", tmp_path / "a.nc", fidelity="lumped", air=air),
        lambda: studies.calibrate_sensor(tmp_path / "calibration.toml", tmp_path / "b.nc", air=air),
        lambda: studies.recalibrate(tmp_path / "a.nc", [], tmp_path / "c.nc", air=air),
    ]
    for call in calls:
        with refused(Kind.WRONG_TYPE, "air", air):
            call()


def test_air_is_one_object_or_its_values(library: Library) -> None:
    air = LocalAir(altitude=2000.0, temperature_c=10.0)
    there = library.in_air(air)
    assert np.array_equal(
        there.transfer_function, library.in_air(altitude=2000.0, temperature_c=10.0).transfer_function
    )
    solved = acoustic_fem.solve("array-2x6", FREQUENCY, "lumped", air)
    assert solved.design == there.design
    with refused(Kind.CONFLICT, "air"):
        library.in_air(air, humidity=0.1)


def test_the_standard_atmosphere() -> None:
    # ISO 2533:1975, by geometric altitude; the formula takes the geopotential one
    for altitude, pressure in ((0.0, 101325.0), (1000.0, 89876.3), (2000.0, 79501.4), (5000.0, 54048.3)):
        assert standard_pressure(altitude) == pytest.approx(pressure, rel=6e-4)
