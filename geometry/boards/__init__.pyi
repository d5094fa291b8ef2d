from .board_files import write_board as write_board
from .board_picture import board_drawing as board_drawing
from .board_pieces import BoardPlan as BoardPlan
from .board_plan import plan_board as plan_board
from .board_rules import BoardRules as BoardRules, Spacing as Spacing, closest as closest
