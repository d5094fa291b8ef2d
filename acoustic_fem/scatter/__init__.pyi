from .as_built_sensors import (
    made_fidelity as made_fidelity,
    made_transfer_functions as made_transfer_functions,
    scatter_factors as scatter_factors,
)
from .tolerances import (
    TOLERANCES as TOLERANCES,
    UNCALIBRATED as UNCALIBRATED,
    ScatteredDesign as ScatteredDesign,
    Tolerance as Tolerance,
    UnknownScatterError as UnknownScatterError,
    read_tolerances as read_tolerances,
    tolerances_of as tolerances_of,
)
