"""``evaluation.json`` and ``evaluation.html``: how often decoders find the touched point, as one page."""

from __future__ import annotations

from pathlib import Path

from geometry.ground.whole_files import made_folder, temporary_folder, write_text
from studies.evaluation.evaluated_sensors import SENSORS
from studies.evaluation.evaluation_figures import draw_conditions, draw_reliability
from studies.evaluation.full_evaluation import FullEvaluation
from studies.output.folders import write_json
from studies.output.report_texts import inlined_picture, percent, record_rows, rendered_page, with_worst
from studies.output.response_figures import draw_confusion

#: What is written into a folder, the page for people first.
FILES = PAGE_FILE, JSON_FILE = "evaluation.html", "evaluation.json"


def write_evaluation(found: FullEvaluation, folder: Path) -> None:
    """Write ``evaluation.json`` and ``evaluation.html``; the page last.

    Args:
        found: of :func:`studies.evaluation.full_evaluation.evaluate_fully`.
        folder: made where it does not exist.
    """
    made_folder(folder)
    write_json(folder / JSON_FILE, found.to_dict())
    write_text(folder / PAGE_FILE, render(found))


def render(found: FullEvaluation) -> str:
    """Page of an evaluation as text: pictures inlined, no script, nothing fetched."""
    return rendered_page(
        "evaluation_report.html",
        found=found,
        verdict=_verdict(found),
        accuracies=_accuracy_rows(found),
        noise=found.results[0].headline.noise_in_words,
        rows=list(zip(*(each.outcomes for each in found.results), strict=True)),
        sensors=SENSORS,
        pictures=_pictures(found),
        provenance=_provenance(found),
    )


def _verdict(found: FullEvaluation) -> str:
    """The accuracy of the first localizer, in one sentence; :func:`_accuracy_rows` has the other accuracies."""
    first = found.results[0]
    return (
        f"The {first.name} assigns {percent(first.headline.top1)} of held-out {first.headline.signals} to the correct "
        "point."
    )


def _accuracy_rows(found: FullEvaluation) -> list[tuple[str, ...]]:
    """Rows of the table of accuracies: touches and sensors, then a cell for each localizer."""
    headlines = [each.headline for each in found.results]
    rows = [(headlines[0].signals, *(with_worst(each.top1, each.worst) for each in headlines))]
    for pairs in zip(*(each.beside for each in headlines), strict=True):
        rows.append((pairs[0][0], *(with_worst(outcome.top1, outcome.worst) for _, outcome in pairs)))
    hardest = (min(each.outcomes, key=lambda outcome: outcome.top1) for each in found.results)
    cells = (f"{percent(worst.top1)} ({worst.group}: {worst.name})" for worst in hardest)
    return [*rows, ("the hardest of all conditions below", *cells)]


def _pictures(found: FullEvaluation) -> dict[str, str]:
    with temporary_folder() as place:
        paths = {
            "reliability": draw_reliability(found.results, place / "reliability.png"),
            "conditions": draw_conditions(found.results, place / "conditions.png"),
        }
        for index, each in enumerate(found.results):
            name = f"confusion-{index}"
            paths[name] = draw_confusion(each.headline.confusion, found.points, place / f"{name}.png")
        return {name: inlined_picture(path) for name, path in paths.items()}


def _provenance(found: FullEvaluation) -> list[tuple[str, str]]:
    own = {key: value for key, value in found.provenance.items() if key not in ("design", "library")}
    library = {key: value for key, value in found.provenance["library"].items() if key != "cells"}
    return [
        ("made", found.created.strftime("%Y-%m-%d %H:%M UTC")),
        *record_rows("evaluation", own),
        *record_rows("library", library),
        ("design", found.provenance["design"]),
    ]
