"""The decoders that need no training: accuracy and calibration on 36, 108 and 216 points.

``python benchmarks/decoder.py`` writes the table of docs/evidence/decoder.md, with the 3-D cells of the default
fidelity; some minutes of one core the first time.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from ratio_baseline import RatioBaseline

import acoustic_fem
import geometry
from geometry.ground.whole_files import replace_section
from localize import ArrayResponse, BayesDecoder, judge
from localize.decoders.judgement import ResidualTest
from localize.signals.array_response import response_of
from localize.signals.finger_stimuli import friction, taps
from localize.signals.stimulus import StimulusSource, multi_sines
from localize.signals.touch_generator import TouchGenerator

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "decoder.md"
BEGIN, END = "<!-- decoder: made by benchmarks/decoder.py -->", "<!-- end decoder -->"
# Taps reach down to 0 Hz, where long lines bend within a fraction of a hertz.
FREQUENCY = np.concatenate([np.arange(0.25, 20.0, 0.25), np.arange(20.0, 501.0)])
FRAME, ASSUMED, TOUCHES = 250, 1e-3, 4000
CASES: tuple[tuple[str, float, StimulusSource], ...] = (
    ("multi-sine touches, no noise", 0.0, multi_sines),
    ("multi-sine touches, 1 mPa", 1e-3, multi_sines),
    ("taps, 1 mPa", 1e-3, taps),
    ("friction, 1 mPa", 1e-3, friction),
    ("multi-sine touches, 10 mPa", 1e-2, multi_sines),
)


def frames_of(response: ArrayResponse, noise: float, stimuli: StimulusSource) -> tuple[np.ndarray, np.ndarray]:
    """Frames and their points: the last one of steady signals, the one around the peak of others."""
    count = response.point_count * max(4, TOUCHES // response.point_count)
    frames, point = [], []
    for part in TouchGenerator(response, 0, "evaluation", noise, stimuli=stimuli).stream(0, count):
        signals = part.signals.double().numpy()
        length = signals.shape[-1]
        start = np.full(len(signals), length - FRAME)
        if stimuli is not multi_sines:
            start = np.clip(np.abs(signals).max(1).argmax(1) - FRAME // 2, 0, length - FRAME)
        frames.append(
            signals[np.arange(len(signals))[:, None], :, start[:, None] + np.arange(FRAME)].transpose(0, 2, 1)
        )
        point.append(part.point.numpy() - 1)
    return np.concatenate(frames), np.concatenate(point)


def calibration_gap(probability: np.ndarray, right: np.ndarray) -> float:
    """Mean distance between sureness and accuracy over ten groups of equal size (Guo et al. 2017)."""
    order = np.argsort(probability)
    return float(np.mean([abs(probability[part].mean() - right[part].mean()) for part in np.array_split(order, 10)]))


def column(name: str) -> list[str]:
    library = acoustic_fem.solve(geometry.prototype(name), FREQUENCY)
    response = response_of(library)
    decoder, baseline = BayesDecoder(response, ASSUMED), RatioBaseline(response, ASSUMED)
    test = ResidualTest(response, ASSUMED)
    cells = [str(response.point_count)]
    for _, noise, stimuli in CASES:
        frames, point = frames_of(response, noise, stimuli)
        who = decoder if noise <= ASSUMED else BayesDecoder(response, noise)
        probability = who.locate(frames)
        right = probability.argmax(1) == point
        ratio = baseline.locate(frames) == point
        cells.append(
            f"{100 * right.mean():.2f}/{100 * ratio.mean():.1f}/{calibration_gap(probability.max(1), right):.3f}"
        )
        if noise == ASSUMED:
            judged = judge(who, test, frames, false_alarm=0.01)
            cells[-1] += f"/{100 * (~judged.explained).mean():.1f}"
    return cells


def main() -> None:
    names = ("line-2", "line-3", "line-4")
    titles = ["points", *(case[0] for case in CASES)]
    columns = [column(name) for name in names]
    lines = ["| touches | " + " | ".join(names) + " |", "|---" * (len(names) + 1) + "|"]
    lines += [f"| {' | '.join(row)} |" for row in zip(titles, *columns, strict=True)]
    print("\n".join(lines))
    replace_section(PAGE, BEGIN, END, lines)


if __name__ == "__main__":
    main()
