"""The frequencies of a library where a caller names none, as FIRST:LAST:COUNT in Hz."""

from __future__ import annotations

FREQUENCIES = "1:100:64"
"""Usual frequencies of metrics and of sweeps that are played, over the band of the stimuli."""
CALIBRATION_FREQUENCIES = "1:125:125"
"""Usual frequencies of the library of a sensor that was recorded: whole hertz, as far as recordings are driven. A
decoder takes sound above the last frequency of its library for noise, and up to 100 Hz that would be much of a tap."""
LIBRARY_FREQUENCIES = "1:500:500"
"""Usual frequencies of a library, from which localizers are made: whole hertz up to half the sample rate of the
signals, because touches have sound up to there."""
