"""Networks drawn at random, and one dense solve of every node of them, built from the plain closed forms."""

from __future__ import annotations

from dataclasses import fields

import numpy as np
from hypothesis import strategies as st

from acoustic_fem.batch.parameters import PART, ArrayParameters
from acoustic_fem.batch.topology import LineWiring, Topology
from acoustic_fem.cavity.closed_forms import closed_cylinder_compliance, closed_sphere_compliance
from acoustic_fem.duct.plane_wave import CompliantWall, port_admittance, two_port
from acoustic_fem.duct.sections import CircularSection
from acoustic_fem.duct.tube_opening import entrance_impedance

RANGES = {  # SI
    "tube_radius": (1e-4, 6e-4),
    "tube_length": (2e-3, 6e-2),
    "cavity_radius": (1e-3, 5e-3),
    "cavity_height": (8e-4, 6e-3),
    "port_height": (4e-4, 6e-4),
    "membrane_compliance": (1e-14, 1e-12),
    "membrane_loss": (0.01, 0.3),
    "membrane_slope": (0.3, 1.0),
    "membrane_reference": (0.05, 20.0),
    "membrane_relaxation": (0.01, 0.5),
    "membrane_relaxation_time": (1e-4, 1.0),
    "membrane_frequency": (1.5e3, 2e4),
    "leak_conductance": (1e-13, 1e-11),
    "floor_compliance": (1e-14, 1e-12),
    "sheath_compliance": (1e-14, 1e-12),
    **{
        f"{part}_{name}": bounds
        for part in ("floor", "sheath")
        for name, bounds in {
            "loss": (0.01, 0.3),
            "slope": (0.3, 1.0),
            "reference": (0.05, 20.0),
            "relaxation": (0.01, 0.5),
            "relaxation_time": (1e-4, 1.0),
        }.items()
    },
    "chamber_radius": (5e-4, 2e-3),
    "chamber_height": (4e-4, 3e-3),
    "hole_radius": (1.5e-4, 4e-4),
    "hole_length": (1e-4, 1e-3),
    "diaphragm_compliance": (1e-16, 5e-15),
    "back_volume": (5e-10, 1e-8),
    "vent_admittance": (1e-13, 1e-11),
}


@st.composite
def topologies(draw, most_points=4):
    """Connected wirings of 2 to 4 microphones, every part with numbers of its own; two lines may share both ends."""
    count = draw(st.integers(2, 4))
    pairs = [(draw(st.integers(0, node - 1)), node) for node in range(1, count)]
    more = st.tuples(st.integers(0, count - 1), st.integers(0, count - 1)).filter(lambda pair: pair[0] != pair[1])
    pairs += draw(st.lists(more, max_size=2))
    lines = []
    for first, last in pairs:
        points = draw(st.integers(1, most_points))
        lines.append(LineWiring(first, last, (0,) * (points + 1), (0,) * points))
    return Topology((0,) * count, tuple(lines), ("tube",)).individual()


def column_counts(topology):
    return {
        "tube": 1 + max(k for line in topology.lines for k in line.tubes),
        "point": 1 + max(k for line in topology.lines for k in line.points),
        "microphone": 1 + max(topology.microphones),
    }


def random_parameters(topology, seed, designs=1, modes=3):
    """Parameters spread evenly in their logarithms."""
    generator = np.random.default_rng(seed)
    columns = column_counts(topology)

    def draw(name, *shape):
        low, high = np.log(RANGES[name])
        return np.exp(generator.uniform(low, high, shape))

    values = {
        field.name: draw(field.name, designs, columns[PART[field.name]])
        for field in fields(ArrayParameters)
        if field.name not in ("membrane_fraction", "membrane_frequency", "port_height")
    }
    for part in ("membrane", "floor", "sheath"):
        for name in (f"{part}_relaxation", f"{part}_relaxation_time"):
            values[name] = draw(name, designs, columns[PART[name]], 2)
    shape = (designs, columns["point"], modes)
    values["membrane_fraction"] = generator.dirichlet(np.ones(modes), shape[:2])
    values["membrane_frequency"] = np.sort(draw("membrane_frequency", *shape), axis=-1)
    values["port_height"] = draw("port_height", designs, columns["point"])
    return ArrayParameters(**values)


def _modulus(p, part, column, frequency):
    """Complex modulus of a soft part by the stated one: a spring-pot of any slope beside relaxations."""
    loss = p[f"{part}_loss"][column]
    exponent = p[f"{part}_slope"][column] * 2 / np.pi * np.arctan(loss)
    pot = (1 + 1j * loss) * (frequency / p[f"{part}_reference"][column]) ** exponent
    rate = 2j * np.pi * frequency[:, None] * p[f"{part}_relaxation_time"][column]
    return pot + (p[f"{part}_relaxation"][column] * rate / (1 + rate)).sum(-1)


def every_node_at_once(parameters, topology, frequency, medium, cut=None):
    """Impedance between all points and all microphone openings, (n_freq, n, n), points first.

    Args:
        cut: where each tube is cut into two ducts, as a fraction of its length; None: not cut.
    """
    p = {field.name: getattr(parameters, field.name)[0] for field in fields(parameters)}
    rate = 2j * np.pi * frequency
    entries, names = [], {}

    def node(*name):
        return names.setdefault(name, len(names))

    def series(first, last, admittance):
        entries.append(([first, last], admittance[:, None, None] * np.array([[1, -1], [-1, 1]])))

    for number, line in enumerate(topology.lines):
        cavities = [node("point", number, place) for place in range(len(line.points))]
        cavities = [node("chamber", line.first), *cavities, node("chamber", line.last)]
        for place, column in enumerate(line.points):
            cavity = closed_cylinder_compliance(
                p["cavity_radius"][column], p["cavity_height"][column], frequency, medium
            )
            ratio = frequency / p["membrane_frequency"][column][:, None]
            modes = p["membrane_fraction"][column][:, None] / (_modulus(p, "membrane", column, frequency) - ratio**2)
            total = rate * (cavity + p["membrane_compliance"][column] * modes.sum(0))
            total = total + rate * p["floor_compliance"][column] / _modulus(p, "floor", column, frequency)
            total = total + p["leak_conductance"][column]
            entries.append(([cavities[place + 1]], total[:, None, None]))
        for place, column in enumerate(line.tubes):
            radius, length = p["tube_radius"][column], p["tube_length"][column]
            inner = [node("mouth", number, place, side) for side in (0, 1)]
            loss = 1 / entrance_impedance(radius, frequency, medium)
            series(cavities[place], inner[0], loss)
            series(inner[1], cavities[place + 1], loss)
            compliance = p["sheath_compliance"][column] / _modulus(p, "sheath", column, frequency)
            soft = CompliantWall(CircularSection(radius), compliance)
            line = soft.series_impedance(frequency, medium), soft.shunt_admittance(frequency, medium)
            if cut is None:
                entries.append((inner, two_port(*line, length)))
            else:
                middle = node("cut", number, place)
                entries.append(([inner[0], middle], two_port(*line, cut * length)))
                entries.append(([middle, inner[1]], two_port(*line, (1 - cut) * length)))
    for number, column in enumerate(topology.microphones):
        chamber, mouth, opening = (node(name, number) for name in ("chamber", "hole", "opening"))
        size = p["chamber_radius"][column], p["chamber_height"][column]
        entries.append(([chamber], (rate * closed_cylinder_compliance(*size, frequency, medium))[:, None, None]))
        series(chamber, mouth, 1 / entrance_impedance(p["hole_radius"][column], frequency, medium))
        hole = port_admittance(p["hole_radius"][column], p["hole_length"][column], frequency, medium)
        entries.append(([mouth, opening], hole))
        sphere = (3 * p["back_volume"][column] / (4 * np.pi)) ** (1 / 3)
        back = rate * closed_sphere_compliance(sphere, frequency, medium)
        front = rate * p["diaphragm_compliance"][column] + p["vent_admittance"][column]
        entries.append(([opening], (back * front / (back + front))[:, None, None]))

    nodal = np.zeros((len(frequency), len(names), len(names)), dtype=np.complex128)
    for nodes, matrix in entries:
        nodal[:, np.array(nodes)[:, None], nodes] += matrix
    outputs = [node("point", number, k) for number, line in enumerate(topology.lines) for k in range(len(line.points))]
    outputs += [node("opening", number) for number in range(len(topology.microphones))]
    return np.linalg.inv(nodal)[:, outputs][:, :, outputs]
