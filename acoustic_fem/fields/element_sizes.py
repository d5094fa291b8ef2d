"""Sizes of elements from the thickness of the viscous and thermal layers."""

from __future__ import annotations

import numpy as np

from acoustic_fem.quantities.local_air import AirLike, medium_of
from acoustic_fem.quantities.units import metres
from geometry.air.mesh import MeshSizes


def mesh_sizes(scale: float, width: float, air: AirLike, highest: float) -> tuple[MeshSizes, MeshSizes]:
    """Element sizes for the flow and for heat at a scale.

    In cells of designs 1 gives 2e-4 to 4e-4 in the admittances from the flow and, in those like the reference cell,
    1.5e-3 in the compliance from heat; both fall with the third to fourth power of the scale.

    Mouths and tubes count in bore radii. The viscous layer at the highest frequency limits the sizes along
    tubes and in the cavity, the thermal layer those along walls. Elements of 1.4 viscous layers leave 7e-3 of a wide
    bore's admittance, those of 6 in a wide cavity 1.6e-3, and meshes coarser than that agree with each other.

    Args:
        scale: of the sizes, a ratio; 1 is the usual mesh.
        width: smallest extent of the cavity, mm.
        air: a :class:`acoustic_fem.LocalAir`, or a gas of its own.
        highest: frequency, Hz.
    """
    medium = medium_of(air)
    largest = 0.35 * scale * width
    viscous = _layer_thickness(medium.kinematic_viscosity, highest)
    thermal = _layer_thickness(medium.thermal_diffusivity, highest)
    return (
        MeshSizes(
            # The flow is singular at the edge of a mouth, and the residual there falls with the size alone, or little
            # faster; elsewhere it falls with the third power and more, and has the other sign. With the square here all
            # falls alike: otherwise the two cancel on one mesh and not on the next.
            mouth_edge=0.1 * scale**2,
            tube=0.42 * scale,
            growth=min(0.42 * scale, 0.8),
            largest=min(largest, 4.5 * scale * viscous),
            tube_layer=0.67 * scale * viscous,
        ),
        MeshSizes(mouth_edge=scale, tube=0.7 * scale, growth=1.5, largest=largest, wall=1.3 * scale * thermal),
    )


def _layer_thickness(diffusivity: float, frequency: float) -> float:
    """Viscous or thermal layer sqrt(2 nu / w), mm."""
    return float(np.sqrt(diffusivity / (np.pi * frequency))) / metres(1.0)
