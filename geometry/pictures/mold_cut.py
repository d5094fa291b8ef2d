"""A picture of the closed mold, cut through its cavities."""

from __future__ import annotations

import os
from pathlib import Path

import cadquery as cq

from geometry.assembly.model import LOOKS, ArrayModel, array_model
from geometry.design.array_design import ArrayDesign
from geometry.molds.mold import Mold, mold_counts, mold_kinds
from geometry.molds.mold_plan import plan_mold
from geometry.pictures.canvas import aim, draw_labels, open_plotter, polydata, save_picture
from geometry.solids.membrane import membranes_of

_COLOURS = {"mold-base": "#d9c27a", "mold-lid": "#8fa7b8", "mold-scraper": "#8fa7b8"}


def mold_section(
    array: ArrayDesign | ArrayModel, path: str | os.PathLike[str], size: tuple[int, int] = (1600, 800)
) -> Path:
    """Render the mold as it lies closed with silicone in it, cut through the axes of its first row of cavities.

    Shims are left out; where membranes differ, it is the mold of the first point's. Arguments as for
    :func:`geometry.pictures.views.draw_array`.
    """
    model = array_model(array)
    design, parts = model.design, model.parts
    membrane, alike = next(iter(membranes_of(design).items()))
    of_kind = membrane.removeprefix("membrane")
    names = [name for name, kind in mold_kinds(alike).items() if kind != "mold-shim"]
    plan = plan_mold(alike)
    mold = Mold({name: parts[name + of_kind] for name in names}, mold_counts(alike), plan)
    cut_at = min(y for _, y in plan.centres)
    plotter = open_plotter(size)
    bodies = [(name, solid.val(), _COLOURS[name]) for name, solid in mold.parts.items()]
    bodies += [("silicone", cast.val(), LOOKS["membrane"][0]) for cast in mold.cast(parts[membrane])]
    for _, solid, colour in bodies:
        reach = 2 * (solid.BoundingBox().DiagonalLength + abs(cut_at) + 1)
        half = solid.cut(cq.Solid.makeBox(2 * reach, reach, 2 * reach, cq.Vector(-reach, cut_at - reach, -reach)))
        plotter.add_mesh(polydata(half), color=colour, split_sharp_edges=True, smooth_shading=True)
    # Names stand in the left margin, each at the height of its body.
    block = mold.parts["mold-base"].val().BoundingBox()
    x = block.xmin - 0.03 * block.xlen
    lid = mold.parts[names[-1]].val().BoundingBox()
    heights = {names[-1]: lid.zmax / 2, "silicone": min(z for _, z in plan.profile) / 2, names[0]: 0.8 * block.zmin}
    for name, height in heights.items():
        draw_labels(plotter, [(x, cut_at, height)], [name], 20, ("right", "center"))
    aim(plotter, (0.0, -1.0, 0.18), left=0.14)
    return save_picture(plotter, path)
