"""Summary of a run of a sweep."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from geometry.ground.refusal import counted
from studies.study.cases import PROGRAM_ERROR


@dataclass(frozen=True)
class Summary:
    """Summary of a sweep that has ended."""

    cases: int
    """Number of cases of the study."""
    computed: int
    """Number of cases computed by this run."""
    failures: Mapping[str, list[int]]
    """Numbers of the failed cases by kind of reason, each by its first, the most frequent first."""
    cells: int
    """Number of distinct 3-D cells that were needed."""
    cells_solved: int
    """Number of those not found in the cache."""
    cell_seconds: float
    """Time that the solution of the latter took, summed, s."""
    seconds: float
    """Time that this run took, s."""
    notes: tuple[str, ...]
    """Warnings that came up, each once."""

    @property
    def program_errors(self) -> list[int]:
        """Numbers of the cases that failed because of a bug in the program."""
        return [n for why, numbers in self.failures.items() if why.startswith(PROGRAM_ERROR) for n in numbers]

    @property
    def objection(self) -> str | None:
        """Reason for which the sweep failed, in one line; None if it did not. A case that cannot be computed because of
        its design is a result, unless all are.
        """
        if wrong := self.program_errors:
            return (
                f"{counted(len(wrong), 'case')} (the first is {min(wrong)}) failed by a mistake of the program, not by "
                "their design; its traceback is in the log. When it is fixed compute the study into a new store"
            )
        if self.failures and sum(map(len, self.failures.values())) == self.cases:
            why, numbers = next(iter(self.failures.items()))
            return f"none of {counted(self.cases, 'case')} could be computed; case {numbers[0]}: {why}"
        return None
