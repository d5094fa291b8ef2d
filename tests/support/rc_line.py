"""A sensor for the localizer's tests, independent of acoustic_fem: resistors and compliances in a row."""

from __future__ import annotations

import numpy as np

from localize import ArrayResponse

RESISTANCE = 7.2e7  # Pa s/m^3, a tube of 0.6 x 12.5 mm
COMPLIANCE = 1.8e-12  # m^3/Pa, a cavity of 150 mm^3 and its membrane
CHAMBER = 5e-14  # m^3/Pa, a microphone chamber of 5 mm^3


def rc_line(points: int, frequency: np.ndarray | None = None, spread: float = 1.0) -> ArrayResponse:
    """A line of points between two microphones, ``spread`` times as resistive as usual; the same from both ends."""
    f = np.arange(1.0, 501.0) if frequency is None else np.asarray(frequency, float)
    size = points + 2
    admittance = np.zeros((len(f), size, size), complex)
    for k in range(size - 1):
        admittance[:, [k, k + 1], [k, k + 1]] += 1 / (spread * RESISTANCE)
        admittance[:, [k, k + 1], [k + 1, k]] -= 1 / (spread * RESISTANCE)
    compliance = np.array([CHAMBER, *[COMPLIANCE] * points, CHAMBER])
    admittance[:, np.arange(size), np.arange(size)] += 2j * np.pi * f[:, None] * compliance
    impedance = np.linalg.inv(admittance)
    own = np.diagonal(impedance, axis1=1, axis2=2)[:, 1:-1]
    h = impedance[:, [0, -1], 1:-1] / own[:, None, :]
    return ArrayResponse(
        transfer_function=h.transpose(2, 1, 0),
        frequency=f,
        line=np.zeros(points, np.int64),
        place=np.arange(points),
        microphones=("left", "right"),
        name=f"rc-line-{points}",
        provenance={"made by": "tests/support/rc_line.py"},
    )
