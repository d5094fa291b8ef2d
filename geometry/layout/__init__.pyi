from .arrangement import lay_out as lay_out, place_housings as place_housings
from .cutting import (
    Cut as Cut,
    cut_lengths as cut_lengths,
    cutting_list as cutting_list,
    spring_length as spring_length,
)
from .frozen_layout import frozen_values as frozen_values
from .overlaps import (
    OverlapError as OverlapError,
    buildability_notes as buildability_notes,
    refuse_overlaps as refuse_overlaps,
    schematic_notes as schematic_notes,
)
from .placement import (
    ArrayLayout as ArrayLayout,
    Housings as Housings,
    MicrophonePlacement as MicrophonePlacement,
    PointPlacement as PointPlacement,
    TubePlacement as TubePlacement,
    point_places as point_places,
)
from .plan_drawing import draw_plan as draw_plan
from .remedies import fix_for as fix_for, fix_values as fix_values, refuse_unbuildable as refuse_unbuildable
from .size import array_size as array_size
