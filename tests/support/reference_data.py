"""The reference numbers as Python values; provenance: reference/README.md."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from acoustic_fem.quantities.medium import Medium

_DATA = json.loads((Path(__file__).parents[1] / "reference" / "acoustics.json").read_text())

AIR = Medium(density=1.204, viscosity=1.825e-5, conductivity=0.02587, heat_capacity=1006.0, gamma=1.4, pressure=101325)


def column(table: str, name: str) -> np.ndarray[Any, Any]:
    """One column of a table; pairs [real, imaginary] become complex."""
    values = np.array([row[name] for row in _DATA[table]["rows"]])
    return values[:, 0] + 1j * values[:, 1] if values.ndim == 2 else values


def rows(table: str) -> list[dict[str, Any]]:
    """The rows of a table as they are."""
    return list(_DATA[table]["rows"])
