"""Equilibrium of a disc of rubber at finite strain under a rigid body, a soft patch or a pressure, above a floor.

Newton's method on displacements, pressures and contact pressures together. Loads are raised in steps: each begins at
the line through the two states before it, and is halved where Newton's method does not converge.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.linalg import splu

from acoustic_fem.membrane.contact_surface import Face, Floor, Punch, RigidBody, swept_volume
from acoustic_fem.membrane.finite_elasticity import Block, Numbers, Section
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array

#: Newton's method stops below this residual, in E a^2.
_TOLERANCE = 1e-9
_ITERATIONS = 15
#: A step of the load grows where Newton's method took at most so many iterations.
_QUICK, _GROWTH = 6, 1.5
#: Smallest step, by the load that is reached.
_SMALLEST = 4e-3
#: Largest growth of the force in one step, and of a pressure.
_FORCE_GROWTH, _PRESSURE_GROWTH = 0.35, 0.5
#: Weight of a gap against a pressure where the touching corners are chosen, in E / a.
_STIFFNESS = 10.0

LoadKind = Literal["depth", "force", "pressure", "suction", "dead pressure"]


@dataclass(frozen=True)
class Punching:
    """Shape of a rigid punch."""

    flat: float
    """Radius of its flat end, in a."""
    edge: float
    """Radius of its edge, or of the sphere, in a."""


@dataclass(frozen=True)
class Setup:
    """Load, punch and floor of a disc."""

    load: LoadKind
    """Quantity that is raised: depth of a punch below the relaxed upper face, in a; force on the soft patch, constant
    per relaxed area and vertical, in E a^2; pressure on the lower face over the opening, in E, normal to the deformed
    face; suction, its opposite; or a pressure that stays vertical and constant per relaxed area (dead pressure)."""
    punch: Punching | None = None
    """The punch of a depth."""
    floor: float | None = None
    """Depth of the floor below the lower face, in a; None without a floor."""


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """A disc in equilibrium, in a, E and their products."""

    load: float
    """Depth, force or pressure, as the setup says."""
    state: Array
    """All unknowns, (n,) float64."""
    iterations: int
    """Iterations of Newton's method."""
    force: float
    """Force on the disc, downwards, E a^2."""
    volume: float
    """Volume displaced into the cavity, a^3."""
    volume_slope: float
    """Its derivative in the load."""
    force_slope: float
    """Derivative of the force in the load."""
    compliance: float
    """Volume swept outwards per small pressure on the lower face under a constant force, a^3 / E."""
    held_compliance: float
    """The same while punch or patch are held where they are, a^3 / E."""
    deepest: float
    """Way of the lower face's middle into the cavity, a."""
    indentation: float
    """Depth of the punch, or mean way of the soft patch downwards; 0 under a pressure, a."""
    contact_radius: float
    """Radius, on the relaxed upper face, up to which the punch touches; 0 without one, a."""
    floor_force: float
    """Force on the floor, E a^2."""
    stretch: float
    """Largest principal stretch away from the glue's edges."""
    stress: float
    """Largest principal Cauchy stress away from the glue's edges, E."""


class _System(NamedTuple):
    """Residual and tangent at a state."""

    residual: Array
    blocks: list[Block]
    diagonal: tuple[Numbers, Array]
    """Unknowns of contact pressures that are 0, and their entries on the diagonal."""
    touching: NDArray[np.bool_]
    by_load: Array
    """Derivative of the residual in the load."""
    stiffness: float
    """Derivative of the force in the depth of the punch, the state unchanged."""
    force: float
    volume: float
    volume_gradient: Array


class LoadedDisc:
    """A disc with faces that may be touched.

    Args:
        section: the disc.
        setup: its loads.
    """

    def __init__(self, section: Section, setup: Setup) -> None:
        self.section, self.setup = section, setup
        self.opening = Face(section, section.opening)
        self._faces: list[tuple[Face, int]] = []
        self.size = section.size
        self._free: list[Numbers] = [section.free]
        if setup.punch is not None:
            self._touched(Face(section, section.upper_face))
        if setup.floor is not None:
            self._touched(self.opening)
        self.free = np.concatenate(self._free)
        self.relaxed = np.zeros(self.size)
        middle = (section.displacement.doflocs == 0).all(axis=0) & np.isin(np.arange(section.displacement.N), self.free)
        (self._middle,) = np.flatnonzero(middle)
        self._dead = swept_volume(self.opening, self.relaxed).gradient

    @property
    def reach(self) -> float:
        """Contact radius at which a punch has all but reached the outer edge of the disc, a."""
        return float(self._faces[0][0].corners[-2]) if self.setup.punch is not None else np.inf

    def _touched(self, face: Face) -> None:
        self._faces.append((face, self.size))
        self._free.append(np.arange(self.size, self.size + len(face.corners)))
        self.size += len(face.corners)

    def _bodies(self, load: float) -> Iterator[tuple[Face, int, RigidBody]]:
        bodies: list[RigidBody] = []
        if self.setup.punch is not None:
            bodies.append(
                Punch(self.setup.punch.flat, self.setup.punch.edge, lowest=self.section.shape.thickness - load)
            )
        if self.setup.floor is not None:
            bodies.append(Floor(self.setup.floor))
        for (face, first), body in zip(self._faces, bodies, strict=True):
            yield face, first, body

    # -- one load -----------------------------------------------------------------------------------
    def _system(self, state: Array, load: float) -> _System | None:
        """Residual and tangent of all unknowns; None where an element is turned inside out."""
        section = self.section
        strain = section.strain(state)
        if strain is None:
            return None
        residual = np.zeros(self.size)
        residual[: section.size] = section.residual(strain)
        blocks = section.tangent(strain)
        if (glue := section.glue) is not None:
            np.add.at(residual, glue.rows, np.einsum("eij,ej->ei", glue.values, state[glue.columns]))
            blocks.append(glue)
        by_load = np.zeros(self.size)
        stiffness, force, touching = 0.0, 0.0, []
        volume = swept_volume(self.opening, state)
        if self.setup.load == "force":
            by_load[: section.size] = section.patch
            residual += load * by_load
            force = load
        elif self.setup.load in ("pressure", "suction"):
            sign = -1.0 if self.setup.load == "pressure" else 1.0
            by_load = sign * volume.gradient
            residual += load * by_load
            blocks.append(volume.curvature._replace(values=sign * load * volume.curvature.values))
        elif self.setup.load == "dead pressure":
            by_load = -self._dead
            residual += load * by_load
        idle = [np.zeros(0, np.int64)]
        released = [np.zeros(0)]
        for face, first, body in self._bodies(load):
            unknowns = np.arange(first, first + len(face.corners))
            pressure = state[unknowns]
            gaps = face.gaps(state[: section.size], pressure, body)
            active = pressure - _STIFFNESS * gaps.mean / face.area > 0
            touching.append(active)
            gradient = gaps.gradient
            columns = gradient.rows + first
            np.add.at(residual, gradient.columns, -np.einsum("eki,ek->ei", gradient.values, pressure[gradient.rows]))
            residual[unknowns] = np.where(active, -gaps.mean, -face.area * pressure)
            blocks.append(gaps.curvature)
            blocks.append(Block(-gradient.values.swapaxes(1, 2), gradient.columns, columns))
            # Corners that do not touch have rows of their own.
            blocks.append(Block(-gradient.values * active[gradient.rows][..., None], columns, gradient.columns))
            idle.append(unknowns[~active])
            released.append(-face.area[~active])
            if isinstance(body, Punch):
                force, stiffness = gaps.force, gaps.stiffness
                by_load[: section.size] += gaps.turned
                by_load[unknowns] = np.where(active, -gaps.moved, 0.0)
        diagonal = np.concatenate(idle), np.concatenate(released)
        touched = np.concatenate(touching) if touching else np.zeros(0, bool)
        return _System(residual, blocks, diagonal, touched, by_load, stiffness, force, volume.value, volume.gradient)

    def _factor(self, system: _System) -> Callable[[Array], Array]:
        """Solver of the tangent on the free unknowns."""
        rows, columns, values = [system.diagonal[0]], [system.diagonal[0]], [system.diagonal[1]]
        for block in system.blocks:
            rows.append(np.broadcast_to(block.rows[:, :, None], block.values.shape).ravel())
            columns.append(np.broadcast_to(block.columns[:, None, :], block.values.shape).ravel())
            values.append(block.values.ravel())
        entries = np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))
        whole = coo_array(entries, shape=(self.size, self.size)).tocsr()
        matrix = whole[self.free][:, self.free].tocsc()
        options = {"SymmetricMode": True}
        factors = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.01, options=options)

        def solve(right: Array) -> Array:
            solution = np.zeros(self.size)
            solution[self.free] = factors.solve(right[self.free])
            return solution

        return solve

    def solve(self, load: float, start: Array) -> Equilibrium | None:
        """Equilibrium at a load; None where Newton's method does not converge.

        Args:
            load: depth, force or pressure, as the setup says.
            start: state to begin with, (n,) float64.
        """
        state, before = start.copy(), None
        for iteration in range(_ITERATIONS):
            system = self._system(state, load)
            if system is None:
                return None
            settled = before is not None and np.array_equal(before, system.touching)
            if settled and np.abs(system.residual[self.free]).max() < _TOLERANCE:
                return self._result(load, state, iteration, system)
            before = system.touching
            try:
                step = self._factor(system)(-system.residual)
            except RuntimeError:  # exactly singular
                return None
            if not np.isfinite(step).all():
                return None
            length = 1.0
            while self.section.strain(state + length * step) is None:
                length /= 2
                if length < 1e-3:
                    return None
            state = state + length * step
        return None

    def _result(self, load: float, state: Array, iterations: int, system: _System) -> Equilibrium | None:
        try:
            solve = self._factor(system)
        except RuntimeError:
            return None
        by_load = solve(-system.by_load)
        strain = self.section.strain(state)
        if strain is None:
            return None
        stretch, stress = self.section.largest(strain)
        swept = system.volume_gradient
        volume_slope = -float(swept @ by_load)
        compliance = held = float(swept @ solve(swept))
        force_slope = indentation = contact = floor_force = 0.0
        if self.setup.load == "force":
            force_slope = 1.0
            indentation = -float(self.section.patch @ state[: self.section.size])
            held -= volume_slope**2 / float(-self.section.patch @ by_load[: self.section.size])
        for face, first, body in self._bodies(load):
            pressure = state[first : first + len(face.corners)]
            if isinstance(body, Punch):
                force_slope = system.stiffness + float(system.by_load @ by_load)
                indentation = load
                contact = float(face.corners[pressure > 0].max(initial=0.0))
                compliance += volume_slope**2 / force_slope if force_slope > 0 else 0.0
            else:
                floor_force = float(pressure @ face.area)
        return Equilibrium(
            load=load,
            state=state,
            iterations=iterations,
            force=system.force,
            volume=-system.volume,
            volume_slope=volume_slope,
            force_slope=force_slope,
            compliance=compliance,
            held_compliance=held,
            deepest=-float(state[self._middle]),
            indentation=indentation,
            contact_radius=contact,
            floor_force=floor_force,
            stretch=stretch,
            stress=stress,
        )

    def linear_answers(self) -> tuple[float, float, float]:
        """Small answers of the relaxed disc: volume per pressure, a^3 / E, and volume, a / E, and way, 1 / (E a), per
        force on the soft patch.
        """
        system = self._system(self.relaxed, 0.0)
        if system is None:
            raise Refusal("the relaxed disc has no equilibrium", kind=Kind.NO_RESULT)
        solve = self._factor(system)
        patch = np.zeros(self.size)
        patch[: self.section.size] = self.section.patch
        by_pressure, by_force = solve(self._dead), solve(patch)
        return float(self._dead @ by_pressure), float(self._dead @ by_force), float(patch @ by_force)

    # -- many loads ---------------------------------------------------------------------------------
    def path(
        self, first: float, steps: tuple[float, float], last: float, enough: Callable[[Equilibrium], bool]
    ) -> Iterator[Equilibrium]:
        """States at rising loads, until one is enough or no further one is found.

        Args:
            first: first load, above 0.
            steps: the step behind it, and the largest one.
            last: load at which the path ends.
            enough: says of a state that none behind it is wanted.
        """
        state, load, step = self.relaxed, 0.0, first
        slope: Array | None = None
        while load < last:
            tried = min(step, last - load)
            found = None if slope is None else self.solve(load + tried, state + tried * slope)
            if found is None:
                found = self.solve(load + tried, state)
            if found is None:
                step = tried / 2
                if step < _SMALLEST * max(load, steps[0]):
                    return
                continue
            slope = (found.state - state) / tried if load else None
            state, load = found.state, load + tried
            yield found
            if enough(found):
                return
            if found.iterations <= _QUICK:
                step = min(max(step, tried, steps[0] / _GROWTH) * _GROWTH, steps[1])
            growth = _PRESSURE_GROWTH * load
            if found.force_slope > 0:
                growth = _FORCE_GROWTH * found.force / found.force_slope
            step = min(step, max(growth, steps[0]))
