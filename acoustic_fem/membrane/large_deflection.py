"""Large deflections of a mounted membrane: pressed by a sphere, a flat punch or a soft patch, or bulged by a pressure.

The linear law of :mod:`acoustic_fem.membrane.disc` holds for small touches alone. A membrane that is pressed far in is
stretched and stiffens, a blunt indenter comes to stand on the rim, and the rubber reaches the floor of the cavity.
Here is the static equilibrium at finite strain (:mod:`acoustic_fem.membrane.finite_elasticity`), without friction, of
rubber with the modulus that you give and without loss.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from acoustic_fem.membrane.design_discs import design_bulge
from acoustic_fem.membrane.disc import CONTACT, DiscOptions, shape_of_disc
from acoustic_fem.membrane.equilibrium import Punching, Setup
from acoustic_fem.membrane.half_section import DiscShape
from acoustic_fem.membrane.press_table import PressTable, solved_press
from acoustic_fem.quantities.units import metres, pascals
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range, positive_numbers, real_numbers
from geometry.ground.typed import Array

SPHERES = (0.1, 50.0)
"""Smallest and largest radius of a sphere, in radii of the opening."""
#: Thinnest and thickest disc, and largest Poisson's ratio, for which the law was tried.
_THICKNESSES = (0.02, 1.0)
_LARGEST_POISSON_RATIO = 0.4999


@dataclass(frozen=True)
class MountedMembrane:
    """A flat membrane over the round opening of a cavity, without prestress."""

    radius: float
    """Radius of the opening, m."""
    thickness: float
    """Thickness, m, 0.02 to 1 radii."""
    youngs_modulus: float
    """Young's modulus at small strain, Pa: that of a slow press, as hardness and static tests give it."""
    poisson_ratio: float = 0.49
    """Poisson's ratio, 0.01 to 0.4999."""
    rim_width: float = 0.0
    """Width of the rim on which the lower face is glued, m; 0: lateral face clamped."""
    glue_width: float | None = None
    """Width of the glued annulus, m; None: the whole rim."""
    cavity_depth: float | None = None
    """Depth of the flat floor below the relaxed lower face, m; None: no floor."""

    def shape(self, contact_radius: float | None = None) -> DiscShape:
        """Dimensionless numbers of the disc; ``contact_radius`` of a soft patch in m.

        Raises:
            Refusal: a value that is not finite or out of range.
        """
        positive_numbers("radius", self.radius, "m")
        thinnest, thickest = (bound * self.radius for bound in _THICKNESSES)
        check_range("thickness", self.thickness, thinnest, thickest, "m")
        check_range("poisson_ratio", self.poisson_ratio, 0.01, _LARGEST_POISSON_RATIO)
        options = DiscOptions(glue_width=self.glue_width, contact_radius=contact_radius)
        sizes = self.radius, self.thickness, self.youngs_modulus, self.poisson_ratio, self.rim_width
        return shape_of_disc(*sizes, options)[0]

    @property
    def floor(self) -> float | None:
        """Depth of the floor by the radius of the opening, a ratio.

        Raises:
            Refusal: a depth that is not above 0.
        """
        if self.cavity_depth is None:
            return None
        positive_numbers("cavity_depth", self.cavity_depth, "m")
        return round(self.cavity_depth / self.radius, 12)


@dataclass(frozen=True)
class Sphere:
    """A rigid sphere, such as a blunt finger or the tip of a pen."""

    radius: float
    """Radius, m, 0.1 to 50 radii of the opening."""


@dataclass(frozen=True)
class FlatPunch:
    """A rigid flat punch with a round edge."""

    radius: float
    """Radius, its edge included, m, at most 0.9 radii of the opening."""
    edge_radius: float | None = None
    """Radius of the round edge, m, above 0, at most the radius; None: a quarter of it."""


@dataclass(frozen=True)
class SoftPatch:
    """A force that is spread evenly over a patch in the middle of the upper face and stays vertical.

    For small forces this is the patch of the linear law, :attr:`acoustic_fem.membrane.DiscSolution.contact_radius`.
    """

    radius: float | None = None
    """Radius of the patch on the relaxed face, m, 0.02 to 0.9 radii of the opening; None: a quarter of it."""


#: Body that presses on a membrane.
Indenter: TypeAlias = Sphere | FlatPunch | SoftPatch


@dataclass(frozen=True, eq=False)
class PressResponse:
    """A pressed membrane at some forces."""

    force: Array
    """Force on the membrane and its rim; shape of the forces, float64, N."""
    volume: Array
    """Volume displaced into the cavity; shape of the forces, float64, m^3."""
    volume_per_force: Array
    """Volume that a small further force displaces, dV/dF; shape of the forces, float64, m^3/N."""
    compliance: Array
    """Volume per small pressure in the cavity under a constant force, dV/dp; shape of the forces, float64, m^3/Pa."""
    held_compliance: Array
    """Volume per small pressure in the cavity while the indenter is held where it is; shape of the forces, float64,
    m^3/Pa. It jumps as rings of the mesh come into contact, by up to a fifth of the relaxed compliance."""
    indentation: Array
    """Depth of the indenter below the relaxed upper face, or mean displacement of the soft patch; shape of the
    forces, float64, m."""
    deepest: Array
    """Displacement of the middle of the lower face into the cavity; shape of the forces, float64, m."""
    contact_radius: Array
    """Radius, on the relaxed face, up to which a punch touches, in steps of the mesh; that of a soft patch; shape of
    the forces, float64, m."""
    floor_force: Array
    """Force on the floor of the cavity; shape of the forces, float64, N."""
    stretch: Array
    """Largest principal stretch of the rubber more than a tenth of the thickness away from the edges of the glue,
    where stress is singular; shape of the forces, float64, a ratio."""
    stress: Array
    """Largest principal Cauchy stress there; shape of the forces, float64, Pa."""


@dataclass(frozen=True, eq=False)
class BulgeResponse:
    """A membrane under static pressures."""

    pressure: Array
    """Pressure in the cavity above that outside; shape of the pressures, float64, Pa."""
    volume: Array
    """Volume swept outwards; shape of the pressures, float64, m^3."""
    compliance: Array
    """Volume per small change of that pressure, dV/dp; shape of the pressures, float64, m^3/Pa."""
    deepest: Array
    """Displacement of the middle of the lower face into the cavity, negative outwards; shape of the pressures,
    float64, m."""
    stretch: Array
    """Largest principal stretch, as :attr:`PressResponse.stretch`; shape of the pressures, float64, a ratio."""
    stress: Array
    """Largest principal Cauchy stress, as :attr:`PressResponse.stress`; shape of the pressures, float64, Pa."""


class PressCurve:
    """A membrane under one indenter at all forces that its solution covers; made by :func:`press_curve`."""

    def __init__(self, membrane: MountedMembrane, indenter: Indenter) -> None:
        self.membrane, self.indenter = membrane, indenter
        self._table = solved_press(*_setup_of(membrane, indenter))
        self._force_unit = membrane.youngs_modulus * membrane.radius**2

    @property
    def table(self) -> PressTable:
        """The solved states, dimensionless."""
        return self._table

    @cached_property
    def largest_force(self) -> float:
        """Largest force that the solution covers, N."""
        return float(self._table.rows["force"][-1] * self._force_unit)

    @property
    def end(self) -> str:
        """Why the solution goes no further, in words."""
        return self._table.end

    @cached_property
    def force_at_floor(self) -> float:
        """Force at which the membrane reaches the floor, N; infinity if it does not below the largest force."""
        rows = self._table.rows
        standing = np.flatnonzero(rows["floor_force"] > 0)
        depth = self.membrane.floor
        if len(standing) == 0 or depth is None:
            return float("inf")
        first = int(standing[0])
        if first < 2:
            return float(rows["force"][first] * self._force_unit)
        force, deepest = np.log(rows["force"][first - 2 : first]), rows["deepest"][first - 2 : first]
        slope = (deepest[1] - deepest[0]) / (force[1] - force[0])
        found = np.exp(force[1] + (depth - deepest[1]) / slope)
        return float(np.clip(found, *rows["force"][first - 1 : first + 1]) * self._force_unit)

    def response(self, force: ArrayLike) -> PressResponse:
        """Response at forces.

        Args:
            force: 0 to the largest force, any shape, N.

        Raises:
            Refusal: a force out of this range.
        """
        given = real_numbers("force", force)
        if given.size:
            check_range("force", float(given.min()), 0, unit="N")
            check_range(
                "force", float(given.max()), high=self.largest_force * (1 + 1e-12), unit="N", why=f"because {self.end}"
            )
        table, membrane = self._table, self.membrane
        scaled = np.minimum(given / self._force_unit, table.rows["force"][-1])
        size, modulus = membrane.radius, membrane.youngs_modulus
        units = {
            "volume": size**3,
            "compliance": size**3 / modulus,
            "held_compliance": size**3 / modulus,
            "indentation": size,
            "deepest": size,
            "contact_radius": size,
            "floor_force": self._force_unit,
            "stretch": 1.0,
            "stress": modulus,
        }
        values = {name: table.at_force(name, scaled) * unit for name, unit in units.items()}
        if isinstance(self.indenter, SoftPatch):
            values["contact_radius"] = np.full_like(given, self.indenter.radius or CONTACT * size)
        return PressResponse(force=given, volume_per_force=table.volume_slope(scaled) * size / modulus, **values)

    def volume_fraction(self, force: ArrayLike) -> Array:
        """Volume displaced by forces, as a fraction of that by the law of small forces; any shape, float64.

        Arguments and errors as for :meth:`response`.
        """
        response = self.response(force)
        small = float(self._table.rows["volume"][0] / self._table.rows["force"][0])
        linear = small * self.membrane.radius / self.membrane.youngs_modulus * response.force
        return np.divide(response.volume, linear, out=np.ones_like(linear), where=linear > 0)


def press_curve(membrane: MountedMembrane, indenter: Indenter) -> PressCurve:
    """The membrane under an indenter at all forces; solved once, which takes some seconds, and then kept on disk.

    Args:
        membrane: the mounted membrane.
        indenter: what presses on its middle.

    Raises:
        Refusal: proportions out of range.
    """
    return PressCurve(membrane, indenter)


def press(membrane: MountedMembrane, indenter: Indenter, force: ArrayLike) -> PressResponse:
    """Volume, compliance and strain of a membrane that is pressed, at forces in N of any shape.

    Forces from 0 to :attr:`PressCurve.largest_force` are allowed. The table of a pair of membrane and indenter is
    solved at the first call. Against a finer mesh it is good to 3e-3 in volume until the indenter squeezes the rim or
    the rubber reaches the floor, and to 2e-2 behind.

    Raises:
        Refusal: proportions or a force out of range.
    """
    return press_curve(membrane, indenter).response(force)


def bulge(membrane: MountedMembrane, pressure: ArrayLike, *, dead_load: bool = False) -> BulgeResponse:
    """Volume, compliance and strain of a membrane under a static pressure in the cavity.

    Args:
        membrane: the mounted membrane; its floor counts where the pressure draws it in.
        pressure: pressure in the cavity above that outside, of either sign, any shape, Pa.
        dead_load: True: the load stays vertical and constant per relaxed area, which no gas does, for comparison with
            programs that load so; pressure of at least 0 only, and the compliance is that of a gas.

    Raises:
        Refusal: proportions out of range, or a pressure beyond the last equilibrium that was found.
    """
    given = real_numbers("pressure", pressure)
    size, modulus, shape = membrane.radius, membrane.youngs_modulus, membrane.shape()
    units = {"volume": -(size**3), "compliance": size**3 / modulus, "deepest": size, "stretch": 1.0, "stress": modulus}
    values = {name: np.zeros(given.shape) for name in units}
    inwards = given < 0
    for side, setup in (
        (~inwards, Setup("dead pressure" if dead_load else "pressure")),
        (inwards, Setup("suction", floor=membrane.floor)),
    ):
        if not side.any():
            continue
        if dead_load and setup.load == "suction":
            check_range("pressure", float(given.min()), 0, unit="Pa", why="because of dead_load")
        table = solved_press(shape, setup)
        last = float(table.rows["load"][-1])
        why = f"because {table.end}"
        if setup.load == "suction":
            check_range("pressure", float(given.min()), low=-last * modulus, unit="Pa", why=why)
        else:
            check_range("pressure", float(given.max()), high=last * modulus, unit="Pa", why=why)
        for name, unit in units.items():
            values[name][side] = table.at_pressure(name, np.abs(given[side]) / modulus) * unit
    return BulgeResponse(pressure=given, **values)


def design_membrane(design: DesignLike) -> MountedMembrane:
    """The membrane of a design with the modulus that its material states, over the floor of its cavity.

    The floor counts as flat: under a dome it is taken where the bowl begins.

    Args:
        design: the array.

    Raises:
        Refusal: a membrane that is stretched or not flat.
    """
    design = resolve_design(design)
    floor = design_bulge(design).floor
    membrane, radius = design.membrane, metres(design.resonator.cavity_diameter) / 2
    material = design.material(membrane.material)
    return MountedMembrane(
        radius=radius,
        thickness=metres(membrane.thickness),
        youngs_modulus=pascals(material.youngs_modulus),
        poisson_ratio=material.poisson_ratio,
        rim_width=0.0 if membrane.mounting == "clamped" else metres(membrane.rim_width),
        cavity_depth=None if floor is None else floor * radius,
    )


def _setup_of(membrane: MountedMembrane, indenter: Indenter) -> tuple[DiscShape, Setup]:
    size, floor = membrane.radius, membrane.floor
    if isinstance(indenter, SoftPatch):
        return membrane.shape(indenter.radius), Setup("force", None, floor)
    shape = membrane.shape()
    if isinstance(indenter, Sphere):
        smallest, largest = (bound * size for bound in SPHERES)
        check_range("indenter.radius", indenter.radius, smallest, largest, "m")
        return shape, Setup("depth", Punching(0.0, round(indenter.radius / size, 12)), floor)
    check_range("indenter.radius", indenter.radius, 0.05 * size, 0.9 * size, "m")
    edge = indenter.radius / 4 if indenter.edge_radius is None else indenter.edge_radius
    check_range("indenter.edge_radius", edge, 0.05 * indenter.radius, indenter.radius, "m")
    flat, edge = round((indenter.radius - edge) / size, 12), round(edge / size, 12)
    return shape, Setup("depth", Punching(flat, edge), floor)
