"""Changes by the law of the rubber: ``python benchmarks/rubber.py`` writes the tables of docs/evidence/models.md."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import geometry
from geometry import ArrayDesign
from geometry.ground.whole_files import replace_section

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "models.md"
END = "<!-- end {name} -->"
BEGIN = "<!-- {name}: made by benchmarks/rubber.py -->"
GRID = np.geomspace(1, 100, 41)
HEAD = ["", "| {} | H, nearer / farther microphone (%) | ILD (dB) | IPD (°) |", "|---|---|---|---|"]
Complex = NDArray[np.complex128]


def transfer_function(design: ArrayDesign, **law: object) -> Complex:
    """Transfer functions of a design whose membranes follow another law, (n_point, n_microphone, n_freq)."""
    name = f"materials.{design.membrane.material}"
    changed = design.completed().with_values({f"{name}.{field}": value for field, value in law.items()})
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
        return acoustic_fem.solve(changed, GRID, "lumped").transfer_function.values


def largest_changes(new: Complex, old: Complex) -> str:
    """Cells of a table: of H at each point's loudest and second-loudest microphone at 10 Hz, of their ILD and IPD."""
    middle = np.abs(old[:, :, len(GRID) // 2])
    loudest = np.argsort(-middle, axis=1)[:, :2, None]
    new, old = (np.take_along_axis(values, loudest, axis=1) for values in (new, old))
    near, far = 100 * np.abs(new / old - 1).max((0, 2))
    between = new[:, 0] / new[:, 1] / (old[:, 0] / old[:, 1])
    level, phase = np.abs(20 * np.log10(np.abs(between))).max(), np.abs(np.degrees(np.angle(between))).max()
    return f"{near:.1f} / {far:.1f} | {level:.2f} | {phase:.1f}"


def main() -> None:
    """Write the tables."""
    rows = []
    for name in geometry.prototype_names():
        design = geometry.prototype(name)
        now, before = transfer_function(design), transfer_function(design, law="constant")
        rows.append(f"| `{name}` | {largest_changes(now, before)} |")
    _replace("prototypes", "prototype, modulus from its hardness, so at 0.1 Hz", rows)

    design = geometry.prototype("array-2x6")
    constant = transfer_function(design, law="constant")
    rows = []
    for frequency in (0.1, 1.0, 10.0, 100.0):
        now = transfer_function(design, modulus_frequency=frequency)
        rows.append(f"| right at {frequency:g} Hz | {largest_changes(now, constant)} |")
    rows += [
        f"| right at 0.1 Hz, loss factor {loss:g} | "
        f"{largest_changes(transfer_function(design, loss_factor=loss), transfer_function(design))} |"
        for loss in (0.05, 0.2)
    ]
    _replace("frequencies", "`array-2x6`, modulus", rows)


def _replace(name: str, first: str, rows: list[str]) -> None:
    lines = [line.format(first) for line in HEAD]
    replace_section(PAGE, BEGIN.format(name=name), END.format(name=name), [*lines, *rows, ""])


if __name__ == "__main__":
    main()
