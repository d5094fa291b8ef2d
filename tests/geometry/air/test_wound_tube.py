"""A tube wound on a cylinder: its axis, its mesh against the CAD sweep, and what cannot be wound."""

from __future__ import annotations

import cadquery as cq
import numpy as np
import pytest
from hypothesis import given, strategies as st
from refusals import refused

from acoustic_fem.duct.meshed_section import MeshedSection
from geometry.air.mesh import WALL, InvertedElementsError
from geometry.air.wound_tube import Winding, closest_pitch, swept_mesh
from geometry.ground.refusal import Kind

BORE, BEND = 0.25, 5.8  # radii of the publication's rig, mm


HELIX = Winding(2 * BEND, 90.0, closest_pitch(2 * BEND, 0.9))


@given(st.floats(1, 50), st.floats(1, 720), st.floats(0, 30))
def test_a_winding_has_the_curvature_and_torsion_it_names(diameter, angle, pitch):
    winding = Winding(diameter, angle, pitch)
    step = 1e-3 * diameter
    s = winding.arc_length / 2 + step * np.arange(-1, 2) if winding.arc_length > 3 * step else None
    if s is None:
        return
    points, frames = winding.at(s)
    np.testing.assert_allclose((points[2] - points[0]) / (2 * step), frames[1, 2], atol=1e-5)
    turning = (frames[2] - frames[0]) / (2 * step)
    # Frenet: dT/ds = -k (away from the axis); d(across)/ds = torsion times away from the axis.
    np.testing.assert_allclose(turning[2], -winding.curvature * frames[1, 0], atol=1e-4 * winding.curvature + 1e-9)
    np.testing.assert_allclose(np.abs(turning[1] @ frames[1, 0]), winding.torsion, rtol=1e-4, atol=1e-9)
    np.testing.assert_allclose(frames @ frames.transpose(0, 2, 1), np.broadcast_to(np.eye(3), (3, 3, 3)), atol=1e-12)


def test_the_ends_of_a_winding_are_straight_and_continue_it():
    points, frames = HELIX.at(np.array([-2.0, 0.0, HELIX.arc_length, HELIX.arc_length + 3.0]))
    np.testing.assert_allclose(points[1] - points[0], 2 * frames[1, 2], atol=1e-12)
    np.testing.assert_allclose(points[3] - points[2], 3 * frames[2, 2], atol=1e-12)


def test_a_swept_mesh_lies_on_the_cad_sweep_and_has_its_volume():
    section = MeshedSection.circle(BORE, 4)
    along = np.linspace(0, HELIX.arc_length, 61)
    mesh = swept_mesh(section.points, section.triangles, HELIX, along)
    path = cq.Wire.makeHelix(HELIX.pitch, HELIX.pitch / 4, BEND)
    start = HELIX.at(np.zeros(1))
    plane = cq.Plane(start[0][0].tolist(), start[1][0, 0].tolist(), start[1][0, 2].tolist())
    solid = cq.Workplane(plane).circle(BORE).sweep(cq.Workplane(path), isFrenet=True).val()
    assert mesh.volume == pytest.approx(solid.Volume(), rel=1e-5)
    assert mesh.mesh_volume == pytest.approx(solid.Volume(), rel=3e-5)
    wall = mesh.nodes[np.unique(mesh.faces[WALL])][::40]
    shell = solid.Shells()[0]
    assert max(shell.distance(cq.Vertex.makeVertex(*node)) for node in wall) < 1e-4 * BORE


def test_a_bend_too_tight_for_its_layers_is_refused():
    section = MeshedSection.circle(BORE, 1)
    with refused(Kind.NO_RESULT, error=InvertedElementsError):
        swept_mesh(section.points, section.triangles, Winding(0.6, 360.0), np.linspace(0, 1.8, 2))


def test_a_tube_as_wide_as_the_circumference_of_its_cylinder_has_no_pitch():
    with refused(Kind.OUT_OF_RANGE, "outside", 4.0):
        closest_pitch(1.0, 4.0)
