from .description import GraphDescription as GraphDescription, LocalizerError as LocalizerError
from .onnx_localizer import KEY as KEY, OnnxLocalizer as OnnxLocalizer
