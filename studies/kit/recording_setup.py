"""Words on what a data logger must do, how its recordings reach the commands, and what the first one must show."""

from __future__ import annotations

from collections.abc import Sequence

from geometry.ground.refusal import counted
from localize.recordings.recording import LOWEST_RATE
from localize.signals.stimulus import SAMPLE_RATE
from studies.kit.expected_signals import ExpectedSignal
from studies.kit.logger_levels import SLOWEST, ExpectedLevels
from studies.kit.touch_leak_test import READABLE

#: Table of voltages that a logger's own program saves, and the recording that is made of it.
VOLTS, TOUCHES = "volts.csv", "touches.wav"


def logger_needs(levels: ExpectedLevels, microphones: int) -> str:
    """Properties that every data logger for an array must have; empty for digital microphones.

    Args:
        levels: levels of the array.
        microphones: number of its microphones.
    """
    if levels.largest_voltage is None:
        return ""
    return (
        f"A data logger must have {microphones} inputs and one more for the calibration microphone. It must record "
        f"each input at {LOWEST_RATE:g} samples/s or more (best: {SAMPLE_RATE:g}), reach down to {SLOWEST:g} Hz, "
        f"and take {levels.largest_voltage:.3g} V peak without clipping."
    )


def needs_conversion(levels: ExpectedLevels) -> bool:
    """True if the most suitable logger is not a sound card, so that its tables become recordings first."""
    first = levels.loggers[0].logger if levels.loggers else None
    return first is not None and not first.sound_card


def conversion_line(levels: ExpectedLevels) -> str:
    """Command that makes a recording of the table of voltages of the most suitable logger."""
    volts = levels.loggers[0].volts
    return (
        f"python -c \"import numpy, scipy.io.wavfile as w; v = numpy.loadtxt('{VOLTS}', delimiter=',', skiprows=1); "
        f"w.write('{TOUCHES}', {SAMPLE_RATE:.0f}, (v / {volts:.4g}).astype('f4'))\""
    )


def told_apart_words(signals: Sequence[ExpectedSignal]) -> str:
    """Check of the first recording by the louder microphone, as far as the difference can be read."""
    if not signals[0].softer:
        return "Every point has a signal at the microphone."
    close = [signal for signal in signals if signal.difference < READABLE]
    if not close:
        return "Every point is louder at the microphone that the table names."
    if len(close) == len(signals):
        return (
            f"No point differs by {READABLE:g} dB, so either microphone may be the louder one. Both are equally loud, "
            f"within {READABLE:g} dB and the spread. The commands also compare other frequencies."
        )
    return (
        f"Every point whose difference is {READABLE:g} dB or more is louder at the microphone that the table names. "
        f"At {counted(len(close), 'point')} with a smaller difference both microphones are equally loud, within "
        f"{READABLE:g} dB and the spread."
    )
