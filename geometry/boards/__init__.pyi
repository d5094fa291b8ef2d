from .board_files import write_board as write_board
from .board_picture import board_drawing as board_drawing
from .board_pieces import BoardPlan as BoardPlan
from .board_plan import (
    IN_CHAMBER as IN_CHAMBER,
    board_or_reason as board_or_reason,
    plan_board as plan_board,
    shown_board as shown_board,
)
from .board_rules import BoardRules as BoardRules, Spacing as Spacing, closest as closest
from .solid_boards import board_solid as board_solid, solid_of_plan as solid_of_plan
