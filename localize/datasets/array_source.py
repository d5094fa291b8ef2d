"""Where a data set takes its arrays from: one library, the cases of a sweep, or as-built sensors of one design."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import numpy as np
from numpy.typing import NDArray

from acoustic_fem import Library
from geometry.ground.refusal import Kind, Refusal
from localize.signals.array_response import ArrayResponse, response_of


@runtime_checkable
class ArraySource(Protocol):
    """Arrays by case: one library, the cases of a sweep with ``keep = "libraries"``, as-built sensors, or your own."""

    @property
    def case_numbers(self) -> NDArray[np.int64]:
        """Numbers of the cases that have an array, ascending; (n_case,) int64."""

    @property
    def case_keys(self) -> tuple[str, ...]:
        """Text of each case, in the order of their numbers; equal designs have equal ones, and are of one split."""

    @property
    def parameter_names(self) -> tuple[str, ...]:
        """Names of the numbers that tell one case from another."""

    @property
    def parameter_units(self) -> tuple[str, ...]:
        """Unit of each of them."""

    @property
    def array_sizes(self) -> NDArray[np.int64]:
        """Number of points and of microphones of each case; (n_case, 2) int64."""

    def parameter_values(self, case: int) -> NDArray[np.float64]:
        """Parameters of a case, in the order and units of their names; (n_parameter,) float64."""

    def arrays(self, cases: Sequence[int], sound: bool = False) -> list[ArrayResponse]:
        """Arrays of some cases, in their order; several at once take less time than one after the other.

        With ``sound`` they have :attr:`localize.ArrayResponse.ambient_response`.
        """


@dataclass(frozen=True, eq=False)
class OneArray:
    """Source of a single array, case 0, without parameters."""

    response: ArrayResponse
    """The array."""

    @property
    def case_numbers(self) -> NDArray[np.int64]:
        """Case 0 alone; (1,) int64."""
        return np.zeros(1, np.int64)

    @property
    def case_keys(self) -> tuple[str, ...]:
        """Name of the array."""
        return (self.response.name,)

    @property
    def parameter_names(self) -> tuple[str, ...]:
        """No names."""
        return ()

    @property
    def parameter_units(self) -> tuple[str, ...]:
        """No units."""
        return ()

    @property
    def array_sizes(self) -> NDArray[np.int64]:
        """Number of points and of microphones; (1, 2) int64."""
        return np.array([(self.response.point_count, len(self.response.microphones))])

    def parameter_values(self, case: int) -> NDArray[np.float64]:
        """No values; (0,) float64."""
        return np.zeros(0)

    def arrays(self, cases: Sequence[int], sound: bool = False) -> list[ArrayResponse]:
        """The array, as often as there are cases."""
        return [self.response] * len(cases)


def source_of(source: ArraySource | Library | ArrayResponse) -> ArraySource:
    """Source of arrays from what a caller has: a library becomes a source of one array.

    Raises:
        Refusal: anything else; a source without a case; a library that does not cover 1 to 100 Hz.
    """
    if isinstance(source, Library | ArrayResponse):
        return OneArray(response_of(source))
    if not isinstance(source, ArraySource):
        raise Refusal(
            kind=Kind.WRONG_TYPE,
            field="source",
            value=type(source).__name__,
            allowed="a library, a sweep that keeps responses or libraries, or as-built sensors",
        )
    if not len(source.case_numbers):
        raise Refusal("holds no case with an array", kind=Kind.UNSUITABLE, field="source")
    return source
