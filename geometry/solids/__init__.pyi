from .base_plate import draw_base as draw_base
from .carrier import array_carrier as array_carrier
from .housing import build_board as build_board, build_housing as build_housing
from .measure import (
    FACET_ANGLE as FACET_ANGLE,
    Round as Round,
    Tessellation as Tessellation,
    genus as genus,
    hole_diameters as hole_diameters,
    inner_voids as inner_voids,
    quick_box as quick_box,
    rounds as rounds,
    tessellate as tessellate,
)
from .membrane import (
    build_membrane as build_membrane,
    membrane_profile as membrane_profile,
    membrane_radius as membrane_radius,
)
from .round_solids import cylinder as cylinder, one_solid as one_solid, revolved as revolved
from .shell import build_shell as build_shell
from .stroke_font import letters_within as letters_within, text_bars as text_bars, text_size as text_size
from .tube import TubePiece as TubePiece, build_tube as build_tube, piece_of as piece_of
