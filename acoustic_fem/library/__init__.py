"""The labelled result: solve, touch, noise, files.

Stands on: atlas, batch, cell, enclosed, membrane, network, numerics, quantities.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
