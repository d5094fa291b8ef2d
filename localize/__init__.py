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
    from localize.reconstruct import Reconstructor, Waveform, short_window_waveform
    from localize.touch_filter import TouchFilter
    from localize.training import TrainingPlan, TrainingProgress, train
    from localize.two_touches import TwoTouchDecoder, TwoTouches

_HOMES = {
    "ArrayResponse": "array_response",
    "BayesDecoder": "bayes",
    "Evaluation": "evaluation",
    "FamilyDecoder": "hypotheses",
    "FrequencyRatioDecoder": "frequency_ratio",
    "Judgement": "judgement",
    "Localizer": "localizer",
    "LocalizerError": "localizer",
    "Reconstructor": "reconstruct",
    "ResidualTest": "judgement",
    "TouchFilter": "touch_filter",
    "TouchGenerator": "dataset",
    "TrainingPlan": "training",
    "TrainingProgress": "training",
    "TwoTouchDecoder": "two_touches",
    "TwoTouches": "two_touches",
    "Waveform": "reconstruct",
    "evaluate": "evaluation",
    "judge": "judgement",
    "load_localizer": "localizer",
    "short_window_waveform": "reconstruct",
    "train": "training",
}

__all__ = [
    "ArrayResponse",
    "BayesDecoder",
    "Evaluation",
    "FamilyDecoder",
    "FrequencyRatioDecoder",
    "Judgement",
    "Localizer",
    "LocalizerError",
    "Reconstructor",
    "ResidualTest",
    "TouchFilter",
    "TouchGenerator",
    "TrainingPlan",
    "TrainingProgress",
    "TwoTouchDecoder",
    "TwoTouches",
    "Waveform",
    "evaluate",
    "judge",
    "load_localizer",
    "short_window_waveform",
    "train",
]


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        return getattr(import_module(f"localize.{_HOMES[name]}"), name)
    raise AttributeError(f"module 'localize' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)
