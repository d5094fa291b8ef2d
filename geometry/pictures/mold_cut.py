"""Pictures of a mold: closed and cut through its cavities, and open."""

from __future__ import annotations

import os
from pathlib import Path

import cadquery as cq

from geometry.assembly.model import LOOKS, ArrayModel, array_model
from geometry.design.array_design import ArrayDesign
from geometry.molds.mold import Mold, mold_counts, mold_kinds, molds_of
from geometry.molds.mold_plan import plan_mold
from geometry.pictures.canvas import aim, draw_labels, open_plotter, polydata, save_picture

_COLOURS = {"mold-base": "#d9c27a", "mold-lid": "#8fa7b8", "mold-scraper": "#8fa7b8", "mold-plugs": "#7fae86"}
#: Gap between the parts of an open mold, mm.
_APART = 9.0
#: Further gap below the lid, mm, through which the membranes are seen.
_ABOVE = 14.0


def mold_section(
    array: ArrayDesign | ArrayModel, path: str | os.PathLike[str], size: tuple[int, int] = (1600, 800)
) -> Path:
    """Render the mold as it lies closed with silicone in it, cut through the axes of its first row of cavities.

    Shims are left out; where membranes differ, it is the mold of the first point's. Arguments as for
    :func:`geometry.pictures.views.draw_array`.
    """
    mold, membrane = _first_mold(array_model(array))
    cut_at = min(y for _, y in mold.plan.centres)
    plotter = open_plotter(size)
    bodies = [(name, solid.val(), _COLOURS[name]) for name, solid in mold.parts.items()]
    bodies += [("silicone", cast.val(), LOOKS["membrane"][0]) for cast in mold.cast(membrane)[-mold.plan.columns :]]
    for _, solid, colour in bodies:
        reach = 2 * (solid.BoundingBox().DiagonalLength + abs(cut_at) + 1)
        half = solid.cut(cq.Solid.makeBox(2 * reach, reach, 2 * reach, cq.Vector(-reach, cut_at - reach, -reach)))
        plotter.add_mesh(polydata(half), color=colour, split_sharp_edges=True, smooth_shading=True)
    # Names stand in the left margin, each at the height of its body.
    x = -1.06 * mold.plan.half[0]
    box = {name: solid.val().BoundingBox() for name, solid in mold.parts.items()}
    heights = {"silicone": min(z for _, z in mold.plan.profile) / 2, "mold-base": 0.75 * mold.plan.bottom}
    heights |= {name: box[name].zmax / 2 for name in ("mold-lid", "mold-scraper") if name in box}
    heights |= {name: box[name].zmin + 0.2 for name in ("mold-plugs",) if name in box}
    for name, height in heights.items():
        draw_labels(plotter, [(x, cut_at, height)], [name], 20, ("right", "center"))
    aim(plotter, (0.0, -1.0, 0.18), left=0.14)
    return save_picture(plotter, path)


def open_mold(
    array: ArrayDesign | ArrayModel, path: str | os.PathLike[str], size: tuple[int, int] = (1600, 1000)
) -> Path:
    """Render the parts of the mold above each other, opened, with the membranes above the base.

    Shims are left out; where membranes differ, it is the mold of the first point's. Arguments as for
    :func:`geometry.pictures.views.draw_array`.
    """
    mold, membrane = _first_mold(array_model(array))
    plotter = open_plotter(size)
    order = ("mold-plugs", "mold-base", "silicone", "mold-lid", "mold-scraper")
    solids = {name: [solid.val()] for name, solid in mold.parts.items()}
    solids["silicone"] = [cast.val() for cast in mold.cast(membrane)]
    colours = {**_COLOURS, "silicone": LOOKS["membrane"][0]}
    x = -1.06 * mold.plan.half[0]
    for level, name in enumerate(name for name in order if name in solids):
        height = level * _APART + (_ABOVE if name in ("mold-lid", "mold-scraper") else 0.0)
        for solid in solids[name]:
            raised = solid.moved(cq.Location(cq.Vector(0, 0, height)))
            plotter.add_mesh(polydata(raised), color=colours[name], split_sharp_edges=True, smooth_shading=True)
        middle = cq.Compound.makeCompound(solids[name]).BoundingBox().center.z
        draw_labels(plotter, [(x, -mold.plan.half[1], middle + height)], [name], 20, ("right", "center"))
    aim(plotter, (0.25, -1.0, 0.8), left=0.14)
    return save_picture(plotter, path)


def _first_mold(model: ArrayModel) -> tuple[Mold, cq.Workplane]:
    """Mold of the first kind of membrane without its shims, and that membrane."""
    membrane, alike = next(iter(molds_of(model.design).items()))
    of_kind = membrane.removeprefix("membrane")
    names = [name for name, kind in mold_kinds(alike).items() if kind != "mold-shim"]
    solids = {name: model.parts[name + of_kind] for name in names}
    return Mold(solids, mold_counts(alike), plan_mold(alike)), model.parts[membrane]
