"""The best designs of a study: many proposed at once, computed in one call, and reported back (Optuna).

Every trial is kept in a journal beside the results, so that a search that was killed goes on where it was. A design
that cannot be built, printed or laid out is refused before anything is computed and counts as failed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from geometry import ArrayDesign, DesignError
from geometry.ground.refusal import Kind, counted
from studies.optimization.descent import Descent
from studies.optimization.journal import opened, read_only, read_seal, seal
from studies.optimization.problem import Optimization, printable_rows, searched_range
from studies.study.cases import by_kind
from studies.study.constraints import read_value
from studies.study.parameter import Parameter, StudyError
from studies.study.stock_axes import nearest_values
from studies.sweep.one_design import design_metrics
from studies.sweep.workers import Workers, open_workers

if TYPE_CHECKING:
    import optuna

_PART = 16
"""Designs of a batch that one worker takes at a time."""
_STEP = "step"
"""Attribute of a trial that is a step of a descent."""


@dataclass(frozen=True)
class Candidate:
    """Candidate: a design that was computed."""

    number: int
    """Number of its trial; -1 for the base design."""
    values: dict[str, Any]
    """Values of the parameters by dotted name."""
    metrics: dict[str, float]
    """Figures of merit by name, in their units."""
    feasible: bool
    """True if it keeps all limits."""


@dataclass(frozen=True, eq=False)
class OptimizationResult:
    """Result of a search."""

    base: Candidate
    """Design that the search began from, with its figures."""
    candidates: tuple[Candidate, ...]
    """Designs that were computed, in the order of the trials."""
    refused: tuple[tuple[str, int], ...]
    """Kinds of reasons, each by its first, and how many designs they kept from being computed."""
    front: tuple[Candidate, ...]
    """Designs that keep the limits and that no other beats in all objectives; the best first objective first."""


def search_designs(
    problem: Optimization,
    out: Path,
    *,
    workers: int | None = 1,
    scheduler: str | None = None,
    progress: Callable[[str, float], None] | None = None,
) -> OptimizationResult:
    """Result of a search, which goes on where an earlier one was stopped.

    Args:
        problem: what is wanted.
        out: folder of the journal; it must exist.
        workers: processes on this machine; 1 computes in this one; None: one per core.
        scheduler: address of a dask scheduler whose workers are used instead.
        progress: function that is called with the name of the step and the fraction done, 0 to 1.

    Raises:
        StudyError: the folder holds the journal of another problem.
    """
    report = progress or (lambda message, fraction: None)
    with _quiet(), open_workers(workers, scheduler) as team:
        journal = opened(out, _directions(problem), _identity(problem), problem.study.atlas)
        search = _in_memory(journal, problem)
        done = len(search.trials)
        descent = Descent(problem) if problem.method == "gradient" else None
        while done < problem.trials:
            count = min(problem.batch, problem.trials - done)
            # A sampler's state is not in the journal: every batch has a seed of its own instead.
            search.sampler = _sampler(problem, done)
            _run_batch(search, problem, count, team, descent)
            trials = search.get_trials(deepcopy=False)
            journal.add_trials(trials[len(journal.get_trials(deepcopy=False)) :])
            seal(out)
            done += count
            report(counted(done, "design"), done / problem.trials)
        return _result(search, problem)


def without(problem: Optimization, result: OptimizationResult, failed: Mapping[int, str]) -> OptimizationResult:
    """Result without some candidates, which count among the refused.

    Args:
        problem: what is wanted.
        result: of a search.
        failed: reasons by the numbers of the candidates.
    """
    reasons = dict(result.refused)
    for why in failed.values():
        reasons[why] = reasons.get(why, 0) + 1
    kept = tuple(each for each in result.candidates if each.number not in failed)
    refused = tuple(sorted(reasons.items(), key=lambda pair: (-pair[1], pair[0])))
    return replace(result, candidates=kept, front=ranked(problem, kept), refused=refused)


def refusal_of(problem: Optimization, values: dict[str, Any]) -> tuple[ArrayDesign | None, str]:
    """Design of some values; or None and why it cannot be built, printed, laid out, or is not in the study."""
    study = problem.study
    try:
        design = study.base.with_values(values)
    except DesignError as error:
        return None, str(error)
    for constraint in study.constraints:
        if not constraint.holds({name: read_value(design, name) for name in constraint.names}):
            return None, f"constraint {constraint.text!r} does not hold"
    reasons = problem.rules.refusals(design)
    return (None, reasons[0]) if reasons else (design, "")


def pareto_front(values: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Rows that no other row beats: at least as good in every column, better in one; larger is better.

    Args:
        values: (n, n_objective) float64, each column in the unit of its objective.

    Returns:
        (n,) bool.
    """
    keep = np.ones(len(values), dtype=bool)
    for index, own in enumerate(values):
        if keep[index]:
            beaten = (values <= own).all(axis=1) & (values < own).any(axis=1)
            keep &= ~beaten
    return keep


def ranked(problem: Optimization, candidates: Sequence[Candidate]) -> tuple[Candidate, ...]:
    """Front among candidates that keep the limits; see :class:`OptimizationResult`."""
    feasible = [each for each in candidates if each.feasible]
    if not feasible:
        return ()
    sign = [1.0 if objective.better == "larger" else -1.0 for objective in problem.objectives]
    values = np.array([[each.metrics[o.metric.name] for o in problem.objectives] for each in feasible]) * sign
    front = [(tuple(-values[k]), feasible[k]) for k in np.flatnonzero(pareto_front(values))]
    unique: dict[tuple[float, ...], Candidate] = {}
    for key, each in sorted(front, key=lambda pair: (pair[0], pair[1].number)):
        unique.setdefault(key, each)
    return tuple(unique.values())


# -- trials -----------------------------------------------------------------------------------------
def found_so_far(problem: Optimization, out: Path) -> OptimizationResult:
    """Result as far as the journal in a folder holds it; nothing is computed but the base, nothing written.

    Raises:
        StudyError: the journal is damaged, or of another problem.
    """
    with _quiet(), read_only(out, _directions(problem), _identity(problem)) as journal:
        return without(problem, _result(journal, problem), read_seal(out).unprintable)


def _directions(problem: Optimization) -> list[Literal["minimize", "maximize"]]:
    return [objective.direction for objective in problem.objectives]


def _in_memory(journal: optuna.Study, problem: Optimization) -> optuna.Study:
    """A study to search with: the journal waits for the disk at every word, so that whole trials are added to it.

    A batch that a kill cut short is dropped: it is proposed and computed again, from the same seed.
    """
    import optuna

    search = optuna.create_study(directions=_directions(problem))
    trials = journal.get_trials(deepcopy=False)
    whole = len(trials) if len(trials) >= problem.trials else len(trials) // problem.batch * problem.batch
    search.add_trials(trials[:whole])
    return search


def _identity(problem: Optimization) -> dict[str, Any]:
    """Settings that must agree for trials to belong to one search, as JSON keeps them."""
    return {
        "study": problem.study.digest(),
        "metrics": [metric.name for metric in problem.metrics],
        "objectives": [[each.metric.name, each.better] for each in problem.objectives],
        "limits": [[each.metric.name, each.least, each.most] for each in problem.limits],
        "batch": problem.batch,
        "method": problem.method,
        "printable": problem.rules.demand,
    }


def _sampler(problem: Optimization, done: int) -> optuna.samplers.BaseSampler:
    import optuna

    seed = int(np.random.SeedSequence([problem.study.seed, done]).generate_state(1)[0])
    if problem.method == "nsga2":
        return optuna.samplers.NSGAIISampler(population_size=problem.batch, seed=seed)
    if problem.method == "tpe":
        return optuna.samplers.TPESampler(seed=seed, multivariate=True, n_startup_trials=min(problem.batch, 64))
    return optuna.samplers.RandomSampler(seed=seed)


def _run_batch(search: optuna.Study, problem: Optimization, count: int, team: Workers, descent: Descent | None) -> None:
    import optuna

    last = search.trials[-1].user_attrs.get(_STEP) if search.trials else None
    if descent is not None:
        for step in descent.steps(last, count):
            search.enqueue_trial(descent.values(step), {_STEP: asdict(step)})
    trials = [search.ask() for _ in range(count)]
    kept: list[tuple[optuna.Trial, dict[str, Any], ArrayDesign]] = []
    for trial in trials:
        values = _proposed(trial, problem)
        trial.set_user_attr("values", values)
        design, reason = refusal_of(problem, values)
        if design is None:
            trial.set_user_attr("reason", reason)
            search.tell(trial, state=optuna.trial.TrialState.FAIL)
        else:
            kept.append((trial, values, design))
    if not kept:
        return
    names = [metric.name for metric in problem.metrics]
    parts = -(-len(kept) // _PART)
    proposed, designs = [values for _, values, _ in kept], [design for _, _, design in kept]
    discs = None if descent is None else descent.discs
    table, reasons = design_metrics(proposed, problem.study, problem.metrics, team, parts, designs, discs)
    for (trial, _, _), row, reason in zip(kept, table, reasons, strict=True):
        figures = dict(zip(names, (float(value) for value in row), strict=True))
        bad = [name for name, value in figures.items() if not math.isfinite(value)]
        if reason or bad:
            trial.set_user_attr("reason", reason or f"{bad[0]} is not finite")
            search.tell(trial, state=optuna.trial.TrialState.FAIL)
            continue
        trial.set_user_attr("metrics", figures)
        for limit in problem.limits:
            trial.set_constraint(limit.metric.name, limit.excess(figures[limit.metric.name]))
        search.tell(trial, [figures[objective.metric.name] for objective in problem.objectives])


def _proposed(trial: optuna.Trial, problem: Optimization) -> dict[str, Any]:
    """Values of a trial; steps along slopes become the nearest sizes that can be bought."""
    if problem.free is not None:
        return nearest_values(problem.study.axes, _suggested(trial, problem, problem.free.axes))
    return _suggested(trial, problem, problem.study.axes)


def _suggested(trial: optuna.Trial, problem: Optimization, axes: Iterable[tuple[Parameter, ...]]) -> dict[str, Any]:
    values: dict[str, Any] = {}
    for axis in axes:
        label = " & ".join(parameter.name for parameter in axis)
        first = axis[0]
        if all(parameter.values and not parameter.ends for parameter in axis):
            rows = printable_rows(axis, problem.rules)
            index = rows[trial.suggest_int(label, 0, len(rows) - 1)]
            values |= {parameter.name: parameter.values[index] for parameter in axis}
        elif len(axis) == 1:
            low, high = searched_range(first, problem.rules)
            if first.whole:
                values[first.name] = trial.suggest_int(label, round(low), round(high))
            else:
                value = trial.suggest_float(label, low, high, log=first.scale == "log")
                values[first.name] = _had(first, value, low)
        else:
            place = np.array([trial.suggest_float(label, 0.0, 1.0)])
            values |= {parameter.name: _at(parameter, place) for parameter in axis}
    return values


def _at(parameter: Parameter, place: NDArray[np.float64]) -> float | int | str:
    value = parameter.at(place)[0]
    if isinstance(value, str):
        return value
    return int(value) if parameter.whole else float(value)


def _had(parameter: Parameter, value: float, low: float) -> float:
    """The nearest size that can be had and is not below what can be printed."""
    size = float(parameter.to_stock_size(np.array([value]))[0])
    if size >= low:
        return size
    return float(parameter.to_stock_size(np.array([size + parameter.step]))[0]) if parameter.step else low


def _result(search: optuna.Study, problem: Optimization) -> OptimizationResult:
    import optuna

    base = _base(problem)
    candidates, reasons = [], list[tuple[int, str]]()
    for trial in search.trials:
        if trial.state == optuna.trial.TrialState.COMPLETE:
            figures = trial.user_attrs["metrics"]
            candidates.append(Candidate(trial.number, trial.user_attrs["values"], figures, _keeps(problem, figures)))
        elif "reason" in trial.user_attrs:
            reasons.append((trial.number, trial.user_attrs["reason"]))
    refused = tuple((reason, len(numbers)) for reason, numbers in by_kind(reasons).items())
    return OptimizationResult(base, tuple(candidates), refused, ranked(problem, candidates))


def _keeps(problem: Optimization, figures: dict[str, float]) -> bool:
    """True if figures keep all limits."""
    return all(limit.excess(figures[limit.metric.name]) <= 0 for limit in problem.limits)


def _base(problem: Optimization) -> Candidate:
    """The design the search begins from.

    Raises:
        StudyError: it cannot be computed.
    """
    with open_workers(1, None) as team:
        table, (reason,) = design_metrics([{}], problem.study, problem.metrics, team)
    if reason:
        words = f"cannot be computed: {reason}"
        raise StudyError(words, kind=Kind.NO_RESULT, file=problem.study.base.name)
    figures = {metric.name: float(value) for metric, value in zip(problem.metrics, table[0], strict=True)}
    return Candidate(-1, {}, figures, _keeps(problem, figures))


@contextmanager
def _quiet() -> Iterator[None]:
    """Optuna writes a line for every trial."""
    import optuna

    before = optuna.logging.get_verbosity()
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    try:
        yield
    finally:
        optuna.logging.set_verbosity(before)
