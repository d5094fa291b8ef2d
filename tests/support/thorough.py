"""How many cases the heaviest tests try that draw theirs: ``THOROUGH=5 make slow-test`` tries five times as many."""

from __future__ import annotations

import os


def many(count: int) -> int:
    """So many cases, times what ``THOROUGH`` says."""
    return round(count * float(os.environ.get("THOROUGH", "1")))
