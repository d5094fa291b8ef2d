"""Messages to a page that state what it offers, and all of a design."""

from __future__ import annotations

from typing import Any

from geometry.design.array_design import ArrayDesign
from geometry.design.design_file import prototype_names
from studies.comparison.quantities import figure_words
from studies.panels.curves import CURVES
from studies.panels.exploring import MOST_DESIGNS, MOST_METRICS, metric_words
from studies.panels.export_files import EXPORTS
from studies.panels.form import addable_tables, form_of, removable_tables, stated_values

#: File of the page that shows a design without a studio.
SHARED = "page.html"
#: Largest design file that is taken, bytes.
MOST_UPLOAD = 256 * 1024
_SHARED_WORDS = {
    "title": "this design to look at in any browser, without the studio and offline",
    "takes": "at once if all panels were shown, else half a minute",
}


def page_words() -> dict[str, Any]:
    """Names and explanations of the page that no design changes."""
    exports = {name: {"title": each.title, "takes": each.takes} for name, each in EXPORTS.items()}
    return {
        "prototypes": prototype_names(),
        "curves": CURVES,
        "figures": figure_words(),
        "metrics": metric_words(),
        "most_metrics": MOST_METRICS,
        "most_designs": MOST_DESIGNS,
        "exports": exports | {SHARED: _SHARED_WORDS},
        "most_upload": MOST_UPLOAD,
    }


def form_words(design: ArrayDesign) -> dict[str, Any]:
    """All fields of a design, its name, what its file states, and the tables that can be added and removed."""
    return {
        "form": form_of(design),
        "design_name": design.name,
        "stated": stated_values(design),
        "addable": addable_tables(design),
        "removable": removable_tables(design),
    }
