"""Large deflections that were solved once: rows of rising load, kept in this process and, as cells are, on disk.

A row holds what :class:`acoustic_fem.membrane.equilibrium.Equilibrium` says of a state, without its unknowns. All
numbers are dimensionless, so that one table serves every modulus.

Stress is singular at the edge of the glue. Small elements, which the linear solution has there, collapse under large
loads, so the section of a table has larger ones. They make the disc stiffer by 2e-3 to 4e-3 at all loads. Therefore
volumes and compliances are multiplied by the ratio of the linear solution of
:mod:`acoustic_fem.membrane.elasticity` to that of the section.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from functools import lru_cache

import numpy as np
from scipy.interpolate import CubicHermiteSpline, PchipInterpolator

from acoustic_fem.membrane.equilibrium import Equilibrium, LoadedDisc, LoadKind, Setup
from acoustic_fem.membrane.finite_elasticity import Section
from acoustic_fem.membrane.half_section import DiscShape
from acoustic_fem.membrane.solved_discs import solved_disc
from acoustic_fem.numerics import disk_cache
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array

PRESS_MODEL_VERSION = 1
"""To be raised with every change of this model that changes a number."""
REFINEMENT = 2
"""Refinement of the section of a table."""
LARGEST_STRETCH = 8.0
"""A table ends at this principal stretch: silicones tear, and long before stiffen more than neo-Hookean rubber does."""

#: First load, the step behind it and the largest step, and the last load: depth / a, force / (E a^2), pressure / E.
_LOADS: dict[LoadKind, tuple[float, tuple[float, float], float]] = {
    "depth": (1e-5, (2e-3, 0.05), 10.0),
    "force": (1e-6, (4e-5, 0.05), 10.0),
    "pressure": (1e-6, (1e-5, 0.01), 0.1),
    "suction": (1e-6, (1e-5, 0.01), 0.1),
    "dead pressure": (1e-6, (1e-5, 0.01), 0.1),
}
_COLUMNS = (
    "load",
    "force",
    "volume",
    "volume_slope",
    "force_slope",
    "compliance",
    "held_compliance",
    "deepest",
    "indentation",
    "contact_radius",
    "floor_force",
    "stretch",
    "stress",
)
#: Columns that vanish with the load.
_VANISHING = frozenset({"volume", "deepest", "indentation", "stress"})

EDGE = "the indenter touches the disc up to its outer edge"
STRETCHED = f"the rubber is stretched {LARGEST_STRETCH:g} times"
LOST = "no equilibrium was found under a larger load"
COMPLETE = "the table goes no further"


@dataclass(frozen=True, eq=False)
class PressTable:
    """States of a disc under rising loads; lengths in a, forces in E a^2, pressures and stresses in E."""

    rows: dict[str, Array]
    """Columns by name, (n_row,) float64 each, the load ascending."""
    end: str
    """Why the table ends where it does."""

    @property
    def by_force(self) -> bool:
        """True for a table of forces, False for one of pressures."""
        return bool(self.rows["force"][-1] > 0)

    def at_force(self, name: str, force: Array) -> Array:
        """A column at forces, monotone between rows; below the first row as far as the law is linear.

        Args:
            name: of the column.
            force: 0 to the last row's, any shape, E a^2.
        """
        known, column = self.rows["force"], self.rows[name]
        if name == "stretch":
            return 1 + self._between("stretch", force, known, column - 1, vanishing=True)
        return self._between(name, force, known, column, vanishing=name in _VANISHING)

    def _between(self, name: str, force: Array, known: Array, column: Array, vanishing: bool) -> Array:
        place = np.log(np.maximum(force, known[0]))
        logarithmic = vanishing and bool((column > 0).all())
        spline = PchipInterpolator(np.log(known), np.log(column) if logarithmic else column)
        found = np.exp(spline(place)) if logarithmic else spline(place)
        return np.asarray(found * np.minimum(force / known[0], 1.0) if vanishing else found)

    def volume_slope(self, force: Array) -> Array:
        """Derivative of the displaced volume in the force of the interpolation, same shape as it, float64, a / E."""
        known = self.rows["force"]
        spline = PchipInterpolator(np.log(known), np.log(self.rows["volume"]))
        place = np.log(np.maximum(force, known[0]))
        ratio = self.at_force("volume", np.maximum(force, known[0])) / np.exp(place)
        return np.asarray(np.where(force < known[0], 1.0, spline.derivative()(place)) * ratio)

    def at_pressure(self, name: str, pressure: Array) -> Array:
        """A column at pressures from 0 to the last row's, any shape, E."""
        known = np.concatenate([[0.0], self.rows["load"]])
        column = self.rows[name]
        if name == "volume":
            slope = self.rows["volume_slope"]
            slopes = np.concatenate([[column[0] / known[1]], slope])
            return np.asarray(CubicHermiteSpline(known, np.concatenate([[0.0], column]), slopes)(pressure))
        first = 1.0 if name == "stretch" else 0.0 if name in _VANISHING else column[0]
        return np.asarray(PchipInterpolator(known, np.concatenate([[first], column]))(pressure))


@lru_cache(maxsize=64)
def solved_press(shape: DiscShape, setup: Setup, refinement: int = REFINEMENT) -> PressTable:
    """Table of a disc and a load, solved where nobody did before.

    Args:
        shape: the disc, flat and without prestress.
        setup: load, punch and floor.
        refinement: of the section, as for :class:`acoustic_fem.membrane.finite_elasticity.Section`.
    """
    key = disk_cache.key_of(
        {"press": PRESS_MODEL_VERSION, "refinement": refinement, "disc": asdict(shape), "setup": asdict(setup)}
    )
    kept = disk_cache.fetch(key)
    if kept is not None:
        return PressTable(kept[0], kept[1]["end"])
    table = solve_press(shape, setup, refinement)
    disk_cache.store(key, table.rows, {"end": table.end})
    return table


def solve_press(shape: DiscShape, setup: Setup, refinement: int = REFINEMENT) -> PressTable:
    """Table of a disc and a load; arguments as for :func:`solved_press`.

    Raises:
        Refusal: not even a small load has an equilibrium.
    """
    disc = LoadedDisc(Section(shape, refinement), setup)
    first, steps, last = _LOADS[setup.load]
    reach = disc.reach
    states: list[Equilibrium] = []
    end = LOST

    def enough(state: Equilibrium) -> bool:
        return state.stretch > LARGEST_STRETCH or (setup.punch is not None and state.contact_radius >= reach)

    for state in disc.path(first, steps, last, enough):
        if setup.punch is not None and state.contact_radius >= reach:
            end = EDGE
        elif state.stretch > LARGEST_STRETCH:
            end = STRETCHED
        elif states and not _rises(states[-1], state, setup):
            break
        elif state.force > 0 or setup.punch is None:
            states.append(state)
            end = COMPLETE if state.load >= last else LOST
    if len(states) < 2:
        raise Refusal(f"no equilibrium was found under a small {setup.load}", kind=Kind.NO_RESULT)
    rows = {name: np.array([getattr(state, name) for state in states]) for name in _COLUMNS}
    by_pressure, by_force, way = disc.linear_answers()
    exact = solved_disc(shape)
    volume = exact.volume_per_force / by_force if table_of_forces(setup) else exact.compliance / by_pressure
    softer = exact.compliance / by_pressure
    corrections = {"volume": volume, "volume_slope": volume, "compliance": softer, "held_compliance": softer}
    if setup.load == "force":
        corrections["indentation"] = exact.displacement_per_force / way
    return PressTable({name: column * corrections.get(name, 1.0) for name, column in rows.items()}, end)


def table_of_forces(setup: Setup) -> bool:
    """True for a load that is a force, False for a pressure."""
    return setup.load in ("depth", "force")


def _rises(before: Equilibrium, state: Equilibrium, setup: Setup) -> bool:
    """True if force and volume grow from one state to the next."""
    if table_of_forces(setup):
        return state.force > before.force and state.volume > before.volume
    return abs(state.volume) > abs(before.volume)
