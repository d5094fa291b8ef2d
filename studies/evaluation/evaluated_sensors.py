"""Sensors that accuracies are evaluated on: as-built ones that nobody calibrated, and virtual rigs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
from acoustic_fem import Library
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter.as_built_sensors import scatter_factors
from acoustic_fem.scatter.tolerances import UNCALIBRATED, ScatteredDesign
from geometry.ground.refusal import Refusal
from localize.signals.array_response import ArrayResponse
from studies.test_rig.virtual_rig import HEARD, Rig

#: Groups of the results on as-built sensors and on virtual rigs.
AS_BUILT, RIGS = "as-built sensors", "virtual rigs"
#: Number of as-built sensors of a set, and of virtual rigs.
SENSORS, RIG_COUNT = 20, 8


def rig_sensors(
    library: Library, response: ArrayResponse, seed: int, count: int
) -> list[tuple[str, float | None, NDArray[np.complex128]]]:
    """Set of virtual rigs, uncalibrated: as-built sensors with what no decoder knows, :class:`studies.HiddenScatter`.

    The changes by the rigs are computed with closed forms and applied to a library of any fidelity; above 160 Hz it
    stays as it is there.

    Args:
        library: of a design whose scatter is known.
        response: of that library.
        seed: of the first rig.
        count: of rigs.

    Returns:
        Name, no share, and (count, n_point, n_microphone, n_freq) complex128 transfer functions, Pa/Pa.
    """
    grid = np.unique(np.clip(response.frequency, *HEARD))
    place = np.minimum(np.searchsorted(grid, response.frequency), len(grid) - 1)
    nominal = acoustic_fem.solve(library.design, grid, "lumped").transfer_function.values
    rigs = [Rig(library.design, seed + k, fidelity="lumped").transfer_function(grid) / nominal for k in range(count)]
    return [("uncalibrated", None, response.transfer_function * np.stack(rigs)[..., place])]


def scattered_sensors(
    library: Library, response: ArrayResponse, seed: int, count: int, shares: Sequence[float]
) -> tuple[list[tuple[str, float, NDArray[np.complex128]]], str]:
    """Sets of :func:`sensor_sets` and an empty text; none, and the reason, where the scatter of a design is not known.

    Arguments as there, shapes too: (count, n_point, n_microphone, n_freq) complex128 transfer functions, Pa/Pa.
    """
    try:
        return sensor_sets(library, response, seed, count, shares), ""
    except Refusal as error:
        return [], str(error)


def sensor_sets(
    library: Library, response: ArrayResponse, seed: int, count: int, shares: Sequence[float]
) -> list[tuple[str, float, NDArray[np.complex128]]]:
    """Sets of sensors with shares of the tolerances of a sensor that nobody calibrated, its microphones among them.

    A library of any fidelity is scattered around itself, see :func:`acoustic_fem.scatter.scatter_factors`.

    Args:
        library: of a design.
        response: of that library.
        seed: of the sensors.
        count: sensors of each set.
        shares: of :data:`acoustic_fem.scatter.UNCALIBRATED`, one for each set.

    Returns:
        Name and share of each set, and (count, n_point, n_microphone, n_freq) complex128 transfer functions, Pa/Pa.
    """
    scattered, air = ScatteredDesign(library.design, UNCALIBRATED), design_air(library.design)

    def made(share: float) -> NDArray[np.complex128]:
        factors = scatter_factors(scattered, air, response.frequency, count, seed, fraction=share)
        return response.transfer_function * factors

    return [(f"{share:g} of the tolerances", share, made(share)) for share in shares]
