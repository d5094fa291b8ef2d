"""The sensor as a passive circuit of resistors, inductors and capacitors, by the closed forms of its design.

A voltage of 1 V is a pressure of 1 Pa, and a current of 1 A a volume velocity of 1 mm^3/s. Tubes are ladders of equal
sections, each with the series impedance and the shunt admittance of its length; air in cavities, membranes, openings
and microphones follow as in :mod:`acoustic_fem.network`. A force on a membrane is a voltage in series with it, because
its volume per force and its compliance soften by the same modulus.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

import acoustic_fem
from acoustic_fem.cavity.closed_forms import closed_cylinder_compliance
from acoustic_fem.cavity.shaped import shaped_cavity_compliance
from acoustic_fem.circuit.passive_circuit import GROUND, Circuit, ControlledVoltage
from acoustic_fem.circuit.passive_fits import Relaxations, fit_falling, fit_grid, fit_rising
from acoustic_fem.circuit.state_space import STATED_AT
from acoustic_fem.duct.plane_wave import CompliantWall, Line, two_port
from acoustic_fem.duct.sections import CircularSection
from acoustic_fem.duct.tube_opening import entrance_impedance
from acoustic_fem.library.transfer_functions import Library
from acoustic_fem.membrane.disc import DiscSolution
from acoustic_fem.membrane.rubber import Rubber
from acoustic_fem.network.microphone import circuit_elements, response
from acoustic_fem.network.yielding import design_leak, floor_compliance, sheath_compliance, soft_rubber
from acoustic_fem.quantities.checks import FrequencyLike
from acoustic_fem.quantities.local_air import AirLike
from acoustic_fem.quantities.medium import Medium
from acoustic_fem.quantities.units import metres
from geometry.air.cells import Cell, CellPort, cell_catalogue
from geometry.design.array_design import ArrayDesign
from geometry.ground.typed import Array, ComplexArray
from geometry.layout.arrangement import place_housings
from geometry.schema.part_fields import Tube

#: Volume velocity of 1 A, m^3/s.
AMPERE = 1e-9
#: Lowest frequency at which elements are fitted, Hz, and the highest one by the top of the library.
FITTED_FROM, FITTED_TO = 1e-3, 1.5
#: Error that a ladder may have in the admittances of a tube up to the top of the band.
LADDER_ERROR = 2e-4
#: Most sections of a ladder.
MOST_SECTIONS = 24
#: Time in which a sealed circuit loses its pressure, s: a resistor to ground, without which it has no state at rest.
DECAY = 1e8
_COMPARED = 24
#: Resistance by the characteristic one of the inductor and the capacitor behind a force, so that it does not ring.
_DAMPED = 0.01
#: Difference of a circuit to its library, relative to each response, from which there is a warning.
LARGEST_DIFFERENCE = 0.1


class CircuitWarning(UserWarning):
    """Warning of a circuit that differs from its library."""


@dataclass(frozen=True, eq=False)
class SensorCircuit:
    """Circuit of a sensor with named nodes."""

    circuit: Circuit
    """Elements."""
    design: ArrayDesign
    """The array."""
    medium: Medium
    """The air."""
    band: tuple[float, float]
    """Band of the comparison with the library, Hz."""
    error: float
    """Largest difference to the library over the band, pressure in front of each microphone per force, relative to the
    magnitude of each response at each frequency."""

    @property
    def forces(self) -> tuple[str, ...]:
        """Nodes of the forces on the points, V for N."""
        return tuple(f"f{point + 1}" for point in range(self.design.point_count))

    @property
    def cavities(self) -> tuple[str, ...]:
        """Nodes of the cavities under the points: V for Pa, and A for mm^3/s that flow in."""
        return tuple(f"p{point + 1}" for point in range(self.design.point_count))

    @property
    def fronts(self) -> tuple[str, ...]:
        """Nodes in front of the microphones, V for Pa."""
        return tuple(f"front_{name}" for name in self.design.microphones)

    @property
    def outputs(self) -> tuple[str, ...]:
        """Nodes of the microphones' outputs, V."""
        return tuple(f"out_{name}" for name in self.design.microphones)

    def at(self, frequency: Array) -> tuple[ComplexArray, ComplexArray]:
        """Pressures in front of the microphones per force, Pa/N, and their voltages, V/N.

        Args:
            frequency: (n,) float64, Hz.

        Returns:
            Two of (n_point, n_microphone, n) complex128.
        """
        return _per_force(self.circuit, self, np.asarray(frequency, np.float64))


def sensor_circuit(library: Library) -> SensorCircuit:
    """Circuit of the design of a library, in its air, and its difference to the library.

    A difference above :data:`LARGEST_DIFFERENCE`, as of a library that was measured, gives a :class:`CircuitWarning`.

    Raises:
        Refusal: a design whose cells have no closed forms.
    """
    made = _Builder(library.design, library.medium, float(library.frequency[-1])).built()
    low, high = float(library.frequency[0]), float(library.frequency[-1])
    chosen = np.unique(
        np.searchsorted(library.frequency, np.geomspace(low, high, _COMPARED)).clip(max=len(library.frequency) - 1)
    )
    grid = library.frequency[chosen]
    found = SensorCircuit(made, library.design, library.medium, (low, high), np.nan)
    pressure, _ = found.at(grid)
    exact = library.force_response.transpose("point", "microphone", "frequency").values[..., chosen]
    error = float(np.abs(pressure / exact - 1).max())
    if error > LARGEST_DIFFERENCE:
        warnings.warn(
            f"the circuit differs from the library by up to {100 * error:.0f} % from {low:g} to {high:g} Hz, because "
            "it is that of the design by closed forms; a state space follows the library itself",
            CircuitWarning,
            stacklevel=2,
        )
    return SensorCircuit(made, library.design, library.medium, (low, high), error)


def _per_force(circuit: Circuit, names: SensorCircuit, frequency: Array) -> tuple[ComplexArray, ComplexArray]:
    points = len(names.forces)
    held = {name: np.eye(points, dtype=np.complex128)[row] for row, name in enumerate(names.forces)}
    looked = [*names.fronts, *names.outputs]
    found = circuit.voltages(frequency, held, np.empty((0, 2), int), looked).transpose(2, 1, 0)
    microphones = len(names.fronts)
    return found[:, :microphones], found[:, microphones:]


@dataclass(frozen=True)
class _SoftTube(Line):
    """Tube whose sheath yields by the law of its rubber."""

    rigid: Line
    softness: float
    rubber: Rubber

    def series_impedance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """As of the rigid tube, shape of frequency (Hz), complex128, Pa s/m^4."""
        return self.rigid.series_impedance(frequency, air)

    def shunt_admittance(self, frequency: FrequencyLike, air: AirLike) -> ComplexArray:
        """With the compliance of the sheath, shape of frequency (Hz), complex128, m^2/(Pa s)."""
        soft = CompliantWall(self.rigid, self.softness / self.rubber.ratio(frequency))
        return soft.shunt_admittance(frequency, air)


@dataclass
class _Builder:
    """Circuit of one design."""

    design: ArrayDesign
    medium: Medium
    top: float

    def built(self) -> Circuit:
        self.circuit = Circuit()
        self._known: dict[object, Relaxations] = {}
        layout = place_housings(self.design)
        catalogue = cell_catalogue(self.design, layout)
        ends: dict[tuple[int, int], tuple[str, float, float]] = {}
        for housing, use in zip(layout.microphones, catalogue.microphones, strict=True):
            chamber = self._microphone(housing.name, use.cell)
            for port, own in zip(housing.ports, use.order, strict=True):
                ends[port.line, port.end] = self._mouth(chamber, use.cell, use.cell.ports[own])
        point = 0
        for index, line in enumerate(self.design.lines):
            at = ends[index, 0]
            for tube in self.design.tubes_of(line)[:-1]:
                use = catalogue.points[point]
                kind = self.design.of_kind(self.design.kinds[self.design.kind_of_point[point]])
                cavity = self._point(point, kind, use.cell)
                before, after = (self._mouth(cavity, use.cell, use.cell.ports[own]) for own in use.order)
                self._tube(tube, at, before)
                at, point = after, point + 1
            self._tube(self.design.tubes_of(line)[-1], at, ends[index, 1])
        return self.circuit

    @cached_property
    def _grid(self) -> Array:
        return fit_grid(FITTED_FROM, FITTED_TO * self.top)

    def _fit(self, key: object, fit: Callable[..., Relaxations], values: Callable[[], ComplexArray]) -> Relaxations:
        if key not in self._known:
            self._known[key] = fit(values(), self._grid)
        return self._known[key]

    def _air(self, cell: Cell) -> Relaxations:
        """Admittance of the air of a cavity; like that of all air, its relaxations are those of s C."""

        def admittance() -> ComplexArray:
            radius, height = metres(cell.diameter) / 2, metres(cell.height)
            if cell.shape is None:
                cavity = closed_cylinder_compliance(radius, height, self._grid, self.medium)
            else:
                cavity = shaped_cavity_compliance(cell.shape, radius, height, self._grid, self.medium)
            return np.asarray(2j * np.pi * self._grid * cavity)

        return self._fit(("air", cell.diameter, cell.height, cell.shape), fit_rising, admittance)

    def _mouth(self, cavity: str, cell: Cell, port: CellPort) -> tuple[str, float, float]:
        """Node where a tube ends at a cavity, behind the losses of its opening; its stub's length and radius, m."""
        radius = metres(port.bore_diameter) / 2
        mouth = self.circuit.node()
        self._opening(cavity, mouth, radius)
        return mouth, metres(cell.bore_of(port)), metres(port.stub_length)

    def _opening(self, cavity: str, mouth: str, radius: float) -> None:
        impedance = entrance_impedance(radius, np.array([1.0]), self.medium)[0]
        between = self.circuit.node()
        self.circuit.add("R", cavity, between, impedance.real * AMPERE)
        self.circuit.add("L", between, mouth, impedance.imag / (2 * np.pi) * AMPERE)

    def _point(self, point: int, design: ArrayDesign, cell: Cell) -> str:
        """Cavity, membrane, floor and leak of a point."""
        cavity, moved, kind = f"p{point + 1}", self.circuit.node(), design.resonator
        self.circuit.shunt(cavity, self._air(cell), 1 / AMPERE)
        disc, rubber = acoustic_fem.membrane.design_disc(design), acoustic_fem.membrane.design_rubber(design)
        omega = 2j * np.pi * self._grid
        key = self.design.kind_of_point[point]
        membrane = self._fit(("membrane", key), fit_falling, lambda: 1 / (omega * disc.compliance(self._grid, rubber)))
        self.circuit.membrane(cavity, moved, membrane, AMPERE)
        self._force(f"f{point + 1}", moved, disc, rubber)
        floor = floor_compliance(design)
        if floor > 0:
            soft = soft_rubber(design, kind.floor_material)
            yielding = self._fit(("floor", key), fit_falling, lambda: soft.ratio(self._grid) / (omega * floor))
            self.circuit.membrane(cavity, GROUND, yielding, AMPERE)
        leak = design_leak(design, self.medium)
        if leak > 0:
            self.circuit.add("R", cavity, GROUND, AMPERE / leak)
        self.circuit.add("R", cavity, GROUND, DECAY * AMPERE / disc.static_compliance)
        return cavity

    def _force(self, force: str, moved: str, disc: DiscSolution, rubber: Rubber) -> None:
        """Voltage in series with a membrane that a force on it makes.

        The volume per force and the compliance have the same modulus but not the same inertia. Their ratio rises with
        the square of frequency, as the voltage of a capacitor behind an inductor does.
        """
        at_top = disc.response(np.array([self.top]), rubber)
        gain = disc.volume_per_force / disc.static_compliance
        rise = float(np.real(at_top.volume_per_force / at_top.compliance)[0]) / gain - 1
        if rise <= 0:
            self.circuit.sources.append(ControlledVoltage(moved, GROUND, (force, GROUND), gain))
            return
        driven, behind = self.circuit.node(), self.circuit.node()
        corner = 2 * np.pi * self.top * np.sqrt(1 + 1 / rise)
        self.circuit.sources.append(ControlledVoltage(driven, GROUND, (force, GROUND), 1.0))
        self.circuit.add("R", driven, driven + "r", _DAMPED)
        self.circuit.add("L", driven + "r", behind, 1 / corner)
        self.circuit.add("C", behind, GROUND, 1 / corner)
        self.circuit.sources.append(ControlledVoltage(moved, GROUND, (behind, GROUND), gain))

    def _microphone(self, name: str, cell: Cell) -> str:
        """Chamber, sound hole and microphone; its front and its output are named nodes."""
        chamber, front, back = self.circuit.node(), f"front_{name}", f"back_{name}"
        self.circuit.shunt(chamber, self._air(cell), 1 / AMPERE)
        radius, length = metres(cell.opening_diameter) / 2, metres(cell.opening_length)
        mouth = self.circuit.node()
        self._opening(chamber, mouth, radius)
        self._ladder(("hole", radius, length), CircularSection(radius), length, mouth, front)
        microphone = self.design.microphone
        diaphragm, _, vent = circuit_elements(microphone, np.array([STATED_AT]), self.medium)
        behind = self._fit(
            "back",
            fit_rising,
            lambda: 2j * np.pi * self._grid * circuit_elements(microphone, self._grid, self.medium)[1],
        )
        self.circuit.add("C", front, back, diaphragm / AMPERE)
        self.circuit.add("R", front, back, AMPERE / vent)
        self.circuit.shunt(back, behind, 1 / AMPERE)
        stated = abs(response(microphone, np.array([STATED_AT]), self.medium)[0])
        gain = 10 ** (microphone.sensitivity / 20) / stated
        self.circuit.sources.append(ControlledVoltage(f"out_{name}", GROUND, (front, back), gain))
        return chamber

    def _tube(self, tube: Tube, first: tuple[str, float, float], last: tuple[str, float, float]) -> None:
        """Tube between two mouths, its stubs in the cells included."""
        length, radius = metres(tube.acoustic_length(self.design.printing.port_lip)), metres(tube.acoustic_diameter) / 2
        length += first[1] - first[2] + last[1] - last[2]
        line: Line = CircularSection(radius)
        if tube.sheath_material is not None:
            softness = sheath_compliance(self.design, tube)
            rubber = soft_rubber(self.design, tube.sheath_material)
            line = _SoftTube(line, softness, rubber)
        self._ladder(("tube", tube, length), line, length, first[0], last[0])

    def _ladder(self, key: object, line: Line, length: float, first: str, last: str) -> None:
        """Line as equal sections, half of whose series impedance lies on either side of its shunt admittance."""
        series = self._fit(("series", key), fit_rising, lambda: line.series_impedance(self._grid, self.medium))
        shunt = self._fit(("shunt", key), fit_rising, lambda: line.shunt_admittance(self._grid, self.medium))
        sections = self._sections(line, length)
        part, at = length / sections, first
        for number in range(sections):
            middle = self.circuit.node()
            self.circuit.series(at, middle, series, part * AMPERE * (0.5 if number == 0 else 1.0))
            self.circuit.shunt(middle, shunt, part / AMPERE)
            at = middle
        self.circuit.series(at, last, series, 0.5 * part * AMPERE)

    def _sections(self, line: Line, length: float) -> int:
        """Fewest sections with which a ladder of exact parts keeps its error at the top of the band."""
        top = np.array([self.top])
        series, shunt = line.series_impedance(top, self.medium)[0], line.shunt_admittance(top, self.medium)[0]
        exact = two_port(series, shunt, length)
        for sections in range(1, MOST_SECTIONS):
            half, across = series * length / sections / 2, shunt * length / sections
            section = np.array([[1 + half * across, half * (2 + half * across)], [across, 1 + half * across]])
            (a, b), (_, d) = np.linalg.matrix_power(section, sections)
            ladder = np.array([[d / b, -1 / b], [-1 / b, a / b]])
            if np.abs(ladder / exact - 1).max() < LADDER_ERROR:
                return sections
        return MOST_SECTIONS
