"""Findings of a run in numbers and sentences: for the report, and for programs as ``results.json``."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from acoustic_fem.membrane.design_discs import design_disc
from geometry.design.design_file import write_design
from geometry.ground.refusal import counted
from geometry.layout.size import array_size
from localize.signals.stimulus import BAND
from studies.metrics.covered_area import coverage, most_uncovered
from studies.metrics.pairs import attenuation, sensitivity, worst_heard
from studies.output.display import number
from studies.output.folders import write_json
from studies.output.report_texts import percent, with_worst
from studies.run.run_result import RunResult

if TYPE_CHECKING:
    from studies.evaluation.headline import Headline

#: Lumped and Navier-Stokes transfer functions should agree within this: relative magnitude, degrees.
AGREEMENT = (0.015, 1.0)
#: Frequency at which the sensitivity of a point is stated, Hz.
SENSITIVITY_AT = 10.0
#: Pairs that are named where many are as hard to tell apart as the hardest.
NAMED_PAIRS = 3


@dataclass(frozen=True)
class KeyFigure:
    """Line of the table of key figures."""

    name: str
    """Name of the figure."""
    value: str
    """Value with its unit, as text."""
    remark: str = ""
    """Explanation of the value; may be empty."""


@dataclass(frozen=True)
class AccuracyRow:
    """Top-1 accuracies of three decoders on some touches; of several sensors their mean, with the worst."""

    touches: str
    """Touches, and the sensors that they are on."""
    localizer: str
    """Accuracy of the trained localizer."""
    bayes: str
    """Accuracy of the Bayes decoder of the nominal library, without training."""
    tolerant: str
    """Accuracy of the decoder that models manufacturing tolerances; "not known" if the design's are not known."""


def summary(result: RunResult) -> str:
    """Summary of a run: accuracy, the hardest pair, printing; :func:`accuracy_rows` has the other accuracies."""
    design, network = result.design, result.network
    lines = len(design.lines)
    found = (
        f"{counted(design.point_count, 'point')} on {counted(lines, 'line')} between "
        f"{counted(len(design.microphones), 'microphone')}: the trained localizer assigns {percent(network.top1)} of "
        f"held-out {network.signals} to the correct point."
    )
    if network.unscattered:
        found += f" As-built sensors are left out: {network.unscattered}."
    (first, second), *others = result.separability.equally_hard
    level, phase, _ = result.separability.between(first, second)
    hardest = f"The points that are hardest to tell apart are {first} and {second}"
    if others:
        more = len(others) - NAMED_PAIRS
        hardest += " (and equally " + ", ".join(f"{i} and {j}" for i, j in others[:NAMED_PAIRS])
        hardest += f" and {counted(more, 'more pair')})" if more > 0 else ")"
    hardest += f": {level:.2g} dB and {phase:.2g} degrees apart over {BAND[0]:g} to {BAND[1]:g} Hz."
    return f"{found} {hardest} {printing_sentence(result)}"


def accuracy_rows(result: RunResult) -> list[AccuracyRow]:
    """Rows of the table of accuracies: touches and sensors, the headline's first, each with every decoder."""
    columns = [_accuracy_cells(each) for each in (result.network, result.bayes, result.tolerant) if each is not None]
    if result.tolerant is None:
        columns.append(["not known"] * len(columns[0]))
    names = (result.network.signals, *(name for name, _ in result.network.beside))
    return [AccuracyRow(name, *cells) for name, *cells in zip(names, *columns, strict=True)]


def _accuracy_cells(headline: Headline) -> list[str]:
    """Accuracies of a decoder, that of its headline first."""
    beside = [with_worst(outcome.top1, outcome.worst) for outcome in headline.outcomes]
    return [with_worst(headline.top1, headline.worst), *beside]


def printing_sentence(result: RunResult) -> str:
    """Sentence on whether the parts can be printed."""
    report = result.printing
    failing = sorted({finding.part for finding in report.findings if finding.verdict == "fail"})
    warned = sum(finding.verdict == "warn" for finding in report.findings)
    if failing:
        return f"The parts cannot be printed as they are ({report.process.title}): see {', '.join(failing)}."
    if warned:
        return (
            f"The parts can be printed with care: {counted(warned, 'measure')} between the limit of the process "
            "and its advised value."
        )
    return "The parts can be printed."


def confusion_sentence(result: RunResult) -> str:
    """Sentences on the hardest pair by distance against the pair the localizer confuses most."""
    pair = result.network.hardest_pair
    if pair is None:
        return f"The localizer missed none of {result.network.touches} held-out touches ({result.network.signals})."
    named, share = _numbers(result, pair), pair[2]
    text = (
        f"The localizer most often confuses points {named[0]} and {named[1]}: it assigns {percent(share)} of their "
        f"touches to the other point ({result.network.signals}). "
    )
    if named in result.separability.equally_hard:
        return text + "They are also the hardest pair by distance."
    rank = 1 + result.separability.hardest_pairs.index(named)
    return text + (
        f"By distance this pair is number {rank} of {len(result.separability.hardest_pairs)}, hardest first. The two "
        "need not agree, because the distance weights all frequencies equally and ignores noise, whereas each touch "
        "contains only some frequencies, and the training of a network ends before its result is perfect. The distance "
        "is also that of the nominal sensor."
    )


def noise_sentence(result: RunResult) -> str:
    """Sentences on the noise of training and evaluation, and where its figures come from."""
    network, microphone = result.network, result.design.microphone
    text = f"Training and held-out touches have {network.noise_in_words}"
    if network.noise_source == "white":
        return text + ", not that of the design's microphone."
    return text + (
        f": {microphone.noise_density:g} Pa/√Hz, rising as 1/f in power below {microphone.noise_corner:g} "
        "Hz. It is given as pressure in the chamber of the microphone, so it is divided by the microphone's response, "
        f"which falls below {microphone.vent_corner:g} Hz. Source of the data of {microphone.model}: "
        f"{microphone.source}."
    )


def training_sentence(result: RunResult) -> str:
    """Sentences on how long the localizer was trained, and whether the time ran out."""
    training, planned = result.training, result.training["plan"]
    text = f"The localizer was trained on {counted(training['touches'], 'touch')}"
    if training["seconds"]:  # 0 where the clock of files is stopped
        text += f" in {training['seconds']:.0f} s"
    text += "."
    if not training["cut_short"]:
        return text
    touches = planned["epochs"] * planned["seconds_per_point"] * result.design.point_count
    return text + (
        f" The plan had {touches} touches, but the training reached its limit of {planned['time_limit']:g} s. So its "
        "accuracy depends on how busy the machine was. Give it more time for a better localizer."
    )


def agreement_sentence(result: RunResult) -> str:
    """Sentences on how far the closed forms are from the 3-D cells, and why."""
    found = result.disagreement
    if found is None:
        return "The library itself was solved with the lumped model, so there is no comparison."
    text = (
        f"The lumped transfer functions differ from those of Navier-Stokes, {BAND[0]:g} to {BAND[1]:g} Hz, by at most "
        f"{100 * found.magnitude:.2g} % in magnitude ({_where(found.magnitude_at)}) and {found.phase:.2g} degrees in "
        f"phase ({_where(found.phase_at)}); the limits are {100 * AGREEMENT[0]:g} % and {AGREEMENT[1]:g} degree. "
    )
    if found.magnitude <= AGREEMENT[0] and found.phase <= AGREEMENT[1]:
        text += "Lumped is within them. "
    else:
        point, microphone, frequency = (
            found.magnitude_at if found.magnitude / AGREEMENT[0] > found.phase / AGREEMENT[1] else found.phase_at
        )
        text += (
            "Lumped is outside them. The small differences of the cells (last column of the table of cells) add up "
            f"along the path from point {point} to microphone {microphone}. They are largest at {frequency:g} Hz, "
            "where the path attenuates most. Use Navier-Stokes there. "
        )
    return text + (
        "The lumped model assumes a uniform pressure in a cavity, and at the opening of a tube the resistance and "
        "inertance of an opening in a flat wall. The 3-D cells contain the real openings."
    )


def key_figures(result: RunResult) -> list[KeyFigure]:
    """Lines of the table of key figures."""
    design, h = result.design, result.library.transfer_function
    *sides, height = array_size(design, result.layout)
    first, second = result.separability.equally_hard[0]
    level, phase, distance = result.separability.between(first, second)
    network, furthest = result.network, most_uncovered(design)
    noise = f"held out, {network.samples / 1000:g} s each, {network.noise_in_words}"
    figures = [
        KeyFigure("points", f"{design.point_count}", counted(len(design.lines), "line")),
        KeyFigure("microphones", f"{len(design.microphones)}", design.microphone.model),
        KeyFigure(
            "size",
            f"{max(sides):.1f} x {min(sides):.1f} x {height:.1f} mm",
            "of the whole array, with membranes, boards and tubes",
        ),
        KeyFigure(
            "coverage",
            f"{coverage(design, design.target.contact_radius, result.layout):.0%}",
            f"fraction of the area where a contact of {design.target.contact_radius:g} mm radius touches a membrane"
            f"{'' if furthest is None else f'; {furthest.words}'}",
        ),
        KeyFigure(
            "localizer, top-1",
            with_worst(network.top1, network.worst),
            f"{network.touches} {network.signals}, {noise}",
        ),
        KeyFigure(
            "localizer, top-2",
            percent(network.top2),
            "on these touches, correct point among the two most probable; correct point or a neighbour on its line: "
            f"{percent(network.within_one)}",
        ),
        KeyFigure(
            "hardest pair",
            f"points {first} and {second}",
            f"{level:.3g} dB and {phase:.3g} degrees apart (rms over {BAND[0]:g} to {BAND[1]:g} Hz), distance "
            f"{distance:.3g}",
        ),
    ]
    pair = network.hardest_pair
    confused = "none" if pair is None else "points {} and {}".format(*_numbers(result, pair))
    share = "" if pair is None else f"{percent(pair[2])} of their taps and presses are assigned to the other point"
    figures.append(KeyFigure("most confused by the localizer", confused, share))
    for frequency in (10.0, 100.0):
        weakest, point = worst_heard(h, frequency)
        figures.append(
            KeyFigure(
                f"weakest signal at {frequency:g} Hz",
                f"{number(weakest, 1)} dB",
                f"point {point} at its second-loudest microphone",
            )
        )
    bores = sorted({tube.inner_diameter for tube in design.tubes})
    compliances = membrane_compliances(result)
    of_kinds = f"; kinds {', '.join(kind or 'as stated' for kind in design.kinds)}" if len(compliances) > 1 else ""
    relatives = ", ".join(f"{relative:.2g}" for _, relative in compliances)
    figures += [
        KeyFigure("bore", ", ".join(f"{bore:g}" for bore in bores) + " mm", "of all tubes"),
        KeyFigure(
            "membrane compliance",
            ", ".join(f"{compliance:.3g}" for compliance, _ in compliances) + " mm³/kPa",
            f"static; {relatives} times that of the air in its cavity{of_kinds}",
        ),
    ]
    if result.disagreement is not None:
        found = result.disagreement
        inside = found.magnitude <= AGREEMENT[0] and found.phase <= AGREEMENT[1]
        figures.append(
            KeyFigure(
                "lumped against Navier-Stokes",
                f"{100 * found.magnitude:.2g} %, {found.phase:.2g} degrees",
                f"largest difference, {BAND[0]:g} to {BAND[1]:g} Hz; {'within' if inside else 'outside'} "
                f"{100 * AGREEMENT[0]:g} % and {AGREEMENT[1]:g} degree",
            )
        )
    figures.append(KeyFigure("print verdict", result.printing.verdict, result.printing.process.title))
    return figures


def point_rows(result: RunResult) -> list[dict[str, Any]]:
    """Rows of the table of points: levels, sensitivity, the point it is nearest to, and how often it was found."""
    h = result.library.transfer_function
    low, high = attenuation(h, 10.0), attenuation(h, 100.0)
    volume = sensitivity(result.library, SENSITIVITY_AT)
    confusion = result.network.confusion
    found = np.diag(confusion) / np.maximum(confusion.sum(axis=1), 1)
    rows = []
    for index, point in enumerate(result.separability.points):
        nearest = result.separability.nearest(point)
        level, phase, distance = result.separability.between(point, nearest)
        rows.append(
            {
                "point": point,
                "line": int(h["line"].values[index]) + 1,
                "level_10_hz_db": [float(value) for value in low[index]],
                "level_100_hz_db": [float(value) for value in high[index]],
                "sensitivity_pa_per_mm3": float(volume[index]),
                "nearest": nearest,
                "nearest_level_db": level,
                "nearest_phase_degrees": phase,
                "nearest_distance": distance,
                "found": float(found[index]),
            }
        )
    return rows


def membrane_compliances(result: RunResult) -> list[tuple[float, float]]:
    """Per kind of point the static compliance of the membrane, mm^3/kPa, and its ratio to the V / p of its cavity."""
    found = []
    for kind in result.design.kinds:
        alike = result.design.of_kind(kind)
        compliance = design_disc(alike).static_compliance
        air = alike.resonator.cavity_volume * 1e-9 / result.library.medium.pressure
        found.append((compliance * 1e12, compliance / air))
    return found


def write_results(result: RunResult, path: Path) -> None:
    """Write ``results.json``: key figures, distances, evaluations, parts, cells, provenance."""
    distances = result.separability
    found = result.disagreement
    content = {
        "program": "acoustic-fem run",
        "created": result.created.isoformat(timespec="seconds"),
        "verdict": result.verdict.to_dict(),
        "summary": summary(result),
        "accuracy": [asdict(row) for row in accuracy_rows(result)],
        "key_figures": [asdict(figure) for figure in key_figures(result)],
        "design": {"name": result.design.name, "toml": write_design(result.design.completed())},
        "points": point_rows(result),
        "separability": {
            "band_hz": list(BAND),
            "hardest_pairs": [list(pair) for pair in distances.hardest_pairs[:10]],
            "equally_hard": [list(pair) for pair in distances.equally_hard],
            "level_db": distances.level.tolist(),
            "phase_degrees": distances.phase.tolist(),
            "combined": distances.combined.tolist(),
        },
        "network": result.network.to_dict(),
        "bayes": result.bayes.to_dict(),
        "tolerant": None if result.tolerant is None else result.tolerant.to_dict(),
        "training": dict(result.training),
        "lumped_difference": None if found is None else asdict(found),
        "printing": {
            "process": result.printing.process.name,
            "verdict": result.printing.verdict,
            "findings": [_finite(asdict(finding)) for finding in result.printing.findings],
        },
        "files": [
            {
                "path": f"parts/{file.path.name}",
                "part": file.part,
                "count": result.part_counts[file.part],
                "cad_volume_mm3": file.cad_volume,
                "volume_error": file.volume_error,
                "triangles": file.triangles,
            }
            for file in result.files
        ],
        "cells": result.library.provenance["cells"],
        "validity": [{**asdict(item), "holds": item.holds} for item in result.validity],
        "layout_notes": list(result.layout_notes),
        "warnings": list(result.warnings),
        "seconds": dict(result.seconds),
        "provenance": {
            "fidelity": result.library.fidelity,
            "medium": asdict(result.library.medium),
            "frequency_hz": [float(result.library.frequency[0]), float(result.library.frequency[-1])],
            "frequencies": len(result.library.frequency),
            "library": {key: value for key, value in result.library.provenance.items() if key != "cells"},
            "localizer": result.localizer_provenance["localizer"],
        },
    }
    write_json(path, content)


def _numbers(result: RunResult, pair: tuple[int, int, float]) -> tuple[int, int]:
    """Numbers of the points that an evaluation counts from 1, in order."""
    points = result.separability.points
    return points[pair[0] - 1], points[pair[1] - 1]


def _finite(finding: dict[str, Any]) -> dict[str, Any]:
    """A measure without a value (no opposed walls) is null: JSON has no infinity."""
    return {
        key: None if isinstance(value, float) and not math.isfinite(value) else value for key, value in finding.items()
    }


def _where(place_: tuple[int, str, float]) -> str:
    point, microphone, frequency = place_
    return f"point {point}, microphone {microphone}, {frequency:g} Hz"
