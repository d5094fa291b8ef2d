"""Figures of merit of a list of designs, where a search needs them now: lumped ones in one call for each wiring."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from geometry import ArrayDesign
from studies.responses import Responses

if TYPE_CHECKING:
    from studies.metric_registry import Metric
    from studies.study_file import Study


def design_metrics(
    designs: Sequence[ArrayDesign], study: Study, metrics: Sequence[Metric]
) -> tuple[NDArray[np.float64], list[str]]:
    """Metrics of designs, with the fidelity and the frequencies of a study.

    Args:
        designs: any, of one or several wirings.
        study: gives fidelity and frequencies; what it varies does not count.
        metrics: what to compute.

    Returns:
        (n_design, n_metric) float64, NaN where it failed, and for each design why it failed, or nothing.
    """
    table = np.full((len(designs), len(metrics)), np.nan)
    reasons = [""] * len(designs)
    for rows in _batches(designs, study.fidelity):
        try:
            responses = _responses([designs[row] for row in rows], study)
            table[rows] = np.column_stack([metric.of_batch(responses) for metric in metrics])
        except ValueError as error:
            if len(rows) > 1:  # one bad design must not take the others with it
                for row in rows:
                    table[row : row + 1], (reasons[row],) = design_metrics([designs[row]], study, metrics)
            else:
                reasons[rows[0]] = str(error)
    return table, reasons


def _batches(designs: Sequence[ArrayDesign], fidelity: str) -> list[list[int]]:
    if fidelity != "lumped":
        return [[row] for row in range(len(designs))]
    from acoustic_fem.batch_parameters import Topology

    groups: dict[Topology, list[int]] = {}
    for row, design in enumerate(designs):
        groups.setdefault(Topology.of(design), []).append(row)
    return list(groups.values())


def _responses(designs: list[ArrayDesign], study: Study) -> Responses:
    if study.fidelity != "lumped":
        import acoustic_fem

        (design,) = designs
        return Responses.of_library(acoustic_fem.solve(design, study.frequency, study.fidelity))
    from acoustic_fem.batch_network import batch_response
    from acoustic_fem.batch_parameters import ArrayParameters, MediumParameters, Topology, design_air

    media = [design_air(design) for design in designs]
    topology = Topology.of(designs[0])
    response = batch_response(
        ArrayParameters.from_designs(designs), topology, study.frequency, MediumParameters.from_media(media)
    )
    return Responses(
        frequency=study.frequency,
        transfer_function=response.transfer_function,
        designs=designs,
        medium=media,
        source_response=response.source_response,
        point_impedance=response.point_impedance,
        microphone_impedance=response.microphone_impedance,
    )
