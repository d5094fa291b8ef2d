"""Tubes computed by OpenWind (INRIA; GPL-3, in the optional extra ``verify``): the numbers of reference/openwind.json.

Run as a command in an environment with ``openwind`` to print the file anew:
``python tests/support/openwind_ladder.py > tests/reference/openwind.json``.
"""

from __future__ import annotations

import importlib.metadata
import json
import sys
import warnings
from typing import Any

import numpy as np

from acoustic_fem.duct import tapered
from acoustic_fem.duct.sections import CircularSection
from acoustic_fem.quantities.medium import Medium

TEMPERATURE = 20.0
FREQUENCY = [0.01, 0.1, 1.0, 10.0, 100.0, 1000.0, 5000.0, 20000.0]

#: Name: pieces (length, first radius, last radius) in m, from the driven to the closed end, and the method.
CASES: dict[str, tuple[list[tuple[float, float, float]], dict[str, Any]]] = {
    "tube 0.44 x 12.5 mm": ([(0.0125, 2.2e-4, 2.2e-4)], {"compute_method": "TMM"}),
    "tube 0.18 x 4 mm": ([(0.004, 0.9e-4, 0.9e-4)], {"compute_method": "TMM"}),
    "tube 5 x 120 mm": ([(0.12, 2.5e-3, 2.5e-3)], {"compute_method": "TMM"}),
    "ladder of 5 tubes": (
        [
            (0.0125, 2.2e-4, 2.2e-4),
            (0.003, 1.5e-3, 1.5e-3),
            (0.0125, 2.2e-4, 2.2e-4),
            (0.004, 1.5e-3, 1.5e-3),
            (0.006, 0.9e-4, 0.9e-4),
        ],
        {"compute_method": "TMM"},
    ),
    "cone 0.4 to 1.6 x 20 mm": ([(0.02, 2e-4, 8e-4)], {"compute_method": "FEM", "l_ele": 1e-3, "order": 8}),
}


def closed_impedance(pieces: list[tuple[float, float, float]], options: dict[str, Any]) -> np.ndarray[Any, Any]:
    """Input impedance (Pa s/m^3) of pieces in a row with a closed end, exact losses, no junction masses."""
    from openwind import ImpedanceComputation

    bore, place = [], 0.0
    for length, first, last in pieces:
        bore.append([place, place + length, first, last, "linear"])
        place += length
    with warnings.catch_warnings():
        # of one mesh of elements for all frequencies; that of the cone is fine enough for the highest
        warnings.filterwarnings("ignore", "The frequency range is too big", UserWarning)
        computation = ImpedanceComputation(
            FREQUENCY,
            bore,
            unit="m",
            temperature=TEMPERATURE,
            losses="bessel",
            radiation_category="closed",
            discontinuity_mass=False,
            **options,
        )
    return np.asarray(computation.impedance)


def air() -> dict[str, float]:
    """OpenWind's air at that temperature as the six numbers of ``acoustic_fem.Medium``."""
    from openwind.continuous import Physics

    physics = Physics(TEMPERATURE)
    density, sound_speed, viscosity, conductivity, heat_capacity, gamma = (
        float(getattr(physics, name)(0.0)) for name in ("rho", "c", "mu", "kappa", "Cp", "gamma")
    )
    return {
        "density": density,
        "viscosity": viscosity,
        "conductivity": conductivity,
        "heat_capacity": heat_capacity,
        "gamma": gamma,
        "pressure": density * sound_speed**2 / gamma,
    }


def driven_impedance(
    pieces: list[tuple[float, float, float]], frequency: np.ndarray[Any, Any], air: Medium
) -> np.ndarray[Any, Any]:
    """The same by this package: tanh for tubes, finite elements for cones."""
    beyond = np.zeros(len(frequency), dtype=complex)
    for length, first, last in reversed(pieces):
        if first == last:
            bore = CircularSection(first)
            tangent = np.tanh(bore.propagation(frequency, air) * length)
            characteristic = bore.characteristic_impedance(frequency, air)
            beyond = (beyond + tangent / characteristic) / (1 + beyond * characteristic * tangent)
        else:
            y = tapered.port_admittance(
                lambda x, start=first, slope=(last - first) / length: CircularSection(start + slope * x),
                length,
                frequency,
                air,
                accuracy=1e-11,
            )
            beyond = y[:, 0, 0] - y[:, 0, 1] ** 2 / (y[:, 1, 1] + beyond)
    return np.asarray(1 / beyond)


def reference() -> dict[str, Any]:
    """Everything that is kept in the file; needs ``openwind``."""
    cases = []
    for name, (pieces, options) in CASES.items():
        impedance = closed_impedance(pieces, options)
        cases.append(
            {
                "name": name,
                "pieces": pieces,
                "options": options,
                "impedance": [[float(z.real), float(z.imag)] for z in impedance],
            }
        )
    versions = {package: importlib.metadata.version(package) for package in ("openwind", "numpy", "scipy")}
    return {
        "provenance": "input impedance of tubes with a closed end by tests/support/openwind_ladder.py: "
        "losses='bessel', radiation_category='closed', discontinuity_mass=False, "
        "nondim=True, air of OpenWind's Physics(20)",
        "versions": versions | {"python": sys.version.split()[0]},
        "units": "m, Hz, Pa s/m^3",
        "air": air(),
        "frequency": FREQUENCY,
        "cases": cases,
    }


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=1)
    sys.stdout.write("\n")
