from .objections import numbers as numbers
from .prospect import (
    DRAWS as DRAWS,
    expected_accuracy as expected_accuracy,
    is_enough as is_enough,
    least_known as least_known,
)
from .self_calibration import touched as touched
