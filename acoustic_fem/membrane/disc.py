"""The silicone disc over a cavity: compliance, modes, and what a touch does, by elastic finite elements."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from acoustic_fem.membrane.elasticity import ElasticDisc
from acoustic_fem.membrane.half_section import DiscShape
from acoustic_fem.membrane.rubber import ELASTIC, Rubber
from acoustic_fem.membrane.solved_discs import solved_disc
from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from geometry.ground.argument_checks import check_range, positive_numbers
from geometry.ground.caller_warnings import warn_caller
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array, ComplexArray

#: Radius of the contact patch per radius of the opening, where none is given.
CONTACT = 0.25

#: Largest stress in the plane of the disc per modulus, and the stretch that makes nearly as much of it.
_LARGEST_PRESTRESS = 20.0
_LARGEST_STRETCH = 1.9

THICKNESS_BY_RADIUS = (0.01, 2.0)
"""Thinnest and thickest disc that is solved, as a fraction of the radius of its opening."""
#: Limits stated in millimetres are kept after conversion.
_LESS, _MORE = 1 - 1e-9, 1 + 1e-9


class KnownDiscs(Protocol):
    """Discs that need not be solved, such as :class:`acoustic_fem.membrane.disc_table.DiscTables`."""

    def find(self, shape: DiscShape) -> ElasticDisc | None:
        """Disc of a shape, None where it is not known."""


@dataclass(frozen=True)
class DiscOptions:
    """Options of a disc beyond those of :func:`disc_compliance`: glue, pre-stretch, a patch, a raised part."""

    glue_width: float | None = None
    """Width of the glued annulus, from the edge of the opening outwards, m, at least 0.05 thicknesses; None: the whole
    rim. Beyond it the disc lies free."""
    tension: float = 0.0
    """Force per length in the plane, the same in all directions, N/m; at most 20 thickness x youngs_modulus."""
    stretch: float = 1.0
    """Ratio of lengths in the plane, stretched to relaxed, 1 to 1.9; not beside a tension."""
    contact_radius: float | None = None
    """Radius of the patch in the middle of the upper face that takes a force as uniform pressure, m, 0.02 to 0.9 radii;
    None: a quarter of the radius, or the whole boss."""
    rim_height: float = 0.0
    """Height by which the disc is thicker all along its rim, on the upper face, m, at most 2 radii; needs a rim_width,
    and neither tension nor stretch: the stress of such a disc is not uniform."""
    boss_radius: float = 0.0
    """Radius of a boss in the middle of the upper face, m, 0.1 to 0.9 radii, at least contact_radius; instead of a
    rim_height, and without tension and stretch."""
    boss_height: float = 0.0
    """Height of the boss above that face, m, above 0, at most 2 radii."""


#: A disc that is glued over its whole rim, flat, not stretched, and touched on a quarter of its radius.
_PLAIN = DiscOptions()


@dataclass(frozen=True, eq=False)
class DiscModes:
    """Axisymmetric modes in vacuo, undamped; amplitudes are the largest deflection of the lower face."""

    frequency: Array
    """Frequencies, (n,) float64, ascending, Hz."""
    mass: Array
    """Modal masses, (n,) float64, kg."""
    swept_area: Array
    """Participation in volume velocity, (n,) float64, m^2: volume that the lower face sweeps over the opening per
    amplitude; not negative.
    """
    elastic_share: Array
    """Share of the modal stiffness that is elastic and carries the loss, (n,) float64; the rest is pre-stress.
    """
    shape: Array
    """Coupling shapes, (n, n_radius) float64: deflection of the lower face at the radii of :attr:`DiscSolution.radius`;
    largest magnitude 1, outwards where it sweeps volume.
    """


@dataclass(frozen=True, eq=False)
class DiscResponse:
    """Responses of a disc in vacuo at some frequencies."""

    compliance: ComplexArray
    """Volume swept by the lower face per pressure on it, m^3/Pa; shape of the frequencies, complex128."""
    volume_per_force: ComplexArray
    """Volume swept into the cavity per force on the contact patch, m^3/N; by reciprocity also the mean displacement of
    the patch per pressure in the cavity, m/Pa; shape of the frequencies, complex128.
    """
    displacement_per_force: ComplexArray
    """Mean displacement of the patch per force on it, m/N; shape of the frequencies, complex128."""
    volume_per_pressure: ComplexArray
    """Volume swept into the cavity per pressure on the upper face, m^3/Pa; shape of the frequencies, complex128."""


@dataclass(frozen=True, eq=False)
class DiscSolution:
    """Linear elastic behaviour of a disc in vacuo."""

    static_compliance: float
    """Volume swept by the lower face over the opening per static pressure on it, m^3/Pa."""
    first_frequency: float
    """Frequency of the first axisymmetric mode, Hz."""
    modal_mass: float
    """Acoustic mass of that mode, scaled to sweep unit volume, kg/m^4."""
    radius: Array
    """Radii over the opening, (n_radius,) float64, m."""
    deflection: Array
    """Static displacement of the lower face per pressure on it, (n_radius,) float64, outwards, m/Pa."""
    modes: DiscModes
    """The first axisymmetric modes."""
    contact_radius: float
    """Radius of the patch in the middle of the upper face that takes a force, m."""
    volume_per_force: float
    """Static volume swept into the cavity per force on the patch, m^3/N."""
    displacement_per_force: float
    """Static mean displacement of the patch per force on it, the local indentation under a uniform pressure included,
    m/N.
    """
    opening: float
    """Radius of the opening, m."""
    modulus: float
    """Young's modulus of the mounted disc as it is stated, Pa; of a bulged one, that which small signals meet."""
    density: float
    """Density, kg/m^3."""
    model: ElasticDisc
    """The dimensionless dynamic model."""

    def response(self, frequency: FrequencyLike, rubber: Rubber = ELASTIC) -> DiscResponse:
        """Responses to pressures and to a force on the patch as sums over modes with static correction.

        The stiffness is the complex modulus, by the stated one, times its elastic part plus that of the pre-stress,
        which has no loss, projected on the modes and on the static answers to pressure and force (mode acceleration;
        Craig, Structural Dynamics (1981), chapter 15): statics are exact, and at any frequency a passive system
        remains. Valid below half the highest mode that is kept; above that it warns.

        Args:
            frequency: Hz, any shape.
            rubber: law of the modulus over frequency; by default there is no loss.

        Raises:
            Refusal: a frequency that is not finite and positive.
        """
        frequency = frequencies(frequency)
        if frequency.size and frequency.max() > self.modes.frequency[-1] / 2:
            warn_caller(
                f"membrane: {frequency.max():.4g} Hz is above half of the highest mode that is kept "
                f"({self.modes.frequency[-1]:.4g} Hz in vacuo)",
            )
        model = self.model
        square = (2 * np.pi * frequency * self.opening) ** 2 * self.density / self.modulus
        total = np.diag(model.eigenvalues)
        more = rubber.ratio(frequency)[..., None, None] - 1
        system = total + more * (total - model.geometric) - square[..., None, None] * np.eye(len(total))
        loads = np.stack([model.swept, model.patch, model.swept_above], axis=-1)
        shape = (*square.shape, *loads.shape)
        answer = np.asarray(loads.T @ np.linalg.solve(system, np.broadcast_to(loads, shape)), dtype=np.complex128)
        volume = self.opening**3 / self.modulus
        return DiscResponse(
            compliance=answer[..., 0, 0] * volume,
            volume_per_force=answer[..., 0, 1] * self.opening / self.modulus,
            displacement_per_force=answer[..., 1, 1] / (self.opening * self.modulus),
            volume_per_pressure=answer[..., 0, 2] * volume,
        )

    def compliance(self, frequency: FrequencyLike, rubber: Rubber = ELASTIC) -> ComplexArray:
        """Volume compliance C(w) at frequencies in Hz; arguments, validity and errors as :meth:`response`.

        Returns:
            Shape of frequency, complex128, m^3/Pa.
        """
        return self.response(frequency, rubber).compliance


def solve_disc(
    radius: float,
    thickness: float,
    youngs_modulus: float,
    poisson_ratio: float = 0.49,
    rim_width: float = 0.0,
    density: float = 1070.0,
    options: DiscOptions = _PLAIN,
    known: KnownDiscs | None = None,
) -> DiscSolution:
    """Axisymmetric mixed elasticity (Q2-Q1) of a disc under pressure and under a force in its middle.

    Small displacements about the mounted state. Errors up to a thickness of half a radius: 5e-4 in compliance,
    frequency and volume per force, 6e-4 in indentation. An independent program found 4.3e-4 of the compliance at a rim
    and a thickness of a third of a radius. Thicker discs: 2e-3, of which that program found 1.1e-3 to 1.8e-3 at a
    thickness of two radii and a rim of a twentieth; Poisson's ratios above 0.4999: 1e-3. A clamped lateral face is
    stiffer than a glued rim: at a = 3 mm, h = 0.5 mm the rim is 36 % softer.

    A pre-stretched disc is stretched alike in all directions of its plane and then mounted; its stress is
    taken as uniform, the rim included (a free edge nearer than two thicknesses relaxes it in part). Under a
    tension T the stress T / h adds its geometric stiffness and the modulus is that of the disc as it is.
    A stretch starts from the relaxed sheet, neo-Hookean: thickness h / s^2, stress E (s^2 - s^-4) / 3 and
    modulus E s^-4, which is exact for incompressible rubber (Ogden, Non-Linear Elastic Deformations (1984),
    chapter 6).

    Args:
        radius: of the opening, m.
        thickness: m, 0.01 to 2 radii; with a stretch that of the relaxed sheet.
        youngs_modulus: Pa; with a stretch that of the relaxed sheet.
        poisson_ratio: a ratio, 0.01 to 0.49999.
        rim_width: 0: lateral face clamped; above 0: disc of radius + rim_width, glued on its lower face
            along the rim, other faces free; m, at least 0.05 thicknesses and at most 50 radii.
        density: kg/m^3.
        options: glue, pre-stretch, patch of the touch, raised part.
        known: discs that need not be solved.

    Raises:
        Refusal: a value that is not finite or out of range.
    """
    positive_numbers("density", density, "kg/m^3")
    shape, modulus = shape_of_disc(radius, thickness, youngs_modulus, poisson_ratio, rim_width, options)
    # The table of discs has flat ones only.
    found = known.find(shape) if known is not None and shape.raised is None else None
    return _in_si(found or solved_disc(shape), shape.contact, float(radius), modulus, float(density))


def shape_of_disc(
    radius: float,
    thickness: float,
    youngs_modulus: float,
    poisson_ratio: float = 0.49,
    rim_width: float = 0.0,
    options: DiscOptions = _PLAIN,
) -> tuple[DiscShape, float]:
    """Dimensionless numbers of a mounted disc on which its solution depends, and its modulus, Pa.

    Arguments and errors as for :func:`solve_disc`.
    """
    stretch, tension = options.stretch, options.tension
    positive_numbers("radius", radius, "m")
    positive_numbers("youngs_modulus", youngs_modulus, "Pa")
    check_range("stretch", stretch, 1, _LARGEST_STRETCH)
    if stretch != 1:
        check_range("thickness", thickness, THICKNESS_BY_RADIUS[0] * radius * _LESS, np.inf, "m")
        tension = thickness * youngs_modulus * (1 - stretch**-6) / 3
        thickness, youngs_modulus = thickness / stretch**2, youngs_modulus / stretch**4
    low, high = (limit * radius for limit in THICKNESS_BY_RADIUS)
    check_range("thickness", thickness, low * _LESS, high * _MORE, "m")
    check_range("poisson_ratio", poisson_ratio, 0.01, 0.49999)
    check_range("tension", tension, 0, _LARGEST_PRESTRESS * thickness * youngs_modulus, "N/m")
    check_range("rim_height", options.rim_height, 0, 2 * radius, "m")
    check_range("boss_height", options.boss_height, 0, 2 * radius, "m")
    if options.boss_height and options.boss_radius:
        check_range("boss_radius", options.boss_radius, 0.1 * radius * _LESS, 0.9 * radius * _MORE, "m")
    glue = 0.0
    if rim_width != 0:
        check_range("rim_width", rim_width, 0.05 * thickness * _LESS, 50 * radius * _MORE, "m")
        glue = rim_width if options.glue_width is None else options.glue_width
        check_range("glue_width", glue, 0.05 * thickness, rim_width, "m")
    contact = (options.boss_radius or CONTACT * radius) if options.contact_radius is None else options.contact_radius
    check_range("contact_radius", contact, 0.02 * radius, (options.boss_radius or 0.9 * radius) * _MORE, "m")
    contact = min(contact, options.boss_radius or contact)
    _check_together(options, rim_width)
    # rounding lets equal discs in different units share one solution
    lengths = (thickness, rim_width, glue, contact)
    depth, rim, held, patch = (round(float(length) / radius, 12) for length in lengths)
    prestress = round(tension / (depth * radius * youngs_modulus), 12)
    raised = None
    if options.rim_height:
        raised = 1.0, 1.0 + rim, round(float(options.rim_height) / radius, 12)
    elif options.boss_height:
        raised = 0.0, round(float(options.boss_radius) / radius, 12), round(float(options.boss_height) / radius, 12)
    return DiscShape(depth, float(poisson_ratio), rim, held, prestress, patch, raised), float(youngs_modulus)


def _check_together(options: DiscOptions, rim_width: float) -> None:
    """Refuse options that exclude or need each other."""
    raised = "rim_height" if options.rim_height else "boss_height" if options.boss_height else ""
    if options.stretch != 1 and options.tension != 0:
        problem, remedy = f"must not be given beside tension = {options.tension:g} N/m", "give one of the two"
        raise Refusal(problem, kind=Kind.CONFLICT, field="stretch", value=options.stretch, remedy=remedy)
    if options.rim_height and options.boss_height:
        problem = f"must not be given beside rim_height = {options.rim_height:g} m"
        raise Refusal(problem, kind=Kind.CONFLICT, field="boss_height", value=options.boss_height, unit="m")
    if bool(options.boss_radius) != bool(options.boss_height):
        problem = f"and boss_height = {options.boss_height:g} m must be given together"
        raise Refusal(problem, kind=Kind.CONFLICT, field="boss_radius", value=options.boss_radius, unit="m")
    for name, value in (("glue_width", options.glue_width), ("rim_height", options.rim_height or None)):
        if rim_width == 0 and value is not None:
            problem = "needs a rim: rim_width = 0 clamps the lateral face"
            raise Refusal(problem, kind=Kind.CONFLICT, field=name, value=value, unit="m")
    if raised and (options.stretch != 1 or options.tension != 0):
        problem = "must be 0 under a tension or a stretch: only a flat disc is stretched evenly"
        raise Refusal(problem, kind=Kind.CONFLICT, field=raised, value=getattr(options, raised), unit="m")


def _in_si(disc: ElasticDisc, contact: float, radius: float, modulus: float, density: float) -> DiscSolution:
    """The dimensionless solution in metres, pascals and kilograms."""
    true = slice(disc.modes)
    amplitude = np.abs(disc.shapes[true]).max(axis=1)
    frequency = np.sqrt(disc.eigenvalues[true] * modulus / density) / (2 * np.pi * radius)
    modes = DiscModes(
        frequency=frequency,
        mass=density * radius**3 / amplitude**2,
        swept_area=disc.swept[true] / amplitude * radius**2,
        elastic_share=1 - np.diag(disc.geometric)[true] / disc.eigenvalues[true],
        shape=disc.shapes[true] / amplitude[:, None],
    )
    return DiscSolution(
        static_compliance=disc.compliance * radius**3 / modulus,
        first_frequency=float(frequency[0]),
        modal_mass=density / (radius * float(disc.swept[0]) ** 2),
        radius=disc.radius * radius,
        deflection=disc.deflection * radius / modulus,
        modes=modes,
        contact_radius=contact * radius,
        volume_per_force=disc.volume_per_force * radius / modulus,
        displacement_per_force=disc.displacement_per_force / (modulus * radius),
        opening=radius,
        modulus=modulus,
        density=density,
        model=disc,
    )


def disc_compliance(
    radius: float, thickness: float, youngs_modulus: float, poisson_ratio: float = 0.49, rim_width: float = 0.0
) -> float:
    """Static volume compliance of a disc, m^3/Pa; arguments and errors as :func:`solve_disc`.

    Args:
        radius: of the opening, m.
        thickness: m.
        youngs_modulus: Pa.
        poisson_ratio: a ratio.
        rim_width: m; 0: clamped.
    """
    return solve_disc(radius, thickness, youngs_modulus, poisson_ratio, rim_width).static_compliance
