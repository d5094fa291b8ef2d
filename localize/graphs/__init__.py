"""Localizers as ONNX graphs: read, checked and run, and what files of localizers say of themselves.

Stands on: signals.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
