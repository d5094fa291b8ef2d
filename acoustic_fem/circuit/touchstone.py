"""A sensor's circuit as a Touchstone file: the impedances between all cavities and microphones."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from acoustic_fem.circuit.closed_form_circuit import SensorCircuit
from acoustic_fem.library.provenance import versions
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.typed import Array, ComplexArray
from geometry.ground.whole_files import whole_file

#: Suffix of a Touchstone file of version 1, in which the number of ports stands.
_SUFFIX = re.compile(r"\.s(\d+)p", re.IGNORECASE)
_NUMBERS_IN_A_LINE = 4


def is_touchstone(path: Path) -> bool:
    """True if a name ends as those of Touchstone files do, such as ``.s14p``."""
    return _SUFFIX.fullmatch(path.suffix) is not None


def check_ports(path: Path, points: int, microphones: int) -> None:
    """Reject a name whose number of ports is not that of an array.

    Args:
        path: of the file.
        points: number of points.
        microphones: number of microphones.

    Raises:
        Refusal: another number.
    """
    found, count = _SUFFIX.fullmatch(path.suffix), points + microphones
    if found is None or int(found[1]) != count:
        allowed = f"a name that ends with .s{count}p, for {points} points and {microphones} microphones"
        raise Refusal(kind=Kind.MISMATCH, file=path, field=Field("out"), allowed=allowed)


def port_impedances(sensor: SensorCircuit, frequency: Array) -> ComplexArray:
    """Impedances between the ports, while no force acts on any membrane.

    Args:
        sensor: circuit of the sensor.
        frequency: (n_freq,) float64, Hz.

    Returns:
        (n_freq, n_port, n_port) complex128, Pa s/mm^3: pressure at the first port per volume velocity into the second.
        Ports are the cavities of the points, then the fronts of the microphones.
    """
    ports = [*sensor.cavities, *sensor.fronts]
    still = {name: np.zeros(len(ports), np.complex128) for name in sensor.forces}
    each = np.arange(len(ports))
    return sensor.circuit.voltages(np.asarray(frequency, np.float64), still, np.stack([each, each], axis=1), ports)


def save_touchstone(sensor: SensorCircuit, frequency: Array, path: Path) -> None:
    """Write the impedances between the ports of a sensor; the file is whole or not there.

    Args:
        sensor: circuit of the sensor.
        frequency: (n_freq,) float64, ascending, Hz.
        path: as of :func:`check_ports`.
    """
    check_ports(path, len(sensor.cavities), len(sensor.fronts))
    with whole_file(path) as beside:
        beside.write_text("\n".join(_lines(sensor, frequency)) + "\n", encoding="utf-8")


def _lines(sensor: SensorCircuit, frequency: Array) -> Iterator[str]:
    low, high = sensor.band
    yield f"! {_words(sensor.design.name)}: tactile sensor, by acoustic-fem {versions(None, ())['code_version']}"
    yield "! 1 V is 1 Pa, 1 A is 1 mm^3/s, so 1 ohm is 1 Pa s/mm^3; phasors exp(+j omega t)."
    yield f"! Largest difference to the library from {low:g} to {high:g} Hz: {sensor.error:.2g} of each response."
    ports = [*(f"cavity of point {point + 1}" for point in range(len(sensor.cavities)))]
    ports += [f"front of microphone {_words(name)}" for name in sensor.design.microphones]
    for number, name in enumerate(ports, 1):
        yield f"! Port[{number}] = {name}"
    yield "# HZ Z RI R 1"
    for f, matrix in zip(frequency, port_impedances(sensor, frequency), strict=True):
        # Version 1 has a line for each row of a matrix, but for two ports, fewer than any array has.
        for row, values in enumerate(matrix):
            for first in range(0, len(values), _NUMBERS_IN_A_LINE):
                part = " ".join(f"{value.real:.12g} {value.imag:.12g}" for value in values[first:][:_NUMBERS_IN_A_LINE])
                yield f"{f:.12g} {part}" if row == first == 0 else f" {part}"


def _words(name: str) -> str:
    """A name in printable ASCII, as the format asks."""
    return "".join(letter if letter.isascii() and letter.isprintable() else "?" for letter in name)
