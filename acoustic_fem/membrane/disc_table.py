"""Membranes of many thicknesses and rims from few solutions: interpolation between solved discs.

A disc takes about a twentieth of a second to solve. A sweep of thousands of proportions would spend its time there;
statics and the first mode are smooth in thickness and rim, so that a few dozen discs on Chebyshev points give them all.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial.chebyshev import chebvander

from acoustic_fem.membrane.elasticity import ElasticDisc, solve_dimensionless
from acoustic_fem.membrane.half_section import DiscShape
from geometry.ground.typed import Array

#: Largest relative error of the interpolated statics and of the first mode, unless another one is asked for.
ACCURACY = 3e-4
#: Fewest points along thickness and along rim, and how many more per factor e of the range.
_POINTS, _MORE = 4, (2.5, 1.5)
_MOST = 400
#: Points between, where a table is checked.
_CHECKS = 3
#: So many discs are worth a table; fewer are solved one by one.
_FEWEST = 50

Solve = Callable[[Sequence[DiscShape]], list[ElasticDisc]]


@dataclass(frozen=True, eq=False)
class DiscTable:
    """Discs that differ in thickness and rim alone, without pre-stress."""

    like: DiscShape
    """One of the discs; its Poisson's ratio and contact are those of all."""
    bounds: Array
    """Logarithms of the lowest and highest thickness / a (first row) and rim / a, ratios, (2, 2) float64."""
    discs: tuple[ElasticDisc, ...]
    """Solved discs in the order of the points: rim changes fastest."""
    coefficients: Array
    """Chebyshev coefficients of the logarithms of the three static answers and of the first mode's eigenvalue, swept
    volume and patch displacement, (n_thickness, n_rim, 6) float64.
    """
    error: float
    """Largest relative error of those where it was checked."""

    def covers(self, shape: DiscShape) -> bool:
        """True if a disc lies within the table."""
        if _family(shape) != _family(self.like):
            return False
        place = np.log([shape.thickness, shape.rim or 1.0])
        return bool(((place >= self.bounds[:, 0] - 1e-9) & (place <= self.bounds[:, 1] + 1e-9)).all())

    def at(self, shape: DiscShape) -> ElasticDisc:
        """A disc of the table: statics and the first mode interpolated, what lies above from the nearest one.

        Deflection and mode shapes are those of the nearest solved disc, scaled.
        """
        unit = self._unit(shape)
        rows = [
            chebvander(np.array([x]), size - 1)[0] for x, size in zip(unit, self.coefficients.shape[:2], strict=True)
        ]
        compliance, by_force, displacement, eigenvalue, swept, patch = np.exp(rows[0] @ (self._table(rows[1])))
        near = self.discs[self._nearest(unit)]
        # What the first mode leaves of the statics belongs to the other columns: scaled so that the sums are right.
        own = near.swept[1:], near.patch[1:], near.eigenvalues[1:]
        rest = _fitted(
            *own,
            compliance - swept**2 / eigenvalue,
            by_force - swept * patch / eigenvalue,
            displacement - patch**2 / eigenvalue,
        )
        return replace(
            near,
            eigenvalues=np.concatenate([[eigenvalue], near.eigenvalues[1:]]),
            swept=np.concatenate([[swept], rest[0]]),
            patch=np.concatenate([[patch], rest[1]]),
            compliance=float(compliance),
            volume_per_force=float(by_force),
            displacement_per_force=float(displacement),
            deflection=near.deflection * (compliance / near.compliance),
        )

    def _table(self, row: Array) -> Array:
        return np.einsum("tri,r->ti", self.coefficients, row)

    def _unit(self, shape: DiscShape) -> Array:
        """Place in the table, -1 to 1 along thickness and rim."""
        low, high = self.bounds.T
        width = np.where(high > low, high - low, 1.0)
        return (2 * np.log([shape.thickness, shape.rim or 1.0]) - low - high) / width

    def _nearest(self, unit: Array) -> int:
        sizes = self.coefficients.shape[:2]
        index = [int(np.abs(_points(size) - x).argmin()) for size, x in zip(sizes, unit, strict=True)]
        return index[0] * sizes[1] + index[1]


@dataclass(frozen=True, eq=False)
class DiscTables:
    """Several tables as :class:`acoustic_fem.membrane.disc.KnownDiscs`: membranes that one covers come from it."""

    tables: tuple[DiscTable, ...] = ()
    """Tables in the order in which they are asked."""

    def find(self, shape: DiscShape) -> ElasticDisc | None:
        """Disc of a shape, None where no table covers it."""
        return next((table.at(shape) for table in self.tables if table.covers(shape)), None)


def disc_tables(
    shapes: Iterable[DiscShape], solve: Solve | None = None, *, accuracy: float = ACCURACY
) -> tuple[DiscTable, ...]:
    """Tables for the discs of a sweep: one for each group of which there are more than a table takes to make.

    Args:
        shapes: all discs that will be asked for.
        solve: solves several discs, such as side by side; by default one after the other.
        accuracy: largest relative error of the interpolated statics and of the first mode, where it is checked.

    Returns:
        The tables; a group that could not be interpolated to this accuracy gets no table.
    """
    made = []
    for group in _groups(shapes):
        table = _made(group, solve or (lambda several: [solve_dimensionless(shape) for shape in several]), accuracy)
        if table is not None:
            made.append(table)
    return tuple(made)


def disc_count(shapes: Iterable[DiscShape]) -> int:
    """Number of discs that are solved for a sweep if its tables are accurate at once."""
    shapes = dict.fromkeys(shapes)
    groups = _groups(shapes)
    count = len(shapes) - sum(map(len, groups))
    for group in groups:
        size = math.prod(_sizes(_bounds(group)))
        count += len(group) if len(group) < max(_FEWEST, size) else size + _CHECKS
    return count


def _groups(shapes: Iterable[DiscShape]) -> list[list[DiscShape]]:
    groups: dict[object, list[DiscShape]] = {}
    for shape in dict.fromkeys(shapes):
        if shape.prestress == 0 and shape.glue == shape.rim and shape.raised is None:
            groups.setdefault(_family(shape), []).append(shape)
    return list(groups.values())


def _bounds(group: Sequence[DiscShape]) -> Array:
    places = np.log([[shape.thickness, shape.rim or 1.0] for shape in group])
    return np.stack([places.min(axis=0), places.max(axis=0)], axis=1)


def _sizes(bounds: Array) -> list[int]:
    """Points along thickness and along rim."""
    widths = bounds[:, 1] - bounds[:, 0]
    return [1 if w < 1e-12 else math.ceil(_POINTS + more * w) for w, more in zip(widths, _MORE, strict=True)]


def _made(group: Sequence[DiscShape], solve: Solve, accuracy: float) -> DiscTable | None:
    bounds = _bounds(group)
    sizes = _sizes(bounds)
    while len(group) >= _FEWEST and math.prod(sizes) < min(len(group), _MOST):
        table = _solved(group[0], bounds, sizes, solve)
        if table.error <= accuracy:
            return table
        sizes = [size if size == 1 else math.ceil(1.5 * size) for size in sizes]
    return None


def _solved(like: DiscShape, bounds: Array, sizes: Sequence[int], solve: Solve) -> DiscTable:
    points = [_points(size) for size in sizes]
    # between the points, in the middle and at both ends
    checks = [(_between(points[0], k), _between(points[1], -1 - k)) for k in (0, sizes[0] // 2, -1)]

    def shape_at(unit: Sequence[float]) -> DiscShape:
        place = np.exp((bounds[:, 0] + bounds[:, 1] + np.array(unit) * (bounds[:, 1] - bounds[:, 0])) / 2)
        rim = float(place[1]) if like.rim else 0.0
        return replace(like, thickness=float(place[0]), rim=rim, glue=rim)

    discs = solve([shape_at(unit) for unit in (*itertools.product(*points), *checks)])
    count = math.prod(sizes)
    values = np.array([_smooth(disc) for disc in discs])
    nodal = values[:count].reshape(*sizes, -1)
    along = [np.linalg.inv(chebvander(x, len(x) - 1)) for x in points]
    coefficients = np.einsum("ti,rj,ijq->trq", *along, nodal)
    table = DiscTable(like, bounds, tuple(discs[:count]), coefficients, math.inf)
    guesses = [_smooth(table.at(shape_at(unit))) for unit in checks]
    return replace(table, error=float(np.abs(np.array(guesses) - values[count:]).max()))


def _smooth(disc: ElasticDisc) -> Array:
    """Logarithms of what is interpolated."""
    first = disc.eigenvalues[0], disc.swept[0], disc.patch[0]
    return np.log([disc.compliance, disc.volume_per_force, disc.displacement_per_force, *first])


def _fitted(
    swept: Array, patch: Array, eigenvalues: Array, compliance: float, by_force: float, displacement: float
) -> tuple[Array, Array]:
    """Columns like the given ones whose static sums are the given ones."""

    def static(a: Array, b: Array) -> float:
        return float((a * b / eigenvalues).sum())

    swept = swept * math.sqrt(compliance / static(swept, swept))
    along = by_force / compliance
    across = patch - swept * (static(swept, patch) / compliance)
    across = across * math.sqrt((displacement - along**2 * compliance) / static(across, across))
    return swept, along * swept + across


def _points(size: int) -> Array:
    """Chebyshev points with both ends, ascending."""
    return np.zeros(1) if size == 1 else -np.cos(np.pi * np.arange(size) / (size - 1))


def _between(points: Array, index: int) -> float:
    if len(points) == 1:
        return 0.0
    middles = (points[1:] + points[:-1]) / 2
    return float(middles[index % len(middles)])


def _family(shape: DiscShape) -> tuple[float, float, float, bool, bool]:
    return shape.poisson_ratio, shape.contact, shape.prestress, shape.rim > 0, shape.glue == shape.rim
