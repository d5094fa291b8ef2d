"""Search for the fault that explains touches: all are tried quickly, the best are fitted with care."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.diagnosis.diagnosis_options import DiagnosisOptions
from localize.diagnosis.fault_libraries import FaultLibraries, Tables
from localize.diagnosis.fault_likelihood import Fitted, TouchLikelihood
from localize.diagnosis.faults import SensorFault, tube_lines


class FaultSearch:
    """Search for a fault by the likelihood of touches.

    Args:
        libraries: of the faults.
        likelihood: of the touches.
        options: of the diagnosis.
    """

    def __init__(self, libraries: FaultLibraries, likelihood: TouchLikelihood, options: DiagnosisOptions) -> None:
        self._libraries, self._likelihood, self._options = libraries, likelihood, options
        self._coarse = (*options.first_mismatches, options.mismatch)
        self._fine = (4 * options.mismatch, 2 * options.mismatch, options.mismatch)
        self._fits: dict[SensorFault | None, tuple[Tables, Fitted]] = {}

    def found(self) -> list[tuple[Tables, Fitted]]:
        """Sound sensor first, then the faults that explain the touches best, each part once, the best first."""
        self._fit([None, *self._candidates()])
        for step in range(2 * self._options.refinements):
            best = max(self._fits.values(), key=lambda each: each[1].evidence)
            if step >= self._options.refinements and best[1].misfit < self._options.converged:
                break
            self._try_points_of_others()
            best = max(self._fits.values(), key=lambda each: each[1].evidence)
            self._fit(self._beside(best[0].fault))
            for fault, (_, fit) in list(self._fits.items()):
                if fault is not None and fit.evidence < best[1].evidence - self._options.hopeless:
                    continue
                moved = self._libraries.about(fault, fit.deviations)
                self._fits[fault] = moved, self._likelihood.fitted(moved, self._fine, fit.deviations)
        self._try_points_of_others()
        sound = self._fits.pop(None)
        return [sound, *sorted(self._fits.values(), key=lambda each: -each[1].evidence)]

    def _fit(self, faults: Sequence[SensorFault | None]) -> None:
        """Fit hypotheses, each from several deviations to begin with."""
        for fault in faults:
            tables = self._libraries.of(fault)
            begun = [self._likelihood.fitted(tables, self._coarse, start) for start in self._starts()]
            self._fits[fault] = tables, max(begun, key=_evidence)

    def _beside(self, fault: SensorFault | None) -> list[SensorFault]:
        """Faults of the parts beside that of a fault which are not fitted yet, by the amount tried next to its own."""
        if fault is None or "microphone" in fault.kind:
            return []
        parts = {each.part for each in self._libraries.hypotheses if each is not None and each.kind == fault.kind}
        near = [(fault.part[0] + step,) for step in (-1, 1)]
        new = [replace(fault, part=part) for part in near if part in parts]
        return [each for each in new if not any(one is not None and one.same_part(each) for one in self._fits)]

    def _candidates(self) -> list[SensorFault]:
        """Faults of the likeliest parts, each by its likeliest amount."""
        scored: dict[tuple[str, tuple[int, ...]], tuple[float, SensorFault]] = {}
        for tables in self._libraries.screening:
            if tables.fault is None:
                continue
            evidence = self._likelihood.fitted(tables, (self._coarse[0], *self._coarse[2:])).evidence
            key = tables.fault.kind, tables.fault.part
            if key not in scored or evidence > scored[key][0]:
                scored[key] = evidence, tables.fault
        best = sorted(scored.values(), key=lambda each: -each[0])
        kept = [fault for _, fault in best[: self._options.candidates]]
        # Connections of microphones are few, and tell little before deviations are fitted.
        return kept + [fault for _, fault in best[self._options.candidates :] if "microphone" in fault.kind]

    def _starts(self) -> list[Array | None]:
        """Deviations to begin with: none known, and membranes that are softer or stiffer all together."""
        batch = self._libraries.batch_deviation
        return [None, *(each * batch for each in self._options.first_stiffness)]

    def _try_points_of_others(self) -> None:
        """Let the best fits go on from the points of others, and from their own moved by one place, while it helps."""
        for _ in range(self._options.moves):
            order = sorted(self._fits, key=lambda fault: -self._fits[fault][1].evidence)
            leading = [self._fits[fault][1].point for fault in order[: self._options.leading]]
            helped = False
            for fault in dict.fromkeys([None, *order[: self._options.moved]]):
                tables, fit = self._fits[fault]
                tried = [point for point in (*leading, *self._moved(fault, fit.point)) if (point != fit.point).any()]
                fits = [self._likelihood.fitted(tables, self._coarse[1:], None, point) for point in tried]
                best = max((fit, *fits), key=_evidence)
                helped = helped or best.evidence > fit.evidence + 1.0
                self._fits[fault] = tables, best
            if not helped:
                return

    def _moved(self, fault: SensorFault | None, point: NDArray[np.int64]) -> list[NDArray[np.int64]]:
        """Points moved by one place along their lines, all, or those on one side of a fault or of the middle."""
        line = np.repeat(range(len(self._libraries.design.lines)), [one.points for one in self._libraries.design.lines])
        sides = [np.ones(len(point), bool)]
        place = len(line) // 2
        if fault is not None and "microphone" not in fault.kind:
            place = fault.part[0] - 1
            if fault.kind == "blocked tube":
                place -= tube_lines(self._libraries.design)[place]
        sides += [point >= place, point < place]
        found = []
        for side in sides:
            for step in (-1, 1):
                moved = np.clip(point + step, 0, len(line) - 1)
                found.append(np.where(side & (line[moved] == line[point]), moved, point))
        return found


def _evidence(fit: Fitted) -> float:
    return fit.evidence
