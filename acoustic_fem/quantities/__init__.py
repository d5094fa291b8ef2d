"""The gas, SI conversion, checks of numbers, names of fidelities.

Stands on: nothing.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
