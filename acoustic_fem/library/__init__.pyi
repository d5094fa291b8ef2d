from .exchange import FORMATS as FORMATS, export as export, load_exchanged as load_exchanged
from .file import LibraryError as LibraryError
from .noise import (
    detection_limits as detection_limits,
    gas_temperature as gas_temperature,
    thermal_covariance as thermal_covariance,
)
from .provenance import versions as versions
from .result import MEASURED as MEASURED, Library as Library, library_from_arrays as library_from_arrays
from .solving import solve as solve
