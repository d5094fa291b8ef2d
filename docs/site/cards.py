"""Cards of the gallery, ``{gallery-cards}``: one for each design of gallery.json, with a form that filters them.

A card links to the section of its design. Without JavaScript all cards are shown; ``gallery.js`` shows the form and
hides the cards that it leaves out.
"""

from __future__ import annotations

import json
from html import escape
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

#: Filters: name of the data -> label and options, each a value and its words; numbers are upper limits.
LIMITS = {
    "points": ("Points", {"12": "up to 12", "24": "up to 24", "64": "up to 64"}),
    "cost": ("Cost", {"5": "up to 5 USD", "10": "up to 10 USD", "25": "up to 25 USD"}),
    "length": ("Longest side", {"50": "up to 50 mm", "100": "up to 100 mm", "300": "up to 300 mm"}),
}


def read_rows(docs: Path) -> list[dict[str, Any]]:
    """Designs of the gallery that have a verdict, as ``make_gallery.py`` wrote them."""
    rows: list[dict[str, Any]] = json.loads((docs / "gallery.json").read_text(encoding="utf-8"))
    return [row for row in rows if row["verdict"] is not None]


def short_printer(title: str) -> str:
    """Name of a printing process without its settings."""
    return title.partition(",")[0]


def form(rows: list[dict[str, Any]]) -> str:
    """The form of the filters, hidden until a script shows it."""
    verdicts = {row["verdict"]: row["verdict"] for row in rows}
    printers = {row["process"]: short_printer(row["printer"]) for row in rows}
    choices = {"verdict": ("Verdict", verdicts), "process": ("Printer", printers), **LIMITS}
    fields = "".join(
        f'<label>{label} <select name="{name}"><option value="">any</option>'
        + "".join(f'<option value="{escape(value)}">{escape(words)}</option>' for value, words in options.items())
        + "</select></label>"
        for name, (label, options) in choices.items()
    )
    return f'<form class="gallery-filters" hidden>{fields}<output role="status"></output></form>'


def data_of(row: dict[str, Any]) -> str:
    """Attributes of a card that the filters read."""
    values = {name: row[name] for name in ("verdict", "process", "points", "cost")}
    values["length"] = max(row["size"])
    return " ".join(f'data-{name}="{escape(str(value))}"' for name, value in values.items())


def facts(row: dict[str, Any]) -> str:
    """Facts of a card as a list of terms."""
    x, y, z = row["size"]
    taps = "not computed" if row["taps"] is None else f"{row['taps']:g} % of taps, as built"
    terms = {
        "Points": f"{row['points']} by {row['microphones']} microphones",
        "Size": f"{x:.0f} x {y:.0f} x {z:.0f} mm",
        "Force": f"from {row['force']}",
        "Accuracy": taps,
        "Cost": f"{row['cost']:.2f} USD",
        "Printer": short_printer(row["printer"]),
    }
    return "<dl>" + "".join(f"<dt>{name}</dt><dd>{escape(value)}</dd>" for name, value in terms.items()) + "</dl>"


class Cards(SphinxDirective):
    """The form, and a card for each design."""

    def run(self) -> list[nodes.Node]:
        """The nodes, whose pictures Sphinx copies beside the page."""
        docs = Path(self.env.srcdir)
        self.env.note_dependency(str(docs / "gallery.json"))
        rows = read_rows(docs)
        found: list[nodes.Node] = [_raw(form(rows)), _raw('<div class="gallery-cards" role="list">')]
        for row in rows:
            verdict = row["verdict"]
            found += [
                _raw(
                    f'<div class="gallery-card" role="listitem" {data_of(row)}>'
                    f'<a href="#{escape(row["name"])}"><strong>{escape(row["name"])}</strong></a>'
                    f'<span class="verdict {verdict.replace(" ", "-")}">{verdict}</span>'
                ),
                nodes.image(uri=f"images/gallery/{row['name']}.webp", alt=row["words"]),
                _raw(f"{facts(row)}</div>"),
            ]
        return [*found, _raw("</div>")]


def _raw(text: str) -> nodes.raw:
    return nodes.raw("", text, format="html")


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive."""
    app.add_directive("gallery-cards", Cards)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
