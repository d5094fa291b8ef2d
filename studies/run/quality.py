"""Quality of a design, in seconds: accuracy of as-built sensors and of the nominal one, the hardest pair, cost.

Accuracies are predictions for the publication's multi-sine touches, see :mod:`studies.metrics.confusion`, for a
localizer that was trained on the nominal sensor alone. They rank designs; a run measures taps and presses.
"""

from __future__ import annotations

import math
import os
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
from acoustic_fem.atlas import QuickFidelity, quick_fidelity
from acoustic_fem.library.noise_floor import detection_limits
from acoustic_fem.quantities.checks import frequency_grid
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.refusal import Refusal
from geometry.layout.arrangement import lay_out
from localize.signals.stimulus import BAND
from studies.metrics.batch_responses import Responses
from studies.metrics.build import cost
from studies.metrics.separation import separability
from studies.metrics.shared import SharedFigures
from studies.output.display import number
from studies.output.figure_style import WIDTH, figure_in_style, save_figure
from studies.output.frequencies import FREQUENCIES
from studies.output.report_texts import percent
from studies.scatter.effects import quick_scattered_accuracy

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Touches that the accuracies are of.
SIGNALS = "multi-sine touches"
#: As-built sensors for designs of up to so many points; of larger ones fewer, as each takes the square of its points,
#: and never less than the last.
SENSORS, SENSORS_UP_TO, _LEAST_SENSORS = 64, 24, 4
#: Designs of more points have none here.
_MOST_POINTS = 256


@dataclass(frozen=True, eq=False)
class DesignQuality:
    """Predicted quality of a design: multi-sine touches with the noise of the design's microphone, decoded with the
    nominal design.
    """

    nominal: float
    """Share of touches on the nominal sensor whose point a trained localizer is predicted to name, 0 to 1."""
    sensors: int
    """Number of as-built sensors; 0 where the batch does not take the design, or it has over 256 points."""
    as_built: float
    """The same share on sensors with a workshop's scatter, not calibrated, by their mean; NaN without sensors."""
    worst: float
    """The same of the worst of these sensors; NaN without sensors."""
    hardest: tuple[int, int]
    """Numbers of the two points that are hardest to tell apart, by their distance."""
    level: float
    """Level difference of the two, rms over 1 to 100 Hz, dB."""
    phase: float
    """Phase difference of the two, rms over 1 to 100 Hz, degrees."""
    weakest: int
    """Number of the point that needs the largest force."""
    force: float
    """Force there that stands out of the noise, rms from 1 to 100 Hz, N."""
    cost: float
    """Cost of the materials of one array, molds left out, at assumed prices, USD."""
    fidelity: QuickFidelity
    """Fidelity of the nominal sensor's transfer functions: the atlas, or 3-D and why."""
    as_built_fidelity: QuickFidelity | None
    """Fidelity of the as-built sensors' transfer functions; None without sensors."""
    per_point: NDArray[np.float64] = field(repr=False)
    """Share of the touches of each point on the nominal sensor that name it; (n_point,) float64."""

    @property
    def accuracy(self) -> str:
        """Predicted accuracy in words: touches, as-built sensors where they are known, the nominal sensor."""
        as_built = f"{percent(self.as_built)} on as-built sensors, " if self.sensors else ""
        return f"{SIGNALS}: {as_built}{percent(self.nominal)} on the nominal sensor"

    @property
    def lines(self) -> tuple[tuple[str, str, str], ...]:
        """Rows of a table: what, value, and what the value is of."""
        first, second = self.hardest
        made = f"{100 * self.as_built:.1f} % ({100 * self.worst:.1f} %)" if self.sensors else "not known"
        of = f"{SIGNALS}, mean of {self.sensors} (worst)" if self.sensors else "use acoustic-fem tolerance"
        fidelities = {"nominal sensor": self.fidelity, "as-built sensors": self.as_built_fidelity}
        return (
            ("top-1 accuracy, as-built sensors", made, of),
            ("top-1 accuracy, nominal sensor", f"{100 * self.nominal:.1f} %", SIGNALS),
            ("hardest pair", f"{first} and {second}", f"{self.level:.2g} dB, {self.phase:.2g} degrees apart"),
            ("smallest detectable force", f"{number(1e9 * self.force)} nN", f"rms, at point {self.weakest}"),
            ("cost", f"{self.cost:.2f} USD", "materials of one array, assumed prices"),
            *((f"fidelity, {whose}", each.name, each.outside) for whose, each in fidelities.items() if each),
        )

    def to_dict(self) -> dict[str, Any]:
        """Figures as JSON can hold them."""
        known = {**asdict(self), "per_point": self.per_point.tolist(), "hardest": list(self.hardest)}
        known["fidelity"] = self.fidelity.words
        known["as_built_fidelity"] = self.as_built_fidelity and self.as_built_fidelity.words
        return {name: None if value != value else value for name, value in known.items()}


def design_quality(design: DesignLike) -> DesignQuality | None:
    """Predicted quality of a design; None where it has fewer than two points or microphones.

    Args:
        design: the design.

    Raises:
        Refusal: the design cannot be solved.
    """
    design = resolve_design(design)
    if design.point_count < 2 or len(design.microphones) < 2:
        return None
    grid = frequency_grid(FREQUENCIES)
    fidelity = quick_fidelity(design, grid)
    library = acoustic_fem.solve(design, grid, fidelity=fidelity.name)
    apart = separability(library.transfer_function)
    hardest = apart.hardest_pairs[0]
    level, phase, _ = apart.between(*hardest)
    predicted = SharedFigures(Responses.of_library(library)).confusion(None)
    limits = np.asarray(detection_limits(library, BAND)["force"].values)
    weakest = int(np.argmax(limits))
    made, as_built_fidelity = _as_built(design)
    return DesignQuality(
        nominal=float(predicted.top1[0]),
        sensors=len(made),
        as_built=float(made.mean()) if len(made) else float("nan"),
        worst=float(made.min()) if len(made) else float("nan"),
        hardest=hardest,
        level=level,
        phase=phase,
        weakest=apart.points[weakest],
        force=float(limits[weakest]),
        cost=float(cost(design)),
        fidelity=fidelity,
        as_built_fidelity=as_built_fidelity,
        per_point=np.diagonal(predicted.confusion[0]).copy(),
    )


def _as_built(design: ArrayDesign) -> tuple[NDArray[np.float64], QuickFidelity | None]:
    """Predicted shares of as-built sensors, (n,) float64, and their fidelity; none where the batch does not take the
    design or it takes long.
    """
    if design.point_count > _MOST_POINTS:
        return np.zeros(0), None
    count = math.ceil(SENSORS * (SENSORS_UP_TO / design.point_count) ** 2)
    count = max(_LEAST_SENSORS, min(SENSORS, count))
    try:
        return quick_scattered_accuracy(design, FREQUENCIES, sensors=count)
    except Refusal:
        return np.zeros(0), None


def draw_quality(design: ArrayDesign, quality: DesignQuality, path: str | os.PathLike[str]) -> Path:
    """Picture of an array in plan, mm: each point in the colour of its share of touches, the hardest pair ringed.

    Args:
        design: the array.
        quality: its figures.
        path: of the PNG.
    """
    with figure_in_style((WIDTH, 4.6)) as figure:
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
    bar.set_label("top-1 accuracy, nominal sensor")
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
