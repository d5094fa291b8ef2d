"""Processes that solve cells one after another: which are started, which are left to the next cell, and their ends."""

import dataclasses
import os
import signal
import subprocess
import sys
import threading

import numpy as np
import pytest
from coarse_cells import coarse_cells, coarse_in_children
from reference_data import AIR

from acoustic_fem.cell import side_by_side
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.cell.one_cell import CellError
from geometry.air.cells import Cell
from geometry.schema.ports import CellPort

CHAMBER = Cell("microphone", 2.2, 1.3, 0.65, (CellPort(0.0, 0.44),), 0.5, 0.3)
PROGRAM = [sys.executable, "-m", "acoustic_fem.cell.side_by_side"]


@pytest.fixture
def begun(monkeypatch, tmp_path):
    """Programs that were started; what rests in them before and after is of no other test."""
    found = []
    start = subprocess.Popen.__init__

    def noted(self, command, *arguments, **options):
        found.append(command)
        start(self, command, *arguments, **options)

    monkeypatch.setattr(subprocess.Popen, "__init__", noted)
    coarse_in_children(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path / "cells"))
    monkeypatch.setattr(side_by_side._Children, "_left", [])
    yield found
    side_by_side._Children.end_left()


def higher(part):
    return dataclasses.replace(CHAMBER, height=part * CHAMBER.height)


def apart(cell):
    with coarse_cells():
        return solve_cells([cell], [10.0], AIR, apart=True)[cell].admittance


@pytest.mark.slow
def test_cells_solved_side_by_side_are_those_solved_alone(begun, tmp_path, monkeypatch):
    # of two processes one solves two
    cells = [CHAMBER, Cell("microphone", 2.0, 1.5, 0.75, (CellPort(0.0, 0.44),), 0.5, 0.3), higher(1.1)]
    monkeypatch.setattr("acoustic_fem.cell.design_cells.cores", lambda: 2)
    fractions = []
    with coarse_cells():
        alone = [solve_cells([cell], [10.0], AIR)[cell].admittance for cell in cells]
        monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path / "together"))
        together = solve_cells(cells, [10.0], AIR, progress=lambda label, done: fractions.append(done))
    assert begun == [PROGRAM] * 2
    assert not side_by_side._Children._left
    for cell, expected in zip(cells, alone, strict=True):
        np.testing.assert_allclose(together[cell].admittance, expected, rtol=1e-9)
    assert fractions == sorted(fractions)
    assert fractions[-1] == pytest.approx(1.0)


@pytest.mark.slow
def test_a_process_is_left_to_the_next_cell_where_nothing_has_changed(begun, monkeypatch):
    first = apart(CHAMBER)
    apart(higher(1.1))
    assert begun == [PROGRAM]
    ((children,),) = [side_by_side._Children._left]
    (child,) = children.resting
    assert [path.suffix for path in children._handover.iterdir()] == [".log"], "results are not kept twice"
    child.process.kill()
    child.process.wait()
    apart(higher(1.2))
    assert begun == [PROGRAM] * 2
    monkeypatch.setenv("OF_ANOTHER", "environment")
    apart(higher(1.3))
    assert begun == [PROGRAM] * 3
    assert all(each.process.poll() is not None for each in children.resting), "the other one has ended"
    with coarse_cells():
        np.testing.assert_allclose(solve_cells([CHAMBER], [10.0], AIR)[CHAMBER].admittance, first, rtol=1e-9)


@pytest.mark.slow
def test_a_program_that_ends_well_and_solves_nothing_is_an_error(begun, monkeypatch):
    monkeypatch.setattr(sys, "executable", "/bin/true")
    with pytest.raises(CellError, match=r"2\.2 x 1\.3 mm .*the solver ended with 0"):
        apart(CHAMBER)
    assert len(begun) == 1


@pytest.mark.slow
def test_a_forked_program_leaves_the_processes_of_the_other_alone(begun):
    apart(CHAMBER)
    if not (fork := os.fork()):
        side_by_side._Children.end_left()
        os._exit(0)
    os.waitpid(fork, 0)
    apart(higher(1.1))
    assert begun == [PROGRAM]


@pytest.mark.slow
def test_an_interrupt_does_not_reach_a_process_that_rests(begun):
    apart(CHAMBER)
    side_by_side._Children._left[0].resting[0].process.send_signal(signal.SIGINT)
    apart(higher(1.1))
    assert begun == [PROGRAM]


@pytest.mark.slow
def test_a_cell_that_comes_as_its_process_ends_is_given_to_another(begun):
    """The process ends well and has solved nothing."""
    children = side_by_side._Children(side_by_side._environment())
    gone = subprocess.Popen([sys.executable, "-c", "input()"], stdin=-1, stdout=-1, text=True)
    child = side_by_side._Child(None, gone, children._handover / "gone.log", rested=True)
    child.complaints.touch()
    threading.Thread(target=children._listen, args=(child,), daemon=True).start()
    children.resting.append(child)
    side_by_side._Children._left.append(children)
    apart(CHAMBER)
    assert begun[-1] == PROGRAM
    assert gone.returncode == 0


def test_a_process_without_a_cell_ends():
    program = "import sys; from acoustic_fem.cell import side_by_side as s; s._IDLE = 0.1; sys.exit(s.solve_as_child())"
    child = subprocess.Popen([sys.executable, "-c", program], stdin=subprocess.PIPE)
    assert child.wait(60) == 0
    child.stdin.close()
