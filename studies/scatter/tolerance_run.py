"""A tolerance study from a design to its files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from acoustic_fem.quantities.checks import frequency_grid
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.refusal import Refusal
from studies.output.display import Display
from studies.output.folders import check_folder
from studies.output.frequencies import FREQUENCIES

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from acoustic_fem.scatter.tolerances import Tolerance
    from geometry.design.array_design import ArrayDesign
    from studies.scatter.effects import ToleranceResult

#: The library of mis-made sensors.
_LIBRARY = "library.zarr"


@dataclass(frozen=True, eq=False)
class ToleranceStudy:
    """Results of a tolerance study, and their files."""

    design: ArrayDesign
    """Nominal array."""
    result: ToleranceResult
    """Spread of transfer functions and accuracies, and Sobol indices."""
    files: tuple[Path, ...]
    """Files that were written: JSON, picture and, where it was asked for, the library of mis-made sensors."""


def tolerance_study(
    design: DesignLike,
    out: str | os.PathLike[str],
    *,
    samples: int = 256,
    base: int = 128,
    library: int = 0,
    tolerances: str | os.PathLike[str] | Sequence[Tolerance] | None = None,
    noise: float | None = None,
    seed: int = 0,
    frequency: ArrayLike | str = FREQUENCIES,
    display: Display | None = None,
) -> ToleranceStudy:
    """Spread of transfer functions and accuracy by manufacturing scatter, and which tolerance matters most.

    Every tube, cavity and membrane deviates by itself; fidelity ``atlas`` if that covers the design and all sensors
    about it, otherwise 3-D. :func:`studies.scatter.scatter_effects` is the same without files.

    Args:
        design: the nominal array: a design, the path of its file, or the name of a prototype.
        out: the folder for ``tolerance.json`` and ``tolerance.png``.
        samples: sensors made with scatter.
        base: of the Sobol indices: ten times as many sensors; 0 for none.
        library: sensors to store in ``library.zarr`` of the folder, for training, at most a million; 0 for none.
        tolerances: of the workshop, or a TOML file of them; by default assumed ones.
        noise: of the microphones, white, Pa rms over 0 to 500 Hz; by default that of the design's.
        seed: of all draws.
        frequency: (n_freq,) Hz, over 1 to 100 Hz, or FIRST:LAST:COUNT.
        display: shows what is being done.

    Raises:
        Refusal: a value out of range, a folder that cannot be written or has such a library, tolerances that cannot be
            read, or a design that the batch does not take.
    """
    folder, show = Path(out), display or Display()
    from acoustic_fem.scatter.tolerances import tolerances_of
    from studies.scatter.effects import scatter_effects
    from studies.scatter.perturbed_library import MOST_SENSORS, write_perturbed_library
    from studies.scatter.tolerance_files import SUMMARY, save_tolerance

    if not 0 <= library <= MOST_SENSORS:
        raise Refusal(f"library = {library} must be from 0 to {MOST_SENSORS}")
    if seed < 0:
        raise Refusal(f"seed = {seed} must be 0 or above")
    workshop = tolerances if isinstance(tolerances, str | os.PathLike) else None
    check_folder(folder, "tolerance", SUMMARY, reads=(workshop,))
    grid, scatter = frequency_grid(frequency), tolerances_of(tolerances)
    store = folder / _LIBRARY
    if library and store.exists():
        raise Refusal(f"{store}: exists; a library is never overwritten")
    design = resolve_design(design)
    with show.stage("Scatter", of=2 if library else 1) as report:
        result = scatter_effects(
            design, grid, samples=samples, base=base, tolerances=scatter, noise=noise, seed=seed, progress=report
        )
    files = save_tolerance(result, folder)
    if library:
        with show.stage("Library", of=2) as report:
            write_perturbed_library(store, design, library, grid, tolerances=scatter, seed=seed, progress=report)
        files = (*files, store)
    return ToleranceStudy(design, result, files)
