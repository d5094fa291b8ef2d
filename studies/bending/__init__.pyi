from .bending_files import save_bending as save_bending
from .bending_rig import BendingRig as BendingRig
from .bending_run import BendingStudy as BendingStudy, bending_study as bending_study
from .solution import Bending as Bending, solve_bending as solve_bending
