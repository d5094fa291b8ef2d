"""Write docs/gallery.md, its pictures and its designs: ``python docs/make_gallery.py``.

Every prototype, and designs of ours, with what ``acoustic-fem check`` predicts of them. A minute or two of one core.
"""

from __future__ import annotations

from pathlib import Path

import geometry
import studies
from studies.run import design_quality, draw_quality

DOCS = Path(__file__).parent
PAGE, PICTURES, EXAMPLES = DOCS / "gallery.md", DOCS / "images" / "gallery", DOCS / "examples"
#: Designs of ours that ``acoustic-fem new`` makes -> the answers to its questions.
MADE = {
    "wristband-16": {"place": "wrist", "points": 16, "pitch": 15.0},
    "glove-15": {"place": "hand", "points": 15},
    "pad-24": {"place": "flat", "points": 24, "pitch": 14.0, "microphones": 3},
    "flat-64": {"place": "flat", "points": 64, "pitch": 18.5, "microphones": 4},
}
#: Designs of ours that a search found, or that were drawn by hand.
FOUND = ("fingertip-12", "graded-line-36", "line-36", "ring-3x12")
#: Designs of ours that ``acoustic-fem fit`` laid on bodies.
FITTED = ("robot/fingertip", "robot/handle", "robot/palm")
_HEAD = """# Gallery

Pick a design that resembles yours and start from it. This page shows every prototype and some of our own designs, with
the figures that `acoustic-fem check` predicts.

Accuracies are predicted top-1 accuracies for the taps and presses of `acoustic-fem run`. They hold for the noise of
the design's microphone and for the tolerance-aware [decoder](decoder.md). As-built sensors have assumed
[tolerances](tolerances.md) and are not calibrated. Other pages give
different mean accuracies for the same design, because they use other touches, more sensors, another fidelity or another
decoder. [Calibrate](calibration.md) each sensor if the mean of the as-built
sensors is low because calibration removes most of the loss. The cost covers the materials of
one array at assumed prices. Molds are not included. In the pictures each point is coloured by its own accuracy, and
rings mark the *hardest pair*, the two points that are hardest to tell apart.

`acoustic-fem prototypes NAME` prints the file of a prototype. `acoustic-fem parts NAME --out parts` makes its parts.
For a design of ours, use the path of its file in place of the name.

<!-- made by python docs/make_gallery.py -->

Each row is a design, with the predicted top-1 accuracy for taps and presses: mean and fifth percentile of as-built
sensors, then the accuracy of the nominal sensor. Designs with many points are tested with fewer sensors. The hardest
pair is given with the level and phase by which its points differ (rms over 1 to 100 Hz).
"""


def main() -> None:
    """Write the missing designs, the pictures and the page."""
    for name, answers in MADE.items():
        path = EXAMPLES / f"{name}.toml"
        if not path.is_file():
            studies.new_design(name, path, **answers)
    designs = {name: geometry.prototype(name) for name in geometry.prototype_names()}
    ours = {name: geometry.load_design(EXAMPLES / f"{name}.toml") for name in (*MADE, *FOUND, *FITTED)}
    PAGE.write_text(gallery_page(designs, ours), encoding="utf-8")


def gallery_page(prototypes: dict[str, geometry.ArrayDesign], ours: dict[str, geometry.ArrayDesign]) -> str:
    """The page; pictures are written beside."""
    PICTURES.mkdir(parents=True, exist_ok=True)
    rows, blocks = [], []
    for file_name, design in {**ours, **prototypes}.items():
        name = file_name.replace("/", "-")
        quality = design_quality(design)
        assert quality is not None
        picture = draw_quality(design, quality, PICTURES / f"{name}.png")
        made = f"{100 * quality.as_built:.1f} ({100 * quality.worst:.1f})" if quality.sensors else "not computed"
        words = design.description.rstrip(".")
        rows.append(
            f"| [{name}](#{name}) | {words} | {design.point_count} | {len(design.microphones)} "
            f"| {made} | {100 * quality.nominal:.1f} "
            f"| {quality.hardest[0]}, {quality.hardest[1]}: {quality.level:.2g} dB, {quality.phase:.2g}° "
            f"| {quality.cost:.2f} |"
        )
        file = f"[{name}.toml](examples/{file_name}.toml)\n\n" if file_name in ours else ""
        link = picture.relative_to(DOCS).as_posix()
        blocks.append(f"### {name}\n\n{file}![In plan]({link})\n")
        print(rows[-1], flush=True)
    head = (
        "| design | description | points | microphones | as built: mean (5th percentile) (%) | nominal (%) "
        "| hardest pair | cost (USD) |\n|---|---|---|---|---|---|---|---|"
    )
    split = len(ours)
    parts = ["\n".join([head, *rows]), "## Designs of ours", *blocks[:split], "## Prototypes", *blocks[split:]]
    return _HEAD + "\n" + "\n\n".join(part.rstrip() for part in parts) + "\n"


if __name__ == "__main__":
    main()
