"""Work in a process of its own: what it returns and raises comes back; a crash or Ctrl-C ends it alone."""

import os
import signal

import cadquery as cq
import pytest

from geometry.air.apart import apart
from geometry.air.mesh import MeshError, MeshSizes, mesh_solid
from geometry.refusal import Refusal

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


def test_a_solid_is_meshed_alike_in_either_process():
    here, there = (mesh_solid(BOX, {"a": (0.5, 0.5, 0)}, (), SIZES, beat) for beat in (None, lambda: None))
    assert (here.nodes == there.nodes).all()
    assert (here.tetrahedra == there.tetrahedra).all()


def test_a_mistake_of_the_program_is_not_taken_for_a_solid_that_cannot_be_meshed(monkeypatch):
    def mistaken(*_):
        raise TypeError("no such argument")

    monkeypatch.setattr("geometry.air.mesh._set_sizes", mistaken)
    with pytest.raises(TypeError, match="no such argument"):
        mesh_solid(BOX, {"a": (0.5, 0.5, 0)}, (), SIZES)
