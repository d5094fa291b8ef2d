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
    "applications/fingertip": ("robot finger", "robotic fingertip"),
    "applications/first-day": ("first sensor", "lab protocol", "report back"),
    "applications/glove": ("data glove", "glove", "glove sensor"),
    "applications/gripper-pad": ("gripper", "gripper pad", "robot gripper"),
    "applications/mat": ("desk mat", "floor mat", "foot", "mat"),
    "applications/pulse-reader": ("heart rate sensor", "heartbeat", "pulse reader"),
    "applications/wristband": ("bracelet", "wearable", "wrist", "wristband"),
    "assemble": ("assembly", "glue", "how to glue", "leak test"),
    "bending": ("bend radius", "bending", "curved surface"),
    "calibration": ("calibrate the sensor", "calibration", "calibration microphone", "recalibrate"),
    "decoder": ("decoder without training",),
    "embed": ("Arduino", "C code", "ESP32", "firmware", "microcontroller", "run on a microcontroller", "STM32"),
    "diagnosis": ("broken sensor", "fault", "leak", "production test"),
    "evidence/speed": ("processor time",),
    "formats": ("CSV files", "MATLAB", "Octave", "SOFA"),
    "gallery": ("examples of designs", "prototypes"),
    "install": ("install on Windows", "installation"),
    "live": ("data logger", "microphone input", "sound card", "USB"),
    "microphones": ("MEMS microphone", "which microphone"),
    "new-design": ("search a design", "target force"),
    "noise": ("sensitivity", "smallest force"),
    "parts": ("3D printer", "casting silicone", "mold", "resin printer", "STL", "STL files"),
    "cost": ("budget", "cost", "cost of a sensor", "hours of work", "price"),
    "questions": ("battery", "commercial use", "FAQ", "licence", "macOS", "patents", "power supply", "Windows"),
    "realtime": ("delay", "JavaScript", "latency", "ONNX", "reaction time"),
    "robot": ("my own CAD", "on a body", "robot", "robot skin", "STEP file"),
    "stock": ("bill of materials", "shopping list", "silicone supplier", "spring supplier", "where to buy"),
    "suits-you": ("altitude", "humidity", "lifetime", "operating temperature", "temperature", "water", "waterproof"),
    "tolerances": ("manufacturing tolerance",),
    "two-touches": ("multi touch", "multi-touch", "two fingers", "two fingers at once"),
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
