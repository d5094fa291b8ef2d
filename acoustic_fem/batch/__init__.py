"""The lumped network for many designs at once, NumPy or torch, with gradients.

Stands on: atlas, cavity, duct, membrane, network, quantities.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
