from .fit_file import fit_design as fit_design
from .in_space import PlanInSpace as PlanInSpace, plan_in_space as plan_in_space
from .surface_fit import FittedSurface as FittedSurface, fit_surface as fit_surface
from .unrolled import stretch_of as stretch_of
