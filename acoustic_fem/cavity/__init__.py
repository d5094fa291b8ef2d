"""Lossy compliance of closed cavities.

Stands on: fields, numerics, quantities.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
