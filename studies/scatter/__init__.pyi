from .effects import (
    ACCURACIES as ACCURACIES,
    scatter_effects as scatter_effects,
    scattered_accuracy as scattered_accuracy,
)
from .perturbed_library import write_perturbed_library as write_perturbed_library
from .tolerance_files import save_tolerance as save_tolerance
from .tolerance_run import ToleranceStudy as ToleranceStudy, tolerance_study as tolerance_study
