"""A canvas for pictures of parts: a plotter off screen, its camera, labels, and the file."""

from __future__ import annotations

import os
from pathlib import Path

import cadquery as cq
import numpy as np
import pyvista as pv

from geometry.ground.missing_packages import load_before_renderer
from geometry.ground.typed import Array
from geometry.ground.whole_files import made_folder, whole_file
from geometry.solids.measure import tessellate

#: Facets for the eye: within this distance (mm) and angle (rad).
_DEVIATION, _FACET_ANGLE = 0.05, 0.2
#: White around everything, as a factor, and half of the tick of a dimension, pixels.
_MARGIN, _TICK = 1.16, 6
#: Direction or place as x, y and z.
Direction = tuple[float, float, float]


def open_plotter(size: tuple[int, int]) -> pv.Plotter:
    """A plotter off screen, of that size in pixels."""
    load_before_renderer()
    # Without a display VTK warns that it looks for another way to render, and finds one.
    with pv.vtk_verbosity("error"):
        plotter = pv.Plotter(off_screen=True, window_size=list(size), lighting="three lights")
    plotter.set_background("white")
    plotter.enable_parallel_projection()
    return plotter


def aim(
    plotter: pv.Plotter,
    seen_from: Direction,
    upwards: Direction = (0.0, 0.0, 1.0),
    left: float = 0.0,
    right: float = 0.0,
) -> None:
    """Look from a direction, with everything just inside the picture and room for labels at its edges.

    ``left`` and ``right`` are the parts of the picture's width kept free for labels at its edges.
    """
    plotter.view_vector(seen_from, viewup=upwards)
    across, up, towards = picture_axes(seen_from, upwards)
    points = np.vstack([mesh.points for mesh in plotter.meshes])
    centre = sum(
        (float((points @ axis).min()) + float((points @ axis).max())) / 2 * axis for axis in (across, up)
    )  # fmt: skip
    pixel = pixel_size(plotter, seen_from, upwards, left, right)
    centre = centre + (right - left) / 2 * plotter.window_size[0] * pixel / _MARGIN * across
    distance = 2 * float(np.linalg.norm(points.max(axis=0) - points.min(axis=0)))
    plotter.camera.focal_point = centre
    plotter.camera.position = centre + distance * towards
    plotter.camera.parallel_scale = pixel * plotter.window_size[1] / 2
    plotter.reset_camera_clipping_range()


def pixel_size(
    plotter: pv.Plotter,
    seen_from: Direction,
    upwards: Direction = (0.0, 0.0, 1.0),
    left: float = 0.0,
    right: float = 0.0,
) -> float:
    """Size of a pixel, mm, if what was drawn so far is looked at; arguments as for :func:`aim`."""
    points = np.vstack([mesh.points for mesh in plotter.meshes])
    wide, tall = (float(np.ptp(points @ axis)) for axis in picture_axes(seen_from, upwards)[:2])
    width, height = plotter.window_size
    return _MARGIN * max(tall / height, wide / (width * (1 - left - right)))


def picture_axes(seen_from: Direction, upwards: Direction = (0.0, 0.0, 1.0)) -> tuple[Array, Array, Array]:
    """Unit vectors to the right and upwards in a picture, and towards its viewer; (3,) float64 each."""
    towards = np.array(seen_from) / np.linalg.norm(seen_from)
    across = np.cross(upwards, towards)
    across /= np.linalg.norm(across)
    return across, np.cross(towards, across), towards


def save_picture(plotter: pv.Plotter, path: str | os.PathLike[str]) -> Path:
    """Write what the plotter shows as PNG; missing folders are made."""
    path = Path(path)
    made_folder(path.parent)
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


def draw_dimension(plotter: pv.Plotter, ends: tuple[Array, Array], aside: Direction, words: str, pixel: float) -> None:
    """Draw a dimension as in an engineering drawing: a line with a tick at each end, and words beyond its middle.

    Args:
        plotter: seen straight from above.
        ends: of what is measured, (3,) float64 each, mm.
        aside: from there to the line, mm, along x or along y.
        words: what the length is.
        pixel: size of a pixel, mm.
    """
    begin, end = (place + aside for place in ends)
    outwards = np.array(aside) / np.linalg.norm(aside)
    tick = _TICK * pixel * outwards
    for first, last in ((begin, end), (begin - tick, begin + tick), (end - tick, end + tick)):
        plotter.add_mesh(pv.Line(first, last), color="black", line_width=2)
    x, y, z = ((begin + end) / 2 + 2 * tick).tolist()
    across, up = outwards[:2]
    horizontal = "center" if across == 0 else "left" if across > 0 else "right"
    vertical = "center" if up == 0 else "bottom" if up > 0 else "top"
    draw_labels(plotter, [(x, y, z)], [words], 20, (horizontal, vertical))


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
