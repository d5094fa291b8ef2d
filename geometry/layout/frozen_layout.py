"""Layouts whose places are stated in space: laying them out, and freezing any other layout."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from geometry.design.array_design import ArrayDesign
from geometry.ground.refusal import Kind
from geometry.layout.placement import (
    ArrayLayout,
    Housings,
    MicrophonePlacement,
    MicrophonePort,
    PointPlacement,
    TubePlacement,
)
from geometry.plan.cylinder import Frame
from geometry.plan.frozen import FrozenSurface, frame_of, smooth_courses
from geometry.plan.frozen_ways import microphone_ports, ways_of
from geometry.plan.routing import tidy
from geometry.schema.field_errors import DesignError
from geometry.schema.frozen_fields import FrozenPlaces
from geometry.schema.part_fields import Tube
from geometry.schema.ports import Port


def frozen_housings(design: ArrayDesign, frozen: FrozenPlaces) -> Housings:
    """Shells and microphones where the design states them."""
    return _housings(design, frozen, [design.tubes_of(line) for line in design.lines], _surface(frozen))


def _housings(
    design: ArrayDesign, frozen: FrozenPlaces, tubes_of: Sequence[Sequence[Tube]], surface: FrozenSurface
) -> Housings:
    points, microphones, number = [], [], 0
    for index, (line, tubes) in enumerate(zip(design.lines, tubes_of, strict=True)):
        for place in range(line.points):
            part = frozen.points[number]
            ports = _port(part.ports[0], tubes[place]), _port(part.ports[1], tubes[place + 1])
            number += 1
            points.append(PointPlacement(number, index, place, part.plan, ports))
    joined = microphone_ports(design)
    for name, part in zip(design.microphones, frozen.microphones, strict=True):
        ends = tuple(
            MicrophonePort(line, 1 if end else 0, _port(angle, tubes_of[line][-1 if end else 0]))
            for (line, end), angle in zip(joined[name], part.ports, strict=True)
        )
        microphones.append(MicrophonePlacement(name, part.plan, ends))
    return Housings(tuple(points), tuple(microphones), surface)


def _surface(frozen: FrozenPlaces) -> FrozenSurface:
    parts = (*frozen.points, *frozen.microphones)
    return FrozenSurface(tuple(part.plan for part in parts), tuple(map(frame_of, parts)))


def frozen_layout(design: ArrayDesign, frozen: FrozenPlaces) -> ArrayLayout:
    """All parts where the design states them, with tubes that are as stated or smooth curves of their length."""
    tubes_of = [design.tubes_of(line) for line in design.lines]
    surface = _surface(frozen)
    housings = _housings(design, frozen, tubes_of, surface)
    ways = ways_of(design, frozen, surface.frames)
    lengths = np.array([tube.length for own in tubes_of for tube in own])
    courses = smooth_courses(ways, np.maximum(lengths, ways.shortest))
    plan = {each.name: each.position for each in housings.microphones}
    height, tubes, number, before = design.resonator.port_axis_height, [], 0, 0
    for index, line in enumerate(design.lines):
        points = [point.position for point in housings.points[before : before + line.points]]
        stops = [plan[line.between[0]], *points, plan[line.between[1]]]
        for segment, tube in enumerate(tubes_of[index]):
            stated = frozen.tubes[number].course if frozen.tubes else ()
            course = np.array(stated) if stated else courses[number]
            path = np.array([[*stops[segment], height], [*stops[segment + 1], height]])
            tubes.append(TubePlacement(index, segment, tube, path, course))
            number += 1
        before += line.points
    return ArrayLayout(housings.points, housings.microphones, housings.surface, tuple(tubes))


def frozen_values(design: ArrayDesign, layout: ArrayLayout) -> dict[str, Any]:
    """Changes that freeze a design where its parts lie, with every length and course.

    ``design.with_values`` of them is the same array as a layout of kind ``surface``.

    Args:
        design: the array.
        layout: where its parts lie.

    Raises:
        DesignError: tubes are drawn schematically, so that they have no real course.
    """
    if any(tube.schematic for tube in layout.tubes):
        problem = "draws tubes schematically, which have no course that could be frozen"
        raise DesignError(problem, kind=Kind.UNSUITABLE, file=design.name, field="layout")
    frozen = {
        "points": [_part(layout.frame(p), p.port_angles, p.position) for p in layout.points],
        "microphones": [
            _part(layout.frame(m), [port.angle for port in m.ports], m.position) for m in layout.microphones
        ],
        "tubes": [{"course": tube.course.tolist()} for tube in layout.tubes],
    }
    lengths = {
        f"lines.{index}.lengths": [tube.length for tube in design.tubes_of(line)]
        for index, line in enumerate(design.lines)
    }
    return {"layout": {"kind": "surface", "frozen": frozen}, **lengths}


def _part(frame: Frame, ports: Any, plan: tuple[float, float]) -> dict[str, Any]:
    return {
        "at": list(frame.origin),
        "normal": list(frame.axes[2]),
        "x": list(frame.axes[0]),
        "ports": list(ports),
        "plan": list(plan),
    }


def _port(angle: float, tube: Tube) -> Port:
    return Port(tidy(angle), tube.inner_diameter, tube.outer_diameter)
