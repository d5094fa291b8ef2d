from .files import save_bending as save_bending
from .rig import BendingRig as BendingRig, solve_bending as solve_bending
