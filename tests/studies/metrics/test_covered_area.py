"""The share of an array's area where a contact reaches a membrane: against points thrown at it, and known cases."""

import numpy as np
import pytest
from refusals import refused
from scipy.spatial import ConvexHull, Delaunay

import geometry
from geometry.ground.refusal import Kind
from geometry.layout import frozen_values
from geometry.layout.arrangement import lay_out
from studies.metrics import coverage
from studies.metrics.covered_area import (
    _CORNER,
    _hull,
    _is_mirrored,
    _rim,
    _together,
    most_uncovered,
    point_coverage,
)


def by_points(design, radius, count=40_000):
    place = np.array([point.position for point in lay_out(design).points])
    own = np.array([design.of_kind(kind).resonator.cavity_diameter / 2 for kind in design.kinds])
    own = own[list(design.kind_of_point)]
    turn = np.linspace(0, 2 * np.pi, 60)
    rim = (place[:, None] + own[:, None, None] * np.stack([np.cos(turn), np.sin(turn)], -1)).reshape(-1, 2)
    hull = Delaunay(rim[ConvexHull(rim).vertices])
    thrown = np.random.default_rng(1).uniform(rim.min(axis=0), rim.max(axis=0), (count, 2))
    thrown = thrown[hull.find_simplex(thrown) >= 0]
    near = np.linalg.norm(thrown[:, None] - place, axis=-1) < own + radius
    return near.any(axis=1).mean()


@pytest.mark.parametrize(("name", "radius"), [("array-2x6", 5.0), ("glove", 5.0), ("glove", 20.0), ("line-2", 1.0)])
def test_the_share_is_that_of_points_thrown_at_the_area(name, radius):
    design = geometry.prototype(name)
    assert coverage(design, radius) == pytest.approx(by_points(design, radius), abs=0.012)


def test_the_quoted_figures():
    assert coverage(geometry.prototype("array-2x6"), 5.0) == pytest.approx(0.66, abs=0.005)
    assert coverage(geometry.prototype("large-area-64"), 5.0) == pytest.approx(0.58, abs=0.005)
    assert coverage(geometry.prototype("fingertip-3x4"), 5.0) == 1.0
    assert coverage(geometry.prototype("fingertip-4x6"), 5.0) == 1.0


def test_the_contact_is_that_of_the_target():
    design = geometry.prototype("array-2x6").with_values({"target.contact_radius": 3.0})
    assert coverage(design) == coverage(design, 3.0) < coverage(design, 4.0)


def test_a_contact_without_extent_reaches_the_membranes_and_a_wide_one_everything():
    design = geometry.prototype("array-2x6")
    hull = 92.5 * 18.5 + 6 * (92.5 + 18.5) + 9 * np.pi
    assert coverage(design, 0.0) == pytest.approx(12 * 9 * np.pi / hull, rel=2e-3)
    assert coverage(design, 100.0) == 1.0


def test_kinds_of_one_width_and_single_points_are_covered_as_they_are():
    line = geometry.prototype("array-2x6").with_values({"lines.0.points": 1})
    assert coverage(line, 0.0) == pytest.approx(1.0, abs=2e-3)


def test_a_radius_below_zero_is_refused():
    with refused(Kind.OUT_OF_RANGE, "contact_radius_mm", -1.0):
        coverage(geometry.prototype("array-2x6"), -1.0)


def test_the_area_of_an_array_on_a_body_is_that_of_its_cells():
    flat = geometry.prototype("array-2x6")
    frozen = flat.with_values(frozen_values(flat, lay_out(flat)))
    cells = 6 * [{"area": 30.0, "distances": [0, 0, 1, 2, 4]}] + 6 * [{"area": 10.0, "distances": [0, 4]}]
    design = frozen.with_values({"layout.frozen.cells": cells, "layout.frozen.furthest": (1, 2, 3)})
    np.testing.assert_allclose(point_coverage(design, 0.0), np.repeat([0.25, 0.0], 6))
    np.testing.assert_allclose(point_coverage(design, 3.0), np.repeat([0.875, 0.75], 6))
    assert coverage(design, 3.0) == pytest.approx((30 * 0.875 + 10 * 0.75) / 40)
    assert coverage(design, 4.0) == 1.0
    found = most_uncovered(design)
    assert found.distance == 4.0
    assert found.place == (1, 2, 3)
    assert most_uncovered(frozen) is None
    assert coverage(frozen, 3.0) == pytest.approx(coverage(flat, 3.0))


@pytest.mark.parametrize("count", [1, 2, 3, 12, 200])
def test_the_rim_is_that_of_the_hull_of_all_corners(count):
    random = np.random.default_rng(count)
    bent = np.linspace(0.0, 0.05, count)
    for place in (random.normal(size=(count, 2)), 900 * np.stack([np.sin(bent), np.cos(bent)], 1)):
        radius = random.uniform(0.01, 0.5, count)
        hull = ConvexHull((place[:, None] + radius[:, None, None] * _CORNER).reshape(-1, 2))
        x, y = (_rim(place, radius) - place.mean(axis=0)).T
        assert (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2 == pytest.approx(hull.volume, rel=1e-9)


def test_intervals_that_overlap_touch_or_are_empty_count_once():
    random = np.random.default_rng(0)
    begin = random.integers(0, 40, (200, 7)).astype(float)
    end = begin + random.integers(0, 12, begin.shape)
    cells = np.arange(60) + 0.5
    covered = ((begin[..., None] < cells) & (cells < end[..., None])).any(axis=1).sum()
    assert _together(begin, end) == covered


@pytest.mark.parametrize("columns", [1, 4, 6])
def test_where_the_array_is_its_mirror_image_the_lines_of_one_half_cross_it_as_those_of_the_other(columns):
    place = np.stack(np.meshgrid(np.arange(columns) * 18.5, np.arange(3) * 14.3), -1).reshape(-1, 2)
    radius = np.full(len(place), 3.0)
    height, left, right = _hull(place, radius)
    widths = right - left
    assert _is_mirrored(place, radius)
    assert widths == pytest.approx(widths[::-1], rel=1e-12)
    for one, other in zip(_hull(place, radius, 360), (height, left, right), strict=True):
        assert np.array_equal(one, other[:360])
    first = np.arange(len(place)) == 0
    assert not _is_mirrored(place, radius + 1e-6 * first)
    assert not _is_mirrored(place - 1e-6 * first[:, None] * [0, 1], radius)


@pytest.mark.parametrize("name", ["array-2x6", "fingertip-3x4", "line-2"])
def test_the_coverage_of_the_points_adds_up_to_that_of_the_array(name: str) -> None:
    design = geometry.prototype(name)
    own = point_coverage(design, 3.0)
    assert own.shape == (design.point_count,)
    assert own.min() <= coverage(design, 3.0) + 0.01
    assert own.max() >= coverage(design, 3.0) - 0.01
    assert point_coverage(design, 100.0) == pytest.approx(np.ones(design.point_count))


def test_points_that_lie_alike_are_covered_alike() -> None:
    corners = point_coverage(geometry.prototype("array-2x6"), 3.0)[[0, 5, 6, 11]]
    assert corners == pytest.approx(np.full(4, corners[0]), abs=0.01)
