"""Search for the fault that explains touches: all are tried quickly, the best are fitted with care."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from geometry.ground.typed import Array
from localize.diagnosis.diagnosis_options import DiagnosisOptions
from localize.diagnosis.fault_libraries import FaultLibraries, Tables
from localize.diagnosis.fault_likelihood import Begin, Fitted, TouchLikelihood
from localize.diagnosis.faults import AMOUNTS, SPREAD, SensorFault, tube_lines
from localize.diagnosis.touch_assignment import likeliest_assignments

_Key: TypeAlias = tuple[Tables, bytes, bytes]


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
        self._quick = (options.first_mismatches[1], options.first_mismatches[-1])
        self._fine = (4 * options.mismatch, 2 * options.mismatch, options.mismatch)
        self._fits: dict[SensorFault | None, tuple[Tables, Fitted]] = {}
        # What was computed already, by tables and the deviations or points to begin with.
        self._quickly: dict[tuple[Tables, bytes], float] = {}
        self._together: dict[tuple[Tables, bytes], NDArray[np.int64]] = {}
        self._further: dict[_Key, tuple[Tables, Fitted]] = {}

    def found(self) -> list[tuple[Tables, Fitted]]:
        """Sound sensor first, then the faults that explain the touches best, each part once, the best first."""
        options = self._options
        self._fit([[None], *self._candidates()])
        for step in range(2 * options.refinements):
            if step >= options.refinements and self._best.misfit < options.converged:
                break
            self._begin_anew()
            self._fit([[near] for near in self._beside(self._order[0])])
            self._refine()
        self._begin_anew()
        sound = self._fits.pop(None)
        return [sound, *(self._fits[fault] for fault in self._order)]

    @property
    def _order(self) -> list[SensorFault | None]:
        """Hypotheses that are fitted, the best first."""
        return sorted(self._fits, key=lambda fault: -self._fits[fault][1].evidence)

    @property
    def _best(self) -> Fitted:
        return self._fits[self._order[0]][1]

    def _refine(self) -> None:
        """Go on with the best fits, with derivatives about the deviations they have."""
        least = self._best.evidence - self._options.hopeless
        near = [fault for fault in self._order[: self._options.refined] if self._fits[fault][1].evidence > least]
        faults = list(dict.fromkeys([None, *near]))
        before = [self._fits[fault][1] for fault in faults]
        deviations = [fit.deviations for fit in before]
        # A fit may have another amount than the first of its part, and deviations are those from its own.
        tables = self._libraries.about([self._fits[fault][0].fault for fault in faults], deviations)
        # Steps may lead away from a good fit, so each fit is also kept as it is, and with its points.
        begun = [Begin(own, start) for own, start in zip(tables, deviations, strict=True)]
        held = [Begin(own, fit.deviations, fit.point) for own, fit in zip(tables, before, strict=True)]
        tried = zip(
            self._likelihood.fitted(begun, self._fine),
            self._likelihood.fitted(held, self._fine),
            self._likelihood.fitted(begun, ()),
            strict=True,
        )
        fits = [max(each, key=lambda fit: fit.peak) for each in tried]
        self._fits |= zip(faults, zip(tables, fits, strict=True), strict=True)

    def _fit(self, parts: Sequence[Sequence[SensorFault | None]]) -> None:
        """Fit the fault of each part, by its likeliest amounts, from several deviations and points to begin with."""
        faults = [fault for alike in parts for fault in alike]
        leading = {alike[0] for alike in parts}
        every = self._libraries.of(faults)
        begun = [
            [Begin(tables, start) for start in self._starts()[: None if fault in leading else 1]]
            for fault, tables in zip(faults, every, strict=True)
        ]
        together = [
            Begin(tables, None, self._points_together(tables, np.zeros(self._libraries.size))) for tables in every
        ]
        fits = iter(self._likelihood.fitted([each for some in begun for each in some], self._coarse))
        others = self._likelihood.fitted(together, self._coarse[1:])
        best = [
            max([*(next(fits) for _ in some), other], key=_evidence) for some, other in zip(begun, others, strict=True)
        ]
        fitted = iter(self._nearer(list(zip(every, best, strict=True))))
        for alike in parts:
            self._fits[alike[0]] = max((next(fitted) for _ in alike), key=lambda each: each[1].evidence)

    def _points_together(self, tables: Tables, deviations: Array) -> NDArray[np.int64]:
        """Likeliest points of all touches together, (n_touch,) int64."""
        key = tables, deviations.tobytes()
        if key not in self._together:
            mismatch, kept = self._options.assigned_mismatch, self._options.assignments
            found = likeliest_assignments(self._likelihood, tables, deviations, mismatch, kept)
            self._together[key] = found[0]
        return self._together[key]

    def _nearer(self, begun: Sequence[tuple[Tables, Fitted]]) -> list[tuple[Tables, Fitted]]:
        """Fits that go on with transfer functions about the deviations they have."""
        if not begun:
            return []
        nearer = self._libraries.nearer([tables for tables, _ in begun], [fit.deviations for _, fit in begun])
        fine = [Begin(tables, fit.deviations, fit.point) for tables, (_, fit) in zip(nearer, begun, strict=True)]
        return list(zip(nearer, self._likelihood.fitted(fine, self._fine[1:]), strict=True))

    def _beside(self, fault: SensorFault | None) -> list[SensorFault]:
        """Faults of the parts beside that of a fault which are not fitted yet, by the amount tried next to its own."""
        if fault is None or "microphone" in fault.kind:
            return []
        parts = {each.part for each in self._libraries.hypotheses if each is not None and each.kind == fault.kind}
        near = [(fault.part[0] + step,) for step in (-1, 1)]
        new = [replace(fault, part=part) for part in near if part in parts]
        return [each for each in new if not any(one is not None and one.same_part(each) for one in self._fits)]

    def _candidates(self) -> list[list[SensorFault]]:
        """Faults of the likeliest parts, each by its likeliest amounts, the best first."""
        scored: dict[tuple[str, tuple[int, ...]], list[tuple[float, SensorFault]]] = {}
        broken = [tables for tables in self._libraries.screening if tables.fault is not None]
        fits = self._likelihood.fitted([Begin(tables) for tables in broken], (self._coarse[0], *self._coarse[2:]))
        for tables, fit in zip(broken, fits, strict=True):
            assert tables.fault is not None
            scored.setdefault((tables.fault.kind, tables.fault.part), []).append((fit.evidence, tables.fault))
        parts = [sorted(each, key=lambda one: -one[0]) for each in scored.values()]
        parts.sort(key=lambda each: -each[0][0])
        chosen = [[fault for _, fault in part[: self._options.amounts]] for part in parts]
        kept = chosen[: self._options.candidates]
        # Connections of microphones are few, and tell little before deviations are fitted.
        return kept + [each for each in chosen[self._options.candidates :] if "microphone" in each[0].kind]

    def _starts(self) -> list[Array | None]:
        """Deviations to begin with: none known, and membranes that are softer or stiffer all together."""
        batch = self._libraries.batch_deviation
        return [None, *(each * batch for each in self._options.first_stiffness)]

    def _begin_anew(self) -> None:
        """Let the best fits begin anew from other points, while it helps.

        Tried are the likeliest assignments about the deviations found, and the points of the leading faults, as they
        are or moved by one place.
        """
        options = self._options
        for _ in range(options.moves):
            order = self._order
            others: list[NDArray[np.int64]] = []
            for fault in order[: options.leading]:
                point = self._fits[fault][1].point
                others += [point, *self._moved(fault, point)]
            helped = False
            beside = [fault for fault in order if fault is not None and self._is_beside(fault, order[0])]
            faults = list(dict.fromkeys([None, *order[: options.moved], *beside]))
            tried = self._tried(faults, list({point.tobytes(): point for point in others}.values()))
            for fault, found in zip(faults, self._again(tried), strict=True):
                for each in found:
                    if each[1].evidence > self._fits[fault][1].evidence + 1.0:
                        helped, self._fits[fault] = True, each
            if not helped:
                return

    def _tried(self, faults: Sequence[SensorFault | None], others: Sequence[NDArray[np.int64]]) -> list[list[Begin]]:
        """Beginnings of each fault beside its own fit: its likeliest of other points, and all touches together."""
        nominal = self._libraries.of([self._as_strong(fault) for fault in faults])
        own = [[start for start in others if (start != self._fits[fault][1].point).any()] for fault in faults]
        new = [
            (tables, start.tobytes())
            for tables, starts in zip(nominal, own, strict=True)
            for start in starts
            if (tables, start.tobytes()) not in self._quickly
        ]
        begun = [Begin(tables, None, np.frombuffer(start, np.int64)) for tables, start in new]
        fits = self._likelihood.fitted(begun, self._quick)
        self._quickly |= {key: fit.evidence for key, fit in zip(new, fits, strict=True)}
        found = []
        for fault, tables, starts in zip(faults, nominal, own, strict=True):
            ranked = sorted(starts, key=lambda start: -self._quickly[tables, start.tobytes()])
            begin = [Begin(tables, None, start) for start in ranked[: self._options.begun]]
            nearer, fit = self._fits[fault]
            together = self._points_together(nearer, fit.deviations)
            if (together != fit.point).any():
                begin.append(Begin(nearer, fit.deviations, together))
            found.append(begin)
        return found

    def _again(self, tried: Sequence[Sequence[Begin]]) -> list[list[tuple[Tables, Fitted]]]:
        """Fits from several beginnings of each hypothesis; none is fitted twice."""
        keys = [[_key(each) for each in some] for some in tried]
        new = {key: each for some, own in zip(tried, keys, strict=True) for each, key in zip(some, own, strict=True)
               if key not in self._further}  # fmt: skip
        fits = self._likelihood.fitted(list(new.values()), self._coarse[1:])
        begun = [(each.tables, fit) for each, fit in zip(new.values(), fits, strict=True)]
        self._further |= zip(new, self._nearer(begun), strict=True)
        return [[self._further[key] for key in own] for own in keys]

    def _is_beside(self, fault: SensorFault, best: SensorFault | None) -> bool:
        """True if a fault is of the best one's kind, at a part beside its own."""
        return best is not None and fault.kind == best.kind and abs(fault.part[0] - best.part[0]) == 1

    def _as_strong(self, fault: SensorFault | None) -> SensorFault | None:
        """The fault by the amount that is tried next to the one of the best fit, if that is of the same kind."""
        tables, fit = self._fits[self._order[0]]
        best, own = tables.fault, self._fits[fault][0].fault
        if fault is None or best is None or fault.kind != best.kind or fault.kind not in SPREAD:
            return own
        found = best.with_amount(float(fit.deviations[-1])).amount
        nearest = min(AMOUNTS[fault.kind], key=lambda amount: abs(np.log(amount / found)))
        return replace(fault, amount=nearest)

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


def _key(begin: Begin) -> _Key:
    deviations, point = (b"" if each is None else each.tobytes() for each in (begin.deviations, begin.point))
    return begin.tables, deviations, point


def _evidence(fit: Fitted) -> float:
    return fit.evidence
