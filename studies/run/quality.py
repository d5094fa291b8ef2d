"""Quality of a design, in seconds: accuracy of as-built sensors and of the nominal one, the hardest pair, cost.

Accuracies are predictions of what a run measures: its taps and presses, its noise, and the tolerance-aware decoder,
see :mod:`studies.metrics.predicted_accuracy`. Where the scatter of a design is not known, the accuracy is that of a
trained network for multi-sine touches on the nominal sensor, see :mod:`studies.metrics.confusion`.
"""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import studies.metrics
from acoustic_fem.atlas import QuickFidelity, quick_fidelity
from acoustic_fem.library.noise_floor import detection_limits
from acoustic_fem.quantities.checks import frequency_grid
from acoustic_fem.scatter.tolerances import UnknownScatterError
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.layout.arrangement import lay_out
from localize.signals.stimulus import BAND
from studies.metrics.batch_responses import Responses
from studies.metrics.build import cost
from studies.metrics.separation import separability
from studies.metrics.shared import SharedFigures
from studies.output.display import Report
from studies.output.figure_style import WIDTH, figure_in_style, save_figure
from studies.output.frequencies import FREQUENCIES
from studies.output.report_texts import percent
from studies.verdict.words import force_in_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from studies.metrics.predicted_accuracy import AsBuiltAccuracy

#: Touches of the accuracies, and those where the scatter is not known.
FINGER_TOUCHES, MULTI_SINES = "taps and presses", "multi-sine touches"
#: As-built sensors for designs of up to so many points; of larger ones fewer, as each takes the square of its points,
#: and never less than the last.
SENSORS, SENSORS_UP_TO, _LEAST_SENSORS = 64, 36, 4
#: Designs of more points have none here.
_MOST_POINTS = 256


@dataclass(frozen=True, eq=False)
class DesignQuality:
    """Predicted quality of a design: touches as a run has them, with the noise of the design's microphone."""

    nominal: float
    """Fraction of touches on the nominal sensor that are assigned to the correct point, 0 to 1."""
    sensors: int
    """Number of as-built sensors; 0 where it is not known how the design scatters, or it has over 256 points."""
    predicted: AsBuiltAccuracy | None
    """Accuracies of as-built sensors that nobody calibrated, for a run's touches; None without sensors."""
    hardest: tuple[int, int]
    """Numbers of the two points that are hardest to tell apart, by their distance."""
    level: float
    """Level difference of the two, rms over 1 to 100 Hz, dB."""
    phase: float
    """Phase difference of the two, rms over 1 to 100 Hz, degrees."""
    weakest: int
    """Number of the point that needs the largest force."""
    force: float
    """Noise-equivalent force there: the rms force from 1 to 100 Hz that equals the noise, N."""
    cost: float
    """Cost of the materials of one array, molds left out, at assumed prices, USD."""
    fidelity: QuickFidelity
    """Fidelity of the nominal sensor's transfer functions: the atlas, or another one and why."""
    per_point: NDArray[np.float64] = field(repr=False)
    """Fraction of the touches of each point that are assigned to it, on as-built sensors where they are known,
    otherwise on the nominal one; (n_point,) float64."""

    @property
    def touches(self) -> str:
        """Touches of the accuracies, in words."""
        return FINGER_TOUCHES if self.predicted else MULTI_SINES

    @property
    def as_built(self) -> float:
        """Fraction of taps and presses on as-built sensors that are assigned correctly; NaN without sensors."""
        return self._of_both("mean")

    @property
    def worst(self) -> float:
        """The same fraction for the fifth percentile of the sensors; NaN without sensors."""
        return self._of_both("worst")

    @property
    def interval(self) -> tuple[float, float]:
        """Interval that holds what a run measures for 9 of 10 designs; NaN without sensors."""
        return self._of_both("low"), self._of_both("high")

    def _of_both(self, figure: str) -> float:
        if self.predicted is None:
            return float("nan")
        return _of_both(getattr(self.predicted.taps, figure), getattr(self.predicted.presses, figure))

    @property
    def accuracy(self) -> str:
        """Predicted accuracy in words: touches, as-built sensors where they are known, the nominal sensor."""
        as_built = f"{percent(self.as_built)} on as-built sensors, " if self.sensors else ""
        return f"{self.touches}: {as_built}{percent(self.nominal)} on the nominal sensor"

    @property
    def in_short(self) -> str:
        """Predicted accuracy in half a line: of as-built sensors where they are known, otherwise of the nominal one."""
        if self.predicted is None:
            return f"{percent(self.nominal)} of {self.touches} on the nominal sensor"
        low, high = self.interval
        return f"{percent(self.as_built)} ({100 * low:.0f} to {100 * high:.0f} %) of {self.touches}, as built"

    @property
    def lines(self) -> tuple[tuple[str, str, str], ...]:
        """Rows of a table: what, value, and what the value is of."""
        from localize.signals.finger_strokes import PEAK  # needs torch, without which verbs print help

        # The taps of a verdict have the force of its target, so these rows say that their touches are others.
        of_run = {
            FINGER_TOUCHES: f"{FINGER_TOUCHES} of a run, {PEAK[0]:g} to {PEAK[1]:g} Pa in the cavity",
            MULTI_SINES: f"{MULTI_SINES} of a run",
        }
        first, second = self.hardest
        within = f"rms, {BAND[0]:g} to {BAND[1]:g} Hz"
        made, of = "not known", "use acoustic-fem tolerance"
        sines: tuple[tuple[str, str, str], ...] = ()
        if self.predicted is not None:
            low, high = self.interval
            made = f"{100 * self.as_built:.1f} % ({100 * low:.0f} to {100 * high:.0f} %)"
            of = f"{of_run[FINGER_TOUCHES]}, not calibrated, mean of {self.sensors} (9 of 10 designs lie within)"
            value = f"{100 * self.predicted.multi_sines.mean:.1f} %"
            sines = (
                ("top-1 accuracy, 5th percentile", f"{100 * self.worst:.1f} %", of_run[FINGER_TOUCHES]),
                ("top-1 accuracy, multi-sines", value, f"{of_run[MULTI_SINES]}, as-built sensors"),
            )
        return (
            ("top-1 accuracy, as-built sensors", made, of),
            *sines,
            ("top-1 accuracy, nominal sensor", f"{100 * self.nominal:.1f} %", of_run[self.touches]),
            ("hardest pair", f"{first} and {second}", f"{self.level:.2g} dB, {self.phase:.2g} degrees apart"),
            ("noise-equivalent force", force_in_words(self.force), f"{within}, at point {self.weakest}"),
            ("cost", f"{self.cost:.2f} USD", "materials of one array, assumed prices"),
            ("fidelity, hardest pair and force", self.fidelity.name, self.fidelity.why),
        )

    def to_dict(self) -> dict[str, Any]:
        """Figures as JSON can hold them."""
        return {
            "touches": self.touches,
            "nominal": self.nominal,
            "sensors": self.sensors,
            "as_built": self.as_built if self.predicted else None,
            "worst": self.worst if self.predicted else None,
            "interval": list(self.interval) if self.predicted else None,
            "predicted": self.predicted and self.predicted.to_dict(),
            "hardest": list(self.hardest),
            "level": self.level,
            "phase": self.phase,
            "weakest": self.weakest,
            "force": self.force,
            "cost": self.cost,
            "fidelity": self.fidelity.words,
            "per_point": self.per_point.tolist(),
        }


def _of_both(taps: Any, presses: Any) -> Any:
    """A figure of taps and presses together, which are equally frequent."""
    return (taps + presses) / 2


def design_quality(design: DesignLike, progress: Report | None = None) -> DesignQuality | None:
    """Predicted quality of a design; None where it has fewer than two points or microphones.

    Args:
        design: the design.
        progress: called with the name of the step and the fraction done, 0 to 1.

    Raises:
        Refusal: the design cannot be solved.
    """
    design = resolve_design(design)
    if design.point_count < 2 or len(design.microphones) < 2:
        return None
    grid = frequency_grid(FREQUENCIES)
    fidelity = quick_fidelity(design, grid)
    library = acoustic_fem.solve(design, grid, fidelity=fidelity.name, progress=progress)
    apart = separability(library.transfer_function)
    hardest = apart.hardest_pairs[0]
    level, phase, _ = apart.between(*hardest)
    predicted = predicted_accuracy(design)
    if predicted is None:
        confusion = SharedFigures(Responses.of_library(library)).confusion(None)
        nominal, per_point = float(confusion.top1[0]), np.diagonal(confusion.confusion[0]).copy()
    else:
        nominal = _of_both(predicted.nominal.taps.mean, predicted.nominal.presses.mean)
        per_point = _of_both(predicted.taps.per_point, predicted.presses.per_point)
    limits = np.asarray(detection_limits(library, BAND)["force"].values)
    weakest = int(np.argmax(limits))
    return DesignQuality(
        nominal=nominal,
        sensors=0 if predicted is None else predicted.sensors,
        predicted=predicted,
        hardest=hardest,
        level=level,
        phase=phase,
        weakest=apart.points[weakest],
        force=float(limits[weakest]),
        cost=float(cost(design)),
        fidelity=fidelity,
        per_point=per_point,
    )


def predicted_accuracy(design: ArrayDesign) -> AsBuiltAccuracy | None:
    """Predicted accuracies of as-built sensors for the touches of a run; None where it is not known how the design
    scatters, or it takes long.
    """
    if design.point_count > _MOST_POINTS:
        return None
    count = math.ceil(SENSORS * (SENSORS_UP_TO / design.point_count) ** 2)
    count = max(_LEAST_SENSORS, min(SENSORS, count))
    try:
        return studies.metrics.as_built_accuracy(design, force=None, sensors=count)
    except UnknownScatterError:
        return None


def draw_quality(design: ArrayDesign, quality: DesignQuality, path: str | os.PathLike[str]) -> Path:
    """Picture of an array in plan, mm: each point in the colour of its share of touches, the hardest pair ringed.

    Args:
        design: the array.
        quality: its figures.
        path: of the PNG.
    """
    with figure_in_style((WIDTH, 4.6)) as figure:
        figure.set_layout_engine("compressed")  # keeps the plan, whose axes have one scale, in the middle
        axes = figure.subplots()
        _plan(axes, design, quality)
        axes.set(xlabel="x  (mm)", ylabel="y  (mm)", aspect="equal")
        figure.suptitle(f"{design.name}, predicted top-1 accuracy\n{quality.accuracy}")
        figure.legend(loc="outside lower center", ncols=2)
        return save_figure(figure, path)


def _plan(axes: Axes, design: ArrayDesign, quality: DesignQuality) -> None:
    import matplotlib as mpl
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Circle

    layout = lay_out(design)
    for tube in layout.tubes:
        axes.plot(*tube.path[:, :2].T, color="#777777", linewidth=1.2, zorder=1)
    radius = design.resonator.outer_diameter / 2
    shells = PatchCollection(
        [Circle(point.position, radius) for point in layout.points],
        cmap=mpl.colormaps["viridis"],
        clim=(min(0.9, float(quality.per_point.min())), 1.0),
        edgecolor="#333333",
        zorder=2,
    )
    shells.set_array(quality.per_point)
    axes.add_collection(shells)
    bar = axes.figure.colorbar(shells, ax=axes, shrink=0.6)
    bar.set_label(f"top-1 accuracy, {'as-built sensors' if quality.sensors else 'nominal sensor'}")
    for point in layout.points:
        if len(layout.points) <= 64:
            box = {"boxstyle": "round,pad=0.15", "facecolor": "#00000090", "edgecolor": "none"}
            axes.annotate(
                str(point.number), point.position, ha="center", va="center", fontsize=7, color="white", bbox=box
            )
        if point.number in quality.hardest:
            axes.add_patch(Circle(point.position, 1.2 * radius, fill=False, edgecolor="#c0392b", linewidth=2, zorder=3))
    for microphone in layout.microphones:
        axes.plot(*microphone.position, "s", color="#1d4d2b", markersize=9, zorder=3)
        axes.annotate(
            microphone.name, microphone.position, xytext=(0, 9), textcoords="offset points", ha="center", fontsize=9
        )
    axes.plot([], [], "o", markerfacecolor="none", markeredgecolor="#c0392b", label="hardest pair")
    axes.plot([], [], "s", color="#1d4d2b", label="microphone")
    axes.margins(0.06)
    axes.autoscale_view()
