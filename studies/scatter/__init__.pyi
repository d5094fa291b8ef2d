from .effects import (
    ACCURACIES as ACCURACIES,
    scatter_effects as scatter_effects,
    scattered_accuracy as scattered_accuracy,
)
from .files import save_tolerance as save_tolerance
from .perturbed_library import write_perturbed_library as write_perturbed_library
from .studying import ToleranceStudy as ToleranceStudy, tolerance_study as tolerance_study
