"""Figures of a calibration: what was measured, with its uncertainty, its coherence and the design beside."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from acoustic_fem.calibration.measured_library import Calibration
from acoustic_fem.library.transfer_functions import Library
from studies.output.figure_style import WIDTH, figure_in_style as new_figure, line_colours, save_figure


def draw_calibration(calibration: Calibration, model: Library, path: str | os.PathLike[str]) -> Path:
    """Picture of level, coherence and the width of the 95 % band per microphone, the design dashed; its path.

    A good measurement is known to thousandths of a dB: its band about the level is thinner than a line, and therefore
    has a panel of its own.
    """
    frequency, estimates = calibration.frequency, calibration.estimates
    microphones = calibration.manifest.design.microphones
    expected = model.transfer_function.transpose("point", "microphone", "frequency").values
    with new_figure((WIDTH, 2.4 * len(microphones) + 0.4)) as figure:
        axes = figure.subplots(len(microphones), 3, squeeze=False, sharex=True)
        for row, name in enumerate(microphones):
            level, coherence, band = axes[row]
            for colour, (number, estimate) in zip(line_colours(len(estimates)), estimates.items(), strict=True):
                size = np.abs(estimate.transfer_function[row])
                radius = estimate.radius_95[row]
                low, high = 20 * np.log10(np.maximum(size - radius, size / 100)), 20 * np.log10(size + radius)
                level.fill_between(frequency, low, high, color=colour, alpha=0.3, linewidth=0)
                level.plot(frequency, 20 * np.log10(size), color=colour, linewidth=1, label=f"point {number}")
                level.plot(
                    frequency, 20 * np.log10(np.abs(expected[number - 1, row])), "--", color=colour, linewidth=0.8
                )
                coherence.plot(frequency, estimate.coherence[row], color=colour, linewidth=1)
                band.semilogy(frequency, 20 * np.log10(1 + radius / size), color=colour, linewidth=1)
            level.set(ylabel=f"microphone {name}: level (dB)")
            coherence.set(ylabel="coherence", ylim=(min(0.9, float(coherence.get_ylim()[0])), 1.005))
            band.set(ylabel="95 % band, either way (dB)")
        axes[0][0].set_title("measured, 95 % band; dashed: design")
        axes[0][1].set_title("coherence with the reference")
        axes[0][2].set_title("how wide the 95 % band is")
        if len(estimates) <= 12:
            axes[0][0].legend(fontsize=7, ncols=2)
        for axis in axes[-1]:
            axis.set_xlabel("frequency (Hz)")
        return save_figure(figure, path)
