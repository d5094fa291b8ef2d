from .diagnosis import Diagnoser as Diagnoser, Diagnosis as Diagnosis, Verdict as Verdict
from .diagnosis_options import DiagnosisOptions as DiagnosisOptions
from .faults import SensorFault as SensorFault, single_faults as single_faults
