from .build_record import BuildRecord as BuildRecord, read_record as read_record
from .fitted_model import (
    KnownParts as KnownParts,
    Posterior as Posterior,
    Priors as Priors,
    UpdatedModel as UpdatedModel,
)
from .manifest import REFERENCE as REFERENCE, read_manifest as read_manifest
from .measured_library import Calibration as Calibration, calibrate as calibrate
from .model_discrepancy import draw as draw
from .model_updating import Update as Update, update as update
