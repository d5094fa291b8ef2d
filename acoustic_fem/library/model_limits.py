"""Limits of the models that a design, its air or its frequencies may pass, whatever solves it."""

from __future__ import annotations

import numpy as np

from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry.design.array_design import ArrayDesign
from geometry.ground.caller_warnings import warn_caller
from geometry.ground.refusal import Kind, Refusal
from geometry.ground.typed import Array

#: Part of the flow through the narrowest bore by slip at its wall, above which a solve warns, and refuses.
SLIP_WARNED, SLIP_REFUSED = 0.005, 0.1
#: K, temperatures of an ideal gas with a medium's density, pressure and heat capacities. Water would have 3.5 K.
TEMPERATURES = (100.0, 2000.0)
#: Pa, pressure up to which air is ideal within 0.5 %: its compressibility factor is 0.995 at 300 K (Perry's Chemical
#: Engineers' Handbook, table of compressibility factors of air).
IDEAL_UP_TO = 2e6


def check_model_limits(design: ArrayDesign, frequency: Array, medium: Medium) -> None:
    """Warn of what the models neglect, and refuse a gas too thin to be a continuum.

    Args:
        design: the array.
        frequency: (n_freq,) Hz.
        medium: its air.

    Raises:
        Refusal: slip at the wall of the narrowest bore is more than :data:`SLIP_REFUSED` of its flow.
    """
    bore = min(tube.inner_diameter for tube in design.tubes)
    slip = medium.slip_in(bore * 1e-3)
    if slip > SLIP_REFUSED:
        raise Refusal(
            f"has a mean free path of {medium.mean_free_path * 1e3:.3g} mm, too long for a bore of {bore:g} mm: the "
            f"flow by slip is {100 * slip:.3g} % of that without slip, which the models neglect",
            kind=Kind.OUT_OF_RANGE,
            field="air",
            value=f"a gas at {medium.pressure:.4g} Pa",
            allowed=f"slip up to {100 * SLIP_REFUSED:g} %",
        )
    if slip > SLIP_WARNED:
        warn_caller(
            f"slip of the air: the real flow through a bore of {bore:g} mm is {100 * slip:.2g} % larger than the "
            "models', which neglect slip",
            ModelLimitWarning,
        )
    low, high = TEMPERATURES
    if not low <= medium.temperature <= high:
        warn_caller(
            "air: the models take it for an ideal gas, which with this density, pressure and heat capacities would "
            f"be at {medium.temperature:.3g} K; a liquid is stiffer",
            ModelLimitWarning,
        )
    elif medium.pressure > IDEAL_UP_TO:
        warn_caller(
            f"air: the models take it for an ideal gas, as air is within 0.5 % up to {IDEAL_UP_TO:.3g} Pa; the "
            f"pressure is {medium.pressure:.3g} Pa",
            ModelLimitWarning,
        )
    widest = widest_cavity(design)
    limit = uniform_up_to(widest, medium)
    if float(np.max(frequency)) > limit:
        warn_caller(
            f"cavities: pressure in the widest, {widest:g} mm, is uniform up to {limit:.4g} Hz, a tenth of a "
            f"wavelength; the frequencies reach {float(np.max(frequency)):.4g} Hz",
            ModelLimitWarning,
        )


def widest_cavity(design: ArrayDesign) -> float:
    """Largest dimension of a cavity or chamber of a design, mm."""
    microphone = design.microphone
    return max(
        design.resonator.cavity_diameter,
        *(design.of_kind(kind).resonator.cavity_height for kind in design.kinds),
        microphone.chamber_diameter,
        microphone.chamber_height,
    )


def uniform_up_to(widest: float, medium: Medium) -> float:
    """Frequency at which a cavity, mm, is a tenth of the wavelength, Hz."""
    return medium.sound_speed / (10 * widest * 1e-3)
