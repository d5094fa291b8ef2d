"""A small array and a whole run of it, for the tests of the run and of its report."""

from __future__ import annotations

import functools

from shared import shared, shared_folder

import geometry
from geometry.design.array_design import ArrayDesign
from localize import TrainingPlan
from studies.run.pipeline import run_design
from studies.run.run_result import RunResult

PLAN = TrainingPlan(seconds_per_point=60, epochs=3, microphone_noise="design")


def small_design() -> ArrayDesign:
    """The reference array with three points in one row."""
    return geometry.prototype("array-2x6").with_values({"name": "row-3", "lines.0.points": 3, "layout.columns": 3})


@functools.cache
def small_run() -> RunResult:
    """One run for all tests, at fidelity lumped; nobody writes into its folder."""
    folder = shared_folder() / "row-3"
    return shared("small-run", lambda: run_design(small_design(), folder, fidelity="lumped", plan=PLAN))
