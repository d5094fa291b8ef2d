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
from studies.comparison.own_figures import MOST_POINTS, metric_figures
from studies.metrics.batch_responses import Responses
from studies.metrics.binned_arrays import SILENT
from studies.metrics.covered_area import point_coverage
from studies.metrics.predicted_accuracy import as_built_accuracy
from studies.metrics.separation import separability
from studies.metrics.shared import SharedFigures
from studies.output.frequencies import FREQUENCIES
from studies.panels.curves import quick_library


def _check_size(design: ArrayDesign) -> None:
    if design.point_count > MOST_POINTS:
        problem = f"the array has {design.point_count} points; figures are predicted for at most {MOST_POINTS}"
        raise Refusal(problem, kind=Kind.UNSUITABLE)


def point_figures(design: ArrayDesign) -> dict[str, Any]:
    """Figures of a design and of each of its points, of its quick library at the usual frequencies of figures.

    Returns:
        ``figures``: the value of each of :data:`studies.comparison.FIGURES`;
        ``points``: for each point its ``number``, ``nearest`` (the point hardest to tell from it), the ``distance``,
        ``level`` (dB) and ``phase`` (degrees) between the two, ``named`` (share of its simulated touches that name
        it), ``force`` (smallest that stands out of the noise, N rms from 1 to 100 Hz), ``loudest`` (level at the
        microphone where it is loudest, dB at 100 Hz) and ``coverage`` (share of the area that is nearest to its
        membrane in which a contact reaches it); ``confusion``: touches of the row's point that name the column's,
        counted; ``touches`` per point; ``hardest``: pairs of points, as
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
    last = library.transfer_function.isel(frequency=-1).transpose("point", "microphone").values
    loudest = 20 * np.log10(np.maximum(np.abs(last).max(axis=1), SILENT))
    covered = point_coverage(design)
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
                "loudest": float(loudest[index]),
                "coverage": float(covered[index]),
            }
        )
    in_the_way = overlaps(design, lay_out(design))
    return {
        "figures": {name: each.value for name, each in metric_figures(shared, design).items()},
        "points": points,
        "confusion": np.rint(predicted.confusion[0] * predicted.touches).astype(int).tolist(),
        "touches": predicted.touches,
        "hardest": [list(pair) for pair in apart.equally_hard],
        "overlaps": list(in_the_way),
        "mend": fix_for(design) if in_the_way else "",
        "finger": design.target.contact_radius,
        "fidelity": fidelity.words,
    }


def as_built_figures(design: ArrayDesign) -> dict[str, Any]:
    """Predicted accuracy of as-built sensors that nobody calibrated, for the touches of a run.

    Returns:
        ``sensors``, how many; ``mean`` and ``worst`` (5th percentile) fraction of taps and presses that are assigned
        to the correct point by a decoder that nobody calibrated, and the ``interval`` of the mean; ``multi_sines``;
        ``per_point``, the fraction of the taps and presses of each point.

    Raises:
        Refusal: a design whose scatter is not known, or one of more than :data:`MOST_POINTS` points.
    """
    _check_size(design)
    found = as_built_accuracy(design, force=None)
    both = found.taps, found.presses
    mean, worst, low, high = (
        sum(getattr(each, figure) for each in both) / 2 for figure in ("mean", "worst", "low", "high")
    )
    return {
        "sensors": found.sensors,
        "mean": mean,
        "worst": worst,
        "interval": [low, high],
        "multi_sines": found.multi_sines.mean,
        "per_point": ((both[0].per_point + both[1].per_point) / 2).tolist(),
    }
