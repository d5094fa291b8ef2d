"""Manufacturing tolerances as data, and arrays drawn with them.

Stands on: atlas, batch, library, membrane, network, quantities.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
