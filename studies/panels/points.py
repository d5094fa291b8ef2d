"""How distinguishable the points of a design are: distances, predicted confusion, smallest touches, coverage."""

from __future__ import annotations

from typing import Any

import numpy as np

from acoustic_fem.library.noise_floor import detection_limits
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import overlaps
from geometry.layout.remedies import fix_for
from localize.signals.stimulus import BAND
from studies.metrics.batch_responses import Responses
from studies.metrics.covered_area import FINGER
from studies.metrics.separation import separability
from studies.metrics.shared import SharedFigures
from studies.output.frequencies import FREQUENCIES
from studies.panels.curves import quick_library
from studies.scatter.effects import quick_scattered_accuracy
from studies.study.metric_registry import SENSORS, metrics_named

#: Figures of merit of the whole design that the page shows, by the names that a study knows them by.
FIGURES = (
    "predicted_top1", "predicted_top1_white_noise", "confused_pair", "distance_smallest", "ild_smallest",
    "ipd_smallest", "scatter_detection", "sensitivity_force", "noise_equivalent_force", "bandwidth", "coverage",
    "length", "width", "height", "volume", "mass", "cost", "smallest_wall",
)  # fmt: skip


#: Points of the largest array whose figures are predicted beside a page: memory goes with the square of them, 1 GB.
MOST_POINTS = 256


def _check_size(design: ArrayDesign) -> None:
    if design.point_count > MOST_POINTS:
        problem = f"the array has {design.point_count} points; figures are predicted for at most {MOST_POINTS}"
        raise Refusal(problem, kind=Kind.UNSUITABLE)


def point_figures(design: ArrayDesign) -> dict[str, Any]:
    """Figures of a design and of each of its points, of its quick library at the usual frequencies of figures.

    Returns:
        ``figures``: the value of each of :data:`FIGURES`;
        ``points``: for each point its ``number``, ``nearest`` (the point hardest to tell from it), the ``distance``,
        ``level`` (dB) and ``phase`` (degrees) between the two, ``named`` (share of its simulated touches that name
        it) and ``force`` (smallest that stands out of the noise, N rms from 1 to 100 Hz); ``confusion``: touches of
        the row's point that name the column's, counted; ``touches`` per point; ``hardest``: pairs of points, as
        hard as the hardest; ``overlaps``: what of the layout cannot be built, and ``mend``; ``finger``: radius of the
        contact of ``coverage``, mm; ``fidelity`` of the library, in words.

    Raises:
        Refusal: the design has fewer than two points or microphones or more than :data:`MOST_POINTS` points, or cannot
            be solved.
    """
    _check_size(design)
    library, fidelity = quick_library(design, FREQUENCIES)
    shared = SharedFigures(Responses.of_library(library))
    apart = separability(library.transfer_function)
    predicted = shared.confusion(None)
    limits = detection_limits(library, BAND)["force"].values
    named = np.diagonal(predicted.confusion[0])
    points = []
    for index, number in enumerate(apart.points):
        nearest = apart.nearest(number)
        level, phase, distance = apart.between(number, nearest)
        points.append(
            {
                "number": number,
                "nearest": nearest,
                "distance": distance,
                "level": level,
                "phase": phase,
                "named": float(named[index]),
                "force": float(limits[index]),
            }
        )
    in_the_way = overlaps(design, lay_out(design))
    return {
        "figures": {
            metric.name: float(metric.of_batch(shared.responses, shared)[0]) for metric in metrics_named(FIGURES)
        },
        "points": points,
        "confusion": np.rint(predicted.confusion[0] * predicted.touches).astype(int).tolist(),
        "touches": predicted.touches,
        "hardest": [list(pair) for pair in apart.equally_hard],
        "overlaps": list(in_the_way),
        "mend": fix_for(design) if in_the_way else "",
        "finger": FINGER,
        "fidelity": fidelity.words,
    }


def figure_words() -> dict[str, dict[str, str]]:
    """Title, unit, definition and the better direction of each of :data:`FIGURES`."""
    return {metric.name: metric.words for metric in metrics_named(FIGURES)}


def as_built_figures(design: ArrayDesign) -> dict[str, Any]:
    """Predicted accuracy of sensors that are made with a workshop's scatter.

    Returns:
        ``sensors``, how many; ``mean`` and ``worst`` share of their simulated touches whose point is named;
        ``fidelity`` of their transfer functions, in words.

    Raises:
        Refusal: a design that the batch does not take, or one of more than :data:`MOST_POINTS` points.
    """
    _check_size(design)
    found, fidelity = quick_scattered_accuracy(design, FREQUENCIES, sensors=SENSORS)
    return {
        "sensors": SENSORS,
        "mean": float(found.mean()),
        "worst": float(found.min()),
        "fidelity": fidelity.words,
    }
