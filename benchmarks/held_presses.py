"""Held presses: ``python -m benchmarks.held_presses`` prints the table of docs/evidence/large-presses.md.

The reference is an inverse Fourier transform of ``solve`` from 1 mHz on, over a period of 1000 s, of which the press
takes 20 s. It knows nothing of the recorder's library, whose frequencies are 1 Hz apart, nor of its exponentials.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass

import numpy as np
import scipy.fft
from scipy.interpolate import CubicSpline

import acoustic_fem
import geometry
from geometry.ground.typed import Array
from localize.contacts import Contact, ContactRecorder, covered_force
from localize.contacts.contact import surface_of
from localize.signals import response_of

RATE = 1000
"""Sample rate, Hz."""
PERIOD = 1000
"""Period of the reference, s."""
BEGIN, RISE, HOLD, AFTER = 0.2, 0.1, 10.0, 10.0
"""Begin of the press, its rise and fall, its hold, and what is recorded after it, s."""
FORCE = 5e-3
"""Force that is held, N."""
LEAKS = (0.0, 0.05, 0.1)
"""Diameters of the leak of every cavity, mm."""
CASES = (("array-2x6", "atlas", 5), ("line-2", "lumped", 18), ("fingertip-3x4", "lumped", 6))
"""Designs, the fidelity of library and reference, and the point that is pressed, from 1."""


@dataclass(frozen=True, eq=False)
class HeldPress:
    """Signals of a press that is held, as recorded and by the reference."""

    time: Array
    """Times; (n,) float64, s."""
    recorded: Array
    """Signals of the recorder; (n_microphone, n) float64, Pa."""
    reference: Array
    """Signals of the inverse transform; (n_microphone, n) float64, Pa."""
    force: float
    """Force that the membrane of the point takes while the press is held, N."""

    @property
    def largest(self) -> float:
        """Largest difference of all times by the largest pressure."""
        return float(np.abs(self.recorded - self.reference).max() / np.abs(self.reference).max())

    def error_at(self, time: float) -> tuple[float, float]:
        """Pressure of the reference at the first microphone, Pa, and the largest difference there by the pressure."""
        k = round(time * RATE)
        return float(self.reference[0, k]), float(np.abs(self.recorded[:, k] / self.reference[:, k] - 1).max())


def press(time: Array) -> Array:
    """Force of a press that rises and falls smoothly, as a fraction of the held one."""
    end = BEGIN + 2 * RISE + HOLD
    ramp = np.clip(np.minimum((time - BEGIN) / RISE, (end - time) / RISE), 0.0, 1.0)
    return np.asarray(np.sin(np.pi / 2 * ramp) ** 2)


def held_press(name: str, fidelity: str, point: int, leak: float, step: float = 1.0) -> HeldPress:
    """A press of one point, recorded from a library and by the reference.

    Args:
        name: of a prototype.
        fidelity: of the library and the reference.
        point: that is pressed, from 1.
        leak: diameter of the leak of every cavity, mm.
        step: of the library's frequencies, up to 200 Hz; Hz.
    """
    design = geometry.prototype(name).with_values({"resonator.leak_diameter": leak})
    library = acoustic_fem.solve(design, np.arange(step, 200.01, step), fidelity)
    time = np.arange(round((BEGIN + 2 * RISE + HOLD + AFTER) * RATE)) / RATE
    place, _ = surface_of(response_of(library))
    where = np.tile(place[point - 1], (len(time), 1))
    contact = Contact(time, where, FORCE * press(time), 0.1)
    recorded = ContactRecorder(library, RATE, microphone_noise=0.0, linear=True).take(contact).signals

    period = PERIOD * RATE
    slow = [np.arange(1, 2000) * 1e-3, np.arange(2, 20, 0.01), np.arange(20, 200.01, 0.1)]
    solved = acoustic_fem.solve(design, np.concatenate(slow), fidelity)
    spline = CubicSpline(solved.frequency, solved.force_response.values[point - 1], axis=-1)
    lines = scipy.fft.rfftfreq(period, 1 / RATE)
    response = np.zeros((len(library.transfer_function.microphone), len(lines)), np.complex128)
    solved_to = lines <= 200
    response[:, solved_to] = spline(np.maximum(lines[solved_to], lines[1]))
    response[:, 0] = response[:, 0].real
    force = covered_force(contact, library)[:, point - 1]
    reference = scipy.fft.irfft(response * scipy.fft.rfft(force, n=period), n=period)
    # The mean of a period is not known: before the press nothing is.
    reference -= reference[:, : round(BEGIN / 2 * RATE)].mean(axis=1, keepdims=True)
    return HeldPress(time, recorded, reference[:, : len(time)], float(force.max()))


def main() -> None:
    """Print the table."""
    warnings.filterwarnings("ignore", "entrance loss|membrane: |.*its library ends", UserWarning)
    times = (3.0, 9.0, 11.5, 20.0)
    columns = " | ".join(f"at {time:g} s (Pa; error, %)" for time in times)
    print(f"| design | fidelity | leak (mm) | largest error (% of the peak) | {columns} |")
    print("|---" * (4 + len(times)) + "|")
    for name, fidelity, point in CASES:
        for leak in LEAKS:
            found = held_press(name, fidelity, point, leak)
            cells = " | ".join(f"{value:.3g}; {100 * error:.2f}" for value, error in map(found.error_at, times))
            print(f"| `{name}` | {fidelity} | {leak:g} | {100 * found.largest:.3f} | {cells} |")


if __name__ == "__main__":
    main()
