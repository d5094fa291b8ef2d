"""Places in the unrolled plan of an array on a body as places in space, and how far the plan is off."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import RBFInterpolator

from geometry.design.array_design import ArrayDesign
from geometry.design.shell_rules import membrane_top
from geometry.ground.typed import Array
from geometry.layout.placement import ArrayLayout
from geometry.surface.spread import nearest_spacing
from geometry.surface.unrolled import stretch_of

#: Error of the plan's distances, as a fraction, up to which paths in it have the right lengths and directions.
LARGEST_STRETCH = 0.1


@dataclass(frozen=True, eq=False)
class PlanInSpace:
    """The outside of an array on a body, by its plan."""

    plan: Array
    """Places of the points in the plan, (n, 2) float64, mm."""
    places: Array
    """Middles of their membranes in the coordinates of the body, (n, 3) float64, mm."""
    normals: Array
    """Directions away from the body there, (n, 3) float64."""
    stretch: float
    """Root mean square by which distances of neighbours are off in the plan, as a fraction."""
    worst: float
    """Largest error of such a distance, as a fraction."""

    @property
    def is_flat(self) -> bool:
        """True if paths in the plan have nearly the lengths and directions that they have on the body."""
        return self.stretch <= LARGEST_STRETCH

    def at(self, plan: Array) -> tuple[Array, Array]:
        """Places on the membranes and between them, with their normals.

        A smooth surface goes through the middles of all membranes (thin-plate spline, Duchon 1977).

        Args:
            plan: places in the plan, (n, 2) float64, mm.

        Returns:
            Places in the coordinates of the body, mm, and unit vectors away from it, both (n, 3) float64.
        """
        spread = np.linalg.matrix_rank(self.plan - self.plan[0], tol=1e-6)
        known = np.hstack([self.places, self.normals])
        if spread == 2 and len(self.plan) > 3:
            outside = RBFInterpolator(self.plan, known, kernel="thin_plate_spline", degree=1)
        else:
            outside = RBFInterpolator(self.plan, known, kernel="linear", degree=0)
        found = np.asarray(outside(plan))
        normals = found[:, 3:]
        return found[:, :3], normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)


def plan_in_space(design: ArrayDesign, layout: ArrayLayout) -> PlanInSpace:
    """The outside of an array by its plan.

    Args:
        design: the array.
        layout: where its parts lie.
    """
    top = membrane_top(design)
    frames = [layout.frame(point) for point in layout.points]
    plan = np.array([point.position for point in layout.points], np.float64)
    places = np.array([frame.at(0.0, 0.0, top) for frame in frames])
    normals = np.array([frame.axes[2] for frame in frames])
    spacing = float(np.median(nearest_spacing(places, normals))) if len(places) > 1 else 1.0
    stretch, worst = stretch_of(plan, places, normals, spacing)
    return PlanInSpace(plan, places, normals, stretch, worst)
