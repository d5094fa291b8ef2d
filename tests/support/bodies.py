"""Bodies on which arrays are laid, drawn by CadQuery: those of the acceptance, and files that must be refused."""

from __future__ import annotations

import math
from pathlib import Path

import cadquery as cq
import numpy as np


def capsule() -> cq.Workplane:
    """A finger of 18 mm with a flat rear end."""
    tip = cq.Workplane(origin=(0, 0, 18)).sphere(9)
    return cq.Workplane().circle(9).extrude(18).union(tip)


def handle() -> cq.Workplane:
    """A grip with a waist, 110 mm long."""
    points = [(17, 15), (15, 38), (18.5, 62), (15.5, 88), (17, 110)]
    outline = cq.Workplane("XZ").moveTo(0, 0).lineTo(14, 0).spline(points, includeCurrent=True).lineTo(0, 110).close()
    return outline.revolve(360, (0, 0, 0), (0, 1, 0))


def palm() -> cq.Workplane:
    """A free surface with a hollow between two hills, closed downwards."""
    from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
    from OCP.gp import gp_Vec

    def height(x: float, y: float) -> float:
        hills = ((-26, -20, 9, 20, 26), (27, -16, 5, 15, 28), (0, 34, 5, 40, 12), (2, -4, -5, 18, 22))
        bumps = sum(a * math.exp(-(((x - cx) / sx) ** 2) - ((y - cy) / sy) ** 2) for cx, cy, a, sx, sy in hills)
        return 22 - 0.004 * x**2 - 0.0022 * y**2 + bumps

    places = [[cq.Vector(x, y, height(x, y)) for y in np.linspace(-46, 46, 13)] for x in np.linspace(-42, 42, 13)]
    face = cq.Face.makeSplineApprox(places, tol=1e-3, smoothing=None, minDeg=3, maxDeg=5)
    solid = cq.Shape.cast(BRepPrimAPI_MakePrism(face.wrapped, gp_Vec(0, 0, -60)).Shape())
    below = cq.Workplane().box(200, 200, 200).translate((0, 0, -100)).val()
    return cq.Workplane(obj=solid.cut(below))


def panel() -> cq.Workplane:
    """A cap of a ball of 130 mm, 160 mm across and 5 mm thick."""
    shell = cq.Workplane().sphere(130).cut(cq.Workplane().sphere(125))
    return shell.intersect(cq.Workplane().circle(80).extrude(200))


BODIES = {"capsule": capsule, "handle": handle, "palm": palm, "panel": panel}


def written(body: cq.Workplane, path: Path) -> Path:
    """The file of a body, STEP or STL by its ending."""
    cq.exporters.export(body, str(path))
    return path
