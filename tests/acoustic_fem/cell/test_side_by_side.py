"""Processes that solve cells one after another: which are started, which are left to the next cell, and their ends."""

import dataclasses
import os
import signal
import sys
import time
import warnings

import numpy as np
import pytest
from coarse_cells import coarse_cells, coarse_in_children
from reference_data import AIR

from acoustic_fem.cell import side_by_side
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.cell.one_cell import CellError
from geometry.air.cells import Cell
from geometry.ground.refusal import Kind
from geometry.schema.ports import CellPort

CHAMBER = Cell("microphone", 2.2, 1.3, 0.65, (CellPort(0.0, 0.44),), 0.5, 0.3)


@pytest.fixture
def begun(monkeypatch, tmp_path):
    """Processes that were started; those that rest before and after are of no other test."""
    found = []

    def noted(*arguments, **options):
        found.append(side_by_side_child(*arguments, **options))
        return found[-1]

    side_by_side_child = side_by_side.Child
    monkeypatch.setattr(side_by_side, "Child", noted)
    coarse_in_children(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.setenv("ACOUSTIC_FEM_CACHE", str(tmp_path / "cells"))
    monkeypatch.setattr(side_by_side, "_resting", [])
    yield found
    for child in found:
        child.kill()


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
    assert len(begun) == 2
    assert not any(child.is_alive for child in begun)
    for cell, expected in zip(cells, alone, strict=True):
        np.testing.assert_allclose(together[cell].admittance, expected, rtol=1e-9)
    assert fractions == sorted(fractions)
    assert fractions[-1] == pytest.approx(1.0)


@pytest.mark.slow
def test_a_process_is_left_to_the_next_cell_where_nothing_has_changed(begun, monkeypatch):
    first = apart(CHAMBER)
    apart(higher(1.1))
    assert len(begun) == 1
    begun[0].kill()
    apart(higher(1.2))
    assert len(begun) == 2
    monkeypatch.setenv("OF_ANOTHER", "environment")
    apart(higher(1.3))
    assert [child.is_alive for child in begun] == [False, False, True]
    with coarse_cells():
        np.testing.assert_allclose(solve_cells([CHAMBER], [10.0], AIR)[CHAMBER].admittance, first, rtol=1e-9)


@pytest.mark.slow
def test_a_program_that_ends_well_and_solves_nothing_is_an_error(begun, monkeypatch):
    monkeypatch.setattr(sys, "executable", "/bin/true")
    with pytest.raises(CellError) as ended:
        apart(CHAMBER)
    assert ended.value.kind is Kind.STOPPED
    assert CHAMBER.label in str(ended.value)
    assert len(begun) == 1


@pytest.mark.slow
def test_a_forked_program_leaves_the_processes_of_the_other_alone(begun):
    apart(CHAMBER)
    if not (fork := os.fork()):
        side_by_side._resting[0].child.kill()
        os._exit(0)
    os.waitpid(fork, 0)
    apart(higher(1.1))
    assert len(begun) == 1


@pytest.mark.slow
def test_an_interrupt_does_not_reach_a_process_that_rests(begun):
    apart(CHAMBER)
    begun[0]._process.send_signal(signal.SIGINT)
    apart(higher(1.1))
    assert len(begun) == 1


@pytest.mark.slow
def test_a_process_without_a_cell_ends_after_a_while(begun, monkeypatch):
    monkeypatch.setattr(side_by_side, "_IDLE", 0.2)
    apart(CHAMBER)
    end = time.monotonic() + 60
    while begun[0].is_alive:
        assert time.monotonic() < end
        time.sleep(0.05)
    assert not side_by_side._resting


@pytest.mark.slow
def test_whoever_stops_waiting_ends_the_processes(begun):
    def interrupted(label, fraction):
        raise KeyboardInterrupt

    with coarse_cells(), pytest.raises(KeyboardInterrupt):
        solve_cells([CHAMBER], [10.0], AIR, progress=interrupted, apart=True)
    assert not begun[0].is_alive


def warn_and_solve(task, report):
    warnings.warn("the mesh is coarse", UserWarning, stacklevel=1)
    return {}, {}


def test_warnings_of_a_process_are_passed_on(begun, monkeypatch):
    kept = []
    monkeypatch.setattr(side_by_side, "_solve", solve_with_warning)
    with pytest.warns(UserWarning, match="the mesh is coarse"):
        side_by_side.solve_side_by_side(
            [side_by_side.CellTask(CHAMBER, AIR, (1.0, 2.0), "helmholtz")], 1, print, lambda *found: kept.append(found)
        )
    assert len(kept) == 1


def solve_with_warning(task, tell):
    side_by_side.solve_task = warn_and_solve
    return side_by_side._solve(task, tell)
