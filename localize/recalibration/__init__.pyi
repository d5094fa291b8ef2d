from .accuracy_to_expect import (
    expected_accuracy as expected_accuracy,
    is_enough as is_enough,
    least_known as least_known,
)
from .recalibration_options import (
    AccuracyOptions as AccuracyOptions,
    RecalibrationOptions as RecalibrationOptions,
)
from .rejections import numbers as numbers
from .self_calibration import touched as touched
