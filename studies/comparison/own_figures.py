"""Figures of one subject of a comparison: metrics of its library, of its parts, of a run and of a sweep."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

import acoustic_fem
from acoustic_fem import Library
from acoustic_fem.atlas.fidelity_choice import quick_fidelity
from acoustic_fem.library.transfer_functions import MEASURED, VARIABLES, library_from_arrays
from acoustic_fem.quantities.checks import frequency_grid
from geometry.design.array_design import ArrayDesign
from geometry.ground.extras import is_installed
from geometry.ground.refusal import Kind, Refusal, said_by
from localize.signals.stimulus import BAND
from studies.comparison.quantities import FIGURES, TOUCH_WORDS, Value
from studies.comparison.subjects import Subject
from studies.metrics.batch_responses import Responses
from studies.metrics.pairs import worst_heard
from studies.metrics.separation import separability
from studies.metrics.shared import SharedFigures
from studies.output.display import Display
from studies.output.frequencies import FREQUENCIES
from studies.output.report_texts import percent
from studies.run.check import check_design
from studies.study.metric_registry import METRICS
from studies.verdict.accuracies import accuracies
from studies.verdict.measuring import Drawn
from studies.verdict.verdict import Verdict

#: Points of the largest array whose confusions are predicted: memory goes with the square of them, 1 GB.
MOST_POINTS = 256
#: Figures of the verdict.
_JUDGED = ("verdict", "smallest_force")
#: Beginnings of the names of metrics that compare two points, or two microphones.
_OF_PAIRS = ("predicted", "confused", "distance", "ild", "ipd", "scatter")
#: Beginnings of the names of metrics whose memory goes with the square of the points.
_OF_ALL_PAIRS = ("predicted", "confused", "scatter")
#: Decoders of a run as ``results.json`` names them, and their titles.
_DECODERS = {"network": "trained localizer", "bayes": "Bayes decoder", "tolerant": "tolerance-aware decoder"}


@dataclass(frozen=True)
class OwnFigure:
    """Figure of one subject."""

    value: Value | None
    """Value in the unit of its quantity; None where it is not known."""
    remark: str = ""
    """Remark that belongs to the value, such as the accuracy of the worst sensor."""
    why: str = ""
    """Reason why it is not known; empty where it is."""


def unknown(why: str) -> OwnFigure:
    """Figure that is not known, for a reason in words."""
    return OwnFigure(None, why=why)


def library_figures(library: Library) -> dict[str, OwnFigure]:
    """Figures of merit of a library and of its design, by the names of :data:`FIGURES`.

    Frequencies outside 1 to 100 Hz are left out, so that libraries of other grids are compared over one band. A figure
    that the library does not give is unknown, with the reason.

    Args:
        library: of one design.
    """
    return metric_figures(SharedFigures(Responses.of_library(within_band(library))), library.design)


def metric_figures(shared: SharedFigures, design: ArrayDesign) -> dict[str, OwnFigure]:
    """Figures of merit as :func:`library_figures` gives them, from responses between 1 and 100 Hz.

    Args:
        shared: figures of the responses of one design.
        design: the design.
    """
    return {name: _of_metric(name, shared, design) for name in FIGURES}


def _of_metric(name: str, shared: SharedFigures, design: ArrayDesign) -> OwnFigure:
    if why := _no_pairs(name, design):
        return unknown(why)
    metric = METRICS[name]
    if missing := [extra for extra in metric.extras if not is_installed(extra)]:
        return unknown(f"needs pip install 'acoustic-fem[{missing[0]}]'")
    if absent := [each for each in sorted(metric.needs) if getattr(shared.responses, each) is None]:
        return unknown(f"the library has no {', '.join(each.replace('_', ' ') for each in absent)}")
    try:
        value = float(metric.of_batch(shared.responses, shared)[0])
    except Refusal as error:
        return unknown(str(error))
    return OwnFigure(value) if np.isfinite(value) else unknown("it is not finite")


def _no_pairs(name: str, design: ArrayDesign) -> str:
    """Reason why a metric of pairs does not apply to a design; empty where it does."""
    if name.startswith(_OF_PAIRS):
        if design.point_count < 2 or len(design.microphones) < 2:
            return "it needs at least two points and two microphones"
        if name.startswith(_OF_ALL_PAIRS) and design.point_count > MOST_POINTS:
            return f"it is predicted for at most {MOST_POINTS} points"
    return ""


def within_band(library: Library) -> Library:
    """The library between 1 and 100 Hz; the library itself if it has no other frequencies or none in the band."""
    frequency = library.frequency
    inside = (frequency >= BAND[0] - 1e-9) & (frequency <= BAND[1] + 1e-9)
    if inside.all() or not inside.any():
        return library
    arrays = {name: getattr(library, name) for name in VARIABLES}
    values = {
        name: array.transpose(*VARIABLES[name][0]).values[..., inside]
        for name, array in arrays.items()
        if array is not None
    }
    return library_from_arrays(
        library.design, frequency[inside], values, library.fidelity, library.medium, library.provenance
    )


def solved(subject: Subject) -> tuple[Library, str]:
    """Library of a subject and its fidelity in words: its own, otherwise that of its design as a quick answer."""
    if subject.library is not None:
        return subject.library, subject.library.fidelity
    grid = frequency_grid(FREQUENCIES)
    fidelity = quick_fidelity(subject.design, grid)
    return acoustic_fem.solve(subject.design, grid, fidelity=fidelity.name), fidelity.words


def subject_figures(
    subject: Subject, library: Library, fidelity: str, *, printing: bool, display: Display
) -> dict[str, OwnFigure]:
    """All figures of a subject by name of quantity.

    Args:
        subject: the subject.
        library: its library, as :func:`solved` gives it.
        fidelity: that of the library, in words.
        printing: whether to draw the parts of a design and to compare them with the print rules.
        display: shows progress.
    """
    found = dict(library_figures(library))
    found |= _signals(library)
    found |= _counts(subject.design)
    found |= _of_design(subject, library, printing, display)
    found |= {f"stored.{name}": OwnFigure(value) for name, value in subject.metrics.items()}
    grid, medium = library.frequency, library.medium
    found |= {
        "target": OwnFigure(_target_in_words(subject.design)),
        "given": OwnFigure(subject.kind, subject.source),
        "fidelity": OwnFigure(fidelity),
        "frequencies": OwnFigure(f"{len(grid)} from {grid[0]:g} to {grid[-1]:g} Hz"),
        "air": OwnFigure(f"{medium.pressure:.6g} Pa, {medium.density:.4g} kg/m\N{SUPERSCRIPT THREE}"),
    }
    return found | {f"fact.{name}": OwnFigure(text) for name, text in subject.facts.items() if text}


def _signals(library: Library) -> dict[str, OwnFigure]:
    """Level of the weakest point at two frequencies, and the hardest pair."""
    h, design, grid = library.transfer_function, library.design, library.frequency
    found: dict[str, OwnFigure] = {}
    for hertz in (10, 100):
        name = f"level_{hertz}_hz"
        if len(design.microphones) < 2:
            found[name] = unknown("it needs two microphones")
        elif not grid[0] <= hertz + 1e-9 or not grid[-1] >= hertz - 1e-9:
            found[name] = unknown(f"the library has {grid[0]:g} to {grid[-1]:g} Hz")
        else:
            level, point = worst_heard(h, float(hertz))
            found[name] = OwnFigure(level, f"point {point}")
    if why := _no_pairs("distance", design):
        return {**found, "hardest_pair": unknown(why)}
    try:
        apart = separability(h)
    except Refusal as error:
        return {**found, "hardest_pair": unknown(str(error))}
    first, second = apart.hardest_pairs[0]
    level, phase, _ = apart.between(first, second)
    return {**found, "hardest_pair": OwnFigure(f"{first} and {second}", f"{level:.2g} dB, {phase:.2g} degrees apart")}


def _counts(design: ArrayDesign) -> dict[str, OwnFigure]:
    counts = {"points": design.point_count, "microphones": len(design.microphones), "lines": len(design.lines)}
    return {name: OwnFigure(float(count)) for name, count in counts.items()}


def _of_design(subject: Subject, library: Library, printing: bool, display: Display) -> dict[str, OwnFigure]:
    """Verdict, predicted accuracies and print verdict; of a run those that it stored."""
    if library.fidelity == MEASURED:
        names = ("verdict", *(f"{whose}_{touch}" for whose in ("as_built", "nominal") for touch in TOUCH_WORDS))
        return dict.fromkeys(names, unknown("the library is of one sensor that was measured"))
    design = subject.design
    found, drawn = (_of_run(subject), None) if subject.results else _drawn(design, printing, display)
    return {**_judged(design, drawn), **_accuracies(design), **found}


def _target_in_words(design: ArrayDesign) -> str:
    """Force and radius of the contact that verdict and accuracies are for."""
    target = design.target
    return f"{target.force:g} N, contact of {target.contact_radius:g} mm radius"


def _accuracies(design: ArrayDesign) -> dict[str, OwnFigure]:
    """Predicted accuracies of as-built sensors and of the nominal one, for three kinds of touches."""
    names = [f"{whose}_{touch}" for whose in ("as_built", "nominal") for touch in TOUCH_WORDS]
    if why := _no_pairs("predicted", design):
        return dict.fromkeys(names, unknown(why))
    (found,) = accuracies([design])
    if isinstance(found, str):
        return dict.fromkeys(names, unknown(found))
    sides = {"as_built": found.as_built, "nominal": found.designed}
    return {
        f"{whose}_{touch}": OwnFigure(accuracy.mean, f"{percent(accuracy.low)} to {percent(accuracy.high)}")
        for whose, side in sides.items()
        for touch in TOUCH_WORDS
        for accuracy in [side[touch.replace("_", "-")]]
    }


def _judged(design: ArrayDesign, drawn: Drawn | None) -> dict[str, OwnFigure]:
    """Verdict with the rule that is broken worst, and the smallest tap that is detected on every point."""
    try:
        verdict = Verdict(design, drawn=drawn)
        broken = verdict.broken
    except Refusal as error:
        return dict.fromkeys(_JUDGED, unknown(str(error)))
    force = verdict.figures.smallest_force
    return {
        "verdict": OwnFigure(verdict.outcome),
        "reason": OwnFigure(verdict.values[broken[0].name].words) if broken else OwnFigure(None),
        "smallest_force": OwnFigure(force) if np.isfinite(force) else unknown("it needs two microphones"),
    }


def _drawn(design: ArrayDesign, wanted: bool, display: Display) -> tuple[dict[str, OwnFigure], Drawn | None]:
    """Print verdict and number of problems of building a design, and what the verdict needs of the drawn parts."""
    names = ("printing", "problems")
    if not wanted:
        return dict.fromkeys(names, unknown("parts were not drawn")), None
    if not is_installed("cad"):
        return dict.fromkeys(names, unknown("needs pip install 'acoustic-fem[cad]'")), None
    try:
        checked = check_design(design, quality=False, display=display)
    except Refusal as error:
        return dict.fromkeys(names, unknown(str(error))), None
    assert checked.printing is not None
    first = f"the first: {checked.problems[0]}" if checked.problems else ""
    found = {
        "printing": OwnFigure(checked.printing.verdict, checked.printing.process.name),
        "problems": OwnFigure(float(len(checked.problems)), first),
    }
    return found, checked.drawn


def _of_run(subject: Subject) -> dict[str, OwnFigure]:
    """Accuracies of the decoders of a run on the touches that its report lists, and its print verdict."""
    results = subject.results
    found: dict[str, OwnFigure] = {}
    try:
        printing = results["printing"]
        failed = sum(each["verdict"] == "fail" for each in printing["findings"])
        for key, title in _DECODERS.items():
            if (headline := results[key]) is not None:
                rows = [(headline["signals"], headline), *((_touches(each), each) for each in headline["beside"])]
                found |= {f"trained.{title}, {touches}": _accuracy(row) for touches, row in rows}
        found |= {
            "printing": OwnFigure(str(printing["verdict"]), str(printing["process"])),
            "problems": OwnFigure(float(failed)),
        }
        if isinstance(stored := results.get("verdict"), Mapping):  # runs of older versions have a text
            words = stored["reasons"][0]["words"] if stored["reasons"] else None
            found |= {"verdict": OwnFigure(str(stored["outcome"])), "reason": OwnFigure(words)}
    except (KeyError, IndexError, TypeError, ValueError, AttributeError) as error:
        problem = f"does not hold the results of a run of this version: {said_by(error)}"
        raise Refusal(problem, kind=Kind.UNREADABLE, file=subject.source, remedy="run the design again") from None
    return found


def _accuracy(row: Mapping[str, Any]) -> OwnFigure:
    """Top-1 accuracy of a row of ``results.json``, and that of the worst sensor if there are several."""
    worst = row.get("worst")
    return OwnFigure(float(row["top1"]), "" if worst is None else f"worst {percent(float(worst))}")


def _touches(outcome: Mapping[str, Any]) -> str:
    group, count = outcome["group"], outcome["sensors"]
    return f"{outcome['signals']} on {f'{count} {group}' if count > 1 else f'the {group}'}"
