from .area import area_positions as area_positions, outside_at as outside_at
from .cylinder import (
    FLAT as FLAT,
    Axes as Axes,
    Cylinder as Cylinder,
    Frame as Frame,
    Plane as Plane,
    Surface as Surface,
    surface_of as surface_of,
    wound_turn as wound_turn,
)
from .frozen import FrozenSurface as FrozenSurface, frame_of as frame_of, smooth_courses as smooth_courses
from .hand import finger_positions as finger_positions, meeting_at as meeting_at
from .routing import (
    bearing as bearing,
    bow_angle as bow_angle,
    bowed_path as bowed_path,
    drawn_path as drawn_path,
    path_length as path_length,
    resampled as resampled,
    tidy as tidy,
    tightest_bend as tightest_bend,
    trimmed as trimmed,
    turning as turning,
    unit as unit,
)
from .wiring_graph import WiringCounts as WiringCounts, check_topology as check_topology, wiring_counts as wiring_counts
