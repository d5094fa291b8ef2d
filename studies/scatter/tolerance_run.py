"""A tolerance study from a design to its files."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from acoustic_fem.quantities.checks import FrequencyLike, frequency_grid
from acoustic_fem.scatter.tolerances import Tolerance, tolerances_of
from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import DesignLike, resolve_design
from geometry.ground.argument_checks import check_range
from geometry.ground.refusal import Field, Kind, Refusal
from geometry.ground.shown import Shown
from geometry.ground.typed import PathLike
from localize.signals.noise_model import NoiseChoice
from studies.output.call_defaults import BASE_SAMPLES, SEED, SENSORS, STORED_SENSORS
from studies.output.display import Display
from studies.output.folders import check_folder, claimed_folder
from studies.output.frequencies import FREQUENCIES
from studies.scatter.effects import ToleranceResult, scatter_effects
from studies.scatter.perturbed_library import MOST_SENSORS, write_perturbed_library
from studies.scatter.tolerance_files import SUMMARY, save_tolerance

#: File of the library of sensors with scatter.
_LIBRARY = "library.zarr"


@dataclass(frozen=True, eq=False, repr=False)
class ToleranceStudy(Shown):
    """Results of a tolerance study, and their files."""

    design: ArrayDesign
    """Nominal array."""
    result: ToleranceResult
    """Spread of transfer functions and accuracies, and Sobol indices."""
    files: tuple[Path, ...]
    """Files that were written: JSON, picture and, where it was asked for, the library of sensors with scatter."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""
        found = self.result
        accuracies = {
            f"predicted top-1 accuracy, {name}": f"mean {values.mean():.1%}, worst {values.min():.1%}"
            for name, values in found.accuracy.items()
        }
        most = {
            f"largest effect on {name}": f"{indices[0].quantity} (total {indices[0].total:.2g})"
            for name, indices in found.sobol.items()
            if indices
        }
        return f"Tolerances of {self.design.name}", {
            "sensors": len(found.deviation),
            "nominal sensor": f"{found.nominal_accuracy:.1%}",
            **accuracies,
            **most,
            "fidelity": found.fidelity.words,
            "files": ", ".join(str(path) for path in self.files),
        }


def tolerance_study(
    design: DesignLike,
    out: PathLike,
    *,
    samples: int = SENSORS,
    base_samples: int = BASE_SAMPLES,
    library_size: int = STORED_SENSORS,
    tolerances: PathLike | Sequence[Tolerance] | None = None,
    microphone_noise: NoiseChoice = "design",
    seed: int = SEED,
    frequency: FrequencyLike = FREQUENCIES,
    display: Display | None = None,
) -> ToleranceStudy:
    """Spread of transfer functions and accuracy by manufacturing scatter, and which tolerance matters most.

    Every tube, cavity and membrane deviates independently. The fidelity is ``atlas`` if it covers the design and all
    its as-built sensors, otherwise 3-D. :func:`studies.scatter.scatter_effects` does the same without files.

    Args:
        design: the nominal array: a design, the path of its file, or the name of a prototype.
        out: the folder for ``tolerance.json`` and ``tolerance.png``.
        samples: number of sensors with manufacturing scatter.
        base_samples: base samples of the Sobol indices, which take ten times as many sensors; 0 for no indices.
        library_size: number of sensors to store in ``library.zarr`` of the folder, for training, at most a million; 0
            for no library.
        tolerances: tolerances of the workshop, or a TOML file of them; by default assumed ones.
        microphone_noise: white noise of the microphones, Pa rms over 0 to 500 Hz; by default the noise of the design's
            microphone.
        seed: seed of all draws.
        frequency: (n_freq,) Hz, over 1 to 100 Hz, or FIRST:LAST:COUNT.
        display: shows progress.

    Raises:
        Refusal: a value out of range, a folder that cannot be written or already has such a library, tolerances that
            cannot be read, or a design that cannot be solved with scatter.
    """
    folder, show, design = Path(out), display or Display(), resolve_design(design)
    for name, value, most in (("library_size", library_size, MOST_SENSORS), ("seed", seed, math.inf)):
        check_range(name, value, 0, most, whole=True)
    workshop = tolerances if isinstance(tolerances, str | os.PathLike) else None
    check_folder(folder, "tolerance", SUMMARY, reads=(workshop,))
    grid, scatter = frequency_grid(frequency), tolerances_of(tolerances)
    store = folder / _LIBRARY
    if library_size and store.exists():
        raise Refusal("exists, and a library is never overwritten", kind=Kind.EXISTS, file=store, field=Field("out"))
    with claimed_folder(folder, "tolerance", SUMMARY, reads=(workshop,)):
        with show.stage("Scatter", of=2 if library_size else 1) as report:
            result = scatter_effects(
                design,
                grid,
                samples=samples,
                base_samples=base_samples,
                tolerances=scatter,
                microphone_noise=microphone_noise,
                seed=seed,
                progress=report,
            )
        files = save_tolerance(result, folder)
        if library_size:
            with show.stage("Library", of=2) as report:
                write_perturbed_library(
                    store, design, library_size, grid, tolerances=scatter, seed=seed, progress=report
                )
            files = (*files, store)
        return ToleranceStudy(design, result, files)
