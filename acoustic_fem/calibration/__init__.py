"""Measured sweeps to a library; the model fitted to them.

Stands on: batch, duct, library, network, quantities, sound.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
