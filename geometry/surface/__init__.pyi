from .fit_file import fit_design as fit_design
from .surface_fit import FittedSurface as FittedSurface, fit_surface as fit_surface
from .unrolled import stretch_of as stretch_of
