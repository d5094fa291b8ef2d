"""Change of the responses of an array in other air, by closed forms."""

from __future__ import annotations

from acoustic_fem.library.network_responses import array_responses
from acoustic_fem.quantities.local_air import design_air
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array, ComplexArray


def air_ratio(before: ArrayDesign, after: ArrayDesign, frequency: Array) -> dict[str, ComplexArray]:
    """Factors by which other air, outside and enclosed, changes the responses of an array, at ``lumped`` fidelity.

    By what 3-D cells differ from closed forms hardly changes with the air; so their responses in other air
    follow from those known by these factors without a new solve. tests/acoustic_fem/library/test_other_air.py holds
    that against 3-D solves.

    Args:
        before: the array in the air in which the responses are known.
        after: the array in the air in which they are wanted.
        frequency: (n_freq,) float64, ascending, Hz.

    Returns:
        Arrays by the names and shapes of :data:`acoustic_fem.library.transfer_functions.VARIABLES`, dimensionless.
    """
    known, wanted = (array_responses(each, frequency, "lumped", design_air(each))[0] for each in (before, after))
    return {name: wanted[name] / known[name] for name in known}
