"""Warnings that point at the line of the caller, however deep in the packages their reason was found."""

from __future__ import annotations

import inspect
import warnings

_PACKAGES = frozenset({"geometry", "acoustic_fem", "localize", "studies"})


def warn_caller(message: str, category: type[Warning] = UserWarning) -> None:
    """Warn at the nearest line of the call stack that is in none of the four packages.

    Args:
        message: says the numbers and their limit.
        category: class of the warning.
    """
    frame, level = inspect.currentframe(), 1
    while (
        frame is not None
        and frame.f_back is not None
        and str(frame.f_globals.get("__name__")).partition(".")[0] in _PACKAGES
    ):
        frame, level = frame.f_back, level + 1
    warnings.warn(message, category, stacklevel=level)
