"""STL, STEP, 3MF: written, read back, compared; STEP of others.

Stands on: assembly, ground, solids.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
