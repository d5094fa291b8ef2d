"""How many processors there are for this process: the one place that every team of workers asks."""

from __future__ import annotations

import math
import os
from pathlib import Path

#: Where Linux says what share of the processors a container may use: microseconds of each period, or "max".
_SHARE = Path("/sys/fs/cgroup/cpu.max")


def cores() -> int:
    """Number of processors that this process may use, at least 1: those it is bound to, and its container's share."""
    bound = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return max(1, min(bound, _share()))


def _share() -> int:
    """Processors' worth of time that a container may use, rounded up; as good as endless where nothing limits it."""
    unlimited = 1 << 30
    try:
        time, period = _SHARE.read_text(encoding="ascii").split()
        return unlimited if time == "max" else math.ceil(int(time) / int(period))
    except (OSError, ValueError, ZeroDivisionError):
        return unlimited
