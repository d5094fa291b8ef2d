"""The time that a build states in its files in place of the present one, by the convention of ``SOURCE_DATE_EPOCH``."""

from __future__ import annotations

import os

from geometry.ground.refusal import Kind, Refusal

VARIABLE = "SOURCE_DATE_EPOCH"
_LATEST = 253_402_300_799  # the last second of the year 9999


def build_time() -> int | None:
    """Seconds since the beginning of 1970 that files shall state as their time; None where the variable is not set.

    Raises:
        Refusal: the variable holds something else.
    """
    text = os.environ.get(VARIABLE, "")
    if not text:
        return None
    if not (text.isascii() and text.isdigit() and len(text) <= len(str(_LATEST)) and int(text) <= _LATEST):
        allowed = f"a whole number of seconds from 0 to {_LATEST}"
        raise Refusal(
            kind=Kind.OUT_OF_RANGE, field=VARIABLE, value=text, allowed=allowed, remedy="unset it, or give a time"
        )
    return int(text)
