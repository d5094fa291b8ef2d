"""Finer and finer meshes until what is wanted has converged, with an estimate of the error that remains."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

import numpy as np

from geometry.refusal import Refusal

#: What is solved on a mesh.
Solution = TypeVar("Solution")

_COARSER = 1.5
#: Orders of convergence believed: 4 is expected along tubes and in layers, 2 at the edges of mouths, where fine meshes
#: get finer with the square of the scale. What three meshes show is taken between these bounds; coarse ones show
#: chance. Where there are but two the least is taken.
_LEAST_ORDER, BEST_ORDER = 2.0, 3.5
_MOST_REFINEMENTS = 3


class ConvergenceError(Refusal):
    """The meshes did not reach the accuracy asked for."""


@dataclass(frozen=True)
class Refinement:
    """One mesh of a body and how much its answer differs from that of the next coarser one."""

    field: str
    """What was solved: ``"heat"`` or ``"flow"``."""
    scale: float
    """Scale of the element sizes, a ratio, see :func:`acoustic_fem.fields.element_sizes.mesh_sizes`."""
    elements: int
    """Number of tetrahedra."""
    change: float | None
    """Relative change from a mesh 1.5 times coarser; None for the first."""


def refined(
    field: str,
    solved_on: Callable[[float, Callable[[float], None]], tuple[Solution, int]],
    change_between: Callable[[Solution, Solution], float],
    scale: float,
    accuracy: float,
    report: Callable[[float], None],
) -> tuple[Solution, float, list[Refinement]]:
    """Solve on finer and finer meshes until the change says that the error is below the accuracy.

    Args:
        field: what is solved.
        solved_on: scale of the mesh and where to report -> the solution and the number of elements.
        change_between: a solution and the next coarser one -> relative change.
        scale: of the first mesh that may do; two are solved before it, each 1.5 times coarser than the next.
        accuracy: relative error aimed at.
        report: called with the fraction done, never less than before.

    Returns:
        The solution, its estimated error and the meshes.

    Raises:
        ConvergenceError: three refinements of the first mesh that may do are not enough.
    """
    from geometry.air.mesh import InvertedElementsError

    furthest = 0.0

    def advance(begin: float, end: float, done: float) -> None:
        nonlocal furthest
        furthest = max(furthest, begin + (end - begin) * done)
        report(furthest)

    coarser: Solution | None = None
    changes: list[float] = []
    meshes: list[Refinement] = []
    failure = ""
    for step in range(-2, _MOST_REFINEMENTS + 1):
        finer = scale / _COARSER**step
        # How far the meshes take us, were the first that may do good enough.
        begin, end = {-2: (0.0, 0.1), -1: (0.1, 0.3)}.get(step, (0.3, 0.95))
        try:
            solution, elements = solved_on(finer, partial(advance, begin, end))
        except InvertedElementsError as error:
            # Too coarse for the shape: the comparison starts anew with the next one.
            coarser, changes, failure = None, [], str(error)
            continue
        if coarser is not None:
            changes.append(change_between(solution, coarser))
        meshes.append(Refinement(field, finer, elements, changes[-1] if changes else None))
        coarser = solution
        if step < 0 or not changes:
            continue
        error_left = _remaining_error(changes)
        if error_left <= accuracy:
            report(1.0)
            return solution, error_left, meshes
        failure = f"the mesh error of the {field} is still {error_left:.2g}, above accuracy = {accuracy:g}"
    raise ConvergenceError(f"after {_MOST_REFINEMENTS} refinements {failure}")


def _remaining_error(changes: list[float]) -> float:
    """Error of the finest mesh from the last changes, if they go on to fall as they did (Richardson)."""
    order = _LEAST_ORDER
    if len(changes) > 1 and min(changes[-2:]) > 0:
        shown = np.log(changes[-2] / changes[-1]) / np.log(_COARSER)
        order = float(np.clip(shown, _LEAST_ORDER, BEST_ORDER))
    return changes[-1] / (_COARSER**order - 1)
