"""Sparse solver, rational sweep, vector fitting, splines, mesh refinement, disk cache, processors: no physics.

Stands on: nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
