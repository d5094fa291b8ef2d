"""Schema of design files: sections, fields, units, ranges; materials, processes and cavity shapes as data.

Stands on: ground.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
