"""Environment of the command line: nonsense is set right, or refused, before any work."""

from __future__ import annotations

import os

from geometry.ground.argument_checks import whole_number
from geometry.ground.stated_times import stopped_time

#: Sizes of the terminal. Shells and containers set them to 0 where there is none.
_SIZES = ("COLUMNS", "LINES", "TERMINAL_WIDTH")
_LARGEST = 10_000


def check_environment() -> None:
    """Ignore sizes of a terminal that no terminal has, and matplotlib's choice of a window: no verb opens one.

    Raises:
        Refusal: ``SOURCE_DATE_EPOCH`` is not a time.
    """
    for name in _SIZES:
        if name in os.environ and not 1 <= whole_number(os.environ[name].strip()) <= _LARGEST:
            del os.environ[name]
    os.environ["MPLBACKEND"] = "agg"
    stopped_time()
