"""A contact that moves over an array, and the force that each membrane takes of it.

A round contact of radius a presses as Hertz says of two curved bodies, p = 3 F / (2 pi a^2) sqrt(1 - (r / a)^2)
(Johnson, Contact Mechanics (1985), section 4.2); a membrane takes what lies over its opening, the shell around it the
rest. Where the force lies on a membrane does not count: it goes in on the patch of
:attr:`acoustic_fem.Library.force_response`, which is an assumption of ours. Spread evenly over a whole membrane it
would move 0.41 to 0.45 of the air.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from acoustic_fem import Library
from geometry.ground.argument_checks import check_range, real_numbers
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.signals.array_response import ArrayResponse, response_of
from localize.signals.random_streams import Purpose, random_words, uniform

RADII = (0.05, 100.0)
"""Smallest and largest radius of a contact, mm."""
GRAIN = (0.25, 4.0)
"""Shortest and longest wave of a rough contact along its path, mm: about half and eight times the ridges of a finger,
which lie 0.4 to 0.5 mm apart; ours."""
CREEP = 5.0
"""Speed at which a rough contact fluctuates half as much as a fast one, mm/s; one that stands still does not."""
_WAVES = 48
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(24)


@dataclass(frozen=True, eq=False)
class Contact:
    """Contact that moves over an array. Before its first time and after its last time it does not press.

    Between its times, position and force are interpolated linearly.

    Raises:
        Refusal: times that do not ascend, shapes that do not fit them, values that are not finite or out of range.
    """

    time: Array
    """Times, ascending, at least two; (n,) float64, s."""
    path: Array
    """Middle of the contact in the plan of :attr:`localize.ArrayResponse.position`; (n, 2) float64, mm."""
    force: Array
    """Force on the array, zero or above; (n,) float64, N."""
    contact_radius_mm: float
    """Radius of the contact's area, mm."""
    roughness: float = 0.0
    """Fluctuation of the force while it moves, rms as a share of the force, 0 to 2: noise along the path, whose
    frequencies rise with the speed."""
    label: str = ""
    """Kind of contact, such as ``tap``."""

    def __post_init__(self) -> None:
        for name in ("time", "path", "force"):
            values = real_numbers(f"contact.{name}", getattr(self, name))
            if not np.isfinite(values).all():
                raise Refusal("must be finite", kind=Kind.UNSUITABLE, field=f"contact.{name}")
            object.__setattr__(self, name, values)
        count = len(self.time) if self.time.ndim else 0
        if self.time.ndim != 1 or count < 2 or np.any(np.diff(self.time) <= 0):
            raise Refusal(
                f"has shape {self.time.shape}; it must be at least 2 ascending times, s",
                kind=Kind.WRONG_TYPE,
                field="contact.time",
            )
        for name, expected in (("path", (count, 2)), ("force", (count,))):
            shape = getattr(self, name).shape
            if shape != expected:
                raise Refusal(
                    f"has shape {shape}, must be {expected}, one row for each time",
                    kind=Kind.WRONG_TYPE,
                    field=f"contact.{name}",
                )
        check_range("contact.force", float(self.force.min()), 0, unit="N", why="because a contact does not pull")
        check_range("contact.contact_radius_mm", self.contact_radius_mm, *RADII, "mm")
        check_range("contact.roughness", self.roughness, 0.0, 2.0)

    @property
    def seconds(self) -> float:
        """Length, s."""
        return float(self.time[-1] - self.time[0])

    def at(self, time: Array) -> Contact:
        """The same contact at other times.

        Args:
            time: (m,) float64, ascending, s.
        """
        path = np.column_stack([np.interp(time, self.time, along) for along in self.path.T])
        # Rounding must not put the last time outside.
        inside = (time >= self.time[0] - 1e-9) & (time <= self.time[-1] + 1e-9)
        force = np.where(inside, np.interp(time, self.time, self.force), 0.0)
        return replace(self, time=np.asarray(time, np.float64), path=path, force=force)

    def roughened(self, seed: int, purpose: Purpose = "evaluation", sample: int = 0) -> Contact:
        """The contact with its roughness drawn into its force, at its own times: they must be those of the samples.

        Waves that are too fast for the times are left out.

        Args:
            seed: any non-negative integer.
            purpose: streams of different purposes never share a number.
            sample: index of the contact in the stream.
        """
        if self.roughness == 0:
            return self
        drawn = uniform(random_words(seed, purpose, "roughness", sample, 1, _WAVES))[0].numpy().astype(np.float64)
        number = np.exp(np.log(1 / GRAIN[1]) + np.log(GRAIN[1] / GRAIN[0]) * drawn[:, 0])  # per mm
        step = np.hypot(*np.diff(self.path, axis=0).T)
        along = np.concatenate([[0.0], np.cumsum(step)])
        speed = np.gradient(along, self.time)
        waves = np.cos(2 * np.pi * (np.outer(along, number) + drawn[:, 1]))
        waves[np.outer(speed, number) > 0.4 / np.gradient(self.time)[:, None]] = 0.0
        noise = waves.sum(axis=1) * np.sqrt(2 / _WAVES) * speed / (speed + CREEP)
        return replace(self, force=self.force * np.maximum(1 + self.roughness * noise, 0.0), roughness=0.0)


def covered_force(contact: Contact, array: Library | ArrayResponse) -> Array:
    """Force on each membrane over time: its share of the Hertz pressure of the contact.

    Args:
        contact: what presses; its roughness is not drawn, see :meth:`Contact.roughened`.
        array: a library, or a response that knows where its membranes are.

    Returns:
        (n, n_point) float64, N, at the times of the contact.

    Raises:
        Refusal: an array without positions: bare transfer functions.
    """
    place, radius = surface_of(array)
    shares = np.zeros((len(contact.time), len(place)))
    pressing = np.flatnonzero(contact.force)
    distance = np.linalg.norm(contact.path[pressing, None] - place, axis=-1)
    for size in np.unique(radius):
        rows, columns = np.nonzero((distance < contact.contact_radius_mm + size) & (radius == size))
        shares[pressing[rows], columns] = hertz_fraction(
            distance[rows, columns], contact.contact_radius_mm, float(size)
        )
    return shares * contact.force[:, None]


def surface_of(array: Library | ArrayResponse) -> tuple[Array, Array]:
    """Places and radii of the membranes of an array.

    Returns:
        Their middles, (n_point, 2) float64, mm, and radii, (n_point,) float64, mm.

    Raises:
        Refusal: an array that does not know it.
    """
    response = response_of(array)
    if response.position is None or response.membrane_radius is None:
        raise Refusal(
            f"{response.name}: bare transfer functions have no positions of membranes",
            kind=Kind.MISMATCH,
            remedy="take a library that has a design",
        )
    return response.position, response.membrane_radius


def hertz_fraction(distance: Array, contact: float, membrane: float) -> Array:
    """Share of the force of a round contact that lies over a round membrane.

    With u = sqrt(1 - (r / a)^2) the share of a ring is 3 u^2 du times the share of it inside the membrane's edge. The
    whole rings are summed in closed form, the cut ones by Gauss's rule over an angle that takes away the roots at
    both ends: good to 1e-9.

    Args:
        distance: between their middles, (n,) float64 or any other shape, mm.
        contact: radius of the contact's area, mm.
        membrane: radius of the membrane, mm.

    Returns:
        Same shape as the distances, float64, 0 to 1.
    """
    near = np.abs(membrane - distance)
    low, high = np.minimum(near, contact), np.minimum(distance + membrane, contact)
    whole = np.where(distance < membrane, 1 - (1 - (low / contact) ** 2) ** 1.5, 0.0)
    angle = np.pi / 2 * _NODES
    half = (high - low)[..., None] / 2
    ring = (high + low)[..., None] / 2 + half * np.sin(angle)
    away = distance[..., None]
    reach = np.divide(
        ring**2 + away**2 - membrane**2, 2 * ring * away, out=np.ones_like(ring), where=2 * ring * away > 0
    )
    inside = np.arccos(np.clip(reach, -1.0, 1.0)) / np.pi
    # 3 u^2 du = 3 u r dr / a^2, and dr = half cos(angle) d angle.
    density = 3 * np.sqrt(np.maximum(1 - (ring / contact) ** 2, 0.0)) * ring / contact**2
    cut = (density * inside * half * np.cos(angle)) @ _WEIGHTS * np.pi / 2
    return np.asarray(np.clip(whole + cut, 0.0, 1.0))
