"""What the tolerances of manufacturing make of a library: sensors that are drawn about it, whatever its fidelity."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from itertools import product

import numpy as np
from numpy.typing import ArrayLike, NDArray

from acoustic_fem.atlas.fidelity_choice import QuickFidelity, quick_fidelity_by
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.openings import check_openings
from acoustic_fem.network.microphone import vent_ratio
from acoustic_fem.quantities.fidelity import ClosedForm
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.scatter.tolerances import CUT, QUANTITIES, ScatteredDesign

#: What of the scatter counts in the bounds of the atlas.
_BOUNDED = ("bore", "cavity_diameter", "cavity_height", "chamber_height", "ovality")


def made_fidelity(scattered: ScatteredDesign, frequency: ArrayLike, medium: Medium) -> QuickFidelity:
    """The fidelity of a quick answer for a design and all sensors that can be drawn about it.

    It is the atlas where the design has it with every size at either end of its scatter: each ratio that is bounded
    rises or falls with each of them.

    Args:
        scattered: the nominal design and what scatters.
        frequency: (n_freq,) Hz, ascending.
        medium: the air.
    """
    named = {tolerance.quantity for tolerance in scattered.tolerances}
    ends = np.array(list(product(*((-CUT, CUT) if name in named else (0.0,) for name in _BOUNDED))))
    draws = {name: np.zeros((len(ends), 1)) for name in QUANTITIES} | dict(
        zip(_BOUNDED, ends.T[..., None], strict=True)
    )
    draws["ovality"] = np.maximum(draws["ovality"], 0.0)  # either sign flattens a bore

    def check() -> None:
        check_openings(scattered.nominal, scattered.topology, np.asarray(frequency, np.float64), medium)
        check_openings(scattered.parameters(draws), scattered.topology, np.asarray(frequency, np.float64), medium)

    return quick_fidelity_by(check)


def made_transfer_functions(
    scattered: ScatteredDesign,
    draws: Mapping[str, NDArray[np.float64]],
    frequency: ArrayLike,
    medium: Medium,
    fidelity: ClosedForm = "lumped",
) -> NDArray[np.complex128]:
    """Transfer functions of made sensors in closed form, as their microphones give them.

    Args:
        scattered: the nominal design and what scatters.
        draws: by quantity (count, n_part) float64, in standard deviations, as
            :meth:`acoustic_fem.scatter.ScatteredDesign.parameters` takes them.
        frequency: (n_freq,) Hz, ascending.
        medium: the air.
        fidelity: "lumped" or "atlas".

    Returns:
        (count, n_point, n_microphone, n_freq) complex128, Pa/Pa, by the response of the nominal microphone.

    Raises:
        Refusal: a frequency out of range.
        OutsideAtlas: a sensor that the atlas has not; see :func:`made_fidelity`.
    """
    made = batch_transfer_function(scattered.parameters(draws), scattered.topology, frequency, medium, fidelity)
    gain, corner = np.moveaxis(scattered.microphones(draws), 1, 0)[:, :, None, :, None]
    if (gain == 1).all() and (corner == 1).all():
        return np.asarray(made)
    vent = vent_ratio(scattered.design.microphone, frequency, medium)
    return np.asarray(made * gain * (1 + 1 / vent) / (1 + corner / vent))


def scatter_factors(
    scattered: ScatteredDesign,
    medium: Medium,
    frequency: ArrayLike,
    count: int,
    seed: int,
    *,
    first: int = 0,
    share: float = 1.0,
) -> NDArray[np.complex128]:
    """Transfer functions of made sensors over those of the nominal one, both computed with the lumped network.

    Times the transfer functions of a library of any fidelity they are those of sensors made about it: what a finer
    fidelity changes is taken to be the same for all. What closed forms warn of concerns none of the library's own
    numbers and is not told.

    Args:
        scattered: the nominal design and what scatters.
        medium: the air.
        frequency: (n_freq,) Hz, ascending.
        count: sensors.
        seed: of the draws.
        first: number of the first sensor.
        share: of the deviations that are drawn, of one.

    Returns:
        (count, n_point, n_microphone, n_freq) complex128, ratios.

    Raises:
        Refusal: a frequency out of range.
    """
    draws = {name: share * values for name, values in scattered.draws(first, count, seed).items()}
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "entrance loss", UserWarning)
        made = made_transfer_functions(scattered, draws, frequency, medium)
        nominal = batch_transfer_function(scattered.nominal, scattered.topology, frequency, medium)
    return np.asarray(made / nominal)
