"""Footprints: signals at the microphones from a contact of given radius at any place of the surface.

A contact presses all membranes that it covers, each with its fraction of the force. The array is linear, so the signals
of the contact are the sum of the force responses of these membranes. Places at which the fractions have equal ratios
cannot be distinguished by one frame, and have one footprint: for example, all places from which a contact reaches one
membrane alone.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from localize.contacts.contact import RADII, Contact, covered_force
from localize.signals.array_response import ArrayResponse
from localize.signals.stimulus import BAND
from localize.tracking.tracking_options import FootprintOptions


@dataclass(frozen=True, eq=False)
class Footprints:
    """Footprints of one contact on a square grid of places."""

    place: Array
    """Places from which the contact reaches a membrane; (n_place, 2) float64, mm."""
    node: NDArray[np.int64]
    """Row and column of each place in the grid; (n_place, 2) int64."""
    footprint: NDArray[np.int64]
    """Footprint of each place; (n_place,) int64."""
    fraction: Array
    """Fractions of the force on the membranes, of Euclidean norm 1; (n_footprint, n_point) float64."""
    step: float
    """Distance of two neighbours of the grid, mm."""


def pitch_of(response: ArrayResponse) -> float:
    """Distance of a point to its nearest neighbour, the median over the points, mm.

    Args:
        response: of a library with a design.
    """
    assert response.position is not None
    apart = np.linalg.norm(response.position[:, None] - response.position, axis=-1)
    return float(np.median((apart + np.diag(np.full(len(apart), np.inf))).min(1)))


def fractions_at(response: ArrayResponse, contact_radius_mm: float, place: Array) -> Array:
    """Share of the force of a contact that each membrane takes.

    Args:
        response: of a library with a design.
        contact_radius_mm: radius of the contact, mm.
        place: its middles, (n, 2) float64, mm.

    Returns:
        (n, n_point) float64.

    Raises:
        Refusal: bare transfer functions, or a radius out of range.
    """
    twice = np.concatenate([place, place[-1:]])  # a contact has two times at least
    still = Contact(np.arange(len(twice), dtype=np.float64), twice, np.ones(len(twice)), contact_radius_mm)
    return covered_force(still, response)[:-1]


def footprints_over(
    response: ArrayResponse, contact_radius_mm: float, most: int, options: FootprintOptions = FootprintOptions()
) -> Footprints:
    """Footprints all over an array, as finely as their number allows.

    Args:
        response: of a library with a design.
        contact_radius_mm: radius of the contact, mm.
        most: number of footprints at most, unless the points are more.
        options: of the grid.

    Raises:
        Refusal: bare transfer functions, or a radius out of range.
    """
    check_range("contact_radius_mm", contact_radius_mm, *RADII, "mm")
    step = options.grid_step * _checked(response)
    while True:
        found = _footprints(response, contact_radius_mm, step, options.alike)
        if len(found.fraction) <= max(most, response.point_count) or step >= pitch_of(response):
            return found
        step *= 1.25


def footprint_response(
    response: ArrayResponse, share: Array, top: float = FootprintOptions.top_frequency
) -> ArrayResponse:
    """Footprints in place of the points of an array: pressure at the microphones over that which their force makes in
    a cavity of the mean point.

    Args:
        response: of a library with a design.
        share: shares of each footprint on the membranes, at least two footprints; (n, n_point) float64.
        top: frequency up to which it is made, Hz.
    """
    force = response.force_response
    assert force is not None
    # The frequency above the top is kept: between the two values are interpolated.
    kept = slice(0, int(np.searchsorted(response.frequency, max(top, BAND[1]))) + 1)
    summed = np.einsum("np,pmf->nmf", share, force[..., kept]) / pressure_of_force(response)[kept]
    return replace(
        response,
        transfer_function=summed,
        frequency=response.frequency[kept],
        line=np.zeros(len(share), np.int64),
        place=np.arange(len(share)),
        ambient_response=None,
        vent_ratio=None,
        cavity_response=None,
        position=None,
        membrane_radius=None,
        sealed=False,
        closed_form=None,
    )


def pressure_of_force(response: ArrayResponse) -> Array:
    """Pressure in a cavity per force on its membrane, the mean over the points; (n_freq,) float64, Pa/N."""
    assert response.cavity_response is not None
    return np.asarray(np.abs(response.cavity_response).mean(0))


def _checked(response: ArrayResponse) -> float:
    """The pitch of an array that knows what its points are.

    Raises:
        Refusal: bare transfer functions.
    """
    if response.position is None or response.cavity_response is None:
        raise Refusal(
            f"{response.name}: bare transfer functions have no positions of points",
            kind=Kind.MISMATCH,
            remedy="track contacts with a library that has a design",
        )
    return pitch_of(response)


def _footprints(response: ArrayResponse, contact_radius_mm: float, step: float, alike: float) -> Footprints:
    assert response.position is not None
    assert response.membrane_radius is not None
    # A finger beyond the outermost points by more than half a pitch is not on the array.
    margin = min(contact_radius_mm + float(response.membrane_radius.max()), pitch_of(response) / 2)
    least, most = response.position.min(0) - margin, response.position.max(0) + margin
    # Points lie in the grid wherever they themselves lie on one.
    below = np.floor(margin / step)
    axes = [
        first + margin - below * step + step * np.arange(int((last - first) / step) + 1)
        for first, last in zip(least, most, strict=True)
    ]
    node = np.stack(np.meshgrid(*(np.arange(len(axis)) for axis in axes), indexing="ij"), -1).reshape(-1, 2)
    place = np.column_stack([axis[node[:, k]] for k, axis in enumerate(axes)])
    share = fractions_at(response, contact_radius_mm, place)
    covered = share.sum(1) > 0
    share = share[covered] / np.linalg.norm(share[covered], axis=1, keepdims=True)
    _, first, footprint = np.unique(np.round(share / alike), axis=0, return_index=True, return_inverse=True)
    return Footprints(place[covered], node[covered], footprint.reshape(-1), share[first], step)
