"""Laying an array on a body: even places, the order of each line, microphones, ports and lengths; the frozen result."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from geometry.body.reading import Body
from geometry.body.samples import samples_of
from geometry.design.array_design import ArrayDesign
from geometry.design.shell_rules import membrane_top
from geometry.ground.refusal import Kind, counted
from geometry.ground.typed import Array
from geometry.layout.arrangement import lay_out
from geometry.layout.overlaps import overlaps
from geometry.layout.placement import ArrayLayout
from geometry.plan.routing import tightest_bend
from geometry.schema.field_errors import DesignError
from geometry.schema.part_fields import STUB_LENGTH_IN_RADII
from geometry.schema.surface_fields import SurfaceFit
from geometry.surface.covered_cells import cells_of
from geometry.surface.frozen_arrays import Laid, frozen_design
from geometry.surface.in_space import plan_in_space
from geometry.surface.microphones import Seats, placed_microphone, room_for_microphones, wanted_places
from geometry.surface.order import Order, crossings, steps_of
from geometry.surface.regions import Mask, region_of
from geometry.surface.rims import lifted_over, widest_gap
from geometry.surface.spread import arc_length, arc_lengths, equalised, nearest_spacing, relaxed, spread

#: Facets of the body by the pitch.
_FACETS = 9
#: Points by the number that a hexagonal lattice has room for, and the fraction that stays where they are too close.
_FILLED, _FEWER = 0.94, 0.95
#: Least gap between shells, mm.
_APART = 0.3
#: How far beyond its outermost points a region reaches, in pitches.
_MARGIN = 0.45
#: Seeds that are tried, and searches with dearer steps for each.
_SEEDS, _REPAIRS = 3, 6
#: As how many overlaps counts a try that is not a design.
_NOT_A_DESIGN = 5
_NAMED, _SHELL = re.compile(r"tube (\d+) of line (\d+)"), re.compile(r"^ports of shell (\d+)")


@dataclass(frozen=True)
class FittedSurface:
    """An array that was laid on a body."""

    design: ArrayDesign
    """The design with its frozen places and the lengths of its tubes."""
    layout: ArrayLayout
    """Where its parts lie."""
    spacing: tuple[float, float]
    """Mean distance of the points from their nearest neighbours, mm, and its coefficient of variation."""
    shell_kinds: int
    """Number of shells that differ by the directions of their ports."""
    tightest_bend: float
    """Smallest radius of the tubes, mm."""
    stretch: float
    """Root mean square by which distances of neighbours differ in the unrolled plan, as a fraction."""
    rim_gap: float
    """Largest gap that the bend of the body leaves under a shell or a housing, mm, or beside its top in a pocket."""

    @property
    def uncovered(self) -> float:
        """Largest distance of a place of the region from the rim of the nearest membrane, mm."""
        assert self.design.layout.frozen is not None
        return max(cell.distances[-1] for cell in self.design.layout.frozen.cells)

    @property
    def findings(self) -> tuple[str, ...]:
        """Sentences on the fit, such as parts of the region that were left out."""
        assert self.design.layout.frozen is not None
        return self.design.layout.frozen.findings


def fit_surface(
    design: ArrayDesign,
    body: Body,
    inputs: str = "",
    report: Callable[[str, float], None] = lambda text, fraction: None,
) -> FittedSurface:
    """Lay an array on a body.

    Points spread evenly over the region (Lloyd by arcs), each line joins near points, and tubes lie along the surface
    as smooth curves. Nothing of the body is repaired; what does not fit is refused by its place.

    Args:
        design: the array with its table ``[surface]``; its layout does not count.
        body: of :func:`geometry.body.read_body`.
        inputs: hash of what is fitted, kept with the places.
        report: called with what is done, in words, and the fraction of the work that is behind.

    Raises:
        Refusal: the lines do not follow each other, the region is empty or too narrow, or parts overlap in every try.
    """
    stated = design.surface
    if stated is None:
        raise DesignError("is missing", kind=Kind.MISSING, file=design.name, field="surface")
    names = _chain(design)
    fit = _Fit(design, stated, body, names, report)
    best: tuple[list[str], Laid] | None = None
    for seed in range(stated.seed, stated.seed + _SEEDS):
        found = fit.tried(seed)
        if best is None or len(found[0]) < len(best[0]):
            best = found
        if not best[0]:
            break
        report(f"seed {seed}: {counted(len(found[0]), 'fault')} left", 0.3 + 0.2 * (seed - stated.seed))
    assert best is not None
    notes, laid = best
    if notes:
        remedy = "choose a larger pitch or fewer points, thinner tubes, or other places of the microphones"
        if stated.tubes == "equal":
            remedy = f"{remedy}, or let the tubes be as they lie"
        raise DesignError.of_notes(design.name, list(dict.fromkeys(notes)), "cannot be laid on the body", remedy)
    return fit.result(laid, inputs)


def _chain(design: ArrayDesign) -> list[str]:
    """Microphones in the order of lines that follow each other.

    Raises:
        DesignError: they do not.
    """
    lines = design.lines
    names = [lines[0].between[0], *(line.between[1] for line in lines)]
    follows = all(one.between[1] == other.between[0] for one, other in pairwise(lines))
    if not follows or len(set(names)) < len(names):
        problem = "must follow each other, each from the microphone at which the one before it ends to a new one"
        raise DesignError(problem, kind=Kind.CONFLICT, file=design.name, field="lines")
    return names


class _Fit:
    """Body, region and sizes, which all tries share."""

    def __init__(
        self,
        design: ArrayDesign,
        stated: SurfaceFit,
        body: Body,
        names: list[str],
        report: Callable[[str, float], None],
    ) -> None:
        self.design, self.stated, self.body, self.names, self.report = design, stated, body, names, report
        resonator, microphone, axis = design.resonator, design.microphone, design.resonator.port_axis_height
        self.seats = Seats.of(design)
        self.cavity, self.outer = self.seats.shell
        self.least_length = self._least_length()
        self.counts = [line.points for line in design.lines]
        below = membrane_top(design)
        self.floor = stated.base + resonator.floor_thickness if stated.seat == "on" else -below
        under = microphone.wall_thickness + microphone.chamber_height / 2 - axis
        self.microphone_floor = max(self.floor, stated.base + under) if stated.seat == "on" else self.floor
        self.least = max(2 * self.outer + _APART, 2 * self.cavity + self.least_length)
        self.pitch = stated.pitch or self._guessed_pitch()
        if self.pitch < self.least and stated.pitch is None:
            raise DesignError(
                f"have {counted(sum(self.counts), 'point')}, so that neighbours would be {self.pitch:.3g} mm apart; "
                f"they must be at least {self.least:.3g} mm apart",
                kind=Kind.CONFLICT,
                file=design.name,
                field="lines",
                remedy="choose fewer points, or a larger region",
            )
        if self.pitch < self.least:
            raise DesignError(
                kind=Kind.CONFLICT,
                file=design.name,
                field="surface.pitch",
                value=round(self.pitch, 3),
                unit="mm",
                allowed=f"at least {self.least:.4g} mm, for shells {_APART:g} mm apart and the shortest tubes",
            )
        report("dividing the body", 0.1)
        self.ground = samples_of(body, self.pitch / _FACETS)
        self.region = region_of(self.ground, stated, self.outer, self.pitch)
        self.samples = self.ground.lifted(self.floor + axis)
        self.for_microphones = self.ground.lifted(self.microphone_floor + axis)
        self.room = room_for_microphones(self.ground, stated, self.seats)
        self.reach = self.seats.corner + self.outer + self.pitch
        self.wanted, self.findings = wanted_places(
            self.ground, self.room, self.region, names, stated, self.reach, self.seats.corner
        )
        self.findings = [*body.findings, *self.region.findings, *self.findings]
        self.soft, self.hard = self._masks()
        self.points = sum(self.counts) if stated.pitch is None else self._count()

    def _least_length(self) -> float:
        resonator, printing = self.design.resonator, self.design.printing
        tubes = [tube for line in self.design.lines for tube in (self.design.tube_of(line),)]
        stubs = max(STUB_LENGTH_IN_RADII * tube.inner_diameter for tube in tubes)
        return max(stubs, 2 * resonator.wall_thickness + 0.05, 2 * printing.port_lip + 0.05)

    def _guessed_pitch(self) -> float:
        """Distance of neighbours if the stated number of points fills what faces are stated, mm."""
        coarse = samples_of(self.body, float(self.body.extent.max()) / 40)
        region = region_of(coarse, self.stated, self.outer, 2 * self.outer)
        area = float(coarse.lifted(self.floor).areas[region.inside].sum())
        return math.sqrt(area * _FILLED / (sum(self.counts) * math.sqrt(3) / 2))

    def _masks(self) -> tuple[Mask, Mask]:
        """Samples that the cells of points fill, and those where the axis of a shell may be.

        Cells reach half a pitch beyond the outermost points.

        Raises:
            DesignError: there is no room for a shell.
        """
        hard = self.region.inside & (self.region.from_edge >= self.outer + self.stated.edge)
        clear = self.seats.corner + self.outer + 0.5
        for index in self.wanted:
            hard &= np.linalg.norm(self.ground.places - self.ground.places[index], axis=1) >= clear
        if not hard.any():
            raise DesignError(
                f"has no room for a shell of {2 * self.outer:.3g} mm beside the microphones and the edge",
                kind=Kind.CONFLICT,
                file=self.design.name,
                field="surface.region",
                remedy="choose a larger region, or places of the microphones outside of it",
            )
        soft = self.region.inside.copy()
        soft[soft] = cKDTree(self.ground.places[hard]).query(self.ground.places[soft])[0] <= _MARGIN * self.pitch
        return soft, hard

    def _count(self) -> int:
        area = float(self.samples.areas[self.soft].sum())
        count = round(area * _FILLED / (self.pitch**2 * math.sqrt(3) / 2))
        if count < 2 * len(self.counts):
            raise DesignError(
                f"has room for {counted(count, 'point')} at a pitch of {self.pitch:.3g} mm",
                kind=Kind.CONFLICT,
                file=self.design.name,
                field="surface.region",
                remedy="choose a smaller pitch or a larger region",
            )
        return count

    def tried(self, seed: int) -> tuple[list[str], Laid]:
        """Sentences on what overlaps, and the array, of one seed."""
        places = self._spread(seed)
        self.report(f"seed {seed}: {len(places)} points", 0.2 + 0.2 * (seed - self.stated.seed))
        lines = len(self.counts)
        counts = self.counts
        if self.stated.pitch is not None:
            counts = [len(places) // lines + (k < len(places) % lines) for k in range(lines)]
        level, normals = self.samples.projected(places)
        at = self._raised(level, normals, self.outer, self.floor)
        apart = arc_lengths(at, normals)
        spacing = float(np.median(nearest_spacing(at, normals)))
        targets = self.for_microphones.places[self.wanted]
        ends = np.linalg.norm(targets[:, None] - at[None], axis=2)
        order = Order(apart, np.maximum(ends - self.reach, 0) + 0.05 * ends, counts, spacing)
        best: tuple[list[str], Laid] | None = None
        for repair in range(_REPAIRS):
            tour = order.found(1000 * seed + repair)
            steps = steps_of(tour, counts)
            crossed = crossings(steps, at, normals)
            if crossed:
                order.dearer([steps[k] for pair in crossed for k in pair], 2.0)
                if repair < _REPAIRS - 1:
                    continue
            own = self._equalised(level, steps) if self.stated.tubes == "equal" and steps else (at, normals)
            found = self._laid(seed, tour, counts, *own, spacing)
            if best is None or len(found[0]) < len(best[0]):
                best = found
            if not best[0]:
                break
            self._avoid(order, found[0], tour, counts)
        assert best is not None
        return best

    def _equalised(self, level: Array, steps: list[tuple[int, int]]) -> tuple[Array, Array]:
        """Axes of the points at the height of the ports and their normals, (n, 3) each, with steps of one length."""
        level, normals = self.samples.projected(equalised(self.samples, self.hard, level, steps, self.least))
        return self._raised(level, normals, self.outer, self.floor), normals

    def _raised(self, at: Array, normals: Array, radius: float, floor: float) -> Array:
        """Axes at the height of the ports, raised where the rim of the floor would come closer to a hollow body.

        Parts that stand on a body keep the stated base under their rims too; both places are (n, 3) float64, mm.
        """
        if self.stated.seat == "in":
            return at
        return lifted_over(self.ground, at, normals, radius, self._above_rim(floor), self.stated.base)

    def _above_rim(self, floor: float) -> float:
        """Height of the ports of a part above its rim, mm: that of its underside, or in a pocket of its flush top."""
        base = self.stated.base if self.stated.seat == "on" else 0.0
        return floor - base + self.design.resonator.port_axis_height

    def _spread(self, seed: int) -> Array:
        count = self.points
        while True:
            places = spread(self.samples, self.soft, count, seed)
            hard = self.samples.places[self.hard]
            off, nearest = map(np.asarray, cKDTree(hard).query(places))
            places = np.where((off > 0.7 * self.samples.edge)[:, None], hard[nearest], places)
            places = relaxed(self.samples, self.hard, places)
            at, normals = self.samples.projected(places)
            if nearest_spacing(at, normals).min() >= self.least:
                return places
            if self.stated.pitch is None or count <= 2 * len(self.counts):
                break
            count = int(count * _FEWER)
        raise DesignError(
            f"is too small for {counted(count, 'point')}: neighbours must be {self.least:.3g} mm apart",
            kind=Kind.CONFLICT,
            file=self.design.name,
            field="surface.region",
            remedy="choose fewer points, or a larger region",
        )

    def _laid(
        self, seed: int, tour: list[int], counts: list[int], at: Array, normals: Array, spacing: float
    ) -> tuple[list[str], Laid]:
        stops = np.cumsum([0, *counts]).tolist()
        steps = np.array(steps_of(tour, counts))
        along = np.linspace(0.0, 1.0, 9)[:, None, None]
        tubes = ((1 - along) * at[steps[:, 0]] + along * at[steps[:, 1]]).reshape(-1, 3)
        found: list[Any] = []
        for k in range(len(self.names)):
            ends: list[tuple[int, int | None]] = []
            if k > 0:
                before = tour[stops[k] - 2] if counts[k - 1] > 1 else None
                ends.append((tour[stops[k] - 1], before))
            if k < len(counts):
                ends.append((tour[stops[k]], tour[stops[k] + 1] if counts[k] > 1 else None))
            placed, own = placed_microphone(
                self.for_microphones,
                self.room,
                self.wanted[k],
                ends,
                (at, normals),
                found,
                tubes,
                self.seats,
                self.reach,
                self.stated.port_step,
            )
            raised = self._raised(placed.place[None], placed.normal[None], self.seats.trunk, self.microphone_floor)[0]
            found.append(replace(placed, place=raised))
            tubes = np.vstack([tubes, own])
        laid = Laid(
            seed,
            counts,
            at[tour],
            normals[tour],
            np.array([each.place for each in found]),
            np.array([each.normal for each in found]),
            self.names,
            spacing,
        )
        laid = laid.rounded()
        try:
            design, step = frozen_design(self.design, self.stated, laid)
        except DesignError as error:
            # Ports of a microphone too close, a tube too short: another order may do.
            return [str(error)] * _NOT_A_DESIGN, laid
        layout = lay_out(design)
        return list(overlaps(design, layout)), replace(laid, design=design, layout=layout, step=step)

    def _avoid(self, order: Order, notes: list[str], tour: list[int], counts: list[int]) -> None:
        """Make dearer what notes name: a step between points, or a point at the end of a line."""
        stops = np.cumsum([0, *counts]).tolist()
        for tube, line in {named for note in notes for named in _NAMED.findall(note)}:
            k = int(line) - 1
            own, segment = tour[stops[k] : stops[k + 1]], int(tube) - 1
            if segment in (0, len(own)):
                order.farther(k if segment == 0 else k + 1, own[0] if segment == 0 else own[-1])
            else:
                order.dearer([(own[segment - 1], own[segment])], 2.0)
        for k, name in enumerate(self.names[1:-1], start=1):
            if any(f"end at {name!r}" in note for note in notes):
                order.farther(k, tour[stops[k]])
        for number in {int(found) for note in notes for found in _SHELL.findall(note)}:
            point = number - 1
            beside = [tour[k] for k in (point - 1, point, point + 1) if 0 <= k < len(tour)]
            order.dearer(list(pairwise(beside)), 1.5)

    def result(self, laid: Laid, inputs: str) -> FittedSurface:
        """The array with what is worth knowing about it."""
        assert laid.design is not None
        assert laid.layout is not None
        spacing = nearest_spacing(laid.points, laid.normals)
        mean, scatter = float(spacing.mean()), float(spacing.std() / spacing.mean())
        kinds = len({point.turned[0] for point in laid.layout.points})
        bend = min(tightest_bend(tube.course) for tube in laid.layout.tubes)
        top = membrane_top(self.design)
        cells, furthest = cells_of(
            self.ground.lifted(self.floor + top),
            self.region.inside,
            laid.points + (top - self.design.resonator.port_axis_height) * laid.normals,
            laid.normals,
            self.cavity,
        )
        discs = (
            (laid.points, laid.normals, self.outer, self.floor),
            (laid.microphones, laid.microphone_normals, self.seats.trunk, self.microphone_floor),
        )
        gap = max(
            widest_gap(self.ground, at - self._above_rim(floor) * normals, normals, radius)
            for at, normals, radius, floor in discs
        )
        where = "under the rims of" if self.stated.seat == "on" else "between the body and the flush tops of"
        stretch = plan_in_space(laid.design, laid.layout).stretch
        findings = [
            *self.findings,
            f"{len(laid.points)} points, {mean:.3g} mm apart with a scatter of {100 * scatter:.1f} %",
            f"{counted(kinds, 'kind')} of shells; tubes in steps of {laid.step:g} mm, bent to {bend:.2g} mm at most",
            f"gaps of up to {gap:.2g} mm {where} shells and housings, where the body is bent",
            f"the unrolled plan is off by {100 * stretch:.1f} % between neighbours",
        ]
        steps = steps_of(range(len(laid.points)), laid.counts)
        if self.stated.tubes == "equal" and steps:
            first, second = np.array(steps).T
            arcs = arc_length(laid.points[first], laid.normals[first], laid.points[second], laid.normals[second])
            unequal = 100 * float(arcs.std() / arcs.mean())
            findings.append(f"tubes between points of one length, over steps that scatter by {unequal:.1f} %")
        if len(laid.points) != self.points:
            findings.append(f"{self.points} points would have been too close")
        frozen = laid.design.layout.frozen
        assert frozen is not None
        values = {
            "layout.frozen.cells": cells,
            "layout.frozen.furthest": furthest.round(2).tolist(),
            "layout.frozen.findings": findings,
            "layout.frozen.body": self.body.sha256,
            "layout.frozen.inputs": inputs,
        }
        design = laid.design.with_values(values)
        return FittedSurface(design, laid.layout, (mean, scatter), kinds, bend, stretch, gap)
