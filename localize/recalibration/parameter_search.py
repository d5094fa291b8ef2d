"""Sensors that unlabelled touches may have come from: maxima of their likelihood times the priors.

With sharp likelihoods there are many: a sensor whose points are all taken for their neighbours explains most touches
too. With a high assumed noise there is one, so that the noise is lowered in stages and the maximum followed. To learn
whether it is the right one, others are sought on purpose from the second stage on: from sensors whose points lie one
place further along a line, both ways, and from a higher and a lower modulus. Candidates that a stage brings to one
sensor, or that are far behind the best, are followed no further.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from time import thread_time

import numpy as np
import scipy.optimize
import torch
from numpy.typing import NDArray

from acoustic_fem.calibration.fitted_model import UpdatedModel
from geometry.ground.typed import Array
from localize.recalibration.marginal_likelihood import MarginalLikelihood
from localize.recalibration.recalibration_options import RecalibrationOptions
from localize.signals.threads import one_thread


@dataclass(frozen=True, eq=False)
class Candidate:
    """Maximum of the likelihood times the priors."""

    start: str
    """Name of what it was found from."""
    parameters: Array
    """Parameters at the maximum, in standard deviations of the priors; (count,) float64."""
    value: float
    """Log-likelihood of the frames - |u|^2 / 2, nats."""
    named: NDArray[np.int64]
    """Most probable point of each frame, from 0; (n,) int64."""

    def is_distinct(self, other: Candidate, fraction: float) -> bool:
        """True if the two maxima assign more than this fraction of the frames to different points."""
        return bool((self.named != other.named).mean() > fraction)


class TimeLimit:
    """Limit of the processor time of a search, counted from its construction.

    Args:
        seconds: the limit, s; None for none.
    """

    def __init__(self, seconds: float | None) -> None:
        self._end = np.inf if seconds is None else thread_time() + seconds
        self.ended_a_search = False
        """True once a search was ended."""

    def is_up(self) -> bool:
        """True if the time is up, and a search must end."""
        self.ended_a_search |= thread_time() > self._end
        return self.ended_a_search


@one_thread()
def search(
    model: UpdatedModel,
    stages: tuple[MarginalLikelihood, ...],
    line: NDArray[np.int64],
    options: RecalibrationOptions = RecalibrationOptions(),
    limit: TimeLimit | None = None,
) -> list[Candidate]:
    """Distinct maxima at the last stage, the best one first.

    Once the time is up, only the best sensor goes through the stages that are left, without steps of its own.

    Args:
        model: the family.
        stages: the same frames at falling noise, two or more.
        line: (n_point,) int64, line of each point; points of a line follow each other.
        options: of the calibration.
        limit: of the time of the search; None for none.
    """
    nominal = np.zeros(model.count)
    starts = [("present", nominal), *_moduli(model, options.moduli)]
    found: list[Candidate] = []
    for number, stage in enumerate(stages):
        reached = list[Candidate]()
        for start, u in starts:
            if reached and limit is not None and limit.is_up():
                break
            reached.append(ascend(model, stage, u, start, options=options, limit=limit))
        found = distinct(reached, options)
        starts = [(one.start, one.parameters) for one in found]
        if number == 0:
            starts += _shifted(model, found[0].parameters, line, options.shift_error)
    best = ascend(model, stages[-1], found[0].parameters, found[0].start, options.fine_gain, options, limit)
    return distinct([best, *found[1:]], options)


def distinct(candidates: list[Candidate], options: RecalibrationOptions = RecalibrationOptions()) -> list[Candidate]:
    """Candidates without repetitions and those far behind, the best one first."""
    kept: list[Candidate] = []
    for one in sorted(candidates, key=lambda candidate: -candidate.value):
        if all(one.is_distinct(other, options.distinct_fraction) for other in kept) and (
            not kept or one.value > kept[0].value - options.far_behind
        ):
            kept.append(one)
    return kept


def ascend(
    model: UpdatedModel,
    likelihood: MarginalLikelihood,
    u: Array,
    start: str,
    precision: float | None = None,
    options: RecalibrationOptions = RecalibrationOptions(),
    limit: TimeLimit | None = None,
) -> Candidate:
    """Maximum near a sensor, by L-BFGS in coordinates in which the likelihood is about as wide everywhere.

    Args:
        model: the family.
        likelihood: of the frames.
        u: (count,) float64, where to begin, in standard deviations of the priors.
        start: what to call it.
        precision: gain of a step, over the objective, below which it ends; by default the coarse one.
        options: of the calibration.
        limit: of the time, at which the ascent ends where it is; None for none.
    """
    if limit is not None and limit.is_up():
        value, _ = value_and_slope(model, likelihood, u)
        named = likelihood.evidence(model.transfer_function(u[None])[0]).probability.argmax(1)
        return Candidate(start, u, value - 0.5 * float(u @ u), named)
    scale = _scale(model, likelihood, u)

    def falling(v: Array) -> tuple[float, Array]:
        here = scale @ v
        # no part deviates that far from its design, and a long step there would end in an impossible part
        possible = np.clip(here, -options.farthest, options.farthest)
        value, slope = value_and_slope(model, likelihood, possible)
        return 0.5 * float(here @ here) - value, scale.T @ (here - np.where(possible == here, slope, 0))

    def ended(intermediate_result: scipy.optimize.OptimizeResult) -> None:
        if limit is not None and limit.is_up():
            raise StopIteration

    best = scipy.optimize.minimize(
        falling,
        np.linalg.solve(scale, u),
        jac=True,
        method="L-BFGS-B",
        callback=ended,
        options={
            "maxiter": options.most_steps,
            "maxcor": 20,
            "ftol": precision or options.coarse_gain,
        },
    )
    there = np.clip(scale @ best.x, -options.farthest, options.farthest)
    named = likelihood.evidence(model.transfer_function(there[None])[0]).probability.argmax(1)
    return Candidate(start, there, -float(best.fun), named)


def value_and_slope(model: UpdatedModel, likelihood: MarginalLikelihood, u: Array) -> tuple[float, Array]:
    """Log-likelihood of the frames on a sensor, and its derivative by the parameters.

    Args:
        model: the family.
        likelihood: of the frames.
        u: (count,) float64, parameters in standard deviations of the priors.

    Returns:
        Log-likelihood, nats, and (count,) float64, nats per standard deviation.
    """
    parameters = torch.tensor(u[None], requires_grad=True)
    h = model.transfer_function(parameters)[0]
    value, slope = likelihood.slope(h.detach().numpy())
    # the product's derivative is the slope carried on to the parameters
    torch.view_as_real(h.resolve_conj()).mul(torch.view_as_real(torch.from_numpy(slope))).sum().backward()
    assert parameters.grad is not None
    return value, parameters.grad[0].numpy()


def _scale(model: UpdatedModel, likelihood: MarginalLikelihood, u: Array) -> Array:
    information = likelihood.information(model.transfer_function(u[None])[0], model.jacobian(u))
    values, vectors = np.linalg.eigh(information)
    return np.asarray(vectors / np.sqrt(1 + np.maximum(values, 0)))


def _moduli(model: UpdatedModel, moduli: tuple[float, ...]) -> Iterator[tuple[str, Array]]:
    of_all = np.eye(model.count)[model.names.index("modulus of all membranes")]
    for deviations in moduli:
        yield f"modulus {deviations:+g} deviations", deviations * of_all


def _shifted(model: UpdatedModel, u: Array, line: NDArray[np.int64], error: float) -> Iterator[tuple[str, Array]]:
    """Sensors that may be mistaken for the one at u: each point of a line answers as its neighbour does there."""
    h, jacobian = model.transfer_function(u[None])[0], model.jacobian(u)
    # the source's spectrum is not known: what tells points apart is one microphone by another
    by_parameters = jacobian[:, :, 1:] / h[:, 1:] - jacobian[:, :, :1] / h[:, :1]
    for number in np.unique(line):
        points = np.flatnonzero(line == number)
        if len(points) < 3:
            continue
        for here, there, text in ((points[:-1], points[1:], "forwards"), (points[1:], points[:-1], "backwards")):
            ratio = (h[there, 1:] / h[there, :1]) / (h[here, 1:] / h[here, :1])
            wanted = np.log(ratio) / error
            rows = (by_parameters[:, here] / error).reshape(model.count, -1)
            a = np.concatenate([rows.real, rows.imag], axis=1)
            b = np.concatenate([wanted.real.ravel(), wanted.imag.ravel()])
            yield f"line {number + 1} {text}", u + np.linalg.solve(a @ a.T + np.eye(model.count), a @ b)
