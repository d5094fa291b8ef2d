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
    from localize.localizer import Localizer, LocalizerError, load_localizer
    from localize.onnx import OnnxLocalizer, export_onnx
    from localize.reconstruct import Reconstructor
    from localize.recording import Recording, RecordingError, read_recording
    from localize.stream import Decision, Fault, TouchStream
    from localize.touches import Touch, touches_of
    from localize.training import TrainingProgress, train
    from localize.training_plan import TrainingPlan

_HOMES = {
    "ArrayResponse": "array_response",
    "BayesDecoder": "bayes",
    "Decision": "stream",
    "Evaluation": "evaluation",
    "Fault": "stream",
    "Localizer": "localizer",
    "LocalizerError": "localizer",
    "OnnxLocalizer": "onnx",
    "Reconstructor": "reconstruct",
    "Recording": "recording",
    "RecordingError": "recording",
    "Touch": "touches",
    "TouchGenerator": "dataset",
    "TouchStream": "stream",
    "TrainingPlan": "training_plan",
    "TrainingProgress": "training",
    "evaluate": "evaluation",
    "export_onnx": "onnx",
    "load_localizer": "localizer",
    "read_recording": "recording",
    "touches_of": "touches",
    "train": "training",
}

__all__ = [
    "ArrayResponse",
    "BayesDecoder",
    "Decision",
    "Evaluation",
    "Fault",
    "Localizer",
    "LocalizerError",
    "OnnxLocalizer",
    "Reconstructor",
    "Recording",
    "RecordingError",
    "Touch",
    "TouchGenerator",
    "TouchStream",
    "TrainingPlan",
    "TrainingProgress",
    "evaluate",
    "export_onnx",
    "load_localizer",
    "read_recording",
    "touches_of",
    "train",
]


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        return getattr(import_module(f"localize.{_HOMES[name]}"), name)
    raise AttributeError(f"module 'localize' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)
