"""A textbook Helmholtz line against the Navier-Stokes solution: ``python -m benchmarks.textbook``; some seconds.

The textbook's tube is a mass with the resistance of a thin viscous boundary layer, its cavity an adiabatic spring with
the static compliance of the membrane beside it (Kinsler et al., Fundamentals of Acoustics, 4th edition, section 10.8).
Both take the layer to be thin, which at 1 to 100 Hz it is not.
"""

from __future__ import annotations

import numpy as np

import acoustic_fem
import geometry
from acoustic_fem.membrane.design_discs import design_disc
from acoustic_fem.quantities.local_air import design_air
from geometry.ground.typed import Array, ComplexArray

DESIGN = "array-2x6"
FREQUENCIES = np.array([5.0, 20.0, 50.0, 100.0])


def textbook_transfer_functions(design: geometry.ArrayDesign, frequency: Array) -> ComplexArray:
    """Transfer functions of a line of equal points between two microphones, (n_point, 2, n_freq) complex128, Pa/Pa."""
    air, omega = design_air(design), 2 * np.pi * frequency
    radius, length = design.tube.inner_diameter / 2e3, design.tube.length / 1e3
    area = np.pi * radius**2
    resistance = length * np.sqrt(2 * air.density * air.viscosity * omega) / (radius * area)
    series = 1 / (resistance + 1j * omega * air.density * length / area)
    stiffness = air.gamma * air.pressure
    cavity = 1j * omega * (design.resonator.cavity_volume * 1e-9 / stiffness + design_disc(design).static_compliance)
    microphone = design.microphone
    volume = (microphone.chamber_volume + microphone.diaphragm_equivalent_volume) * 1e-9
    chamber = 1j * omega * volume / stiffness
    count = design.point_count + 2
    found = np.empty((design.point_count, 2, len(frequency)), dtype=np.complex128)
    for k in range(len(frequency)):
        shunt = np.array([chamber[k], *[cavity[k]] * (count - 2), chamber[k]])
        admittance = np.diag(shunt).astype(np.complex128)
        for node in range(count - 1):
            admittance[node : node + 2, node : node + 2] += series[k] * np.array([[1, -1], [-1, 1]])
        impedance = np.linalg.inv(admittance)
        inner = np.arange(1, count - 1)
        found[:, :, k] = impedance[np.ix_(inner, [0, count - 1])] / impedance[inner, inner][:, None]
    return found


def level_differences(h: ComplexArray) -> Array:
    """Level of the first microphone against the last, (n_point, n_freq) float64, dB."""
    return 20 * np.log10(np.abs(h[:, 0] / h[:, -1]))


def main() -> None:
    """Print the level difference of the first point by both, and the ratio of the two."""
    design = geometry.prototype(DESIGN)
    solved = acoustic_fem.solve(design, FREQUENCIES).transfer_function.values
    simple = textbook_transfer_functions(design, FREQUENCIES)
    print("| frequency (Hz) | Navier-Stokes (dB) | textbook (dB) | textbook / Navier-Stokes |\n|---|---|---|---|")
    for f, own, other in zip(FREQUENCIES, level_differences(solved)[0], level_differences(simple)[0], strict=True):
        print(f"| {f:g} | {own:.2f} | {other:.2f} | {other / own:.2f} |")


if __name__ == "__main__":
    main()
