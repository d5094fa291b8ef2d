"""The bodies of the three examples as STEP: a fingertip, a handle and a palm. Run it in this folder."""

import math

import cadquery as cq
import numpy as np
from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
from OCP.gp import gp_Vec


def fingertip() -> cq.Workplane:
    """A capsule of 18 mm with a flat rear end."""
    radius, length = 9.0, 18.0  # mm
    tip = cq.Workplane(origin=(0, 0, length)).sphere(radius)
    return cq.Workplane().circle(radius).extrude(length).union(tip)


def handle() -> cq.Workplane:
    """A grip of 36 mm with a waist, 100 mm long."""
    outline = [(18, 20), (16, 50), (18, 80), (17, 100)]  # radius and height, mm
    side = cq.Workplane("XZ").lineTo(16, 0).spline(outline, includeCurrent=True).lineTo(0, 100).close()
    return side.revolve(360, (0, 0, 0), (0, 1, 0))


def palm() -> cq.Workplane:
    """A palm of 90 x 90 mm with a ball of the thumb beside a hollow, flat below."""

    def height(x: float, y: float) -> float:
        thumb = 7 * math.exp(-(((x + 24) / 24) ** 2) - ((y + 16) / 28) ** 2)
        hollow = 4 * math.exp(-(((x - 6) / 26) ** 2) - (y / 30) ** 2)
        return 22 - (x / 17) ** 2 - (y / 22) ** 2 + thumb - hollow

    along = np.linspace(-45, 45, 11)
    places = [[cq.Vector(x, y, height(x, y)) for y in along] for x in along]
    face = cq.Face.makeSplineApprox(places, tol=1e-3, smoothing=None, minDeg=3, maxDeg=5)
    below = cq.Shape.cast(BRepPrimAPI_MakePrism(face.wrapped, gp_Vec(0, 0, -60)).Shape())
    return cq.Workplane(obj=below.cut(cq.Workplane().box(200, 200, 200).translate((0, 0, -100)).val()))


if __name__ == "__main__":
    for body in (fingertip, handle, palm):
        cq.exporters.export(body(), f"{body.__name__}.step")
