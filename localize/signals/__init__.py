"""Touches, sound and noise as signals at 1 kHz, reproducible sample by sample.

Stands on: nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
