"""Gradient descent on the continuous parameters of a study, through the lumped network on torch tensors.

Each step follows the gradient of smooth stand-ins for the figures of merit and is then cut back, field by field, to
what can be printed and laid out, which has no gradient. What comes out is computed again exactly and kept only where
it keeps all limits.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from geometry.refusal import Refusal
from studies.optimization.problem import Optimization, searched_range
from studies.optimization.search import Candidate, OptimizationResult, evaluated, ranked, refusal_of, rounded
from studies.optimization.smooth_model import DIFFERENTIABLE, SmoothModel

if TYPE_CHECKING:
    from torch import Tensor

#: Most designs that descend, one after the other.
STARTS = 8
#: Of a range, in one step at the most; falls to a tenth of it towards the end.
_STEP = 0.03
_MARGIN = 0.01
"""Share by which limits are kept on the way, against what the stand-ins are off."""
_PENALTY = 30.0


def refine(
    problem: Optimization, starts: Sequence[Candidate], progress: Callable[[str, float], None] | None = None
) -> tuple[Candidate, ...]:
    """Designs by descent from those that keep all limits, towards a better first objective.

    The other objectives may not become worse than they are at the start, limits stay kept. Parameters that are no
    continuous range, or have no derivative, stay as they are; limits on metrics without derivative are kept by
    looking at the design that comes out.

    Args:
        problem: with a lumped study and a first objective of :data:`DIFFERENTIABLE`.
        starts: at most :data:`STARTS` of one wiring are taken.
        progress: called with what is being done and the fraction done.

    Returns:
        Those that came out better, computed exactly, numbered from -2 downwards.

    Raises:
        Refusal: the study is not lumped, or the first objective has no derivative, or no parameter has.
    """
    check_refinable(problem)
    report = progress or (lambda message, fraction: None)
    found: list[Candidate] = []
    for number, start in enumerate(starts[:STARTS]):
        report(f"design {number + 1}", number / min(len(starts), STARTS))
        better = _descended(problem, start, -2 - number)
        if better is not None:
            found.append(better)
    report("done", 1.0)
    return tuple(found)


def check_refinable(problem: Optimization) -> None:
    """Refuse what :func:`refine` cannot do.

    Raises:
        Refusal: as :func:`refine`.
    """
    name = problem.objectives[0].metric.name
    if name not in DIFFERENTIABLE:
        raise Refusal(
            f"optimize.refine needs a first objective with a derivative: {', '.join(DIFFERENTIABLE)}; {name} has none"
        )
    if problem.study.fidelity != "lumped":
        raise Refusal(f"optimize.refine needs fidelity = 'lumped', not {problem.study.fidelity!r}")
    if not _continuous(problem):
        raise Refusal("optimize.refine needs a parameter with a range and a derivative, such as tube.length")


def _continuous(problem: Optimization) -> list[tuple[str, float, float]]:
    found = []
    for axis in problem.study.axes:
        parameter = axis[0]
        if len(axis) == 1 and not parameter.values and SmoothModel.knows(parameter.name, problem.study.base):
            found.append((parameter.name, *searched_range(parameter, problem.rules)))
    return found


def _descended(problem: Optimization, start: Candidate, number: int) -> Candidate | None:
    """The best design on the way that keeps everything; None where none is better than the start."""
    import torch

    names, low, high = (list(column) for column in zip(*_continuous(problem), strict=True))
    ranges = np.array([low, high]).T
    design, reason = refusal_of(problem, start.values)
    if design is None:
        raise Refusal(f"refine: the design to start from is refused: {reason}")
    model = SmoothModel(design, names, ranges, problem.study.frequency)
    width = ranges[:, 1] - ranges[:, 0]
    place = (np.array([start.values[name] for name in names]) - ranges[:, 0]) / width
    bounds = _kept(problem, start)
    momentum, square = np.zeros((2, len(names)))
    visited: list[Candidate] = []
    for step in range(1, problem.refine + 1):
        values = torch.from_numpy(ranges[:, 0] + width * place)[None].requires_grad_()
        loss = _loss(problem, model.figures(values), bounds)
        (gradient,) = torch.autograd.grad(loss, values)
        slope = gradient[0].numpy() * width
        momentum, square = 0.9 * momentum + 0.1 * slope, 0.99 * square + 0.01 * slope**2
        ahead = momentum / (1 - 0.9**step) / (np.sqrt(square / (1 - 0.99**step)) + 1e-12)
        size = _STEP * 0.1 ** (step / problem.refine)
        place = _allowed(problem, start, names, ranges, place, np.clip(place - size * ahead, 0, 1))
        if step % 10 == 0 or step == problem.refine:
            visited.append(evaluated(problem, number, _values(start, names, ranges, place)))
    first = problem.objectives[0]
    sign = 1.0 if first.better == "larger" else -1.0
    keep = [
        each for each in visited
        if each.feasible and all(_excess(each.metrics[name], *ends) <= 0 for name, ends in bounds.items())
    ]  # fmt: skip
    best = max(keep, key=lambda each: sign * each.metrics[first.metric.name], default=start)
    return best if sign * best.metrics[first.metric.name] > sign * start.metrics[first.metric.name] else None


def _kept(problem: Optimization, start: Candidate) -> dict[str, tuple[float | None, float | None]]:
    """Smallest and largest values of metrics: the limits, and the other objectives as they are at the start."""
    bounds: dict[str, tuple[float | None, float | None]] = {
        limit.metric.name: (limit.least, limit.most) for limit in problem.limits
    }
    for objective in problem.objectives[1:]:
        now = start.metrics[objective.metric.name]
        least, most = bounds.get(objective.metric.name, (None, None))
        bounds[objective.metric.name] = (now, most) if objective.better == "larger" else (least, now)
    return bounds


def _excess(value: float, least: float | None, most: float | None) -> float:
    below = 0.0 if least is None else least - value
    above = 0.0 if most is None else value - most
    return max(below, above)


def _loss(
    problem: Optimization, figures: Mapping[str, Tensor], bounds: Mapping[str, tuple[float | None, float | None]]
) -> Tensor:
    import torch

    first = problem.objectives[0]
    loss = torch.log(figures[first.metric.name]).sum() * (-1.0 if first.better == "larger" else 1.0)
    for name, (least, most) in bounds.items():
        if name not in figures:
            continue
        for bound, sign in ((least, 1.0), (most, -1.0)):
            if bound is not None and bound > 0:
                short = torch.relu(sign * math.log(bound) + _MARGIN - sign * torch.log(figures[name]))
                loss = loss + _PENALTY * (short + short**2).sum()
    return loss


def _allowed(
    problem: Optimization,
    start: Candidate,
    names: list[str],
    ranges: NDArray[np.float64],
    now: NDArray[np.float64],
    wanted: NDArray[np.float64],
) -> NDArray[np.float64]:
    """The step, less the fields that would lead to a design that is refused."""
    if refusal_of(problem, _values(start, names, ranges, wanted))[0] is not None:
        return wanted
    place = now.copy()
    for k in np.argsort(-np.abs(wanted - now)):
        trial = place.copy()
        trial[k] = wanted[k]
        if refusal_of(problem, _values(start, names, ranges, trial))[0] is not None:
            place = trial
    return place


def _values(
    start: Candidate, names: list[str], ranges: NDArray[np.float64], place: NDArray[np.float64]
) -> dict[str, Any]:
    at = ranges[:, 0] + (ranges[:, 1] - ranges[:, 0]) * place
    own = {name: rounded(float(value), *ends) for name, value, ends in zip(names, at, ranges.tolist(), strict=True)}
    return start.values | own


def with_refined(problem: Optimization, result: OptimizationResult, refined: Sequence[Candidate]) -> OptimizationResult:
    """Result of a search with the designs found by descent among its own."""
    candidates = (*result.candidates, *refined)
    return replace(result, candidates=candidates, front=ranked(problem, candidates))
