"""A circuit of resistors, inductors, capacitors and controlled voltages, solved at single frequencies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray
from scipy.sparse.linalg import splu

from acoustic_fem.circuit.passive_fits import Relaxations
from geometry.ground.typed import Array, ComplexArray

#: Numbers of nodes.
Nodes = NDArray[np.int64]
#: Node that all voltages are measured from.
GROUND = "0"


@dataclass(frozen=True)
class Element:
    """Two-pole between two nodes."""

    kind: str
    """R, L or C."""
    first: str
    """One node."""
    second: str
    """The other node."""
    value: float
    """Resistance, inductance or capacitance, above 0."""


@dataclass(frozen=True)
class ControlledVoltage:
    """Voltage between two nodes that follows the voltage between two others; nothing flows between these."""

    first: str
    """Node that is the higher by the voltage."""
    second: str
    """The other node."""
    control: tuple[str, str]
    """Nodes between which the controlling voltage lies."""
    gain: float
    """Voltage per controlling voltage."""


@dataclass
class Circuit:
    """Elements between named nodes."""

    elements: list[Element] = field(default_factory=list)
    """Passive elements."""
    sources: list[ControlledVoltage] = field(default_factory=list)
    """Controlled voltages."""
    _count: int = 0

    def node(self) -> str:
        """Name of a new node."""
        self._count += 1
        return f"n{self._count}"

    def add(self, kind: str, first: str, second: str, value: float) -> None:
        """A passive element; one of no resistance, inductance or capacitance is not allowed."""
        self.elements.append(Element(kind, first, second, value))

    def series(self, first: str, second: str, impedance: Relaxations, scale: float) -> None:
        """Impedance that rises with frequency: resistor, inductor, and pairs of both side by side.

        Args:
            first: one node.
            second: the other node.
            impedance: as of :func:`acoustic_fem.circuit.passive_fits.fit_rising`.
            scale: factor of the impedance.
        """
        parts = [("R", impedance.constant * scale), ("L", impedance.reactive * scale)]
        steps: list[list[tuple[str, float]]] = [[part] for part in parts if part[1] > 0]
        for weight, rate in zip(impedance.weight * scale, impedance.rate, strict=True):
            steps.append([("R", weight), ("L", weight / rate)])
        self._chain(first, second, steps)

    def membrane(self, first: str, second: str, impedance: Relaxations, scale: float) -> None:
        """Impedance of rubber: capacitor, pairs of resistor and capacitor side by side, and inductor, in series.

        Arguments as :meth:`series`, with an impedance of :func:`acoustic_fem.circuit.passive_fits.fit_falling`.
        """
        steps: list[list[tuple[str, float]]] = []
        if impedance.elastic > 0:
            steps.append([("C", 1 / (impedance.elastic * scale))])
        for weight, rate in zip(impedance.weight * scale, impedance.rate, strict=True):
            steps.append([("R", weight / rate), ("C", 1 / weight)])
        if impedance.constant > 0:
            steps.append([("R", impedance.constant * scale)])
        if impedance.reactive > 0:
            steps.append([("L", impedance.reactive * scale)])
        self._chain(first, second, steps)

    def shunt(self, node: str, admittance: Relaxations, scale: float) -> None:
        """Admittance to ground that rises with frequency: capacitor, and resistors in series with capacitors.

        Args:
            node: the node.
            admittance: as of :func:`acoustic_fem.circuit.passive_fits.fit_rising`.
            scale: factor of the admittance.
        """
        if admittance.reactive > 0:
            self.add("C", node, GROUND, admittance.reactive * scale)
        if admittance.constant > 0:
            self.add("R", node, GROUND, 1 / (admittance.constant * scale))
        for weight, rate in zip(admittance.weight * scale, admittance.rate, strict=True):
            between = self.node()
            self.add("R", node, between, 1 / weight)
            self.add("C", between, GROUND, weight / rate)

    def _chain(self, first: str, second: str, steps: list[list[tuple[str, float]]]) -> None:
        at = first
        for number, step in enumerate(steps):
            following = second if number == len(steps) - 1 else self.node()
            for kind, value in step:
                self.add(kind, at, following, value)
            at = following

    def voltages(
        self, frequency: Array, held: Mapping[str, ComplexArray], currents: Array, at: list[str]
    ) -> ComplexArray:
        """Voltages of nodes for several excitations.

        Args:
            frequency: (n_freq,) float64, Hz.
            held: voltage of nodes that are held, by name, (n_excitation,) each.
            currents: rows (node number in ``at``, excitation) of unit currents into nodes, (m, 2) int.
            at: names of the nodes that are looked at.

        Returns:
            (n_freq, len(at), n_excitation) complex128.
        """
        names = {GROUND: -1}
        for element in self.elements:
            for name in (element.first, element.second):
                names.setdefault(name, len(names) - 1)
        for source in self.sources:
            for name in (source.first, source.second, *source.control):
                names.setdefault(name, len(names) - 1)
        nodes, excitations = len(names) - 1, len(next(iter(held.values()))) if held else int(currents[:, 1].max()) + 1
        size = nodes + len(self.sources) + len(held)
        kinds = np.array([element.kind for element in self.elements])
        ends = np.array([(names[element.first], names[element.second]) for element in self.elements], np.int64)
        values = np.array([element.value for element in self.elements])
        fixed = self._incidence(names, held, nodes)
        right = np.zeros((size, excitations), np.complex128)
        for row, voltage in enumerate(held.values()):
            right[nodes + len(self.sources) + row] = voltage
        for node, excitation in currents:
            right[names[at[node]], excitation] += 1.0
        looked = [names[name] for name in at]
        found = np.empty((len(frequency), len(at), excitations), np.complex128)
        for number, f in enumerate(frequency):
            s = 2j * np.pi * f
            admittance = np.where(kinds == "R", 1 / values, np.where(kinds == "C", s * values, 1 / (s * values)))
            rows, columns, entries = _stamped(ends, admittance)
            system = sp.csc_matrix((entries, (rows, columns)), shape=(size, size)) + fixed
            found[number] = splu(sp.csc_matrix(system)).solve(right)[looked]
        return found

    def _incidence(self, names: Mapping[str, int], held: Mapping[str, ComplexArray], nodes: int) -> sp.csc_matrix:
        """Rows and columns of the controlled and the held voltages."""
        entries: list[tuple[int, int, float]] = []
        for number, source in enumerate(self.sources):
            row = nodes + number
            for name, sign in ((source.first, 1.0), (source.second, -1.0)):
                entries += [(row, names[name], sign), (names[name], row, sign)]
            for name, sign in zip(source.control, (-source.gain, source.gain), strict=True):
                entries.append((row, names[name], sign))
        for number, name in enumerate(held):
            row = nodes + len(self.sources) + number
            entries += [(row, names[name], 1.0), (names[name], row, 1.0)]
        kept = [entry for entry in entries if entry[0] >= 0 and entry[1] >= 0]
        rows = np.array([entry[0] for entry in kept], np.int64)
        columns = np.array([entry[1] for entry in kept], np.int64)
        signs = np.array([entry[2] for entry in kept], np.complex128)
        size = nodes + len(self.sources) + len(held)
        return sp.csc_matrix((signs, (rows, columns)), shape=(size, size))


def _stamped(ends: Nodes, admittance: ComplexArray) -> tuple[Nodes, Nodes, ComplexArray]:
    """Rows, columns and entries of two-poles in a nodal matrix without the ground."""
    first, second = ends.T
    rows = np.concatenate([first, second, first, second])
    columns = np.concatenate([first, second, second, first])
    entries = np.concatenate([admittance, admittance, -admittance, -admittance])
    kept = (rows >= 0) & (columns >= 0)
    return rows[kept], columns[kept], entries[kept]
