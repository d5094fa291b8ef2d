"""Change of the responses of an array in other air, by closed forms."""

from __future__ import annotations

from acoustic_fem.library.network_responses import array_responses
from acoustic_fem.quantities.medium import Medium
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array, ComplexArray


def air_ratio(design: ArrayDesign, frequency: Array, before: Medium, after: Medium) -> dict[str, ComplexArray]:
    """Factors by which other air changes the responses of an array, at ``lumped`` fidelity.

    By what 3-D cells differ from closed forms hardly changes with the air; so their responses in other air
    follow from those known by these factors without a new solve. tests/acoustic_fem/library/test_other_air.py holds
    that against 3-D solves.

    Args:
        design: the array.
        frequency: (n_freq,) float64, ascending, Hz.
        before: the air in which the responses are known.
        after: the air in which they are wanted.

    Returns:
        Arrays by the names and shapes of :data:`acoustic_fem.library.transfer_functions.VARIABLES`, dimensionless.
    """
    known, _ = array_responses(design, frequency, "lumped", before)
    wanted, _ = array_responses(design, frequency, "lumped", after)
    return {name: wanted[name] / known[name] for name in known}
