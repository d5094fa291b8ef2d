"""Test that ``locate`` notices a library of another array, and a microphone that is far off its level.

``python benchmarks/sensor_fit.py`` writes the table of docs/evidence/streams.md, in some minutes of one core.
Signals are taps and friction on virtual rigs, at six points each. Seeds begin at ``FIRST``, and no constant was chosen
on them. Libraries are those of the designs, without calibration.
"""

from __future__ import annotations

import tempfile
import warnings
from collections import defaultdict
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import geometry
from geometry.ground.whole_files import replace_section
from localize import Locator, TolerantDecoder, TouchStream, read_recording
from localize.evaluation.goodness_of_fit import LoudFrames, SensorFit, sensor_fit
from localize.live.stream_options import StreamOptions
from studies.test_rig.rig_touches import TouchSession, record_touches
from studies.test_rig.virtual_rig import HiddenScatter, Recorder, Rig

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "streams.md"
BEGIN, END = "<!-- sensor fit: made by benchmarks/sensor_fit.py -->", "<!-- end of sensor fit -->"
FIRST, SENSORS, POINTS = 9210, 3, 6
DESIGNS = ("array-2x6", "line-2", "fingertip-4x6", "glove", "line-3", "large-area-64")
LEVELS = (-20.0, -12.0, -8.0, 8.0, 12.0, 20.0)
SESSION = TouchSession(takes=1, seconds=4.0, parts=("taps", "friction"))


def recorded(rig: Rig, points: int, folder: Path) -> list[NDArray[np.float64]]:
    """Recordings by the microphones of a rig for touches at some of its points, (n_microphone, n) Pa each."""
    chosen = np.random.default_rng(rig.seed).choice(np.arange(1, points + 1), POINTS, replace=False)
    recorder = Recorder(output="pressure")
    record_touches(rig, folder, sorted(chosen.tolist()), SESSION, recorder)
    names = rig.design.microphones
    return [read_recording(path, names, recorder.full_scale).signals for path in sorted(folder.glob("*.wav"))]


def fitted(decoder: TolerantDecoder, recordings: list[NDArray[np.float64]], factor: NDArray[np.float64]) -> SensorFit:
    """Warnings for recordings whose microphones are off by a factor."""
    loud = LoudFrames()
    for number, signals in enumerate(recordings):
        stream = TouchStream(_Anyhow(decoder), options=StreamOptions(frames=True))
        loud.take(stream.push(signals * factor[:, None], 10**6 * number))
    found = sensor_fit(decoder, loud.frames())
    assert found is not None
    return found


class _Anyhow(Locator):
    """Locator that always returns the same probability, because the point does not matter here and takes time."""

    def __init__(self, decoder: TolerantDecoder) -> None:
        self.array = decoder.array

    def _probability(self, batch: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.ones((len(batch), 1))


def is_found(fit: SensorFit, microphone: str, level: float) -> bool:
    """True if a level was found to 2 dB; for two microphones, the difference of both."""
    if fit.fault is None or fit.fault.kind != "level":
        return False
    name, found = fit.fault.microphones[0], fit.fault.amount
    if len(fit.microphones) == 2 and name != microphone:
        found = -found
    return (name == microphone or len(fit.microphones) == 2) and abs(found - level) < 2


def main() -> None:
    warnings.filterwarnings("ignore", "entrance loss|membrane: |.*its library ends", UserWarning)
    designs = {name: geometry.prototype(name) for name in DESIGNS}
    libraries = {k: acoustic_fem.solve(design, np.arange(1.0, 501.0), "lumped") for k, design in designs.items()}
    decoders = {name: TolerantDecoder(library, None, "design") for name, library in libraries.items()}
    rows: dict[tuple[str, int], list[bool]] = defaultdict(list)
    random = np.random.default_rng(FIRST)
    for name, design in designs.items():
        microphones = design.microphones
        for seed in range(FIRST, FIRST + SENSORS):
            with tempfile.TemporaryDirectory() as folder:
                heard = recorded(Rig(design, seed, HiddenScatter(), "lumped"), design.point_count, Path(folder) / "rig")
            count, unchanged = len(microphones), np.ones(len(microphones))
            for other, decoder in decoders.items():
                if decoder.microphones == microphones:
                    fit = fitted(decoder, heard, unchanged)
                    what = "own library accepted" if other == name else "another's library rejected"
                    rows[what, count].append((fit.warning is None) == (other == name) and fit.fault is None)
                    print(name, seed, other, fit, flush=True)
            for level in LEVELS:
                channel = int(random.integers(count))
                factor = unchanged.copy()
                factor[channel] = 10 ** (level / 20)
                fit = fitted(decoders[name], heard, factor)
                print(name, seed, microphones[channel], level, fit, flush=True)
                what = f"{level:+g} dB found"
                rows[what, count].append(is_found(fit, microphones[channel], level))
    cases = list(dict.fromkeys(what for what, _ in rows))
    lines = [f"| microphones | {' | '.join(cases)} |", "|---" * (1 + len(cases)) + "|"]
    for count in sorted({count for _, count in rows}):
        found = [rows.get((what, count), []) for what in cases]
        cells = " | ".join(f"{sum(each)}/{len(each)}" if each else "-" for each in found)
        lines.append(f"| {count} | {cells} |")
    replace_section(PAGE, BEGIN, END, lines)
    print("\n".join(lines))


if __name__ == "__main__":
    main()
