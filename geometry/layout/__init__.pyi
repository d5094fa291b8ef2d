from .arrangement import lay_out as lay_out
from .cutting import (
    Cut as Cut,
    cut_lengths as cut_lengths,
    cutting_list as cutting_list,
    spring_length as spring_length,
)
from .overlaps import buildability_notes as buildability_notes
from .placement import (
    ArrayLayout as ArrayLayout,
    MicrophonePlacement as MicrophonePlacement,
    PointPlacement as PointPlacement,
    TubePlacement as TubePlacement,
    microphone_ports as microphone_ports,
    point_places as point_places,
    point_ports as point_ports,
)
from .size import array_size as array_size
