"""Queries that people type into the search of the site, and the page that must come first for each.

``in_browser.py`` types them into the built site. Unlike :data:`search_words.WORDS`, which become entries of the index,
they are the test of it: words of a newcomer, of more than one word where people type more.
"""

from __future__ import annotations

#: Page -> queries.
QUERIES = {
    "applications/fingertip": ("robot finger", "robotic fingertip", "finger of a robot"),
    "applications/first-day": ("first sensor", "report back", "lab protocol"),
    "applications/glove": ("data glove", "glove sensor"),
    "applications/gripper-pad": ("robot gripper", "gripper"),
    "applications/mat": ("floor mat", "foot", "desk mat"),
    "applications/pulse-reader": ("heartbeat", "heart rate sensor"),
    "applications/wristband": ("wearable", "wrist", "bracelet"),
    "assemble": ("how to glue",),
    "calibration": ("calibrate the sensor", "calibration microphone"),
    "cost": ("cost", "how much does it cost", "price of a sensor"),
    "diagnosis": ("broken sensor", "leak"),
    "embed": ("arduino", "run on a microcontroller", "esp32"),
    "install": ("install on windows", "pip install"),
    "live": ("sound card input",),
    "microphones": ("which microphone",),
    "noise": ("smallest force",),
    "parts": ("3d printer", "stl files"),
    "questions": ("battery", "commercial use", "faq"),
    "realtime": ("latency", "reaction time"),
    "robot": ("robot", "my own cad", "step file"),
    "stock": ("spring supplier", "silicone supplier", "where to buy springs"),
    "suits-you": ("waterproof", "operating temperature"),
    "two-touches": ("multi touch", "two fingers at once"),
}
