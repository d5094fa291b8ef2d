"""Assumptions of the models, each in a number beside its limit: what `check` lists and a report repeats."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from acoustic_fem.duct.tube_opening import LARGEST_SHEAR_NUMBER
from acoustic_fem.library.model_limits import SLIP_WARNED, uniform_up_to, widest_cavity
from acoustic_fem.membrane.design_discs import design_disc
from acoustic_fem.membrane.rubber import causal_slope
from acoustic_fem.network.microphone import noise_density_behind_vent
from acoustic_fem.quantities.medium import Medium
from geometry.design.array_design import ArrayDesign
from localize.signals.stimulus import BAND

#: Weakest sinusoid of the paper's stimuli, Pa, and length of the localizer's frames, s.
WEAKEST_SINUSOID, FRAME_SECONDS = 0.02, 0.25


@dataclass(frozen=True)
class Validity:
    """Assumption of the models, in a number that can be compared with a limit."""

    assumption: str
    """Name of the assumption, in words."""
    value: float
    """Value for the design, in the unit."""
    relation: Literal["at least", "at most"]
    """Relation that the value must have to the limit."""
    limit: float
    """Limit, in the unit."""
    unit: str
    """Unit of value and limit; empty for ratios."""
    meaning: str
    """Explanation of the value, in words."""

    @property
    def holds(self) -> bool:
        """True if the value keeps the limit."""
        return self.value >= self.limit if self.relation == "at least" else self.value <= self.limit


def model_validity(design: ArrayDesign, medium: Medium, weakest_level: float) -> tuple[Validity, ...]:
    """Assumptions of the models, each against its limit, for the band up to 100 Hz.

    Args:
        design: the design.
        medium: its air.
        weakest_level: of the point that is heard worst, at its second-loudest microphone and 100 Hz, dB.

    Raises:
        Refusal: the membrane's proportions are outside what can be solved.
    """
    highest = BAND[1]
    microphone, alike = design.microphone, [design.of_kind(kind) for kind in design.kinds]
    widest = widest_cavity(design)
    bores = [tube.inner_diameter for tube in design.tubes]
    slip = medium.slip_in(min(bores) * 1e-3)
    shear = max(bores) / 2 * 1e-3 * math.sqrt(2 * math.pi * highest / medium.kinematic_viscosity)
    material = design.material(design.membrane.material)
    missing = causal_slope(material.loss_factor or 0.0) if material.law == "constant" else 0.0
    noise = float(noise_density_behind_vent(microphone, highest, medium)) / math.sqrt(FRAME_SECONDS)
    heard = weakest_level + 20 * math.log10(WEAKEST_SINUSOID / math.sqrt(2) / noise)
    return (
        Validity(
            "plane waves and uniform cavity pressure up to",
            uniform_up_to(widest, medium),
            "at least",
            highest,
            "Hz",
            f"frequency at which the widest cavity, {widest:g} mm, is a tenth of the wavelength",
        ),
        Validity(
            "first resonance of the membrane, without air",
            min(design_disc(each).first_frequency for each in alike),
            "at least",
            3 * highest,
            "Hz",
            "up to a third of this frequency the membrane moves in its first mode alone; the band ends at "
            f"{highest:g} Hz",
        ),
        Validity(
            "stiffening of the membrane that its material law neglects",
            100 * ((BAND[1] / BAND[0]) ** float(missing) - 1),
            "at most",
            5.0,
            "%",
            f"rise of the modulus from {BAND[0]:g} to {BAND[1]:g} Hz that the loss factor implies; "
            f"{design.membrane.material}: {material.law_in_words}",
        ),
        Validity(
            "slip of the air in the narrowest bore",
            100 * slip,
            "at most",
            100 * SLIP_WARNED,
            "%",
            f"the real flow through a bore of {min(bores):g} mm is larger by this, because the models assume no slip "
            "at walls",
        ),
        Validity(
            f"shear number of the widest bore at {highest:g} Hz",
            shear,
            "at most",
            LARGEST_SHEAR_NUMBER,
            "",
            "bore radius over the thickness of the viscous boundary layer, sqrt(nu / omega), for a bore of "
            f"{max(bores):g} mm; above the limit the entrance loss of the lumped model is not valid",
        ),
        Validity(
            f"weakest touch over the microphone's noise at {highest:g} Hz",
            heard,
            "at least",
            10.0,
            "dB",
            f"a sinusoid of {WEAKEST_SINUSOID:g} Pa in the cavity with the weakest signal, at its second-loudest "
            f"microphone, in {FRAME_SECONDS:g} s; source of the microphone's noise: {microphone.source}",
        ),
    )
