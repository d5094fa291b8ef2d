"""A body on which an array is laid: read from CAD and mesh files, checked, and seen as a smooth surface.

Stands on: formats, ground, solids.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
