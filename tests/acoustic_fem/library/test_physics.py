"""Unphysical values are refused with the variable and the place; no library of a sensor is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings, strategies as st
from random_networks import every_node_at_once, random_parameters, topologies
from refusals import check_messages, refused

import acoustic_fem
import geometry
from acoustic_fem.library.physics import check_physics
from acoustic_fem.library.transfer_functions import MEASURED, Library
from geometry.ground.refusal import Kind

pytestmark = pytest.mark.filterwarnings("ignore:entrance loss")
AIR = acoustic_fem.Medium.at(20, 0.5)


@pytest.fixture(scope="module")
def library() -> Library:
    return acoustic_fem.solve(geometry.prototype("line-2"), [1.0, 10.0, 100.0], "lumped")


def network_library(topology, seed: int, frequency: np.ndarray) -> Library:
    """Responses of a network drawn at random, as a library has them."""
    z = np.moveaxis(every_node_at_once(random_parameters(topology, seed), topology, frequency, AIR), 0, -1)
    points = sum(len(line.points) for line in topology.lines)
    own = np.einsum("ppf->pf", z[:points, :points])
    coordinates = {"point": range(1, points + 1), "microphone": range(len(z) - points), "frequency": frequency}
    source = xr.DataArray(z[:points, points:], coordinates)
    impedance = xr.DataArray(own, {key: coordinates[key] for key in ("point", "frequency")})
    between = xr.DataArray(
        z[points:, points:],
        {"microphone_2": coordinates["microphone"], **{key: coordinates[key] for key in ("microphone", "frequency")}},
        ("microphone", "microphone_2", "frequency"),
    )
    return Library(source / impedance, source, impedance, None, "lumped", AIR, {}, between)


@settings(deadline=None, max_examples=12, derandomize=True)
@given(topologies(), st.integers(0, 2**32 - 1))
def test_no_network_of_ducts_and_cavities_is_refused(topology, seed: int) -> None:
    computed = network_library(topology, seed, np.array([1e-3, 0.1, 3.0, 40.0, 500.0, 2000.0]))
    check_physics(computed)


@settings(deadline=None, max_examples=12, derandomize=True)
@given(topologies(), st.integers(0, 2**32 - 1), st.floats(0.0, 10.0))
def test_no_measurement_however_noisy_is_refused(topology, seed: int, noise: float) -> None:
    model = network_library(topology, seed, np.array([1.0, 40.0, 500.0]))
    generator = np.random.default_rng(seed)
    shape = model.transfer_function.shape
    drawn = generator.normal(size=shape) + 1j * generator.normal(size=shape)
    h = model.transfer_function * (1 + noise * drawn)
    source = h * model.point_impedance
    check_physics(replace(model, transfer_function=h, source_response=source.transpose(*h.dims), fidelity=MEASURED))


@pytest.mark.parametrize("name", geometry.prototype_names())
def test_no_prototype_is_refused(name: str) -> None:
    check_physics(acoustic_fem.solve(geometry.prototype(name), np.geomspace(1e-3, 2000, 9), "lumped"))


def test_one_point_at_one_frequency_is_not_refused() -> None:
    design = geometry.prototype("array-2x6").with_values({"lines.0.points": 1, "layout.columns": 1})
    check_physics(acoustic_fem.solve(design, [50.0], "lumped"))


def scaled(library: Library, factor: object, *names: str) -> Library:
    return replace(library, **{name: getattr(library, name) * factor for name in names})


def at(shape: tuple[int, ...], place: tuple[int, ...], value: complex) -> np.ndarray:
    factor = np.ones(shape, complex)
    factor[place] = value
    return factor


BOTH = ("transfer_function", "source_response")
WRONG: dict[str, tuple[Callable[[Library], Library], str]] = {
    "zero": (lambda it: scaled(it, 0.0, *BOTH), "transfer_function"),
    "all-zero": (lambda it: scaled(it, 0.0, *BOTH, "point_impedance", "microphone_impedance"), "transfer_function"),
    "silent-point": (lambda it: scaled(it, at((36, 1, 1), (4,), 0), *BOTH), "transfer_function"),
    "constant": (
        lambda it: replace(
            it, transfer_function=xr.ones_like(it.transfer_function) * (0.5 + 0j),
            source_response=xr.ones_like(it.source_response) * (0.5 + 0j),
            point_impedance=xr.ones_like(it.point_impedance),
        ),
        "transfer_function",
    ),
    "one-changed": (
        lambda it: scaled(it, at((36, 2, 3), (2, 1, 0), 1.1), "transfer_function"),
        "source_response",
    ),
    "points-exchanged": (
        lambda it: replace(it, point_impedance=it.point_impedance.copy(data=it.point_impedance.values[::-1] * 1.01)),
        "source_response",
    ),
    "negative": (
        lambda it: scaled(it, -1.0, "source_response", "point_impedance"),
        "point_impedance_real",
    ),
    "negative-microphone": (
        lambda it: scaled(it, -1.0, "microphone_impedance"),
        "microphone_impedance_real",
    ),
    "no-impedance": (lambda it: scaled(it, 0.0, "source_response", "point_impedance"), "point_impedance"),
    "loud": (lambda it: scaled(it, 1e3, *BOTH), "source_response"),
    "not-reciprocal": (
        lambda it: scaled(it, at((2, 2, 3), (0, 1, 2), 1.01), "microphone_impedance"),
        "microphone_impedance",
    ),
    "beyond-numbers": (
        lambda it: scaled(it, 1e300, *BOTH, "point_impedance"), "source_response",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_what_no_physics_makes_is_refused_by_the_variable(library: Library, name: str) -> None:
    change, variable = WRONG[name]
    with refused(Kind.UNSUITABLE, variable):
        check_physics(change(library))


def test_messages_of_libraries_without_physics_name_the_place(library: Library) -> None:
    cases = {name: partial(check_physics, change(library)) for name, (change, _) in WRONG.items()}
    check_messages(Path(__file__).with_name("physics.txt"), cases)


def test_a_library_of_zeros_is_refused_when_it_is_loaded(library: Library, tmp_path: Path) -> None:
    acoustic_fem.save(scaled(library, 0.0, *BOTH), tmp_path / "zero.nc")
    with pytest.raises(acoustic_fem.LibraryError, match=r"zero.nc: .*transfer_function is zero everywhere"):
        acoustic_fem.load(tmp_path / "zero.nc")
