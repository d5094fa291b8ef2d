from .as_built_estimates import AsBuiltEstimate as AsBuiltEstimate
from .diagnosis import Diagnoser as Diagnoser, Diagnosis as Diagnosis, Verdict as Verdict
from .diagnosis_options import DiagnosisOptions as DiagnosisOptions
from .faults import SensorFault as SensorFault, single_faults as single_faults
from .production_limits import ProductionLimits as ProductionLimits, read_limits as read_limits
