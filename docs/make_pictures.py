"""Draw the pictures of parts.md: top view, exploded view and mold section of every prototype that was made.

python docs/make_pictures.py [NAME ...]
"""

from __future__ import annotations

import sys
from pathlib import Path

import geometry
from geometry.assembly.model import array_model
from geometry.pictures.mold_cut import mold_section
from geometry.pictures.views import exploded_view, top_view

IMAGES = Path(__file__).parent / "images"
#: The prototypes that were made; the others are simulated studies.
MADE = ("array-2x6", "fingertip-3x4", "fingertip-4x6", "glove", "large-area-64")


def draw(name: str) -> list[Path]:
    """The three pictures of one prototype."""
    model = array_model(geometry.prototype(name))
    return [
        top_view(model, IMAGES / f"{name}-top.png", (1200, 750)),
        exploded_view(model, IMAGES / f"{name}-exploded.png", (1200, 750)),
        mold_section(model, IMAGES / f"{name}-mold.png", (1200, 600)),
    ]


def main() -> None:
    """Draw those named on the command line, or all."""
    names = sys.argv[1:] or MADE
    for name in names:
        if name not in MADE:
            raise SystemExit(f"{name}: must be of {', '.join(MADE)}")
    for name in names:
        for path in draw(name):
            print(path)


if __name__ == "__main__":
    main()
