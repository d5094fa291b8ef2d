"""Make the figures of README: accuracy of taps and presses by the default decoder, and the picture of its ten lines.

    python -m benchmarks.readme          # prints the table, writes docs/images/level-difference.png; two minutes

Sensors are the nominal one and virtual rigs, see docs/calibration.md: as-built sensors with rubber, microphones and air
that no decoder is given. Each rig is decoded once with the design's library and once with the library that calibrate
makes from its recordings.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np
from matplotlib import colormaps

import acoustic_fem
import localize
import studies
from localize.evaluation import PRESSES, TAPS, TouchedSensors, decide
from localize.signals import response_of
from studies.output.figure_style import WIDTH, figure_in_style, save_figure

DESIGN = "array-2x6"
#: Seeds of the rigs: on none of them was a constant of a decoder chosen.
RIGS = (9101, 9102, 9103, 9104)
#: Touches of each kind at every point of a sensor.
TOUCHES = 100
#: Kinds of touches by name.
KINDS = {each.name: each for each in (TAPS, PRESSES)}
PICTURE = Path(__file__).parents[1] / "docs" / "images" / "level-difference.png"


class FingerAccuracy(NamedTuple):
    """Top-1 accuracy for touches of a finger: fractions of one by kind of touches, one for each sensor."""

    as_built: dict[str, list[float]]
    """Rigs, decoded with the library of the design."""
    calibrated: dict[str, list[float]]
    """Rigs, each decoded with its own measured library."""
    nominal: dict[str, list[float]]
    """The nominal sensor."""


def finger_accuracy(touches: int = TOUCHES, rigs: tuple[int, ...] = RIGS) -> FingerAccuracy:
    """Accuracy of the default decoder on simulated taps and presses, of which it is given 250 ms with the noise of the
    design's microphones.
    """
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        designed = studies.solve_library(DESIGN, place / "designed.nc")
        as_built, calibrated = [], []
        for seed in rigs:
            rig = studies.record_rig(DESIGN, place / f"rig-{seed}", seed=seed)
            studies.calibrate_sensor(rig.calibration, place / f"{seed}.nc")
            truth = acoustic_fem.load(rig.library)
            as_built.append(_accuracy(designed, truth, touches))
            calibrated.append(_accuracy(acoustic_fem.load(place / f"{seed}.nc"), truth, touches))
        nominal = [_accuracy(designed, designed, touches)]
    return FingerAccuracy(
        *({kind: [each[kind] for each in sensors] for kind in KINDS} for sensors in (as_built, calibrated, nominal))
    )


def _accuracy(known: acoustic_fem.Library, sensor: acoustic_fem.Library, touches: int) -> dict[str, float]:
    """Top-1 accuracy by kind of touches at a sensor, decoded with a library that may be another."""
    decoder, touched = localize.open_model(known).locator, TouchedSensors(response_of(sensor), "design", seed=77)
    return {name: decide(decoder, touched.touches(kinds, touches)).evaluation().top1 for name, kinds in KINDS.items()}


def draw_level_difference() -> Path:
    """Level at microphone A over microphone B from every point, against frequency."""
    frequency = np.linspace(1, 100, 100)
    h = acoustic_fem.solve(DESIGN, frequency, fidelity="lumped").transfer_function
    level = 20 * np.log10(abs(h.sel(microphone="A") / h.sel(microphone="B")))
    with figure_in_style((WIDTH, 2.8)) as figure:
        axes = figure.subplots()
        for point in h.point.values:
            axes.plot(frequency, level.sel(point=point), label=f"{point}", color=colormaps["viridis"](point / 13))
        axes.set(xlabel="frequency  (Hz)", ylabel="level at A over B  (dB)", xlim=(1, 100))
        figure.legend(*axes.get_legend_handles_labels(), title="point", loc="outside right center", fontsize="small")
        return save_figure(figure, PICTURE)


def main() -> None:
    """Print the table, and draw the picture."""
    print(draw_level_difference())
    for name, by_kind in finger_accuracy()._asdict().items():
        for kind, values in by_kind.items():
            print(f"{name}, {kind}: {100 * np.mean(values):.1f} % (worst sensor {100 * min(values):.1f})", flush=True)


if __name__ == "__main__":
    main()
