"""How a command of the command line ended, and what runs one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Outcome:
    """How a command ended."""

    code: int
    out: str
    err: str

    def refusal(self, code: int = 1) -> str:
        """The one line with which a command was refused, after what it had shown of its progress."""
        assert self.code == code, self.err
        assert "Traceback" not in self.err
        *_, last = lines = self.err.splitlines()
        assert [line for line in lines if line.startswith("acoustic-fem: ")] == [last]
        assert len(last) < 2100
        return last


Command = Callable[..., Outcome]
"""Runs ``acoustic-fem`` with arguments."""
