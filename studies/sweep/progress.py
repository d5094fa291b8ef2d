"""How far a sweep is, and how a display tells it."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from time import perf_counter

from studies.output.display import Report, duration, number


@dataclass(frozen=True)
class Progress:
    """Progress of a sweep."""

    what: str
    """Words for what is being done."""
    done: int
    """Number of cases (or cells) finished, failed ones included, those of earlier runs too."""
    total: int
    """Number of all cases (or cells)."""
    failed: int
    """Number of those finished that failed."""
    rate: float
    """Cases (or cells) per second of this run; 0 before the first."""
    remaining: float
    """Time left at that rate, s; NaN before the first."""


def progress_of(what: str, done: int, total: int, failed: int, computed: int, seconds: float) -> Progress:
    """Progress of a sweep at the rate of this run.

    Args:
        what: words for what is being done.
        done: number finished.
        total: number of all.
        failed: number of those finished that failed.
        computed: number finished by this run.
        seconds: time that they took, s.
    """
    rate = computed / max(seconds, 1e-9)
    return Progress(what, done, total, failed, rate, (total - done) / rate if rate else math.nan)


def shown_on(report: Report, often: bool) -> Callable[[Progress], None]:
    """Progress as a display takes it.

    Args:
        report: of a stage.
        often: twice a second, as at a terminal; else when a tenth more time has passed, at least five seconds.
    """
    started = perf_counter()
    last = -1e9

    def show(now: Progress) -> None:
        nonlocal last
        seconds = perf_counter() - started
        wait = 0.5 if often else max(5.0, 0.1 * seconds)
        if seconds - last < wait and now.done < now.total:
            return
        last = seconds
        failed = f", {now.failed} failed" if now.failed else ""
        left = "" if now.done >= now.total else f", {duration(now.remaining)} left"
        report(f"{now.done} of {now.total} {now.what}, {number(now.rate)}/s{left}{failed}", now.done / now.total)

    return show
