"""The pressure at the microphones after a touch of given kind."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, replace
from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

import acoustic_fem
from geometry.design.array_design import ArrayDesign
from geometry.ground.argument_checks import check_choice
from geometry.ground.typed import Array, ComplexArray

if TYPE_CHECKING:
    from acoustic_fem.membrane.disc import DiscResponse

#: Quantities that measure a touch, and their units.
TOUCHES = {"displacement": "m", "force": "N", "pressure": "Pa"}


def touch_response(
    design: ArrayDesign,
    source_response: xr.DataArray,
    point_impedance: xr.DataArray,
    touch: str,
    *,
    contact_radius: float | None = None,
) -> xr.DataArray:
    """Pressure at the microphones per touch of each membrane.

    A force F on the patch in the middle of the membrane injects j w V F, with V the volume per force in vacuo;
    a pressure on the upper face j w times its volume per pressure. The patch moves by
    (D - j w V^2 Z) F, with D its displacement per force in vacuo and Z the point impedance: the air in
    the cavity pushes back. A displacement is that of the patch, on average.

    Args:
        design: the array, for its membranes.
        source_response: (point, microphone, frequency) complex128, as in :class:`acoustic_fem.Library`.
        point_impedance: (point, frequency) complex128, as there.
        touch: "displacement" (m), "force" (N) or "pressure" (Pa).
        contact_radius: of the patch, m, as for :func:`acoustic_fem.membrane.disc.solve_disc`.

    Returns:
        (point, microphone, frequency) complex128, Pa per unit of the touch.

    Raises:
        Refusal: an unknown touch, or a contact radius out of range.
    """
    source = source_response.transpose("point", "microphone", "frequency")
    injected = touch_flow(design, point_impedance, touch, contact_radius)
    return (
        source.copy(data=source.values * injected[:, None])
        .assign_attrs(
            {"units": f"Pa/{TOUCHES[touch]}", "long_name": f"pressure at the microphone per {touch} of the touch"}
        )
        .rename(f"response_to_{touch}")
    )


def touch_flow(
    design: ArrayDesign, point_impedance: xr.DataArray, touch: str, contact_radius: float | None = None
) -> ComplexArray:
    """Volume velocity that a touch of each membrane injects into its cavity; arguments as :func:`touch_response`.

    Returns:
        (n_point, n_freq) complex128, m^3/s per unit of the touch.

    Raises:
        Refusal: an unknown touch, or a contact radius out of range.
    """
    # The face loads finite elements when they are first used: a library is read and looked at without them.
    check_choice("touch", touch, tuple(TOUCHES))
    grid = np.asarray(point_impedance["frequency"].values)
    rubber = acoustic_fem.membrane.design_rubber(design)
    vacuum = membranes_in_vacuo(
        design,
        lambda alike: acoustic_fem.membrane.design_disc(alike, contact_radius=contact_radius).response(grid, rubber),
    )
    return injected_flow(touch, grid, vacuum, point_impedance.transpose("point", "frequency").values)


def membranes_in_vacuo(design: ArrayDesign, response_of: Callable[[ArrayDesign], DiscResponse]) -> DiscResponse:
    """Response of the membrane of each point in vacuo.

    Args:
        design: the array.
        response_of: gives the response, arrays (n_freq,), of the membranes of a design whose points are alike.

    Returns:
        Arrays (n_point, n_freq) complex128.
    """
    own = [response_of(design.of_kind(kind)) for kind in design.kinds]
    of_points = list(design.kind_of_point)
    return replace(
        own[0], **{each.name: np.stack([getattr(one, each.name) for one in own])[of_points] for each in fields(own[0])}
    )


def injected_flow(touch: str, frequency: Array, vacuum: DiscResponse, point_impedance: ComplexArray) -> ComplexArray:
    """Volume velocity that a touch injects into the cavity of each point.

    Args:
        touch: one of :data:`TOUCHES`.
        frequency: (n_freq,) float64, Hz.
        vacuum: what the membranes do in vacuo, arrays (..., n_point, n_freq) complex128.
        point_impedance: (..., n_point, n_freq) complex128, Pa s/m^3; the air pushes back where a displacement is given.

    Returns:
        (..., n_point, n_freq) complex128, m^3/s per unit of the touch.
    """
    omega = 2j * np.pi * frequency
    if touch == "pressure":
        return np.asarray(omega * vacuum.volume_per_pressure)
    per_force = omega * vacuum.volume_per_force
    if touch == "force":
        return np.asarray(per_force)
    pushed_back = omega * vacuum.volume_per_force**2 * point_impedance
    return np.asarray(per_force / (vacuum.displacement_per_force - pushed_back))
