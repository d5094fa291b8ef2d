"""The reference numbers as Python values; provenance: reference/README.md."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

from acoustic_fem.quantities.medium import Medium

_FOLDER = Path(__file__).parents[1] / "reference"
_DATA = json.loads((_FOLDER / "acoustics.json").read_text())

AIR = Medium(density=1.204, viscosity=1.825e-5, conductivity=0.02587, heat_capacity=1006.0, gamma=1.4, pressure=101325)


def column(table: str, name: str) -> np.ndarray[Any, Any]:
    """One column of a table; pairs [real, imaginary] become complex."""
    values = np.array([row[name] for row in _DATA[table]["rows"]])
    return values[:, 0] + 1j * values[:, 1] if values.ndim == 2 else values


def rows(table: str) -> list[dict[str, Any]]:
    """The rows of a table as they are."""
    return list(_DATA[table]["rows"])


_PRESSES = json.loads((_FOLDER / "press.json").read_text())
_MEMBRANES = {
    "array-2x6": ("array/glove/area a3 h.5", "array/glove/area", 3e-3, 1.1424e6),
    "fingertip-4x6": ("fingertip-4x6", "fingertip-4x6", 0.8e-3, 0.2783e6),
}


class PressedMembrane:
    """Large deflections of one membrane by another program, in newtons, pascals and metres.

    The file gives forces and displaced volumes in E a^2 and a^3, although it says newtons and cubic millimetres for
    spheres: its small forces displace the volume of its own linear law in these units only.
    """

    def __init__(self, design: str) -> None:
        self._patch, self._bulge, self.radius, self.modulus = _MEMBRANES[design]

    def patch(self, largest: float) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
        """Forces up to a largest one, N, on the soft patch of a quarter of the radius, and displaced volumes, m^3."""
        table = _PRESSES["rows"][self._patch]["patch"]
        return self._in_si([row["v"] for row in table], [row["V"] for row in table], largest)

    def sphere(self, radius: float, largest: float) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
        """The same under a sphere of a radius in m, which the file has for array-2x6 only."""
        table = [row for row in _PRESSES["spheres"][f"array R{radius * 1e3:.1f}"] if row[1] is not None]
        return self._in_si([row[1] for row in table], [row[2] for row in table], largest)

    def _in_si(
        self, force: list[float], volume: list[float], largest: float
    ) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
        newtons = np.array(force) * self.modulus * self.radius**2
        kept = newtons <= largest * (1 + 1e-3)
        return newtons[kept], np.array(volume)[kept] * self.radius**3

    def bulge(self) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
        """Pressures, Pa, and volumes swept under a dead load, m^3."""
        table = np.array(_PRESSES["bulge"][self._bulge])
        return table[:, 0], table[:, 2] * 1e-9
