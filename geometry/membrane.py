"""The membrane: a cast silicone disc."""

from __future__ import annotations

import cadquery as cq

from geometry.design import Membrane, Resonator
from geometry.shell import cylinder, one_solid


def membrane_radius(resonator: Resonator, membrane: Membrane) -> float:
    """Radius of the disc with its rim as it is cast, before it is stretched, mm."""
    return (resonator.cavity_diameter / 2 + membrane.rim_width) / membrane.stretch


def build_membrane(resonator: Resonator, membrane: Membrane) -> cq.Workplane:
    """Draw the disc as it is cast: axis z, lower face at z = 0."""
    return one_solid(cylinder(membrane_radius(resonator, membrane), 0, membrane.thickness), "membrane")
