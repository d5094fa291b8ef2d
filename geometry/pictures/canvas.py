"""A canvas for pictures of parts: a plotter off screen, its camera, labels, and the file."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

import cadquery as cq
import numpy as np
import pyvista as pv

from geometry.files.writing import whole_file
from geometry.solids.measure import tessellate

if TYPE_CHECKING:
    pass


#: Facets for the eye: within this distance (mm) and angle (rad).
_DEVIATION, _FACET_ANGLE = 0.05, 0.2


def open_plotter(size: tuple[int, int]) -> pv.Plotter:
    """A plotter off screen, of that size in pixels."""
    # Without a display VTK warns that it looks for another way to render, and finds one.
    with pv.vtk_verbosity("error"):
        plotter = pv.Plotter(off_screen=True, window_size=list(size), lighting="three lights")
    plotter.set_background("white")
    plotter.enable_parallel_projection()
    return plotter


def aim(
    plotter: pv.Plotter,
    seen_from: tuple[float, float, float],
    upwards: tuple[float, float, float] = (0.0, 0.0, 1.0),
    left: float = 0.0,
) -> None:
    """Look from a direction, with everything just inside the picture and room for labels at its edges.

    ``left`` is the part of the picture's width kept free for labels at its left edge.
    """
    plotter.view_vector(seen_from, viewup=upwards)
    towards = np.array(seen_from) / np.linalg.norm(seen_from)
    right = np.cross(upwards, towards)
    right /= np.linalg.norm(right)
    up = np.cross(towards, right)
    points = np.vstack([mesh.points for mesh in plotter.meshes])
    lows, highs = zip(
        *((float((points @ axis).min()), float((points @ axis).max())) for axis in (right, up)), strict=True
    )
    centre = sum((low + high) / 2 * axis for low, high, axis in zip(lows, highs, (right, up), strict=True))
    width, height = plotter.window_size
    half = max((highs[1] - lows[1]) / 2, (highs[0] - lows[0]) / 2 * height / (width * (1 - left)))
    centre = centre - left * half * width / height * right
    distance = 2 * float(np.linalg.norm(points.max(axis=0) - points.min(axis=0)))
    plotter.camera.focal_point = centre
    plotter.camera.position = centre + distance * towards
    plotter.camera.parallel_scale = 1.16 * half
    plotter.reset_camera_clipping_range()


def save_picture(plotter: pv.Plotter, path: str | os.PathLike[str]) -> Path:
    """Write what the plotter shows as PNG; missing folders are made."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        with whole_file(path) as beside:
            plotter.screenshot(str(beside))
    finally:
        plotter.close()
    return path


def polydata(solid: cq.Shape) -> pv.PolyData:
    """The facets of a solid, fine enough for pictures."""
    facets = tessellate(solid, _DEVIATION, _FACET_ANGLE)
    return pv.PolyData.from_regular_faces(facets.vertices, facets.triangles)


def draw_labels(
    plotter: pv.Plotter,
    anchors: list[tuple[float, float, float]],
    words: list[str],
    size: int,
    justified: tuple[str, str] = ("center", "center"),
) -> None:
    """Write texts at places of the scene; nothing hides them."""
    plotter.add_point_labels(
        np.array(anchors),
        words,
        font_size=size,
        text_color="black",
        shape=None,
        show_points=False,
        always_visible=True,
        justification_horizontal=justified[0],
        justification_vertical=justified[1],
    )
