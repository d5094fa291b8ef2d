"""A body of air condensed to its ports: 3-D or closed form; cells of a design side by side.

Stands on: cavity, duct, fields, numerics, quantities.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
