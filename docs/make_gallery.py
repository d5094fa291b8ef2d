"""Write the gallery: docs/gallery.json, docs/gallery.md, its pictures and its designs: ``python docs/make_gallery.py``.

Every prototype, and designs of ours, with what ``acoustic-fem check`` predicts of them. Ten minutes or so of one core;
names of designs compute only these, and the others stay as docs/gallery.json has them.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

from PIL import Image

import geometry
import studies
from geometry.ground.whole_files import write_text
from geometry.pictures.views import draw_array
from geometry.schema.print_processes import process_of
from studies.run import design_quality, draw_quality
from studies.verdict import force_in_words

DOCS = Path(__file__).parent
PAGE, DATA, PICTURES, EXAMPLES = (
    DOCS / "gallery.md",
    DOCS / "gallery.json",
    DOCS / "images" / "gallery",
    DOCS / "examples",
)
#: Designs of ours that ``acoustic-fem new`` makes -> the answers to its questions.
MADE = {
    "wristband-16": {"place": "wrist", "points": 16, "pitch": 15.0},
    "glove-15": {"place": "hand", "points": 15},
    "pad-24": {"place": "flat", "points": 24, "pitch": 14.0, "microphones": 3},
    "flat-64": {"place": "flat", "points": 64, "pitch": 18.5, "microphones": 4},
}
#: Designs of ours that a page works out -> that page.
WORKED = {
    "gripper-pad": "gripper-pad",
    "wristband-10": "wristband",
    "glove-10": "glove",
    "floor-mat": "mat",
    "pulse-reader": "pulse-reader",
}
#: Designs of ours that a search found, or that were drawn by hand.
FOUND = ("fingertip-12", "graded-line-36", "line-36", "ring-3x12")
#: Designs of ours that ``acoustic-fem fit`` laid on bodies -> file below docs/examples.
FITTED = {"robot-fingertip": "robot/fingertip", "robot-handle": "robot/handle", "robot-palm": "robot/palm"}
#: Design -> page that works it out.
PAGE_OF = {**WORKED, "robot-fingertip": "fingertip"}
#: Size of the thumbnails and of the picture that each is reduced from, pixels; colours of the plans.
THUMBNAIL, DRAWN, COLOURS = (480, 300), (960, 600), 96
_HEAD = """# Gallery

This page shows every prototype and some of our own designs, with the figures that `acoustic-fem check` predicts. Pick a
design that resembles yours and start from it. Click a card to see the design and its kit.

```{gallery-cards}
```

<!-- made by python docs/make_gallery.py -->

## Meaning of the figures

The verdict is that of [`check`](verdict.md) without drawn parts. The smallest force is that of the weakest tap that can
be located at every point. The accuracy on the card is the predicted top-1 accuracy for taps with the force of the
target. Accuracies in the tables are predicted top-1 accuracies for the taps and presses of `acoustic-fem run`. They
hold for the noise of the design's microphone and for the tolerance-aware [decoder](decoder.md). As-built sensors have
the [tolerances of a sensor that nobody calibrated](tolerances.md#sensors-that-nobody-calibrated). Other pages give
different mean accuracies for the same design, because they use other touches, more sensors, another fidelity or another
decoder. If the mean of the as-built sensors is low, [calibrate](calibration.md) each sensor, because calibration
removes most of the loss. The cost covers the materials of one array at assumed prices, but not the molds. It assumes
that no spring is bent, so a kit's bill may differ by 0.5 %. In the pictures each point is coloured by its own accuracy,
and rings mark the *hardest pair*, the two points that are hardest to tell apart. The tables state the hardest pair with
the differences of its points in level and in phase (rms over 1 to 100 Hz).
"""


def main() -> None:
    """Write the missing designs, the pictures and the page."""
    for name, answers in MADE.items():
        path = EXAMPLES / f"{name}.toml"
        if not path.is_file():
            studies.new_design(name, path, **answers)
    ours, asked = (*WORKED, *MADE, *FOUND, *FITTED), sys.argv[1:]
    names = (*ours, *geometry.prototype_names())
    if unknown := set(asked) - set(names):
        raise SystemExit(f"{', '.join(sorted(unknown))}: must be of {', '.join(names)}")
    known = {row["name"]: row for row in json.loads(DATA.read_text("utf-8"))} if DATA.is_file() else {}
    for name in asked or names:
        known[name] = row_of(
            name, geometry.load_design(EXAMPLES / f"{FITTED.get(name, name)}.toml") if name in ours else None
        )
        print(known[name], flush=True)
        rows = [known[name] for name in names if name in known]
        write_text(DATA, json.dumps(rows, indent=1, ensure_ascii=False) + "\n")
    write_text(PAGE, gallery_page(rows))


def row_of(name: str, own: geometry.ArrayDesign | None) -> dict[str, Any]:
    """Figures of a design as JSON holds them; its pictures are written.

    Args:
        name: name of the design.
        own: the design, if it is no prototype.
    """
    design = geometry.prototype(name) if own is None else own
    verdict, quality = studies.Verdict(design), design_quality(design)
    assert quality is not None
    draw(name, design, quality)
    figures = verdict.figures
    accuracy = {"taps": figures.taps, "as_built": quality.as_built, "worst": quality.worst, "nominal": quality.nominal}
    return {
        "name": name,
        "ours": own is not None,
        "words": design.description.rstrip("."),
        "page": PAGE_OF.get(name),
        "process": process_of(design.printing).name,
        "printer": process_of(design.printing).title,
        "points": design.point_count,
        "microphones": len(design.microphones),
        "size": [round(each, 1) for each in figures.size],
        "force": force_in_words(figures.smallest_force),
        "target": design.target.force,
        "cost": round(quality.cost, 2),
        "verdict": verdict.outcome,
        "broken": [verdict.values[rule.name].words for rule in verdict.broken],
        **{key: round(100 * value, 1) if value == value else None for key, value in accuracy.items()},
        "hardest": f"{quality.hardest[0]}, {quality.hardest[1]}: {quality.level:.2g} dB, {quality.phase:.2g}°",
    }


def draw(name: str, design: geometry.ArrayDesign, quality: studies.DesignQuality) -> None:
    """Write the plan and the thumbnail of a design."""
    PICTURES.mkdir(parents=True, exist_ok=True)
    plan = draw_quality(design, quality, PICTURES / f"{name}.png")
    Image.open(plan).convert("RGB").quantize(COLOURS).save(plan, optimize=True)
    whole = draw_array(design, PICTURES / f"{name}-whole.png", DRAWN)
    Image.open(whole).convert("RGB").resize(THUMBNAIL, Image.Resampling.LANCZOS).save(
        PICTURES / f"{name}.webp", quality=75, method=6
    )
    whole.unlink()


def per_cent(value: float | None) -> str:
    """A percentage, or that it is not known."""
    return "not computed" if value is None else f"{value:.1f} %"


def section(row: dict[str, Any]) -> str:
    """Section of one design: its files, its plan and its figures."""
    name = row["name"]
    path = f"examples/{FITTED.get(name, name)}.toml"
    files = f" [Design file]({path})." if row["ours"] else ""
    worked = f" [Worked application](applications/{row['page']}.md)." if row["page"] else ""
    given = f"docs/{path}" if row["ours"] else name
    figures = {
        **_judged(row),
        "points, microphones": f"{row['points']}, {row['microphones']}",
        "printer": row["printer"],
        "cost": f"{row['cost']:.2f} USD",
        "taps and presses, as built: mean": per_cent(row["as_built"]),
        "taps and presses, as built: fifth percentile": per_cent(row["worst"]),
        "taps and presses, nominal": per_cent(row["nominal"]),
        "hardest pair": row["hardest"],
    }
    table = "\n".join(f"| {title} | {value} |" for title, value in figures.items())
    return "\n\n".join(
        [
            f"### {name}",
            f"{row['words']}.{files}{worked}",
            f"| figure | value |\n|---|---|\n{table}",
            f"```bash\nacoustic-fem parts {given} --out {name}-kit\n```",
            f"![{name} in plan](images/gallery/{name}.png)",
        ]
    )


def _judged(row: dict[str, Any]) -> dict[str, str]:
    """Figures of the verdict; none of a design on a body that only the plan's figures are known of."""
    if row["verdict"] is None:
        return {}
    x, y, z = row["size"]
    return {
        "verdict": row["verdict"] + (f": {'; '.join(row['broken'])}" if row["broken"] else ""),
        "size": f"{x:.0f} x {y:.0f} x {z:.1f} mm",
        "smallest force of a tap": row["force"],
        f"taps of {row['target']:g} N, as built": per_cent(row["taps"]),
    }


def gallery_page(rows: list[dict[str, Any]]) -> str:
    """The page."""
    split = {True: ["## Designs of ours"], False: ["## Prototypes"]}
    for row in rows:
        split[row["ours"]].append(section(row))
    return _HEAD + "\n" + "\n\n".join([*split[True], *split[False]]) + "\n"


if __name__ == "__main__":
    main()
