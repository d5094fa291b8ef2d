"""Times and durations that written files state: those of the clock, or of one that ``SOURCE_DATE_EPOCH`` has stopped.

Everything else in a file follows from its input, so that two calls with one input write equal bytes wherever no time
is stated. With the variable of https://reproducible-builds.org/specs/source-date-epoch set to a whole number of
seconds, every stated time is that one, durations are 0, and files do not state whether a cell came from the cache.
"""

from __future__ import annotations

import os
from datetime import UTC, datetime

from geometry.ground.refusal import Kind, Refusal

VARIABLE = "SOURCE_DATE_EPOCH"
"""Environment variable that stops the clock, seconds since 1970-01-01 00:00 UTC."""
#: The last second that a date of four digits has.
_LAST = 253402300799


def stopped_time() -> datetime | None:
    """The time at which ``SOURCE_DATE_EPOCH`` has stopped the clock of written files; None where it is not set.

    Raises:
        Refusal: the variable is not a whole number of seconds from 0 to the end of the year 9999.
    """
    text = os.environ.get(VARIABLE)
    if text is None:
        return None
    if not (text.isascii() and text.isdecimal() and len(text) <= len(str(_LAST)) and int(text) <= _LAST):
        allowed = f"a whole number of seconds since 1970, at most {_LAST}"
        remedy = "correct the environment variable, or unset it"
        raise Refusal(kind=Kind.OUT_OF_RANGE, field=VARIABLE, value=text, allowed=allowed, remedy=remedy)
    return datetime.fromtimestamp(int(text), UTC)


def stated_time() -> datetime:
    """The time that a file written now states, in UTC.

    Raises:
        Refusal: as :func:`stopped_time`.
    """
    return stopped_time() or datetime.now(UTC)


def stated_seconds(seconds: float) -> float:
    """The duration that a file written now states for work that took ``seconds``; 0 while the clock is stopped.

    Raises:
        Refusal: as :func:`stopped_time`.
    """
    return seconds if stopped_time() is None else 0.0
