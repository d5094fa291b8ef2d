from .accuracy_to_expect import (
    DRAWS as DRAWS,
    expected_accuracy as expected_accuracy,
    is_enough as is_enough,
    least_known as least_known,
)
from .rejections import numbers as numbers
from .self_calibration import touched as touched
