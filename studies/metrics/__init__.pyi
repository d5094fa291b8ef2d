from .batch_responses import Responses as Responses
from .confusion import (
    PredictedConfusion as PredictedConfusion,
    check_grid as check_grid,
    predict_confusion as predict_confusion,
)
from .covered_area import coverage as coverage
from .pairs import (
    BAND as BAND,
    DECIBEL as DECIBEL,
    Disagreement as Disagreement,
    attenuation as attenuation,
    check_band as check_band,
    disagreement as disagreement,
    microphone_ratios as microphone_ratios,
    sensitivity as sensitivity,
    trapezoidal_weights as trapezoidal_weights,
    worst_heard as worst_heard,
)
from .predicted_accuracy import (
    AsBuiltAccuracy as AsBuiltAccuracy,
    NominalAccuracy as NominalAccuracy,
    TouchAccuracy as TouchAccuracy,
    as_built_accuracies as as_built_accuracies,
    as_built_accuracy as as_built_accuracy,
)
from .separation import (
    PairDistances as PairDistances,
    Separability as Separability,
    pair_distances as pair_distances,
    separability as separability,
)
from .shared import SharedFigures as SharedFigures
