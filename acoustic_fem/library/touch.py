"""The pressure at the microphones after a touch of given kind."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from geometry.design.array_design import ArrayDesign
from geometry.refusal import Refusal

if TYPE_CHECKING:
    from acoustic_fem.membrane.disc import DiscResponse

#: What a touch is measured by, and its unit.
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
        design: the array, for its membrane.
        source_response: (point, microphone, frequency) complex128, as in :class:`acoustic_fem.Library`.
        point_impedance: (point, frequency) complex128, as there.
        touch: "displacement" (m), "force" (N) or "pressure" (Pa).
        contact_radius: of the patch, m, as for :func:`acoustic_fem.membrane.disc.solve_disc`.

    Returns:
        (point, microphone, frequency) complex128, Pa per unit of the touch.

    Raises:
        Refusal: an unknown touch, or a contact radius out of range.
    """
    # Here, so that a library can be read and looked at without the finite elements.
    from acoustic_fem.membrane.disc import design_disc, design_rubber

    if touch not in TOUCHES:
        raise Refusal(f"touch = {touch!r} must be one of: {', '.join(TOUCHES)}")
    grid = np.asarray(source_response["frequency"].values)
    disc = design_disc(design, contact_radius=contact_radius)
    vacuum = disc.response(grid, design_rubber(design))
    source = source_response.transpose("point", "microphone", "frequency")
    injected = injected_flow(touch, grid, vacuum, point_impedance.transpose("point", "frequency").values)
    return (
        source.copy(data=source.values * injected[:, None])
        .assign_attrs(
            {"units": f"Pa/{TOUCHES[touch]}", "long_name": f"pressure at the microphone per {touch} of the touch"}
        )
        .rename(f"response_to_{touch}")
    )


def injected_flow(
    touch: str, frequency: NDArray[np.float64], vacuum: DiscResponse, point_impedance: NDArray[np.complex128]
) -> NDArray[np.complex128]:
    """Volume velocity that a touch injects into the cavity of each point.

    Args:
        touch: one of :data:`TOUCHES`.
        frequency: (n_freq,) float64, Hz.
        vacuum: what the membrane does in vacuo, arrays (..., n_freq) complex128.
        point_impedance: (..., n_point, n_freq) complex128, Pa s/m^3; the air pushes back where a displacement is given.

    Returns:
        (..., n_point or 1, n_freq) complex128, m^3/s per unit of the touch.
    """
    omega = 2j * np.pi * frequency
    if touch == "pressure":
        return np.asarray((omega * vacuum.volume_per_pressure)[..., None, :])
    per_force = omega * vacuum.volume_per_force
    if touch == "force":
        return np.asarray(per_force[..., None, :])
    pushed_back = (omega * vacuum.volume_per_force**2)[..., None, :] * point_impedance
    return np.asarray(per_force[..., None, :] / (vacuum.displacement_per_force[..., None, :] - pushed_back))
