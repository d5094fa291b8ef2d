"""Chains of arcs along smooth curves: tangent to each other, near the curve, and quick to divide into facets."""

import math

import numpy as np
import pytest

import geometry
from geometry.plan.routing import path_length
from geometry.solids import build_tube, piece_of, tessellate
from geometry.solids.arc_chain import arc_ends


def twisted(turn=1.2):
    """A cubic out of its plane between two straight ends, 33 chords in all."""
    s = np.linspace(0, 1, 31)[:, None]
    corners = [(2, 0, 0), (5, 0, 0), (8, 3, turn), (9, 6, 2 * turn)]
    bend = sum(math.comb(3, k) * s**k * (1 - s) ** (3 - k) * np.array(corner) for k, corner in enumerate(corners))
    along = np.array([1.0, 3.0, turn])
    return np.vstack([[0.0, 0, 0], bend, bend[-1] + 2 * along / np.linalg.norm(along)])


def directions(start, along, ends):
    """Direction at the end of each arc of a chain; at its start each goes on in that of the arc before."""
    for end in ends:
        chord = end - start
        along = 2 * (chord @ along) / (chord @ chord) * chord - along
        start = end
        yield along


@pytest.mark.parametrize("turn", [0.0, 0.4, 1.2])
def test_a_chain_ends_where_the_curve_does_and_in_its_direction(turn):
    course = twisted(turn)
    ends = arc_ends(course)
    np.testing.assert_allclose(ends[-1], course[-2], atol=1e-12)
    first, last = course[1] - course[0], course[-1] - course[-2]
    *_, along = directions(course[1], first / np.linalg.norm(first), ends)
    np.testing.assert_allclose(along, last / np.linalg.norm(last), atol=1e-9)


def test_points_of_a_curve_lie_within_a_few_micrometres_of_its_chain():
    course = twisted()
    ends = arc_ends(course)
    assert len(ends) < 16
    start, along = course[1], np.array([1.0, 0, 0])
    near = np.full(len(course) - 2, np.inf)
    for end in ends:
        chord = end - start
        across = chord - (chord @ along) * along
        width = np.linalg.norm(across)
        radius = chord @ chord / (2 * width)
        half = math.asin(np.linalg.norm(chord) / (2 * radius))
        angles = np.linspace(0, 2 * half, 400)
        arc = start + radius * (np.outer(np.sin(angles), along) + np.outer(1 - np.cos(angles), across / width))
        near = np.minimum(near, np.linalg.norm(course[1:-1, None] - arc[None], axis=2).min(axis=1))
        start, along = end, 2 * (chord @ along) / (chord @ chord) * chord - along
    assert near.max() < 0.004


def test_a_tube_along_a_free_curve_has_round_faces_few_facets_and_its_volume():
    tube = geometry.prototype("array-2x6").tube
    piece, _ = piece_of(tube, twisted(), 0.5)
    sheath = build_tube(piece)[1].val()
    assert {face.geomType() for face in sheath.Faces()} <= {"TORUS", "CYLINDER", "PLANE"}
    area = math.pi / 4 * (tube.outer_diameter**2 - tube.spring_outer_diameter**2)
    assert sheath.Volume() == pytest.approx(area * path_length(np.array(piece.path)), rel=1e-3)
    # A pipe along a spline had up to 126 000 of them, and took a minute.
    assert len(tessellate(sheath, 0.01, 0.3, measured=False).triangles) < 20_000
