from .effects import (
    ACCURACIES as ACCURACIES,
    scattered_accuracy as scattered_accuracy,
    tolerance_study as tolerance_study,
)
from .files import save_tolerance as save_tolerance
from .perturbed_library import write_perturbed_library as write_perturbed_library
from .tolerances import (
    TOLERANCES as TOLERANCES,
    ScatteredDesign as ScatteredDesign,
    Tolerance as Tolerance,
    read_tolerances as read_tolerances,
)
