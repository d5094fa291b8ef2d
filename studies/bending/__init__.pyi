from .files import save_bending as save_bending
from .rig import BendingRig as BendingRig
from .solution import Bending as Bending, solve_bending as solve_bending
from .studying import BendingStudy as BendingStudy, bending_study as bending_study
