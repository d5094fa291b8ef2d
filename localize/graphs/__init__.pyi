from .description import GraphDescription as GraphDescription, LocalizerError as LocalizerError
from .onnx_localizer import (
    KEY as KEY,
    ConvertedGraphWarning as ConvertedGraphWarning,
    OnnxLocalizer as OnnxLocalizer,
)
