"""The table of the atlas from its solved samples: least squares, and what leaving one cell out changes.

``python -m benchmarks.atlas.fitting FOLDER`` writes acoustic_fem/atlas/cell_atlas.json, its errors taken over from the
table that is there until ``benchmarks.atlas.certify`` measures them.
"""

from __future__ import annotations

import json
import sys
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import cached_property
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import acoustic_fem.atlas
from acoustic_fem.atlas.polynomial import layer_number
from acoustic_fem.cell.lumped import lumped_admittance
from acoustic_fem.duct.tube_opening import INERTANCE, RESISTANCE
from benchmarks.atlas.samples import FREQUENCY, MEDIUM, SEEDS
from geometry.air.cells import Cell
from geometry.schema.ports import CellPort

#: What meshes lack, over s^2.
Bias = Callable[[NDArray[np.float64]], NDArray[np.complex128]]

TABLE = Path(acoustic_fem.atlas.__file__).with_name("cell_atlas.json")
#: Powers of a/R, of the sum and of the product of a by the distances to floor and ceiling.
POWERS = {
    "resonator": [(i, j, k) for i in range(4) for j in range(4) for k in range(2) if i + j + 2 * k <= 3],
    "microphone": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (2, 0, 0), (1, 1, 0), (0, 2, 0)],
}
LAYERS = 4
STORAGE_LAYERS = 5
#: Impedance of a stub with its opening in mu / a^3, at a shear number s: what errors are relative to.
BARE = (11.5, 0.5)
#: Mesh error of the scales compared, by their difference: the error falls with the third power.
COARSE, FINE = 0.85, 0.7
_TO_ZERO = 1 + 1 / ((COARSE / FINE) ** 3 - 1)

BOUNDS = {
    "resonator": {
        "bore by cavity diameter": (0.04, 0.31),
        "bore radius by height of its axis above the floor": (0.06, 0.85),
        "bore radius by distance of its axis from the ceiling": (0.06, 0.52),
        "cavity height by radius": (0.3, 2.3),
        "shear number a sqrt(w/nu) at the highest frequency": (0.0, 5.0),
    },
    "microphone": {
        "bore by cavity diameter": (0.12, 0.42),
        "bore radius by height of its axis above the floor": (0.1, 0.56),
        "bore radius by distance of its axis from the ceiling": (0.1, 0.56),
        "cavity height by radius": (0.7, 3.0),
        "sound hole by chamber diameter": (0.03, 0.6),
        "shear number a sqrt(w/nu) at the highest frequency": (0.0, 5.0),
    },
}


@dataclass(frozen=True, eq=False)
class Solved:
    """A sample and its admittance."""

    name: str
    cell: Cell
    admittance: NDArray[np.complex128]

    @cached_property
    def excess(self) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        """3-D minus the closed form: to the impedances beside the common one, and to the whole admittance."""
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
            lumped = lumped_admittance(self.cell, FREQUENCY, MEDIUM)
        (apart, sums), (lumped_apart, lumped_sums) = _split(self.admittance), _split(lumped)
        return apart - lumped_apart, sums - lumped_sums

    def sizes(self, port: int) -> tuple[float, tuple[float, float, float], NDArray[np.float64]]:
        """Radius of a bore in m, a by R and by the distances to floor and ceiling, s^2."""
        a, height = self.cell.ports[port].bore_diameter / 2, self.cell.height_of(self.cell.ports[port])
        square = 2 * np.pi * FREQUENCY * (1e-3 * a) ** 2 / MEDIUM.kinematic_viscosity
        return 1e-3 * a, (2 * a / self.cell.diameter, a / height, a / (self.cell.height - height)), square

    def opening(self, port: int) -> NDArray[np.complex128]:
        """Impedance of an opening in mu / a^3, without the part shared with the other tube or the sound hole."""
        apart, _ = self.excess
        shared = apart[:, 0, 1]
        a, _, square = self.sizes(port)
        return (apart[:, port, port] - shared) * a**3 / MEDIUM.viscosity + RESISTANCE + 1j * square * INERTANCE


def _split(nodal: NDArray[np.complex128]) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    sums = nodal.sum((1, 2))
    return np.linalg.inv(nodal) - 1 / sums[:, None, None], sums


def read(folder: Path) -> dict[str, Solved]:
    """The samples of a folder."""
    found = {}
    for path in sorted(folder.glob("*.json")):
        plain = json.loads(path.read_text())
        ports = tuple(CellPort(**port) for port in plain["cell"].pop("ports"))
        admittance = np.array(plain["real"]) + 1j * np.array(plain["imag"])
        found[path.stem] = Solved(path.stem, Cell(**plain["cell"], ports=ports), admittance)
    return found


def _columns(ratios: Sequence[float], powers: Sequence[Sequence[int]], layer: NDArray[np.float64], count: int) -> Any:
    terms = [np.prod([x**p for x, p in zip(ratios, each, strict=True)]) for each in powers]
    return np.stack([term * layer**n for term in terms for n in range(count)], -1)


def _least_squares(matrix: NDArray[np.float64], values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Least squares in which a value far off counts little: a mesh may be worse than others."""
    size = np.linalg.norm(matrix, axis=0)
    weight = np.ones(len(values))
    found = np.zeros(matrix.shape[1])
    for _ in range(6):
        scaled = matrix / size * weight[:, None]
        system = scaled.T @ scaled + 1e-9 * np.eye(len(size))
        found = np.linalg.solve(system, scaled.T @ (values * weight)) / size
        off = np.abs(values - matrix @ found)
        weight = np.sqrt(1 / np.maximum(1.0, off / (2 * np.median(off) + 1e-12)))
    return found


@dataclass(frozen=True, eq=False)
class _Port:
    cell: str
    ratios: tuple[float, float, float]
    square: NDArray[np.float64]
    value: NDArray[np.complex128]


def _ports(house: str, samples: dict[str, Solved], bias: Bias) -> list[_Port]:
    found = []
    for name, sample in samples.items():
        if not name.startswith(house) or name.endswith("fine"):
            continue
        for port in range(len(sample.cell.ports)):
            _, (by_radius, by_floor, by_ceiling), square = sample.sizes(port)
            ratios = (by_radius, by_floor + by_ceiling, by_floor * by_ceiling)
            found.append(_Port(name, ratios, square, sample.opening(port) + bias(square)))
    return found


def _fit(ports: Sequence[_Port], powers: Any, count: int) -> tuple[Any, Any]:
    """Coefficients of resistance and inertance."""
    matrices, real, imag = [], [], []
    weights = [1 / (BARE[0] + BARE[1] * port.square) for port in ports]
    for port, weight in zip(ports, weights, strict=True):
        columns = _columns(port.ratios, powers, layer_number(port.square), count)
        matrices.append((columns * weight[:, None], columns * (weight * port.square)[:, None]))
        real.append(port.value.real * weight)
        imag.append(port.value.imag * weight)
    return (
        _least_squares(np.vstack([each[0] for each in matrices]), np.concatenate(real)),
        _least_squares(np.vstack([each[1] for each in matrices]), np.concatenate(imag)),
    )


def _value(port: _Port, powers: Any, count: int, fitted: tuple[Any, Any]) -> NDArray[np.complex128]:
    columns = _columns(port.ratios, powers, layer_number(port.square), count)
    return columns @ fitted[0] + 1j * port.square * (columns @ fitted[1])


def mesh_bias(house: str, samples: dict[str, Solved]) -> tuple[Bias, float]:
    """Mesh error of the samples over s^2, and its scatter as a fraction of a stub's impedance."""
    pairs = []
    for name, fine in samples.items():
        if name.startswith(house) and name.endswith("-fine"):
            coarse = samples[name.removesuffix("-fine")]
            for port in range(len(fine.cell.ports)):
                lacking = _TO_ZERO * (fine.opening(port) - coarse.opening(port))
                pairs.append(_Port(name, (0.0, 0.0, 0.0), fine.sizes(port)[2], lacking))
    powers = [(0, 0, 0)]
    fitted = _fit(pairs, powers, LAYERS)
    scatter = max(
        float(np.max(np.abs(_value(each, powers, LAYERS, fitted) - each.value) / (BARE[0] + BARE[1] * each.square)))
        for each in pairs
    )

    def bias(square: NDArray[np.float64]) -> Any:
        return _value(_Port("", (0.0, 0.0, 0.0), square, square.astype(np.complex128)), powers, LAYERS, fitted)

    return bias, scatter


def _storage(samples: dict[str, Solved]) -> dict[str, Any]:
    """Polynomials of the compliance of an opening, from the samples whose thermal field was solved on fine meshes."""
    matrices, values = [], []
    for name, sample in samples.items():
        if not name.endswith("-fine"):
            continue
        total = sample.excess[1] / (2j * np.pi * FREQUENCY) * MEDIUM.pressure
        rows: Any = 0.0
        bores = [port.bore_diameter for port in sample.cell.ports]
        if sample.cell.opening_length > 0:
            bores.append(sample.cell.opening_diameter)  # the sound hole opens into the chamber, too
        scale = sum((5e-4 * bore) ** 3 for bore in bores)
        for bore in bores:
            a = 5e-4 * bore
            layer = layer_number(2 * np.pi * FREQUENCY * a**2 / MEDIUM.kinematic_viscosity) ** 0.5
            ratio = (bore / sample.cell.diameter,)
            rows = rows + _columns(ratio, [(0,), (1,)], layer, STORAGE_LAYERS) * (a**3 / scale)
        matrices.append(rows)
        values.append(total / scale)
    matrix, value = np.vstack(matrices), np.concatenate(values)
    real, imag = (_least_squares(matrix, part).reshape(2, -1).tolist() for part in (value.real, value.imag))
    return {"powers": [[0], [1]], "real": real, "imag": imag}


def _inertances(samples: dict[str, Solved], pairs: Sequence[tuple[int, int]]) -> list[list[float]]:
    """Inertance in rho / R that the openings share with each other or with the membrane, from mid frequencies."""
    rows, values = [], []
    for name, sample in samples.items():
        if not name.startswith("resonator") or name.endswith("fine"):
            continue
        cell = sample.cell
        unit = MEDIUM.density / (5e-4 * cell.diameter)
        part = np.mean([sample.excess[0][:, one, other] for one, other in pairs], 0)
        values.append(float(np.mean((part.imag / (2 * np.pi * FREQUENCY * unit))[3:12])))
        flatness, place = cell.diameter / 2 / cell.height, cell.port_height / cell.height - 0.5
        rows.append([flatness**m * place**n for m in range(3) for n in range(2)])
    return _least_squares(np.array(rows), np.array(values)).reshape(3, 2).tolist()


def fitted_table(samples: dict[str, Solved]) -> dict[str, Any]:
    """The table as plain values, without its errors on held-out designs."""
    openings, left_out = {}, {}
    for house, powers in POWERS.items():
        bias, scatter = mesh_bias(house, samples)
        ports = _ports(house, samples, bias)
        fitted = _fit(ports, powers, LAYERS)
        real, imag = (part.reshape(len(powers), LAYERS) for part in fitted)
        openings[house] = {"powers": [list(each) for each in powers], "real": real.tolist(), "imag": imag.tolist()}
        off = []
        for cell in dict.fromkeys(port.cell for port in ports):
            rest = _fit([port for port in ports if port.cell != cell], powers, LAYERS)
            for port in ports:
                if port.cell == cell:
                    gap = np.abs(_value(port, powers, LAYERS, rest) - port.value)
                    off.append(float(np.max(gap / (BARE[0] + BARE[1] * port.square))))
        left_out[f"{house}, one cell left out"] = max(off)
        left_out[f"{house}, one cell left out, median"] = float(np.median(off))
        left_out[f"{house}, scatter of the mesh error"] = scatter
    return {
        "bounds": BOUNDS,
        "openings": openings,
        "storage": _storage(samples),
        "passage": _inertances(samples, [(0, 1)]),
        "to_membrane": _inertances(samples, [(0, 2), (1, 2)]),
        "errors": left_out,
        "provenance": {
            "made": datetime.now(UTC).isoformat(timespec="seconds"),
            "samples": len(samples),
            "seeds": list(SEEDS),
            "scale of the meshes of the flow": COARSE,
            "scale of the finer meshes compared": FINE,
            **{name: version(name) for name in ("acoustic-fem", "gmsh", "scikit-fem", "numpy", "scipy")},
        },
    }


def rounded(value: Any) -> Any:
    """Numbers with as many digits as count."""
    if isinstance(value, float):
        return float(f"{value:.9g}")
    if isinstance(value, dict):
        return {name: rounded(each) for name, each in value.items()}
    return [rounded(each) for each in value] if isinstance(value, list | tuple) else value


def write(table: dict[str, Any]) -> None:
    """The table into its file."""
    TABLE.write_text(json.dumps(rounded(table), indent=1) + "\n", encoding="utf-8")


def main(folder: Path) -> None:
    """Fit and write the table."""
    table, before = fitted_table(read(folder)), json.loads(TABLE.read_text())
    table["errors"] = before["errors"] | table["errors"]
    table["provenance"]["held-out designs"] = before["provenance"]["held-out designs"]
    write(table)
    for name, value in table["errors"].items():
        print(f"{name}: {value:.1e}")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
