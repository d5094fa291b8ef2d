"""The membrane: a cast silicone disc, flat, with a thicker rim or with a boss for the touch."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import geometry
from geometry.design.array_design import ArrayDesign
from geometry.schema.part_fields import Membrane, Resonator

if TYPE_CHECKING:
    import cadquery as cq


def membrane_radius(resonator: Resonator, membrane: Membrane) -> float:
    """Radius of the disc with its rim as it is cast, before it is stretched, mm."""
    return (resonator.cavity_diameter / 2 + membrane.rim_width) / membrane.stretch


def membranes_of(design: ArrayDesign) -> dict[str, ArrayDesign]:
    """The distinct membranes of a design, by the names of their parts: each as the design whose points all have it.

    Where there are several, their names end in their thickness in mm.
    """
    alike: dict[Membrane, ArrayDesign] = {}
    for kind in design.kinds:
        own = design.of_kind(kind)
        alike.setdefault(own.membrane, own)
    if len(alike) == 1:
        return dict(zip(["membrane"], alike.values(), strict=True))
    return {f"membrane-{membrane.thickness:g}": own for membrane, own in alike.items()}


def membrane_profile(design: ArrayDesign) -> tuple[tuple[float, float], ...]:
    """Half section of the membrane as cast: corners (radius, height) in mm, the glued face at height 0.

    Every upright wall leans by ``mold.draft`` towards the side that leaves the mold last, so that the glued
    face is the widest section: it has exactly the radius of :func:`membrane_radius`.
    """
    membrane, slope = design.membrane, math.tan(math.radians(design.mold.draft))
    radius, thickness = membrane_radius(design.resonator, membrane), membrane.thickness
    top = membrane.total_height
    raised = top - thickness
    glued = ((0.0, 0.0), (radius, 0.0))
    if membrane.shape == "rim":
        inner = design.resonator.cavity_diameter / 2
        rim = ((radius - top * slope, top), (inner + raised * slope, top), (inner, thickness))
        return (*glued, *rim, (0.0, thickness))
    if membrane.boss_diameter is not None:
        boss = membrane.boss_diameter / 2
        return (
            *glued,
            (radius - thickness * slope, thickness),
            (boss, thickness),
            (boss - raised * slope, top),
            (0, top),
        )
    return (*glued, (radius - thickness * slope, thickness), (0.0, thickness))


def build_membrane(design: ArrayDesign) -> cq.Workplane:
    """Draw the membrane as it is cast: axis z, glued face at z = 0, boss or rim upwards.

    Raises:
        Refusal: the drawn membrane is not one valid solid.
    """
    return geometry.solids.one_solid(geometry.solids.revolved(membrane_profile(design)), "membrane")
