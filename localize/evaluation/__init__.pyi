from .accuracy import (
    Evaluation as Evaluation,
    Locator as Locator,
    check_evaluation as check_evaluation,
    evaluate as evaluate,
    wilson_interval as wilson_interval,
)
from .conditions import (
    Outcome as Outcome,
    evaluate_conditions as evaluate_conditions,
    evaluate_sensors as evaluate_sensors,
)
from .goodness_of_fit import (
    LoudFrames as LoudFrames,
    SensorFit as SensorFit,
    sensor_fit as sensor_fit,
)
from .held_out import (
    MULTI_SINES as MULTI_SINES,
    PRESSES as PRESSES,
    TAPS as TAPS,
    TAPS_AND_PRESSES as TAPS_AND_PRESSES,
    Decisions as Decisions,
    HeldOutTouches as HeldOutTouches,
    TouchedSensors as TouchedSensors,
    TouchKinds as TouchKinds,
    decide as decide,
)
