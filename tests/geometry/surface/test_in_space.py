"""Places of the unrolled plan in space: on the capsule of the example, on a plane, and the error of the plan."""

from pathlib import Path

import numpy as np
import pytest

import geometry
from geometry.layout import frozen_values, lay_out
from geometry.surface import plan_in_space

ROBOT = Path("docs/examples/robot")


def on_body(design):
    return plan_in_space(design, lay_out(design))


@pytest.fixture(scope="module")
def fingertip():
    return on_body(geometry.load_design(ROBOT / "fingertip.toml"))


def test_places_of_the_points_are_their_membranes(fingertip):
    places, normals = fingertip.at(fingertip.plan)
    np.testing.assert_allclose(places, fingertip.places, atol=1e-6)
    np.testing.assert_allclose(normals, fingertip.normals, atol=1e-6)


def test_places_between_points_lie_on_the_capsule(fingertip):
    """Against the cylinder and the half ball of the body at the height of the membranes."""
    random = np.random.default_rng(3)
    apart = np.linalg.norm(fingertip.plan[:, None] - fingertip.plan[None], axis=2)
    near = np.argsort(apart, axis=1)[:, :3]
    weights = random.dirichlet(np.ones(3), len(near))
    between = np.einsum("nk,nkc->nc", weights, fingertip.plan[near])
    places, normals = fingertip.at(between)
    axis = np.column_stack([0 * places[:, :2], np.minimum(places[:, 2], 18.0)])
    radius = np.linalg.norm(places - axis, axis=1)
    top = 9 + 0.4 + 0.6 + 1.3 + 0.2
    # Flat facets between three points sink by up to 1.4 mm; the smooth surface is off by a third of it at most.
    flat = np.einsum("nk,nkc->nc", weights, fingertip.places[near])
    sunk = top - np.linalg.norm(flat - np.column_stack([0 * flat[:, :2], np.minimum(flat[:, 2], 18.0)]), axis=1)
    assert np.abs(radius - top).max() < sunk.max() / 3
    assert np.sqrt(np.mean((radius - top) ** 2)) < 0.25
    assert np.einsum("nc,nc->n", normals, (places - axis) / radius[:, None]).min() > np.cos(np.radians(8))


@pytest.mark.parametrize("name", ["array-2x6", "line-2"])
def test_a_frozen_sheet_is_its_own_plan(name):
    flat = geometry.prototype(name)
    found = on_body(flat.with_values(frozen_values(flat, lay_out(flat))))
    assert found.stretch == pytest.approx(0, abs=1e-9)
    assert found.is_flat
    middle = found.plan[:1] * 0.5 + found.plan[1:2] * 0.5
    places, normals = found.at(middle)
    np.testing.assert_allclose(places[:, :2], middle, atol=1e-6)
    np.testing.assert_allclose(normals, [(0, 0, 1)], atol=1e-9)


def test_the_error_of_the_plan_is_stated_and_a_ring_is_not_flat():
    errors = {name: on_body(geometry.load_design(ROBOT / f"{name}.toml")) for name in ("palm", "handle")}
    assert errors["palm"].stretch < 0.03
    assert errors["palm"].is_flat
    assert not errors["handle"].is_flat
    assert errors["handle"].worst > errors["handle"].stretch > 0.1
