"""The extra series impedance of one opening of a tube into a cavity."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from acoustic_fem.quantities.checks import FrequencyLike, frequencies
from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.model_limit_warning import ModelLimitWarning
from geometry.ground.argument_checks import positive_numbers
from geometry.ground.caller_warnings import warn_caller
from geometry.ground.typed import ComplexArray

#: Resistance of one opening in units of mu / a^3: half of the creeping flow through a hole in a thin
#: plate (R. A. Sampson, Phil. Trans. R. Soc. A 182 (1891) 449).
RESISTANCE = 1.5

#: Inertance of one opening in units of rho / a: linearised Navier-Stokes of a tube that ends in the flat
#: wall of a wide cavity gives 0.43 at 1 Hz, 0.42 at 10 Hz and 0.38 at 100 Hz for a = 0.25 mm
#: (tests/reference/acoustics.json, "entrance").
INERTANCE = 0.42

#: Largest a sqrt(w / nu) at which the constants are compared with 3-D: that of the atlas of cells.
LARGEST_SHEAR_NUMBER = 5.0


def entrance_impedance(radius: ArrayLike, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
    """Impedance of one opening in series with its tube, Z = 1.5 mu / a^3 + j w 0.42 rho / a, Pa s/m^3.

    Within 4 % in resistance and 9 % in inertance of the Navier-Stokes table for shear numbers
    a sqrt(w / nu) up to 1.6 and a flat wall much wider than the bore (a cavity of 5 bore radii has 22 to
    26 % less inertance). Against the atlas of cells, over the cavities of all prototypes, Z is within 12 % up to 1.6,
    20 % at 3.6 and 27 % at 5, above which a warning starts. One opening is about 1 % of a tube of 60 radii, so that
    the error of the tube is at most 0.14 % up to 1.6 and 0.4 % up to 5.

    Args:
        radius: of the bore, m; broadcasts with frequency.
        frequency: Hz, any shape.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.

    Returns:
        Broadcast shape, complex128.

    Raises:
        Refusal: a radius or frequency that is not finite and positive.
    """
    medium = medium_of(air)
    radius, omega = positive_numbers("radius", radius, "m"), 2 * np.pi * frequencies(frequency)
    shear = float(np.max(radius * np.sqrt(omega / medium.kinematic_viscosity)))
    if shear > LARGEST_SHEAR_NUMBER:
        warn_caller(
            f"entrance loss of a tube: shear number a sqrt(w/nu) = {shear:.2g} is above {LARGEST_SHEAR_NUMBER:g}, "
            f"the largest it is fit for (bore radius {np.max(radius) * 1e3:.3g} mm, up to "
            f"{np.max(omega) / (2 * np.pi):.4g} Hz)",
            ModelLimitWarning,
        )
    impedance: ComplexArray = (
        RESISTANCE * medium.viscosity / radius**3 + 1j * omega * INERTANCE * medium.density / radius
    )
    return impedance
