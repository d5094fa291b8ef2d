"""A study: a set of designs over a base design, and what to compute for each. Made in Python or read from a file."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import tomlkit
from numpy.typing import NDArray

import acoustic_fem.atlas
from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.quantities.fidelity import CLOSED_FORMS, MANY_DESIGNS, ONE_DESIGN, Fidelity
from geometry import ArrayDesign, DesignError, load_design
from geometry.design.array_design import validated
from geometry.design.design_file import prototype, prototype_names, write_design
from geometry.ground.argument_checks import check_type
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.shown import Shown
from geometry.ground.text_files import parse_toml
from geometry.ground.typed import Array, PathLike
from geometry.ground.whole_files import check_own_kind, write_text
from geometry.schema.field_errors import model_of, nearest
from studies.study.axes import axes_of, case_count
from studies.study.constraints import Constraint, parse_constraint
from studies.study.fields import Keep, Membranes, Outside, Precision, StudyFields
from studies.study.metric_registry import metrics_named
from studies.study.mistaken_files import check_no_design, study_text
from studies.study.parameter import Parameter, Sampling, StudyError, parameter_content

#: Words of older study files, and what is written in their place.
_RENAMED = {
    "transfer_functions": 'keep = "responses" to keep transfer functions, or leave it out',
    "parameters": "[vary]",
    "frequencies": "frequency",
}


class Study(Shown):
    """Study: a set of designs and what to compute for each.

    A study file has the same fields. :meth:`load` reads one and :meth:`save` writes one.
    """

    text: str
    """Text of the study file; of a study made in Python, the file that :meth:`save` writes."""
    name: str
    """Name of the study."""
    description: str
    """Question that it asks, for people."""
    base: ArrayDesign
    """Design that is varied."""
    axes: tuple[tuple[Parameter, ...], ...]
    """Parameters that vary on their own: one parameter, or several that go together."""
    sampling: Sampling
    """Sampling of the cases: every combination, or samples of the ranges."""
    cases: int
    """Number of samples; 0 for a grid."""
    seed: int
    """Seed of the samples."""
    constraints: tuple[Constraint, ...]
    """Conditions that a case must meet to be part of the study."""
    fidelity: Fidelity
    """Fidelity that the cells are computed with."""
    frequency: NDArray[np.float64]
    """Frequencies of the transfer functions; (n_freq,) float64, Hz."""
    metrics: tuple[str, ...]
    """Names of the metrics to compute, of :data:`studies.study.metric_registry.METRICS`."""
    keep: Keep
    """Content of the store for each case: "metrics", also its "responses", or everything that "libraries" need."""
    precision: Precision
    """Precision of the responses that are kept, "double" or "single"."""
    membranes: Membranes
    """How many membranes of different proportions are computed: "interpolated" between solutions, or each "solved"."""
    outside: Outside
    """Fate of a case outside the atlas: "fail", or it is solved with "navier-stokes"."""

    def __init__(
        self,
        base: ArrayDesign | PathLike,
        vary: Mapping[str, Any] | None = None,
        *,
        metrics: Sequence[str],
        together: Iterable[Mapping[str, Any]] = (),
        sampling: str = "grid",
        cases: int | None = None,
        seed: int = 0,
        constraints: Sequence[str] = (),
        fidelity: str | None = None,
        frequency: FrequencyLike = "1:100:64",
        keep: str = "metrics",
        precision: str = "double",
        membranes: str | None = None,
        outside: str = "fail",
        stock: str = "on",
        name: str = "study",
        description: str = "",
    ) -> None:
        """Check the fields, and read the base design if it is the path of a file.

        Args:
            base: design that is varied: a design, the path of its file, or the name of a prototype.
            vary: dotted names of fields that vary on their own. Each has a list of values; a pair ``(low, high)`` for a
                range to sample; or a range as in a file, such as ``{"from": 9, "to": 30, "scale": "log"}``.
            metrics: names of figures of merit to compute.
            together: groups of fields that vary together, each as ``vary``.
            sampling: "grid" for every combination, or "sobol", "latin-hypercube" or "random" for samples.
            cases: number of samples, a power of 2 for Sobol points; not for a grid.
            seed: of the samples.
            constraints: conditions on a case, such as ``"tube.length > 20 * tube.inner_diameter"``.
            fidelity: what the cells are computed with; by default "atlas" if it covers the base, otherwise
                "navier-stokes".
            frequency: (n_freq,) ascending, Hz, or FIRST:LAST:COUNT such as ``"1:500:500"``.
            keep: what the store holds of each case: "metrics", also its "responses", or everything that "libraries"
                need.
            precision: of the responses that are kept, "double" or "single".
            membranes: "interpolated" if 50 or more of different proportions may be interpolated between solutions, or
                "solved"; by default "solved" if libraries are kept, otherwise "interpolated".
            outside: what becomes of a case outside the atlas: "fail", or it is solved in 3-D, "navier-stokes".
            stock: "on" if sizes of bought parts are those of the catalogue, with the parts that go with them; "off" if
                any size will do.
            name: of the study, for people.
            description: what it asks, for people.

        Raises:
            StudyError: a field is not valid.
            DesignError: the base design is not valid.
        """
        given: dict[str, Any] = {
            "name": name,
            "description": description,
            "base": base,
            "sampling": sampling,
            "seed": seed,
            "constraints": _plain(constraints),
            "frequency": frequency,
            "metrics": _plain(metrics),
            "keep": keep,
            "precision": precision,
            "outside": outside,
            "stock": stock,
            "vary": {each: _values(value) for each, value in (vary or {}).items()},
            "together": [{each: _values(value) for each, value in group.items()} for group in together],
        }
        chosen = (("cases", cases), ("fidelity", fidelity), ("membranes", membranes))
        given |= {key: value for key, value in chosen if value is not None}
        self._fill(given, "", "", Path())

    def _fill(
        self, given: dict[str, Any], text: str, source: str, folder: Path, base: ArrayDesign | None = None
    ) -> None:
        stated = given.get("base")
        if base is None and stated is not None:
            base = _base(stated, folder, source)
        grid = given.get("frequency", "1:100:64")
        fields = {**given, "frequency": grid if isinstance(grid, str) else "a list"}
        if stated is not None:
            fields["base"] = stated if isinstance(stated, str) else "a design"
        file = model_of(StudyFields, fields, source, "study", StudyError)
        assert base is not None  # the model requires a base
        try:
            frequency = frequency_grid(grid)
            axes = axes_of(file, base)
            self.name, self.description = file.name, file.description
            self.base, self.axes, self.sampling = base, axes, file.sampling
            self.constraints = tuple(parse_constraint(each, base) for each in file.constraints)
            self.fidelity = file.fidelity or (
                ONE_DESIGN if acoustic_fem.atlas.outside_atlas(base, frequency) else MANY_DESIGNS
            )
            self.cases, self.seed = case_count(file), file.seed
            self.frequency, self.metrics = frequency, _metrics(file.metrics, frequency)
            self.keep, self.precision = file.keep, file.precision
            self.membranes = file.membranes or ("solved" if file.keep == "libraries" else "interpolated")
            self.outside = _outside(file.outside, self.fidelity)
        except Refusal as error:
            raise StudyError.of(error, file=source or None) from None
        self._given = file
        self.text = text or self._written()

    @classmethod
    def load(cls, path: PathLike) -> Study:
        """Study read from a file. If ``base`` is a file, its path is relative to the folder of the study.

        Raises:
            StudyError: no such file, not TOML, or not a valid study.
            DesignError: the base design is not valid.
        """
        path = Path(path)
        return read_study(study_text(path), str(path), path.parent)

    def save(self, path: PathLike) -> None:
        """Write the study file. A base that is not a prototype is written into it, so the file stands alone.

        Raises:
            StudyError: the name does not end with ``.toml``, or the file cannot be written.
        """
        check_own_kind(path, ".toml", StudyError)
        try:
            write_text(path, self._written())
        except OSError as error:
            raise StudyError(f"cannot be written: {error.strerror}", kind=Kind.UNREADABLE, file=path) from None

    def _written(self) -> str:
        own = self._given.model_dump(mode="json", by_alias=True, exclude_defaults=True)
        document, tables = tomlkit.document(), {}
        known = self.base.name in prototype_names() and prototype(self.base.name) == self.base
        if known:
            own["base"] = self.base.name
        else:
            del own["base"]
        if self._given.frequency == "a list":
            own["frequency"] = self.frequency.tolist()
        for key, value in own.items():
            if key in ("vary", "together"):
                tables[key] = value
            else:
                document.add(key, tomlkit.item(value))
        if "vary" in tables:
            document.add("vary", _table(tables["vary"]))
        if "together" in tables:
            groups = tomlkit.aot()
            for group in tables["together"]:
                groups.append(_table(group))
            document.add("together", groups)
        if not known:
            document.add("base", tomlkit.item(parse_toml(write_design(self.base), "base", StudyError)))
        return tomlkit.dumps(document)

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        varied = {
            each.name: ", ".join(map(str, each.values)) if each.values else f"{each.low:g} to {each.high:g}"
            for each in self.parameters
        }
        return f"Study {self.name}", {
            "description": self.description,
            "base": self.base.name,
            "varies": "; ".join(f"{name}: {values}" for name, values in varied.items()),
            "sampling": f"{self.sampling}, {self.cases} cases, seed {self.seed}" if self.cases else self.sampling,
            "constraints": "; ".join(each.text for each in self.constraints),
            "fidelity": f"{self.fidelity}, cases outside: {self.outside}" if self.atlas else self.fidelity,
            "frequency": f"{self.frequency[0]:g} to {self.frequency[-1]:g} Hz, {len(self.frequency)} values",
            "metrics": ", ".join(self.metrics),
            "keeps": f"{self.keep}, {self.precision} precision" if self.keep != "metrics" else self.keep,
        }

    def __eq__(self, other: object) -> bool:
        """True if the other is a study of the same name and description that gives the same results."""
        if not isinstance(other, Study):
            return NotImplemented
        return (self.name, self.description, self.content()) == (other.name, other.description, other.content())

    def __hash__(self) -> int:
        return hash((self.name, self.description, self.digest()))

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """Parameters that vary, in the order of the file."""
        return tuple(parameter for axis in self.axes for parameter in axis)

    @property
    def atlas(self) -> str:
        """Digest of the table of the atlas that is installed; empty at other fidelities."""
        if self.fidelity != "atlas":
            return ""
        return acoustic_fem.atlas.cell_atlas().digest

    @property
    def solid_fidelity(self) -> Fidelity:
        """Fidelity of the 3-D cells: that of the study, or of its cases outside the atlas."""
        return "navier-stokes" if self.fidelity in CLOSED_FORMS else self.fidelity

    def content(self) -> dict[str, Any]:
        """Content that determines the results, as plain values, without comments and whatever the order of lines."""
        return {
            "base": hashlib.sha256(write_design(self.base).encode()).hexdigest(),
            "vary": [[parameter_content(parameter) for parameter in axis] for axis in self.axes],
            "sampling": self.sampling,
            "cases": self.cases,
            "seed": self.seed,
            "constraints": [constraint.text for constraint in self.constraints],
            "fidelity": self.fidelity,
            "frequency": [float(value) for value in self.frequency],
            "metrics": list(self.metrics),
            "keep": self.keep,
            "precision": self.precision,
            "membranes": self.membranes,
            "outside": self.outside,
        }  # fmt: skip

    def digest(self) -> str:
        """SHA-256 of :meth:`content`, hexadecimal."""
        return hashlib.sha256(json.dumps(self.content(), sort_keys=True).encode()).hexdigest()


# -- reading ------------------------------------------------------------------------------------------------
def resolve_study(study: Study | PathLike) -> Study:
    """The study itself, or that of a file; errors as :func:`load_study`."""
    if isinstance(study, Study):
        return study
    check_type("study", study, (str, os.PathLike), "a study, or the path of its file", StudyError)
    return load_study(study)


def load_study(path: PathLike) -> Study:
    """Study read from a file. If ``base`` is a file, its path is relative to the folder of the study.

    Raises:
        StudyError: no such file, not TOML, or not a valid study.
        DesignError: the base design is not valid.
    """
    return Study.load(path)


def read_study(
    text: str, source: str = "study.toml", folder: Path | None = None, base: ArrayDesign | None = None
) -> Study:
    """Study read from the text of a file.

    Args:
        text: TOML.
        source: name of the file, for messages.
        folder: where design files are looked for; by default the current one.
        base: the base design, in place of the one the text names.

    Raises:
        StudyError: not TOML, or not a valid study.
        DesignError: the base design is not valid.
    """
    return study_of(parse_toml(text, source, StudyError), text, source, folder, base)


def study_of(
    given: Mapping[str, Any], text: str, source: str, folder: Path | None = None, base: ArrayDesign | None = None
) -> Study:
    """Study of the table of a study file.

    Args:
        given: as TOML gives it.
        text: the file it comes from, kept with the study.
        source: name of the file, for messages.
        folder: where design files are looked for; by default the current one.
        base: the base design, in place of the one the table names.

    Raises:
        StudyError: not a valid study.
        DesignError: the base design is not valid.
    """
    check_no_design(given, source)
    for old, new in _RENAMED.items():
        if old in given:
            problem = "is a word of older study files"
            raise StudyError(problem, kind=Kind.UNKNOWN, file=source, field=old, remedy=f"write {new}")
    study = Study.__new__(Study)
    study._fill(dict(given), text, source, folder or Path(), base)
    return study


def _base(stated: Any, folder: Path, source: str) -> ArrayDesign:
    if isinstance(stated, ArrayDesign):
        return stated
    if isinstance(stated, Mapping):
        try:
            return validated(stated, source)
        except DesignError as error:
            raise DesignError.of(error, field=".".join(filter(None, ("base", error.field)))) from None
    allowed = "a prototype, the path of a design file, or a design"
    check_type("base", stated, (str, os.PathLike), allowed, StudyError, file=source)
    name = os.fspath(stated)
    if name in prototype_names():
        return prototype(name)
    path = folder / name
    if not os.path.isfile(path):
        raise StudyError(
            f"is neither a file in {folder} nor a prototype",
            kind=Kind.UNKNOWN,
            file=source,
            field="base",
            value=name,
            remedy=nearest(name, prototype_names()),
        )
    return load_design(path)


def _outside(stated: Outside, fidelity: str) -> Outside:
    if stated != "fail" and fidelity != "atlas":
        allowed = f"left out for fidelity = {fidelity!r}, which has no bounds"
        raise Refusal(kind=Kind.CONFLICT, field="outside", value=stated, allowed=allowed)
    return stated


def _metrics(names: tuple[str, ...], frequency: Array) -> tuple[str, ...]:
    for metric in metrics_named(names):
        metric.check_grid(frequency)
    return tuple(dict.fromkeys(names))


# -- plain values -----------------------------------------------------------------------------------------
def _plain(value: Any) -> Any:
    """A value as TOML would give it: a tuple or an array as a list, a number of NumPy as Python's."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    return list(value) if isinstance(value, tuple) else value


def _values(value: Any) -> Any:
    """Values that are given for a field that varies, as TOML gives them: a pair is a range."""
    if isinstance(value, tuple) and len(value) == 2:
        return {"from": _plain(value[0]), "to": _plain(value[1])}
    value = _plain(value)
    return [_plain(each) for each in value] if isinstance(value, list) else value


def _table(values: Mapping[str, Any]) -> tomlkit.items.Table:
    """A table whose dotted names are keys in quotes, and whose ranges stand in one line."""
    table = tomlkit.table()
    for name, value in values.items():
        if isinstance(value, Mapping):
            line = tomlkit.inline_table()
            line.update(value)
            value = line
        table.add(tomlkit.key(name), value)
    return table
