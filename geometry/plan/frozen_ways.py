"""Both ends of every tube of an array whose places are frozen."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from geometry.ground.typed import Array
from geometry.plan.cylinder import Frame
from geometry.plan.frozen import Ways, frame_of
from geometry.schema.array_fields import StatedArray
from geometry.schema.frozen_fields import FrozenPlaces


def ways_of(design: StatedArray, frozen: FrozenPlaces, frames: Sequence[Frame] | None = None) -> Ways:
    """Ends of all tubes, line by line from the first microphone to the second.

    Args:
        design: the array; of its layout only ``frozen`` counts.
        frozen: its places.
        frames: of all points, then of all microphones, where they are known; default: those of the places.
    """
    resonator, microphone = design.resonator, design.microphone
    shell = resonator.cavity_diameter / 2, resonator.outer_diameter / 2
    # Tubes are straight until they have left the seat of the board, in whatever direction.
    seat = math.hypot(*(side / 2 + microphone.board_gap + microphone.wall_thickness for side in microphone.board_size))
    radius = microphone.chamber_diameter / 2
    chamber = radius, max(radius + microphone.wall_thickness, seat)
    parts = (*frozen.points, *frozen.microphones)
    ports, number = microphone_ports(design), {name: k for k, name in enumerate(design.microphones)}
    stops: list[tuple[int, int]] = []  # part and port at each end of each tube
    before = 0
    for index, line in enumerate(design.lines):
        first, last = (
            (len(frozen.points) + number[name], ports[name].index((index, end)))
            for end, name in enumerate(line.between)
        )
        inner = [(point, port) for point in range(before, before + line.points) for port in (0, 1)]
        stops += [first, *inner, last]
        before += line.points
    part = np.array([each for each, _ in stops])
    angles = np.radians([parts[each].ports[port] for each, port in stops])
    frames = [frame_of(each) for each in parts] if frames is None else frames
    axes = np.array([frame.axes for frame in frames])[part]
    normals = axes[:, 2]
    at = np.array([frame.origin for frame in frames])[part] + resonator.port_axis_height * normals
    out = np.cos(angles)[:, None] * axes[:, 0] + np.sin(angles)[:, None] * axes[:, 1]
    is_housing = part >= len(frozen.points)
    inner_radius, outer_radius = (np.where(is_housing, *each) for each in zip(chamber, shell, strict=True))
    count = len(stops) // 2
    sides = np.array([tube.side for tube in frozen.tubes] if frozen.tubes else [1.0] * count)
    return Ways(
        _both(at), _both(out), _both(inner_radius), _both(outer_radius), (normals[::2] + normals[1::2]) / 2, sides
    )


def _both(ends: Array) -> tuple[Array, Array]:
    """Values of the first and of the last ends of tubes, from those of all ends in turn."""
    return ends[::2], ends[1::2]


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
