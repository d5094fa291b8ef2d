from .cases import (
    PROGRAM_ERROR as PROGRAM_ERROR,
    Cases as Cases,
    by_kind as by_kind,
    cases_of as cases_of,
    sobol_note as sobol_note,
)
from .fields import FileSection as FileSection
from .metric_registry import METRICS as METRICS, Metric as Metric, metrics_named as metrics_named
from .parameter import Parameter as Parameter, StudyError as StudyError
from .study import Study as Study, load_study as load_study, read_study as read_study, study_of as study_of
