from .closed_form import ClosedForm as ClosedForm
from .exchange import FORMATS as FORMATS, export as export, load as load
from .foreign_sofa import library_from_sofa as library_from_sofa
from .netcdf_file import LibraryError as LibraryError
from .network_responses import cell_summaries as cell_summaries
from .noise_floor import (
    detectable_density as detectable_density,
    detection_limits as detection_limits,
    gas_temperature as gas_temperature,
    matched_filter_snr as matched_filter_snr,
    noise_density as noise_density,
    thermal_covariance as thermal_covariance,
)
from .provenance import versions as versions
from .solving import solve as solve
from .transfer_functions import (
    MEASURED as MEASURED,
    VARIABLES as VARIABLES,
    Library as Library,
    described as described,
    library_from_arrays as library_from_arrays,
    measured_library as measured_library,
)
