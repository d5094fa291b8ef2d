from .air_and_rubber import (
    SEALED_AIR_AND_RUBBER as SEALED_AIR_AND_RUBBER,
    UNKNOWN_AIR_AND_RUBBER as UNKNOWN_AIR_AND_RUBBER,
    AirAndRubber as AirAndRubber,
    DrawnAirAndRubber as DrawnAirAndRubber,
)
from .as_built_sensors import (
    AsBuiltSensors as AsBuiltSensors,
    DrawnSensors as DrawnSensors,
    as_built_fidelity as as_built_fidelity,
    batch_of_sensors as batch_of_sensors,
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
