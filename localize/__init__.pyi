from . import (
    contacts as contacts,
    datasets as datasets,
    decoders as decoders,
    diagnosis as diagnosis,
    embedded as embedded,
    evaluation as evaluation,
    graphs as graphs,
    layers as layers,
    learned as learned,
    live as live,
    model as model,
    recalibration as recalibration,
    recognition as recognition,
    recordings as recordings,
    signals as signals,
    tracking as tracking,
    two_touches as two_touches,
)
from .contacts.contact import Contact as Contact
from .datasets.touch_dataset import TouchDataset as TouchDataset
from .datasets.transfer_function_dataset import TransferFunctionDataset as TransferFunctionDataset
from .decoders.bayes import BayesDecoder as BayesDecoder
from .decoders.decoder_options import (
    DecoderOptions as DecoderOptions,
    DriftOptions as DriftOptions,
    HypothesisOptions as HypothesisOptions,
    ResidualOptions as ResidualOptions,
    SoundOptions as SoundOptions,
    TolerantOptions as TolerantOptions,
)
from .decoders.drift import DriftDecoder as DriftDecoder
from .decoders.family import FamilyDecoder as FamilyDecoder
from .decoders.hand_motion import HandMotion as HandMotion
from .decoders.judgement import Judgement as Judgement, ResidualTest as ResidualTest, judge as judge
from .decoders.motion_test import MotionTest as MotionTest
from .decoders.reconstruct import (
    Reconstructor as Reconstructor,
    Waveform as Waveform,
    short_window_waveform as short_window_waveform,
)
from .decoders.sound_test import SoundTest as SoundTest
from .decoders.tolerant import TolerantDecoder as TolerantDecoder
from .diagnosis.diagnosis import Diagnosis as Diagnosis, diagnose as diagnose
from .evaluation.accuracy import Evaluation as Evaluation, evaluate as evaluate
from .evaluation.goodness_of_fit import SensorFit as SensorFit, sensor_fit as sensor_fit
from .graphs.description import LocalizerError as LocalizerError
from .graphs.onnx_localizer import OnnxLocalizer as OnnxLocalizer
from .learned.epochs import TrainingProgress as TrainingProgress
from .learned.localizer import (
    Localizer as Localizer,
    load_localizer as load_localizer,
)
from .learned.onnx import export_onnx as export_onnx
from .learned.training import train as train
from .learned.training_plan import TrainingPlan as TrainingPlan
from .live.events import Decision as Decision, Fault as Fault, TouchEvent as TouchEvent
from .live.stream import TouchStream as TouchStream
from .live.stream_options import StreamOptions as StreamOptions, TouchOptions as TouchOptions
from .live.touch_filter import TouchFilter as TouchFilter
from .live.touches import Touch as Touch, TouchTracker as TouchTracker, touches_of as touches_of
from .model.located_touches import LocatedTouches as LocatedTouches
from .model.opened_model import Model as Model
from .model.opening import open_model as open_model
from .recalibration.self_calibration import (
    SelfCalibration as SelfCalibration,
    SelfCalibrationError as SelfCalibrationError,
    self_calibrate as self_calibrate,
)
from .recognition.learning import train_recognizer as train_recognizer
from .recognition.pulse import PulseReader as PulseReader, PulseReading as PulseReading
from .recognition.recognition_plan import RecognitionPlan as RecognitionPlan
from .recognition.recognizer import (
    Recognizer as Recognizer,
    RecognizerError as RecognizerError,
    load_recognizer as load_recognizer,
)
from .recordings.recording import (
    Recording as Recording,
    RecordingError as RecordingError,
    read_recording as read_recording,
)
from .signals.array_facts import ArrayFacts as ArrayFacts
from .signals.array_response import ArrayResponse as ArrayResponse
from .signals.locator import Locator as Locator
from .signals.touch_generator import TouchGenerator as TouchGenerator
from .tracking.path import PathTracker as PathTracker, Track as Track
from .tracking.path_gestures import Gesture as Gesture, gesture_of as gesture_of
from .tracking.position import PositionDecoder as PositionDecoder, Positions as Positions
from .tracking.signal_track import track as track
from .two_touches.two_touch_decoder import (
    FoundTouch as FoundTouch,
    TouchesAtOnce as TouchesAtOnce,
    TwoTouchDecoder as TwoTouchDecoder,
)
from .two_touches.two_touch_options import TwoTouchOptions as TwoTouchOptions
