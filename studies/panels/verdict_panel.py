"""Verdict on a design as the studio's bar shows it: outcome, reasons, remedies that a button applies, four figures."""

from __future__ import annotations

from typing import Any

from geometry.design.array_design import ArrayDesign
from studies.verdict import Verdict, figure_rows, overload_lines, remedy_in_words


def verdict_figures(design: ArrayDesign) -> dict[str, Any]:
    """Verdict on a design, without its drawn parts.

    Returns:
        As :meth:`studies.Verdict.to_dict`, where each remedy also has its ``line``; ``rows`` of the four figures; and
        ``clipped``, lines on taps that the microphone clips.

    Raises:
        Refusal: a membrane outside what can be solved.
    """
    verdict = Verdict(design)
    found = verdict.to_dict()
    for shown, reason in zip(found["reasons"], verdict.reasons, strict=True):
        if reason.remedy is not None:
            shown["remedy"]["line"] = remedy_in_words(reason.rule, reason.remedy)
    clipped = [line.removeprefix("- ") for line in overload_lines(verdict)]
    return {**found, "rows": [list(row) for row in figure_rows(verdict)], "clipped": clipped}
