"""Bodies on which arrays are laid, drawn by CadQuery: those of the acceptance, and the designs that they carry."""

from __future__ import annotations

import itertools
import math
from pathlib import Path
from typing import Any

import cadquery as cq
import numpy as np

import geometry

FINE = geometry.prototype("fingertip-3x4")
#: The region of a finger that touches.
PAD: dict[str, Any] = {
    "normal": {"towards": (0.8, 0, 0.6), "within": 78},
    "above": ({"point": (0, 0, 5), "normal": (0, 0, 1)},),
}


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


def wishes(**places: tuple[float, float, float]) -> tuple[dict[str, Any], ...]:
    """Places at which microphones are wanted, by their names."""
    return tuple({"name": name, "at": place} for name, place in places.items())


def half(point: tuple[float, float, float], normal: tuple[float, float, float]) -> dict[str, Any]:
    """The part of space above a plane."""
    return {"point": point, "normal": normal}


def cases() -> dict[str, tuple[geometry.ArrayDesign, str, dict[str, Any]]]:
    """What each body carries: parts, microphones, and the table [surface]; the first word is the body."""
    wrist = geometry.load_design("docs/examples/wristband-16.toml")
    ends = (half((0, 0, 14), (0, 0, 1)), half((0, 0, 96), (0, 0, -1)))
    sides = (half((38, 0, 0), (-1, 0, 0)), half((-38, 0, 0), (1, 0, 0)), half((0, 41, 0), (0, -1, 0)))
    up = {"towards": (0, 0, 1), "within": 45}
    return {
        "capsule": (FINE, "AB", {"pitch": 4.0, "region": PAD, "microphones": wishes(A=(-6, -7, 7), B=(-6, 7, 7))}),
        "capsule in pockets": (FINE, "AB", {"pitch": 4.0, "region": PAD, "seat": "in"}),
        "handle": (wrist, "AB", {"pitch": 15.0, "region": {"above": ends}}),
        "palm": (
            wrist,
            "ABC",
            {
                "pitch": 14.0,
                "region": {"normal": up, "above": (*sides, half((0, -41, 0), (0, 1, 0)))},
                "microphones": wishes(A=(-40, -44, 20), B=(40, -44, 20), C=(40, 44, 20)),
            },
        ),
        "panel": (
            wrist,
            "ABCD",
            {
                "pitch": 15.0,
                "region": {"normal": up},
                "microphones": wishes(A=(-70, 0, 108), B=(0, 70, 108), C=(70, 0, 108), D=(0, -70, 108)),
            },
        ),
    }


def design_of(parts: geometry.ArrayDesign, names: str, stated: dict[str, Any], points: int = 1) -> geometry.ArrayDesign:
    """A design to fit: lines that follow each other between microphones named by letters."""
    data = parts.model_dump()
    lines = [{"between": pair, "points": points} for pair in itertools.pairwise(names)]
    return geometry.ArrayDesign.model_validate(
        {**data, "microphones": tuple(names), "lines": lines, "layout": {"kind": "serpentine"},
         "surface": {"body": "body.step", **stated}}
    )  # fmt: skip
