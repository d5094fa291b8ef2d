"""The frequencies of a library where a caller names none."""

FREQUENCIES = "1:100:64"
"""Usual frequencies of figures of merit and of sweeps that are played, over the band of the stimuli, as
FIRST:LAST:COUNT in Hz."""
CALIBRATION_FREQUENCIES = "1:125:125"
"""Usual frequencies of the library of a sensor that was recorded: whole hertz, as far as recordings are driven. What is
heard above a library's last one, a decoder takes for noise: up to 100 Hz it would be much of a tap."""
LIBRARY_FREQUENCIES = "1:500:500"
"""Usual frequencies of a library, from which localizers are made: whole hertz up to half the sample rate of the
signals, which touches fill."""
