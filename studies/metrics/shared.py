"""Responses of a batch of designs with what several metrics are made of, computed once and handed on."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from geometry.ground.typed import Array, ComplexArray
from geometry.layout.size import array_size
from localize.signals.noise_model import microphone_noise
from studies.metrics.batch_responses import Responses, required
from studies.metrics.build import Volumes, volumes_of
from studies.metrics.confusion import PredictedConfusion, predict_confusions
from studies.metrics.separation import PairDistances, pair_distances
from studies.metrics.touch_metrics import in_vacuo, touch_response

if TYPE_CHECKING:
    from acoustic_fem.membrane.disc import DiscResponse  # loads its finite elements
    from studies.metrics.predicted_accuracy import SweptAccuracies


SWEPT_SENSORS = 24
"""Number of as-built sensors of each design of a batch."""


class SharedFigures:
    """Figures of one batch that more than one metric needs: each is computed when it is first asked for and kept here.

    Args:
        responses: of the batch.
        levels: of the noise of all confusions that will be asked for, as for :meth:`confusion`; they are predicted
            together.
    """

    def __init__(self, responses: Responses, levels: Iterable[float | None] = ()) -> None:
        self.responses = responses
        self._levels = tuple(dict.fromkeys(levels))
        self._distances: dict[tuple[float, float], PairDistances] = {}
        self._confusion: dict[float | None, PredictedConfusion] = {}
        self._touches: dict[str, ComplexArray] = {}

    def distances(self, band: tuple[float, float]) -> PairDistances:
        """Distances of all pairs of points over a band, Hz."""
        if band not in self._distances:
            self._distances[band] = pair_distances(self.responses, band)
        return self._distances[band]

    def confusion(self, level: float | None) -> PredictedConfusion:
        """Predicted confusions of the points.

        Args:
            level: white noise of the microphones, Pa rms over 0 to 500 Hz; None: that of the designs' microphones.
        """
        if level not in self._confusion:
            own = self.responses
            levels = self._levels if level in self._levels else (level,)
            noises = [_design_noise(own) if each is None else each for each in levels]
            found = predict_confusions(own.transfer_function, own.frequency, noises)
            self._confusion |= zip(levels, found, strict=True)
        return self._confusion[level]

    def touch_response(self, touch: str) -> ComplexArray:
        """Pressures at the microphones per touch, (n_design, n_point, n_microphone, n_freq) complex128, Pa per unit.

        Args:
            touch: "displacement" (m), "force" (N) or "pressure" (Pa).
        """
        if touch not in self._touches:
            self._touches[touch] = touch_response(self.responses, touch, self._vacuum)
        return self._touches[touch]

    @cached_property
    def _vacuum(self) -> DiscResponse:
        return in_vacuo(self.responses)

    def as_built(self, touch: str) -> Array:
        """Predicted top-1 accuracy of as-built sensors of each design, (n_design,) float64.

        Args:
            touch: "taps", "presses" or "multi_sines", as a run has them.
        """
        return self._as_built_accuracies[touch]

    @cached_property
    def _as_built_accuracies(self) -> Mapping[str, Array]:
        from studies.metrics.predicted_accuracy import SweptTouches  # needs torch, without which verbs print help
        from studies.metrics.touch_bins import TOUCHES

        designs = range(len(required(self.responses.designs)))
        found = self.swept.of(dict.fromkeys(designs, SweptTouches()))
        return dict(zip(TOUCHES, np.array([found[number] for number in designs]).T, strict=True))

    @cached_property
    def swept(self) -> SweptAccuracies:
        """Accuracies of as-built sensors of the designs; those of several kinds of touches are of the same sensors."""
        from studies.metrics.predicted_accuracy import SweptAccuracies

        own = self.responses
        return SweptAccuracies(required(own.designs), SWEPT_SENSORS, own.discs)

    @cached_property
    def sizes(self) -> Array:
        """Length, width and height of each design, (n_design, 3) float64, mm: length is the longer side."""
        sizes = [array_size(design) for design in required(self.responses.designs)]
        return np.array([(max(x, y), min(x, y), z) for x, y, z in sizes])

    @cached_property
    def volumes(self) -> list[Volumes]:
        """Volumes of the parts of each design, as :func:`studies.metrics.build.volumes_of`."""
        return [volumes_of(design) for design in required(self.responses.designs)]


def _design_noise(responses: Responses) -> Array:
    """Mean squares per hertz of the microphones' noise, (n_design, 500) float64, Pa^2."""
    found: dict[tuple[object, ...], Array] = {}
    rows = []
    for design, medium in zip(required(responses.designs), required(responses.medium), strict=True):
        key = (design.microphone, medium)
        if key not in found:
            found[key] = microphone_noise(design.microphone, medium).power
        rows.append(found[key])
    return np.stack(rows)
