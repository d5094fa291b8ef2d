"""Small libraries, and libraries held against each other."""

from __future__ import annotations

import numpy as np

import acoustic_fem
import geometry
from acoustic_fem.library.transfer_functions import DEVIATION, VARIABLES, Library

GRID = np.linspace(1.0, 100.0, 7)


def library_of(name: str, **changes: object) -> Library:
    """Lumped library of a prototype with other values, at :data:`GRID`."""
    return acoustic_fem.solve(geometry.prototype(name).with_values(changes), GRID, "lumped")


def three_points() -> Library:
    """Library of a small array."""
    return library_of("array-2x6", **{"lines.0.points": 3, "layout.columns": 3})


def assert_same_library(found: Library, expected: Library, without: tuple[str, ...] = ()) -> None:
    """Two libraries agree bit for bit, but for the responses that the first one is ``without``."""
    for name in (*VARIABLES, "transfer_function_deviation"):
        one, other = getattr(found, name), getattr(expected, name)
        if name in without:
            assert one is None
        elif other is None:
            assert one is None, name
        else:
            dimensions = {**VARIABLES, "transfer_function_deviation": DEVIATION}[name][0]
            assert np.array_equal(one.transpose(*dimensions).values, other.transpose(*dimensions).values), name
    assert np.array_equal(found.frequency, expected.frequency)
    assert found.design == expected.design
    assert (found.medium, found.fidelity) == (expected.medium, expected.fidelity)
    assert dict(found.provenance) == dict(expected.provenance)
