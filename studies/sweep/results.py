"""The results of a sweep, read: tables, designs and libraries of its cases."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
from acoustic_fem.library.provenance import frequency_hash
from acoustic_fem.quantities.fidelity import CLOSED_FORMS
from acoustic_fem.quantities.local_air import design_air
from geometry import ArrayDesign
from geometry.design.design_file import read_completed
from geometry.ground.argument_checks import check_choice, check_range, check_type
from geometry.ground.file_checks import check_entries, check_local, read_bytes
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.shown import Shown
from studies.output.zarr_files import METADATA
from studies.study.metric_registry import METRICS
from studies.study.parameter import StudyError, followers
from studies.sweep.plots import plot_effects, plot_trade_off
from studies.sweep.records import DONE, FAILED, FOLDER, FORMAT, MARK, SPLIT, WAITING, Records, case_key
from studies.sweep.summary import Summary

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.figure import Figure

    from localize.signals.array_response import ArrayResponse

#: Most bytes of what a store of an older version says of itself.
_MOST_METADATA = 2**26
#: Words for the states of a case.
_STATUS = np.array(["waiting", "done", "failed"], object)
#: Attributes of the store that say what the results are, for people.
_FOR_PEOPLE = ("title", "description", "fidelity", "code_version")


@dataclass(frozen=True, eq=False, repr=False)
class Sweep(Shown):
    """Results of a study, finished or not."""

    records: Records
    """Records from which they are read."""
    values: Mapping[str, NDArray[Any]]
    """Values of the parameters, the metrics, ``state`` and ``reason``, (n_case,) each; metrics of what is waiting or
    failed are NaN."""
    solid: frozenset[int] = frozenset()
    """Numbers of the cases outside the atlas that were solved in 3-D."""
    run: Summary | None = None
    """Summary of the run that returned the results; None if they were opened."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        done, failed = int(self.done.sum()), int(self.failed.sum())
        figures = {}
        for name in self.metrics:
            values, unit = self.values[name][np.isfinite(self.values[name])], self.units(name)
            if len(values):
                figures[name] = f"{values.min():.4g} to {values.max():.4g}{'' if unit == '1' else f' {unit}'}"
        return f"Sweep {self.attributes['title']}", {
            "results": self.records.path,
            "cases": f"{len(self)}: {done} done, {failed} failed, {len(self) - done - failed} waiting",
            "varies": ", ".join(self.parameters),
            "fidelity": self.attributes["fidelity"],
            "keeps": self.keep,
            **figures,
        }

    def plot(self, metric: str | None = None, against: str | None = None) -> Figure:
        """Figure of a metric against each parameter, or of the trade-off between two metrics.

        Args:
            metric: name of a metric of the study; by default its first.
            against: another metric, for a trade-off. Cases that no other case beats in both metrics are labelled with
                their number.

        Raises:
            Refusal: the study does not compute a metric.
            MissingExtra: matplotlib is not installed.
        """
        for field, name in (("metric", metric), ("against", against)):
            if name is not None:
                check_choice(field, name, self.metrics, kind=Kind.UNKNOWN)
        chosen = metric or self.metrics[0]
        return plot_effects(self, chosen) if against is None else plot_trade_off(self, chosen, against)

    @property
    def summary(self) -> Summary:
        """Summary of the run that returned the results.

        Raises:
            Refusal: they were opened, not computed.
        """
        if self.run is None:
            problem = "has no summary of a run: the results were opened, not computed"
            raise Refusal(problem, kind=Kind.MISSING, file=self.records.path)
        return self.run

    @property
    def attributes(self) -> dict[str, Any]:
        """Attributes of the results: ``title``, ``description``, ``fidelity``, ``study`` and others."""
        return self.records.layout.attributes

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the variables that were varied."""
        return self.records.parameters

    @property
    def followers(self) -> dict[str, str]:
        """Parameters without values of their own, such as the wire of a spring whose bore varies, and their leaders."""
        return followers([[(each["name"], each["values"]) for each in axis] for axis in self.records.content["vary"]])

    @property
    def metrics(self) -> tuple[str, ...]:
        """Names of the variables that were computed."""
        return self.records.metrics

    @property
    def keep(self) -> str:
        """Results that are kept for each case: "metrics", "responses" (with metrics), or "libraries" (everything that a
        library needs).
        """
        return str(self.records.content["keep"])

    @property
    def frequency(self) -> NDArray[np.float64]:
        """Frequencies of the study; (n_freq,) float64, Hz."""
        return np.array(self.records.content["frequency"], np.float64)

    def __len__(self) -> int:
        return len(self.values["state"])

    def units(self, name: str) -> str:
        """Unit of a variable, "1" for ratios; empty if it is dimensionless."""
        return self.records.layout.variables[name].attributes.get("units", "")

    # -- tables -----------------------------------------------------------------------------------
    def to_dataframe(self) -> pd.DataFrame:
        """Table with one row a case: its parameters, its metrics, ``status`` and ``reason``.

        The index is the number of the case. The status is "done", "failed" or "waiting"; metrics of the latter two are
        NaN.
        """
        import pandas as pd  # takes longer than a sweep is listed in without it

        columns = {name: self.values[name] for name in (*self.parameters, *self.metrics)}
        columns |= {"status": _STATUS[self.values["state"]], "reason": self.values["reason"]}
        return pd.DataFrame(columns, index=pd.RangeIndex(len(self), name="case"))

    def to_xarray(self) -> xr.Dataset:
        """Results as one data set along ``case``, with the parameters and the ``split`` of each case as coordinates.

        Its variables are the metrics, ``status``, ``reason`` and the responses that are kept. Responses are complex and
        are loaded from disk when you use them. They are NaN if a case is waiting, has failed or has fewer points.
        """
        import xarray as xr

        variables = self.records.layout.variables

        def column(name: str) -> tuple[Any, ...]:
            return ("case",), self.values[name], variables[name].attributes

        coordinates: dict[str, Any] = {"case": np.arange(len(self))}
        coordinates |= {name: column(name) for name in (SPLIT, *self.parameters)}
        rows: dict[str, Any] = {name: column(name) for name in self.metrics}
        rows |= {"status": (("case",), _STATUS[self.values["state"]]), "reason": column("reason")}
        for name in self.records.kept:
            dimensions, unit, title = acoustic_fem.library.VARIABLES[name]
            rows[name] = (("case", *dimensions), self._lazy(name), {"units": unit, "long_name": title})
            for each in dimensions:
                known = variables[f"responses/{each}"]
                coordinates[each] = ((each,), known.start(), known.attributes)
        about = {name: self.attributes[name] for name in _FOR_PEOPLE if self.attributes[name]}
        return xr.Dataset(rows, coordinates, about)

    def _lazy(self, name: str) -> Any:
        """A response as an array of dask whose blocks are read when they are used."""
        import dask
        import dask.array as da

        _, *rest = self.records.layout.variables[f"responses/{name}_real"].shape
        read, blocks = dask.delayed(self._response, pure=False), []
        for first, stop in self.records.blocks():
            shape = (stop - first, *rest)
            blocks.append(da.from_delayed(read(name, first, shape), shape, np.complex128))
        return da.concatenate(blocks)

    def _response(self, name: str, first: int, shape: tuple[int, ...]) -> NDArray[np.complex128]:
        if self.values["state"][first] == WAITING:
            return np.full(shape, complex(np.nan, np.nan))
        return self.records.responses(first, (name,))[name]

    # -- cases ------------------------------------------------------------------------------------
    @cached_property
    def base(self) -> ArrayDesign:
        """Design that was varied.

        Raises:
            DesignError: it is not valid in this version.
        """
        return base_of(self.records.path, self.attributes["base_design"])

    @property
    def done(self) -> NDArray[np.bool_]:
        """True if a case was computed without failure; (n_case,) bool."""
        return np.asarray(self.values["state"] == DONE)

    @property
    def failed(self) -> NDArray[np.bool_]:
        """True if a case failed; the reason is in ``values["reason"]``; (n_case,) bool."""
        return np.asarray(self.values["state"] == FAILED)

    def best(self, metric: str, count: int = 10) -> list[int]:
        """Numbers of the best cases by one metric, the best first; equal cases in the order of their numbers.

        Args:
            metric: name of a metric of the study.
            count: at most so many.

        Raises:
            Refusal: the study does not compute the metric, or a count below 1.
        """
        check_choice("metric", metric, self.metrics, kind=Kind.UNKNOWN)
        check_range("count", count, 1, whole=True)
        known = np.flatnonzero(self.done & np.isfinite(self.values[metric]))
        sign = 1.0 if METRICS[metric].better == "smaller" else -1.0
        order = np.argsort(sign * self.values[metric][known], kind="stable")
        return [int(number) for number in known[order[:count]]]

    def case(self, number: int) -> dict[str, Any]:
        """Values of the parameters of one case."""
        values = {name: self.values[name][self._checked(number)] for name in self.parameters}
        return {name: value.item() if hasattr(value, "item") else value for name, value in values.items()}

    def design(self, number: int) -> ArrayDesign:
        """Design of one case.

        Raises:
            DesignError: its values contradict each other, which is why it failed.
            Refusal: the study has no such case.
        """
        return self.base.with_values(self.case(number))

    def library(self, number: int) -> acoustic_fem.Library:
        """Library of one case, of a study with ``keep = "libraries"``.

        In double precision it equals, bit for bit, the library that :func:`acoustic_fem.solve` computes for the design,
        unless the study asks for ``membranes = "interpolated"`` and the provenance of the library says so. One block of
        cases is held in memory, so read the cases in order.

        Args:
            number: of the case.

        Raises:
            Refusal: the study has no such case, does not keep libraries, or the case is waiting or failed.
            StudyError: a part of the results is damaged.
        """
        number, arrays, about = self._computed(number)
        if self.keep != "libraries":
            allowed = "'libraries', in a sweep whose cases have libraries"
            raise Refusal(kind=Kind.MISMATCH, file=self.records.path, field="keep", value=self.keep, allowed=allowed)
        design, place = self.design(number), number % self.records.layout.block
        count, grid = design.point_count, self.frequency
        values = {name: whole[place].copy() for name, whole in arrays.items()}
        for name in ("transfer_function", "point_impedance"):
            values[name] = values[name][:count]
        values["source_response"] = values["transfer_function"] * values["point_impedance"][:, None]
        fidelity = "navier-stokes" if number in self.solid else str(self.attributes["fidelity"])
        made = {name: self.attributes[name] for name in ("code_version", "seed", "python", "libraries")}
        provenance = {
            **made,
            "frequency_sha256": frequency_hash(grid),
            "precision": self.records.precision,
            "sweep": {"title": self.attributes["title"], "case": number},
            **about.get(number, {}),
        }
        if fidelity in CLOSED_FORMS:
            provenance["cells"] = acoustic_fem.library.cell_summaries(design, fidelity)
        return acoustic_fem.library.library_from_arrays(design, grid, values, fidelity, design_air(design), provenance)

    # -- for data sets: an array source of localize.datasets --------------------------------------
    @property
    def case_numbers(self) -> NDArray[np.int64]:
        """Numbers of the cases that were computed, ascending; (n,) int64."""
        return np.flatnonzero(self.done).astype(np.int64)

    @property
    def case_keys(self) -> tuple[str, ...]:
        """Values of the parameters of each case that was computed, as JSON."""
        return tuple(case_key(self.case(int(number))) for number in self.case_numbers)

    @property
    def splits(self) -> NDArray[np.object_]:
        """Split of each case, "train", "validation" or "test", as data sets deal it by default; (n_case,) texts."""
        return self.values[SPLIT]

    @property
    def parameter_names(self) -> tuple[str, ...]:
        """Names of the parameters, as :attr:`parameters`."""
        return self.parameters

    @property
    def parameter_units(self) -> tuple[str, ...]:
        """Unit of each parameter; of a text "number of the value", from 0 in the order of the alphabet."""
        return tuple(
            "number of the value" if self.values[name].dtype == object else self.units(name) or "1"
            for name in self.parameters
        )

    @property
    def array_sizes(self) -> NDArray[np.int64]:
        """Number of points and of microphones of each case that was computed; (n, 2) int64."""
        points = np.zeros(len(self), np.int64)
        for number, line in enumerate(self.base.lines):
            points += np.asarray(self.values.get(f"lines.{number}.points", line.points), np.int64)
        sizes = np.column_stack([points, np.full(len(self), len(self.base.microphones))])
        return np.asarray(sizes[self.done])

    def texts(self, name: str) -> tuple[str, ...]:
        """Texts that the numbers of a parameter stand for in :meth:`parameter_values`, from 0; none if it is a number.

        Args:
            name: of the parameter.
        """
        column = self.values[name]
        return tuple(np.unique(column.astype(str)).tolist()) if column.dtype == object else ()

    def parameter_values(self, case: int) -> NDArray[np.float64]:
        """Values of the parameters of one case, in the units of :attr:`parameter_units`; (n_parameter,) float64."""
        case = self._checked(case)
        return np.array(
            [
                self._texts[name].index(str(self.values[name][case])) if self._texts[name] else self.values[name][case]
                for name in self.parameters
            ],
            np.float64,
        )

    def arrays(self, cases: Sequence[int], sound: bool = False) -> list[ArrayResponse]:
        """Arrays of some cases as data sets take them, of a study that keeps responses or libraries.

        Args:
            cases: numbers of the cases.
            sound: whether their response to room sound is needed. For this the study must keep libraries, and the
                membranes are solved.

        Raises:
            Refusal: as :meth:`library`.
        """
        # In the order of their blocks, because one block is held in memory.
        found = {case: self._array(case, sound) for case in sorted(set(cases))}
        return [found[case] for case in cases]

    def _array(self, case: int, sound: bool) -> ArrayResponse:
        # Lists of the best cases need none of it.
        from localize.signals.array_response import response_of, response_of_design

        if sound:
            return response_of(self.library(case))
        number, arrays, _ = self._computed(case)
        design = self.design(number)
        h = arrays["transfer_function"][number % self.records.layout.block][: design.point_count]
        made = {"sweep": self.attributes["title"], "case": number}
        return response_of_design(design, np.array(h, np.complex128), self.frequency, design_air(design), made)

    def _computed(self, number: int) -> tuple[int, dict[str, NDArray[np.complex128]], Mapping[int, Mapping[str, Any]]]:
        """The number of a case whose responses are kept, the responses of its block, and how they were computed."""
        number = self._checked(number)
        if self.keep == "metrics":
            allowed = "'responses' or 'libraries', in a sweep whose cases have transfer functions"
            raise Refusal(kind=Kind.MISMATCH, file=self.records.path, field="keep", value=self.keep, allowed=allowed)
        if self.values["state"][number] != DONE:
            status, reason = _STATUS[self.values["state"][number]], str(self.values["reason"][number])
            problem = f"is {status}{': ' * bool(reason)}{reason}"
            raise Refusal(problem, kind=Kind.NO_RESULT, file=self.records.path, field="case", value=number)
        return number, *self._held(number - number % self.records.layout.block)

    def _held(self, first: int) -> tuple[dict[str, NDArray[np.complex128]], Mapping[int, Mapping[str, Any]]]:
        """Responses of the block that begins with a case, and how they were computed; the last one stays in memory."""
        if self._last.get("first") != first:
            self._last.clear()
            responses = self.records.responses(first, self.records.kept)
            self._last.update(first=first, block=(responses, self.records.block(first).about))
        found: tuple[dict[str, NDArray[np.complex128]], Mapping[int, Mapping[str, Any]]] = self._last["block"]
        return found

    @cached_property
    def _texts(self) -> dict[str, tuple[str, ...]]:
        return {name: self.texts(name) for name in self.parameters}

    @cached_property
    def _last(self) -> dict[str, Any]:
        return {}

    def _checked(self, number: int) -> int:
        """The number of a case of the study, as a plain whole number."""
        check_type("case", number, (int, np.integer), "a whole number")
        check_range("case", number, 0, len(self) - 1, whole=True, why="the cases of the study", file=self.records.path)
        return int(number)


def base_of(path: Path, text: str) -> ArrayDesign:
    """Design of which the results in a store are changes, from its text there."""
    return read_completed(text, f"{path}: base design").completed()


def open_sweep(path: str | os.PathLike[str]) -> Sweep:
    """Results of a study, even while it runs. Responses are loaded from disk when you use them.

    Raises:
        StudyError: the folder is not the results of a sweep, it holds a pipe, a device or a link, or a record is
            damaged; names the file, and what to do.
    """
    check_local(path, StudyError, "results")
    path = Path(path)
    check_sweep(path)
    try:
        records = Records.of_store(path)
        variables = records.layout.variables
        values = {name: variables[name].start() for name in variables if "/" not in name}
        solid: set[int] = set()
        for first, stop in records.blocks():
            if records.is_done(first):
                found = records.block(first)
                columns: dict[str, Any] = {**found.values, "state": found.state, "reason": found.reason}
                for name, column in columns.items():
                    values[name][first:stop] = column
                solid.update(found.solid)
    except StudyError as error:
        if error.kind is Kind.MISMATCH:
            raise
        remedy = "run the same sweep again to compute the damaged part again"
        raise StudyError.of(error, remedy=remedy) from None
    for name in records.metrics:
        if name not in METRICS:
            raise StudyError(
                "is not a metric of this version", kind=Kind.UNKNOWN, file=path, field="metrics", value=name
            )
    return Sweep(records, values, frozenset(solid))


def is_sweep(path: Path) -> bool:
    """True if a folder holds the results of a sweep, of this version or an older one."""
    return (path / FOLDER).is_dir() or (path / METADATA).exists()


def check_sweep(path: Path) -> None:
    """Refuse a path that is not the results of a sweep of this version, or that holds a pipe, a device or a link."""
    if (path / FOLDER).is_dir():
        check_entries(path, StudyError, "remove it, then run the same sweep again, which writes what is missing")
        return
    older = None
    with suppress(ValueError, KeyError, TypeError, RecursionError):
        older = json.loads(read_bytes(path / METADATA, "a store", StudyError, _MOST_METADATA))["attributes"][MARK]
    if older in (None, FORMAT):
        raise StudyError(f"is not the results of a sweep: it has no {FOLDER}", kind=Kind.MISMATCH, file=path)
    raise StudyError(
        f"is of format {older}; this version of the program reads format {FORMAT}",
        kind=Kind.MISMATCH, file=path, remedy="compute the study again",
    )  # fmt: skip
