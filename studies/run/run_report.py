"""``report.html``: one page that a designer can read without the program, the code or a network."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from acoustic_fem.cell.design_cells import solve_cells
from acoustic_fem.cell.lumped import lumped_admittance
from geometry.air.cells import Cell
from geometry.ground.whole_files import write_text
from geometry.layout.cutting import cutting_list
from localize.evaluation.held_out import TAPS_AND_PRESSES
from localize.signals.finger_stimuli import PRESS_HOLD
from localize.signals.finger_strokes import PEAK, TAP_SECONDS
from localize.signals.stimulus import BAND
from studies.output.report_texts import inlined_picture, record_rows, rendered_page
from studies.run.check import cell_uses
from studies.run.figure_data import figure_data
from studies.run.findings import (
    SENSITIVITY_AT,
    accuracy_rows,
    agreement_sentence,
    confusion_sentence,
    key_figures,
    noise_sentence,
    point_rows,
    printing_sentence,
    summary,
    training_sentence,
)
from studies.run.run_result import RunResult
from studies.run.worst_findings import folded_sections
from studies.verdict import figure_rows, remedy_in_words

#: Frequencies at which lumped cells are compared with 3-D cells, Hz.
CELLS_COMPARED_AT = (1.0, 10.0, 100.0)
#: A table of more points is folded away.
LONG_TABLE = 36
_ORDER = {"fail": 0, "warn": 1, "ok": 2}


def write_report(result: RunResult, path: Path) -> None:
    """Write the page of a run: pictures, figures as data and the script that draws them inlined, nothing fetched."""
    write_text(path, render(result))


def render(result: RunResult) -> str:
    """Page of a run as text."""
    layout = result.layout
    return rendered_page(
        "report.html",
        result=result,
        design=result.design,
        band=BAND,
        verdict=result.verdict,
        reasons=[
            (reason, None if reason.remedy is None else remedy_in_words(reason.rule, reason.remedy))
            for reason in result.verdict.reasons
        ],
        four=figure_rows(result.verdict),
        folded=folded_sections(result),
        summary=summary(result),
        accuracies=accuracy_rows(result),
        figures=key_figures(result),
        # JSON reads the escaped sign as the plain one, and no text of a design ends the element too early.
        figure_data=json.dumps(figure_data(result), allow_nan=False, separators=(",", ":")).replace("<", "\\u003c"),
        pictures={name: inlined_picture(path) for name, path in result.figures.items()},
        confusion=confusion_sentence(result),
        agreement=agreement_sentence(result),
        printing=printing_sentence(result),
        training=training_sentence(result),
        long_table=LONG_TABLE,
        schematic=any(tube.schematic for tube in layout.tubes),
        sensitivity_at=SENSITIVITY_AT,
        points=point_rows(result),
        microphones=list(result.design.microphones),
        findings=sorted(result.printing.findings, key=lambda finding: _ORDER[finding.verdict]),
        parts=_part_rows(result),
        cuts=cutting_list(result.design, layout),
        cells=_cell_rows(result, cell_uses(result.design, layout)),
        cells_compared_at=CELLS_COMPARED_AT,
        assumptions=_assumptions(result),
        provenance=_provenance(result),
    )


def _part_rows(result: RunResult) -> list[dict[str, Any]]:
    rows: dict[str, dict[str, Any]] = {}
    for file in result.files:
        row = rows.setdefault(
            file.part,
            {"part": file.part, "count": result.part_counts[file.part], "volume": file.cad_volume, "files": []},
        )
        row["files"].append({"format": file.format.upper(), "error": round(100 * file.volume_error, 4)})
        if file.triangles is not None:
            row["triangles"], row["deviation"] = file.triangles, file.linear_deviation
    return list(rows.values())


def _cell_rows(result: RunResult, cells: Sequence[tuple[Cell, int]]) -> list[dict[str, Any]]:
    """How each distinct cell was obtained; where it was solved in 3-D, with the difference of its closed form."""
    differences = _lumped_differences(result, [cell for cell, _ in cells]) if result.lumped is not None else {}
    return [
        {**dict(solved), "places": places, "differences": differences.get(cell.label)}
        for (cell, places), solved in zip(cells, result.library.provenance["cells"], strict=True)
    ]


def _lumped_differences(result: RunResult, cells: Sequence[Cell]) -> dict[str, list[float]]:
    """Per cell and frequency: largest difference of the lumped nodal admittance, in percent of its largest entry."""
    medium, frequency = result.library.medium, np.array(CELLS_COMPARED_AT)
    solved = solve_cells(cells, frequency, medium)
    differences = {}
    for cell, solution in solved.items():
        error = np.abs(lumped_admittance(cell, frequency, medium) - solution.admittance).max(axis=(1, 2))
        differences[cell.label] = [float(v) for v in 100 * error / np.abs(solution.admittance).max(axis=(1, 2))]
    return differences


_MOUNTING = {"rim": "glued by its lower face on its rim", "clamped": "held at the wall of the cavity"}


def _assumptions(result: RunResult) -> list[str]:
    design = result.design
    membrane = design.material(design.membrane.material)
    return [
        "Sound pressures are small, so all equations are linear. Walls are rigid and have the temperature of the air. "
        "Only floors and sheaths move, if the design names their material.",
        "Waves in tubes are plane. The grooves of a spring are modelled as a wider bore. Bends are ignored.",
        f"A membrane is {_MOUNTING[design.membrane.mounting]}, stretched by {design.membrane.stretch - 1:.3g}, and "
        "displaces the air in the shape of its first mode. Its material is "
        f"{design.membrane.material}: {membrane.law_in_words} ({membrane.source}).",
        noise_sentence(result),
        "One point is touched at a time. The nominal sensor is exactly as designed. As-built sensors have the "
        "assumed tolerances of a sensor that nobody calibrated: bores, lengths, cavities, membranes and microphones "
        "deviate. "
        "Calibration would remove most of their loss of accuracy. Virtual rigs are not calibrated either. Their "
        "rubber, microphones and air also differ from the design in ways that no decoder is given.",
        _touches_sentence(result),
    ]


def _touches_sentence(result: RunResult) -> str:
    """Sentences on the touches of the evaluation and of the training."""
    plan = result.training["plan"]
    sensors = result.training["sensors"]
    trained = f"{sensors} as-built sensors" if sensors > 1 else "the nominal sensor"
    shortest, longest = (1000 * each for each in TAP_SECONDS)
    return (
        f"Taps and presses are strokes of a membrane by a finger: a tap lasts {shortest:g} to {longest:g} ms, a press "
        f"is held for {PRESS_HOLD[0]:g} to {PRESS_HOLD[1]:g} s. Their peaks are {PEAK[0]:g} to {PEAK[1]:g} Pa. They "
        f"pass the high-pass of {TAPS_AND_PRESSES.high_pass:g} Hz of a stream, and multi-sine touches do not. Each is "
        f"located from one frame of {result.network.samples} ms. Multi-sine touches, which the publication uses, have "
        f"1 to 100 sines from {BAND[0]:g} to {BAND[1]:g} Hz and white noise. A network recognizes only the kinds of "
        "touches that it was "
        f"trained on. This one was trained on {', '.join(plan['stimuli'])} on {trained}."
    )


def _provenance(result: RunResult) -> list[tuple[str, str]]:
    library = result.library
    own = {key: value for key, value in library.provenance.items() if key != "cells"}
    medium = library.medium
    air = result.design.air
    return [
        ("made", result.created.strftime("%Y-%m-%d %H:%M UTC")),
        ("fidelity", library.fidelity),
        ("frequencies", f"{len(library.frequency)} from {library.frequency[0]:g} to {library.frequency[-1]:g} Hz"),
        (
            "air",
            f"{air.temperature:g} °C, {100 * air.humidity:g} % relative humidity, {air.pressure:g} Pa: density "
            f"{medium.density:.4f} kg/m³, viscosity {medium.viscosity:.4g} Pa s, "
            f"sound speed {medium.sound_speed:.1f} m/s",
        ),
        *record_rows("library", own),
        *record_rows("localizer", result.localizer_provenance["localizer"]),
        *record_rows("training", result.training["plan"]),
        ("seconds", ", ".join(f"{name} {seconds:.1f}" for name, seconds in result.seconds.items())),
    ]
