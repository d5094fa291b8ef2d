from .disk_cache import CacheWarning as CacheWarning
from .frequency_splines import interpolation as interpolation
from .processors import cores as cores
from .rational_sweep import (
    ReducedModel as ReducedModel,
    reduce_system as reduce_system,
    require_passive as require_passive,
)
from .refinement import BEST_ORDER as BEST_ORDER, Refinement as Refinement, refined as refined
from .vector_fitting import RationalFit as RationalFit, VectorFitError as VectorFitError, fit_poles as fit_poles
