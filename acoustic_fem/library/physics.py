"""Physics that every library obeys: a library that is not passive or not reciprocal is refused, by variable and place.

Noise breaks none of it: a measured library has the impedances of the library of its design, and its source response is
their product with the measured transfer function. The measured transfer function itself is not checked for passivity.
"""

from __future__ import annotations

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from acoustic_fem.library.transfer_functions import MEASURED, Library
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import ComplexArray

#: Part of the size of impedances by which resistances may be negative, and impedances unequal, from rounding: cells
#: in 3-D are symmetric and passive to 1e-9.
_ROUNDING = 1e-6


def check_physics(library: Library) -> None:
    """Refuse a library that no sensor has.

    - Every point has a response, and it changes with the frequency.
    - The source response is the transfer function times the point impedance.
    - Impedances take power and give none: resistances are not negative, and, where nothing was measured, the square of
      that between a point and a microphone is at most the product of their own (the real part of an impedance matrix
      is positive semidefinite).
    - Impedances between microphones are reciprocal.

    Raises:
        Refusal: names the variable and the place.
    """
    _check_heard(library.transfer_function)
    _check_product(library)
    _check_passive("point_impedance", library.point_impedance, library.point_impedance.values)
    if library.microphone_impedance is not None:
        _check_microphones(library.microphone_impedance)
        if library.fidelity != MEASURED:
            _check_shared(library, library.microphone_impedance)


def _check_heard(transfer_function: xr.DataArray) -> None:
    h = transfer_function.values
    silent = np.flatnonzero(~np.any(h, axis=(1, 2)))
    if len(silent) == len(h):
        raise _unphysical("transfer_function", "is zero everywhere; no sensor is silent")
    if len(silent):
        point = transfer_function["point"].values[silent[0]]
        raise _unphysical("transfer_function", f"is zero at point {point} everywhere; no point is silent")
    if h.shape[2] > 1 and (h == h[..., :1]).all():
        raise _unphysical("transfer_function", "is the same at all frequencies; that of no sensor is")


def _check_product(library: Library) -> None:
    h = library.transfer_function
    with np.errstate(over="ignore", invalid="ignore"):
        product = h.values * library.point_impedance.values[:, None]
        # what is next to nothing has lost digits
        near = np.abs(library.source_response.values - product) <= 1e-5 * np.abs(product) + 1e-280
    wrong = ~(near & np.isfinite(product))
    if wrong.any():
        raise _unphysical(
            "source_response",
            f"is not transfer_function times point_impedance at {_place(h, wrong)}; one of the three was changed",
        )


def _unphysical(variable: str, problem: str) -> Refusal:
    return Refusal(problem, kind=Kind.UNSUITABLE, field=variable)


def _check_passive(name: str, array: xr.DataArray, values: ComplexArray) -> None:
    wrong = values.real < -_ROUNDING * np.abs(values)
    if wrong.any():
        found = values.real[tuple(np.argwhere(wrong)[0])]
        raise Refusal(
            f"at {_place(array, wrong)} must be positive: a passive part gives no power",
            kind=Kind.UNSUITABLE,
            field=f"{name}_real",
            value=float(f"{found:.3g}"),
            unit="Pa s/m^3",
        )
    if (values == 0).any():
        raise _unphysical(name, f"is zero at {_place(array, values == 0)}; no part of a sensor has no impedance")


def _check_microphones(impedance: xr.DataArray) -> None:
    z = impedance.values
    own = np.einsum("iif->if", z)
    _check_passive("microphone_impedance", impedance.isel(microphone_2=0), own)
    size = np.sqrt(np.abs(own))
    wrong = np.abs(z - z.swapaxes(0, 1)) > _ROUNDING * size[:, None] * size[None]
    if wrong.any():
        raise _unphysical(
            "microphone_impedance",
            f"is not reciprocal at {_place(impedance, wrong)}: exchanging its microphones must change nothing",
        )


def _check_shared(library: Library, microphone_impedance: xr.DataArray) -> None:
    source, point = library.source_response, library.point_impedance.values[:, None]
    own = np.einsum("iif->if", microphone_impedance.values)[None]
    with np.errstate(over="ignore", invalid="ignore"):
        bound = point.real * own.real + _ROUNDING * np.abs(point) * np.abs(own)
        wrong = ~(source.values.real**2 <= bound)
    if wrong.any():
        raise _unphysical(
            "source_response",
            f"is not passive at {_place(source, wrong)}: its resistance must be at most the root of those of "
            "point_impedance and microphone_impedance",
        )


def _place(array: xr.DataArray, wrong: NDArray[np.bool_]) -> str:
    """The first place at which something is wrong, in words."""
    at = {str(name): array[name].values[k] for name, k in zip(array.dims, np.argwhere(wrong)[0], strict=True)}
    return ", ".join(f"{value:g} Hz" if name == "frequency" else f"{name} {value}" for name, value in at.items())
