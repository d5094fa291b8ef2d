"""Both ends of every tube of an array whose places are frozen."""

from __future__ import annotations

import math

import numpy as np

from geometry.ground.typed import Array
from geometry.plan.cylinder import Frame
from geometry.plan.frozen import Ways, frame_of
from geometry.plan.routing import unit
from geometry.schema.array_fields import StatedArray
from geometry.schema.frozen_fields import FrozenPart, FrozenPlaces

#: An end of a tube: place on the axis at the height of the ports, direction, normal, inner and outer radius.
_End = tuple[Array, Array, Array, float, float]


def ways_of(design: StatedArray, frozen: FrozenPlaces) -> Ways:
    """Ends of all tubes, line by line from the first microphone to the second.

    Args:
        design: the array; of its layout only ``frozen`` counts.
        frozen: its places.
    """
    resonator, microphone, height = design.resonator, design.microphone, design.resonator.port_axis_height
    shell = resonator.cavity_diameter / 2, resonator.outer_diameter / 2
    # Tubes are straight until they have left the seat of the board, in whatever direction.
    seat = math.hypot(*(side / 2 + microphone.board_gap + microphone.wall_thickness for side in microphone.board_size))
    radius = microphone.chamber_diameter / 2
    chamber = radius, max(radius + microphone.wall_thickness, seat)
    ports = microphone_ports(design)
    points = [(part, frame_of(part)) for part in frozen.points]
    housings = {name: (part, frame_of(part)) for name, part in zip(design.microphones, frozen.microphones, strict=True)}
    ends: list[tuple[_End, _End]] = []
    before = 0
    for index, line in enumerate(design.lines):
        own = points[before : before + line.points]
        stops: list[_End] = []
        for end, name in enumerate(line.between):
            port = ports[name].index((index, end))
            stop = _end(*housings[name], port, height, chamber)
            if end == 0:
                stops.append(stop)
                for part, frame in own:
                    stops += [_end(part, frame, port, height, shell) for port in (0, 1)]
            else:
                stops.append(stop)
        ends += zip(stops[::2], stops[1::2], strict=True)
        before += line.points
    first, last = ([pair[end] for pair in ends] for end in (0, 1))

    def column(entry: int) -> tuple[Array, Array]:
        return np.array([each[entry] for each in first]), np.array([each[entry] for each in last])

    normals = column(2)
    sides = np.array([tube.side for tube in frozen.tubes] if frozen.tubes else [1.0] * len(ends))
    return Ways(column(0), column(1), column(3), column(4), (normals[0] + normals[1]) / 2, sides)


def microphone_ports(design: StatedArray) -> dict[str, list[tuple[int, int]]]:
    """Line ends that each microphone joins, in order of (line, end)."""
    return {
        name: [
            (index, end)
            for index, line in enumerate(design.lines)
            for end, own in enumerate(line.between)
            if own == name
        ]
        for name in design.microphones
    }


def _end(part: FrozenPart, frame: Frame, port: int, height: float, radii: tuple[float, float]) -> _End:
    axes = np.asarray(frame.axes)
    return frame.at(0.0, 0.0, height), unit(part.ports[port]) @ axes[:2], axes[2], *radii
