"""A parameter of a study: one field of the design, with its values or its range."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from geometry.ground.refusal import Refusal

#: Significant digits of a value within a range: below a micrometre nothing is made.
_DIGITS = 4

Sampling = Literal["grid", "latin-hypercube", "sobol", "random"]


class StudyError(Refusal):
    """Refusal of a study that is not valid. The message is one line: file, field, value and what is allowed."""


@dataclass(frozen=True)
class Parameter:
    """Field of the design that a study varies: a list of values, or a range."""

    name: str
    """Dotted name of the field."""
    values: tuple[float | int | str, ...] = ()
    """Values of a list, in the unit of the field; empty for a range."""
    low: float = 0.0
    """Beginning of a range, in the unit of the field."""
    high: float = 0.0
    """End of a range, in the unit of the field."""
    count: int = 0
    """Number of values of the range in a grid; 0 where none is given."""
    scale: Literal["linear", "log"] = "linear"
    """Scale of a range: equal steps, or equal ratios."""
    whole: bool = False
    """True if the values are whole numbers, to which those of a range are rounded."""
    step: float = 0.0
    """Distance of the sizes that can be had, counted from the beginning of a range; 0 where any can."""
    ends: tuple[float, ...] = ()
    """Places from 0 to 1 at which the share of each value of a list ends; empty where all shares are equal."""

    @property
    def size(self) -> int:
        """Number of values in a grid."""
        return len(self.values) or self.count

    def at(self, place: NDArray[np.float64]) -> NDArray[Any]:
        """Values at places from 0 to 1: for a list each value takes its share of them.

        Args:
            place: (n,) float64, 0 to 1.

        Returns:
            (n,) float64, int64 where the values are whole, or objects (texts); in the unit of the field.
        """
        if self.values:
            kind = np.float64 if all(isinstance(value, (int, float)) for value in self.values) else object
            kind = np.int64 if self.whole else kind
            index = (
                np.searchsorted(self.ends, place, "right") if self.ends else (place * len(self.values)).astype(np.int64)
            )
            index = np.minimum(index, len(self.values) - 1)
            return np.array(self.values, dtype=kind)[index]
        if self.whole:  # each whole number takes an equal share
            low, high = round(self.low), round(self.high)
            return np.minimum(low + (place * (high - low + 1)).astype(np.int64), high)
        if self.scale == "log":
            values = self.low * (self.high / self.low) ** place
        else:
            values = self.low + (self.high - self.low) * place
        return self.to_stock_size(np.clip(values, self.low, self.high))

    def to_stock_size(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """The values (n,) as the nearest sizes that can be had; (n,) float64, in the unit of the field.

        Without a step these are values of four digits, more where the range is narrow, so that what is computed is what
        a design file says and what somebody can make.
        """
        if not self.step:
            span = 2 - math.floor(math.log10(self.high - self.low))
            sizes = [round(value, max(_decimals(value), span)) for value in values.tolist()]
            return np.clip(np.array(sizes, np.float64), self.low, self.high)
        last = math.floor((self.high - self.low) / self.step + 1e-9)
        steps = np.clip(np.round((values - self.low) / self.step), 0, last)
        return np.round(self.low + steps * self.step, 9)

    def grid(self) -> NDArray[Any]:
        """Values in a grid, in the order of the file; (n,) float64, int64 where they are whole, or objects (texts)."""
        if self.values:
            return self.at((np.arange(len(self.values)) + 0.5) / len(self.values))
        steps = np.arange(self.count) / max(self.count - 1, 1)
        if self.whole:
            return np.unique(np.round(self.low + (self.high - self.low) * steps).astype(np.int64))
        return self.at(steps)


def followers(axes: Iterable[Sequence[tuple[str, Sequence[Any]]]]) -> dict[str, str]:
    """Parameters that have no values of their own: name of each, and of the first parameter of its group.

    Such a parameter has one value for every combination of those before it in its group, like the wire of a spring
    whose bore varies.

    Args:
        axes: groups of parameters that go together, each a name and the values of its list; no values for a range.
    """
    found = {}
    for axis in axes:
        for place, (name, values) in enumerate(axis[1:], 1):
            before = [own for _, own in axis[:place]]
            rows = list(zip(*before, strict=True)) if values and all(before) else []
            if len({*zip(rows, values, strict=False)}) == len(set(rows)):
                found[name] = axis[0][0]
    return found


def _decimals(value: float) -> int:
    """Decimals of a number that is rounded to significant digits."""
    return _DIGITS - 1 - math.floor(math.log10(abs(value))) if value else 0


def parameter_content(parameter: Parameter) -> dict[str, Any]:
    """A parameter as plain values; what is not stated of the later fields does not count: older results stay known."""
    content = vars(parameter) | {"values": list(parameter.values), "ends": list(parameter.ends)}
    return {name: value for name, value in content.items() if name not in ("step", "ends") or value}
