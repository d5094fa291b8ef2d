"""Words that people type into the search of the site, and the page that it lists first for each.

They become main entries of the index of their pages, which the search of Sphinx ranks above titles and text.
``in_browser.py`` types each of them into the built site.
"""

from __future__ import annotations

from docutils import nodes
from sphinx.addnodes import index
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

#: Page -> words.
WORDS = {
    "assemble": ("assembly", "glue", "leak test"),
    "bending": ("bend radius", "bending", "curved surface"),
    "calibration": ("calibration", "recalibrate"),
    "decoder": ("decoder without training",),
    "embed": ("Arduino", "C code", "ESP32", "firmware", "microcontroller", "STM32"),
    "evidence/speed": ("processor time",),
    "formats": ("CSV files", "MATLAB", "Octave", "SOFA"),
    "gallery": ("examples of designs", "prototypes"),
    "live": ("data logger", "microphone input", "sound card", "USB"),
    "new-design": ("gripper", "gripper pad", "mat", "robot", "robot skin", "wristband"),
    "noise": ("sensitivity", "smallest force"),
    "parts": ("3D printer", "casting silicone", "mold", "resin printer", "STL"),
    "cost": ("budget", "cost of a sensor", "hours of work", "price"),
    "questions": ("battery", "licence", "macOS", "patents", "power supply", "Windows"),
    "realtime": ("delay", "JavaScript", "latency", "ONNX"),
    "stock": ("bill of materials", "shopping list", "silicone supplier", "spring supplier", "where to buy"),
    "suits-you": ("altitude", "humidity", "lifetime", "temperature", "water", "waterproof"),
    "tolerances": ("manufacturing tolerance",),
    "two-touches": ("multi-touch", "two fingers"),
    "verdict": ("does my design work",),
}


class SearchWords(SphinxTransform):
    """Add the index entries of a page, before Sphinx collects those of all."""

    default_priority = 100

    def apply(self, **_: object) -> None:
        """Add them ahead of the text."""
        words = WORDS.get(self.env.docname, ())
        if not words:
            return
        place = "search-words"
        entries = [("single", word, place, "main", None) for word in words]
        section = next(iter(self.document.findall(nodes.section)))
        section.insert(1, [index(entries=entries, inline=False), nodes.target("", "", ids=[place])])


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the entries while pages are read."""
    app.add_transform(SearchWords)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
