"""The pressure at the microphones when the whole sensor is shaken."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import xarray as xr

from acoustic_fem.quantities.units import metres
from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array
from geometry.layout.arrangement import lay_out

if TYPE_CHECKING:
    from acoustic_fem.library.transfer_functions import Library

AXES = ("x", "y", "z")


def acceleration_response(library: Library) -> xr.DataArray:
    """Pressure at the microphones per acceleration of the sensor as a rigid body.

    The inertia of a membrane of thickness h and density rho is, on a housing with the acceleration a, a pressure
    rho h (a . n) on its outer face, n the outward normal. It acts on all membranes at once, so that the responses of
    the points add. The inertia of the air in the tubes (0.04 Pa per m/s2 over 30 mm) and of the microphones' diaphragms
    is left out.

    Args:
        library: of the array. The axes are those of its design's layout: z is normal to a flat array.

    Returns:
        (microphone, axis, frequency) complex128, Pa s2/m.

    Raises:
        Refusal: a membrane that is not flat.
    """
    pressure = library.touch_response("pressure").transpose("point", "microphone", "frequency")
    layout = lay_out(library.design)
    normals = np.array([layout.frame(point).axes[2] for point in layout.points], dtype=np.float64)
    load = areal_mass(library.design)[:, None] * normals
    return xr.DataArray(
        np.einsum("pmf,pa->maf", pressure.values, load),
        dims=("microphone", "axis", "frequency"),
        coords={"microphone": pressure["microphone"], "axis": list(AXES), "frequency": pressure["frequency"]},
        name="acceleration_response",
        attrs={"units": "Pa s2/m", "long_name": "pressure at the microphone per acceleration of the sensor"},
    )


def areal_mass(design: ArrayDesign) -> Array:
    """Mass of the membrane of each point per area, (n_point,) float64, kg/m^2.

    Raises:
        Refusal: a membrane that is not flat.
    """
    kinds = []
    for each in (design.of_kind(kind) for kind in design.kinds):
        membrane = each.membrane
        if membrane.shape != "flat":
            raise Refusal(
                kind=Kind.NO_RESULT,
                field="membrane.shape",
                value=membrane.shape,
                allowed="'flat' for responses to acceleration",
            )
        # a stretched sheet is thinner in the ratio of the areas
        density = each.material(membrane.material).density
        kinds.append(density * metres(membrane.thickness) / membrane.stretch**2)
    return np.array(kinds)[list(design.kind_of_point)]
