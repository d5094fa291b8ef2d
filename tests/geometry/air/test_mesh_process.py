"""gmsh works in a copy of this process: round after round, within its limits, and its mistakes stay mistakes."""

import os
import signal

import cadquery as cq
import pytest

from geometry.air.mesh import MeshError, MeshSizes, mesh_solid
from geometry.ground.refusal import Kind, Refusal

SIZES = MeshSizes(1, 1, 0.5, 0.5)
BOX = cq.Solid.makeBox(1, 1, 1)


def test_round_solids_are_meshed_one_after_the_other():
    ball = cq.Workplane().sphere(2).union(cq.Workplane().cylinder(5, 1)).val()
    first, second = (mesh_solid(ball, {"a": (0, 0, 2.5)}, ("a",), SIZES) for _ in range(2))
    assert (first.nodes == second.nodes).all()


def test_gmsh_never_works_in_this_process(monkeypatch):
    def tell(*_):
        raise MeshError(f"process {os.getpid()}", kind=Kind.OUT_OF_RANGE)

    monkeypatch.setattr("geometry.air.mesh._set_sizes", tell)
    with pytest.raises(MeshError, match="process") as refused:
        mesh_solid(BOX, {"a": (0.5, 0.5, 0)}, (), SIZES)
    assert str(refused.value) != f"process {os.getpid()}"


def test_a_crash_of_gmsh_is_a_refusal_with_a_remedy(monkeypatch):
    monkeypatch.setattr("geometry.air.mesh._set_sizes", lambda *_: os.kill(os.getpid(), signal.SIGSEGV))
    with pytest.raises(Refusal) as refused:
        mesh_solid(BOX, {"a": (0.5, 0.5, 0)}, (), SIZES)
    assert refused.value.kind is Kind.STOPPED
    assert refused.value.remedy


def test_a_mistake_of_the_program_is_not_taken_for_a_solid_that_cannot_be_meshed(monkeypatch):
    def mistaken(*_):
        raise TypeError("no such argument")

    monkeypatch.setattr("geometry.air.mesh._set_sizes", mistaken)
    with pytest.raises(TypeError, match="no such argument"):
        mesh_solid(BOX, {"a": (0.5, 0.5, 0)}, (), SIZES)
