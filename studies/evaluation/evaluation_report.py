"""``evaluation.json`` and ``evaluation.html``: how well the touched point is named, on one self-contained page."""

from __future__ import annotations

import base64
import json
import tempfile
from importlib import resources
from pathlib import Path

import studies
from geometry.ground.refusal import counted
from geometry.ground.whole_files import made_folder, write_text
from studies.evaluation.evaluation_figures import draw_conditions, draw_reliability
from studies.evaluation.full_evaluation import SENSORS, FullEvaluation
from studies.evaluation.headline import SIGNALS, Headline
from studies.output.display import number
from studies.output.folders import write_json
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
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("studies"), autoescape=True, undefined=StrictUndefined, trim_blocks=True,
        lstrip_blocks=True,
    )  # fmt: skip
    environment.filters |= {"number": number, "counted": counted}
    return environment.get_template("evaluation_report.html").render(
        style=(resources.files(studies) / "templates" / "report.css").read_text(encoding="utf-8"),
        found=found,
        verdict=_verdict(found),
        noise=found.results[0].overall.noise_in_words,
        rows=list(zip(*(each.outcomes for each in found.results), strict=True)),
        sensors=SENSORS,
        pictures=_pictures(found),
        provenance=_provenance(found),
    )


def _verdict(found: FullEvaluation) -> str:
    """The page in three sentences."""
    headlines = [Headline.of(each.overall, each.outcomes, SENSORS, found.unscattered) for each in found.results]
    shares = " and ".join(
        f"the {each.name} assigns {100 * each.overall.top1:.1f} % to the correct point" for each in found.results
    )
    hardest = []
    for each in found.results:
        worst = min(each.outcomes, key=lambda outcome: outcome.top1)
        hardest.append(f"for the {each.name} {worst.group}, {worst.name} ({100 * worst.top1:.1f} %)")
    beside = [
        f"of {pairs[0][0]} {' and '.join(f'{100 * own.top1:.1f} %' for _, own in pairs)}"
        for pairs in zip(*(each.beside for each in headlines), strict=True)
    ]
    return (
        f"Held-out {SIGNALS} are classified as follows: {shares}; {', '.join(beside)}. The hardest condition is "
        f"{', '.join(hardest)}."
    )


def _pictures(found: FullEvaluation) -> dict[str, str]:
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        paths = {
            "reliability": draw_reliability(found.results, place / "reliability.png"),
            "conditions": draw_conditions(found.results, place / "conditions.png"),
        }
        for index, each in enumerate(found.results):
            name = f"confusion-{index}"
            paths[name] = draw_confusion(each.overall.confusion, found.points, place / f"{name}.png")
        encoded = {name: base64.b64encode(path.read_bytes()).decode("ascii") for name, path in paths.items()}
    return {name: "data:image/png;base64," + text for name, text in encoded.items()}


def _provenance(found: FullEvaluation) -> list[tuple[str, str]]:
    own = {key: value for key, value in found.provenance.items() if key not in ("design", "library")}
    library = {key: value for key, value in found.provenance["library"].items() if key != "cells"}
    return [
        ("made", found.created.strftime("%Y-%m-%d %H:%M UTC")),
        ("evaluation", json.dumps(own)),
        ("library", json.dumps(library)),
        ("design", found.provenance["design"]),
    ]
