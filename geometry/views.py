"""Pictures of an array and of one point, rendered off screen to PNG."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

import cadquery as cq
import numpy as np
import pyvista as pv

from geometry.assembly import build_parts, place_parts
from geometry.design import ArrayDesign
from geometry.layout import ArrayLayout, place
from geometry.measure import tessellate
from geometry.routing import unit

if TYPE_CHECKING:
    from collections.abc import Mapping

_SHELL, _MEMBRANE, _MOLD, _HOUSING, _LID = "#9fb8cc", "#e39a7b", "#d9c27a", "#4f7f6b", "#2f2f2f"
_TUBE, _SCHEMATIC = "#4a4a4a", "#b08fc7"
#: Facets for the eye: within this distance (mm) and angle (rad).
_DEVIATION, _FACET_ANGLE = 0.05, 0.2
#: Tubes of a microphone lead away from the viewer where their directions add up to more than this.
_LEADS_AWAY = 0.1


def draw_array(
    design: ArrayDesign,
    path: str | os.PathLike[str],
    parts: Mapping[str, cq.Workplane] | None = None,
    size: tuple[int, int] = (1600, 1000),
) -> Path:
    """Render the whole array with translucent shells, numbered points and named microphones.

    Tubes drawn schematically (see :func:`geometry.layout.place`) have a colour of their own.

    Args:
        design: the array.
        path: of the PNG.
        parts: of :func:`geometry.build_parts`, where they exist already.
        size: width and height in pixels.
    """
    parts = build_parts(design) if parts is None else parts
    layout = place(design)
    copies: dict[str, list[tuple[tuple[float, float, float], float]]] = {}
    for placed in place_parts(design, layout):
        copies.setdefault(placed.part, []).append((placed.position, placed.rotation))
    plotter = _plotter(size)
    for name, places in copies.items():
        colour, opacity = _look(name)
        mesh = _copies(_polydata(parts[name].val()), places)
        plotter.add_mesh(mesh, color=colour, opacity=opacity, split_sharp_edges=True, smooth_shading=True)
    _add_tubes(plotter, layout)
    x0, x1, y0, y1, _, _ = plotter.bounds
    # Tall arrays are seen from their right side, so that they lie along the picture's longer edge.
    seen_from = (0.0, -0.7, 1.0) if x1 - x0 >= y1 - y0 else (0.7, 0.0, 1.0)
    _add_labels(plotter, design, layout, seen_from)
    _aim(plotter, seen_from)
    return _save(plotter, path)


def draw_point(
    design: ArrayDesign,
    path: str | os.PathLike[str],
    parts: Mapping[str, cq.Workplane] | None = None,
    size: tuple[int, int] = (1600, 1000),
) -> Path:
    """Render the parts of one point pulled apart: shell and membrane, beside them the open mold.

    A quarter of the shell and of the mold is cut away to show the cavity, a port and the groove. Arguments as
    for :func:`draw_array`; the shell is the first one of the design.
    """
    parts = build_parts(design) if parts is None else parts
    shell = next(name for name in parts if name.startswith("shell"))
    mold = parts["mold-base"].val().BoundingBox()
    top, thickness = design.resonator.cavity_height, design.membrane.thickness
    # The lid hangs clear of the pins, the mold clear of the shell although the view is oblique.
    lift, aside = 1.3 * (mold.zmax - thickness), design.resonator.outer_diameter / 2 + 0.8 * mold.xlen
    plotter = _plotter(size)
    labels, anchors = [], []
    for name, offset, cut in (
        (shell, (0.0, 0.0, 0.0), True),
        ("membrane", (0.0, 0.0, top + lift), False),
        ("mold-base", (aside, 0.0, 0.0), True),
        ("membrane", (aside, 0.0, 1.2 * lift), False),
        ("mold-lid", (aside, 0.0, 3.2 * lift), True),
    ):
        solid = parts[name].val()
        box = solid.BoundingBox()
        if cut:
            # The quarter towards the viewer; ports lie at 0 degrees and beyond, so one of them is cut in half.
            reach = 2 * (box.DiagonalLength + 1)
            solid = solid.cut(cq.Solid.makeBox(reach, reach, reach, cq.Vector(0, -reach, -reach / 2)))
        mesh = _copies(_polydata(solid), [(offset, 0.0)])
        plotter.add_mesh(mesh, color=_look(name)[0], split_sharp_edges=True, smooth_shading=True)
        labels.append(name)
        anchors.append((offset[0] + box.xmin, offset[1] + box.ymin, offset[2] + box.zmin))
    _labels(plotter, anchors, labels, 22, ("left", "top"))
    _aim(plotter, (0.25, -1.0, 0.6))
    return _save(plotter, path)


def _look(name: str) -> tuple[str, float]:
    """Colour and opacity of a part."""
    for start, colour, opacity in (
        ("shell", _SHELL, 0.45),
        ("membrane", _MEMBRANE, 0.6),
        ("mold", _MOLD, 1.0),
        ("microphone-lid", _LID, 1.0),
    ):
        if name.startswith(start):
            return colour, opacity
    return _HOUSING, 1.0


def _plotter(size: tuple[int, int]) -> pv.Plotter:
    # Without a display VTK warns that it looks for another way to render, and finds one.
    with pv.vtk_verbosity("error"):
        plotter = pv.Plotter(off_screen=True, window_size=list(size), lighting="three lights")
    plotter.set_background("white")
    plotter.enable_parallel_projection()
    return plotter


def _aim(plotter: pv.Plotter, seen_from: tuple[float, float, float]) -> None:
    """Look from a direction, with everything just inside the picture and room for labels at its edges."""
    plotter.view_vector(seen_from, viewup=(0, 0, 1))
    towards = np.array(seen_from) / np.linalg.norm(seen_from)
    right = np.cross((0, 0, 1), towards)
    right /= np.linalg.norm(right)
    up = np.cross(towards, right)
    points = np.vstack([mesh.points for mesh in plotter.meshes])
    lows, highs = zip(
        *((float((points @ axis).min()), float((points @ axis).max())) for axis in (right, up)), strict=True
    )
    centre = sum((low + high) / 2 * axis for low, high, axis in zip(lows, highs, (right, up), strict=True))
    width, height = plotter.window_size
    half = max((highs[1] - lows[1]) / 2, (highs[0] - lows[0]) / 2 * height / width)
    distance = 2 * float(np.linalg.norm(points.max(axis=0) - points.min(axis=0)))
    plotter.camera.focal_point = centre
    plotter.camera.position = centre + distance * towards
    plotter.camera.parallel_scale = 1.16 * half
    plotter.reset_camera_clipping_range()


def _save(plotter: pv.Plotter, path: str | os.PathLike[str]) -> Path:
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(f".{path.stem}.{os.getpid()}.png")
    try:
        plotter.screenshot(str(beside))
        os.replace(beside, path)
    finally:
        plotter.close()
        beside.unlink(missing_ok=True)
    return path


def _polydata(solid: cq.Shape) -> pv.PolyData:
    facets = tessellate(solid, _DEVIATION, _FACET_ANGLE)
    return pv.PolyData.from_regular_faces(facets.vertices, facets.triangles)


def _copies(mesh: pv.PolyData, places: list[tuple[tuple[float, float, float], float]]) -> pv.PolyData:
    """One mesh of all copies, each turned about z (degrees) and then moved."""
    points, triangles = [], []
    for count, (position, rotation) in enumerate(places):
        c, s = np.cos(np.radians(rotation)), np.sin(np.radians(rotation))
        points.append(mesh.points @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) + position)
        triangles.append(mesh.regular_faces + count * mesh.n_points)
    return pv.PolyData.from_regular_faces(np.vstack(points), np.vstack(triangles))


def _add_tubes(plotter: pv.Plotter, layout: ArrayLayout) -> None:
    for schematic, colour in ((False, _TUBE), (True, _SCHEMATIC)):
        meshes = [
            pv.MultipleLines(tube.path).tube(radius=tube.tube.outer_diameter / 2, n_sides=16)
            for tube in layout.tubes
            if tube.schematic == schematic
        ]
        if meshes:
            plotter.add_mesh(pv.merge(meshes), color=colour, smooth_shading=True)


def _add_labels(
    plotter: pv.Plotter, design: ArrayDesign, layout: ArrayLayout, seen_from: tuple[float, float, float]
) -> None:
    top = design.resonator.cavity_height + design.membrane.thickness
    _labels(plotter, [(*p.position, top) for p in layout.points], [str(p.number) for p in layout.points], 16)
    # Names stand behind their housing as seen in the picture, before it where its tubes lead away from the viewer.
    towards = np.array(seen_from[:2]) / np.linalg.norm(seen_from[:2])
    housing = design.microphone.chamber_diameter + 2 * design.microphone.wall_thickness
    reach = max(0.8 * housing, design.resonator.outer_diameter / 2)
    for microphone in layout.microphones:
        before = sum(float(unit(port.angle) @ towards) for port in microphone.ports) < -_LEADS_AWAY
        x, y = np.add(microphone.position, (reach if before else -reach) * towards)
        words = [f"microphone {microphone.name}"]
        height = -design.resonator.floor_thickness if before else top
        _labels(plotter, [(x, y, height)], words, 20, ("center", "top" if before else "bottom"))


def _labels(
    plotter: pv.Plotter,
    anchors: list[tuple[float, float, float]],
    words: list[str],
    size: int,
    justified: tuple[str, str] = ("center", "center"),
) -> None:
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
