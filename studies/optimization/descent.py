"""Steps downhill along the slopes of one objective (Adam; Kingma and Ba 2015), each step a design to compute.

A place is a number for each parameter, without bounds: a logistic function of it is the share of the parameter's range
in logarithms. A step's input from the steps before it is kept beside it in the journal.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

import acoustic_fem
from geometry.design.design_file import value_of
from geometry.ground.refusal import Refusal
from geometry.ground.typed import Array
from studies.optimization.problem import Optimization, searched_range

if TYPE_CHECKING:
    from acoustic_fem.membrane.disc_table import DiscTables
    from acoustic_fem.membrane.elasticity import ElasticDisc
    from acoustic_fem.membrane.half_section import DiscShape


#: Length of the first and of the last step, in logistic units; between them it falls evenly in logarithms.
RATES = (0.1, 0.005)
#: Shares of what is remembered of slopes and of their squares.
_MEMORY = (0.9, 0.999)
#: Where in the range a search begins at the least and at the most, as a share of it.
_BEGIN = (0.02, 0.98)
#: Designs of the ranges that membranes are interpolated between.
_DISCS = 64


@dataclass(frozen=True)
class Step:
    """Step of a descent: where it is, and what is remembered there."""

    number: int
    """Number of the step, from 0."""
    place: tuple[float, ...]
    """Place, one number per parameter."""
    slope: tuple[float, ...]
    """Mean of the slopes so far."""
    square: tuple[float, ...]
    """Mean of their squares."""


class Descent:
    """Descent of the only objective of a problem.

    Args:
        problem: with the method "gradient".
    """

    def __init__(self, problem: Optimization) -> None:
        self.problem = problem
        (self.objective,) = problem.objectives
        self.study = problem.free or problem.study
        self.parameters = [parameter for (parameter,) in self.study.axes]
        ends = np.log([searched_range(parameter, problem.rules) for parameter in self.parameters])
        self._low, self._width = ends[:, 0], ends[:, 1] - ends[:, 0]
        self.discs = self._known_discs()

    def first(self) -> Step:
        """Step at the base design, or as near to it as the ranges are."""
        base = np.array([float(value_of(self.study.base, each.name)) for each in self.parameters])
        share = np.clip((np.log(np.maximum(base, 1e-9)) - self._low) / self._width, *_BEGIN)
        none = (0.0,) * len(share)
        return Step(0, tuple(np.log(share / (1 - share)).tolist()), none, none)

    def after(self, step: Step) -> Step:
        """The step after one; where the slopes are not known there, one that turns back halfway to the base."""
        share = 1 / (1 + np.exp(-np.array(step.place)))
        try:
            slope = self._slopes(self.values(step)) * self._width * share * (1 - share)
        except Refusal:
            back = (np.array(step.place) + np.array(self.first().place)) / 2
            return Step(step.number + 1, tuple(back.tolist()), step.slope, step.square)
        memory = np.array(_MEMORY)
        mean = memory[0] * np.array(step.slope) + (1 - memory[0]) * slope
        square = memory[1] * np.array(step.square) + (1 - memory[1]) * slope**2
        whole = 1 - memory ** (step.number + 1)
        done = step.number / max(self.problem.trials - 1, 1)
        rate = RATES[0] * (RATES[1] / RATES[0]) ** done
        place = np.array(step.place) - rate * (mean / whole[0]) / (np.sqrt(square / whole[1]) + 1e-12)
        return Step(step.number + 1, *(tuple(each.tolist()) for each in (place, mean, square)))

    def steps(self, last: Mapping[str, Any] | None, count: int) -> list[Step]:
        """Steps of a batch.

        Args:
            last: what the journal keeps of the step before; None at the beginning.
            count: how many.
        """
        steps = [self.first() if last is None else self.after(Step(**last))]
        while len(steps) < count:
            steps.append(self.after(steps[-1]))
        return steps

    def values(self, step: Step) -> dict[str, float]:
        """Values of the free parameters at a step by dotted name, as they are proposed to the search."""
        ends = np.exp(self._low), np.exp(self._low + self._width)
        found = np.exp(self._low + self._width / (1 + np.exp(-np.array(step.place))))
        return dict(zip((each.name for each in self.parameters), np.clip(found, *ends).tolist(), strict=True))

    def _slopes(self, values: Mapping[str, float]) -> Array:
        slopes = self.objective.metric.slopes
        assert slopes is not None  # the problem was checked
        found = slopes(self.study.base.with_values(values), list(values), self.discs)[1]
        return found if self.objective.better == "smaller" else -found

    def _known_discs(self) -> SolvedDiscs:
        """Membranes of designs all over the ranges."""
        shares = np.random.default_rng(0).uniform(size=(_DISCS, len(self._low)))
        shares[:2] = [[0.0], [1.0]]
        shapes = []
        for share in shares:
            values = np.exp(self._low + share * self._width).tolist()
            names = [each.name for each in self.parameters]
            try:
                design = self.study.base.with_values(dict(zip(names, values, strict=True)))
                shapes += [acoustic_fem.membrane.design_shape(design.of_kind(kind)) for kind in design.kinds]
            except Refusal:
                continue
        return SolvedDiscs(acoustic_fem.membrane.DiscTables(acoustic_fem.membrane.disc_tables(shapes)))


@dataclass(frozen=True)
class SolvedDiscs:
    """Membranes of a descent: interpolated between those of tables, solved where no table covers them."""

    tables: DiscTables
    """Tables between whose discs others are interpolated."""

    def find(self, shape: DiscShape) -> ElasticDisc | None:
        """Disc of a shape."""
        from acoustic_fem.membrane.solved_discs import solved_disc

        return self.tables.find(shape) or solved_disc(shape)
