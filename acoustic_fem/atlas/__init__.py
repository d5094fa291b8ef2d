"""The difference between 3-D and closed forms of cells, interpolated between solved ones: the fidelity ``atlas``.

Stands on: cavity, cell, duct, quantities.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
