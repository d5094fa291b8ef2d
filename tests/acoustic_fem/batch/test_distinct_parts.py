"""Transfer functions from distinct parts are those of the batch solver."""

from __future__ import annotations

import numpy as np
import pytest

import geometry
from acoustic_fem.batch.distinct_parts import transfer_function_of_distinct_parts
from acoustic_fem.batch.network import batch_transfer_function
from acoustic_fem.batch.parameters import MediumParameters
from acoustic_fem.quantities.local_air import LocalAir, medium_of
from acoustic_fem.scatter.tolerances import UNCALIBRATED, ScatteredDesign

FREQUENCY = np.array([3.0, 20.0, 95.0])


@pytest.mark.parametrize("name", ["array-2x6", "glove"])
def test_designs_with_equal_parts_have_the_transfer_functions_of_the_batch(name: str) -> None:
    """Sensors of three kinds in two airs: as designed, with one part off, and with all parts off."""
    design = geometry.prototype(name)
    scattered = ScatteredDesign(design, UNCALIBRATED)
    drawn = scattered.draws(0, 6, 46)
    drawn = {quantity: values * np.array([0, 0, 0, 0, 1, 1])[:, None] for quantity, values in drawn.items()}
    drawn["bore"][[1, 3], 2] = 0.5
    air, high = medium_of(None, design), medium_of(LocalAir(80e3), design)
    medium = MediumParameters.from_media([air, air, high, high, air, high])
    parameters = scattered.parameters(drawn)
    found = transfer_function_of_distinct_parts(parameters, scattered.topology, FREQUENCY, medium)
    expected = batch_transfer_function(parameters, scattered.topology, FREQUENCY, medium)
    assert found == pytest.approx(expected, rel=1e-11)
    assert not np.isclose(found[0], found[1], rtol=1e-6).all()


def test_designs_that_are_all_equal_are_allowed() -> None:
    design = geometry.prototype("array-2x6")
    scattered = ScatteredDesign(design, UNCALIBRATED)
    none = {quantity: np.zeros_like(values) for quantity, values in scattered.draws(0, 2, 1).items()}
    medium = MediumParameters.from_media([medium_of(None, design)])
    parameters = scattered.parameters(none)
    found = transfer_function_of_distinct_parts(parameters, scattered.topology, FREQUENCY, medium)
    assert found[0] == pytest.approx(found[1], rel=1e-15)
    assert found == pytest.approx(batch_transfer_function(parameters, scattered.topology, FREQUENCY, medium), rel=1e-11)
