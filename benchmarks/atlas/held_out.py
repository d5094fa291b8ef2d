"""Random designs that took no part in the making of the atlas, solved in 3-D: what its errors are measured on.

``python -m benchmarks.atlas.held_out`` solves their cells, which the cache of cells keeps: it goes on where it ended.
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

import geometry
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.quantities.local_air import design_air
from geometry import ArrayDesign
from geometry.air.cells import cell_catalogue
from geometry.layout.arrangement import lay_out
from geometry.refusal import Refusal

FIRST_SEED = 1900
COUNT = 40
#: Hz.
FREQUENCY = np.geomspace(1.0, 200.0, 24)
#: So many designs have the same microphones and air: their chambers are solved once.
_ALIKE = 4


def random_design(seed: int) -> ArrayDesign:
    """A line of 2 to 12 points with sizes, membranes and air drawn at random.

    Of four designs with the same microphones one has bores of two widths and two points, one has its ports out of the
    middle, and every other time one has corners.
    """
    common, random = _microphones(np.random.default_rng(seed // _ALIKE)), np.random.default_rng(seed)
    while True:
        try:
            return geometry.prototype("array-2x6").with_values({**common, **_line(random, seed, common)})
        except Refusal:
            continue


def _between(random: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(random.uniform(np.log(low), np.log(high))))


def _microphones(random: np.random.Generator) -> dict[str, Any]:
    """Microphones, their tubes and the air, as a wide array could have them."""
    while True:
        drawn = _drawn_microphones(random)
        wide = {"resonator.cavity_diameter": 10.0, "resonator.cavity_height": 5.0, "membrane.thickness": 1.0}
        try:
            geometry.prototype("array-2x6").with_values({**wide, **drawn})
        except Refusal:
            continue
        return drawn


def _drawn_microphones(random: np.random.Generator) -> dict[str, Any]:
    bore = _between(random, 0.2, 0.9)
    chamber = max(bore / random.uniform(0.17, 0.4), 1.2)
    return {
        "microphone_tube.inner_diameter": round(bore, 3),
        "microphone_tube.outer_diameter": round(bore + 0.3, 3),
        "microphone_tube.length": round(_between(random, 6.0, 30.0), 2),
        "microphone.chamber_diameter": round(chamber, 3),
        "microphone.chamber_height": round(chamber / 2 * float(random.uniform(0.9, 2.4)), 3),
        "microphone.sound_hole_diameter": round(chamber * float(random.uniform(0.14, 0.3)), 3),
        "air.temperature": round(float(random.uniform(0, 40)), 1),
        "air.pressure": round(float(random.uniform(7e4, 1.05e5))),
    }


def _line(random: np.random.Generator, seed: int, common: dict[str, Any]) -> dict[str, Any]:
    kind, other = seed % _ALIKE, common["microphone_tube.inner_diameter"]
    bore = round(other * random.uniform(0.5, 1.6), 3) if kind == 1 else other
    wide = 1.04 * max(bore, other)
    radius = _between(random, max(0.75, wide / 0.6), max(wide / 0.14, 1.0))
    height = _between(random, max(0.35 * radius, 1.7 * wide), min(2.2 * radius, 7 * wide))
    port = height / 2 if kind != 2 else float(random.uniform(max(0.2 * height, 0.65 * wide), 0.5 * height))
    points = 2 if kind == 1 else int(random.integers(2, 13))
    corners = kind == 3 and seed // _ALIKE % 2 == 0
    return {
        "name": f"held-out-{seed}",
        "lines.0.points": max(points, 4) if corners else points,
        "layout.columns": -(-max(points, 4) // 2) if corners else points,
        "resonator.cavity_diameter": round(2 * radius, 3),
        "resonator.cavity_height": round(height, 3),
        "resonator.port_height": round(port, 3),
        "membrane.thickness": round(2 * radius * _between(random, 0.05, 0.2), 3),
        "tube.inner_diameter": bore,
        "tube.outer_diameter": round(bore + 0.3, 3),
        "tube.length": round(_between(random, 6.0, 30.0), 2),
    }


def main() -> None:
    """Solve the cells of all held-out designs."""
    for seed in range(FIRST_SEED, FIRST_SEED + COUNT):
        design = random_design(seed)
        cells = cell_catalogue(design, lay_out(design)).distinct
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
            try:
                solved = solve_cells(cells, FREQUENCY, design_air(design))
            except Refusal as error:
                print(f"{seed}: {error}", flush=True)
                continue
        print(seed, *(f"{s.seconds:.1f} s {s.mesh_error:.1e}; " for s in solved.values()), flush=True)


if __name__ == "__main__":
    main()
