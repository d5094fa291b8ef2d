"""Reconstructed waveforms: signal over error against window and latency.

``python benchmarks/reconstruction.py`` writes the table of docs/evidence/decoder.md in about a minute of one core.
Signals are exact steady states of multi-sines with microphone noise. The error covers the whole band of the stimulus,
including its noise up to 500 Hz.
"""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np

import acoustic_fem
import geometry
from geometry.ground.whole_files import replace_section
from localize import ArrayResponse, Reconstructor, short_window_waveform
from localize.signals.array_response import response_of
from localize.signals.stimulus import multi_sines, time_signal
from localize.signals.touch_generator import TouchGenerator

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "decoder.md"
BEGIN, END = "<!-- reconstruction: made by benchmarks/reconstruction.py -->", "<!-- end reconstruction -->"
FREQUENCY = np.arange(1.0, 501.0)
NOISE, TOUCHES = 1e-3, 20
INSIDE = slice(500, 850)
FILTERS = ((250, 0), (250, 4), (250, 16), (250, 64))
SHORT = (32, 256)


def array(name: str) -> ArrayResponse:
    short = name == "line-2, 12 points"
    design = geometry.prototype("line-2" if short else name)
    if short:
        design = design.with_values({"lines.0.points": 12, "layout.columns": 6})
    with warnings.catch_warnings():
        # Entrances beyond the range of the closed form, above 200 Hz: nothing hangs on it here.
        warnings.filterwarnings("ignore", "entrance loss of a tube", UserWarning)
        return response_of(acoustic_fem.solve(design, FREQUENCY, "lumped"))


def ratio(pressure: np.ndarray, estimate: np.ndarray) -> float:
    """Signal over error, dB, away from the ends, over all touches of a point."""
    signal, error = pressure[:, INSIDE], (pressure - estimate)[:, INSIDE]
    return float(10 * np.log10((signal**2).sum() / (error**2).sum()))


def main() -> None:
    names = ("line-2, 12 points", "array-2x6", "line-2")
    columns: dict[str, list[np.ndarray]] = {}
    deviations: dict[str, float] = {}
    for name in names:
        response = array(name)
        points = response.point_count
        made = TouchGenerator(response, 0, "evaluation", NOISE).samples(0, TOUCHES * points)
        stimuli = multi_sines(0, "evaluation", 0, TOUCHES * points, (1.0, 500.0))
        signals = made.signals.double().numpy()
        source = time_signal(stimuli.spectrum).double().numpy()

        def over_points(estimate, points=points, signals=signals, source=source) -> np.ndarray:
            return np.array([ratio(source[k::points], estimate(signals[k::points], k + 1)) for k in range(points)])

        columns[name] = []
        for window, latency in FILTERS:
            filters = Reconstructor(response, NOISE, window, latency)
            columns[name].append(over_points(lambda x, k, f=filters: f.waveform(x, k).pressure))
            if (window, latency) == (250, 16):
                deviations[name] = max(filters.deviation(k + 1) for k in range(points))
        for window in SHORT:
            columns[name].append(
                over_points(lambda x, k, r=response, w=window: short_window_waveform(r, x, k, w, w // 2))
            )
    titles = [f"Wiener, window {window}, latency {latency} ms" for window, latency in FILTERS]
    titles += [f"short windows of {window}, hop {window // 2}" for window in SHORT]
    lines = ["| filter | " + " | ".join(names) + " |", "|---" * (len(names) + 1) + "|"]
    for row, title in enumerate(titles):
        cells = [f"{columns[name][row].min():.1f}/{columns[name][row].mean():.1f}" for name in names]
        lines.append(f"| {title} | " + " | ".join(cells) + " |")
    cells = [f"{1e3 * deviations[name]:.1f}" for name in names]
    lines.append("| largest posterior deviation (mPa), window 250, latency 16 ms | " + " | ".join(cells) + " |")
    print("\n".join(lines))
    replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
