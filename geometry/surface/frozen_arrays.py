"""A try to lay an array as a design with frozen places: frames, ports, plan and lengths of its parts."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.design.frozen_rules import sizes_of
from geometry.design.shell_rules import membrane_top
from geometry.ground.typed import Array
from geometry.layout.placement import ArrayLayout
from geometry.plan.frozen import Ways
from geometry.plan.frozen_ways import ways_of
from geometry.schema.frozen_fields import FrozenPlaces
from geometry.schema.part_fields import STUB_LENGTH_IN_RADII
from geometry.schema.surface_fields import SurfaceFit
from geometry.surface.tubes import chosen_lengths, directions, equal_length, rounded_ports
from geometry.surface.unrolled import unrolled

#: Digits of places, mm, and of directions.
_PLACE, _DIRECTION = 4, 6
#: Degrees to which the ports of microphones are rounded: angles closer than that are one part.
_PORT = 0.1


@dataclass(frozen=True)
class Laid:
    """Points in the order of the lines and microphones in the order of the chain, at the height of their ports."""

    seed: int
    """Seed of the places."""
    counts: list[int]
    """Points of each line."""
    points: Array
    """Places of the points, (n, 3) float64, mm."""
    normals: Array
    """Normals of the points, (n, 3) float64."""
    microphones: Array
    """Places of the microphones, one more than lines, (m, 3) float64, mm."""
    microphone_normals: Array
    """Normals of the microphones, (m, 3) float64."""
    names: list[str]
    """Names of the microphones."""
    spacing: float
    """Usual distance of neighbours, mm."""
    design: ArrayDesign | None = None
    """The design with the frozen places."""
    layout: ArrayLayout | None = None
    """Its layout."""
    step: float = 0.0
    """Step of the lengths of tubes, mm."""

    def rounded(self) -> Laid:
        """The same in the digits that a file of places keeps."""
        return replace(
            self,
            points=self.points.round(_PLACE),
            microphones=self.microphones.round(_PLACE),
            normals=_unit(self.normals.round(_DIRECTION)),
            microphone_normals=_unit(self.microphone_normals.round(_DIRECTION)),
        )

    def all_places(self) -> Array:
        """Points, then microphones, (m, 3) float64, mm."""
        return np.vstack([self.points, self.microphones])

    def all_normals(self) -> Array:
        """Normals of :meth:`all_places`, (m, 3) float64."""
        return np.vstack([self.normals, self.microphone_normals])


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=1, keepdims=True))


def frozen_design(design: ArrayDesign, stated: SurfaceFit, laid: Laid) -> tuple[ArrayDesign, float]:
    """The design with an array laid on a body, and the step of its lengths, mm.

    Args:
        design: the array; its layout does not count.
        stated: the table ``[surface]``.
        laid: where its parts are, at the height of their ports.
    """
    axis = design.resonator.port_axis_height
    before, after = _neighbours(laid)
    forward, backward = (directions(laid.points, laid.normals, each) for each in (after, before))
    x, angles, _ = rounded_ports(forward, backward, laid.normals, stated.port_step)
    # At the height of the membranes, on which touches and tracks are computed in the plan.
    up = membrane_top(design) - axis
    plan = unrolled(laid.all_places() + up * laid.all_normals(), laid.all_normals(), laid.spacing).round(_PLACE)
    points = [
        _part(at - axis * normal, normal, way, [float(angle), 0.0], own)
        for at, normal, way, angle, own in zip(laid.points, laid.normals, x, angles, plan, strict=False)
    ]
    order = {name: k for k, name in enumerate(laid.names)}
    microphones = [
        _microphone(laid, order[name], axis, plan[len(laid.points) + order[name]]) for name in design.microphones
    ]
    data: dict[str, Any] = {
        "points": points,
        "microphones": microphones,
        "sizes": {field: value for field, (_, value) in sizes_of(design).items()},
        "seed": laid.seed,
    }
    lines = [
        line.model_copy(update={"points": count, "lengths": None, "pattern": line.pattern})
        for line, count in zip(design.lines, laid.counts, strict=True)
    ]
    counted = design.model_copy(update={"lines": tuple(lines)})
    ways = ways_of(counted, FrozenPlaces.model_validate(data))
    tubes = [tube for line in lines for tube in counted.tubes_of(line)]
    smallest = np.array([max(tube.smallest_bend_radius, tube.outer_diameter / 2) * 1.001 for tube in tubes])
    walls = ways.walls + 0.05
    least = np.maximum(
        walls, [max(STUB_LENGTH_IN_RADII * t.inner_diameter, 2 * design.printing.port_lip) for t in tubes]
    )
    lengths, sides, step = _lengths(design, stated, laid, ways, smallest, least + 1e-6)
    data["tubes"] = [{"side": float(side)} for side in sides]
    values, start = [], 0
    for line in lines:
        stop = start + line.points + 1
        values.append({**line.model_dump(), "lengths": lengths[start:stop].tolist()})
        start = stop
    return design.with_values({"layout": {"kind": "surface", "frozen": data}, "lines": values}), step


def _lengths(
    design: ArrayDesign, stated: SurfaceFit, laid: Laid, ways: Ways, smallest: Array, least: Array
) -> tuple[Array, Array, float]:
    """Lengths and sides of all tubes, (n,) each, and the finest step of the lengths, mm."""
    reach = design.resonator.outer_diameter
    ends = np.cumsum([0, *(count + 1 for count in laid.counts)])
    inner = np.ones(len(least), bool)
    inner[[*ends[:-1], *(ends[1:] - 1)]] = False
    if stated.tubes == "as they lie" or not inner.any():
        return chosen_lengths(ways, stated.length_step, smallest, least, laid.points, reach)
    lengths, sides, outer = np.empty(len(least)), np.empty(len(least)), ~inner
    lengths[inner], sides[inner], step = equal_length(
        ways.chosen(inner), stated.length_step, smallest[inner], least[inner], laid.all_places(), reach / 2
    )
    lengths[outer], sides[outer], other = chosen_lengths(
        ways.chosen(outer), stated.length_step, smallest[outer], least[outer], laid.points, reach
    )
    return lengths, sides, min(step, other)


def _neighbours(laid: Laid) -> tuple[Array, Array]:
    """Places of the part before and of that after each point, (n, 3) each."""
    before, after, start = [], [], 0
    for k, count in enumerate(laid.counts):
        own = laid.points[start : start + count]
        chain = np.vstack([laid.microphones[k][None], own, laid.microphones[k + 1][None]])
        before.append(chain[:-2])
        after.append(chain[2:])
        start += count
    return np.vstack(before), np.vstack(after)


def _microphone(laid: Laid, k: int, axis: float, plan: Array) -> dict[str, Any]:
    """A microphone whose x points along the tube of the first line that it joins."""
    at, normal = laid.microphones[k], laid.microphone_normals[k]
    stops = np.cumsum([0, *laid.counts]).tolist()
    ends = ([laid.points[stops[k] - 1]] if k > 0 else []) + ([laid.points[stops[k]]] if k < len(laid.counts) else [])
    ways = directions(np.repeat(at[None], len(ends), 0), np.repeat(normal[None], len(ends), 0), np.array(ends))
    x, y = ways[0], np.cross(normal, ways[0])
    angles = np.degrees(np.arctan2(ways @ y, ways @ x)) % 360
    return _part(at - axis * normal, normal, x, [round(round(float(a) / _PORT) * _PORT, 6) for a in angles], plan)


def _part(at: Array, normal: Array, x: Array, ports: list[float], plan: Array) -> dict[str, Any]:
    return {
        "at": at.round(_PLACE).tolist(),
        "normal": normal.round(_DIRECTION).tolist(),
        "x": x.round(_DIRECTION).tolist(),
        "ports": ports,
        "plan": (plan + 0.0).tolist(),
    }
