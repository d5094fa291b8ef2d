"""The errors of the atlas on designs that took no part in its making, and on a sweep; written into its table.

``python -m benchmarks.atlas.certify`` solves what the cache of cells lacks, prints tables of docs/evidence/models.md
and writes the errors into acoustic_fem/atlas/cell_atlas.json.
"""

from __future__ import annotations

import json
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from numpy.typing import NDArray

import acoustic_fem
import geometry
import studies
from acoustic_fem.atlas.cell_in_atlas import atlas_admittance, least_angle
from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.cell.lumped import lumped_admittance
from acoustic_fem.quantities.local_air import design_air
from benchmarks.atlas.fitting import TABLE, write
from benchmarks.atlas.held_out import COUNT, FIRST_SEED, FREQUENCY, random_design
from geometry import ArrayDesign
from geometry.air.cells import cell_catalogue
from geometry.design.design_file import write_design
from geometry.layout.arrangement import lay_out

#: Wide bores in small cavities, where closed forms alone are further off than the atlas states.
BASE = {
    "layout.columns": 12,
    **{f"{tube}.inner_diameter": 0.7 for tube in ("tube", "microphone_tube")},
    **{f"{tube}.outer_diameter": 1.3 for tube in ("tube", "microphone_tube")},
}
SWEPT = {
    "resonator.cavity_height": (2.0, 2.6),
    "resonator.cavity_diameter": (3.2, 4.2),
    "membrane.thickness": (0.4, 1.2),
    "tube.length": (9.0, 25.0),
}
CASES, LOOKED_AT = 10_000, 10
SWEEP_SEED = 2640
#: Smallest transfer function whose relative error counts, Pa/Pa.
HEARD = 1e-3


@dataclass(frozen=True)
class Errors:
    """Largest relative errors of one design."""

    cell: float
    """Of the bare admittances of its resonators, each entry against its row and column."""
    chamber: float
    """Of those of its microphones' chambers, sound holes included."""
    heard: float
    """Of the transfer functions of at least ``HEARD``."""
    per_log: float
    """Of all, by 1 + |ln |H||: an error of a tube counts as often as a sound passes it."""


def errors(design: ArrayDesign, fidelity: str) -> Errors:
    """Errors of a closed form against 3-D."""
    air = design_air(design)
    closed = lumped_admittance if fidelity == "lumped" else atlas_admittance
    bare = {"resonator": 0.0, "microphone": 0.0}
    for cell, solved in solve_cells(cell_catalogue(design, lay_out(design)).distinct, FREQUENCY, air).items():
        y = solved.admittance
        size = np.sqrt(np.abs(np.einsum("fii->fi", y)))
        gap = np.abs(closed(cell, FREQUENCY, air) - y) / (size[:, :, None] * size[:, None, :])
        bare[cell.kind] = max(bare[cell.kind], float(gap.max()))
    exact, found = (
        acoustic_fem.solve(design, FREQUENCY, name).transfer_function.values for name in ("navier-stokes", fidelity)
    )
    return Errors(bare["resonator"], bare["microphone"], *apart(exact, found))


def apart(exact: NDArray[np.complex128], found: NDArray[np.complex128]) -> tuple[float, float]:
    """Relative error of the transfer functions above a level, and of all divided by 1 + |ln |H||."""
    off, size = np.abs(found / exact - 1), np.abs(exact)
    return float(off[size >= HEARD].max()), float((off / (1 + np.abs(np.log(size)))).max())


def held_out() -> dict[int, dict[str, Errors]]:
    """Errors of every held-out design."""
    found = {}
    for seed in range(FIRST_SEED, FIRST_SEED + COUNT):
        design = random_design(seed)
        found[seed] = {fidelity: errors(design, fidelity) for fidelity in ("lumped", "atlas")}
        rows = ([f"{value:.1e}" for value in vars(each).values()] for each in found[seed].values())
        print(seed, *(" ".join(row) + " |" for row in rows), flush=True)
    return found


def swept() -> list[dict[str, tuple[float, float]]]:
    """Errors of random cases of a sweep at fidelity atlas."""
    parameters = "".join(f'"{name}" = {{ from = {low}, to = {high} }}\n' for name, (low, high) in SWEPT.items())
    text = (
        f'base = "line.toml"\nfidelity = "atlas"\nsampling = "sobol"\ncases = {CASES}\nseed = {SWEEP_SEED}\n'
        'metrics = ["ild_smallest"]\nkeep = "responses"\n'
        'frequency = "1:200:6"\n'
        f"[vary]\n{parameters}"
    )
    random = np.random.default_rng(SWEEP_SEED)
    found = []
    with TemporaryDirectory() as folder:
        (Path(folder) / "line.toml").write_text(write_design(geometry.prototype("array-2x6").with_values(BASE)))
        path = Path(folder) / "study.toml"
        path.write_text(text)
        study = studies.load_study(path)
        studies.run_sweep(study, Path(folder) / "results.zarr", workers=1)
        store = studies.open_sweep(Path(folder) / "results.zarr")
        for case in random.choice(CASES, LOOKED_AT, replace=False):
            design, row = store.design(int(case)), store.to_xarray().isel(case=int(case))
            values = row["transfer_function"]
            exact, lumped = (
                acoustic_fem.solve(design, study.frequency, name).transfer_function.values
                for name in ("navier-stokes", "lumped")
            )
            kept = values.transpose("point", "microphone", "frequency").values
            found.append({"lumped": apart(exact, lumped), "atlas": apart(exact, kept)})
            print("case", case, found[-1], flush=True)
    return found


def main() -> None:
    """Measure, print and write."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "entrance loss of a tube|membrane: ", UserWarning)
        designs = held_out()
        cases = swept()
    table = json.loads(TABLE.read_text())
    table["errors"] |= stated(designs)
    table["provenance"]["held-out designs"] = {
        "seeds": [FIRST_SEED, FIRST_SEED + COUNT - 1],
        "highest": float(FREQUENCY[-1]),
        "least angle": _least_angle(),
    }
    write(table)
    print_tables(designs, cases)


def _least_angle() -> float:
    """Smallest angle between the tubes of a point of the held-out designs, degrees."""
    designs = (random_design(seed) for seed in range(FIRST_SEED, FIRST_SEED + COUNT))
    return min(least_angle(cell_catalogue(design, lay_out(design)).distinct) for design in designs)


def stated(designs: Mapping[int, Mapping[str, Errors]]) -> dict[str, float]:
    """The errors that the table states: the worst of all held-out designs."""
    worst = {name: max(getattr(each["atlas"], name) for each in designs.values()) for name in Errors.__annotations__}
    return {
        "admittance of a resonator, held-out designs": worst["cell"],
        "admittance of a chamber, held-out designs": worst["chamber"],
        "transfer function of 1e-3 and more, held-out designs": worst["heard"],
        "transfer function by 1 + |ln H|": worst["per_log"],
    }


def print_tables(designs: Mapping[int, Mapping[str, Errors]], cases: Sequence[Mapping[str, Any]]) -> None:
    """The tables of the documentation."""
    print("| 40 random designs | bare resonator | bare chamber | H of 1e-3 and more | H by 1 + |ln H| |")
    print("|---|---|---|---|---|")
    for fidelity in ("lumped", "atlas"):
        for what, of in (("median", np.median), ("worst", np.max)):
            figures = [
                float(of([getattr(each[fidelity], name) for each in designs.values()]))
                for name in Errors.__annotations__
            ]
            print(f"| {fidelity}, {what} | " + " | ".join(f"{100 * each:.2f} %" for each in figures) + " |")
    for fidelity in ("lumped", "atlas"):
        heard, per_log = (max(each[fidelity][k] for each in cases) for k in range(2))
        print(f"| sweep, {fidelity}, worst of 10 | | | {100 * heard:.2f} % | {100 * per_log:.3f} % |")


if __name__ == "__main__":
    main()
