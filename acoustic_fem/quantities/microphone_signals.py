"""Kinds of signals that recordings hold, and how low outputs of microphones are equalised; names alone."""

from __future__ import annotations

from typing import Literal, get_args

#: Kinds of signals: outputs of microphones over their sensitivity, or pressures in front of them.
Output = Literal["voltage", "pressure"]
OUTPUTS: tuple[Output, ...] = get_args(Output)
#: Lowest frequency down to which signals are equalised unless it is given, Hz: that of the stimuli.
LOWEST = 1.0
#: Range of that frequency, Hz.
LOWEST_RANGE = (0.1, 20.0)
