"""What a logger must do and how its table becomes a recording: the printed command is run, and read by the program."""

from __future__ import annotations

import shlex
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import geometry
from localize import read_recording
from studies.kit.expected_signals import ExpectedSignal, expected_signals
from studies.kit.logger_levels import expected_levels, two_digits
from studies.kit.recording_setup import conversion_line, logger_needs, needs_conversion, told_apart_words

DESIGN = geometry.prototype("array-2x6")
DIGITAL = DESIGN.with_values({"microphone.model": "ICS-43434"})


def test_the_printed_command_makes_a_recording_of_a_table_of_volts(tmp_path: Path) -> None:
    levels = expected_levels(DESIGN)
    volts = np.random.default_rng(5).uniform(-0.3, 0.3, (2, 600))
    rows = ["A,B", *(f"{one:.6f},{other:.6f}" for one, other in volts.T)]
    (tmp_path / "volts.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    name, *arguments = shlex.split(conversion_line(levels))
    assert name == "python"
    subprocess.run([sys.executable, *arguments], cwd=tmp_path, check=True)
    first = levels.loggers[0]
    read = read_recording(tmp_path / "touches.wav", DESIGN.microphones, full_scale=first.full_scale)
    assert read.rate == 1000
    assert levels.sensitivity is not None
    assert read.signals == pytest.approx(volts / levels.sensitivity, abs=1e-3)


def test_a_sound_card_needs_no_conversion() -> None:
    levels = expected_levels(DESIGN)
    assert [each.logger.sound_card for each in levels.loggers if each.logger] == [False, True]
    assert needs_conversion(levels)
    assert not needs_conversion(replace(levels, loggers=levels.loggers[1:]))
    assert not needs_conversion(expected_levels(DIGITAL))


def test_a_logger_must_take_the_voltage_at_which_the_microphone_is_clipped() -> None:
    words = logger_needs(expected_levels(DESIGN), 2)
    microphone = DESIGN.microphone
    assert f"{microphone.overload * 10 ** (microphone.sensitivity / 20):.3g} V peak" in words
    assert "2 inputs and one more" in words
    assert "250 samples/s or more (best: 1000), reach down to 3 Hz" in words
    assert logger_needs(expected_levels(DIGITAL), 2) == ""


def test_points_are_told_apart_as_far_as_their_levels_differ() -> None:
    far, near = (ExpectedSignal(1, "A", "B", 1.0, difference, 0.1, -0.5) for difference in (4.0, 0.4))
    assert told_apart_words([far, far]) == "Every point is louder at the microphone that the table names."
    assert "At 1 point with a smaller difference" in told_apart_words([far, near])
    assert told_apart_words([near, near]).startswith("No point differs by 1 dB")
    assert "the microphone" in told_apart_words([replace(near, softer="", difference=0.0)])
    # The tubes of the glove are so wide that no point differs by 1 dB at 10 Hz.
    assert told_apart_words(expected_signals(geometry.prototype("glove"), None)).startswith("No point differs")


@pytest.mark.parametrize(("value", "words"), [(148.0, "150"), (8.64, "8.6"), (0.0412, "0.041"), (1480.0, "1500")])
def test_two_digits_have_no_power_of_ten(value: float, words: str) -> None:
    assert two_digits(value) == words
