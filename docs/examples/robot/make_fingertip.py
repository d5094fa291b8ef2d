"""The body of the example: a capsule of 18 mm with a flat rear end, as STEP. Run it in this folder."""

import cadquery as cq

RADIUS, LENGTH = 9.0, 18.0  # mm

tip = cq.Workplane(origin=(0, 0, LENGTH)).sphere(RADIUS)
finger = cq.Workplane().circle(RADIUS).extrude(LENGTH).union(tip)
cq.exporters.export(finger, "fingertip.step")
