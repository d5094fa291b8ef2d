"""From microphone signals to the touched point.

Names are loaded when they are first used, so that ``import localize`` does not load torch. No module may bear the
name of one of them: importing it would hide the function.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from localize.array_response import ArrayResponse
    from localize.bayes import BayesDecoder
    from localize.dataset import TouchGenerator
    from localize.evaluation import Evaluation, evaluate
    from localize.frequency_ratio import FrequencyRatioDecoder
    from localize.hypotheses import FamilyDecoder
    from localize.judgement import Judgement, ResidualTest, judge
    from localize.localizer import Localizer, LocalizerError, load_localizer
    from localize.onnx import OnnxLocalizer, export_onnx
    from localize.reconstruct import Reconstructor, Waveform, short_window_waveform
    from localize.recording import Recording, RecordingError, read_recording
    from localize.self_calibration import SelfCalibration, SelfCalibrationError, self_calibrate
    from localize.sound_test import SoundTest
    from localize.stream import Decision, Fault, TouchStream
    from localize.touch_filter import TouchFilter
    from localize.touches import Touch, touches_of
    from localize.training import TrainingProgress, train
    from localize.training_plan import TrainingPlan
    from localize.two_touches import TwoTouchDecoder, TwoTouches

_HOMES = {
    "ArrayResponse": "array_response",
    "BayesDecoder": "bayes",
    "Decision": "stream",
    "Evaluation": "evaluation",
    "FamilyDecoder": "hypotheses",
    "Fault": "stream",
    "FrequencyRatioDecoder": "frequency_ratio",
    "Judgement": "judgement",
    "Localizer": "localizer",
    "LocalizerError": "localizer",
    "OnnxLocalizer": "onnx",
    "Reconstructor": "reconstruct",
    "Recording": "recording",
    "RecordingError": "recording",
    "ResidualTest": "judgement",
    "SelfCalibration": "self_calibration",
    "SelfCalibrationError": "self_calibration",
    "SoundTest": "sound_test",
    "Touch": "touches",
    "TouchFilter": "touch_filter",
    "TouchGenerator": "dataset",
    "TouchStream": "stream",
    "TrainingPlan": "training_plan",
    "TrainingProgress": "training",
    "TwoTouchDecoder": "two_touches",
    "TwoTouches": "two_touches",
    "Waveform": "reconstruct",
    "evaluate": "evaluation",
    "export_onnx": "onnx",
    "judge": "judgement",
    "load_localizer": "localizer",
    "read_recording": "recording",
    "self_calibrate": "self_calibration",
    "short_window_waveform": "reconstruct",
    "touches_of": "touches",
    "train": "training",
}

__all__ = [
    "ArrayResponse",
    "BayesDecoder",
    "Decision",
    "Evaluation",
    "FamilyDecoder",
    "Fault",
    "FrequencyRatioDecoder",
    "Judgement",
    "Localizer",
    "LocalizerError",
    "OnnxLocalizer",
    "Reconstructor",
    "Recording",
    "RecordingError",
    "ResidualTest",
    "SelfCalibration",
    "SelfCalibrationError",
    "SoundTest",
    "Touch",
    "TouchFilter",
    "TouchGenerator",
    "TouchStream",
    "TrainingPlan",
    "TrainingProgress",
    "TwoTouchDecoder",
    "TwoTouches",
    "Waveform",
    "evaluate",
    "export_onnx",
    "judge",
    "load_localizer",
    "read_recording",
    "self_calibrate",
    "short_window_waveform",
    "touches_of",
    "train",
]


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        return getattr(import_module(f"localize.{_HOMES[name]}"), name)
    raise AttributeError(f"module 'localize' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)
