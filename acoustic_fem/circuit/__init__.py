"""The sensor as a circuit and as a state space: for control, for electronics, and for simulations in time.

Stands on: cavity, duct, library, membrane, network, numerics, quantities.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
