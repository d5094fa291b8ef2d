"""A study: a set of designs over a base design, and what to compute for each."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from geometry import ArrayDesign
from geometry.design.design_file import write_design
from geometry.refusal import Refusal
from studies.study.constraints import Constraint

Fidelity = Literal["lumped", "helmholtz", "navier-stokes"]
Sampling = Literal["grid", "latin-hypercube", "sobol", "random"]


class StudyError(Refusal):
    """A study that is not valid. The message is one line: file, field, value and what is allowed."""


@dataclass(frozen=True)
class Parameter:
    """A field of the design that a study varies: a list of values, or a range.

    Attributes:
        name: dotted name.
        values: the list; empty for a range.
        low: where a range begins.
        high: where it ends.
        count: values of the range in a grid; 0 where none is given.
        scale: of a range: equal steps, or equal ratios.
        whole: whether the values are whole numbers, to which those of a range are rounded.
    """

    name: str
    values: tuple[float | int | str, ...] = ()
    low: float = 0.0
    high: float = 0.0
    count: int = 0
    scale: Literal["linear", "log"] = "linear"
    whole: bool = False

    @property
    def size(self) -> int:
        """Number of values in a grid."""
        return len(self.values) or self.count

    def at(self, place: NDArray[np.float64]) -> NDArray[Any]:
        """Values at places from 0 to 1: for a list each value takes an equal share of them."""
        if self.values:
            kind = np.float64 if all(isinstance(value, (int, float)) for value in self.values) else object
            kind = np.int64 if self.whole else kind
            index = np.minimum((place * len(self.values)).astype(np.int64), len(self.values) - 1)
            return np.array(self.values, dtype=kind)[index]
        if self.whole:  # each whole number takes an equal share
            low, high = round(self.low), round(self.high)
            return np.minimum(low + (place * (high - low + 1)).astype(np.int64), high)
        if self.scale == "log":
            values = self.low * (self.high / self.low) ** place
        else:
            values = self.low + (self.high - self.low) * place
        return np.clip(values, min(self.low, self.high), max(self.low, self.high))

    def grid(self) -> NDArray[Any]:
        """All values in a grid, in the order of the file."""
        if self.values:
            return self.at((np.arange(len(self.values)) + 0.5) / len(self.values))
        steps = np.arange(self.count) / max(self.count - 1, 1)
        if self.whole:
            return np.unique(np.round(self.low + (self.high - self.low) * steps).astype(np.int64))
        return self.at(steps)


@dataclass(frozen=True, eq=False)
class Study:
    """A set of designs and what to compute for each.

    Attributes:
        text: the study file.
        name: of the study.
        description: what it asks, for people.
        base: the design that is varied.
        axes: what varies on its own: one parameter, or several that go together.
        sampling: how the cases lie: every combination, or samples of the ranges.
        cases: number of samples; 0 for a grid.
        seed: of the samples.
        constraints: conditions that a case must meet to be part of the study.
        fidelity: what the cells are computed with.
        frequency: (n_freq,) Hz.
        metrics: names of :data:`studies.study.metric_registry.METRICS`.
        transfer_functions: whether they are kept.
    """

    text: str
    name: str
    description: str
    base: ArrayDesign
    axes: tuple[tuple[Parameter, ...], ...]
    sampling: Sampling
    cases: int
    seed: int
    constraints: tuple[Constraint, ...]
    fidelity: Fidelity
    frequency: NDArray[np.float64]
    metrics: tuple[str, ...]
    transfer_functions: bool

    @property
    def parameters(self) -> tuple[Parameter, ...]:
        """All that varies, in the order of the file."""
        return tuple(parameter for axis in self.axes for parameter in axis)

    def content(self) -> dict[str, Any]:
        """What decides the results, as plain values: neither comments nor the order of lines count."""
        return {
            "base": hashlib.sha256(write_design(self.base).encode()).hexdigest(),
            "parameters": [[vars(parameter) | {"values": list(parameter.values)} for parameter in axis]
                           for axis in self.axes],
            "sampling": self.sampling,
            "cases": self.cases,
            "seed": self.seed,
            "constraints": [constraint.text for constraint in self.constraints],
            "fidelity": self.fidelity,
            "frequencies": [float(value) for value in self.frequency],
            "metrics": list(self.metrics),
            "transfer_functions": self.transfer_functions,
        }  # fmt: skip

    def digest(self) -> str:
        """Hash of :meth:`content`."""
        return hashlib.sha256(json.dumps(self.content(), sort_keys=True).encode()).hexdigest()
