from .calibrating import SensorCalibration as SensorCalibration, calibrate_sensor as calibrate_sensor
from .calibration_figures import draw_calibration as draw_calibration
from .faulty_rig import (
    DiagnosisSession as DiagnosisSession,
    FaultyRig as FaultyRig,
    diagnosis_session as diagnosis_session,
)
from .priors import fit_priors as fit_priors, model_deviation as model_deviation
from .recalibrating import Recalibration as Recalibration, recalibrate as recalibrate
from .rig_contacts import record_contact as record_contact
from .rig_motion import (
    record_motion as record_motion,
    table_knocks as table_knocks,
    waved_hand as waved_hand,
)
from .rig_session import RigSession as RigSession, record_rig as record_rig
from .rig_touches import TouchSession as TouchSession, record_touches as record_touches
from .slow_sounds import closing_doors as closing_doors, gusts as gusts
from .touches_at_once import FrameRig as FrameRig, TouchFrame as TouchFrame
from .virtual_rig import HiddenScatter as HiddenScatter, Recorder as Recorder, Rig as Rig
