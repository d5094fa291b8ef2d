"""Reasons for which designs failed, counted by kind: those that differ in their numbers alone are one."""

from __future__ import annotations

from collections.abc import Iterable

#: How the reason begins of a case that failed by a mistake of the program, not by its design.
PROGRAM_ERROR = "program error: "


def by_kind(reasons: Iterable[tuple[int, str]]) -> dict[str, list[int]]:
    """Numbers of the designs by kind of reason, the most frequent first.

    Args:
        reasons: number of each design that failed, and why.

    Returns:
        Numbers of all designs of a kind, by the reason of the first of them.
    """
    first: dict[str, str] = {}
    found: dict[str, list[int]] = {}
    for number, reason in reasons:
        found.setdefault(first.setdefault(_kind(reason), reason), []).append(number)
    return dict(sorted(found.items(), key=lambda entry: (-len(entry[1]), entry[1][0])))


def _kind(reason: str) -> str:
    """A reason without its numbers; of a mistake of the program all, for its line is what it is."""
    if reason.startswith(PROGRAM_ERROR):
        return reason
    words = reason.replace("(", " ").replace(")", " ").split()
    return " ".join(word for word in words if not any(letter.isdigit() for letter in word))
