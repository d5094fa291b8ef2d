"""Finer and finer meshes until what is wanted has converged, with an estimate of the error that remains."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import TypeVar

import numpy as np

from geometry.air.mesh import InvertedElementsError
from geometry.ground.refusal import Kind, Refusal

#: A solution on a mesh.
Solution = TypeVar("Solution")

#: Meshes that are compared differ by this much in size at least.
_COARSER = 1.5
#: Orders of convergence believed of flow and heat: 4 is expected along tubes and in layers, 2.2 to 4 at the edges of
#: mouths. From one mesh of a random cell to one 1.5 times finer 3.1 to 6.2 and 2.8 to 3.2 was found; of a dozen changes
#: of the flow two were below 3.5, and the least error that is believed covers them. What two changes of coarse meshes
#: show is chance.
FLOW_ORDER, HEAT_ORDER = 3.5, 2.5
#: Most that is believed; by it, the order of most of the error, the size of the first mesh follows from the accuracy.
BEST_ORDER = 3.5
#: Below this scale two changes in succession show the order, and more is believed where less than the most was.
_FINE = 0.69
_MOST_REFINEMENTS = 4
#: A mesh that misses the accuracy is followed by one that is finer by these factors.
_NEXT_FINER = (1.15, 1.5)
#: Part of the accuracy that the next mesh aims at.
_AIMED_AT = 0.8


class ConvergenceError(Refusal):
    """The meshes did not reach the accuracy asked for."""


@dataclass(frozen=True)
class Refinement:
    """One mesh of a body and how much its answer differs from that of the next coarser one."""

    field: str
    """The field that was solved: ``"heat"`` or ``"flow"``."""
    scale: float
    """Scale of the element sizes, a ratio, see :func:`acoustic_fem.fields.element_sizes.mesh_sizes`."""
    elements: int
    """Number of tetrahedra."""
    change: float | None
    """Relative change from the last mesh that is at least 1.5 times coarser; None where there is none."""


def refined(
    field: str,
    solved_on: Callable[[float, Callable[[float], None]], tuple[Solution, int]],
    change_between: Callable[[Solution, Solution], float],
    scale: float,
    accuracy: float,
    order: float,
    report: Callable[[float], None],
) -> tuple[Solution, float, list[Refinement]]:
    """Solve on finer and finer meshes until the change says that the error is below the accuracy.

    Args:
        field: what is solved.
        solved_on: scale of the mesh and where to report -> the solution and the number of elements.
        change_between: a solution and a coarser one -> relative change.
        scale: of the first mesh that may do; one 1.5 times coarser is solved before it, or two where it is so fine
            that the three show the order, and a better one than ``order`` would be believed.
        accuracy: relative error aimed at.
        order: of convergence that is believed at least, :data:`FLOW_ORDER` or :data:`HEAT_ORDER`.
        report: called with the fraction done, never less than before.

    Returns:
        The solution, its estimated error and the meshes.

    Raises:
        ConvergenceError: four refinements of the first mesh that may do are not enough.
    """
    furthest = 0.0

    def advance(begin: float, end: float, done: float) -> None:
        nonlocal furthest
        furthest = max(furthest, begin + (end - begin) * done)
        report(furthest)

    solved: list[tuple[float, Solution]] = []
    meshes: list[Refinement] = []
    before = 2 if scale < _FINE and order < BEST_ORDER else 1
    failure, following = "", scale * _COARSER**before
    for step in range(-before, _MOST_REFINEMENTS + 1):
        finer = following
        # How far the meshes take us, were the first that may do good enough.
        begin, end = (0.0, 0.3) if step < 0 else (0.3, 0.95)
        try:
            solution, elements = solved_on(finer, partial(advance, begin, end))
        except InvertedElementsError as error:
            # Too coarse for the shape: the comparison starts anew with the next one.
            following, failure = finer / _COARSER, str(error)
            continue
        coarser = next((each for each in reversed(solved) if each[0] >= (1 - 1e-9) * _COARSER * finer), None)
        change = None if coarser is None else change_between(solution, coarser[1])
        meshes.append(Refinement(field, finer, elements, change))
        solved.append((finer, solution))
        if coarser is None or change is None or step < 0:
            following = finer / _COARSER
            continue
        believed = order if finer > _FINE else _shown_order(meshes, order)
        error_left = change / ((coarser[0] / finer) ** believed - 1)
        if error_left <= accuracy:
            report(1.0)
            return solution, error_left, meshes
        failure = f"the mesh error of the {field} is still {error_left:.2g}, above accuracy = {accuracy:g}"
        # As if the change stayed as it is: orders are better than what is believed.
        wanted = coarser[0] / (1 + change / (_AIMED_AT * accuracy)) ** (1 / believed)
        if len(solved) > before + 1:
            # The first mesh misleads: the next one is fine enough to be compared with a later one.
            wanted = min(wanted, solved[-2][0] / _COARSER)
        following = float(np.clip(wanted, finer / _NEXT_FINER[1], finer / _NEXT_FINER[0]))
    raise ConvergenceError(f"after {_MOST_REFINEMENTS} refinements {failure}", kind=Kind.NO_RESULT)


def _shown_order(meshes: list[Refinement], least: float) -> float:
    """Order of convergence that the last three meshes show if they are 1.5 times apart; else the least."""
    sizes, changes = [mesh.scale for mesh in meshes[-3:]], [mesh.change for mesh in meshes[-2:]]
    steps = [coarse / fine for coarse, fine in pairwise(sizes)]
    first, last = changes if len(changes) == 2 else (None, None)
    if len(steps) < 2 or not first or not last or max(abs(step / _COARSER - 1) for step in steps) > 1e-6:
        return least
    return float(np.clip(np.log(first / last) / np.log(_COARSER), least, BEST_ORDER))
