"""Studies begun from the form of a design: their file, their run, and what they found as figures."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from pathlib import Path
from shutil import make_archive
from time import monotonic
from types import MappingProxyType
from typing import Any

import numpy as np
import tomlkit

from acoustic_fem.atlas.cell_table import cell_atlas
from acoustic_fem.numerics.disk_cache import cache_folder
from acoustic_fem.quantities.fidelity import CLOSED_FORMS, MANY_DESIGNS
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import write_design
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.text_files import parse_toml
from geometry.ground.whole_files import temporary_folder, write_text
from studies.findings.page import design_of
from studies.findings.result_table import Column, ResultTable, effect, fast_front, table_of_search, table_of_sweep
from studies.findings.searching import optimize
from studies.optimization.journal import journal_exists
from studies.optimization.problem import Limit, read_optimization
from studies.optimization.search import found_so_far
from studies.output.display import Report
from studies.panels.cad_panel import CallbackDisplay
from studies.study.metric_registry import METRICS, metrics_named
from studies.study.parameter import StudyError
from studies.study.study import read_study
from studies.sweep.progress import Progress
from studies.sweep.results import open_sweep
from studies.sweep.run import run_sweep

#: Figures of merit of one study, as many as a search can weigh against each other.
MOST_METRICS = 4
#: Designs of one study that a page shows; of more the file is for the verbs ``sweep`` and ``optimize``.
MOST_DESIGNS = 4096
#: Seconds between two lines on how far a study is, and digits of the values that are shown.
_PACE, _DIGITS = 0.5, 5
#: Largest bound of a metric, in any unit.
_LARGEST = 1e12


def study_file(
    design: ArrayDesign,
    ranges: Mapping[str, Sequence[float] | Sequence[str]],
    metrics: Sequence[str],
    *,
    search: bool = False,
    designs: int = 256,
    fidelity: str = MANY_DESIGNS,
    limits: Mapping[str, float] = MappingProxyType({}),
) -> str:
    """The study file that ranges around a design amount to.

    Args:
        design: the base, which the file names as ``NAME.toml`` beside it.
        ranges: of each field, by dotted name: where it begins and ends, in its unit, or a list of texts.
        metrics: names of figures of merit, 1 to 4; a search looks for the best of all of them.
        search: search the best designs in place of a sweep over evenly spread ones.
        designs: how many are computed, 1 to 4096.
        fidelity: what the cells are computed with.
        limits: bound of each metric that a design must keep, in its unit, as :func:`limits_of` takes them. A search
            keeps them; a sweep computes their metrics too.

    Returns:
        Text of the file; it was read back and is a study.

    Raises:
        Refusal: not a study: the line that its reader gives.
    """
    if not 1 <= len(metrics) <= MOST_METRICS:
        raise Refusal(
            kind=Kind.OUT_OF_RANGE,
            field="metrics",
            value=list(metrics),
            allowed=f"1 to {MOST_METRICS} figures of merit",
        )
    check_range("designs", designs, 1, MOST_DESIGNS, whole=True)
    stated: dict[str, Any] = {
        "name": f"{design.name[:70]}-{'search' if search else 'sweep'}",
        "base": f"{design.name}.toml",
        "fidelity": fidelity,
    }
    if not search:
        stated |= {"sampling": "sobol", "cases": designs}
    bounds = limits_of(limits)
    computed = metrics if search else dict.fromkeys([*metrics, *limits])
    stated |= {"metrics": list(computed), "vary": tomlkit.table()}
    for name, given in ranges.items():
        stated["vary"].add(tomlkit.key(name), _range(given))
    if search:
        batch = min(64, max(designs // 4, 1))
        objectives = [{"metric": name} for name in metrics]
        stated["optimize"] = {"trials": designs, "batch": batch, "objectives": objectives}
        if bounds:
            stated["optimize"]["limits"] = [_stated_limit(each) for each in bounds]
    text = tomlkit.dumps(stated)
    _read(design, text)
    return text


def limits_of(limits: Mapping[str, float]) -> tuple[Limit, ...]:
    """Limits of metrics: at least of those that should be large, at most of those that should be small.

    Args:
        limits: bound by the name of the metric, in its unit.

    Raises:
        Refusal: no such metric, or a bound that is not finite.
    """
    found = []
    for name, bound in limits.items():
        (metric,) = metrics_named([name])
        check_range(f"limit of {name}", bound, -_LARGEST, _LARGEST)
        found.append(Limit(metric, bound, None) if metric.better == "larger" else Limit(metric, None, bound))
    return tuple(found)


def _stated_limit(limit: Limit) -> dict[str, Any]:
    bound = {"most": limit.most} if limit.least is None else {"least": limit.least}
    return {"metric": limit.metric.name, **bound}


def _range(given: Sequence[float] | Sequence[str]) -> Any:
    if not given or any(isinstance(value, str) for value in given):
        return list(given)
    if len(given) != 2:
        raise Refusal(field="a range", value=list(given), kind=Kind.WRONG_TYPE, allowed="the first and the last value")
    ends = tomlkit.inline_table()
    ends.update({"from": given[0], "to": given[1]})
    return ends


def _read(design: ArrayDesign, text: str) -> Any:
    """The study or the search that a file of ours states."""
    reader = read_optimization if _is_search(text) else read_study
    return reader(text, "the study", base=design)


def _is_search(text: str) -> bool:
    return "optimize" in parse_toml(text, "the study", StudyError)


def write_study(design: ArrayDesign, text: str, path: Path) -> None:
    """Write a study file and its base beside each other into one ZIP file, as ``sweep`` and ``optimize`` take them."""
    with temporary_folder() as folder:
        write_text(folder / "study.toml", text)
        write_text(folder / f"{design.name}.toml", write_design(design))
        make_archive(str(path.with_suffix("")), "zip", str(folder))


def study_folder(design: ArrayDesign, text: str) -> Path:
    """Folder of a study's results, beside the solved cells, so that it goes on where it was.

    By its hash and the digest of the atlas.
    """
    key = hashlib.sha256(json.dumps([text, write_design(design), cell_atlas().digest]).encode()).hexdigest()
    return cache_folder() / "studies" / key


@dataclass(frozen=True)
class FailedDesign:
    """Design of a study without figures."""

    number: int
    """Number of it in its study."""
    reason: str
    """Reason why the case failed."""
    values: Mapping[str, Any]
    """Value of each parameter, by dotted name."""


@dataclass(frozen=True, eq=False)
class FoundDesigns:
    """Designs that a study has computed."""

    table: ResultTable
    """Table of them, with their parameters and metrics."""
    failed: tuple[FailedDesign, ...] = ()
    """Designs that could not be computed, or that break a limit of the search."""

    def design(self, number: Any) -> ArrayDesign:
        """One of the designs, as the verb ``best`` writes it.

        Args:
            number: of it in its study.

        Raises:
            Refusal: there is none of that number.
        """
        numbers = self.table.number.tolist()
        if number not in numbers:
            allowed = f"one of the {len(numbers)} that the study has computed"
            raise Refusal(kind=Kind.UNKNOWN, field="design", value=number, allowed=allowed)
        return design_of(self.table, numbers.index(number))


def run_study(design: ArrayDesign, text: str, notify: Callable[[str], None] = lambda line: None) -> FoundDesigns:
    """Run a study, or go on with it.

    Args:
        design: the base.
        text: as of :func:`study_file`.
        notify: called with how far it is.

    Raises:
        Refusal: what the sweep or the search refuses.
    """
    place, study = study_folder(design, text), _read(design, text)
    place.mkdir(parents=True, exist_ok=True)
    if _is_search(text):
        # Where cells are closed forms a search is over before processes beside this one have started.
        workers = 1 if study.study.fidelity in CLOSED_FORMS else None
        optimize(study, place / "search", workers=workers, display=_Paced(notify))
    else:
        report = _paced(notify)

        def progress(now: Progress) -> None:
            report(f"{now.done} of {now.total} {now.what}{f', {now.failed} failed' * bool(now.failed)}", 0.0)

        objection = run_sweep(study, place / "results.zarr", progress=progress).summary.objection
        if objection:
            raise Refusal(objection, kind=Kind.NO_RESULT)
    return study_so_far(design, text)


def study_so_far(design: ArrayDesign, text: str) -> FoundDesigns:
    """Results of a study as far as it was run.

    Raises:
        Refusal: nothing is there yet.
    """
    place = study_folder(design, text)
    if _is_search(text):
        if not journal_exists(place / "search"):
            raise StudyError("no design was computed yet", kind=Kind.MISSING)
        problem = read_optimization(text, "the study", base=design)
        result = found_so_far(problem, place / "search")
        outside = [
            FailedDesign(each.number, f"not {'; '.join(map(str, problem.limits))}", each.values)
            for each in result.candidates
            if not each.feasible
        ]
        return FoundDesigns(table_of_search(problem, result), tuple(outside))
    sweep = open_sweep(place / "results.zarr")
    failed = [
        FailedDesign(int(number), str(sweep.values["reason"][number]), sweep.case(int(number)))
        for number in np.flatnonzero(sweep.failed)
    ]
    return FoundDesigns(table_of_sweep(sweep), tuple(failed))


class _Paced(CallbackDisplay):
    """A display that reports at a pace at which a page can show it."""

    def _shown(self, name: str) -> Any:
        return nullcontext(_paced(lambda line: self.note(f"{name}: {line}")))


def _paced(notify: Callable[[str], None]) -> Report:
    last = 0.0

    def report(message: str, fraction: float) -> None:
        nonlocal last
        if message and monotonic() - last > _PACE:
            last = monotonic()
            notify(message)

    return report


def study_figures(found: FoundDesigns, limits: Mapping[str, float] = MappingProxyType({})) -> dict[str, Any]:
    """Contents of the page for a study.

    Args:
        found: the designs.
        limits: bounds of metrics as of :func:`limits_of`; a design that breaks one is on no front.

    Returns:
        ``title``, ``source`` ("sweep" or "search"), ``fidelity``; ``waiting``: designs not computed yet; ``failures``:
        kinds of reasons and how many designs failed for each; ``number`` of each design; ``parameters`` and
        ``metrics``: for each its ``name``, ``title``, ``unit``, ``labels`` (texts that values stand for), ``better``
        and ``values``; ``effects``: for each metric and parameter the main effect as of
        :func:`studies.findings.result_table.effect`; ``fronts``: for each two metrics ``first``, ``second`` and the
        ``rows`` that no other design beats in both; ``limits`` in words; ``kept``: whether each design keeps them;
        ``failed``: of each failed design its ``number``, ``reason`` and ``values``, one a parameter as in its column,
        None for a text that no computed design has.
    """
    table, metrics = found.table, found.table.metrics
    bounds = limits_of(limits) if table.source == "sweep" else ()  # a search has left out what breaks its limits
    kept = np.ones(len(table.number), dtype=bool)
    for limit in bounds:
        kept &= np.array([limit.excess(value) <= 0 for value in table.metric(limit.metric.name).values], dtype=bool)
    rows = np.flatnonzero(kept)
    return {
        "title": table.title,
        "source": table.source,
        "fidelity": table.fidelity,
        "waiting": table.waiting,
        "failures": [list(each) for each in table.failures],
        "number": table.number.tolist(),
        "parameters": [_column(each) for each in table.parameters],
        "metrics": [_column(each) for each in metrics],
        "effects": [[_effect(parameter, metric) for parameter in table.parameters] for metric in metrics],
        "fronts": [
            {
                "first": first,
                "second": second,
                "rows": rows[
                    fast_front(np.column_stack([metrics[first].goodness[rows], metrics[second].goodness[rows]]))
                ].tolist(),
            }
            for first in range(len(metrics))
            for second in range(first + 1, len(metrics))
        ],
        "limits": [str(limit) for limit in bounds],
        "kept": kept.tolist(),
        "failed": [
            {
                "number": each.number,
                "reason": each.reason,
                "values": [_value_in(column, each.values.get(column.name)) for column in table.parameters],
            }
            for each in found.failed
        ],
    }


def _value_in(column: Column, value: Any) -> float | None:
    """Value of a parameter as its column has it; None if the column does not have it."""
    if column.labels:
        return float(column.labels.index(str(value))) if str(value) in column.labels else None
    return None if value is None else _numbers([value])[0]


def _column(column: Column) -> dict[str, Any]:
    return column.words | {"values": _numbers(column.values)}


def _effect(parameter: Column, metric: Column) -> dict[str, Any]:
    own = effect(parameter, metric)
    return {key: _numbers(getattr(own, key)) for key in ("centres", "mean", "low", "high")} | {"share": own.share}


def _numbers(values: Any) -> list[float]:
    return [float(f"{value:.{_DIGITS}g}") for value in values]


def metric_words() -> dict[str, dict[str, str]]:
    """Title, unit, definition, the better direction and the caution of every figure of merit that a study can have."""
    return {metric.name: metric.words | {"caution": metric.caution} for metric in METRICS.values()}
