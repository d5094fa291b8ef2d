"""Result of a run of one design: data only."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from acoustic_fem import Library
from geometry.design.array_design import ArrayDesign
from geometry.formats.part_files import ExportedFile
from geometry.ground.shown import Shown
from geometry.layout.placement import ArrayLayout
from geometry.printing.printability import PrintReport
from studies.metrics.pairs import Disagreement
from studies.metrics.separation import Separability
from studies.output.report_texts import with_worst
from studies.run.validity import Validity
from studies.verdict import Verdict

if TYPE_CHECKING:
    from studies.evaluation.headline import Headline


@dataclass(frozen=True, eq=False, repr=False)
class RunResult(Shown):
    """Result of a run, with everything that its report contains."""

    def shown(self) -> tuple[str, Mapping[str, object]]:
        """Title and facts that a session and a notebook show."""

        def accuracy(headline: Headline | None) -> str:
            return "" if headline is None else with_worst(headline.top1, headline.worst)

        return f"Run of {self.design.name}", {
            "verdict": self.verdict.outcome,
            "folder": self.folder,
            "fidelity": self.library.fidelity,
            "top-1 accuracy on": self.network.signals,
            "localizer": accuracy(self.network),
            "Bayes decoder": accuracy(self.bayes),
            "tolerance-aware decoder": accuracy(self.tolerant),
            "parts": f"{sum(self.part_counts.values())}, in {len(self.files)} files",
            "warnings": len(self.warnings) or "none",
            "time": f"{sum(self.seconds.values()):.0f} s",
        }

    design: ArrayDesign
    """Design that was run."""
    folder: Path
    """Folder that the run wrote."""
    verdict: Verdict
    """Verdict on the design, with its reasons and remedies."""
    created: datetime
    """Time at which the run was made."""
    library: Library
    """Transfer functions of the array."""
    lumped: Library | None
    """Lumped library at 1 to 100 Hz, for comparison; None where the library itself is lumped."""
    disagreement: Disagreement | None
    """Disagreement of lumped with the library, at all points, microphones and frequencies from 1 to 100 Hz; None where
    there is no other."""
    separability: Separability
    """Distances of all pairs of points."""
    network: Headline
    """Results of the trained localizer on held-out taps and presses on as-built sensors, and those beside them."""
    bayes: Headline
    """Results of the Bayes decoder on the same touches."""
    tolerant: Headline | None
    """Results of the decoder that models manufacturing tolerances on the same touches; None if the tolerances of the
    design are not known."""
    training: Mapping[str, Any]
    """Record of the training: plan, losses and accuracies by epoch."""
    localizer_provenance: Mapping[str, Any]
    """Provenance of the localizer."""
    printing: PrintReport
    """Report of the print rules on the parts."""
    layout: ArrayLayout
    """Where everything lies."""
    part_counts: Mapping[str, int]
    """Number of each part."""
    files: tuple[ExportedFile, ...]
    """Files of the parts."""
    layout_notes: tuple[str, ...]
    """Notes on what is drawn but could not be built as drawn."""
    validity: tuple[Validity, ...]
    """Assumptions of the models, each against its limit."""
    warnings: tuple[str, ...]
    """Warnings that the models gave about their limits while they ran."""
    figures: Mapping[str, Path]
    """Path of each figure, by name."""
    seconds: Mapping[str, float]
    """Time taken by each stage, s."""
