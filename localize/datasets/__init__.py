"""Data sets for torch: touches on one or many arrays, and transfer functions by design.

Stands on: learned, signals.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
