"""Changes of H by single effects: ``python benchmarks/effects.py`` writes tables of docs/evidence/models.md."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from rubber import GRID, HEAD, Complex, largest_changes, transfer_function

import geometry
from acoustic_fem.quantities.local_air import design_air
from acoustic_fem.scatter import AsBuiltSensors, ScatteredDesign, Tolerance
from geometry import ArrayDesign
from geometry.ground.whole_files import replace_section

PAGE = Path(__file__).parents[1] / "docs" / "evidence" / "models.md"
END = "<!-- end {name} -->"
BEGIN = "<!-- {name}: made by benchmarks/effects.py -->"


def with_smooth_bores(design: ArrayDesign) -> ArrayDesign:
    """The design with round bores without grooves in all its tubes."""
    return design.with_values(dict.fromkeys(_bores(design), "smooth"))


def _bores(design: ArrayDesign) -> Iterator[str]:
    yield "tube.bore"
    if "microphone_tube" not in design.followers:
        yield "microphone_tube.bore"
    for index, line in enumerate(design.lines):
        yield from (f"lines.{index}.{name}.bore" for name in ("tube", "microphone_tube") if getattr(line, name))
    yield from (f"tube_kinds.{name}.bore" for name in design.tube_kinds)


#: Silicone that is stiff at the frequency in the middle of the band.
SILICONE = {
    "youngs_modulus": 1.0,
    "poisson_ratio": 0.49,
    "density": 1070.0,
    "loss_factor": 0.1,
    "modulus_frequency": 10.0,
    "source": "benchmarks/effects.py",
}


def with_oval_tubes(design: ArrayDesign, ovality: float) -> Complex:
    """Transfer functions where all tubes are oval by as much, (n_point, n_microphone, n_freq)."""
    scattered = ScatteredDesign(design, [Tolerance("ovality", ovality, "relative", "benchmarks/effects.py")])
    draws = {name: np.ones_like(values) for name, values in scattered.draws(0, 1, 0).items()}
    return AsBuiltSensors(scattered, GRID, design_air(design)).transfer_functions(draws)[0]


def effects(design: ArrayDesign) -> Iterator[tuple[str, Complex, Complex]]:
    """Name of each effect, transfer functions with it and without it."""
    stated = transfer_function(design)

    def changed(values: dict[str, object]) -> Complex:
        return transfer_function(design.with_values({"materials.silicone": SILICONE, **values}))

    constant = transfer_function(design, law="constant")
    yield "causal law, modulus right at 0.1 Hz (default)", stated, constant
    yield "causal law, modulus right at 10 Hz", transfer_function(design, modulus_frequency=10.0), constant
    yield "bore of the spring (default)", stated, transfer_function(with_smooth_bores(design))
    yield "leak of 50 μm, 1 mm, in every cavity", changed({"resonator.leak_diameter": 0.05}), stated
    yield "all tubes 10 % oval", with_oval_tubes(design, 0.1), stated
    yield "all tubes 5 % oval", with_oval_tubes(design, 0.05), stated
    yield "floors of 1 mm, 1 MPa", changed({"resonator.floor_material": "silicone"}), stated
    yield "floors of 1 mm, photopolymer resin", changed({"resonator.floor_material": "photopolymer-resin"}), stated
    sheaths = ("tube.sheath_material", "microphone_tube.sheath_material")
    yield "sheaths of 1 MPa", changed(dict.fromkeys(sheaths, "silicone")), stated
    warm = design.with_values({"air.temperature": design.air.temperature + 10})
    yield "air 10 K warmer", transfer_function(warm), stated


def main() -> None:
    """Write the tables."""
    rows = [
        f"| {name} | {largest_changes(now, before)} |" for name, now, before in effects(geometry.prototype("array-2x6"))
    ]
    _replace("effects", "`array-2x6`", rows)
    rows = []
    for name in geometry.prototype_names():
        design = geometry.prototype(name)
        now, before = transfer_function(design), transfer_function(with_smooth_bores(design))
        rows.append(f"| `{name}` | {largest_changes(now, before)} |")
    _replace("bores", "prototype, bore of its springs for a smooth one", rows)


def _replace(name: str, first: str, rows: list[str]) -> None:
    lines = [line.format(first) for line in HEAD]
    replace_section(PAGE, BEGIN.format(name=name), END.format(name=name), [*lines, *rows, ""])


if __name__ == "__main__":
    main()
