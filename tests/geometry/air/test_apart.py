"""Work in a process of its own: what it returns and raises comes back; a crash or Ctrl-C ends it alone."""

import os
import signal

import cadquery as cq
import pytest

from geometry.air.apart import apart
from geometry.air.mesh import MeshError, MeshSizes, mesh_solid
from geometry.ground.refusal import Refusal

SIZES = MeshSizes(1, 1, 0.5, 0.5)
BOX = cq.Solid.makeBox(1, 1, 1)


def test_what_the_work_returns_comes_back_from_another_process():
    process, answer = apart(lambda: (os.getpid(), "done"), "work")
    assert answer == "done"
    assert process != os.getpid()


def test_what_the_work_raises_is_raised_here():
    def fail():
        raise MeshError("the solid has a hole")

    with pytest.raises(MeshError, match="the solid has a hole"):
        apart(fail, "work")


def test_a_crash_of_the_work_is_refused():
    with pytest.raises(Refusal, match="gmsh gave up on this solid: it may take 60 s of processor time and 3 GiB"):
        apart(lambda: os.kill(os.getpid(), signal.SIGKILL), "gmsh")


def test_who_stops_waiting_ends_the_work(tmp_path):
    started = tmp_path / "started"

    def for_ever():
        started.write_text(str(os.getpid()), encoding="ascii")
        signal.pause()

    def interrupted():
        if started.exists() and started.read_text(encoding="ascii"):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        apart(for_ever, "work", interrupted)
    with pytest.raises(ProcessLookupError):
        os.kill(int(started.read_text(encoding="ascii")), 0)


def test_round_solids_are_meshed_one_after_the_other():
    ball = cq.Workplane().sphere(2).union(cq.Workplane().cylinder(5, 1)).val()
    first, second = (mesh_solid(ball, {"a": (0, 0, 2.5)}, ("a",), SIZES) for _ in range(2))
    assert (first.nodes == second.nodes).all()


def test_gmsh_never_works_in_this_process(monkeypatch):
    def told(*_):
        raise MeshError(f"process {os.getpid()}")

    monkeypatch.setattr("geometry.air.mesh._set_sizes", told)
    with pytest.raises(MeshError, match="process") as refused:
        mesh_solid(BOX, {"a": (0.5, 0.5, 0)}, (), SIZES)
    assert str(refused.value) != f"process {os.getpid()}"


def test_an_error_that_cannot_be_sent_is_no_refusal():
    def fail():
        raise ValueError(lambda: None)

    with pytest.raises(RuntimeError, match="lambda"):
        apart(fail, "work")


def test_work_that_waits_for_threads_of_this_process_is_refused(monkeypatch):
    monkeypatch.setattr("geometry.air.apart._ASLEEP", 0.3)
    with pytest.raises(Refusal, match="gmsh does not wake up in a copy of this process"):
        apart(signal.pause, "gmsh")


def test_a_mistake_of_the_program_is_not_taken_for_a_solid_that_cannot_be_meshed(monkeypatch):
    def mistaken(*_):
        raise TypeError("no such argument")

    monkeypatch.setattr("geometry.air.mesh._set_sizes", mistaken)
    with pytest.raises(TypeError, match="no such argument"):
        mesh_solid(BOX, {"a": (0.5, 0.5, 0)}, (), SIZES)
