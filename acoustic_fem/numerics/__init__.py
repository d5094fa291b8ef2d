"""Sparse solver, rational sweep, mesh refinement, disk cache, number of processors: no physics.

Stands on: nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
