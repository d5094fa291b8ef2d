from .arrangement import lay_out as lay_out
from .cutting import (
    Cut as Cut,
    cut_lengths as cut_lengths,
    cutting_list as cutting_list,
    spring_length as spring_length,
)
from .placement import (
    ArrayLayout as ArrayLayout,
    MicrophonePlacement as MicrophonePlacement,
    PointPlacement as PointPlacement,
    TubePlacement as TubePlacement,
)
