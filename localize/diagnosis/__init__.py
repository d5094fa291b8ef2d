"""Diagnosis of built sensors: which part is broken, from ordinary touches.

Stands on: decoders, live, signals.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
