"""What a run of one design made: data only."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from geometry.design.array_design import ArrayDesign
from studies.metrics.pairs import Disagreement, Separability
from studies.run.check import Validity

if TYPE_CHECKING:
    from acoustic_fem import Library
    from geometry.formats.part_files import ExportedFile
    from geometry.printing.report import PrintReport
    from localize import Evaluation


@dataclass(frozen=True, eq=False)
class RunResult:
    """What a run found; the report is made from nothing else."""

    design: ArrayDesign
    folder: Path
    created: datetime
    library: Library
    lumped: Library | None
    """At 1 to 100 Hz, for comparison; None where the library itself is lumped."""
    disagreement: Disagreement | None
    """Of lumped from the library, at all points, microphones and frequencies from 1 to 100 Hz."""
    separability: Separability
    network: Evaluation
    bayes: Evaluation
    training: Mapping[str, Any]
    localizer_provenance: Mapping[str, Any]
    printing: PrintReport
    part_counts: Mapping[str, int]
    files: tuple[ExportedFile, ...]
    layout_notes: tuple[str, ...]
    validity: tuple[Validity, ...]
    warnings: tuple[str, ...]
    """What the models said about their limits while they ran."""
    figures: Mapping[str, Path]
    seconds: Mapping[str, float]
    """Per stage."""
