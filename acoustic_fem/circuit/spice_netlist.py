"""A sensor's circuit as a SPICE netlist: one subcircuit with named pins."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from acoustic_fem.circuit.closed_form_circuit import SensorCircuit
from acoustic_fem.circuit.passive_circuit import GROUND
from acoustic_fem.library.provenance import versions
from geometry.ground.whole_files import whole_file

#: Suffix of netlists.
NETLIST_FORMAT = ".cir"
_PINS_IN_A_LINE = 12


def subcircuit_name(sensor: SensorCircuit) -> str:
    """Name of the subcircuit: that of the design in letters, digits and underscores."""
    return _plain(sensor.design.name)


def pins(sensor: SensorCircuit) -> list[str]:
    """Pins of the subcircuit in their order: forces, cavities, pressures before the microphones, their outputs."""
    return [_plain(name) for name in (*sensor.forces, *sensor.cavities, *sensor.fronts, *sensor.outputs)]


def netlist(sensor: SensorCircuit) -> str:
    """Text of the netlist, which SPICE 3 and its successors read."""
    return "\n".join(_lines(sensor)) + "\n"


def save_netlist(sensor: SensorCircuit, path: Path) -> None:
    """Write the netlist; the file is whole or not there."""
    with whole_file(path) as beside:
        beside.write_text(netlist(sensor), encoding="utf-8")


def _lines(sensor: SensorCircuit) -> Iterator[str]:
    low, high = sensor.band
    points, microphones = sensor.design.point_count, sensor.design.microphones
    version = versions(None, ())["code_version"]
    yield f"* {_plain(sensor.design.name)}: tactile sensor as a circuit, by acoustic-fem {version}"
    yield "* 1 V is 1 Pa, 1 A is 1 mm^3/s; time is in seconds. All resistors, inductors and capacitors are positive."
    yield f"* Pins f1 to f{points}: force on the membrane of each point, 1 V is 1 N. Leave none open: connect it to 0."
    yield f"* Pins p1 to p{points}: pressure in the cavity of each point; a current that flows in is a volume velocity."
    yield f"* Pins front_...: pressure in front of microphone {', '.join(microphones)}."
    yield "* Pins out_...: its output, V, behind its vent."
    yield f"* Largest difference to the library from {low:g} to {high:g} Hz: {sensor.error:.2g} of each response."
    names = pins(sensor)
    yield f".subckt {subcircuit_name(sensor)}"
    for first in range(0, len(names), _PINS_IN_A_LINE):
        yield "+ " + " ".join(names[first : first + _PINS_IN_A_LINE])
    for number, element in enumerate(sensor.circuit.elements, 1):
        yield f"{element.kind}{number} {_plain(element.first)} {_plain(element.second)} {element.value:.12g}"
    for number, source in enumerate(sensor.circuit.sources, 1):
        ends = (source.first, source.second, *source.control)
        yield f"E{number} {' '.join(map(_plain, ends))} {source.gain:.12g}"
    yield ".ends"


def _plain(name: str) -> str:
    return name if name == GROUND else re.sub(r"\W", "_", name, flags=re.ASCII)
