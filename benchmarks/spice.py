"""Sensors in ngspice against their libraries: ``python -m benchmarks.spice`` prints the table of docs/formats.md.

ngspice reads the netlist that ``convert`` writes. Its small-signal analysis is compared with the library from 1 to
200 Hz, and its transient analysis of a burst with ``Library.simulate``.
"""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import acoustic_fem
from acoustic_fem import Library
from acoustic_fem.circuit import SensorCircuit, netlist, sensor_circuit
from acoustic_fem.circuit.spice_netlist import pins, subcircuit_name
from geometry.ground.typed import Array, ComplexArray

DESIGNS = ("array-2x6", "glove", "line-2")
"""Prototypes."""
FIDELITIES = ("lumped",)
"""Fidelities of their libraries; the circuit has the closed forms of lumped."""
FREQUENCIES = "1:200:200"
"""Frequencies of the libraries."""
POINTS = 2
"""Points of each design that are pressed, evenly spaced."""
RATE, SECONDS = 4000.0, 0.2
"""Sample rate and length of the transient, Hz and s."""
BURST = (40.0, 0.05, 0.15)
"""Frequency of the burst, Hz, and its begin and end, s."""
FORCE = 5e-3
"""Force of the burst, N."""
BURST_FORMULA = (
    "(time > {begin} && time < {end}) ? "
    "{force} * sin({pi} * (time - {begin}) / ({end} - {begin}))^2 * sin({turn} * (time - {begin})) : 0"
).format(force=FORCE, pi=np.pi, turn=2 * np.pi * BURST[0], begin=BURST[1], end=BURST[2])
"""The burst as ngspice takes it."""
LONGEST_STEP = 6.25e-5
"""Longest step of the transient analysis, s; steps of 0.25 ms are 3 % off."""


def missing() -> str | None:
    """Reason why nothing can be run here; None where ngspice is installed."""
    return None if shutil.which("ngspice") else "ngspice is not installed"


def pressed(library: Library) -> list[int]:
    """Points that are pressed, from 0."""
    count = library.transfer_function.sizes["point"]
    return [int(point) for point in np.linspace(0, count - 1, POINTS).round()]


@dataclass(frozen=True)
class Spice:
    """ngspice with one sensor."""

    sensor: SensorCircuit
    """The circuit."""

    def small_signal(self, points: list[int], frequency: Array) -> ComplexArray:
        """Pressures in front of the microphones per force, (len(points), n_microphone, n) complex128, Pa/N."""
        lines = [netlist(self.sensor)]
        measured = []
        for point in points:
            names = self._instance(f"x{point}", point, lines)
            lines.append(f"vf{point} {names[point]} 0 dc 0 ac 1")
            measured += [f"v({name})" for name in self._fronts(names)]
        found = []
        for f in frequency:
            found.append(f"ac lin 1 {f:.9g} {f:.9g}")
            found.append(f"wrdata OUT {' '.join(measured)}")
        rows = self._run(lines, found)
        values = rows[:, 1::3] + 1j * rows[:, 2::3]
        return values.reshape(len(frequency), len(points), -1).transpose(1, 2, 0)

    def transient(self, point: int, time: Array) -> Array:
        """Pressures in front of the microphones for the burst on one point, (n_microphone, n) float64, Pa.

        The force is a formula, not a list of samples: with a list, ngspice takes ten times as many steps and is 2.6e-3
        off on array-2x6, with shorter steps and by Gear's method too.
        """
        lines = [netlist(self.sensor)]
        names = self._instance("x1", point, lines)
        lines.append(f"bf {names[point]} 0 v = {BURST_FORMULA}")
        measured = " ".join(f"v({name})" for name in self._fronts(names))
        step = time[1] - time[0]
        control = [f"tran {step:.9g} {time[-1]:.9g} 0 {LONGEST_STEP:.9g}", f"wrdata OUT {measured}"]
        rows = self._run(lines, control)
        return np.stack([np.interp(time, rows[:, 0], rows[:, column]) for column in range(1, rows.shape[1], 2)])

    def _instance(self, name: str, point: int, lines: list[str]) -> list[str]:
        """A sensor of which one force is a node, and the others are 0; its pins."""
        forces = len(self.sensor.forces)
        own = [f"{name}_{pin}" for pin in pins(self.sensor)]
        connected = ["0" if k < forces and k != point else node for k, node in enumerate(own)]
        lines.append(f"{name}")
        lines += ["+ " + " ".join(connected[first : first + 12]) for first in range(0, len(connected), 12)]
        lines.append(f"+ {subcircuit_name(self.sensor)}")
        return own

    def _fronts(self, names: list[str]) -> list[str]:
        first = 2 * len(self.sensor.forces)
        return names[first : first + len(self.sensor.fronts)]

    def _run(self, lines: list[str], control: list[str]) -> Array:
        with tempfile.TemporaryDirectory() as folder:
            out, deck = Path(folder) / "out.txt", Path(folder) / "deck.cir"
            body = [line.replace("OUT", str(out)) for line in control]
            text = ["sensor", *lines, ".options reltol=1e-6", ".control", "set appendwrite", *body, "quit", ".endc"]
            deck.write_text("\n".join([*text, ".end"]) + "\n", encoding="utf-8")
            made = subprocess.run(["ngspice", "-b", str(deck)], capture_output=True, text=True, check=False)
            if not out.is_file():
                raise RuntimeError(made.stdout[-2000:] + made.stderr[-2000:])
            return np.loadtxt(out, ndmin=2)


def burst(time: Array) -> Array:
    """Force of a burst of a sine whose ends are smooth, N."""
    frequency, begin, end = BURST
    window = np.clip((time - begin) / (end - begin), 0, 1)
    return np.asarray(FORCE * np.sin(np.pi * window) ** 2 * np.sin(2 * np.pi * frequency * (time - begin)))


def compared(name: str, fidelity: str) -> tuple[int, float, float]:
    """Elements of a design's circuit, and the errors of its small-signal and its transient analysis.

    The first is relative to each response at each frequency, the second to the largest pressure.
    """
    library = acoustic_fem.solve(name, FREQUENCIES, fidelity)
    sensor = sensor_circuit(library)
    spice, points = Spice(sensor), pressed(library)
    chosen = np.unique(np.geomspace(1, 200, 12).round())
    expected = library.force_response.sel(frequency=chosen).values[points]
    small = float(np.abs(spice.small_signal(points, chosen) / expected - 1).max())
    time = np.arange(round(RATE * SECONDS)) / RATE
    force = np.zeros((len(sensor.forces), len(time)))
    force[points[1]] = burst(time)
    exact = library.simulate(force, RATE)
    moved = spice.transient(points[1], time)
    return len(sensor.circuit.elements), small, float(np.abs(moved - exact).max() / np.abs(exact).max())


def main() -> None:
    """Print the table."""
    print("| design | library | elements | small signal | transient |")
    print("|---|---|---|---|---|")
    for name in DESIGNS:
        for fidelity in FIDELITIES:
            elements, small, moved = compared(name, fidelity)
            print(f"| `{name}` | {fidelity} | {elements} | {small:.1e} | {moved:.1e} |", flush=True)


if __name__ == "__main__":
    main()
