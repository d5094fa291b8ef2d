"""Words on how to hold an array while it is glued, computed from where its parts stand."""

from __future__ import annotations

import numpy as np

from geometry.assembly.model import ArrayModel

#: Height below which parts stand on one plane, mm: what a strip of tape levels.
_LEVEL = 0.02


def shim_height(model: ArrayModel) -> float:
    """Height of the lowest face of the housings above that of the shells, mm."""
    return _lowest(model, "housing") - _lowest(model, "shell")


def holding_words(model: ArrayModel) -> str:
    """How to hold the shells and housings of an array while its tubes are glued; empty with a base plate or carrier."""
    design = model.design
    kinds = {part.kind for part in model.placed}
    if design.base.kind != "none" or "shell" not in kinds or design.layout.frozen is not None:
        return ""
    tilts = [abs(part.axes[2][2]) for part in model.placed if part.kind in ("shell", "housing")]
    if min(tilts) < 1 - 1e-6:
        return ""
    apart = _distances(model)
    steps = ["Stick double-sided tape onto a flat plate and stand each part on it as you glue it, membranes up."]
    height = shim_height(model)
    if abs(height) > _LEVEL:
        lower, upper = ("shells", "housings") if height > 0 else ("housings", "shells")
        steps.append(
            f"The bottoms of the {upper} are {abs(height):.2f} mm higher than those of the {lower}: lay paper or foil "
            f"of {abs(height):.2f} mm under the {upper}, so that the tubes at the ends stay straight."
        )
    where = "assembly.csv has the place of each part."
    if apart:
        where = f"{apart}, and {where}"
    steps.append(f"Tubes that are pushed in up to their lips set the distance: {where}")
    steps.append(
        'The program also draws a base plate with a seat for each part: write [base] kind = "plate" into design.toml '
        "and run acoustic-fem parts design.toml."
    )
    return " ".join(steps)


def _distances(model: ArrayModel) -> str:
    """Distances of neighbours on a line in words, of straight and of bent tubes; empty without neighbours."""
    places = {part.group: np.array(part.position) for part in model.placed if part.kind == "shell"}
    apart: dict[bool, list[float]] = {True: [], False: []}
    first = 1
    for number, line in enumerate(model.design.lines):
        for tube in model.layout.tubes:
            if tube.line == number and 0 < tube.segment < line.points:
                point = first + tube.segment - 1
                step = places[f"point {point}"] - places[f"point {point + 1}"]
                apart[tube.is_straight].append(float(np.linalg.norm(step)))
        first += line.points
    words = [
        f"the axes of neighbours at a {'straight' if straight else 'bent'} tube are {_range(found)} apart"
        for straight, found in apart.items()
        if found
    ]
    return ", ".join(words)


def _range(lengths: list[float]) -> str:
    """A length, or the shortest and the longest of several, mm."""
    low, high = min(lengths), max(lengths)
    return f"{low:.4g} mm" if high - low < _LEVEL else f"{low:.4g} to {high:.4g} mm"


def _lowest(model: ArrayModel, kind: str) -> float:
    """Height of the lowest face of all parts of a kind, mm."""
    return min(
        part.position[2] + float(model.shapes[part.part].BoundingBox().zmin)
        for part in model.placed
        if part.kind == kind
    )
